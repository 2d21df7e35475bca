/**
 * The reflectances of `data/brdf` (data/README.md, section 2) as questions to the functions that scatter paths; see
 * brdf-tables.ts for those of the integrator `direct`.
 */
import type { Vec3 } from '@ray-scene/core';
import { type Bsdf, bsdfValue } from '../../packages/core/src/reference/material/bsdf.ts';
import { exactFresnel } from '../../packages/core/src/reference/material/dielectric.ts';
import { facetProbability, splitAt } from '../../packages/core/src/reference/material/fresnel.ts';
import { ggx, smithOverCosine } from '../../packages/core/src/reference/material/microfacet.ts';
import { normalize, scale } from '../../packages/core/src/vector.ts';
import { bsdfOf } from '../bsdf/cases.ts';
import type { BrdfCase, GgxEntry, GltfEntry, SchlickEntry, SmithEntry } from './brdf-tables.ts';

/** What the GPU is asked: a call with a material and numbers. */
export interface BsdfQuestion {
  readonly bsdf: Bsdf;
  readonly call: keyof typeof bsdfCalls;
  readonly first: Vec3;
  readonly second: Vec3;
  /** What the answer is to be multiplied by. */
  readonly factor: number;
}

/** GLSL that answers. */
export const bsdfCalls = {
  fresnel: 'answer = vec4(exactFresnel(first.x, first.y))',
  ggx: 'answer = vec4(ggx(b.alpha, first))',
  smith:
    'answer = vec4(first.x * smithOverCosine(b.alpha, first.x), first.y * smithOverCosine(b.alpha, first.y), 0, 0)',
  reflected: 'answer = vec4(splitAt(b, first.x).reflected, 0.0)',
  value: 'float pdf; answer = vec4(bsdfValue(b, first, second, pdf), 0.0)',
  pdf: 'float pdf; bsdfValue(b, first, second, pdf); answer = vec4(pdf)',
} as const;

type BsdfCase = BrdfCase<BsdfQuestion>;

const NOWHERE: Vec3 = [0, 0, 0];

const ask = (bsdf: Bsdf, call: BsdfQuestion['call'], first: Vec3, second = NOWHERE, factor = 1): BsdfQuestion => ({
  bsdf,
  call,
  first,
  second,
  factor,
});

interface FresnelEntry {
  readonly cosI: number;
  readonly eta: number;
  readonly F: number;
  readonly tirAmbiguous: boolean;
  readonly cond: number;
}

const fresnelCases = (entries: readonly FresnelEntry[]): readonly BsdfCase[] =>
  entries
    .filter(({ tirAmbiguous }) => !tirAmbiguous)
    .map(({ cosI, eta, F, cond }) => ({
      right: [F],
      cond,
      reference: () => [exactFresnel(cosI, eta)],
      question: ask(bsdfOf({}), 'fresnel', [cosI, eta, 0]),
    }));

const ggxCases = (entries: readonly GgxEntry[]): readonly BsdfCase[] =>
  entries.map(({ alpha, cosH, D, cond }) => {
    const h: Vec3 = [Math.sqrt((1 - cosH) * (1 + cosH)), 0, cosH];
    return {
      right: [D],
      cond,
      reference: () => [ggx(alpha, h)],
      question: ask(bsdfOf({ alpha }), 'ggx', h),
    };
  });

const smithCases = (entries: readonly SmithEntry[]): readonly BsdfCase[] =>
  entries.map(({ alpha, NoL, NoV, G1L, G1V, cond }) => ({
    right: [G1L, G1V],
    cond,
    reference: () => [NoL * smithOverCosine(alpha, NoL), NoV * smithOverCosine(alpha, NoV)],
    question: ask(bsdfOf({ alpha }), 'smith', [NoL, NoV, 0]),
  }));

/** A metal of the colour f0. */
const schlickCases = (entries: readonly SchlickEntry[]): readonly BsdfCase[] =>
  entries.map(({ cosI, f0, F, cond }) => {
    const metal = bsdfOf({ metalness: 1, color: [f0, f0, f0] });
    return {
      right: [F],
      cond: cond ?? 0,
      reference: () => [splitAt(metal, cosI).reflected[0]],
      question: ask(metal, 'reflected', [cosI, 0, 0]),
    };
  });

function gltfMaterial({ baseColor: color, metallic: metalness, roughness, ior }: GltfEntry) {
  const bsdf = bsdfOf({ color, metalness, ior });
  // Only the shader's numbers are f32.
  const straight = ((ior - 1) / (ior + 1)) ** 2;
  return { ...bsdf, alpha: roughness * roughness, f0: [straight, straight, straight] as const };
}

const gltfCases = (entries: readonly GltfEntry[]): readonly BsdfCase[] =>
  entries.map((entry) => {
    const [bsdf, wo, wi] = [gltfMaterial(entry), normalize(entry.V), normalize(entry.L)];
    return {
      right: entry.mix_sep,
      cond: entry.cond,
      reference: () => scale(bsdfValue(bsdf, wo, wi).value, 1 / entry.NoL),
      question: ask(bsdf, 'value', wo, wi, 1 / entry.NoL),
    };
  });

/** The densities of both lobes are the truth's; how often each is drawn from is a matter of taste, so taken as it is. */
const gltfPdfCases = (entries: readonly GltfEntry[]): readonly BsdfCase[] =>
  entries.map((entry) => {
    const [bsdf, wo, wi] = [gltfMaterial(entry), normalize(entry.V), normalize(entry.L)];
    const facets = facetProbability(bsdf, wo[2]);
    return {
      right: [facets * entry.pdfVndf + (1 - facets) * entry.pdfCos],
      cond: entry.cond,
      reference: () => [bsdfValue(bsdf, wo, wi).pdf],
      question: ask(bsdf, 'pdf', wo, wi),
    };
  });

/** The tables, with the files that they are in. */
export const bsdfTables: {
  readonly [table: string]: {
    readonly file: string;
    readonly casesOf: (entries: readonly never[]) => readonly BsdfCase[];
  };
} = {
  'path fresnel': { file: 'fresnel', casesOf: fresnelCases },
  'path ggx_d': { file: 'ggx_d', casesOf: ggxCases },
  'path smith_g': { file: 'smith_g', casesOf: smithCases },
  'path schlick': { file: 'schlick', casesOf: schlickCases },
  'path gltf': { file: 'gltf', casesOf: gltfCases },
  'path gltf pdf': { file: 'gltf', casesOf: gltfPdfCases },
};
