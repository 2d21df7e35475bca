/**
 * The reflectances of `data/brdf` (data/README.md, section 2) as questions to functions of the project. Those have the
 * lobe as a product, so the factor that is not asked for is 1 or taken out by its formula here, in f64. See bsdf-tables.ts
 * for the functions of paths.
 */
import { parseScene, resolveScene, type Vec3 } from '@ray-scene/core';
import {
  fresnel,
  ggxLobe,
  scattered,
  schlickWeight,
} from '../../packages/core/src/reference/material/metallic-roughness.ts';
import type { Surface } from '../../packages/core/src/reference/surface.ts';
import { negate, normalize, scale } from '../../packages/core/src/vector.ts';

/** What the GPU is asked: a call of the shader of a scene. */
export interface BrdfQuestion {
  readonly scene: object;
  readonly camera: Vec3;
  readonly call: keyof typeof calls;
  readonly numbers: Vec3;
  readonly vector: Vec3;
  /** What the answer is to be multiplied by. */
  readonly factor: number;
}

/** GLSL that answers. */
export const calls = {
  lobe: 'answer = vec4(ggxLobe(numbers.x, vec3(0.0, 0.0, 1.0), vector, numbers.y, numbers.z))',
  schlick:
    'Material m = loadParts().material0; m.color = vector; answer = vec4(fresnel(m, schlickWeight(numbers.x)), 1.0)',
  scene: 'answer = direct(vector)',
} as const;

/** One entry of a table. */
export interface BrdfCase<Q = BrdfQuestion> {
  readonly right: readonly number[];
  readonly cond: number;
  readonly reference: () => readonly number[];
  readonly question: Q;
}

const UP: Vec3 = [0, 0, 1];

/** A floor seen from v and lit from l. */
const lit = (material: object, v: Vec3, l: Vec3) => ({
  scene: {
    lights: [{ type: 'directional', direction: negate(l), intensity: 1 }],
    objects: [{ type: 'plane', normal: UP, ...material }],
    background: 'transparent',
  },
  camera: v,
});

const METAL = lit({ metalness: 1, roughness: 0.5, color: [0.5, 0.5, 0.5] }, UP, UP);

/** cos + √(alpha² + (1 - alpha²) cos²): 2 cos / G1 of Smith. */
const smith = (alpha: number, cosine: number): number =>
  cosine + Math.sqrt(alpha * alpha + (1 - alpha * alpha) * cosine * cosine);

export interface GgxEntry {
  readonly alpha: number;
  readonly cosH: number;
  readonly D: number;
  readonly cond: number;
}

/** Both directions along the half vector: the lobe is D / smith². */
function ggxCase({ alpha, cosH, D, cond }: GgxEntry): BrdfCase {
  const h: Vec3 = [Math.sqrt((1 - cosH) * (1 + cosH)), 0, cosH];
  const visibility = smith(alpha, cosH) ** -2;
  return {
    right: [D],
    cond,
    reference: () => [ggxLobe(alpha, UP, h, h) / visibility],
    question: {
      ...METAL,
      call: 'lobe',
      numbers: [alpha * alpha, cosH, cosH],
      vector: scale(h, 2),
      factor: 1 / (Math.PI * visibility),
    },
  };
}

export interface SmithEntry {
  readonly alpha: number;
  readonly NoL: number;
  readonly NoV: number;
  readonly G1L: number;
  readonly G1V: number;
  readonly Vsep: number;
  readonly cond: number;
}

/** Whatever the half vector is, the formulas allow it; what D is for it, is taken out. */
function smithCase({ alpha, NoL, NoV, Vsep, cond }: SmithEntry): BrdfCase {
  const alpha2 = alpha * alpha;
  const along = Math.fround(NoL + NoV);
  const [across2, h2] = [1, 1 + along * along];
  return {
    right: [Vsep],
    cond,
    // Along the normal, where D is 1 / (pi alpha²).
    reference: () => [ggxLobe(alpha, UP, scale(UP, NoV), scale(UP, NoL)) * Math.PI * alpha2],
    // Aside, where no square is too small for f32.
    question: {
      ...METAL,
      call: 'lobe',
      numbers: [alpha2, NoL, NoV],
      vector: [1, 0, along],
      factor: (across2 + alpha2 * along * along) ** 2 / (alpha2 * h2 * h2),
    },
  };
}

export interface SchlickEntry {
  readonly cosI: number;
  readonly f0: number;
  readonly F: number;
  /** Null where F is 0. */
  readonly cond: number | null;
}

/** A metal of the colour f0. */
function schlickCase({ cosI, f0, F, cond }: SchlickEntry): BrdfCase {
  const color: Vec3 = [f0, f0, f0];
  return {
    right: [F],
    cond: cond ?? 0,
    reference: () => [fresnel(surface({ metalness: 1, color }), schlickWeight(cosI))[0]],
    question: { ...METAL, call: 'schlick', numbers: [cosI, 0, 0], vector: color, factor: 1 },
  };
}

export interface GltfEntry {
  readonly baseColor: Vec3;
  readonly metallic: number;
  readonly roughness: number;
  readonly ior: number;
  readonly V: Vec3;
  readonly L: Vec3;
  readonly NoL: number;
  readonly mix_sep: Vec3;
  readonly pdfVndf: number;
  readonly pdfCos: number;
  readonly cond: number;
}

/** On the GPU, a whole picture of one pixel. */
function gltfCase({
  baseColor: color,
  metallic: metalness,
  roughness,
  ior,
  V,
  L,
  NoL,
  mix_sep,
  cond,
}: GltfEntry): BrdfCase {
  const material = { color, metalness, roughness, ior };
  const [v, l] = [normalize(V), normalize(L)];
  return {
    right: mix_sep,
    cond,
    reference: () => scale(scattered(surface(material), v, l), 1 / NoL),
    question: { ...lit(material, v, l), call: 'scene', numbers: [0, 0, 0], vector: negate(v), factor: 1 / NoL },
  };
}

function surface(fields: object): Surface {
  const material = resolveScene(parseScene({ objects: [{ type: 'plane', ...fields }] })).materials[0];
  if (!material) throw new Error('the plane has no material');
  return { object: 0, position: [0, 0, 0], normal: UP, front: true, color: material.color, material };
}

/** By the file's name. */
export const brdfTables: { readonly [table: string]: (entry: never) => BrdfCase } = {
  ggx_d: ggxCase,
  smith_g: smithCase,
  schlick: schlickCase,
  gltf: gltfCase,
};

/** The furnace is an integral, which test/unit/bsdf.test.ts compares by quadrature. */
export const skippedTables = ['furnace'];

/** The largest error of the channels, relative and in units of the conditioning; NaN counts as endless. */
export function brdfError(
  values: readonly number[],
  { right, cond }: BrdfCase<unknown>,
  side: 'reference' | 'gpu',
): number {
  const unit = side === 'gpu' ? Math.max(cond, 2 ** -24) : Math.max(cond * 2 ** -29, 2 ** -53);
  const errors = right.map((value, i) => {
    const off = Math.abs((values[i] as number) - value);
    return off === 0 ? 0 : off / Math.abs(value) / unit;
  });
  return errors.some(Number.isNaN) ? Number.POSITIVE_INFINITY : Math.max(...errors);
}
