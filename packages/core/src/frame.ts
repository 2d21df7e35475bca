/** The space that a scene is packed in: relative to the camera, in units that make the largest length about 1. */
import { subtract, scale as times, type Vec3 } from './vector.ts';

export interface Frame {
  /** The camera's position or, for one that is far away, the point where its axis gets near: see `rayStart`. */
  readonly origin: Vec3;
  /** An exact power of two: packed length = scale × scene length. */
  readonly scale: number;
}

/** A position in the frame, in f64. */
export const toFrame = (frame: Frame, position: Vec3): Vec3 => times(subtract(position, frame.origin), frame.scale);

const bits = new DataView(new ArrayBuffer(8));

/** The largest power of two that is not above a positive normal f64 number, exactly. */
export function powerOfTwoBelow(value: number): number {
  bits.setFloat64(0, value);
  bits.setBigUint64(0, bits.getBigUint64(0) & 0x7ff0000000000000n);
  return bits.getFloat64(0);
}
