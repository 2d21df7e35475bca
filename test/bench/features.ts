/** `npm run bench -- --features`: what each feature of a scene costs, against the same scene without it. */
import { featureScenes, images } from '../feature-scenes.ts';
import { packedImages } from '../truth/images/packed-image.ts';
import { measureColdStarts, measurePace, type Plan, type SceneToBench, type Start, subjectsOf } from './measure.ts';

declare const bench: typeof import('./page.ts');

/** Medians. With the feature, over and less what it is without: the scenes start and are drawn in turns. */
export interface FeatureCost {
  readonly shaderChars: number;
  readonly addedChars: number;
  readonly compileMs: number;
  readonly compileRatio: number;
  readonly addedCompileMs: number;
  readonly msPerSample: number;
  /** The median of the turns' ratios. */
  readonly sampleRatio: number;
  readonly addedMsPerSample: number;
}

type FeatureCosts = { readonly [feature: string]: FeatureCost };

const scenes: readonly SceneToBench[] = Object.entries(featureScenes).map(([name, { scene, settings }]) => ({
  name,
  scene: JSON.stringify(scene),
  integrator: 'path',
  bounces: 3,
  ...settings,
  images: packedImages(images),
}));

/** The first one is the scene without any of them. */
export async function measureFeatures(start: Start, plan: Plan, onCost: (name: string, cost: FeatureCost) => void) {
  const compiles = (await measureColdStarts(start, scenes, plan)).map(({ compileMs }) => compileMs);
  const browser = await start();
  const [without] = scenes as readonly [SceneToBench];
  const [plainCompile] = compiles as [number];
  let plainChars = 0;
  const features: { [feature: string]: FeatureCost } = {};
  for (const [i, scene] of scenes.entries()) {
    const page = await browser.open();
    const { shaderChars } = await page.execute((subjects) => bench.prepare(subjects), subjectsOf(scene));
    if (i === 0) plainChars = shaderChars;
    const pace = await measurePace(page, [...subjectsOf(scene), ...subjectsOf(without)], plan);
    const { msPerSample, floorMsPerSample: plainMs = msPerSample, floorRatio: sampleRatio = 1 } = pace;
    const compileMs = compiles[i] as number;
    const cost = {
      shaderChars,
      addedChars: shaderChars - plainChars,
      compileMs,
      compileRatio: compileMs / plainCompile,
      addedCompileMs: compileMs - plainCompile,
      msPerSample,
      sampleRatio,
      addedMsPerSample: msPerSample - plainMs,
    };
    features[scene.name] = cost;
    onCost(scene.name, cost);
  }
  await browser.close();
  return features satisfies FeatureCosts;
}

export function printFeaturesHead({ coldStarts, rounds }: Plan): void {
  console.log(`
what a scene costs with one thing more, beside a dull ball and a lamp alone; the path integrator, 300 × 300, medians:
compile of ${coldStarts} cold starts, ms per sample of ${rounds} turns; + what it adds, × how many times as much it is
${line('', ['characters', '+', 'compile', '+', '×', 'ms/sample', '+', '×'])}`);
}

export function printFeature(name: string, cost: FeatureCost): void {
  const { shaderChars, addedChars, compileMs, addedCompileMs, compileRatio } = cost;
  const { msPerSample, addedMsPerSample, sampleRatio } = cost;
  const compile = [compileMs.toFixed(1), addedCompileMs.toFixed(1), compileRatio.toFixed(2)];
  const sample = [msPerSample.toFixed(2), addedMsPerSample.toFixed(2), sampleRatio.toFixed(2)];
  console.log(line(name, [shaderChars, addedChars, ...compile, ...sample]));
}

const line = (name: string, cells: readonly (string | number)[]): string =>
  name.padEnd(36) + cells.map((cell) => String(cell).padStart(10)).join('');
