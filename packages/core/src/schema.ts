/**
 * THE table: every node of a scene, every field of it, with its meaning, default, range, and the shader features that
 * its values switch on. Types, validation, JSON Schema, attributes and the reference docs all come from here.
 */
import { choice, color, type Fields, factors, name, number, type Values, vector } from './fields.ts';
import type { primitives, ShapeKind } from './primitives/index.ts';
import type { Vec3 } from './vector.ts';

/** A kind of node: its fields, and what must hold between them. */
export interface NodeTable<F extends Fields = Fields> {
  readonly doc: string;
  readonly fields: F;
  /** The lists of other nodes in it. */
  readonly holds?: readonly ('lights' | 'objects')[];
}

export const camera = {
  doc: 'Where the picture is taken from.',
  fields: {
    type: choice('Kind of projection.', ['perspective', 'orthographic'], { default: 'perspective' }),
    position: vector('Where the camera stands; default: where it sees all objects.'),
    target: vector(
      'What it looks at; default: the middle of the objects if it has no position either, else the origin.',
    ),
    up: vector('The direction that is up in the picture.', { default: [0, 1, 0], nonzero: true }),
    fov: number('Vertical field of view, in degrees.', { default: 45, min: 1e-6, max: 179 }),
    height: number('Height of an orthographic view; default: what fov shows at the target.', { above: 0 }),
    aperture: number('Radius of the lens; 0: a pinhole, which has everything in focus.', { default: 0, min: 0 }),
    focusDistance: number('How far ahead the plane in focus is; default: as far as the target.', { above: 0 }),
  },
} satisfies NodeTable;

const lightName = name("The author's name for it.");
const lightColor = color('Colour of the light.', { default: [1, 1, 1], light: true });
const lightDirection = vector('Direction in which the light travels; default: from position to target, or down.', {
  nonzero: true,
});
const candela = number('Radiant intensity (candela).', { default: 1, min: 0 });
const decay = choice('How it fades with distance: 2 as light does, 0 not at all.', [2, 0], {
  default: 2,
  switches: { falloff: (decay) => decay === 2, noFalloff: (decay) => decay === 0 },
});
const lightRadius = number('Radius of the ball that shines; 0: a point, which nobody sees.', { default: 0, min: 0 });

export const lights = {
  point: {
    doc: 'Light from one point, the same in all directions.',
    fields: {
      name: lightName,
      position: vector('Where it is.', { default: [0, 1, 0] }),
      color: lightColor,
      intensity: candela,
      decay,
      radius: lightRadius,
    },
  },
  spot: {
    doc: 'Light from one point into a cone.',
    fields: {
      name: lightName,
      position: vector('Where it is.', { default: [0, 1, 0] }),
      target: vector('What its axis goes through; default: the origin.'),
      direction: vector('Direction of its axis, in place of the target.', { nonzero: true }),
      color: lightColor,
      intensity: candela,
      angle: number('Angle between the axis and the edge of the cone, in degrees.', {
        default: 45,
        above: 0,
        max: 180,
      }),
      penumbra: number('Share of that angle over which light fades towards the edge.', { default: 0, min: 0, max: 1 }),
      decay,
      radius: lightRadius,
    },
  },
  directional: {
    doc: 'Parallel light from far away.',
    fields: {
      name: lightName,
      direction: lightDirection,
      position: vector('With target, another way to say the direction.'),
      target: vector('What light from the position travels towards; default: the origin.'),
      color: lightColor,
      intensity: number('Irradiance on a surface that faces it (lux).', { default: 1, min: 0 }),
      angularDiameter: number('How large it is in the sky, in degrees; 0: a point. The Sun has 0.53.', {
        default: 0,
        min: 0,
        max: 180,
      }),
    },
  },
} satisfies { readonly [kind: string]: NodeTable };

export const environment = {
  doc: 'Light from all around, infinitely far away.',
  fields: {
    color: color('Radiance, the same from everywhere.', { light: true }),
    top: color('Radiance from straight above (+y); with bottom, a gradient linear in the height.', { light: true }),
    bottom: color('Radiance from straight below.', { light: true }),
    src: name('Address of an equirectangular .hdr image, in place of colours; oriented as in three.js.', 'an address'),
    intensity: number('Factor on the radiance.', { default: 1, min: 0 }),
    rotation: number('Turns an image about +y, counterclockwise from above, in degrees.', { default: 0 }),
  },
} satisfies NodeTable;

const isGrey = ([r, g, b]: Vec3): boolean => r === g && g === b;

export const material = {
  doc: 'How a surface scatters light: metallic-roughness as in glTF 2.0.',
  fields: {
    color: color('Base colour: albedo of a dielectric, reflectance of a metal.', { default: [1, 1, 1] }),
    metalness: number('0 a dielectric, 1 a metal, between: a mix of both.', {
      default: 0,
      min: 0,
      max: 1,
      switches: { metal: (metalness) => metalness > 0, dielectric: (metalness) => metalness < 1 },
    }),
    roughness: number('0 a mirror, 1 dull; GGX with alpha = roughness².', { default: 0.5, min: 0, max: 1 }),
    ior: number('Index of refraction: reflectance of a dielectric seen straight on = ((ior - 1) / (ior + 1))².', {
      default: 1.5,
      min: 1,
      max: 100,
    }),
    specular: number('Factor on the reflection of a dielectric.', {
      default: 1,
      min: 0,
      max: 1,
      switches: { specular: (specular) => specular > 0, specularWeight: (specular) => specular < 1 },
    }),
    specularColor: color('Tints the straight-on reflection of a dielectric.', {
      default: [1, 1, 1],
      switches: { specularTint: (tint) => !isGrey(tint) },
    }),
    transmission: number('Share of the light under the surface that goes on into it: 1 for glass and water.', {
      default: 0,
      min: 0,
      max: 1,
      switches: { transmission: (share) => share > 0 },
    }),
    attenuationColor: color('What white light turns into on its way through attenuationDistance of the inside.', {
      default: [1, 1, 1],
    }),
    attenuationDistance: number('How far that way is; default: nothing is lost.', { above: 0 }),
    emission: color('Radiance that the surface sends out by itself.', { default: [0, 0, 0], light: true }),
    emissionIntensity: number('Factor on the emission.', { default: 1, min: 0 }),
    emissionSide: choice('Side that shines: front is where the outward normal points.', ['front', 'back', 'both'], {
      default: 'front',
    }),
    checker: color('Second colour, of the cells where floor(U / size) + floor(V / size) is odd.'),
    checkerSize: number('Side of a cell, measured along the surface; of an image on a plane.', {
      default: 1,
      above: 0,
    }),
    map: name('Address of an image over the whole surface, sRGB, that the base colour is multiplied by.', 'an address'),
  },
} satisfies NodeTable;

/** Fields that every object takes besides those of its shape and its own material. */
export const objectFields = {
  name: name("The author's name for it."),
  material: name('Name of a material; fields of the object itself go before those of the material.'),
} satisfies Fields;

/** Stands among the objects, and may hold groups itself. */
export const group = {
  doc: 'Objects and lights that are scaled, turned and moved together, in this order. They say where they are in its space.',
  fields: {
    name: objectFields.name,
    position: vector('Where its origin is.', { default: [0, 0, 0] }),
    rotation: vector('Angles in degrees: about its x axis, then its own y axis, then its own z axis.', {
      default: [0, 0, 0],
    }),
    scale: factors('Factor along each of its axes, or one for all; below 0 it mirrors.', { default: [1, 1, 1] }),
  },
  holds: ['lights', 'objects'],
} as const satisfies NodeTable;

type LightOf<K extends LightKind> = { readonly type: K } & Values<(typeof lights)[K]['fields']>;
type ObjectOf<K extends ShapeKind> = { readonly type: K } & Values<(typeof primitives)[K]['fields']> &
  Values<typeof objectFields> &
  Partial<Material>;

export type LightKind = keyof typeof lights;
export const lightKinds = Object.keys(lights) as readonly LightKind[];
export const lightType = choice('Kind of light.', lightKinds, { default: 'point' });

export type Camera = Values<typeof camera.fields>;
export type Light = { [K in LightKind]: LightOf<K> }[LightKind];
export type Environment = Values<typeof environment.fields>;
export type Material = Values<typeof material.fields>;
export type SceneObject = { [K in ShapeKind]: ObjectOf<K> }[ShapeKind];
export type Group = { readonly type: 'group'; readonly lights: readonly Light[] } & Values<typeof group.fields> & {
    readonly objects: readonly SceneNode[];
  };
/** What stands in a list of objects. */
export type SceneNode = SceneObject | Group;
/** The shape of an object of one kind. */
export type Shape<K extends ShapeKind> = { readonly type: K } & Values<(typeof primitives)[K]['fields']>;
/** What a camera ray shows that meets no object: a linear colour, the environment, or nothing. */
export type Background = Vec3 | 'environment' | 'transparent';

/** A validated scene. Every number is finite and in its range, every colour linear, every default filled in. */
export interface Scene {
  readonly version: 1;
  readonly name?: string;
  readonly camera?: Camera;
  readonly environment?: Environment;
  readonly background?: Background;
  readonly lights: readonly Light[];
  readonly materials: { readonly [name: string]: Partial<Material> };
  readonly objects: readonly SceneNode[];
  readonly extras?: unknown;
}
