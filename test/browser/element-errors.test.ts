import { expect, oneEvent } from '@open-wc/testing';
import { builtInMaterials, SceneError } from '@ray-scene/core';
import { type RayScene, type RaySceneErrorEvent, sceneElements } from '../../packages/ray-scene/src/index.ts';
import {
  countEvents,
  middlePixel,
  overlayOf,
  partOf,
  QuietConsole,
  rejection,
  sceneWith,
  someFrames,
  until,
} from './element-fixtures.ts';

const takes = (tag: keyof typeof sceneElements): string => sceneElements[tag].observedAttributes.join(', ');
const holds = Object.keys(sceneElements)
  .map((tag) => `<${tag}>`)
  .join(', ');
const builtIn = Object.keys(builtInMaterials).join(', ');

/** Content of a `<ray-scene>`, and all that is wrong with it. */
const mistakes: { readonly [name: string]: readonly [content: string, ...problems: string[]] } = {
  'a misspelt attribute': [
    '<ray-sphere></ray-sphere><ray-sphere raduis="2"></ray-sphere>',
    `ray-scene > ray-sphere[2]: unknown attribute "raduis" (did you mean "radius"?). A sphere takes: ${takes('ray-sphere')}.`,
  ],
  'an attribute in camel case': [
    '<ray-plane checkerSize="2"></ray-plane>',
    `ray-scene > ray-plane: unknown attribute "checkersize" (did you mean "checker-size"?). A plane takes: ${takes('ray-plane')}.`,
  ],
  'a type on a shape': [
    '<ray-sphere type="plane"></ray-sphere>',
    'ray-scene > ray-sphere: unknown attribute "type": <ray-sphere> says it already',
  ],
  'an unknown element': [
    '<ray-spere></ray-spere>',
    `ray-scene > ray-spere: unknown element <ray-spere> (did you mean <ray-sphere>?). A ray-scene holds: ${holds}.`,
  ],
  'an element without its prefix': [
    '<sphere></sphere>',
    `ray-scene > sphere: unknown element <sphere> (did you mean <ray-sphere>?). A ray-scene holds: ${holds}.`,
  ],
  'an element nothing is like': [
    '<ray-unicorn></ray-unicorn>',
    `ray-scene > ray-unicorn: unknown element <ray-unicorn>. A ray-scene holds: ${holds}.`,
  ],
  'self-closed elements, with all else that is wrong': [
    '<ray-camera position="0 0 5"/><ray-sphere/><ray-plane normal="up">',
    'ray-scene > ray-camera: holds other elements, as <ray-camera/> does in HTML: write <ray-camera></ray-camera>',
    'ray-scene > ray-camera > ray-sphere: holds other elements, as <ray-sphere/> does in HTML: write <ray-sphere></ray-sphere>',
    'ray-scene > ray-camera > ray-sphere > ray-plane: normal must be three numbers "x y z", not all 0, not "up"',
  ],
  'a negative radius': [
    '<ray-sphere radius="-1"></ray-sphere>',
    'ray-scene > ray-sphere: radius must be a number above 0, not "-1"',
  ],
  'what is not a number': [
    '<ray-sphere radius="NaN"></ray-sphere>',
    'ray-scene > ray-sphere: radius must be a number above 0, not "NaN"',
  ],
  'a material that is missing': [
    '<ray-material name="red"></ray-material><ray-sphere material="read"></ray-sphere>',
    `ray-scene > ray-sphere: unknown material "read" (did you mean "red"?). Materials here: red, ${builtIn}.`,
  ],
  'materials without a name of their own': [
    '<ray-material></ray-material><ray-material name="red"></ray-material><ray-material name="red"></ray-material>',
    'ray-scene > ray-material[1]: needs a name, for objects to refer to',
    'ray-scene > ray-material[3]: another material has the name "red"',
  ],
  'two cameras': [
    '<ray-camera></ray-camera><ray-camera></ray-camera>',
    'ray-scene > ray-camera[2]: a scene has one camera, and this is another',
  ],
  'a field of another kind of light': [
    '<ray-light type="directional" decay="0"></ray-light>',
    'ray-scene > ray-light: unknown attribute "decay". A directional light takes: name, direction, position, target, color, intensity, angular-diameter.',
  ],
  'an unknown type of light': [
    '<ray-light type="pont"></ray-light>',
    'ray-scene > ray-light: unknown type "pont" (did you mean "point"?). Types of light: point, spot, directional.',
  ],
  'two scenes': [
    '<ray-sphere></ray-sphere><script type="application/json">{}</script>',
    'ray-scene: has 2 scenes: an inline script, child elements. Keep one of them.',
  ],
  'a key that JSON does not have': [
    '<script type="application/json">{ "objects": [{ "type": "sphere", "radius": "big" }] }</script>',
    'ray-scene > script objects[0]: radius must be a number above 0, not "big"',
  ],
};

describe('errors of <ray-scene>', () => {
  let quiet: QuietConsole;
  beforeEach(() => {
    quiet = new QuietConsole();
  });
  afterEach(() => quiet.restore());

  for (const [name, [content, ...problems]] of Object.entries(mistakes)) {
    it(`mends ${name}`, async () => {
      const element = await sceneWith(content);
      const error = await rejection(element.ready);
      expect(error).to.be.instanceOf(SceneError);
      expect(error.message.split('\n')).to.deep.equal(problems);
      expect(quiet.lines).to.deep.equal(problems);
      await element.updateComplete;
      expect(overlayOf(element)).to.equal(problems.join('\n'));
      expect(element.scene).to.equal(undefined);
    });
  }

  it('tells of a number that is none', async () => {
    const element = await sceneWith('<ray-sphere></ray-sphere>');
    await element.ready;
    partOf(element, 'ray-sphere').radius = Number.NaN;
    const { error } = await oneEvent<RaySceneErrorEvent>(element, 'error');
    expect(error.message).to.equal('ray-scene > ray-sphere: radius must be a number above 0, not NaN');
  });

  it('tells of JSON that is none', async () => {
    const error = await rejection((await sceneWith('<script type="application/json">{ broken</script>')).ready);
    expect(error.message).to.match(/^ray-scene > script: is not JSON: ./);
  });

  it('tells which address has no scene', async () => {
    const error = await rejection((await sceneWith('', 'src="no-such-scene.json"')).ready);
    const url = new URL('no-such-scene.json', document.baseURI).href;
    expect(error.message).to.equal(`${url}: could not be loaded: 404 Not Found`);
  });

  it('tells of attributes that mean nothing, and draws all the same', async () => {
    const element = await sceneWith('<ray-sphere></ray-sphere>', 'exposre="2" bounces="none" background="blurple"');
    const errors = countEvents(element, 'error');
    await element.ready;
    const known = (customElements.get('ray-scene') as typeof RayScene).observedAttributes.join(', ');
    expect(quiet.lines).to.have.lengthOf(3);
    expect(quiet.lines[0]).to.equal(
      `ray-scene: unknown attribute "exposre" (did you mean "exposure"?). A ray-scene takes: ${known}.`,
    );
    expect(quiet.lines[1]).to.equal('ray-scene: bounces must be a whole number from 0 to 64, not "none"');
    expect(quiet.lines[2]).to.match(
      /^ray-scene: background must be "environment", "transparent" or a colour, not "blurple"/,
    );
    expect(errors.count).to.equal(1);
    expect(element.bounces).to.equal(6);
  });

  it('leaves attributes alone that belong to the page or to a framework', async () => {
    const attributes =
      'id="a" class="b" data-c="d" aria-hidden="true" tabindex="-1" title="e" v-if="f" _ngcontent-g @click="h" x-data ' +
      'itemprop="image" itemscope itemtype="https://schema.org/Product" defer-hydration';
    const element = await sceneWith(`<ray-sphere ${attributes} onclick=""></ray-sphere>`, attributes);
    await element.ready;
    expect(quiet.lines).to.deep.equal([]);
  });

  it('leaves HTML for people alone', async () => {
    const content = '<p>No picture?</p><img alt=""><my-widget></my-widget><svg></svg><figcaption>Ball</figcaption>';
    const element = await sceneWith(`A text. ${content}<ray-sphere></ray-sphere>`);
    await element.ready;
    expect(quiet.lines).to.deep.equal([]);
    expect(element.querySelector('p')?.checkVisibility?.({ visibilityProperty: true })).to.not.equal(true);
  });

  it('keeps the last good picture, and says each thing once until it changes', async () => {
    const element = await sceneWith('<ray-sphere color="red"></ray-sphere>');
    await element.complete;
    const before = middlePixel(element);
    const sphere = partOf(element, 'ray-sphere');
    const errors = countEvents(element, 'error');
    const loads = countEvents(element, 'load');

    sphere.setAttribute('radius', '-1');
    const first = await rejection(element.ready);
    expect(first.message).to.equal('ray-scene > ray-sphere: radius must be a number above 0, not "-1"');
    expect(middlePixel(element)).to.deep.equal(before);
    expect(element.scene?.objects[0]).to.include({ radius: 1 });

    element.append(document.createElement('ray-plane'));
    await rejection(element.ready);
    expect(errors.count).to.equal(1);
    expect(quiet.lines).to.have.lengthOf(1);

    sphere.setAttribute('colour', 'blue');
    const second = await rejection(element.ready);
    expect((second as SceneError).problems).to.have.lengthOf(2);
    expect(errors.count).to.equal(2);
    expect(quiet.lines).to.have.lengthOf(2);

    sphere.removeAttribute('colour');
    sphere.removeAttribute('radius');
    await element.ready;
    expect(loads.count).to.equal(1);
    await until(() => overlayOf(element) === undefined);
    expect(element.scene?.objects).to.have.lengthOf(2);
  });

  it('leaves no rejection that nobody handles', async () => {
    const unhandled: unknown[] = [];
    const listen = (event: PromiseRejectionEvent): void => {
      event.preventDefault();
      unhandled.push(event.reason);
    };
    addEventListener('unhandledrejection', listen);
    await sceneWith('<ray-sphere radius="0"></ray-sphere>');
    await someFrames(5);
    removeEventListener('unhandledrejection', listen);
    expect(quiet.lines).to.have.lengthOf(1);
    expect(unhandled).to.deep.equal([]);
  });
});
