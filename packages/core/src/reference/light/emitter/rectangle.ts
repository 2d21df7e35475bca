/** Twin of shaders/light/emitter/rectangle.glsl. */

/** A rectangle across the z axis as it is seen from the origin: its lowest and highest x and y, and how far away it is. */
export interface Rectangle {
  readonly low: readonly [number, number];
  readonly high: readonly [number, number];
  readonly height: number;
}

/**
 * Its solid angle, as that of two triangles, which does not cancel.
 * Source: A. van Oosterom and J. Strackee, IEEE Trans. Biomed. Eng. 30(2), 1983, equation (8).
 */
export function rectangleAngle({ low: [x0, y0], high: [x1, y1], height: z }: Rectangle): number {
  const a = Math.hypot(x0, y0, z);
  const b = Math.hypot(x1, y0, z);
  const c = Math.hypot(x1, y1, z);
  const d = Math.hypot(x0, y1, z);
  const volume = z * (x1 - x0) * (y1 - y0);
  const [ab, bc] = [x0 * x1 + y0 * y0 + z * z, x1 * x1 + y0 * y1 + z * z];
  const [cd, da] = [x0 * x1 + y1 * y1 + z * z, x0 * x0 + y0 * y1 + z * z];
  const ac = x0 * x1 + y0 * y1 + z * z;
  const first = Math.atan2(volume, a * b * c + ab * c + bc * a + ac * b);
  const second = Math.atan2(volume, a * c * d + ac * d + cd * a + da * c);
  return 2 * (first + second);
}

/**
 * A place on it, as parts of both sides, so that all directions are equally likely.
 * Source: C. Ureña, M. Fajardo, A. King, "An Area-Preserving Parametrization for Spherical Rectangles", CGF 32(4), 2013.
 * Its angles come from arc tangents here, and a step of Newton's method mends what cancels in f32.
 */
export function rectanglePlace(
  rectangle: Rectangle,
  angle: number,
  u: readonly [number, number],
): readonly [number, number] {
  const { low, high, height: z } = rectangle;
  const [x0, y0] = low;
  const [x1, y1] = high;
  const x = rectangleColumn(rectangle, angle, u[0]);
  const near = Math.sqrt(x * x + z * z);
  const [h0, h1] = [y0 / Math.hypot(near, y0), y1 / Math.hypot(near, y1)];
  const h = h0 + u[1] * (h1 - h0);
  const y = (near * h) / Math.sqrt(Math.max(1 - h * h, Number.MIN_VALUE));
  return [within((x - x0) / (x1 - x0)), within((y - y0) / (y1 - y0))];
}

/** The x up to which a part u of the solid angle lies. */
function rectangleColumn({ low, high, height: z }: Rectangle, angle: number, u: number): number {
  const [x0, y0] = low;
  const [x1, y1] = high;
  // Two of the inner angles of the spherical rectangle.
  const atHigh = Math.atan2(z * Math.hypot(x0, y1, z), y1 * x0);
  const atLow = Math.atan2(z * Math.hypot(x0, y0, z), -y0 * x0);
  const turn = u * angle + 2 * Math.PI - atHigh - atLow;
  const [b0, b1] = [-y0 / Math.hypot(z, y0), y1 / Math.hypot(z, y1)];
  const [sine, cosine] = [Math.sin(turn), Math.cos(turn)];
  // f = (cos b0 - b1) / sin; x = z sign(f) / sqrt(f² + b0² - 1), both times the sine.
  const f = cosine * b0 - b1;
  const rest = f * f - (sine * z) ** 2 / (z * z + y0 * y0);
  const sign = f * sine > 0 ? 1 : -1;
  const x = rest > 0 ? (sign * z * Math.abs(sine)) / Math.sqrt(rest) : sign * Number.MAX_VALUE;
  const start = Math.min(Math.max(x, x0), x1);
  const beyond = rectangleAngle({ low, high: [start, y1], height: z }) - u * angle;
  const density = (z / (start * start + z * z)) * (y1 / Math.hypot(start, y1, z) - y0 / Math.hypot(start, y0, z));
  return Math.min(Math.max(start - beyond / density, x0), x1);
}

const within = (part: number): number => Math.min(Math.max(part, 0), 1);
