import { expect } from '@open-wc/testing';
import type { ResolvedCamera } from '@ray-scene/core';
import { sendKeys, sendMouse } from '@web/test-runner-commands';
import type { RayScene } from '../../packages/ray-scene/src/index.ts';
import { canvasIn, partOf, sceneWith, someFrames, until } from './element-fixtures.ts';

const CONTENT = '<ray-camera position="0 0 5"></ray-camera><ray-sphere></ray-sphere>';

async function controlled(attributes = 'camera-controls'): Promise<RayScene> {
  const element = await sceneWith(CONTENT, attributes);
  await element.ready;
  // They are loaded when an element first asks for them.
  await import('../../packages/ray-scene/src/camera-controls.ts');
  return element;
}

const cameraOf = (element: RayScene): ResolvedCamera => {
  if (!element.camera) throw new Error('no camera yet');
  return element.camera;
};

const distance = ({ position, target }: ResolvedCamera): number =>
  Math.hypot(...position.map((x, i) => x - (target[i] ?? 0)));

/** A pointer event as a browser would send it, of a pointer that does not exist. */
function point(canvas: HTMLCanvasElement, type: string, pointerId: number, clientX: number, clientY: number): void {
  canvas.setPointerCapture = () => {};
  canvas.dispatchEvent(new PointerEvent(type, { pointerId, clientX, clientY, bubbles: true }));
}

describe('camera-controls', () => {
  it('orbit by the arrow keys, zoom by plus and minus, pan with shift, and start over', async () => {
    const element = await controlled();
    canvasIn(element).focus();
    await sendKeys({ press: 'ArrowRight' });
    expect(cameraOf(element).position[0]).to.be.above(0.5);
    expect(distance(cameraOf(element))).to.be.closeTo(5, 1e-9);
    await sendKeys({ press: 'ArrowUp' });
    expect(cameraOf(element).position[1]).to.be.above(0.5);
    await sendKeys({ press: '+' });
    expect(distance(cameraOf(element))).to.be.closeTo(5 / 1.1, 1e-9);
    await sendKeys({ press: '-' });
    expect(distance(cameraOf(element))).to.be.closeTo(5, 1e-9);
    await sendKeys({ press: 'Shift+ArrowLeft' });
    expect(cameraOf(element).target[0]).to.be.below(-0.1);
    await sendKeys({ press: 'Home' });
    await until(() => cameraOf(element).position[0] === 0);
    expect(cameraOf(element).position).to.deep.equal([0, 0, 5]);
    expect(partOf(element, 'ray-camera').position).to.deep.equal([0, 0, 5]);
  });

  it('orbit by a drag that may leave the element', async () => {
    const element = await controlled();
    const { left, top } = element.getBoundingClientRect();
    await sendMouse({ type: 'move', position: [Math.round(left + 50), Math.round(top + 20)] });
    await sendMouse({ type: 'down' });
    await sendMouse({ type: 'move', position: [Math.round(left + 70), Math.round(top + 20)] });
    await sendMouse({ type: 'up' });
    const dragged = cameraOf(element);
    expect(distance(dragged)).to.be.closeTo(5, 1e-9);
    expect(dragged.position[0]).to.be.below(-1);
    await sendMouse({ type: 'move', position: [Math.round(left + 10), Math.round(top + 20)] });
    expect(cameraOf(element)).to.deep.equal(dragged);
  });

  it('never go over the poles', async () => {
    const element = await controlled();
    const canvas = canvasIn(element);
    point(canvas, 'pointerdown', 7, 0, 0);
    point(canvas, 'pointermove', 7, 0, 1000);
    const { position } = cameraOf(element);
    expect(position[1]).to.be.closeTo(5, 1e-4);
    expect(position[2]).to.be.above(0);
  });

  it('zoom and pan by two fingers', async () => {
    const element = await controlled();
    const canvas = canvasIn(element);
    point(canvas, 'pointerdown', 7, 10, 20);
    point(canvas, 'pointerdown', 8, 20, 20);
    point(canvas, 'pointermove', 8, 30, 20);
    expect(distance(cameraOf(element))).to.be.closeTo(2.5, 1e-9);
    point(canvas, 'pointermove', 7, 20, 20);
    expect(distance(cameraOf(element))).to.be.closeTo(5, 1e-9);
    expect(cameraOf(element).target[0]).to.be.below(-0.1);
    point(canvas, 'pointerup', 7, 20, 20);
    point(canvas, 'pointercancel', 8, 30, 20);
    const { position } = cameraOf(element);
    point(canvas, 'pointermove', 8, 0, 0);
    expect(cameraOf(element).position).to.deep.equal(position);
  });

  it('zoom by the wheel with the focus or with Ctrl, and else let the page scroll', async () => {
    const element = await controlled();
    const canvas = canvasIn(element);
    const wheel = (init: WheelEventInit): boolean =>
      !canvas.dispatchEvent(new WheelEvent('wheel', { deltaY: 100, cancelable: true, ...init }));
    expect(wheel({})).to.equal(false);
    expect(distance(cameraOf(element))).to.equal(5);
    expect(wheel({ ctrlKey: true })).to.equal(true);
    const further = distance(cameraOf(element));
    expect(further).to.be.above(5.5);
    canvas.focus();
    expect(wheel({ deltaY: -6, deltaMode: WheelEvent.DOM_DELTA_LINE })).to.equal(true);
    expect(distance(cameraOf(element))).to.be.below(further);
  });

  it('give way to the author who edits the camera, but not to other edits', async () => {
    const element = await controlled();
    element.camera = { position: [3, 0, 0] };
    expect(cameraOf(element)).to.deep.equal({ position: [3, 0, 0], target: [0, 0, 0], up: [0, 1, 0], fov: 45 });
    partOf(element, 'ray-sphere').radius = 2;
    await element.ready;
    expect(cameraOf(element).position).to.deep.equal([3, 0, 0]);
    partOf(element, 'ray-camera').fov = 30;
    await element.ready;
    expect(cameraOf(element)).to.deep.include({ position: [0, 0, 5], fov: 30 });
    element.camera = { fov: 60 };
    element.resetCamera();
    await until(() => cameraOf(element).fov === 30);
  });

  it('may be set up before there is a picture', async () => {
    const element = await sceneWith(CONTENT);
    partOf(element, 'ray-camera').fov = 30;
    element.camera = { position: [3, 0, 0] };
    element.camera = { up: [0, 0, 1] };
    await element.ready;
    expect(cameraOf(element)).to.deep.equal({ position: [3, 0, 0], target: [0, 0, 0], up: [0, 0, 1], fov: 30 });
  });

  it('are not there unless wanted', async () => {
    const element = await controlled('');
    const canvas = canvasIn(element);
    point(canvas, 'pointerdown', 7, 0, 0);
    point(canvas, 'pointermove', 7, 20, 0);
    canvas.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowLeft' }));
    expect(cameraOf(element).position).to.deep.equal([0, 0, 5]);
    expect(canvas.hasAttribute('tabindex')).to.equal(false);
  });

  it('refuse a camera that cannot be', async () => {
    const element = await controlled();
    expect(() => {
      element.camera = { fov: -1 };
    }).to.throw('camera: fov must be a number from 0.000001 to 179, not -1');
  });
});

describe('auto-rotate', () => {
  const original = window.matchMedia;
  afterEach(() => {
    window.matchMedia = original;
  });

  it('walks around the scene, but not while paused', async () => {
    const element = await controlled('auto-rotate');
    await until(() => cameraOf(element).position[0] > 0.01);
    expect(distance(cameraOf(element))).to.be.closeTo(5, 1e-9);
    element.paused = true;
    await someFrames();
    const { position } = cameraOf(element);
    await someFrames(5);
    expect(cameraOf(element).position).to.deep.equal(position);
  });

  it('holds nothing of a page that it left before the code for it was there', async () => {
    const element = await sceneWith('<ray-sphere></ray-sphere>');
    const original = EventTarget.prototype.addEventListener;
    let held = 0;
    EventTarget.prototype.addEventListener = function (...args: Parameters<typeof original>) {
      if (this instanceof MediaQueryList && this.media.includes('reduced-motion')) held++;
      original.apply(this, args);
    };
    try {
      element.addController({ hostUpdated: () => element.remove() });
      element.autoRotate = true;
      await until(() => element.renderRoot.querySelector('#keys'));
      expect(held).to.equal(0);
      document.body.append(element);
      expect(held).to.equal(1);
    } finally {
      EventTarget.prototype.addEventListener = original;
      element.remove();
    }
  });

  it('stands still for who wants no motion', async () => {
    window.matchMedia = (query) =>
      query.includes('prefers-reduced-motion')
        ? Object.assign(new EventTarget() as MediaQueryList, { matches: true })
        : original.call(window, query);
    const element = await controlled('auto-rotate');
    await element.complete;
    await someFrames(5);
    expect(cameraOf(element).position).to.deep.equal([0, 0, 5]);
  });
});
