/** What scenes need that hold other shapes than spheres and planes, or many of them. Importing this makes it known. */
import discGlsl from '../../../shaders/shape/disc.glsl';
import quadGlsl from '../../../shaders/shape/quad.glsl';
import triangleGlsl from '../../../shaders/shape/triangle.glsl';
import { indexedObjects } from './indexed-objects.ts';
import { registerParts } from './parts.ts';
import { disc } from './primitives/disc-shape.ts';
import { quad } from './primitives/quad-shape.ts';
import { triangle } from './primitives/triangle-shape.ts';

const moreShapes = {
  disc: { primitive: disc, glsl: discGlsl },
  quad: { primitive: quad, glsl: quadGlsl },
  triangle: { primitive: triangle, glsl: triangleGlsl },
} as const;

registerParts(moreShapes, indexedObjects);

/** The kinds that are known from here on. */
export const moreKinds: readonly string[] = Object.keys(moreShapes);
