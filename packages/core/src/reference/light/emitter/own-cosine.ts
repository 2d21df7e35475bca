/** Twin of shaders/light/emitter/own-cosine.glsl: the cosine of a unit direction with the normal where it met an emitter. */
import type { Emitter, EmitterOf } from '../../../emitters.ts';
import { planeAxes } from '../../../primitives/plane.ts';
import { quadNormal } from '../../../primitives/quad-shape.ts';
import { triangleNormal } from '../../../primitives/triangle-shape.ts';
import { addScaled, dot, length, normalize, scale, subtract, type Vec3 } from '../../../vector.ts';

/** Of kinds whose pdf does not ask for it, 1. */
export function ownCosine(emitter: Emitter, point: Vec3, d: Vec3): number {
  switch (emitter.kind) {
    case 'quad':
      return dot(quadNormal(emitter), d);
    case 'disc':
      return dot(planeAxes(emitter).normal, d);
    case 'triangle':
      return dot(triangleNormal(emitter), d);
    case 'box':
      return boxCosine(emitter, subtract(point, emitter.center), d);
    case 'cylinder':
      return cylinderCosine(emitter, subtract(point, emitter.base), d);
    default:
      return 1;
  }
}

function boxCosine({ size }: EmitterOf<'box'>, q: Vec3, d: Vec3): number {
  const half = scale(size, 0.5);
  const beyond = q.map((x, i) => Math.abs(x) - (half[i] as number));
  return d[beyond.indexOf(Math.max(...beyond))] as number;
}

function cylinderCosine({ base, top, radius }: EmitterOf<'cylinder'>, q: Vec3, d: Vec3): number {
  const axis = normalize(subtract(top, base));
  const height = dot(axis, q);
  const outwards = addScaled(q, axis, -height);
  const away = length(outwards);
  const isCap = Math.max(-height, height - length(subtract(top, base))) > away - radius;
  return isCap ? dot(axis, d) : dot(outwards, d) / away;
}
