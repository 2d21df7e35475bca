/** From what a scene requires to the GLSL that draws it, and nothing more. */
import { type AssembledGlsl, assembleGlsl } from './assemble-glsl.ts';
import { glslFiles } from './glsl-files.ts';
import { sceneLayout, viewLayout } from './pack-scene.ts';
import { loadedParts, moreParts, pathParts } from './parts.ts';
import { shapeKinds } from './primitives/index.ts';
import { placedCount, type Requirements } from './requirements.ts';
import { type BlockLayout, blockGlsl, structGlsl } from './std140.ts';
import { unrolledObjects } from './unrolled-objects.ts';

export interface ShaderSource {
  readonly vertex: string;
  readonly fragment: string;
  /** `lines[i]` is where line i + 1 of `fragment` comes from. */
  readonly lines: AssembledGlsl['lines'];
  readonly sceneBlock: BlockLayout;
  readonly viewBlock: BlockLayout;
}

export interface ShaderOptions {
  /**
   * How many vec4 the scene's numbers may take as flat varyings (0: they are read as uniforms). Software rasterisers
   * read a varying much faster than a uniform; GPUs do not.
   */
  readonly varyings?: number;
  /** Text that stands in for `trace.frag.glsl`: the main function of a test, which calls the others with their numbers. */
  readonly main?: string;
}

/** The vertex and fragment shader of a scene with these requirements. */
export function generateShader(required: Requirements, { varyings = 0, main }: ShaderOptions = {}): ShaderSource {
  const indexed = required.features.includes('indexed');
  const gapless = sceneLayout(required, { gapless: true });
  // One more row is for the camera ray.
  const rows = !indexed && gapless.size / 16 < varyings ? moreParts().rows.varyingRows(gapless) : undefined;
  const scene = rows ? gapless : sceneLayout(required);
  const defined = definedNames(required);
  if (rows && !defined.has('EXACT_RAYS')) defined.add('VARYINGS');
  const view = viewLayout(defined);
  const paths = required.features.includes('path') ? pathParts() : undefined;
  const root = paths ? 'path.frag.glsl' : 'trace.frag.glsl';
  const files = {
    ...glslFiles,
    ...loadedParts()?.files,
    ...paths?.files,
    ...(main === undefined ? {} : { [root]: main }),
    'generated/limits.glsl': paths?.limitsGlsl(required) ?? `const float BOUNCES = ${required.bounces}.0;\n`,
    'generated/view.glsl': blockGlsl(view),
    'generated/emitters.glsl': paths?.emittersGlsl(required.features) ?? '',
    'generated/rows.glsl': rows?.vertex ?? '',
    'generated/scene.glsl': rows ? structGlsl(scene) + rows.fragment : blockGlsl(scene),
    'generated/objects.glsl':
      shapeIncludes(required) +
      (indexed ? moreParts().indexedObjects(required, scene) : unrolledObjects(required, scene, !!rows)),
  };
  const fragment = assembleGlsl(root, { files, defined });
  const vertex = assembleGlsl(rows ? 'varyings.vert.glsl' : 'fullscreen.vert.glsl', {
    files,
    defined,
  });
  return { vertex: vertex.text, fragment: fragment.text, lines: fragment.lines, sceneBlock: scene, viewBlock: view };
}

/** `specularTint` as it is asked for in GLSL: `SPECULAR_TINT`. */
export const glslName = (feature: string): string => feature.replace(/[A-Z]/g, '_$&').toUpperCase();

const countNames = { point: 'POINT_LIGHTS', directional: 'DIRECTIONAL_LIGHTS' } as const;

const shapeIncludes = (required: Requirements): string =>
  [
    ...shapeKinds.filter((kind) => required.shapes[kind] + required.placed[kind] > 0),
    ...(placedCount(required) > 0 ? ['placed'] : []),
  ]
    .map((name) => `#include "shape/${name}.glsl"\n`)
    .join('');

function definedNames({ features: present, lights }: Requirements): Set<string> {
  const lit = Object.entries(countNames).filter(([kind]) => lights[kind as keyof typeof lights] > 0);
  return new Set([...present.map(glslName), ...lit.map(([, name]) => name), ...(lit.length > 0 ? ['LIGHTS'] : [])]);
}
