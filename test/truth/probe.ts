/**
 * Asks the GPU: the generated shader's own functions, fed by the real packing, with a main function that draws the answer
 * to one ray into one pixel.
 */
import {
  generateShader,
  mergeRequirements,
  packScene,
  type Requirements,
  type ResolvedScene,
  requirements,
  requirementsKey,
  type ShaderSource,
} from '@ray-scene/core';
import { toFrame } from '../../packages/core/src/frame.ts';
import { packingFrame } from '../../packages/core/src/pack-scene.ts';
import { blockBindings, Program } from '../../packages/ray-scene/src/program.ts';
import type { RenderDevice } from '../../packages/ray-scene/src/render-device.ts';
import probe from './probe.frag.glsl';
import type { Answer, Problem } from './problem.ts';
import { sceneOf } from './reference-side.ts';

/** Pixels in a row of the target. */
const ROW = 512;
/** What the shader calls a miss. */
const MISS = Math.fround(1e18);

interface Prepared {
  readonly shader: ShaderSource;
  readonly program: Program;
}

/** How a program reads the scene: as a uniform block, or as varyings. */
type Passing = { readonly varyings: number };

export class Probe {
  readonly #device: RenderDevice;
  readonly #programs = new Map<string, Prepared>();
  readonly #scene: WebGLBuffer;
  readonly #view: WebGLBuffer;

  /** @throws {Error} where there are no f32 targets. */
  constructor(device: RenderDevice) {
    if (device.precision !== 'float') throw new Error('answers are drawn into 32-bit floats, which this GPU has not');
    this.#device = device;
    this.#scene = device.gl.createBuffer();
    this.#view = device.gl.createBuffer();
  }

  /** The answers to each problem, one for each way in which a program on this device may read the scene. */
  answer(problems: readonly Problem[]): readonly (readonly Answer[])[] {
    const { varyings = 0 } = this.#device.shaderOptions;
    const ways: readonly Passing[] = varyings > 0 ? [{ varyings }, { varyings: 0 }] : [{ varyings: 0 }];
    const answers = ways.map((way) => this.#draw(problems, way));
    return problems.map((_, i) => answers.map((ofWay) => ofWay[i] as Answer));
  }

  #draw(problems: readonly Problem[], passing: Passing): readonly Answer[] {
    const { gl } = this.#device;
    const height = Math.ceil(problems.length / ROW);
    const target = createTarget(gl, ROW, height);
    const scales = problems.map((problem, i) => {
      gl.viewport(i % ROW, Math.floor(i / ROW), 1, 1);
      return this.#drawOne(problem, passing);
    });
    const pixels = new Float32Array(4 * ROW * height);
    gl.readPixels(0, 0, ROW, height, gl.RGBA, gl.FLOAT, pixels);
    target.dispose();
    return scales.map((scale, i) => {
      const [t, x, y, z] = pixels.subarray(4 * i, 4 * i + 4) as unknown as readonly [number, number, number, number];
      return { t: t >= MISS ? Number.POSITIVE_INFINITY : t / scale, normal: [x, y, z] };
    });
  }

  /** Returns the scale of the frame that the distance is in. */
  #drawOne(problem: Problem, passing: Passing): number {
    const { gl } = this.#device;
    const scene = sceneOf(problem);
    const required = requirementsOf(scene, problem);
    const { program, shader } = this.#prepare(required, problem, passing);
    const frame = packingFrame(scene);
    program.use();
    write(gl, this.#scene, blockBindings.Scene, packScene(scene, required, shader.sceneBlock));
    // Only the window is drawn from it, of which a pixel sees nothing.
    write(gl, this.#view, blockBindings.View, new ArrayBuffer(shader.viewBlock.size));
    gl.uniform3fv(program.uniform('origin'), [...toFrame(frame, problem.origin)]);
    gl.uniform3fv(program.uniform('direction'), [...problem.direction]);
    gl.uniform1f(program.uniform('own'), problem.own ? 1 : 0);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    return frame.scale;
  }

  #prepare(required: Requirements, problem: Problem, { varyings }: Passing): Prepared {
    const key = JSON.stringify([requirementsKey(required), isFromCamera(problem), varyings]);
    let prepared = this.#programs.get(key);
    if (!prepared) {
      const shader = generateShader(required, { varyings, main: mainOf(problem) });
      prepared = { shader, program: new Program(this.#device.gl, shader) };
      this.#programs.set(key, prepared);
    }
    return prepared;
  }
}

const isFromCamera = ({ camera, origin }: Problem): boolean => camera.every((x, i) => x === origin[i]);

function mainOf(problem: Problem): string {
  // Of each object, whether what is left comes after it.
  const own = `Hit(MISS${', 1.0 - own'.repeat(problem.objects.length)})`;
  const start = isFromCamera(problem) ? 'fromCamera(scene)' : `fromPoint(scene, origin, ${own})`;
  return probe.replace('= START', `= ${start}`).replace('= OWN', `= ${own}`);
}

/**
 * What the scene requires. Rays that do not start at the camera, or start on a surface, may be on any side of things, as
 * in a scene whose rays pass through surfaces.
 */
function requirementsOf(scene: ResolvedScene, problem: Problem): Requirements {
  const required = requirements(scene, { bounces: 1 });
  if (isFromCamera(problem) && !problem.own) return required;
  const { needs } = required;
  return mergeRequirements(required, {
    ...required,
    needs: { ...needs, features: new Set([...needs.features, 'through']) },
  });
}

function write(gl: WebGL2RenderingContext, buffer: WebGLBuffer, binding: number, bytes: ArrayBuffer): void {
  if (bytes.byteLength === 0) return;
  gl.bindBuffer(gl.UNIFORM_BUFFER, buffer);
  gl.bufferData(gl.UNIFORM_BUFFER, bytes, gl.DYNAMIC_DRAW);
  gl.bindBufferBase(gl.UNIFORM_BUFFER, binding, buffer);
}

/** A float target that is drawn into from now on. */
export function createTarget(gl: WebGL2RenderingContext, width: number, height: number): { dispose(): void } {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, width, height);
  const framebuffer = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  gl.disable(gl.BLEND);
  return {
    dispose() {
      gl.deleteFramebuffer(framebuffer);
      gl.deleteTexture(texture);
    },
  };
}
