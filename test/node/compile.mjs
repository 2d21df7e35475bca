// How a source file becomes a JavaScript module: the one definition for Node, the browser tests and the build.
import { basename } from 'node:path';
import { transformSync } from 'esbuild';

// lit's decorators need the first two; esbuild reads no tsconfig in its transform mode.
const compilerOptions = { experimentalDecorators: true, useDefineForClassFields: false, verbatimModuleSyntax: true };

/** JavaScript of a TypeScript file, with its source map as a comment. */
export function compileTypeScript(code, path) {
  return transformSync(code, {
    loader: 'ts',
    target: 'es2022',
    format: 'esm',
    sourcefile: basename(path),
    // Names in a source map are relative to the file it is in.
    sourcemap: 'inline',
    tsconfigRaw: { compilerOptions },
  }).code;
}

/** A shader file as a module whose default export is its text. */
export const textModule = (text) => `export default ${JSON.stringify(text)};`;
