/** The names of all features. Programs know them as types; tests and tools go through the list. */
import { shapeKinds } from './primitives/index.ts';

/** Everything that a shader may or may not hold. In GLSL, each is a name to ask for by `#if`. */
export const features = [
  'metal',
  'dielectric',
  'specular',
  'specularTint',
  'specularWeight',
  'falloff',
  'noFalloff',
  ...shapeKinds.map((kind) => `${kind}Checker` as const),
  ...shapeKinds.map((kind) => `${kind}Map` as const),
  'tiltedPlane',
  'turnedChecker',
  // Derived from the whole scene:
  'mixedFalloff',
  'checker',
  'map',
  'reflective',
  'highlights',
  'reflections',
  'shadows',
  'inside',
  'closeSphere',
  // Rays pass through surfaces: they start on any side of what they meet.
  'through',
  // The integrator `path`, or what `direct` becomes where light is more than points and surfaces more than mirrors:
  'path',
  'whitted',
  // All pixels have a sample at the same place, where paths have places of their own.
  'sharedPlace',
  'rough',
  'smooth',
  'transmission',
  'opaqueBase',
  'thin',
  'solid',
  'nested',
  'attenuation',
  'emissive',
  'sides',
  'roulette',
  'clamp',
  // What is shown of the first surface, in place of its light:
  'normal',
  'depth',
  'albedo',
  'lens',
  // Rays start in a plane ahead of the camera: they are parallel, or nearly.
  'distant',
  // What can be asked for light:
  'pointEmitter',
  'spotEmitter',
  'directionalEmitter',
  'sunEmitter',
  'sphereEmitter',
  'quadEmitter',
  'discEmitter',
  'triangleEmitter',
  'boxEmitter',
  'cylinderEmitter',
  'imageEmitter',
  'severalEmitters',
  // Balls with a narrow lobe that throw the light of lamps without extent on other things.
  'glint',
  'secondGlint',
  'thirdGlint',
  'fourthGlint',
  // One that a ray may meet by chance, too.
  'areaEmitter',
  // One that does not fade with distance; a ball that shines as a spotlight does; a solid that shines inwards; one in a
  // space of its own.
  'steadyEmitter',
  'aimedBall',
  'innerEmitter',
  'placedEmitter',
  'wideRange',
  'indexed',
  // Camera rays keep the digits that a horizon needs.
  'exactRays',
  'environment',
  'gradient',
  'backgroundColor',
  'backgroundEnvironment',
  'backgroundImage',
] as const;

export type Feature = (typeof features)[number];
