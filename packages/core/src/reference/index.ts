/** `@ray-scene/core/reference`: the f64 tracer. */
export { illConditioned, relativeDifference } from './conditioning.ts';
export { type Intersection, intersect } from './intersect.ts';
export { type ReferenceImage, type ReferenceSettings, renderReference } from './render.ts';
