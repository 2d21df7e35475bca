const scene = document.getElementById('scene');
const select = document.getElementById('name');
const json = document.getElementById('json');

async function show(name) {
  select.value = name;
  // An assigned scene goes before src.
  scene.scene = null;
  scene.src = `scenes/${name}.json`;
  json.value = await (await fetch(scene.src)).text();
}

select.addEventListener('change', () => {
  // The address of the page names the scene: scenes.html#metals
  location.hash = select.value;
});
addEventListener('hashchange', () => show(location.hash.slice(1)));
show(location.hash.slice(1) || select.value);

json.addEventListener('input', () => {
  scene.scene = json.value;
});

scene.addEventListener('load', () => {
  const { name } = scene.scene;
  document.getElementById('caption').textContent = name;
  scene.alt = name;
});
