/**
 * The umbra under a Sun that is a ball of light, where there is no edge to be seen: outside of it the ground gets as much
 * light as the Moon leaves of the Sun's disc, which begins with the power 3/2 of the way from the edge.
 */
import { cameraFrame, parseScene, rayDirection, resolveScene, type Scene, type Vec3 } from '@ray-scene/core';
import { dot, length, subtract } from '../../packages/core/src/vector.ts';
import { EARTH, eclipse, MOON, SUN } from './eclipse.ts';

/** The radius across the axis, on the ground: where the cone that touches Sun and Moon from outside meets the Earth. */
export function umbraRadius(): number {
  const sine = (SUN.radius - MOON.radius) / (SUN.distance - MOON.distance);
  const apex = MOON.distance - MOON.radius / sine;
  const slope = sine / Math.sqrt(1 - sine * sine);
  let radius = 0;
  // Towards the edge the ground falls away by less than a hundredth of what the radius is: this settles at once.
  for (let i = 0; i < 50; i++) radius = (heightOf(radius) - apex) * slope;
  return radius;
}

/** Of the ground, along the axis. */
export const heightOf = (radius: number): number => Math.sqrt(EARTH.radius ** 2 - radius ** 2);

/** Pixels along both sides of the picture. */
export const SIZE = 64;

/** From the edge on, in metres: the rings that are looked at. */
const [FROM, TO, RINGS] = [2e3, 42e3, 10];

const [earth, moon] = eclipse.scene.objects;

/** The ground at the edge of the umbra from 2 million metres above it, 48 km of it. */
const camera = {
  position: eclipse.camera,
  target: [heightOf(umbraRadius()), umbraRadius() + 21e3, 0],
  fov: (2 * Math.atan(24e3 / (eclipse.camera[0] - EARTH.radius)) * 180) / Math.PI,
};

const sun = {
  type: 'point',
  position: [SUN.distance, 0, 0],
  radius: SUN.radius,
  intensity: 3 * SUN.distance ** 2,
} as const;

export const eclipsed: Scene = parseScene({ camera, lights: [sun], objects: [earth, moon] });
export const fullSun: Scene = parseScene({ camera, lights: [sun], objects: [earth] });

/** Where the ground is that a pixel shows, across the axis. */
function groundRadius(pixel: number): number {
  const frame = cameraFrame(resolveScene(eclipsed).camera, SIZE, SIZE);
  const d = rayDirection(frame, (pixel % SIZE) + 0.5, SIZE - Math.floor(pixel / SIZE) - 0.5);
  const toCenter = subtract([0, 0, 0], frame.origin);
  const along = dot(toCenter, d) / dot(d, d);
  const aside = subtract(toCenter, d.map((x) => x * along) as unknown as Vec3);
  const t = along - Math.sqrt((EARTH.radius ** 2 - dot(aside, aside)) / dot(d, d));
  return length([0, frame.origin[1] + t * d[1], frame.origin[2] + t * d[2]]);
}

/** What the Moon leaves of the Sun's disc, seen from the ground. */
function visibleShare(radius: number): number {
  const height = heightOf(radius);
  const a = Math.asin(SUN.radius / Math.hypot(SUN.distance - height, radius));
  const b = Math.asin(MOON.radius / Math.hypot(MOON.distance - height, radius));
  const apart = Math.atan2(radius, MOON.distance - height) - Math.atan2(radius, SUN.distance - height);
  if (apart <= b - a) return 0;
  const [a2, b2, c2] = [a * a, b * b, apart * apart];
  const kite = (a + b - apart) * (apart + a - b) * (apart - a + b) * (apart + a + b);
  const overlap =
    a2 * Math.acos((c2 + a2 - b2) / (2 * apart * a)) +
    b2 * Math.acos((c2 + b2 - a2) / (2 * apart * b)) -
    Math.sqrt(kite) / 2;
  return 1 - overlap / (Math.PI * a2);
}

/**
 * The radius that two pictures tell, RGBA: how far the rings would have to be moved for the light there to be what is left
 * of the Sun by geometry. Its power 2/3 is nearly linear in the radius.
 */
export function measuredRadius(withMoon: ArrayLike<number>, withoutMoon: ArrayLike<number>): number {
  const edge = umbraRadius();
  const rings = Array.from({ length: RINGS }, () => ({ lit: 0, full: 0, expected: 0, radius: 0, pixels: 0 }));
  for (let pixel = 0; pixel < SIZE * SIZE; pixel++) {
    const radius = groundRadius(pixel);
    const ring = rings[Math.floor(((radius - edge - FROM) / (TO - FROM)) * RINGS)];
    if (!ring) continue;
    ring.lit += withMoon[4 * pixel] as number;
    ring.full += withoutMoon[4 * pixel] as number;
    ring.expected += visibleShare(radius);
    ring.radius += radius;
    ring.pixels++;
  }
  const points = rings.map(({ lit, full, expected, radius, pixels }) => ({
    found: (lit / full) ** (2 / 3),
    expected: (expected / pixels) ** (2 / 3),
    radius: radius / pixels,
  }));
  const [first, last] = [points[0], points[RINGS - 1]] as [(typeof points)[0], (typeof points)[0]];
  const perMetre = (last.expected - first.expected) / (last.radius - first.radius);
  const missing = points.reduce((sum, { found, expected }) => sum + expected - found, 0) / RINGS;
  return edge + missing / perMetre;
}
