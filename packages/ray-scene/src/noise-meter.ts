/** How noisy a picture is, measured on the GPU and read back without waiting for it. Loaded when there is something to measure. */
import { assembleGlsl, glslFiles } from '@ray-scene/core';
import ramp from '../../../shaders/display/ramp.glsl';
import blockErrorFragment from '../../../shaders/noise/block-error.frag.glsl';
import cellErrorFragment from '../../../shaders/noise/cell-error.frag.glsl';
import relativeVariance from '../../../shaders/noise/relative-variance.glsl';
import { type Accumulation, accumulationFiles } from './accumulation.ts';
import { CELL_BITS } from './cells.ts';
import { FloatTarget } from './float-target.ts';
import type { Program, ProgramSource } from './program.ts';
import type { ProgramCache } from './program-cache.ts';
import type { Precision } from './render-device.ts';

/** What is known of the noise of a picture. */
export interface Noise {
  /** Samples per pixel, at least, when it was measured. */
  readonly samples: number;
  /** Samples of all pixels together, at that time, and how many the pixels of each cell had. */
  readonly rays: number;
  readonly counts: Uint32Array;
  /** The factor on the radiance. */
  readonly exposure: number;
  /** Root of the mean, over pixels and channels, of variance / (mean² + 0.01). */
  readonly error: number;
  /** The same of each cell, row by row from the bottom. */
  readonly cells: Float32Array;
}

/** Side of a block of pixels, the first step from pixels to cells, as a power of two. */
const BLOCK_BITS = 2;

const files = {
  ...glslFiles,
  ...accumulationFiles,
  'generated/blocks.glsl': `const int BLOCK = ${1 << BLOCK_BITS};\nconst int BLOCKS = ${1 << (CELL_BITS - BLOCK_BITS)};\n`,
  'display/ramp.glsl': ramp,
  'noise/relative-variance.glsl': relativeVariance,
  'noise/block-error.frag.glsl': blockErrorFragment,
  'noise/cell-error.frag.glsl': cellErrorFragment,
};

/** A program over the whole viewport, of one of these files. */
export function noiseSource(root: string, more: { readonly [file: string]: string } = {}): ProgramSource {
  const sources = { files: { ...files, ...more }, defined: new Set<string>() };
  const { text, lines } = assembleGlsl(root, sources);
  return { vertex: assembleGlsl('fullscreen.vert.glsl', sources).text, fragment: text, lines };
}

const BLOCK_KEY = 'noise of blocks';
const CELL_KEY = 'noise of cells';

export class NoiseMeter {
  readonly width: number;
  readonly height: number;
  /** The errors of blocks of pixels, as `block-error.frag.glsl` writes them. */
  readonly blocks: FloatTarget;
  readonly #gl: WebGL2RenderingContext;
  readonly #programs: ProgramCache;
  readonly #cells: FloatTarget;
  readonly #buffer: WebGLBuffer;
  readonly #blockProgram: Program;
  readonly #cellProgram: Program;

  /** @throws {Error} when its targets do not fit into the graphics memory. */
  constructor(gl: WebGL2RenderingContext, programs: ProgramCache, precision: Precision, { width, height }: Size) {
    this.#gl = gl;
    this.#programs = programs;
    this.width = width;
    this.height = height;
    this.blocks = new FloatTarget(gl, precision, shifted(width, BLOCK_BITS), shifted(height, BLOCK_BITS));
    this.#cells = new FloatTarget(gl, precision, shifted(width, CELL_BITS), shifted(height, CELL_BITS));
    this.#buffer = gl.createBuffer();
    this.#blockProgram = programs.acquire(BLOCK_KEY, noiseSource('noise/block-error.frag.glsl'));
    this.#cellProgram = programs.acquire(CELL_KEY, noiseSource('noise/cell-error.frag.glsl'));
    if (this.blocks.isComplete && this.#cells.isComplete) return;
    this.dispose();
    throw new Error('The noise of the picture cannot be measured: the graphics memory is full');
  }

  /**
   * Measures a picture of at least two samples. What it returns gives the result, when the GPU has passed a fence and
   * before another measurement begins.
   */
  begin(accumulation: Accumulation, exposure: number): () => Noise {
    const gl = this.#gl;
    gl.disable(gl.BLEND);
    this.#blockProgram.use();
    accumulation.bindTextures(this.#blockProgram);
    gl.uniform1f(this.#blockProgram.uniform('exposure'), exposure);
    this.blocks.bind();
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    this.#cellProgram.use();
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.blocks.texture);
    this.#cells.bind();
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, this.#buffer);
    // Allocated anew: what nobody has read, as of a scene that has changed since, is in no one's way.
    gl.bufferData(gl.PIXEL_PACK_BUFFER, 16 * this.#cells.width * this.#cells.height, gl.STREAM_READ);
    gl.readPixels(0, 0, this.#cells.width, this.#cells.height, gl.RGBA, gl.FLOAT, 0);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    const { samples, cells } = accumulation;
    const measured = { samples, exposure, rays: cells.rays, counts: cells.counts.slice() };
    return () => ({ ...measured, ...this.#read() });
  }

  dispose(): void {
    this.#programs.release(BLOCK_KEY, this.#blockProgram);
    this.#programs.release(CELL_KEY, this.#cellProgram);
    this.blocks.dispose();
    this.#cells.dispose();
    this.#gl.deleteBuffer(this.#buffer);
  }

  #read(): Pick<Noise, 'error' | 'cells'> {
    const gl = this.#gl;
    const texels = new Float32Array(4 * this.#cells.width * this.#cells.height);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, this.#buffer);
    gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, texels);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    const cells = texels.filter((_, i) => i % 4 === 0);
    let sum = 0;
    let shares = 0;
    for (const [i, error] of cells.entries()) {
      const share = texels[4 * i + 1] as number;
      sum += share * error ** 2;
      shares += share;
    }
    return { error: Math.sqrt(sum / shares), cells };
  }
}

interface Size {
  readonly width: number;
  readonly height: number;
}

const shifted = (length: number, bits: number): number => Math.ceil(length / 2 ** bits);
