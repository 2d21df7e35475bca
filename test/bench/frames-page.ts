/**
 * What the bench of frames does in a page: an element draws a heavy scene while somebody drags the camera round, and every
 * batch of its work is told, with how long it took.
 */
import '@ray-scene/core/parts';
// Bundled pages are without it otherwise, and then scenes at true scale are refused before anybody has looked closely.
import '../../packages/core/src/words.ts';
import '../../packages/ray-scene/src/index.ts';
import { CELL_PIXELS } from '../../packages/ray-scene/src/cells.ts';
import type { RayScene } from '../../packages/ray-scene/src/element.ts';
import { Pace } from '../../packages/ray-scene/src/pace.ts';

export interface Drag {
  /** JSON text of the scene. */
  readonly scene: string;
  /** Milliseconds. */
  readonly budget: number;
  /** CSS pixels; the device has as many. */
  readonly width: number;
  readonly height: number;
  readonly frames: number;
}

/** Work that was begun in one frame. */
export interface Work {
  readonly milliseconds: number;
  readonly pixels: number;
  /** Of one tile, at the pace of this work. */
  readonly tileMs: number;
}

const { learn } = Pace.prototype;
let told: Work[] = [];
Pace.prototype.learn = function (milliseconds, pixels) {
  told.push({ milliseconds, pixels, tileMs: (milliseconds / pixels) * CELL_PIXELS });
  learn.call(this, milliseconds, pixels);
};

const nextFrame = (): Promise<number> => new Promise(requestAnimationFrame);

/** Pixels that the pointer goes in a frame. */
const STRIDE = 3;
/** Frames until the pace is known and the programs are compiled for all that they meet. */
const FIRST_FRAMES = 30;

/** Drags for so many frames. Returns the work of those in which some was begun. */
export async function drag({ scene, budget, width, height, frames }: Drag): Promise<readonly Work[]> {
  document.body.replaceChildren();
  const element = document.createElement('ray-scene') as RayScene;
  element.style.cssText = `display: block; width: ${width}px; height: ${height}px`;
  Object.assign(element, { cameraControls: true, frameBudget: budget, integrator: 'path', pixelRatio: 1 });
  element.append(Object.assign(document.createElement('script'), { type: 'application/json', textContent: scene }));
  document.body.append(element);
  await element.ready;
  const canvas = element.shadowRoot?.querySelector('canvas') as HTMLCanvasElement;
  // Nothing but a real pointer can be captured.
  canvas.setPointerCapture = () => {};
  const point = (type: string, x: number): boolean =>
    canvas.dispatchEvent(new PointerEvent(type, { pointerId: 1, clientX: x, clientY: height / 2, button: 0 }));
  let x = 0;
  const move = async (count: number): Promise<void> => {
    for (let frame = 0; frame < count; frame++) {
      x += STRIDE;
      point('pointermove', x);
      await nextFrame();
    }
  };
  point('pointerdown', x);
  await move(FIRST_FRAMES);
  told = [];
  await move(frames);
  point('pointerup', x);
  element.remove();
  return told;
}
