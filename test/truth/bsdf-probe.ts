/** Asks the shaders' functions that scatter paths: the very files that draw, with a main function that calls them. */
import { Program } from '../../packages/ray-scene/src/program.ts';
import type { RenderDevice } from '../../packages/ray-scene/src/render-device.ts';
import { definedFor, materials } from '../bsdf/cases.ts';
import { setMaterial, shaderSource } from '../bsdf/probe.ts';
import main from './bsdf.frag.glsl';
import { type BsdfQuestion, bsdfCalls } from './bsdf-tables.ts';
import { createTarget } from './probe-target.ts';

const ROW = 512;

export class BsdfProbe {
  readonly #gl: WebGL2RenderingContext;
  readonly #programs = new Map<string, Program>();

  constructor({ gl }: RenderDevice) {
    this.#gl = gl;
  }

  /** Three channels for each question. */
  answer(questions: readonly BsdfQuestion[]): readonly (readonly number[])[] {
    const target = createTarget(this.#gl, ROW, Math.ceil(questions.length / ROW));
    questions.forEach((question, i) => {
      this.#gl.viewport(i % ROW, Math.floor(i / ROW), 1, 1);
      this.#draw(question);
    });
    const pixels = target.read();
    target.dispose();
    return questions.map(({ factor }, i) => [...pixels.subarray(4 * i, 4 * i + 3)].map((value) => value * factor));
  }

  #draw({ bsdf, call, first, second }: BsdfQuestion): void {
    const gl = this.#gl;
    const program = this.#program(call);
    program.use();
    setMaterial(gl, program, bsdf);
    gl.uniform3fv(program.uniform('first'), [...first]);
    gl.uniform3fv(program.uniform('second'), [...second]);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  /** In the shader that serves materials of all sorts. */
  #program(call: BsdfQuestion['call']): Program {
    const known = this.#programs.get(call);
    if (known) return known;
    const source = shaderSource(main.replace('CALL;', `${bsdfCalls[call]};`), definedFor(Object.values(materials)));
    const program = new Program(this.#gl, source);
    this.#programs.set(call, program);
    return program;
  }
}
