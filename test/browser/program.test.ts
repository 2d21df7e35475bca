import { expect } from '@open-wc/testing';
import { Program, ShaderError } from '../../packages/ray-scene/src/program.ts';
import { RenderDevice } from '../../packages/ray-scene/src/render-device.ts';
import { countObjects, fillSource } from './gl-fixtures.ts';

describe('Program', () => {
  let device: RenderDevice;
  before(() => {
    device = new RenderDevice();
  });
  after(() => device.dispose());

  const errorOf = (source: ConstructorParameters<typeof Program>[1]): ShaderError => {
    const program = new Program(device.gl, source);
    try {
      program.use();
    } catch (error) {
      expect(error).to.be.instanceOf(ShaderError);
      return error as ShaderError;
    } finally {
      program.dispose();
    }
    throw new Error('it compiled');
  };

  it('draws, and frees everything', () => {
    const counts = countObjects(device.gl);
    const program = new Program(device.gl, fillSource('vec4(1)'));
    program.use();
    expect(counts.Program).to.equal(1);
    program.dispose();
    expect(Object.values(counts)).to.deep.equal([0, 0, 0, 0, 0]);
  });

  it('names file and line of an error and shows the lines around it', () => {
    const { vertex } = fillSource('');
    const fragment = [
      '#version 300 es',
      'precision highp float;',
      'float sphereDistance(vec3 o) {',
      '  return dot(o, radius);',
      '}',
      'out vec4 color;',
      'void main() { color = vec4(sphereDistance(vec3(1))); }',
      '',
    ].join('\n');
    const lines = [
      { file: 'trace.frag.glsl', line: 1 },
      { file: 'trace.frag.glsl', line: 5 },
      { file: 'shape/sphere.glsl', line: 8 },
      { file: 'shape/sphere.glsl', line: 12 },
      { file: 'shape/sphere.glsl', line: 13 },
      { file: 'trace.frag.glsl', line: 9 },
      { file: 'trace.frag.glsl', line: 11 },
    ];
    const { message } = errorOf({ vertex, fragment, lines });
    expect(message).to.match(/^shape\/sphere\.glsl:12: 'radius' : undeclared identifier/);
    expect(message).to.contain(
      [
        '  shape/sphere.glsl:8 | float sphereDistance(vec3 o) {',
        '> shape/sphere.glsl:12 |   return dot(o, radius);',
        '  shape/sphere.glsl:13 | }',
      ].join('\n'),
    );
  });

  it('tells errors of the vertex shader and of linking too', () => {
    const { vertex, fragment, lines } = fillSource('vec4(1)');
    expect(errorOf({ vertex: vertex.replace('gl_Position', 'gl_Place'), fragment, lines }).message).to.contain(
      'gl_Place',
    );
    const unlinked = fragment.replace('out', 'in vec4 missing;\nout').replace('vec4(1)', 'missing');
    expect(errorOf({ vertex, fragment: unlinked, lines }).message).to.contain('missing');
  });

  it('finds uniforms, and knows of none that the compiler left out', () => {
    const source = fillSource('vec4(used)');
    const fragment = source.fragment.replace('out', 'uniform float used;\nuniform float unused;\nout');
    const program = new Program(device.gl, { ...source, fragment });
    program.use();
    expect(program.uniform('used')).not.to.equal(null);
    expect(program.uniform('unused')).to.equal(null);
    program.dispose();
  });
});
