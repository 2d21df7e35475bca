/** The images of a scene on the GPU: of its surroundings, with the table by which directions to it are drawn, and on surfaces. */
import { type EnvironmentImage, IMAGE_ROW, imageAtlas, imageTable, type ResolvedScene } from '@ray-scene/core';
import { FloatTarget } from './float-target.ts';
import type { Program } from './program.ts';

export { imageTableByRows } from '@ray-scene/core';

export class SceneTextures {
  /** Those of a scene: the present ones, if they hold its images. Others are freed. */
  static of(
    scene: ResolvedScene,
    gl: WebGL2RenderingContext,
    present: SceneTextures | undefined,
  ): SceneTextures | undefined {
    const { environment } = scene;
    const surroundings = environment?.kind === 'image' ? environment.image : undefined;
    const images = [surroundings, ...imageAtlas(scene).places.keys()];
    if (present) {
      if (present.#holds(images)) return present;
      present.dispose();
    }
    return images.some((image) => image) ? new SceneTextures(gl, images) : undefined;
  }

  readonly #gl: WebGL2RenderingContext;
  /** That of the surroundings, if there is one, then those on surfaces. */
  readonly #images: readonly (EnvironmentImage | undefined)[];
  /** By the names of their uniforms. */
  readonly #textures: readonly (readonly [name: string, texture: WebGLTexture])[];

  /** @throws {Error} when an image is larger than the GPU takes. */
  private constructor(gl: WebGL2RenderingContext, images: readonly (EnvironmentImage | undefined)[]) {
    const [surroundings, ...others] = images;
    this.#gl = gl;
    this.#images = images;
    this.#textures = [
      ...(surroundings ? surroundingsTextures(gl, surroundings) : []),
      ...(others.length > 0 ? [['imageTexels', atlasTexture(gl, others as EnvironmentImage[])] as const] : []),
    ];
  }

  /** Gives them to the program in use. */
  bind(program: Program): void {
    const gl = this.#gl;
    for (const [unit, [name, texture]] of this.#textures.entries()) {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.uniform1i(program.uniform(name), unit);
    }
    // Whoever binds a texture to change it is used to this one.
    gl.activeTexture(gl.TEXTURE0);
  }

  dispose(): void {
    for (const [, texture] of this.#textures) this.#gl.deleteTexture(texture);
  }

  #holds(images: readonly (EnvironmentImage | undefined)[]): boolean {
    return images.length === this.#images.length && images.every((image, i) => image === this.#images[i]);
  }
}

function surroundingsTextures(gl: WebGL2RenderingContext, image: EnvironmentImage) {
  const { width, height, texels, choices } = imageTable(image);
  const most: number = gl.getParameter(gl.MAX_TEXTURE_SIZE);
  if (Math.max(width + 1, height) > most) {
    throw new Error(
      `The image of the surroundings has ${width} × ${height} pixels, and the GPU takes up to ${most - 1}`,
    );
  }
  return [
    ['environmentTexels', floatTexture(gl, [gl.RGBA32F, gl.RGBA], width, height, texels)],
    ['environmentChoices', floatTexture(gl, [gl.RG32F, gl.RG], width + 1, height, choices)],
  ] as const;
}

/** The texels of all images one after the other, in as many rows as that takes. */
function atlasTexture(gl: WebGL2RenderingContext, images: readonly EnvironmentImage[]): WebGLTexture {
  const texels = images.reduce((sum, { width, height }) => sum + width * height, 0);
  const rows = Math.ceil(texels / IMAGE_ROW);
  const most: number = gl.getParameter(gl.MAX_TEXTURE_SIZE);
  if (rows > most) {
    throw new Error(`The images on surfaces have ${texels} pixels, and the GPU takes up to ${most * IMAGE_ROW}`);
  }
  const numbers = new Float32Array(3 * IMAGE_ROW * rows);
  let at = 0;
  for (const { data } of images) {
    numbers.set(data, at);
    at += data.length;
  }
  return floatTexture(gl, [gl.RGB32F, gl.RGB], IMAGE_ROW, rows, numbers);
}

/** A texture that texels are fetched from, one by one: floats are not filtered everywhere. */
function floatTexture(
  gl: WebGL2RenderingContext,
  [inside, format]: readonly [inside: number, format: number],
  width: number,
  height: number,
  numbers: Float32Array,
): WebGLTexture {
  const texture = gl.createTexture();
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, inside, width, height);
  gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, format, gl.FLOAT, numbers);
  FloatTarget.useNearest(gl);
  return texture;
}
