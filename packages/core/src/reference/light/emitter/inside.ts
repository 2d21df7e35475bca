/** Twin of shaders/light/emitter/inside.glsl: a closed surface around a point, in all directions equally likely. */
import type { EmitterOf } from '../../../emitters.ts';
import type { Vec3 } from '../../../vector.ts';
import { circle } from '../../circle.ts';
import type { EmitterSample } from './sample.ts';

const AROUND_PDF = 1 / (4 * Math.PI);

/** A unit vector. */
export function aroundDirection(u: readonly [number, number]): Vec3 {
  const [x, y] = circle(u[1]);
  const away = 2 * Math.sqrt(u[0] * (1 - u[0]));
  return [away * x, away * y, 1 - 2 * u[0]];
}

type Solid = EmitterOf<'sphere' | 'box' | 'cylinder'>;

/** The light from the inner side of a surface that is `distance` away; from a point on it, some directions lead outside. */
export function insideSample(
  emitter: Solid,
  direction: Vec3,
  distance: number,
  pdf = AROUND_PDF,
): EmitterSample | undefined {
  if (emitter.side === 'front') return undefined;
  return {
    direction,
    distance: Math.max(distance, 0),
    radiance: distance > 0 ? emitter.radiance : [0, 0, 0],
    pdf,
    delta: false,
    object: emitter.object,
  };
}

export const insidePdf = ({ side }: Solid): number => (side === 'front' ? 0 : AROUND_PDF);
