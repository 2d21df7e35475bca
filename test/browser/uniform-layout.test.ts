import '@ray-scene/core/parts';
import { expect } from '@open-wc/testing';
import {
  type BlockLayout,
  cameraFrame,
  generateShader,
  parseScene,
  parseSettings,
  requirements,
  resolveScene,
} from '@ray-scene/core';
import { Accumulation } from '../../packages/ray-scene/src/accumulation.ts';
import { Program } from '../../packages/ray-scene/src/program.ts';
import { ProgramCache } from '../../packages/ray-scene/src/program-cache.ts';
import { RenderDevice } from '../../packages/ray-scene/src/render-device.ts';
import { Tracer } from '../../packages/ray-scene/src/tracer.ts';

const spheres = [
  { type: 'sphere', radius: 2 },
  { type: 'sphere', center: [3, 0, 0], metalness: 1 },
  { type: 'sphere', center: [5, 0, 0], metalness: 0.5, specularColor: 'red' },
];
const plane = { type: 'plane', point: [0, -1, 0], checker: 'black' };
const lights = [
  { type: 'point', position: [3, 9, 4] },
  { type: 'point', position: [3, 9, 5], decay: 0 },
  { type: 'directional', direction: [0, -1, 0] },
];

/** Between them these have every member of every record. */
const scenes: { readonly [name: string]: object } = {
  'one sphere': { objects: spheres.slice(0, 1), lights: lights.slice(2) },
  'the studio': { objects: [...spheres, plane] },
  'a dull plane': { objects: [{ ...plane, specular: 0 }], lights: lights.slice(0, 1) },
  'many objects': {
    objects: [...Array.from({ length: 11 }, (_, i) => ({ ...spheres[i % 3], center: [i, 0, 0] })), plane, plane],
    lights,
  },
  'small things on a planet': { objects: [...spheres, { type: 'sphere', radius: 1e6 }, plane], lights },
  'all at once': {
    objects: [...spheres, plane, { ...plane, point: [0, -3, 0], checkerSize: 2 }],
    lights,
    environment: { top: 'white', bottom: 'gray' },
    background: 'navy',
  },
};

/** What WebGL says of a uniform in a block. */
function offsetsOf(gl: WebGL2RenderingContext, program: WebGLProgram, names: readonly string[]) {
  const indices = gl.getUniformIndices(program, [...names]);
  if (!indices) throw new Error('no indices');
  expect(names.filter((_, i) => indices[i] === gl.INVALID_INDEX)).to.deep.equal([]);
  return (gl.getActiveUniforms(program, indices, gl.UNIFORM_OFFSET) as number[]).map((offset, i) => [names[i], offset]);
}

/** What the layout says. */
const placesIn = ({ entries }: BlockLayout): [string, number][] =>
  entries.flatMap(({ name, struct, count, offset }) =>
    Array.from({ length: count ?? 1 }, (_, i) =>
      struct.members.map((member): [string, number] => [
        `${name}${count === undefined ? '' : `[${i}]`}.${member.name}`,
        offset + i * struct.size + member.offset,
      ]),
    ).flat(),
  );

describe('uniform blocks', () => {
  let device: RenderDevice;
  before(() => {
    device = new RenderDevice();
  });
  after(() => device.dispose());

  for (const [name, scene] of Object.entries(scenes)) {
    it(`lie where the layout says: ${name}`, () => {
      const { gl } = device;
      const shader = generateShader(
        requirements(resolveScene(parseScene(scene)), parseSettings({ integrator: 'direct' })),
      );
      const program = new Program(gl, shader);
      program.use();
      const handle = gl.getParameter(gl.CURRENT_PROGRAM) as WebGLProgram;
      for (const layout of [shader.sceneBlock, shader.viewBlock]) {
        const places = placesIn(layout);
        const names = places.map(([uniform]) => uniform);
        expect(offsetsOf(gl, handle, names)).to.deep.equal(places);
        const index = gl.getUniformBlockIndex(handle, layout.name);
        expect(gl.getActiveUniformBlockParameter(handle, index, gl.UNIFORM_BLOCK_DATA_SIZE)).to.equal(layout.size);
        expect(gl.getActiveUniformBlockParameter(handle, index, gl.UNIFORM_BLOCK_ACTIVE_UNIFORMS)).to.equal(
          names.length,
        );
      }
      program.dispose();
    });

    it(`say the same when they come as varyings: ${name}`, () => {
      const { gl, precision } = device;
      const resolved = resolveScene(parseScene(scene));
      const required = requirements(resolved, parseSettings({ integrator: 'direct' }));
      const pictures = [0, gl.getParameter(gl.MAX_VARYING_VECTORS)].map((varyings) => {
        const programs = new ProgramCache(gl);
        const tracer = new Tracer(gl, programs, required, { varyings });
        tracer.setScene(resolved);
        const target = new Accumulation(gl, precision, 16, 16);
        target.add(() => tracer.draw(cameraFrame(resolved.camera, 16, 16)));
        const mean = target.readMean();
        target.dispose();
        tracer.dispose();
        programs.dispose();
        return mean;
      });
      const [uniforms, varyings] = pictures as [Float32Array, Float32Array];
      expect(uniforms.some((value) => value > 0)).to.equal(true);
      // Compilers may order the same sums differently; on an edge a pixel may then fall to the other side.
      const different = uniforms.filter(
        (value, i) => Math.abs(value - (varyings[i] as number)) > 1e-4 * Math.max(value, 1),
      );
      expect(different.length).to.be.at.most(8);
    });
  }
});
