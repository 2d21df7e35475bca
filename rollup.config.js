// Builds both packages: ES modules whose dependencies stay imports, their types, and minified files for pages without a build step.
import { readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, resolve } from 'node:path';
import { brotliCompressSync } from 'node:zlib';
import { nodeResolve } from '@rollup/plugin-node-resolve';
import terser from '@rollup/plugin-terser';
import { transformSync } from 'esbuild';
import { dts } from 'rollup-plugin-dts';
import { compileTypeScript, textModule } from './test/node/compile.mjs';
import { plainGlsl } from './test/node/plain-glsl.mjs';
import { stripGlsl } from './test/node/strip-glsl.mjs';
import './test/node/register.mjs';

const manifest = (folder) => JSON.parse(readFileSync(`${folder}/package.json`, 'utf8'));

/**
 * The table's texts are for people and for tools, which read the modules; no page needs them. The first argument of a
 * kind of field is its text.
 */
const withoutDocs = {
  name: 'without-docs',
  transform(code, path) {
    if (!/core\/src\/(schema|settings|primitives\/\w+)\.ts$/.test(path)) return undefined;
    const text =
      /(?<=\b(?:number|vector|factors|color|choice|name)\(\s*|\bdoc:\s*)(['"]).*?(?<!\\)\1(?:\s*\+\s*'[^']*')*/gs;
    return { code: code.replace(text, "''"), map: null };
  },
};

/** The named colours of CSS in the order of their numbers, and the steps from one to the next, which are shorter. */
const shortColorNames = {
  name: 'short-color-names',
  async transform(_code, path) {
    if (!path.endsWith('culori/src/colors/named.js')) return undefined;
    const { default: named } = await import(path);
    const colors = Object.entries(named).sort(([, a], [, b]) => a - b);
    const names = colors.map(([name]) => name).join(' ');
    const steps = colors.map(([, color], i) => color - (i > 0 ? colors[i - 1][1] : 0));
    const all = `'${names}'.split(' ').map((name, i) => [name, (color += [${steps}][i])]).sort()`;
    return {
      code: `let color = 0; export default Object.fromEntries(${all});`,
      map: null,
      moduleSideEffects: false,
    };
  },
};

/** Indents and comments of style sheets. */
const shortStyles = {
  name: 'short-styles',
  transform(code, path) {
    if (!/\/(?:styles|error-overlay)\.ts$/.test(path)) return undefined;
    const shorter = (css) => css.replace(/\/\*.*?\*\//gs, '').replace(/\s*\n\s*|(?<=:) /g, '');
    return { code: code.replace(/`[^`]*`/g, shorter), map: null };
  },
};

/** The constants of WebGL as the numbers that they are, which TypeScript knows. */
const glNumbers = {
  name: 'gl-numbers',
  transform(code, path) {
    if (!/ray-scene\/src\/[\w-]+\.ts$/.test(path)) return undefined;
    return {
      code: code.replace(/\b(?:this\.#?)?gl\.([A-Z][\dA-Z_]+)\b/g, (all, name) => glValues.get(name) ?? all),
      map: null,
    };
  },
};

const domTypes = readFileSync(createRequire(import.meta.url).resolve('typescript/lib/lib.dom.d.ts'), 'utf8');
const glValues = new Map(
  [...domTypes.matchAll(/^interface WebGL2?RenderingContextBase .*?^\}/gms)]
    .flatMap(([members]) => [...members.matchAll(/readonly ([\dA-Z_]+): (0x[\dA-F]+|\d+);/g)])
    .map(([, name, value]) => [name, String(Number(value))]),
);

/** Every browser that reads ES2022, as this file is, adopts style sheets. */
const adoptedStyles = {
  name: 'adopted-styles',
  transform(code, path) {
    if (!path.endsWith('reactive-element/css-tag.js')) return undefined;
    const asked = /\w+\.ShadowRoot&&.*?"replace"in CSSStyleSheet\.prototype/;
    if (!asked.test(code)) this.error('lit asks in other words whether the browser adopts style sheets');
    return { code: code.replace(asked, 'true'), map: null };
  },
};

/** Gives private names one letter, which terser does not. */
const shortPrivateNames = {
  name: 'short-private-names',
  renderChunk: (code) => ({ code: transformSync(code, { minify: true, target: 'es2022' }).code, map: null }),
};

const sources = {
  name: 'sources',
  transform(code, path) {
    if (path.endsWith('.ts')) return { code: compileTypeScript(code, path), map: null };
    return path.endsWith('.glsl') ? { code: textModule(stripGlsl(code)), map: { mappings: '' } } : undefined;
  },
};

/** The files that every page loads, without the branches of what comes with a chunk; that brings them whole. */
const plainShaders = {
  name: 'plain-shaders',
  resolveId(source, importer) {
    if (!importer?.endsWith('/glsl-files.ts') || !source.endsWith('.glsl')) return undefined;
    return `${resolve(dirname(importer), source)}?plain`;
  },
  async load(id) {
    if (!id.endsWith('?plain')) return undefined;
    const { moreNames } = await import('./packages/core/src/load-parts.ts');
    const text = readFileSync(id.replace('?plain', ''), 'utf8');
    return { code: textModule(stripGlsl(plainGlsl(text, new Set(moreNames)))), map: { mappings: '' } };
  },
};

/** Prints what a browser downloads, and holds every file to the size that its package promises. */
function sizes(folder) {
  const { maxBrotliBytes = {} } = manifest(folder);
  return {
    name: 'sizes',
    generateBundle(_options, bundle) {
      for (const [name, { code }] of Object.entries(bundle)) {
        const bytes = brotliCompressSync(code).length;
        const limit = maxBrotliBytes[`dist/${name}`];
        console.log(`${folder}/dist/${name}: ${bytes} bytes brotli${limit ? ` of ${limit}` : ''}`);
        if (bytes > limit) this.error(`${name} has ${bytes} bytes brotli, more than the ${limit} of its promise`);
      }
    },
  };
}

/** A warning of the bundler is a mistake in the sources, and fails the build; dependencies may have their cycles. */
function onLog(level, log, handle) {
  if (log.code === 'CIRCULAR_DEPENDENCY' && log.ids.every((id) => id.includes('node_modules'))) return;
  handle(level === 'warn' ? 'error' : level, log);
}

/** A file of JSON beside the modules; what makes it is loaded when they are there. */
const jsonFile = (fileName, make) => ({
  name: fileName,
  async generateBundle() {
    this.emitFile({ type: 'asset', fileName, source: `${JSON.stringify(await make(), undefined, 2)}\n` });
  },
});

/** The JSON Schema of scene files, for editors. */
const schemaFile = jsonFile('scene.schema.json', async () =>
  (await import('./packages/core/src/json-schema.ts')).sceneJsonSchema(),
);

/** What the elements take, for editors and for viewers of documentation. */
const customElementsFile = jsonFile('custom-elements.json', async () =>
  (await import('./docs/custom-elements.ts')).customElementsManifest(),
);

function modules(folder, input, ...more) {
  const dependencies = Object.keys(manifest(folder).dependencies);
  const external = (id) => dependencies.some((name) => id === name || id.startsWith(`${name}/`));
  // Without hoisting, an entry imports what it uses itself, not what its chunks use.
  const output = { dir: `${folder}/dist`, chunkFileNames: '[name].js', hoistTransitiveImports: false };
  const types = dts({ tsconfig: `${folder}/tsconfig.json` });
  return [
    { input, output, external, onLog, plugins: [nodeResolve(), sources, sizes(folder), ...more] },
    { input, output: { ...output, chunkFileNames: '[name].d.ts' }, external, onLog, plugins: [types] },
  ];
}

// Every licence of what these files hold asks to be named with it.
const LIT = 'lit (BSD-3-Clause, Google LLC), ';
const licences = (folder, others) =>
  `/*! ray-scene ${manifest(folder).version}, MIT. With ${others}gl-matrix and culori (MIT). */`;

const minify = (folder) => [
  withoutDocs,
  shortColorNames,
  shortStyles,
  glNumbers,
  adoptedStyles,
  sources,
  shortPrivateNames,
  terser({
    module: true,
    ecma: 2020,
    compress: { passes: 3, keep_fargs: false, unsafe: true },
    format: { comments: /^!/, quote_style: 1 },
  }),
  sizes(folder),
];

const resolvePage = (...conditions) =>
  nodeResolve({ exportConditions: [...conditions, 'source', 'production'], browser: true });

/** One file that a page names, and chunks beside it that it loads when a scene asks for them. */
function entryFile(folder, name, input, others = '') {
  return {
    input: { [name]: input },
    // Chunks import what they share from the entry, which stays one file.
    preserveEntrySignatures: 'allow-extension',
    output: { dir: `${folder}/dist`, chunkFileNames: `${name}.[name].js`, banner: licences(folder, others) },
    onLog,
    plugins: [resolvePage('on-demand'), plainShaders, ...minify(folder)],
  };
}

/** One file with everything in it. */
function wholeFile(folder, name, input, others) {
  return {
    input,
    output: { file: `${folder}/dist/${name}.js`, inlineDynamicImports: true, banner: licences(folder, others) },
    onLog,
    plugins: [resolvePage(), ...minify(folder)],
  };
}

for (const folder of ['packages/core', 'packages/ray-scene'])
  rmSync(`${folder}/dist`, { recursive: true, force: true });

export default [
  ...modules(
    'packages/core',
    {
      index: 'packages/core/src/index.ts',
      reference: 'packages/core/src/reference/index.ts',
      parts: 'packages/core/src/all-parts.ts',
    },
    schemaFile,
  ),
  ...modules(
    'packages/ray-scene',
    {
      index: 'packages/ray-scene/src/index.ts',
      element: 'packages/ray-scene/src/element.ts',
      renderer: 'packages/ray-scene/src/renderer.ts',
    },
    customElementsFile,
  ),
  entryFile('packages/core', 'reference.min', 'packages/core/src/reference/index.ts'),
  entryFile('packages/ray-scene', 'ray-scene.min', 'packages/ray-scene/src/index.ts', LIT),
  wholeFile('packages/ray-scene', 'ray-scene.whole.min', 'packages/ray-scene/src/index.ts', LIT),
];
