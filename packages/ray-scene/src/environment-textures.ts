/** An image of the surroundings on the GPU, and the table by which directions to it are drawn. */
import { type EnvironmentImage, imageTable, type ResolvedScene } from '@ray-scene/core';
import { FloatTarget } from './float-target.ts';
import type { Program } from './program.ts';

export class EnvironmentTextures {
  /** Those of a scene: the present ones, if they hold its image. Others are freed. */
  static of(
    { environment }: Pick<ResolvedScene, 'environment'>,
    gl: WebGL2RenderingContext,
    present: EnvironmentTextures | undefined,
  ): EnvironmentTextures | undefined {
    const image = environment?.kind === 'image' ? environment.image : undefined;
    if (present && present.#image === image) return present;
    present?.dispose();
    return image && new EnvironmentTextures(gl, image);
  }

  readonly #gl: WebGL2RenderingContext;
  readonly #image: EnvironmentImage;
  /** By the names of their uniforms. */
  readonly #textures: { readonly [name: string]: WebGLTexture };

  /** @throws {Error} when the image is larger than the GPU takes. */
  constructor(gl: WebGL2RenderingContext, image: EnvironmentImage) {
    const { width, height, texels, choices } = imageTable(image);
    const most: number = gl.getParameter(gl.MAX_TEXTURE_SIZE);
    if (Math.max(width + 1, height) > most) {
      throw new Error(
        `The image of the surroundings has ${width} × ${height} pixels, and the GPU takes up to ${most - 1}`,
      );
    }
    this.#gl = gl;
    this.#image = image;
    this.#textures = {
      environmentTexels: floatTexture(gl, 4, width, height, texels),
      environmentChoices: floatTexture(gl, 2, width + 1, height, choices),
    };
  }

  /** Gives them to the program in use. */
  bind(program: Program): void {
    const gl = this.#gl;
    for (const [unit, [name, texture]] of Object.entries(this.#textures).entries()) {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.uniform1i(program.uniform(name), unit);
    }
    // Whoever binds a texture to change it is used to this one.
    gl.activeTexture(gl.TEXTURE0);
  }

  dispose(): void {
    for (const texture of Object.values(this.#textures)) this.#gl.deleteTexture(texture);
  }
}

/** A texture that texels are fetched from, one by one: floats are not filtered everywhere. */
function floatTexture(
  gl: WebGL2RenderingContext,
  channels: 2 | 4,
  width: number,
  height: number,
  numbers: Float32Array,
): WebGLTexture {
  const [inside, format] = channels === 4 ? [gl.RGBA32F, gl.RGBA] : [gl.RG32F, gl.RG];
  const texture = gl.createTexture();
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, inside, width, height);
  gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, format, gl.FLOAT, numbers);
  FloatTarget.useNearest(gl);
  return texture;
}
