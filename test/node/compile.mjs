// How a source file becomes a JavaScript module: the one definition for Node, the browser tests and the build.
import { transformSync } from 'esbuild';

// lit's decorators need the first two; esbuild reads no tsconfig in its transform mode.
const compilerOptions = { experimentalDecorators: true, useDefineForClassFields: false, verbatimModuleSyntax: true };

/** JavaScript and source map of a TypeScript file. `sourcemap` is 'inline' (in the code) or 'external' (in `map`). */
export function compileTypeScript(code, path, sourcemap = 'inline') {
  return transformSync(code, {
    loader: 'ts',
    target: 'es2022',
    format: 'esm',
    sourcefile: path,
    sourcemap,
    tsconfigRaw: { compilerOptions },
  });
}

/** A shader file as a module whose default export is its text. */
export const textModule = (text) => `export default ${JSON.stringify(text)};`;
