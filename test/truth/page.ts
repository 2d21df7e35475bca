/** What `npm run truth` does in a page: answers problems on the GPU, as plain data that goes through JSON. */
import { RenderDevice } from '../../packages/ray-scene/src/render-device.ts';
import { BrdfProbe } from './brdf-probe.ts';
import type { BrdfQuestion } from './brdf-tables.ts';
import { BsdfProbe } from './bsdf-probe.ts';
import type { BsdfQuestion } from './bsdf-tables.ts';
import { Probe } from './probe.ts';
import type { Problem } from './problem.ts';

export * from './images/gpu-picture.ts';

let probe: Probe | undefined;

/** t and the normal as text: JSON has no Infinity, nor what is not a number. */
export function answer(problems: readonly Problem[]): readonly (readonly (readonly string[])[])[] {
  probe ??= new Probe(RenderDevice.shared);
  return probe.answer(problems).map((ways) => ways.map(({ t, normal }) => [t, ...normal].map(String)));
}

let brdfProbe: BrdfProbe | undefined;

/** Three channels each, as text. */
export function reflectance(questions: readonly BrdfQuestion[]): readonly (readonly string[])[] {
  brdfProbe ??= new BrdfProbe(RenderDevice.shared);
  return brdfProbe.answer(questions).map((channels) => channels.map(String));
}

let bsdfProbe: BsdfProbe | undefined;

/** Three channels each, as text. */
export function scattering(questions: readonly BsdfQuestion[]): readonly (readonly string[])[] {
  bsdfProbe ??= new BsdfProbe(RenderDevice.shared);
  return bsdfProbe.answer(questions).map((channels) => channels.map(String));
}
