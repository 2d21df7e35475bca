// Frames and circles of the shaders, which all directions are drawn with.
import { expect } from '@open-wc/testing';
import type { Vec3 } from '@ray-scene/core';
import { circle } from '../../packages/core/src/reference/circle.ts';
import { tangents } from '../../packages/core/src/reference/tangents.ts';
import { cross, dot, length, subtract } from '../../packages/core/src/vector.ts';
import { Program } from '../../packages/ray-scene/src/program.ts';
import { RenderDevice } from '../../packages/ray-scene/src/render-device.ts';
import main from '../bsdf/directions.frag.glsl';
import { drawnPixels, shaderSource } from '../bsdf/probe.ts';

describe('directions on the GPU', () => {
  let device: RenderDevice;
  let program: Program;
  before(() => {
    device = new RenderDevice();
    program = new Program(device.gl, shaderSource(main, new Set()));
  });
  after(() => device.dispose());

  const drawn = (part: number): readonly Vec3[] => {
    program.use();
    device.gl.uniform1i(program.uniform('part'), part);
    const pixels = drawnPixels(device.gl, 256, 256);
    return Array.from({ length: 65536 }, (_, i) => [...pixels.subarray(4 * i, 4 * i + 3)] as unknown as Vec3);
  };

  it('go around a circle within 1e-7', () => {
    const off = drawn(3).map(([x, y], i) => {
      const [cos, sin] = circle(i / 65536);
      return Math.max(Math.abs(x - cos), Math.abs(y - sin));
    });
    expect(Math.max(...off)).to.be.below(1e-7);
  });

  it('have frames that are orthonormal to rounding, and those of f64', () => {
    const [normals, xs, ys] = [drawn(0), drawn(1), drawn(2)] as const;
    const off = normals.map((n, i) => {
      const [x, y] = [xs[i], ys[i]] as [Vec3, Vec3];
      const turned = tangents(n)[0];
      return {
        frame: Math.max(...[dot(x, n), dot(y, n), dot(x, y), length(x) - 1, length(y) - 1].map(Math.abs)),
        hand: length(subtract(cross(x, y), n)),
        twin: length(subtract(x, turned)),
      };
    });
    expect(Math.max(...off.map(({ frame }) => frame))).to.be.below(1e-6);
    expect(Math.max(...off.map(({ hand }) => hand))).to.be.below(1e-6);
    // Where they change over, one rounding decides.
    const twins = off.filter((_, i) => Math.abs((normals[i] as Vec3)[2] + 0.6180339887) > 1e-7);
    expect(Math.max(...twins.map(({ twin }) => twin))).to.be.below(1e-6);
  });
});
