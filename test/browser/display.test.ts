import { expect } from '@open-wc/testing';
import { Accumulation } from '../../packages/ray-scene/src/accumulation.ts';
import { Display } from '../../packages/ray-scene/src/display.ts';
import { RenderDevice } from '../../packages/ray-scene/src/render-device.ts';
import { addPixels } from './gl-fixtures.ts';

type Rgb = readonly [number, number, number];
type Rgba = readonly [number, number, number, number];
type ToneMapping = Display['toneMapping'];

/** The reference, from the formulas of the specification, in f64. */
const toneMap: { readonly [T in ToneMapping]: (color: Rgb) => Rgb } = {
  none: (color) => map(color, (c) => Math.min(c, 1)),
  neutral: (color) => {
    const x = Math.min(...color);
    const f = x <= 0.08 ? x - x ** 2 / 0.16 : 0.04;
    const p = Math.max(...color) - f;
    if (p <= 0.76) return map(color, (c) => c - f);
    const pn = 1 - 0.24 ** 2 / (p + 1 - 2 * 0.76);
    const g = 1 / (0.15 * (p - pn) + 1);
    return map(color, (c) => (c - f) * (pn / p) * g + pn * (1 - g));
  },
};

const encode = (c: number): number => (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055);

const map = ([r, g, b]: Rgb, f: (c: number) => number): Rgb => [f(r), f(g), f(b)];

/** 8-bit premultiplied RGBA. */
function expected([r, g, b, a]: Rgba, toneMapping: ToneMapping, exposure: number): readonly number[] {
  if (a === 0) return [0, 0, 0, 0];
  const mapped = toneMap[toneMapping](map([r / a, g / a, b / a], (c) => c * exposure));
  return [...map(mapped, encode), 1].map((c) => Math.round(255 * a * c));
}

describe('display', () => {
  let device: RenderDevice;
  let context: CanvasRenderingContext2D;
  before(() => {
    device = new RenderDevice();
    context = document.createElement('canvas').getContext('2d') as CanvasRenderingContext2D;
  });
  after(() => device.dispose());

  function shown(pixels: readonly Rgba[], toneMapping: ToneMapping, exposure = 1): Uint8Array {
    const { gl, programs, precision } = device;
    const target = new Accumulation(gl, precision, pixels.length, 1);
    addPixels(gl, target, pixels);
    const display = new Display(gl, programs, toneMapping);
    const bytes = new Uint8Array(4 * pixels.length);
    device.present(context, pixels.length, 1, () => {
      display.draw(target, exposure);
      gl.readPixels(0, 0, pixels.length, 1, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    });
    display.dispose();
    target.dispose();
    return bytes;
  }

  const values = [0, 1e-6, 0.002, 0.0031308, 0.0032, 0.02, 0.0799, 0.0801, 0.3, 0.7599, 0.8, 0.81, 1, 1.5, 4, 50, 1e4];
  const opaque = values.flatMap((r) => [0, 0.05, 0.5, 3].map((g) => [r, g, r * g, 1] as const));

  for (const toneMapping of ['neutral', 'none'] as const) {
    for (const exposure of [1, 0.25, 8, 0]) {
      it(`follows the formulas (${toneMapping}, exposure ${exposure})`, () => {
        const bytes = shown(opaque, toneMapping, exposure);
        const reference = opaque.flatMap((pixel) => expected(pixel, toneMapping, exposure));
        const worst = Math.max(...reference.map((value, i) => Math.abs(value - (bytes[i] as number))));
        // One level: rounding falls to either side.
        expect(worst).to.be.at.most(1);
      });
    }

    it(`maps the colour of what covers a pixel, not its share of the light (${toneMapping})`, () => {
      const colors: readonly Rgb[] = [
        [0.2, 0.5, 0.9],
        [2, 0.5, 0.1],
        [1e-4, 0, 0.01],
      ];
      const pixels = [0, 1 / 64, 0.25, 0.5, 1].flatMap((a) => colors.map((c) => [...map(c, (x) => x * a), a] as const));
      const bytes = shown(pixels, toneMapping);
      pixels.forEach((pixel, i) => {
        expected(pixel, toneMapping, 1).forEach((value, channel) => {
          expect(bytes[4 * i + channel]).to.be.closeTo(value, 1);
          // Premultiplied: no colour without coverage.
          expect(bytes[4 * i + channel]).to.be.at.most(bytes[4 * i + 3] as number);
        });
      });
    });

    it(`shows something sensible of any number (${toneMapping})`, () => {
      const extremes = [3e38, Number.POSITIVE_INFINITY, 1e-30, Number.NaN, -1];
      for (const exposure of [0, 1, 1e60]) {
        const bytes = shown(
          extremes.map((x) => [x, x, x, 1]),
          toneMapping,
          exposure,
        );
        const grey = [...bytes].filter((_, i) => i % 4 === 0);
        const white = exposure > 0 ? 255 : 0;
        const dark = exposure > 1 ? 255 : 0;
        expect(grey).to.deep.equal([white, white, dark, 0, 0]);
      }
    });
  }

  it('divides by the samples', () => {
    const { gl, programs, precision } = device;
    const target = new Accumulation(gl, precision, 1, 1);
    addPixels(gl, target, [[2, 2, 2, 4]]);
    for (let i = 0; i < 3; i++) target.add(() => {});
    const display = new Display(gl, programs, 'none');
    device.present(context, 1, 1, () => display.draw(target, 1));
    expect([...context.getImageData(0, 0, 1, 1).data]).to.deep.equal([188, 188, 188, 255]);
    display.dispose();
    target.dispose();
  });

  it('compiles each tone mapping once', () => {
    const before = device.compileCount;
    shown([[1, 1, 1, 1]], 'neutral');
    shown([[1, 1, 1, 1]], 'none');
    shown([[1, 1, 1, 1]], 'neutral');
    expect(device.compileCount).to.equal(before);
  });
});
