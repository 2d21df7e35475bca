// Calls `draw` with the seconds that passed, every frame, until the button stops it. Who asked the system for less
// motion has to start it.
export function animate(button, draw) {
  let seconds = 0;
  let last;
  let frame;

  function step(now) {
    seconds += (now - (last ?? now)) / 1000;
    last = now;
    draw(seconds);
    frame = requestAnimationFrame(step);
  }

  function play(playing) {
    button.textContent = playing ? 'Pause' : 'Play';
    cancelAnimationFrame(frame);
    last = undefined;
    frame = playing ? requestAnimationFrame(step) : undefined;
  }

  button.addEventListener('click', () => play(frame === undefined));
  play(!matchMedia('(prefers-reduced-motion: reduce)').matches);
}
