/** Asks the shader's BSDF: the very files that draw, with a main function that answers a question in each pixel. */
import type { Vec3 } from '@ray-scene/core';
import { assembleGlsl } from '../../packages/core/src/assemble-glsl.ts';
import { glslFiles } from '../../packages/core/src/glsl-files.ts';
import { pathFiles } from '../../packages/core/src/path-files.ts';
import type { Bsdf, BsdfSample, BsdfValue } from '../../packages/core/src/reference/material/bsdf.ts';
import type { Program } from '../../packages/ray-scene/src/program.ts';
import { createTarget } from '../truth/probe-target.ts';
import material from './material.glsl';
import main from './probe.frag.glsl';
import type { Question } from './questions.ts';

export interface Answer {
  readonly sample: BsdfSample;
  readonly value: BsdfValue;
  readonly isMirrorOnly: boolean;
}

const WIDTH = 256;

const VERTEX = `#version 300 es
  void main() { gl_Position = vec4(4 * (gl_VertexID & 1) - 1, 2 * (gl_VertexID & 2) - 1, 0, 1); }`;

/** A program with this main file, and what it includes of the shaders when these names are defined. */
export function shaderSource(root: string, defined: ReadonlySet<string>) {
  const files = { ...glslFiles, ...pathFiles, 'probe/material.glsl': material, 'probe.frag.glsl': root };
  const { text, lines } = assembleGlsl('probe.frag.glsl', { files, defined });
  return { vertex: VERTEX, fragment: text, lines };
}

export const probeSource = (defined: ReadonlySet<string>) => shaderSource(main, defined);

/** What the program in use draws. */
export function drawnPixels(gl: WebGL2RenderingContext, width: number, height: number): Float32Array {
  const target = createTarget(gl, width, height);
  gl.viewport(0, 0, width, height);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
  const pixels = target.read();
  target.dispose();
  return pixels;
}

/** The answers to all questions about one material. */
export function askBsdf(
  gl: WebGL2RenderingContext,
  program: Program,
  bsdf: Bsdf,
  questions: readonly Question[],
): readonly Answer[] {
  const height = Math.ceil(questions.length / WIDTH);
  program.use();
  setMaterial(gl, program, bsdf);
  gl.uniform1i(program.uniform('questions'), 1);
  const texture = questionTexture(gl, questions, height);
  const [directions, weights, values] = [0, 1, 2].map((part) => {
    gl.uniform1i(program.uniform('part'), part);
    return drawnPixels(gl, WIDTH, height);
  }) as [Float32Array, Float32Array, Float32Array];
  gl.deleteTexture(texture);
  return questions.map((_, i) => {
    const [wi, pdf] = pixelOf(directions, i);
    const [weight, mirror] = pixelOf(weights, i);
    const [value, density] = pixelOf(values, i);
    return { sample: { wi, weight, pdf }, value: { value, pdf: density }, isMirrorOnly: mirror === 1 };
  });
}

/** Sets the uniforms of material.glsl. */
export function setMaterial(gl: WebGL2RenderingContext, program: Program, { thin, ...bsdf }: Bsdf): void {
  for (const [name, value] of Object.entries({ ...bsdf, thin: Number(thin) })) {
    if (typeof value === 'number') gl.uniform1f(program.uniform(name), value);
    else gl.uniform3fv(program.uniform(name), [...value]);
  }
}

function questionTexture(
  gl: WebGL2RenderingContext,
  questions: readonly Question[],
  height: number,
): WebGLTexture | null {
  const texels = new Float32Array(WIDTH * 3 * height * 4);
  questions.forEach(({ wo, wi, u, lobe }, i) => {
    const at = 4 * (3 * WIDTH * Math.floor(i / WIDTH) + (i % WIDTH));
    texels.set([...wo, lobe], at);
    texels.set([...wi, u[0]], at + 4 * WIDTH);
    texels.set([u[1], 0, 0, 0], at + 8 * WIDTH);
  });
  const texture = gl.createTexture();
  // The first unit is the target's.
  gl.activeTexture(gl.TEXTURE1);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  // Floats are not filtered everywhere.
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, WIDTH, 3 * height);
  gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, WIDTH, 3 * height, gl.RGBA, gl.FLOAT, texels);
  gl.activeTexture(gl.TEXTURE0);
  return texture;
}

const pixelOf = (pixels: Float32Array, i: number): readonly [Vec3, number] => {
  const [x, y, z, w] = pixels.subarray(4 * i, 4 * i + 4) as unknown as readonly [number, number, number, number];
  return [[x, y, z], w];
};
