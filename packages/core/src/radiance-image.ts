/**
 * Images in the format of Radiance (.hdr, .pic): RGB with a common exponent, in scanlines that may be packed.
 * Source: G. Ward, "Real Pixels", Graphics Gems II, 1991; "Radiance File Formats" and color.c of Radiance.
 */
import type { EnvironmentImage } from './environment-image.ts';
import { type RowByRow, toEnd } from './row-by-row.ts';

/** More would take gigabytes before anything is seen: 8192 × 4096. */
export const MOST_PIXELS = 2 ** 25;

interface Header {
  readonly width: number;
  readonly height: number;
  /** Where pixels begin. */
  readonly start: number;
  /** What they were multiplied by. */
  readonly exposure: number;
  /** Whether the first scanline is the lowest one, and whether they run from right to left. */
  readonly upwards: boolean;
  readonly backwards: boolean;
}

/**
 * The radiance in an image: linear RGB as it stands there, over the exposure that its header tells.
 * @throws {Error} when it is none, or one that is not read here.
 */
export const readRadianceImage = (bytes: Uint8Array): EnvironmentImage => toEnd(radianceImageByRows(bytes));

/** The same row by row. */
export function* radianceImageByRows(bytes: Uint8Array): RowByRow<EnvironmentImage> {
  const header = readHeader(bytes);
  const { width, height, exposure } = header;
  const steps = Float64Array.from({ length: 256 }, (_, exponent) => stepOf(exponent) / exposure);
  const data = new Float32Array(3 * width * height);
  const row = new Uint8Array(4 * width);
  let at = header.start;
  for (let j = 0; j < height; j++) {
    at = readScanline(bytes, at, row);
    const place = 3 * width * (header.upwards ? height - 1 - j : j);
    for (let i = 0; i < width; i++) {
      const to = place + 3 * (header.backwards ? width - 1 - i : i);
      const step = steps[row[4 * i + 3] as number] as number;
      // Mantissas were rounded down: half a step more is their mean.
      for (let channel = 0; channel < 3; channel++)
        data[to + channel] = ((row[4 * i + channel] as number) + 0.5) * step;
    }
    yield;
  }
  return { width, height, data };
}

/** What one step of the mantissas is worth; an exponent of 0 is black. */
const stepOf = (exponent: number): number => (exponent === 0 ? 0 : 2 ** (exponent - 136));

/** Of how its sides are told: `-Y 512 +X 1024` has 512 rows from the top, each from the left. */
const SIZE = /^([-+])Y (\d+) ([-+])X (\d+)$/;

function readHeader(bytes: Uint8Array): Header {
  const lines = new LineReader(bytes);
  if (!lines.next().startsWith('#?')) throw new Error('it does not begin with "#?"');
  let exposure = 1;
  for (let line = lines.next(); line !== ''; line = lines.next()) {
    const [, name, value = ''] = /^(\w+)\s*=\s*(.*?)\s*$/.exec(line) ?? [];
    if (name === 'FORMAT' && value !== '32-bit_rle_rgbe') throw new Error(`it has pixels as "${value}"`);
    if (name === 'EXPOSURE' && Number(value) > 0) exposure *= Number(value);
  }
  const size = lines.next();
  const [, rows, height = 0, columns, width = 0] = SIZE.exec(size.trim()) ?? [];
  const pixels = Number(width) * Number(height);
  if (!(pixels > 0)) throw new Error(`it has its rows as "${size.slice(0, 40)}", not as "-Y height +X width"`);
  if (pixels > MOST_PIXELS) throw new Error(`it has ${width} × ${height} pixels, more than ${MOST_PIXELS}`);
  return {
    width: Number(width),
    height: Number(height),
    start: lines.at,
    exposure,
    upwards: rows === '+',
    backwards: columns === '-',
  };
}

/** The lines of text that a file begins with. */
class LineReader {
  at = 0;
  readonly #bytes: Uint8Array;

  constructor(bytes: Uint8Array) {
    this.#bytes = bytes;
  }

  next(): string {
    const end = this.#bytes.indexOf(0x0a, this.at);
    if (end < 0) throw new Error('it ends within its header');
    const line = String.fromCharCode(...this.#bytes.subarray(this.at, Math.min(end, this.at + LONGEST_LINE)));
    this.at = end + 1;
    return line.replace(/\r$/, '');
  }
}

const LONGEST_LINE = 1000;

/** Widths that scanlines may be packed for channel by channel. */
const PACKED_FROM = 8;
const PACKED_BELOW = 2 ** 15;

/** Reads a scanline into the four numbers of its pixels; returns where the next one begins. */
function readScanline(bytes: Uint8Array, at: number, row: Uint8Array): number {
  const width = row.length / 4;
  const [a, b, high = 0, low = 0] = bytes.subarray(at, at + 4);
  const isPacked = width >= PACKED_FROM && width < PACKED_BELOW && a === 2 && b === 2 && high < 128;
  if (!isPacked) return readFlat(bytes, at, row);
  if (high * 256 + low !== width) throw new Error(`it has rows of ${width} and of ${high * 256 + low} pixels`);
  let next = at + 4;
  for (let channel = 0; channel < 4; channel++) next = readChannel(bytes, next, row, channel);
  return next;
}

/** One of the four numbers of all pixels: runs of the same one (above 128), and others one by one. */
function readChannel(bytes: Uint8Array, start: number, row: Uint8Array, channel: number): number {
  let at = start;
  for (let place = channel; place < row.length; ) {
    const code = byteAt(bytes, at++);
    const isRun = code > 128;
    const count = isRun ? code - 128 : code;
    if (count === 0 || place + 4 * (count - 1) >= row.length) throw new Error('it has a run beyond the end of its row');
    for (let i = 0; i < count; i++, place += 4) row[place] = byteAt(bytes, isRun ? at : at + i);
    at += isRun ? 1 : count;
  }
  return at;
}

/** Pixels one by one; (1, 1, 1, n) repeats the one before n times, a further such code 256 n times, and so on. */
function readFlat(bytes: Uint8Array, start: number, row: Uint8Array): number {
  let at = start;
  let shift = 0;
  for (let place = 0; place < row.length; ) {
    const pixel = [byteAt(bytes, at), byteAt(bytes, at + 1), byteAt(bytes, at + 2), byteAt(bytes, at + 3)] as const;
    at += 4;
    const isRepeat = pixel[0] === 1 && pixel[1] === 1 && pixel[2] === 1;
    const count = isRepeat ? pixel[3] * 2 ** shift : 1;
    shift = isRepeat ? shift + 8 : 0;
    if (isRepeat && place === 0) throw new Error('it repeats a pixel before the first one');
    if (place + 4 * count > row.length) throw new Error('it has a run beyond the end of its row');
    for (let i = 0; i < count; i++, place += 4) row.set(isRepeat ? row.subarray(place - 4, place) : pixel, place);
  }
  return at;
}

function byteAt(bytes: Uint8Array, at: number): number {
  const byte = bytes[at];
  if (byte === undefined) throw new Error('it ends before its last row');
  return byte;
}
