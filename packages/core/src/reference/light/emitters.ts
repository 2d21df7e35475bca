import type { Vec3 } from '../../vector.ts';
export interface EmitterSample {
  direction: Vec3;
  distance: number;
  radiance: Vec3;
  pdf: number;
  delta: boolean;
  object: number | undefined;
}
export const sampleEmitter = (..._: unknown[]): EmitterSample | undefined => undefined;
export const emitterPdf = (..._: unknown[]): number => 0;
