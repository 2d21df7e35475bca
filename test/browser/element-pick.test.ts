import { expect } from '@open-wc/testing';
import { sendMouse } from '@web/test-runner-commands';
import type { RayScene } from '../../packages/ray-scene/src/index.ts';
import { ObjectEvents } from '../../packages/ray-scene/src/object-events.ts';
import { canvasIn, sceneWith, until } from './element-fixtures.ts';

const LEFT = '<ray-sphere id="left" center="-1 0 0" radius="0.5"></ray-sphere>';
const RIGHT = '<ray-sphere id="right" center="1 0 0" radius="0.5"></ray-sphere>';
const CAMERA = '<ray-camera position="0 0 5" fov="45"></ray-camera>';

async function drawn(content = CAMERA + LEFT + RIGHT, attributes = ''): Promise<RayScene> {
  const element = await sceneWith(content, attributes);
  await element.ready;
  return element;
}

/** Where a point of the picture is on the page: (0, 0) its middle, y = 1 its upper edge. */
function at(element: RayScene, x: number, y: number): [number, number] {
  const { left, top, width, height } = canvasIn(element).getBoundingClientRect();
  return [left + width / 2 + (x * height) / 2, top + height / 2 - (y * height) / 2];
}

/** Where the middle of a ball at x = ±1 is seen. */
const BALL = 1 / 5 / Math.tan(Math.PI / 8);

describe('pick', () => {
  it('tells the object, its element, the distance, the point and the normal', async () => {
    const element = await drawn();
    const hit = await element.pick(...at(element, BALL, 0));
    expect(hit?.object).to.equal(1);
    expect(hit?.element?.id).to.equal('right');
    // Straight at the centre of the ball.
    expect(hit?.t).to.be.closeTo(Math.sqrt(26) - 0.5, 1e-9);
    expect(hit?.position[0]).to.be.closeTo(1 - 0.5 / Math.sqrt(26), 1e-9);
    expect(hit?.normal[2]).to.be.closeTo(5 / Math.sqrt(26), 1e-9);
  });

  it('tells nothing where nothing is, in the picture or outside of it', async () => {
    const element = await drawn();
    expect(await element.pick(...at(element, 0, 0))).to.equal(undefined);
    expect(await element.pick(...at(element, 0, 3))).to.equal(undefined);
  });

  it('follows the camera in use', async () => {
    const element = await drawn();
    element.camera = { position: [0, 0, -5] };
    expect((await element.pick(...at(element, BALL, 0)))?.element?.id).to.equal('left');
  });

  it('looks along an orthographic view', async () => {
    const element = await drawn(`<ray-camera type="orthographic" position="0 0 5" height="4"></ray-camera>${RIGHT}`);
    const hit = await element.pick(...at(element, 0.5, 0.125));
    expect(hit?.normal[0]).to.be.closeTo(0, 1e-9);
    expect(hit?.normal[1]).to.be.closeTo(0.5, 1e-9);
  });

  it('does not shift with a border', async () => {
    const element = await drawn();
    element.style.border = '20px solid';
    await element.complete;
    expect((await element.pick(...at(element, BALL, 0)))?.normal[1]).to.be.closeTo(0, 1e-9);
  });

  it('knows no elements of a scene from elsewhere', async () => {
    const element = await drawn();
    element.scene = { camera: { position: [0, 0, 5] }, objects: [{ type: 'sphere' }] };
    const hit = await element.pick(...at(element, 0, 0));
    expect(hit?.object).to.equal(0);
    expect(hit?.element).to.equal(undefined);
  });

  it('finds the light that a ball belongs to', async () => {
    const element = await drawn(`${CAMERA}${RIGHT}<ray-light position="0 0 0" radius="0.2"></ray-light>`);
    const hit = await element.pick(...at(element, 0, 0));
    expect(hit?.object).to.equal(-1);
    expect(hit?.element?.localName).to.equal('ray-light');
  });
});

/** What comes to the element and bubbles to it, as `type target`. */
function listen(element: RayScene, ...types: string[]): string[] {
  const seen: string[] = [];
  for (const type of types) {
    element.addEventListener(type, ({ target }) => seen.push(`${type} ${(target as Element).id || 'scene'}`));
  }
  return seen;
}

const rounded = (place: [number, number]): [number, number] => [Math.round(place[0]), Math.round(place[1])];

describe('pointer events', () => {
  it('click: the very first one comes to the element, once, and bubbles', async () => {
    const element = await drawn();
    const seen = listen(element, 'click');
    await sendMouse({ type: 'click', position: rounded(at(element, BALL, 0)) });
    await until(() => seen.length > 0);
    expect(seen).to.deep.equal(['click right']);
    await sendMouse({ type: 'click', position: rounded(at(element, -BALL, 0)) });
    await sendMouse({ type: 'click', position: rounded(at(element, 0, 0)) });
    expect(seen).to.deep.equal(['click right', 'click left', 'click scene']);
  });

  it('enter and leave the objects', async () => {
    // A pointer that an earlier test has left above the picture would be told of by the element itself.
    await sendMouse({ type: 'move', position: [1, 1] });
    const element = await drawn();
    const seen: string[] = [];
    for (const type of ['pointerenter', 'pointerleave']) {
      for (const part of element.querySelectorAll('ray-sphere')) {
        part.addEventListener(type, ({ target }) => seen.push(`${type} ${(target as Element).id}`));
      }
    }
    new ObjectEvents(element, canvasIn(element));
    for (const x of [-BALL, -BALL, 0, BALL]) move(element, 'pointermove', x);
    move(element, 'pointerout', BALL);
    expect(seen).to.deep.equal(['pointerenter left', 'pointerleave left', 'pointerenter right', 'pointerleave right']);
  });

  it('say what the original says, and prevent what it would do', async () => {
    const element = await drawn();
    new ObjectEvents(element, canvasIn(element));
    let copy: PointerEvent | undefined;
    element.addEventListener('pointerdown', (event) => {
      copy = event;
      event.preventDefault();
    });
    const original = move(element, 'pointerdown', BALL, { pointerId: 7, ctrlKey: true, pressure: 0.25 });
    expect(original.defaultPrevented).to.equal(true);
    expect(copy?.target).to.equal(element.querySelector('#right'));
    const { clientX, pointerId, ctrlKey, pressure } = copy as PointerEvent;
    expect([clientX, pointerId, ctrlKey, pressure]).to.deep.equal([original.clientX, 7, true, 0.25]);
  });

  it('a drag that looks around is no click on an object', async () => {
    const element = await drawn(`${CAMERA}<ray-sphere id="large" radius="1.5"></ray-sphere>`, 'camera-controls');
    const seen = listen(element, 'click');
    await import('../../packages/ray-scene/src/camera-controls.ts');
    const [x, y] = rounded(at(element, 0, 0));
    await sendMouse({ type: 'click', position: [x, y] });
    await until(() => seen.length > 0);
    await sendMouse({ type: 'down' });
    await sendMouse({ type: 'move', position: [x + 8, y] });
    await sendMouse({ type: 'up' });
    expect(element.camera?.position[0]).to.be.below(-0.1);
    await sendMouse({ type: 'click', position: [x, y] });
    expect(seen).to.deep.equal(['click large', 'click scene', 'click large']);
  });

  it('are those of the picture where the scene is not made of elements', async () => {
    const element = await drawn('');
    element.scene = { camera: { position: [0, 0, 5] }, objects: [{ type: 'sphere' }] };
    await element.ready;
    const seen = listen(element, 'click');
    await sendMouse({ type: 'click', position: rounded(at(element, 0, 0)) });
    expect(seen).to.deep.equal(['click scene']);
  });
});

/** An event of the picture as a browser would send it. */
function move(element: RayScene, type: string, x: number, more: PointerEventInit = {}): PointerEvent {
  const [clientX, clientY] = at(element, x, 0);
  const event = new PointerEvent(type, { clientX, clientY, bubbles: true, composed: true, cancelable: true, ...more });
  canvasIn(element).dispatchEvent(event);
  return event;
}
