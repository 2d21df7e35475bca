/** The materials of the neutral description as ours. */
import { indexInside } from './interfaces.ts';
import type { NeutralMaterial, NeutralObject, NeutralScene } from './neutral-scene.ts';
import { given, Untranslatable } from './untranslatable.ts';

const materials: { readonly [type: string]: (material: NeutralMaterial) => object } = {
  lambert: (material) => ({ color: given(material, 'albedo').albedo, roughness: 1, specular: 0 }),
  mirror: (material) => ({ ...metal(material), roughness: 0 }),
  ggxConductor: (material) => ({ ...metal(material), roughness: roughness(material) }),
  dielectric: () => ({ ...glass, roughness: 0 }),
  roughDielectric: (material) => ({ ...glass, roughness: roughness(material) }),
};

const roughness = (material: NeutralMaterial): number => Math.sqrt(given(material, 'alpha').alpha);

/** Theirs reflects the same share at every angle. With Schlick's approximation that is so of white alone. */
function metal({ reflectance = [1, 1, 1] }: NeutralMaterial): object {
  if (reflectance.some((channel) => channel !== 1)) {
    throw new Untranslatable('there is no metal whose reflectance is below 1 and the same at every angle');
  }
  return { color: reflectance, metalness: 1 };
}

/** Its index depends on what is around the object. */
const glass = { color: [1, 1, 1], transmission: 1 };

export function materialOf(object: NeutralObject, scene: NeutralScene): object {
  const material = scene.materials[object.material];
  const translate = material && Object.hasOwn(materials, material.type) ? materials[material.type] : undefined;
  if (!material || !translate) throw new Untranslatable(`there is no material ${material?.type ?? object.material}`);
  return {
    ...(material.checker ? checkered(object, material.checker) : translate(material)),
    ...(material.iorInside === undefined ? {} : { ior: indexInside(object, scene) }),
    ...emissionOf(object),
  };
}

/** Theirs counts cells along +x and -z from the corner, ours along the edges; which of these is called U does not matter. */
function checkered(
  { shape, edgeU = [0, 0, 0], edgeV = [0, 0, 0] }: NeutralObject,
  { cell, color0, color1 }: NonNullable<NeutralMaterial['checker']>,
): object {
  const edges = [edgeU, edgeV];
  const alongX = edges.find(([, y, z]) => y === 0 && z === 0);
  const alongZ = edges.find(([x, y]) => x === 0 && y === 0);
  if (shape !== 'rectangle' || !alongX || !alongZ) throw new Untranslatable(`there is no such checker on a ${shape}`);
  // Counted the other way, the first cell is number -1.
  const turned = alongX[0] < 0 !== alongZ[2] > 0;
  const [color, checker] = turned ? [color1, color0] : [color0, color1];
  return { color, checker, checkerSize: cell, roughness: 1, specular: 0 };
}

const sides: { readonly [side: string]: string } = {
  outside: 'front',
  front: 'front',
  inside: 'back',
  back: 'back',
  both: 'both',
};

function emissionOf({ emission, emissionSide = 'outside' }: NeutralObject): object {
  if (!emission) return {};
  if (!sides[emissionSide]) throw new Untranslatable(`there is no emission on the side ${emissionSide}`);
  return { emission, emissionSide: sides[emissionSide] };
}
