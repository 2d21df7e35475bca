/** From what a scene requires to the GLSL that draws it, and nothing more. */
import { type AssembledGlsl, assembleGlsl } from './assemble-glsl.ts';
import { glslFiles } from './glsl-files.ts';
import { indexedObjects } from './indexed-objects.ts';
import { layoutBlocks } from './pack-scene.ts';
import { shapeKinds } from './primitives/index.ts';
import { features, type Requirements } from './requirements.ts';
import { type BlockLayout, blockGlsl, structGlsl } from './std140.ts';
import { unrolledObjects } from './unrolled-objects.ts';
import { varyingRows } from './varying-rows.ts';

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
}

/** The vertex and fragment shader of a scene with these requirements. */
export function generateShader(required: Requirements, { varyings = 0 }: ShaderOptions = {}): ShaderSource {
  const { scene, view } = layoutBlocks(required);
  const indexed = required.features.includes('indexed');
  const rows = (scene.size + view.size) / 16;
  const throughVaryings = !indexed && rows <= varyings;
  const transport = throughVaryings ? varyingRows(scene, view) : undefined;
  const generated = {
    'generated/blocks.glsl': transport
      ? [scene, view].map(structGlsl).join('') + transport.fragment
      : blockGlsl(scene) + blockGlsl(view),
    'generated/eye.glsl': `Eye loadEye() {\n  return ${view.entries.map((entry) => transport?.construct(view, entry, 0) ?? entry.name)};\n}\n`,
    'generated/limits.glsl': `const int BOUNCES = ${required.bounces};\n`,
    'generated/objects.glsl': indexed ? indexedObjects(required) : unrolledObjects(required, scene, transport),
  };
  const assemble = (root: string) =>
    assembleGlsl(root, { files: { ...glslFiles, ...generated }, defined: definedNames(required), known: KNOWN_NAMES });
  const fragment = assemble('trace.frag.glsl');
  const vertex = transport?.vertex ?? assemble('fullscreen.vert.glsl').text;
  return { vertex, fragment: fragment.text, lines: fragment.lines, sceneBlock: scene, viewBlock: view };
}

/** `specularTint` as it is asked for in GLSL: `SPECULAR_TINT`. */
const glslName = (feature: string): string => feature.replace(/[A-Z]/g, '_$&').toUpperCase();

const countNames = { point: 'POINT_LIGHTS', directional: 'DIRECTIONAL_LIGHTS' } as const;
const shapeName = (kind: string): string => `${kind.toUpperCase()}S`;

const KNOWN_NAMES: ReadonlySet<string> = new Set([
  ...features.map(glslName),
  ...shapeKinds.map(shapeName),
  ...Object.values(countNames),
  'LIGHTS',
]);

function definedNames({ features: present, shapes, lights }: Requirements): ReadonlySet<string> {
  const lit = Object.entries(countNames).filter(([kind]) => lights[kind as keyof typeof lights] > 0);
  return new Set([
    ...present.map(glslName),
    ...shapeKinds.filter((kind) => shapes[kind] > 0).map(shapeName),
    ...lit.map(([, name]) => name),
    ...(lit.length > 0 ? ['LIGHTS'] : []),
  ]);
}
