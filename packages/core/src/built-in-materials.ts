import type { NamedMaterials } from './named-materials.ts';

/**
 * Materials that every scene knows by name; an author's material of the same name goes before these.
 * Metals: linear reflectance at normal incidence from S. Lagarde, "Feeding a physically based shading model" (2011).
 */
export const builtInMaterials: NamedMaterials = {
  mirror: { color: [1, 1, 1], metalness: 1, roughness: 0 },
  gold: { color: [1, 0.766, 0.336], metalness: 1, roughness: 0.2 },
  silver: { color: [0.972, 0.96, 0.915], metalness: 1, roughness: 0.2 },
  copper: { color: [0.955, 0.638, 0.538], metalness: 1, roughness: 0.2 },
  aluminium: { color: [0.913, 0.922, 0.924], metalness: 1, roughness: 0.2 },
  // Indices at 589 nm, 20 °C: fused glass of windows and optics (BK7), water and diamond, M. Polyanskiy, refractiveindex.info.
  glass: { transmission: 1, roughness: 0, ior: 1.5168 },
  water: { transmission: 1, roughness: 0, ior: 1.333 },
  diamond: { transmission: 1, roughness: 0, ior: 2.417 },
  // White gypsum plaster reflects about nine tenths of the light and has hardly any gloss.
  plaster: { color: [0.9, 0.9, 0.9], roughness: 1, specular: 0 },
};
