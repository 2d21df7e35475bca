/** Asks the shaders' functions of light, by the same way as probe.ts. */
import {
  generateShader,
  packScene,
  parseScene,
  requirements,
  requirementsKey,
  resolveScene,
  type ShaderSource,
} from '@ray-scene/core';
import { Program } from '../../packages/ray-scene/src/program.ts';
import type { RenderDevice } from '../../packages/ray-scene/src/render-device.ts';
import main from './brdf.frag.glsl';
import { type BrdfQuestion, calls } from './brdf-tables.ts';
import { createTarget, UniformBuffers } from './probe-target.ts';

const ROW = 512;

export class BrdfProbe {
  readonly #gl: WebGL2RenderingContext;
  readonly #programs = new Map<string, { readonly shader: ShaderSource; readonly program: Program }>();
  readonly #buffers: UniformBuffers;

  constructor({ gl }: RenderDevice) {
    this.#gl = gl;
    this.#buffers = new UniformBuffers(gl);
  }

  /** Three channels for each question. */
  answer(questions: readonly BrdfQuestion[]): readonly (readonly number[])[] {
    const gl = this.#gl;
    const target = createTarget(gl, ROW, Math.ceil(questions.length / ROW));
    questions.forEach((question, i) => {
      gl.viewport(i % ROW, Math.floor(i / ROW), 1, 1);
      this.#draw(question);
    });
    const pixels = target.read();
    target.dispose();
    return questions.map(({ factor }, i) => [...pixels.subarray(4 * i, 4 * i + 3)].map((value) => value * factor));
  }

  #draw({ scene: objects, camera, call, numbers, vector }: BrdfQuestion): void {
    const gl = this.#gl;
    const scene = resolveScene(parseScene(objects), 1, { position: camera, target: [0, 0, 0], up: [0, 1, 0], fov: 45 });
    const required = requirements(scene, { bounces: 1 });
    const key = JSON.stringify([requirementsKey(required), call]);
    let prepared = this.#programs.get(key);
    if (!prepared) {
      const shader = generateShader(required, { main: main.replace('  CALL', `  ${calls[call]}`) });
      prepared = { shader, program: new Program(gl, shader) };
      this.#programs.set(key, prepared);
    }
    const { program, shader } = prepared;
    program.use();
    this.#buffers.write(packScene(scene, required, shader.sceneBlock), shader.viewBlock.size);
    gl.uniform3fv(program.uniform('numbers'), [...numbers]);
    gl.uniform3fv(program.uniform('vector'), [...vector]);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}
