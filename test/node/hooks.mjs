// Module hooks for Node: workspaces resolve to their sources, .ts and .glsl files load as modules.
import { readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { compileTypeScript, textModule } from './compile.mjs';

export function resolve(specifier, context, nextResolve) {
  return nextResolve(specifier, { ...context, conditions: [...context.conditions, 'source'] });
}

export async function load(url, context, nextLoad) {
  const path = url.startsWith('file:') ? fileURLToPath(url) : '';
  if (path.endsWith('.ts')) {
    const source = compileTypeScript(await readFile(path, 'utf8'), path);
    return { format: 'module', source, shortCircuit: true };
  }
  if (path.endsWith('.glsl')) {
    return { format: 'module', source: textModule(await readFile(path, 'utf8')), shortCircuit: true };
  }
  return nextLoad(url, context);
}
