/** A scene on the GPU: the program that its requirements make, and the uniform blocks that the program reads. */
import {
  type BlockLayout,
  type CameraFrame,
  type Frame,
  generateShader,
  packingFrame,
  packScene,
  packView,
  type Requirements,
  type ResolvedScene,
  requirementsKey,
  type SampleNumber,
  type ShaderOptions,
} from '@ray-scene/core';
import { blockBindings, type Program } from './program.ts';
import type { ProgramCache } from './program-cache.ts';
import type { SceneTextures } from './scene-textures.ts';

export class Tracer {
  readonly key: string;
  readonly #required: Requirements;
  readonly #gl: WebGL2RenderingContext;
  readonly #programs: ProgramCache;
  readonly #program: Program;
  readonly #scene: UniformBlock;
  readonly #view: UniformBlock;
  #textures: SceneTextures | undefined;
  #frame: Frame = { origin: [0, 0, 0], scale: 1 };

  /** @throws {Error} when the scene has more in it than the GPU takes. */
  constructor(gl: WebGL2RenderingContext, programs: ProgramCache, required: Requirements, options: ShaderOptions) {
    const shader = generateShader(required, options);
    this.key = requirementsKey(required);
    this.#required = required;
    this.#gl = gl;
    this.#programs = programs;
    this.#scene = new UniformBlock(gl, shader.sceneBlock, blockBindings.Scene);
    this.#view = new UniformBlock(gl, shader.viewBlock, blockBindings.View);
    this.#program = programs.acquire(this.key, shader);
  }

  /** Whether the driver is done with the program, as far as it tells. */
  get isReady(): boolean {
    return this.#program.isReady;
  }

  /** Waits until the program is compiled. @throws {ShaderError} when it does not compile. */
  compile(): void {
    this.#program.use();
  }

  /**
   * Takes the numbers of a scene, seen from its camera. It must require no more than this tracer has.
   * @param Textures needed where the scene has images.
   */
  setScene(scene: ResolvedScene, Textures?: typeof SceneTextures): void {
    this.#frame = packingFrame(scene);
    this.#scene.write(packScene(scene, this.#required, this.#scene.layout));
    this.#textures = Textures?.of(scene, this.#gl, this.#textures);
  }

  /** Draws one sample of every pixel into the bound framebuffer. */
  draw(view: CameraFrame, sample?: SampleNumber): void {
    this.use(view, sample);
    this.drawPixels();
  }

  /** Makes a sample what `drawPixels` draws, until another program is in use. */
  use(view: CameraFrame, sample?: SampleNumber): void {
    this.#program.use();
    this.#view.write(packView(view, this.#view.layout, this.#frame, sample));
    this.#scene.bind();
    this.#view.bind();
    this.#textures?.bind(this.#program);
  }

  /** Draws it, of every pixel that the scissor lets through: as often as there are tiles. */
  drawPixels(): void {
    this.#gl.drawArrays(this.#gl.TRIANGLES, 0, 3);
  }

  dispose(): void {
    this.#programs.release(this.key, this.#program);
    this.#scene.dispose();
    this.#view.dispose();
    this.#textures?.dispose();
  }
}

class UniformBlock {
  readonly layout: BlockLayout;
  readonly #gl: WebGL2RenderingContext;
  readonly #binding: number;
  readonly #buffer: WebGLBuffer;

  constructor(gl: WebGL2RenderingContext, layout: BlockLayout, binding: number) {
    const room: number = gl.getParameter(gl.MAX_UNIFORM_BLOCK_SIZE);
    if (layout.size > room) {
      throw new Error(
        `This scene takes ${layout.size} bytes, and the graphics card has room for ${room}: use fewer objects`,
      );
    }
    this.#gl = gl;
    this.layout = layout;
    this.#binding = binding;
    this.#buffer = gl.createBuffer();
  }

  write(bytes: ArrayBuffer): void {
    this.#gl.bindBuffer(this.#gl.UNIFORM_BUFFER, this.#buffer);
    // Allocated anew, so that no driver waits for the draw calls that read the old bytes.
    this.#gl.bufferData(this.#gl.UNIFORM_BUFFER, bytes, this.#gl.DYNAMIC_DRAW);
  }

  bind(): void {
    // GLSL has no empty block.
    if (this.layout.size > 0) this.#gl.bindBufferBase(this.#gl.UNIFORM_BUFFER, this.#binding, this.#buffer);
  }

  dispose(): void {
    this.#gl.deleteBuffer(this.#buffer);
  }
}
