/** Asks the shaders' functions of lights, fed by the real packing. */
import '@ray-scene/core/parts';
import { assembleGlsl, type Feature, glslFiles, type Vec3 } from '@ray-scene/core';
import {
  ABSENT_EMITTER,
  emitterEntries,
  emitterFeatures,
  packChoice,
  packEmitter,
} from '../../packages/core/src/emitter-record.ts';
import { emittersGlsl } from '../../packages/core/src/emitter-shader.ts';
import { type Frame, toFrame } from '../../packages/core/src/frame.ts';
import { moreParts } from '../../packages/core/src/parts.ts';
import { pathFiles } from '../../packages/core/src/path-files.ts';
import type { Lighting } from '../../packages/core/src/reference/light/emitters.ts';
import { type BlockLayout, blockGlsl, layoutBlock, writeStruct } from '../../packages/core/src/std140.ts';
import { Program } from '../../packages/ray-scene/src/program.ts';
import type { RenderDevice } from '../../packages/ray-scene/src/render-device.ts';
import main from './emitter.frag.glsl';
import { createTarget, UniformBuffers } from './probe-target.ts';

/** What is asked; lengths and places are those of the frame. */
export interface LightQuestion {
  readonly p: Vec3;
  readonly which: number;
  readonly u: readonly [number, number];
  readonly own: number;
  /** Of a ray that met an emitter. */
  readonly met: { readonly emitter: number; readonly direction: Vec3; readonly t: number; readonly cosine: number };
}

export interface LightAnswer {
  readonly direction: Vec3;
  readonly distance: number;
  readonly radiance: Vec3;
  readonly pdf: number;
  readonly delta: boolean;
  readonly object: number;
  readonly metPdf: number;
  readonly metRadiance: Vec3;
}

export class EmitterProbe {
  readonly #gl: WebGL2RenderingContext;
  readonly #buffers: UniformBuffers;

  constructor({ gl }: RenderDevice) {
    this.#gl = gl;
    this.#buffers = new UniformBuffers(gl);
  }

  /** `more`: features beyond those of the emitters; `capacity`: places for emitters. */
  answer(
    lighting: Lighting,
    frame: Frame,
    questions: readonly LightQuestion[],
    { more = [], capacity = lighting.emitters.length }: { more?: readonly Feature[]; capacity?: number } = {},
  ): readonly LightAnswer[] {
    const gl = this.#gl;
    const present = [
      ...emitterFeatures(lighting.emitters),
      ...(capacity > 1 ? (['severalEmitters'] as const) : []),
      ...more,
    ];
    const block = layoutBlock('Scene', emitterEntries(present, capacity));
    const program = new Program(gl, sourceOf(present, block));
    program.use();
    this.#buffers.write(packed(lighting, frame, block, capacity), 0);
    const asked = askedTexture(gl, questions);
    gl.uniform1i(program.uniform('asked'), 0);
    const images = imageTextures(gl, lighting, program);
    const target = createTarget(gl, questions.length, 4);
    [asked, ...images].forEach((texture, unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture);
    });
    gl.activeTexture(gl.TEXTURE0);
    gl.viewport(0, 0, questions.length, 4);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    const pixels = target.read();
    target.dispose();
    for (const texture of [asked, ...images]) gl.deleteTexture(texture);
    program.dispose();
    return questions.map((_, i) => answerAt(pixels, questions.length, i));
  }
}

function sourceOf(present: readonly Feature[], block: BlockLayout) {
  const name = (feature: string): string => feature.replace(/[A-Z]/g, '_$&').toUpperCase();
  const files = {
    ...glslFiles,
    ...moreParts().files,
    ...pathFiles,
    'main.glsl': main,
    'generated/scene.glsl': blockGlsl(block),
    'generated/emitters.glsl': emittersGlsl(present),
  };
  const defined = new Set(present.map(name));
  const { text, lines } = assembleGlsl('main.glsl', { files, defined });
  const vertex = assembleGlsl('fullscreen.vert.glsl', { files, defined }).text;
  return { vertex, fragment: text, lines };
}

function packed({ emitters, table }: Lighting, frame: Frame, block: BlockLayout, capacity: number): ArrayBuffer {
  const bytes = new ArrayBuffer(block.size);
  const view = new DataView(bytes);
  for (const entry of block.entries) {
    if (entry.name === 'choice') writeStruct(view, entry, 0, packChoice(emitters));
    else {
      for (let i = 0; i < capacity; i++) {
        writeStruct(view, entry, i, i < emitters.length ? packEmitter(emitters, table, i, frame) : ABSENT_EMITTER);
      }
    }
  }
  return bytes;
}

function askedTexture(gl: WebGL2RenderingContext, questions: readonly LightQuestion[]): WebGLTexture {
  const width = questions.length;
  const numbers = new Float32Array(4 * 4 * width);
  questions.forEach(({ p, which, u, own, met }, i) => {
    [[...p, which], [...u, own, met.emitter], [...met.direction, met.t], [met.cosine]].forEach((row, j) => {
      numbers.set(row, 4 * (j * width + i));
    });
  });
  return floatTexture(gl, width, 4, 4, numbers);
}

/** The image of the surroundings, if there is one, and what it is chosen from by; they are in the units 1 and 2. */
function imageTextures(gl: WebGL2RenderingContext, { emitters }: Lighting, program: Program): readonly WebGLTexture[] {
  const image = emitters.map((one) => (one.kind === 'image' ? one.image : undefined)).find((one) => one);
  if (!image) return [];
  gl.uniform1i(program.uniform('environmentTexels'), 1);
  gl.uniform1i(program.uniform('environmentChoices'), 2);
  return [
    floatTexture(gl, image.width, image.height, 4, image.texels),
    floatTexture(gl, image.width + 1, image.height, 2, image.choices),
  ];
}

function floatTexture(
  gl: WebGL2RenderingContext,
  width: number,
  height: number,
  channels: 2 | 4,
  numbers: Float32Array,
): WebGLTexture {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, channels === 4 ? gl.RGBA32F : gl.RG32F, width, height);
  gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, channels === 4 ? gl.RGBA : gl.RG, gl.FLOAT, numbers);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  return texture;
}

function answerAt(pixels: Float32Array, width: number, i: number): LightAnswer {
  const [first, second, third, fourth] = [0, 1, 2, 3].map((row) => {
    const at = 4 * (row * width + i);
    return [...pixels.subarray(at, at + 4)] as unknown as readonly [number, number, number, number];
  }) as unknown as readonly (readonly [number, number, number, number])[] & { length: 4 };
  const rgb = ([r, g, b]: readonly number[]): Vec3 => [r as number, g as number, b as number];
  return {
    direction: rgb(first as readonly number[]),
    distance: first?.[3] as number,
    radiance: rgb(second as readonly number[]),
    pdf: second?.[3] as number,
    delta: third?.[0] === 1,
    object: third?.[1] as number,
    metPdf: fourth?.[0] as number,
    metRadiance: rgb((fourth as readonly number[]).slice(1)),
  };
}

/** A point that f32 has, in the frame, and what it is in the scene. */
export function roundedPoint(frame: Frame, p: Vec3): { readonly inFrame: Vec3; readonly inScene: Vec3 } {
  const inFrame = toFrame(frame, p).map(Math.fround) as unknown as Vec3;
  return { inFrame, inScene: inFrame.map((x, i) => x / frame.scale + (frame.origin[i] as number)) as unknown as Vec3 };
}
