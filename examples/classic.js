import { animate } from './animate.js';

const camera = document.getElementById('camera');

animate(document.getElementById('play'), (t) => {
  camera.position = [5 * Math.sin(t / 4), 0, -5 * Math.cos(t / 4)];
});
