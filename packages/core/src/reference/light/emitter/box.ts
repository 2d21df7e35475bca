/** Twin of shaders/light/emitter/box.glsl. */
import type { EmitterOf } from '../../../emitters.ts';
import { scale, subtract, type Vec3 } from '../../../vector.ts';
import { areaPdf, areaSample } from './area.ts';
import { aroundDirection, insidePdf, insideSample } from './inside.ts';
import type { EmitterSample } from './sample.ts';

/** From outside, points of the faces that are seen, all equally likely; from inside, all directions are. */
export function boxSample(
  box: EmitterOf<'box'>,
  p: Vec3,
  u: readonly [number, number],
  own: boolean,
): EmitterSample | undefined {
  const half = scale(box.size, 0.5);
  const c = subtract(box.center, p);
  const areas = seenAreas(c, half);
  const area = areas[0] + areas[1] + areas[2];
  if (own || area === 0) {
    const direction = aroundDirection(u);
    return insideSample(box, direction, boxExit(c, half, direction, own));
  }
  let place = u[0] * area;
  let axis = 0;
  while (axis < 2 && place >= (areas[axis] as number)) place -= areas[axis++] as number;
  if (areas[axis] === 0) return undefined;
  const [v, w] = [2 * (place / (areas[axis] as number)) - 1, 2 * u[1] - 1];
  const [a, b] = [(axis + 1) % 3, (axis + 2) % 3];
  const way = [...c] as [number, number, number];
  const height = Math.abs(c[axis] as number) - (half[axis] as number);
  way[axis] = (c[axis] as number) < 0 ? -height : height;
  way[a] = (c[a] as number) + (half[a] as number) * v;
  way[b] = (c[b] as number) + (half[b] as number) * w;
  return areaSample(box, way, height, area, true);
}

export function boxPdf(box: EmitterOf<'box'>, from: Vec3, t: number, cosine: number, own: boolean): number {
  const areas = seenAreas(subtract(box.center, from), scale(box.size, 0.5));
  const area = areas[0] + areas[1] + areas[2];
  return own || area === 0 ? insidePdf(box) : areaPdf(t, cosine, area);
}

/** The area of the face across x that is seen from a point, and of those across y and z; c: the way to the middle. */
function seenAreas(c: Vec3, half: Vec3): Vec3 {
  const seen = (i: 0 | 1 | 2, area: number): number => (Math.abs(c[i]) > half[i] ? 4 * area : 0);
  return [seen(0, half[1] * half[2]), seen(1, half[2] * half[0]), seen(2, half[0] * half[1])];
}

/** How far the surface is from a point inside; 0 for directions out of the face that the point is on. */
function boxExit(c: Vec3, half: Vec3, direction: Vec3, own: boolean): number {
  const ends = c.map((x, i) => {
    const d = direction[i] as number;
    return d === 0 ? Number.POSITIVE_INFINITY : (x + (d < 0 ? -(half[i] as number) : (half[i] as number))) / d;
  });
  const depths = c.map((x, i) => Math.abs(Math.abs(x) - (half[i] as number)));
  const face = depths.indexOf(Math.min(...depths));
  const leaves = (c[face] as number) * (direction[face] as number) < 0;
  return own && leaves ? 0 : Math.min(...ends);
}
