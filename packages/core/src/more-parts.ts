/** What scenes need that hold other shapes than spheres and planes, or many of them. Importing this makes it known. */
import arcTangent from '../../../shaders/arc-tangent.glsl';
import directionalLight from '../../../shaders/light/directional.glsl';
import environment from '../../../shaders/light/environment.glsl';
import boxGlsl from '../../../shaders/shape/box.glsl';
import coneGlsl from '../../../shaders/shape/cone.glsl';
import convexGlsl from '../../../shaders/shape/convex.glsl';
import cylinderGlsl from '../../../shaders/shape/cylinder.glsl';
import discGlsl from '../../../shaders/shape/disc.glsl';
import placedGlsl from '../../../shaders/shape/placed.glsl';
import planeThrough from '../../../shaders/shape/plane-through.glsl';
import planeTilted from '../../../shaders/shape/plane-tilted.glsl';
import quadGlsl from '../../../shaders/shape/quad.glsl';
import sphereCells from '../../../shaders/shape/sphere-cells.glsl';
import sphereClose from '../../../shaders/shape/sphere-close.glsl';
import sphereInside from '../../../shaders/shape/sphere-inside.glsl';
import sphereThrough from '../../../shaders/shape/sphere-through.glsl';
import sphereWide from '../../../shaders/shape/sphere-wide.glsl';
import torusGlsl from '../../../shaders/shape/torus.glsl';
import torusQuarticGlsl from '../../../shaders/shape/torus-quartic.glsl';
import triangleGlsl from '../../../shaders/shape/triangle.glsl';
import splitDot from '../../../shaders/split-dot.glsl';
import varyingsVertex from '../../../shaders/varyings.vert.glsl';
import { flattenGroups } from './flatten-groups.ts';
import { indexedObjects } from './indexed-objects.ts';
import { registerParts } from './parts.ts';
import * as placed from './placed-shape.ts';
import { anyPlane } from './primitives/any-plane.ts';
import { anySphere } from './primitives/any-sphere.ts';
import { box } from './primitives/box-shape.ts';
import { cone } from './primitives/cone-shape.ts';
import { cylinder } from './primitives/cylinder-shape.ts';
import { disc } from './primitives/disc-shape.ts';
import { quad } from './primitives/quad-shape.ts';
import { torus } from './primitives/torus-shape.ts';
import { triangle } from './primitives/triangle-shape.ts';
import { structFromRows, varyingRows } from './varying-rows.ts';
import { wholeFiles } from './whole-files.ts';

const shapes = {
  sphere: anySphere,
  plane: anyPlane,
  disc,
  quad,
  box,
  cylinder,
  cone,
  torus,
  triangle,
} as const;

registerParts({
  shapes,
  files: {
    ...wholeFiles,
    'arc-tangent.glsl': arcTangent,
    'light/directional.glsl': directionalLight,
    'light/environment.glsl': environment,
    'shape/box.glsl': boxGlsl,
    'shape/cone.glsl': coneGlsl,
    'shape/convex.glsl': convexGlsl,
    'shape/cylinder.glsl': cylinderGlsl,
    'shape/disc.glsl': discGlsl,
    'shape/placed.glsl': placedGlsl,
    'shape/plane-through.glsl': planeThrough,
    'shape/plane-tilted.glsl': planeTilted,
    'shape/quad.glsl': quadGlsl,
    'shape/sphere-cells.glsl': sphereCells,
    'shape/sphere-close.glsl': sphereClose,
    'shape/sphere-inside.glsl': sphereInside,
    'shape/sphere-through.glsl': sphereThrough,
    'shape/sphere-wide.glsl': sphereWide,
    'shape/torus-quartic.glsl': torusQuarticGlsl,
    'shape/torus.glsl': torusGlsl,
    'shape/triangle.glsl': triangleGlsl,
    'split-dot.glsl': splitDot,
    'varyings.vert.glsl': varyingsVertex,
  },
  indexedObjects,
  flattenGroups,
  placed,
  rows: { varyingRows, structFromRows },
});

/** The kinds that are known from here on. */
export const moreKinds: readonly string[] = Object.keys(shapes);
