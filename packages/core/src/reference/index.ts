/** `@ray-scene/core/reference`: the f64 tracer. */
import { builtInMaterials } from '../built-in-materials.ts';
import { registerMaterials } from '../named-materials.ts';

export { illConditioned, relativeDifference } from './conditioning.ts';
export { type Intersection, intersect } from './intersect.ts';
export { type ReferenceImage, type ReferenceSettings, renderReference } from './render.ts';

// Scenes may have been read elsewhere.
registerMaterials(builtInMaterials);
