const scene = document.getElementById('scene');
const select = document.getElementById('name');
const progress = document.getElementById('progress');
const names = [...select.options].map(({ value }) => value);

function show(name) {
  select.value = name;
  scene.src = `scenes/${name}.json`;
  document.getElementById('file').href = scene.src;
  for (const text of document.querySelectorAll('[data-scene]')) text.hidden = text.dataset.scene !== name;
}

/** The address of the page names the scene: light.html#focus */
function showNamed() {
  const name = location.hash.slice(1);
  show(names.includes(name) ? name : names[0]);
}

select.addEventListener('change', () => {
  location.hash = select.value;
});
addEventListener('hashchange', showNamed);
showNamed();

scene.addEventListener('load', () => {
  scene.alt = scene.scene.name;
});
scene.addEventListener('progress', ({ samples, total }) => {
  progress.textContent = `${samples} of ${total} samples`;
});

document.getElementById('numbers').addEventListener('change', ({ target }) => {
  scene.showStats = target.checked;
});
