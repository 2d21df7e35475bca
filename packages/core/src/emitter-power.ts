/** How much of an emitter's light falls on a scene, roughly: what one emitter is chosen by among several. */
import type { BareEmitter, EmittingScene, Profile } from './emitters.ts';
import { primitiveOf } from './parts.ts';
import type { Bounds } from './primitives/primitive.ts';
import { add, addScaled, cross, length, scale, subtract, type Vec3 } from './vector.ts';

interface Ball {
  readonly center: Vec3;
  readonly radius: number;
}

/** The ball around what is to be lit: all objects that have an end and do not shine; without any, around the camera. */
export function litBall({ camera, materials, objects }: EmittingScene): Ball {
  const shines = (index: number): boolean => {
    const material = materials[index];
    return !!material && mean(material.emission) * material.emissionIntensity > 0;
  };
  const bounds = objects
    .filter(({ material }) => !shines(material))
    .map(({ shape }) => primitiveOf(shape).bounds(shape))
    .filter((one) => one !== undefined);
  if (bounds.length === 0) return { center: camera.position, radius: length(subtract(camera.target, camera.position)) };
  const { min, max } = bounds.reduce(
    (a: Bounds, b: Bounds): Bounds => ({ min: each(Math.min, a.min, b.min), max: each(Math.max, a.max, b.max) }),
  );
  return { center: scale(add(min, max), 0.5), radius: length(subtract(max, min)) / 2 };
}

/** The flux on the ball, in the mean of the channels: all of it from nearby, from afar what the ball intercepts. */
export function emitterPower(emitter: BareEmitter, { center, radius }: Ball): number {
  const section = Math.PI * radius * radius;
  switch (emitter.kind) {
    case 'directional':
      return mean(emitter.irradiance) * section;
    case 'sun':
      return mean(emitter.radiance) * Math.PI * emitter.cone * (2 - emitter.cone) * section;
    case 'image':
      return emitter.image.irradiance * emitter.intensity * section;
    case 'point':
      return 4 * Math.PI * mean(emitter.intensity) * share(emitter.position);
    case 'spot':
      return profileAngle(emitter.profile) * mean(emitter.intensity) * share(emitter.position);
    default: {
      const { middle, area } = placedSurface(emitter);
      return Math.PI * mean(emitter.radiance) * area * share(middle);
    }
  }
  function share(position: Vec3): number {
    const away = length(subtract(position, center));
    return away > radius / 2 ? (radius / (2 * away)) ** 2 : 1;
  }
}

const mean = ([r, g, b]: Vec3): number => (r + g + b) / 3;

const each = (choose: (a: number, b: number) => number, a: Vec3, b: Vec3): Vec3 => [
  choose(a[0], b[0]),
  choose(a[1], b[1]),
  choose(a[2], b[2]),
];

/** The solid angle of a cone that ends in the middle of the penumbra. */
const profileAngle = ({ outer, penumbra }: Profile): number =>
  4 * Math.PI * Math.sin((outer * (1 - penumbra / 2)) / 2) ** 2;

/** In the scene; of what a map stretches, roughly how large. */
function placedSurface(emitter: Extract<BareEmitter, { object: number }>): Surface {
  const { middle, area } = surfaceOf(emitter);
  const { place } = emitter;
  return place ? { middle: place.point(middle), area: area * place.meanFactor ** 2 } : { middle, area };
}

interface Surface {
  readonly middle: Vec3;
  readonly area: number;
}

/** Where an object that shines is, and how large its surface is; of what has no inside, both sides count that shine. */
function surfaceOf(emitter: Extract<BareEmitter, { object: number }>): Surface {
  const sides = emitter.side === 'both' ? 2 : 1;
  switch (emitter.kind) {
    case 'sphere': {
      const share = emitter.profile ? profileAngle(emitter.profile) / (4 * Math.PI) : 1;
      return { middle: emitter.center, area: 4 * Math.PI * emitter.radius ** 2 * share };
    }
    case 'quad': {
      const { corner, edgeU, edgeV } = emitter;
      return { middle: addScaled(corner, add(edgeU, edgeV), 0.5), area: sides * length(cross(edgeU, edgeV)) };
    }
    case 'disc':
      return { middle: emitter.center, area: sides * Math.PI * emitter.radius ** 2 };
    case 'triangle': {
      const { a, b, c } = emitter;
      return {
        middle: scale(add(a, add(b, c)), 1 / 3),
        area: (sides / 2) * length(cross(subtract(b, a), subtract(c, a))),
      };
    }
    case 'box': {
      const [x, y, z] = emitter.size;
      return { middle: emitter.center, area: 2 * (x * y + y * z + z * x) };
    }
    case 'cylinder': {
      const { base, top, radius } = emitter;
      const height = length(subtract(top, base));
      return { middle: scale(add(base, top), 0.5), area: 2 * Math.PI * radius * (radius + height) };
    }
  }
}
