/** The custom elements manifest says what the elements have. */
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import Ajv from 'ajv';
import { parseHTML } from 'linkedom';
import * as all from 'ray-scene/element';
import { customElementsManifest } from '../../docs/custom-elements.ts';
import { ErrorOverlay } from '../../packages/ray-scene/src/error-overlay.ts';
import { ShadowTree } from '../../packages/ray-scene/src/shadow-tree.ts';
import { type StatsHost, StatsPanel } from '../../packages/ray-scene/src/stats-panel.ts';

const { RayScene, sceneElements } = all;
const json = (path: string) => JSON.parse(readFileSync(path, 'utf8'));

const manifest = customElementsManifest();
const elements = (manifest.modules[0]?.declarations ?? []).flatMap((declaration) =>
  'customElement' in declaration && declaration.kind === 'class' ? [declaration] : [],
);
const scene = elements.find(({ tagName }) => tagName === 'ray-scene');

const names = (list: readonly { readonly name: string }[] | undefined): string[] =>
  (list ?? []).map(({ name }) => name).sort();

test('the manifest is one by the schema of the community', () => {
  const ajv = new Ajv({ strict: false });
  const validate = ajv.compile(json('node_modules/custom-elements-manifest/schema.json'));
  assert.ok(validate(manifest), ajv.errorsText(validate.errors));
});

test('package.json names the manifest, and the manifest the module that registers the elements', () => {
  const { customElements, exports } = json('packages/ray-scene/package.json');
  assert.equal(customElements, 'dist/custom-elements.json');
  assert.equal(exports['./custom-elements.json'], `./${customElements}`);
  assert.deepEqual(
    manifest.modules.map(({ path }) => `./${path}`),
    [exports['.'].default],
  );
});

test('every element is there, with the attributes that it observes and what each property has', () => {
  const classes = { 'ray-scene': RayScene, ...sceneElements };
  assert.deepEqual(elements.map(({ tagName }) => tagName).sort(), Object.keys(classes).sort());
  for (const [tag, { observedAttributes, prototype }] of Object.entries(classes) as [string, typeof RayScene][]) {
    const element = elements.find(({ tagName }) => tagName === tag);
    assert.deepEqual(names(element?.attributes), [...observedAttributes].sort(), tag);
    assert.ok(element?.description, tag);
    for (const { name, description } of [...(element.attributes ?? []), ...(element.members ?? [])])
      assert.ok(description, `${tag}: ${name}`);
    for (const { kind, name } of element.members ?? []) {
      assert.ok(name in prototype, `${tag}: ${name}`);
      const { value } = Object.getOwnPropertyDescriptor(prototype, name) ?? {};
      assert.equal(typeof value === 'function', kind === 'method', `${tag}: ${name}`);
    }
  }
});

/** What lit and the browser call, but nobody else. */
const CALLED = ['constructor', 'connectedCallback', 'disconnectedCallback', 'createRenderRoot'];
const LIFECYCLE = [...CALLED, 'willUpdate', 'update', 'updated'];

test('<ray-scene> has no property and no method beside those', () => {
  const own = Object.getOwnPropertyNames(RayScene.prototype).filter((name) => !LIFECYCLE.includes(name));
  const listed = new Set(names(scene?.members));
  assert.deepEqual(
    own.filter((name) => !listed.has(name)),
    [],
  );
});

test('its parts and slots are those of its shadow tree', () => {
  const { document } = parseHTML('<div></div>');
  Object.assign(globalThis, { document });
  const root = document.createElement('div') as unknown as ShadowRoot;
  new ShadowTree(root);
  new ErrorOverlay(root);
  new StatsPanel(document.createElement('p') as unknown as StatsHost, root);
  const found = [...root.querySelectorAll('[part]')].map((element) => element.getAttribute('part'));
  assert.deepEqual(names(scene?.cssParts), found.sort());
  const slots = [...root.querySelectorAll('slot')].map((slot) => slot.getAttribute('name') ?? '');
  assert.deepEqual(names(scene?.slots), slots.sort());
});

test('its CSS properties are those that its styles ask for, with the same defaults', () => {
  const folder = 'packages/ray-scene/src';
  const styles = readdirSync(folder).map((file) => readFileSync(`${folder}/${file}`, 'utf8'));
  const asked = styles.flatMap((text) => [...text.matchAll(/: var\((--[\w-]+), (.*)\);/g)]);
  const listed = (scene?.cssProperties ?? []).map(({ name, default: value }) => [name, value]);
  assert.deepEqual(listed.sort(), asked.map(([, name, value]) => [name, value]).sort());
});

test('the README names what can be styled, filled and listened to', () => {
  const readme = readFileSync('README.md', 'utf8');
  const { cssParts = [], cssProperties = [], events = [], slots = [] } = scene ?? {};
  const told = [...cssParts, ...cssProperties, ...events].map(({ name }) => `\`${name}\``);
  const filled = slots.filter(({ name }) => name).map(({ name }) => `\`slot="${name}"\``);
  assert.deepEqual(
    [...told, ...filled].filter((text) => !readme.includes(text)),
    [],
  );
});

test('its events are those of its classes of events', () => {
  const problem = new Error('none');
  const events = [
    new all.RaySceneLoadEvent({} as ConstructorParameters<typeof all.RaySceneLoadEvent>[0]),
    new all.RaySceneErrorEvent(problem),
    new all.RaySceneProgressEvent('progress', 1, 2),
    new all.RaySceneCompleteEvent(1, 2, 'samples', undefined),
  ];
  const classes = Object.keys(all).filter((name) => name.endsWith('Event'));
  const made = events.map((event) => [event.type, event.constructor.name]);
  assert.deepEqual(made.map(([, name]) => name).sort(), classes.sort());
  assert.deepEqual((scene?.events ?? []).map(({ name, type }) => [name, type.text]).sort(), made.sort());
});
