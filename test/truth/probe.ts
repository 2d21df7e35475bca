/**
 * Asks the GPU: the generated shader's own functions, fed by the real packing, with a main function that draws the answer
 * to one ray into one pixel.
 */
import '@ray-scene/core/parts';
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
import { Program } from '../../packages/ray-scene/src/program.ts';
import type { RenderDevice } from '../../packages/ray-scene/src/render-device.ts';
import probe from './probe.frag.glsl';
import { createTarget, UniformBuffers } from './probe-target.ts';
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
  readonly #buffers: UniformBuffers;

  /** @throws {Error} where there are no f32 targets. */
  constructor(device: RenderDevice) {
    if (device.precision !== 'float') throw new Error('answers are drawn into 32-bit floats, which this GPU has not');
    this.#device = device;
    this.#buffers = new UniformBuffers(device.gl);
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
    const target = createTarget(gl, ROW, Math.ceil(problems.length / ROW));
    const scales = problems.map((problem, i) => {
      gl.viewport(i % ROW, Math.floor(i / ROW), 1, 1);
      return this.#drawOne(problem, passing);
    });
    const pixels = target.read();
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
    this.#buffers.write(packScene(scene, required, shader.sceneBlock), shader.viewBlock.size);
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
      const shader = generateShader(required, { varyings, main: mainOf(problem, required) });
      prepared = { shader, program: new Program(this.#device.gl, shader) };
      this.#programs.set(key, prepared);
    }
    return prepared;
  }
}

const isFromCamera = ({ camera, origin }: Problem): boolean => camera.every((x, i) => x === origin[i]);

function mainOf(problem: Problem, { features, shapes }: Requirements): string {
  const objects = Object.values(shapes).reduce((sum, count) => sum + count, 0);
  // By number, or of each object whether what is left comes after it.
  const left = features.includes('indexed') ? ', own > 0.5 ? 0 : -1' : ', 1.0 - own'.repeat(objects);
  const own = `Hit(MISS${left})`;
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
