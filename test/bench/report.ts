/** The numbers of the bench as a table for people. */
import type { Machine } from './circumstances.ts';
import type { Measured, Pace, Plan } from './measure.ts';

export function printMachine(machine: Machine, brotli: number | null): void {
  const { browser, renderer, processor, cores, system, load, sampleTimes } = machine;
  const time = sampleTimes === 'cpu' ? 'what all processors spend together in the browser' : 'time on the clock';
  console.log(`${browser}, ${renderer}
${processor}, ${cores} cores, ${system}, load ${load.toFixed(1)}
ray-scene.min.js: ${brotli === null ? 'does not build' : `${brotli} bytes brotli`}
Times of samples are ${time}. They are of this machine and its load: compare ratios.`);
}

export function printScenes(scenes: { readonly [scene: string]: Measured }, plan: Plan): void {
  console.log(`
ms, medians; pictures of 300 × 300; starts: ${plan.coldStarts}, samples of ${plan.rounds} turns
${line(['scene', 'shader chars', 'compile', 'first frame', 'ms/sample', 'wall', 'ratio to floor'])}`);
  for (const [name, measured] of Object.entries(scenes)) {
    const { shaderChars, compileMs, firstFrameMs, floorCompileMs, floorFirstFrameMs, at600 } = measured;
    console.log(line([name, shaderChars, ms(compileMs), ms(firstFrameMs), ...paceCells(measured)]));
    if (floorCompileMs === undefined || floorFirstFrameMs === undefined || !at600) continue;
    console.log(line(['  its floor', '', ms(floorCompileMs), ms(floorFirstFrameMs), ...floorCells(measured)]));
    console.log(line(['  at 600 × 600', '', '', '', ...paceCells(at600)]));
    console.log(line(['  its floor', '', '', '', ...floorCells(at600)]));
  }
  console.log(
    `The ratio to the floor, a shader written by hand for that one scene, is the median of ${plan.rounds} pairs.`,
  );
}

const paceCells = ({ msPerSample, wallMsPerSample, floorRatio }: Pace): string[] => [
  ms(msPerSample),
  ms(wallMsPerSample),
  floorRatio?.toFixed(3) ?? '',
];

const floorCells = ({ floorMsPerSample = 0, floorWallMsPerSample = 0 }: Pace): string[] => [
  ms(floorMsPerSample),
  ms(floorWallMsPerSample),
  '1',
];

const ms = (time: number): string => time.toFixed(time < 10 ? 2 : 1);

const line = ([name, ...numbers]: readonly (string | number)[]): string =>
  String(name).padEnd(16) + numbers.map((number) => String(number).padStart(14)).join('');
