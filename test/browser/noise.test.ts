import '@ray-scene/core/parts';
import { expect } from '@open-wc/testing';
import { parseScene, parseSettings, type RenderSettings } from '@ray-scene/core';
import { Accumulation } from '../../packages/ray-scene/src/accumulation.ts';
import { CELL_BITS } from '../../packages/ray-scene/src/cells.ts';
import { type Noise, NoiseMeter } from '../../packages/ray-scene/src/noise-meter.ts';
import { Program } from '../../packages/ray-scene/src/program.ts';
import { RenderDevice, Renderer } from '../../packages/ray-scene/src/renderer.ts';
import { FEWEST_SAMPLES } from '../../packages/ray-scene/src/stop-rules.ts';
import { countObjects, fillSource } from './gl-fixtures.ts';

const nextTask = (): Promise<unknown> => new Promise((resolve) => setTimeout(resolve));

/** A number from 0 to 1 in GLSL, another one for each pixel and sample: two rounds of PCG. */
const randomSource = (color: string) => {
  const { vertex, fragment, lines } = fillSource(color);
  const random = `uniform uint sampleNumber;
    uint pcg(uint v) {
      uint state = v * 747796405u + 2891336453u;
      uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
      return (word >> 22u) ^ word;
    }
    float random() {
      uvec2 pixel = uvec2(gl_FragCoord.xy);
      return float(pcg(pcg(pixel.x + 4096u * pixel.y) ^ pcg(sampleNumber)) >> 8) * exp2(-24.0);
    }
    void main()`;
  return {
    vertex,
    lines,
    fragment: fragment
      .replace('precision highp float;', 'precision highp float; precision highp int;')
      .replace('void main()', random),
  };
};

for (const precision of ['float', 'half'] as const) {
  describe(`NoiseMeter (${precision})`, () => {
    let device: RenderDevice;
    let gl: WebGL2RenderingContext;
    before(() => {
      device = new RenderDevice({ precision });
      ({ gl } = device);
    });
    after(() => device.dispose());

    /** The noise of so many samples of a colour, in GLSL. */
    function noiseOf(color: string, samples: number, { width = 200, height = 150, exposure = 1 } = {}): Noise {
      const target = new Accumulation(gl, precision, width, height);
      const program = new Program(gl, randomSource(color));
      for (let i = 0; i < samples; i++) {
        program.use();
        gl.uniform1ui(program.uniform('sampleNumber'), i);
        target.add(() => gl.drawArrays(gl.TRIANGLES, 0, 3));
      }
      const meter = new NoiseMeter(gl, device.programs, precision, target);
      const noise = meter.begin(target, exposure)();
      meter.dispose();
      program.dispose();
      target.dispose();
      return noise;
    }

    // Of 200 × 150 pixels with the same number in all channels: the spread of the error is 0.4 %.
    const NEAR = 0.02;
    /** What is told may be larger than it is by so many times itself: see relative-variance.glsl. */
    const SAFE = 0.5;

    for (const samples of [2, 3, 7, 16, 33]) {
      it(`knows the error of ${samples} samples, uniform between 0.5 and 1.5`, () => {
        const { error } = noiseOf('vec4(vec3(0.5 + random()), 1)', samples);
        const expected = Math.sqrt(1 / 12 / samples / 1.01);
        expect(error / expected).to.be.within(1 - NEAR, 1 + NEAR + SAFE * expected);
      });
    }

    it('finds none where all samples are alike', () => {
      expect(noiseOf('vec4(0.5, 0.25, 4, 1)', 8).error).to.equal(0);
      expect(noiseOf('vec4(0)', 8).error).to.equal(0);
    });

    it('is not told to be small by bright specks that make the mean large under them', () => {
      const [share, bright, samples] = [1e-3, 100, 16];
      const { error } = noiseOf(`vec4(vec3(random() < ${share} ? ${bright} : 1), 1)`, samples);
      const mean = 1 + share * (bright - 1);
      const expected = Math.sqrt((share * (1 - share) * (bright - 1) ** 2) / samples / (mean ** 2 + 0.01));
      // 480 specks in each channel of the picture: 1 / sqrt(480) of the variance, half of it of the error.
      expect(error / expected).to.be.closeTo(1, 0.1);
    });

    // What it tells over what there is, by a simulation of 1,800 pixels of an edge; without what stands for those that have met
    // nothing of the lamp, this picture tells 0.85, 0.77, 0.70 and 1.
    for (const [bright, dark, told] of [
      [15, 0.1, 1.2],
      [15, 0, 1.08],
      [100, 0.1, 1.32],
      [2, 0.1, 1],
    ] as const) {
      it(`knows of the edge of a lamp of ${bright} beside ${dark}, of which some pixels have met nothing`, () => {
        const [width, height, samples] = [64, 600, 16];
        const lamp = (row: string) => `20.0 + fract(${row} * 0.618)`;
        const color = `vec4(vec3(gl_FragCoord.x - 0.5 + random() < ${lamp('gl_FragCoord.y')} ? float(${bright}) : float(${dark})), 1)`;
        let sum = 0;
        for (let y = 0.5; y < height; y++) {
          const share = (y * 0.618) % 1;
          const mean = dark + share * (bright - dark);
          sum += (share * (1 - share) * (bright - dark) ** 2) / (mean ** 2 + 0.01);
        }
        const expected = Math.sqrt(sum / (width * height) / samples);
        // Of 600 pixels of an edge: up to 8 % by chance.
        expect(noiseOf(color, samples, { width, height }).error / expected).to.be.closeTo(told, 0.12);
      });
    }

    it('is relative where the picture is bright, absolute where it is dark', () => {
      const errorAt = (exposure: number): number => noiseOf('vec4(vec3(0.5 + random()), 1)', 16, { exposure }).error;
      const expected = (exposure: number): number => Math.sqrt(1 / 12 / 16 / (1 + 0.01 / exposure ** 2));
      for (const exposure of [1e-3, 0.1, 1, 100, 1e15]) {
        const told = errorAt(exposure) / expected(exposure);
        expect(told).to.be.within(1 - NEAR, 1 + NEAR + SAFE * expected(1));
      }
      expect(errorAt(0)).to.equal(0);
    });

    it('tells it for each cell, also where cells are cut by the edge of the picture', () => {
      const side = 2 ** CELL_BITS;
      const [width, height] = [side + 8, 2 * side + 6];
      const left = `vec4(vec3(gl_FragCoord.x < ${side}.0 ? 0.5 + random() : 1.0), 1)`;
      const { cells, error } = noiseOf(left, 16, { width, height });
      const expected = Math.sqrt(1 / 12 / 16 / 1.01);
      // One degree of freedom for each pixel; four standard deviations.
      const chance = (pixels: number): number => 4 * Math.sqrt(1 / (2 * pixels));
      expect(cells.length).to.equal(2 * 3);
      for (const [i, cell] of cells.entries()) {
        const pixels = side * Math.min(side, height - side * (i >> 1));
        const off = cell / expected - (i % 2 === 0 ? 1 : 0);
        expect(off).to.be.within(-chance(pixels), chance(pixels) + SAFE * expected);
      }
      const whole = Math.sqrt(side / width);
      const spare = chance(side * height);
      expect(error / expected / whole - 1).to.be.within(-spare, spare + SAFE * expected);
    });

    it('is a number whatever the pictures hold', () => {
      for (const color of ['vec4(3e38)', 'vec4(-1)', 'vec4(0.0 / (random() - random()))', 'vec4(1e30 * random())']) {
        const { error } = noiseOf(color, 5, { exposure: 1e30 });
        expect(error, color).to.be.within(0, 1e5);
      }
    });

    it('frees everything', () => {
      const target = new Accumulation(gl, precision, 40, 40);
      const counts = countObjects(gl);
      new NoiseMeter(gl, device.programs, precision, target).dispose();
      expect([counts.Buffer, counts.Framebuffer, counts.Texture]).to.deep.equal([0, 0, 0]);
      target.dispose();
    });
  });
}

describe('the end of a picture', () => {
  const scene = parseScene({
    environment: { color: 'white' },
    background: 'black',
    objects: [{ type: 'sphere' }, { type: 'sphere', center: [1, 1, 0], color: 'red' }],
  });
  let renderer: Renderer;
  let canvas: HTMLCanvasElement;

  beforeEach(() => {
    canvas = document.createElement('canvas');
    renderer = new Renderer(canvas);
    renderer.onerror = (error) => {
      throw error;
    };
    renderer.resize(64, 48);
  });
  afterEach(() => {
    renderer.dispose();
    RenderDevice.shared.dispose();
  });

  /** Draws, as a page does, until nothing more is to be known. */
  async function complete(settings: Partial<RenderSettings>): Promise<void> {
    renderer.setSettings(parseSettings({ integrator: 'direct', ...settings }));
    renderer.setScene(scene);
    while (renderer.draw(2) || renderer.isMeasuring) await nextTask();
  }

  it('comes with the last sample, and the noise of all of them is known', async () => {
    await complete({ samples: 40 });
    expect(renderer.stopped).to.equal('samples');
    const { samples, error, rays, seconds } = renderer.stats;
    expect(samples).to.equal(40);
    expect(rays).to.equal(40 * 64 * 48);
    expect(error).to.be.within(0.005, 0.1);
    expect(seconds).to.be.greaterThan(0);
  });

  it('comes when the noise is low enough, but not by the luck of a few samples', async () => {
    await complete({ samples: 100_000, maxError: 0.02 });
    expect(renderer.stopped).to.equal('error');
    expect(renderer.stats.error).to.be.at.most(0.02);
    expect(renderer.samples).to.be.within(FEWEST_SAMPLES, 10_000);
    await complete({ samples: 100_000, maxError: 1 });
    expect(renderer.stopped).to.equal('error');
    expect(renderer.samples).to.be.at.least(FEWEST_SAMPLES);
  });

  it('comes when the time is up, with one sample at least', async () => {
    await complete({ samples: 2 ** 20, maxTime: 0.05 });
    expect(renderer.stopped).to.equal('time');
    expect(renderer.stats.seconds).to.be.at.least(0.05);
    expect(renderer.samples).to.be.at.least(1);
  });

  it('of one sample comes without knowing its noise', async () => {
    await complete({ samples: 1 });
    expect(renderer.stopped).to.equal('samples');
    expect(renderer.stats.error).to.equal(undefined);
  });

  it('is put off by other settings, and comes again for another view', async () => {
    await complete({ samples: 4 });
    renderer.setSettings(parseSettings({ integrator: 'direct', samples: 8 }));
    expect(renderer.stopped).to.equal(undefined);
    await complete({ samples: 8 });
    expect([renderer.stopped, renderer.samples]).to.deep.equal(['samples', 8]);
    renderer.resize(30, 40);
    expect(renderer.stopped).to.equal(undefined);
    expect(renderer.stats.error).to.equal(undefined);
  });

  it('measures anew when the exposure changes', async () => {
    await complete({ samples: 16, exposure: 0.01 });
    const dark = renderer.stats.error as number;
    renderer.setSettings(parseSettings({ integrator: 'direct', samples: 16, exposure: 1 }));
    while (renderer.draw(2) || renderer.isMeasuring) await nextTask();
    expect(renderer.stats.samples).to.equal(16);
    expect(renderer.stats.error).to.be.greaterThan(dark);
  });

  /** The bytes of a pixel of the canvas, counted from the lower left. */
  const shownAt = (x: number, y: number): readonly number[] => [
    ...(canvas.getContext('2d') as CanvasRenderingContext2D).getImageData(x, 47 - y, 1, 1).data,
  ];

  it('is seen in a map of the samples and in one of the error', async () => {
    await complete({ samples: 16, output: 'samples' });
    // The bright end of the ramp: all pixels have the most that any has.
    expect(shownAt(3, 3)).to.deep.equal(shownAt(60, 40));
    expect(shownAt(3, 3)[0]).to.be.within(250, 255);
    await complete({ samples: 16, output: 'error' });
    // Its dark end: far from the edge of a ball all samples are alike.
    const [red = 0, green = 0, blue = 0, alpha] = shownAt(1, 1);
    expect([red < 80, green < 10, blue < 100, alpha]).to.deep.equal([true, true, true, 255]);
    const row = Array.from({ length: 64 }, (_, x) => shownAt(x, 24)[1] as number);
    expect(Math.max(...row)).to.be.greaterThan(100);
    await complete({ samples: 16 });
    expect(shownAt(1, 1)).to.deep.equal([0, 0, 0, 255]);
  });
});
