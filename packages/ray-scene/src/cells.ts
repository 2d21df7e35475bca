/** Which samples the pixels of a picture have: all pixels of a cell have equally many. Knows no WebGL. */

/** Side of a cell in pixels, as a power of two; the shaders are told. */
export const CELL_BITS = 4;
export const CELL_PIXELS = 4 ** CELL_BITS;

/** Cells one after the other, counted row by row from the bottom: some of one row, or whole rows. */
export interface Tile {
  readonly first: number;
  readonly count: number;
}

/** In pixels, from the lower left corner of the picture. It may reach beyond the others. */
export type Rectangle = readonly [x: number, y: number, width: number, height: number];

export class Cells {
  readonly columns: number;
  readonly rows: number;
  readonly whole: Tile;
  /** Samples per pixel, by cell. */
  readonly counts: Uint32Array;
  /** Samples that every pixel has. */
  least = 0;
  /** Samples of all pixels together. */
  rays = 0;
  readonly #width: number;
  readonly #height: number;

  /** @param width of the picture, in pixels */
  constructor(width: number, height: number) {
    this.#width = width;
    this.#height = height;
    this.columns = cellsAlong(width);
    this.rows = cellsAlong(height);
    this.counts = new Uint32Array(this.columns * this.rows);
    this.whole = { first: 0, count: this.counts.length };
  }

  /** How many samples the pixels of a tile have. */
  countOf({ first }: Tile): number {
    return this.counts[first] as number;
  }

  rectangleOf({ first, count }: Tile): Rectangle {
    const { columns } = this;
    const corner = [first % columns, Math.floor(first / columns), Math.min(count, columns), Math.ceil(count / columns)];
    return corner.map((cells) => cells << CELL_BITS) as unknown as Rectangle;
  }

  /** How many pixels of the picture are in a tile. */
  pixelsOf(tile: Tile): number {
    const [x, y, width, height] = this.rectangleOf(tile);
    return Math.min(width, this.#width - x) * Math.min(height, this.#height - y);
  }

  /** Begins anew. */
  clear(): void {
    this.counts.fill(0);
    this.least = this.rays = 0;
  }

  /** The pixels of a tile have one sample more. */
  add(tile: Tile): void {
    this.counts.fill(this.countOf(tile) + 1, tile.first, tile.first + tile.count);
    this.least = this.counts.reduce((a, b) => Math.min(a, b));
    this.rays += this.pixelsOf(tile);
  }

  /** The next tile to draw, of at most so many cells: of those that have fewest samples, so that none falls behind. */
  next(most: number): Tile {
    const { columns, counts, least } = this;
    const first = counts.indexOf(least);
    let count = 0;
    while (count < most && counts[first + count] === least) count++;
    const column = first % columns;
    const isWide = column === 0 && count > columns;
    return { first, count: isWide ? count - (count % columns) : Math.min(count, columns - column) };
  }
}

const cellsAlong = (length: number): number => Math.ceil(length / 2 ** CELL_BITS);
