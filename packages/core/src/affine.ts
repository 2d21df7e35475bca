/** Affine maps of space in f64, each with its inverse: where the objects of a group stand. */
import type { Bounds } from './primitives/primitive.ts';
import type { Group } from './schema.ts';
import { add, addScaled, cross, dot, normalize, scale, type Vec3 } from './vector.ts';

/** Three vectors: the columns or the rows of a matrix. */
export type Matrix = readonly [Vec3, Vec3, Vec3];

const UNIT: Matrix = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/** p ↦ linear part · p + offset. */
export class Affine {
  /** Of the linear part: where it takes the axes. */
  readonly columns: Matrix;
  /** Of the inverse of the linear part, a product of the inverses of its factors: nothing cancels in it. */
  readonly inverse: Matrix;
  readonly offset: Vec3;
  /**
   * The linear part is a similarity, which scales all lengths by this factor, after the rest. There is a rest from the
   * first scale on that is not the same along all axes; its numbers are the author's own where groups are not nested.
   */
  readonly factor: number;
  readonly rest: Matrix | undefined;

  constructor(columns: Matrix, inverse: Matrix, offset: Vec3, factor: number, rest?: Matrix) {
    this.columns = columns;
    this.inverse = inverse;
    this.offset = offset;
    this.factor = factor;
    this.rest = rest;
  }

  static readonly identity = new Affine(UNIT, UNIT, [0, 0, 0], 1);

  /** Of a group in the space that this map leads from: first what the group does, then this. */
  within({ position, rotation, scale: factors }: Pick<Group, 'position' | 'rotation' | 'scale'>): Affine {
    const turned = rotationMatrix(rotation);
    const columns = mapMatrix(turned, (axis, i) => scale(axis, factors[i] as number));
    const inverse = mapMatrix(turned, (axis, i) => scale(times(this.inverse, axis), 1 / (factors[i] as number)));
    const uniform = Math.abs(factors[0]) === Math.abs(factors[1]) && Math.abs(factors[1]) === Math.abs(factors[2]);
    const stretched = mapMatrix(UNIT, (axis, i) => scale(axis, factors[i] as number));
    const { rest } = this;
    return new Affine(
      mapMatrix(columns, (column) => this.direction(column)),
      inverse,
      this.point(position),
      uniform && !rest ? this.factor * Math.abs(factors[0]) : this.factor,
      rest ? mapMatrix(columns, (column) => times(rest, column)) : uniform ? undefined : stretched,
    );
  }

  /** The factor of a similarity that makes volumes as large. */
  get meanFactor(): number {
    const [x, y, z] = this.rest ?? UNIT;
    return this.factor * Math.cbrt(Math.abs(dot(cross(x, y), z)));
  }

  /** Whether right hands become left hands. */
  get mirrors(): boolean {
    const [x, y, z] = this.columns;
    return dot(cross(normalize(x), normalize(y)), z) < 0;
  }

  point(p: Vec3): Vec3 {
    return add(this.direction(p), this.offset);
  }

  direction(d: Vec3): Vec3 {
    return times(this.columns, d);
  }

  /** A vector that stays perpendicular to what it is perpendicular to, on the same side; not of its length. */
  normal(n: Vec3): Vec3 {
    return times(this.inverse, n);
  }

  /** Where a point comes from. */
  pointBack(p: Vec3): Vec3 {
    return this.directionBack(addScaled(p, this.offset, -1));
  }

  directionBack(d: Vec3): Vec3 {
    const [x, y, z] = this.inverse;
    return [dot(x, d), dot(y, d), dot(z, d)];
  }

  /** The corners of a box, where they are taken to. */
  corners({ min, max }: Bounds): readonly Vec3[] {
    const ends = [min, max];
    return [0, 1, 2, 3, 4, 5, 6, 7].map((i) =>
      this.point([ends[i & 1]?.[0] ?? 0, ends[(i >> 1) & 1]?.[1] ?? 0, ends[i >> 2]?.[2] ?? 0]),
    );
  }

  /** The box along the axes around all of these. */
  bounds(box: Bounds): Bounds {
    const corners = this.corners(box);
    const along = (i: number): number[] => corners.map((corner) => corner[i] as number);
    return {
      min: mapVector((_, i) => Math.min(...along(i))),
      max: mapVector((_, i) => Math.max(...along(i))),
    };
  }
}

const mapVector = (change: (n: number, i: number) => number): Vec3 => UNIT[0].map(change) as unknown as Vec3;

const mapMatrix = (m: Matrix, change: (v: Vec3, i: number) => Vec3): Matrix => m.map(change) as unknown as Matrix;

/** A matrix of these columns times a vector. */
export const times = ([x, y, z]: Matrix, v: Vec3): Vec3 => addScaled(addScaled(scale(x, v[0]), y, v[1]), z, v[2]);

/** The columns of a rotation by so many degrees about x, then about the new y axis, then about the new z axis. */
function rotationMatrix(degrees: Vec3): Matrix {
  const [[sx, cx], [sy, cy], [sz, cz]] = degrees.map(sineAndCosine) as [Turn, Turn, Turn];
  return [
    [cy * cz, cx * sz + sx * sy * cz, sx * sz - cx * sy * cz],
    [-cy * sz, cx * cz - sx * sy * sz, sx * cz + cx * sy * sz],
    [sy, -sx * cy, cx * cy],
  ];
}

type Turn = readonly [sine: number, cosine: number];

/** Exact for right angles, so that what was along an axis is along an axis again. */
function sineAndCosine(degrees: number): Turn {
  const quarters = Math.round((degrees % 360) / 90);
  const rest = ((degrees % 360) - 90 * quarters) * (Math.PI / 180);
  const [sine, cosine] = [Math.sin(rest), Math.cos(rest)];
  const turns: readonly Turn[] = [
    [sine, cosine],
    [cosine, -sine],
    [-sine, -cosine],
    [-cosine, sine],
  ];
  return turns[(quarters + 4) % 4] as Turn;
}
