// How far the GPU's picture is from the one in f64.
const SIZE = 128;

const scene = document.getElementById('scene');
const select = document.getElementById('name');
const factor = document.getElementById('factor');

// A page that requires trusted types says which addresses may become programs: here, this one.
const workerUrl = new URL('reference-worker.js', import.meta.url).href;
const policy = globalThis.trustedTypes?.createPolicy('reference', {
  createScriptURL: (url) => (url === workerUrl ? url : ''),
});
const newWorker = () => new Worker(policy?.createScriptURL(workerUrl) ?? workerUrl, { type: 'module' });

/** What the table tells, of the pixels that are not left out. */
function figures({ differences, excluded }) {
  const kept = differences.filter((_, pixel) => !excluded[pixel]).sort();
  return {
    median: kept[Math.floor(kept.length / 2)],
    p999: kept[Math.floor(kept.length * 0.999)],
    share: kept.filter((difference) => difference > 1e-3).length / kept.length,
    excluded: 1 - kept.length / differences.length,
  };
}

const percent = (share) => `${(100 * share).toFixed(3)} %`;

function showFigures(comparison) {
  const { median, p999, share, excluded } = figures(comparison);
  const texts = {
    median: median.toExponential(1),
    p999: p999.toExponential(1),
    share: percent(share),
    excluded: percent(excluded),
  };
  for (const [id, text] of Object.entries(texts)) document.getElementById(id).textContent = text;
}

const encodeSrgb = (x) => (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055);
const byte = (x) => 255 * Math.min(1, Math.max(0, x));

/** Paints a canvas; `rgba` gives the four bytes of a pixel by its number, the top row first. */
function paint(id, rgba) {
  const canvas = document.getElementById(id);
  canvas.width = canvas.height = SIZE;
  const image = new ImageData(SIZE, SIZE);
  for (let pixel = 0; pixel < SIZE * SIZE; pixel++) image.data.set(rgba(pixel), 4 * pixel);
  canvas.getContext('2d').putImageData(image, 0, 0);
}

function showReference({ reference: { data } }) {
  paint('reference', (pixel) => {
    const [r, g, b, alpha] = data.subarray(4 * pixel, 4 * pixel + 4);
    // Colours are premultiplied by alpha there, and are not in an image.
    const channel = (x) => byte(encodeSrgb(alpha > 0 ? x / alpha : 0));
    return [channel(r), channel(g), channel(b), byte(alpha)];
  });
}

function showDifference({ differences, excluded }) {
  const times = 10 ** factor.valueAsNumber;
  document.getElementById('times').value = times.toLocaleString('en', { maximumSignificantDigits: 2 });
  paint('difference', (pixel) => {
    const grey = byte(differences[pixel] * times);
    return excluded[pixel] ? [0, 90, 255, 255] : [grey, grey, grey, 255];
  });
}

let worker;
let comparison;

/** Renders and compares the scene that is chosen; a comparison that is under way is given up. */
async function compare() {
  worker?.terminate();
  const name = select.value;
  document.getElementById('state').textContent = 'computing…';
  scene.src = `scenes/${name}.json`;
  try {
    await scene.ready;
    await scene.complete;
  } catch {
    document.getElementById('state').textContent = 'cannot be drawn, and the picture says why';
    return;
  }
  if (name !== select.value) return;
  const { integrator, samples, bounces, seed } = scene;
  const settings = { width: SIZE, height: SIZE, integrator, samples, bounces, seed };
  worker = newWorker();
  worker.addEventListener('message', ({ data }) => {
    comparison = data;
    document.getElementById('state').textContent = `done: ${name}`;
    showReference(data);
    showDifference(data);
    showFigures(data);
  });
  worker.postMessage({ picture: scene.readRadiance(), scene: scene.scene, settings });
}

select.addEventListener('change', compare);
factor.addEventListener('input', () => comparison && showDifference(comparison));
compare();
