import { animate } from './animate.js';

const scene = document.getElementById('scene');
await scene.ready;

animate(document.getElementById('play'), (t) => {
  scene.camera = { ...scene.camera, position: [5 * Math.sin(t / 4), 0, -5 * Math.cos(t / 4)] };
});
