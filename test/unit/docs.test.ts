/** The documentation says what the code does: tables, examples and links. UPDATE=1 writes the tables. */
import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { parseScene, parseSettings, settingsFields } from '@ray-scene/core';
import { transformSync } from 'esbuild';
import { RayScene } from 'ray-scene/element';
import { sceneTables, settingsTable } from '../../docs/tables.ts';

const documents = ['README.md', 'CONTRIBUTING.md', ...readdirSync('docs').map((name) => `docs/${name}`)].filter(
  (path) => path.endsWith('.md'),
);
const read = (path: string): string => readFileSync(path, 'utf8');

const generated: readonly [path: string, marker: string, text: string][] = [
  ['README.md', 'settings', settingsTable()],
  ['docs/scene.md', 'tables', sceneTables()],
];

for (const [path, marker, text] of generated) {
  test(`the table "${marker}" of ${path} is that of the code`, () => {
    const [start, end] = [`<!-- ${marker} -->\n`, `\n<!-- /${marker} -->`];
    const before = read(path);
    const [from, to] = [before.indexOf(start) + start.length, before.indexOf(end)];
    if (process.env.UPDATE) writeFileSync(path, before.slice(0, from) + text + before.slice(to));
    else assert.equal(before.slice(from, to), text, 'UPDATE=1 npm run test:unit writes it');
  });
}

test('the README lists every attribute of the element', () => {
  const [, text = ''] = /### Attributes(.*?)###/s.exec(read('README.md')) ?? [];
  const listed = [...text.matchAll(/^\| `([\w-]+)`/gm)].map(([, name]) => name);
  assert.deepEqual(listed.sort(), [...RayScene.observedAttributes].sort());
});

/** The text of every code block of a language. */
const blocks = (path: string, language: string): string[] =>
  [...read(path).matchAll(new RegExp(`\`\`\`${language}\\n(.*?)\`\`\``, 'gs'))].map(([, text]) => text as string);

type Attributes = { [name: string]: string };

/** The elements of simple markup, in their order, with their attributes in camelCase; `id` says nothing of a scene. */
const elements = (markup: string): { readonly tag: string; readonly attributes: Attributes }[] =>
  [...markup.matchAll(/<(ray-\w+)([^>]*)>/g)].map(([, tag = '', text = '']) => ({
    tag,
    attributes: Object.fromEntries(
      [...text.matchAll(/([\w-]+)(?:="([^"]*)")?/g)]
        .filter(([, name]) => name !== 'id')
        .map(([, name = '', value = '']) => [camelCase(name), value]),
    ),
  }));

const camelCase = (name: string): string => name.replace(/-(\w)/g, (_, letter: string) => letter.toUpperCase());

/** The scene that the children of one `<ray-scene>` describe. */
function sceneOf(markup: string): object {
  const all = (tag: string): Attributes[] =>
    elements(markup)
      .filter((element) => element.tag === `ray-${tag}`)
      .map(({ attributes }) => attributes);
  const [camera] = all('camera');
  const [environment] = all('environment');
  const [scene] = all('scene');
  return {
    ...(scene?.background && { background: scene.background }),
    ...(camera && { camera }),
    ...(environment && { environment }),
    lights: all('light'),
    materials: Object.fromEntries(all('material').map(({ name = '', ...fields }) => [name, fields])),
    objects: ['sphere', 'plane'].flatMap((type) => all(type).map((fields) => ({ type, ...fields }))),
  };
}

const sceneMarkup = (text: string): string[] =>
  [...text.matchAll(/<ray-scene(?:(?!<ray-scene).)*?<\/ray-scene>/gs)].map(([markup]) => markup);

test('the markup of the documentation is valid', () => {
  const examples = documents.flatMap((path) => sceneMarkup(read(path)));
  assert.ok(examples.length > 0);
  for (const markup of examples) {
    parseScene(sceneOf(markup));
    const [scene] = elements(markup);
    const settings = Object.entries(scene?.attributes ?? {}).filter(([name]) => name in settingsFields);
    parseSettings(Object.fromEntries(settings));
  }
});

test('the JSON of the documentation is valid', () => {
  const examples = documents.flatMap((path) => blocks(path, 'json'));
  assert.ok(examples.length > 0);
  for (const json of examples) parseScene(json);
});

test('the scripts of the documentation compile', () => {
  const examples = documents.flatMap((path) => [...blocks(path, 'js'), ...blocks(path, 'ts')]);
  assert.ok(examples.length > 0);
  for (const code of examples) transformSync(code, { loader: 'ts', format: 'esm' });
});

test('the README shows one scene in two ways, and hello.html and hello.json are that scene', () => {
  const [markup = ''] = sceneMarkup(read('README.md'));
  const [json = ''] = blocks('README.md', 'json');
  const [page = ''] = sceneMarkup(read('examples/hello.html'));
  const { name, ...file } = JSON.parse(read('examples/scenes/hello.json'));
  assert.deepEqual(parseScene(sceneOf(markup)), parseScene(json));
  assert.deepEqual(parseScene(file), parseScene(json));
  assert.ok(name);
  const lines = (text: string): string[] => text.split('\n').map((line) => line.trim());
  assert.deepEqual(lines(page).slice(1), lines(markup).slice(1));
});

test('the classic in markup is the classic in JSON', () => {
  const [markup = ''] = sceneMarkup(read('examples/classic.html'));
  const { name, objects, ...json } = JSON.parse(read('examples/scenes/classic.json'));
  assert.ok(name);
  const unnamed = objects.map(({ name: _, ...object }: { name: string }) => object);
  assert.deepEqual(parseScene(sceneOf(markup)), parseScene({ ...json, objects: unnamed }));
});

const sceneNames = readdirSync('examples/scenes').map((file) => file.replace('.json', ''));

test('every scene file is valid, and every page that lists scenes lists all', () => {
  for (const name of sceneNames) parseScene(read(`examples/scenes/${name}.json`));
  for (const page of ['scenes.html', 'reference.html']) {
    const listed = [...read(`examples/${page}`).matchAll(/<option[^>]*>(.*?)<\/option>/g)].map(([, name]) => name);
    assert.deepEqual(listed.sort(), sceneNames.sort(), page);
  }
});

test('the README lists every example page', () => {
  const pages = readdirSync('examples').filter((name) => name.endsWith('.html') && name !== 'index.html');
  const listed = [...read('README.md').matchAll(/\]\(examples\/(.*?\.html)\)/g)].map(([, name]) => name);
  assert.deepEqual(listed.sort(), pages.sort());
});

test('every link of a document leads to a file', () => {
  for (const path of documents) {
    for (const [, target = ''] of read(path).matchAll(/\]\(([^)#]+)(?:#[^)]*)?\)/g)) {
      if (!target.startsWith('http')) assert.ok(existsSync(join(dirname(path), target)), `${path}: ${target}`);
    }
  }
});

test('every file that a document names is there', () => {
  for (const path of documents) {
    for (const [, file = ''] of read(path).matchAll(/`((?:packages|shaders|examples|test|docs)\/[\w./-]+\.\w+)`/g)) {
      // What the reader is to make or to build, and placeholders.
      if (!/\bbox\b|\/dist\/|NAME/.test(file)) assert.ok(existsSync(file), `${path}: ${file}`);
    }
  }
});
