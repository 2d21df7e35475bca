/** `npm run bench -- --primitives`: what it costs that no digits get lost, primitive by primitive. */
import { type ShapeKind, shapeKinds } from '@ray-scene/core';
import type { BenchBrowser, BenchPage } from './browser-pages.ts';
import { childrenCpuMs } from './cpu-time.ts';
import type { Plan } from './measure.ts';

declare const primitiveBench: typeof import('./primitives-page.ts');

/** The module of the pages that this runs in. */
export const PRIMITIVES_PAGE = { entry: 'test/bench/primitives-page.ts', name: 'primitiveBench' } as const;

const SIZE = 300;

export interface PrimitiveCost {
  /** Medians, of the engine's formulas and of the textbook's. */
  readonly msPerSample: number;
  readonly textbookMsPerSample: number;
  /** The median of the turns' ratios. */
  readonly ratio: number;
  /** How far the pictures are apart, relative: the median of all colours that are not black. */
  readonly difference: number;
}

/** Eight of a kind, before a camera and below a lamp; a camera ray and a shadow ray meet all of them. */
function sceneOf(kind: ShapeKind): string {
  const objects = Array.from({ length: 8 }, (_, i) => {
    const [x, y] = [((i % 4) - 1.5) * 1.1, (Math.floor(i / 4) - 0.5) * 1.3];
    return { type: kind, specular: 0, color: '#ccc', ...shapeAt(kind, [x, y, 0.2 * Math.sin(i)], i) };
  });
  return JSON.stringify({
    camera: { position: [0.2, 0.5, 5], target: [0, 0, 0], fov: 40 },
    background: 'black',
    lights: [{ type: 'point', position: [2, 3, 4], intensity: 60 }],
    objects,
  });
}

type Triple = readonly [number, number, number];

function shapeAt(kind: ShapeKind, [x, y, z]: Triple, i: number): object {
  const tilt: Triple = [Math.sin(i), 1.5, Math.cos(i)];
  switch (kind) {
    case 'sphere':
      return { center: [x, y, z], radius: 0.55 };
    case 'plane':
      return { point: [2 * x, 2 * y, -3], normal: [Math.sin(i), Math.cos(i), 1] };
    case 'disc':
      return { center: [x, y, z], normal: [Math.sin(i), Math.cos(i), 2], radius: 0.55 };
    case 'quad':
      return { corner: [x - 0.5, y - 0.5, z], edgeU: [1, 0.1, 0.2 * Math.sin(i)], edgeV: [0, 1, 0.2 * Math.cos(i)] };
    case 'box':
      return { center: [x, y, z], size: [0.8, 0.9, 0.7] };
    case 'cylinder':
      return { base: [x, y - 0.5, z], top: [x + 0.3 * tilt[0], y + 0.5, z + 0.3 * tilt[2]], radius: 0.4 };
    case 'cone':
      return { base: [x, y - 0.5, z], tip: [x + 0.3 * tilt[0], y + 0.5, z + 0.3 * tilt[2]], radius: 0.5 };
    case 'torus':
      return { center: [x, y, z], axis: tilt, radius: 0.4, tube: 0.15 };
    case 'triangle':
      return { a: [x - 0.5, y - 0.5, z], b: [x + 0.5, y - 0.4, z], c: [x, y + 0.5, z + 0.3 * tilt[0]] };
  }
}

export async function measurePrimitives(
  browser: BenchBrowser,
  { rounds, turnMs }: Plan,
): Promise<{ readonly [kind: string]: PrimitiveCost }> {
  const costs: { [kind: string]: PrimitiveCost } = {};
  for (const kind of shapeKinds) {
    const page = await browser.open();
    const subject = { kind, scene: sceneOf(kind), size: SIZE };
    const { medianDifference } = await page.execute((one) => primitiveBench.prepare(one), subject);
    const samples = Math.max(1, Math.ceil(turnMs / (await takeTurn(page, 0, 2))));
    const turns: [number, number][] = [];
    for (let round = 0; round < rounds; round++) {
      // Whoever went first goes last in the next round.
      const order = round % 2 === 0 ? [0, 1] : [1, 0];
      const turn: [number, number] = [0, 0];
      for (const index of order) turn[index] = await takeTurn(page, index, samples);
      turns.push(turn);
    }
    costs[kind] = {
      msPerSample: median(turns.map(([ours]) => ours)),
      textbookMsPerSample: median(turns.map(([, theirs]) => theirs)),
      ratio: median(turns.map(([ours, theirs]) => ours / theirs)),
      difference: medianDifference,
    };
  }
  return costs;
}

/** Milliseconds per sample: of all processors where the system tells, else of the clock on the wall. */
async function takeTurn(page: BenchPage, index: number, samples: number): Promise<number> {
  const before = childrenCpuMs();
  const wall = await page.execute((turn) => primitiveBench.run(turn.index, turn.samples), { index, samples });
  const after = childrenCpuMs();
  return (before === undefined || after === undefined ? wall : after - before) / samples;
}

const median = (values: readonly number[]): number => [...values].sort((a, b) => a - b)[values.length >> 1] as number;

export function printPrimitives(costs: { readonly [kind: string]: PrimitiveCost }): void {
  console.log(`\neight of a kind at ${SIZE} × ${SIZE}, ms per sample; the textbook's formulas in the same shader`);
  console.log(`${''.padEnd(12)}${['ours', 'textbook', 'ratio', 'apart'].map((name) => name.padStart(12)).join('')}`);
  for (const [kind, { msPerSample, textbookMsPerSample, ratio, difference }] of Object.entries(costs)) {
    const cells = [
      msPerSample.toFixed(2),
      textbookMsPerSample.toFixed(2),
      ratio.toFixed(2),
      difference.toExponential(0),
    ];
    console.log(kind.padEnd(12) + cells.map((cell) => cell.padStart(12)).join(''));
  }
}
