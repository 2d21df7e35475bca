const scene = document.getElementById('scene');

// <input data-of="ball" data-property="radius"> sets document.getElementById('ball').radius
for (const input of document.querySelectorAll('input[data-of]')) {
  const element = document.getElementById(input.dataset.of);
  const set = () => {
    element[input.dataset.property] = input.valueAsNumber;
    input.nextElementSibling.value = input.value;
  };
  input.addEventListener('input', set);
  set();
}

const floor = document.createElement('ray-plane');
Object.assign(floor, { point: [0, -1, 0], color: 'white', checker: 'black' });

const button = document.getElementById('floor');
button.addEventListener('click', () => {
  if (floor.isConnected) floor.remove();
  else scene.append(floor);
  button.textContent = floor.isConnected ? 'Remove the floor' : 'Add a floor';
});

const ROWS = [
  ['Programs compiled', ({ compiles }) => compiles],
  ['… which took', ({ compileMs }) => `${compileMs.toFixed(0)} ms`],
  ['Samples per pixel', ({ samples }) => samples],
  ['Time per sample', ({ msPerSample }) => `${msPerSample.toFixed(1)} ms`],
  ['Pixels', ({ width, height }) => `${width} × ${height}`],
  ['Numbers', ({ precision }) => (precision === 'float' ? '32-bit floats' : '16-bit floats')],
];

const cells = ROWS.map(([label]) => {
  const row = document.getElementById('stats').insertRow();
  row.insertCell().textContent = label;
  return row.insertCell();
});

function showStats() {
  for (const [i, [, text]] of ROWS.entries()) cells[i].textContent = text(scene.stats);
}

for (const event of ['load', 'progress', 'complete']) scene.addEventListener(event, showStats);
