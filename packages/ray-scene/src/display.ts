/** The last step to a picture: the mean of the samples, exposed, tone mapped and encoded. */
import { assembleGlsl, glslFiles, type RenderSettings } from '@ray-scene/core';
import { type Accumulation, accumulationFiles } from './accumulation.ts';
import type { Program, ProgramSource } from './program.ts';
import type { ProgramCache } from './program-cache.ts';

type ToneMapping = RenderSettings['toneMapping'];

const featureOf = { neutral: 'TONE_MAPPING_NEUTRAL', none: undefined } as const satisfies {
  [T in ToneMapping]: string | undefined;
};

/** The largest f32: exposures beyond it would be infinite on the GPU. */
const LARGEST_FLOAT = (2 - 2 ** -23) * 2 ** 127;

export class Display {
  readonly #gl: WebGL2RenderingContext;
  readonly #programs: ProgramCache;
  readonly #key: string;
  readonly #program: Program;
  readonly toneMapping: ToneMapping;

  constructor(gl: WebGL2RenderingContext, programs: ProgramCache, toneMapping: ToneMapping) {
    this.#gl = gl;
    this.#programs = programs;
    this.toneMapping = toneMapping;
    this.#key = `display ${toneMapping}`;
    this.#program = programs.acquire(this.#key, displaySource(toneMapping));
  }

  /** Draws the accumulated picture into the bound framebuffer. */
  draw(accumulation: Accumulation, exposure: number): void {
    const gl = this.#gl;
    this.#program.use();
    accumulation.bindTextures(this.#program);
    gl.uniform1f(this.#program.uniform('exposure'), Math.min(exposure, LARGEST_FLOAT));
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  dispose(): void {
    this.#programs.release(this.#key, this.#program);
  }
}

function displaySource(toneMapping: ToneMapping): ProgramSource {
  const feature = featureOf[toneMapping];
  const sources = {
    files: { ...glslFiles, ...accumulationFiles },
    defined: new Set(feature ? [feature] : []),
  };
  const { text, lines } = assembleGlsl('display.frag.glsl', sources);
  return { vertex: assembleGlsl('fullscreen.vert.glsl', sources).text, fragment: text, lines };
}
