// Writes window.hdr, which still-life.html is lit by: a dim room with a tall window to the left and a pale wall to the right.
// node examples/images/make-window.mjs
import { writeFileSync } from 'node:fs';

const WIDTH = 256;
const HEIGHT = 128;

/** Linear radiance from the azimuth (degrees from +x towards +z) and the height above the horizon (degrees). */
function radiance(azimuth, height) {
  // The window, behind the camera's left shoulder: six panes between bars.
  const [across, up] = [(azimuth - 118) / 16, (height - 8) / 24];
  if (across > 0 && across < 2 && up > 0 && up < 2) {
    const isBar = Math.abs(across - 1) < 0.06 || Math.abs((up * 1.5) % 1) < 0.07;
    const sky = 9 + 5 * up;
    return isBar ? [0.4, 0.35, 0.3] : [sky * 0.9, sky, sky * 1.12];
  }
  const wall = 0.16 + 0.1 * Math.cos(((azimuth - 20) * Math.PI) / 180);
  if (height > 40) return [0.3, 0.29, 0.27];
  if (height < -25) return [0.07, 0.05, 0.035];
  return [wall * 1.1, wall, wall * 0.85];
}

/** Four samples across and down for each texel. */
function texel(i, j) {
  const sum = [0, 0, 0];
  for (let k = 0; k < 16; k++) {
    const azimuth = (((i + ((k % 4) + 0.5) / 4) / WIDTH) * 360 + 180) % 360;
    const height = 90 - ((j + (Math.floor(k / 4) + 0.5) / 4) / HEIGHT) * 180;
    radiance(azimuth, height).forEach((channel, at) => {
      sum[at] += channel / 16;
    });
  }
  return sum;
}

/** Mantissas rounded down, and their common exponent. */
function rgbe(color) {
  const exponent = Math.floor(Math.log2(Math.max(...color))) + 1;
  return [...color.map((channel) => Math.floor(channel * 2 ** (8 - exponent))), exponent + 128];
}

/** One of the four numbers of a row: runs of the same one, and others one by one. */
function packed(numbers) {
  const bytes = [];
  let literal = [];
  const flush = () => {
    if (literal.length > 0) bytes.push(literal.length, ...literal);
    literal = [];
  };
  for (let i = 0; i < numbers.length; ) {
    let run = 1;
    while (run < 127 && numbers[i + run] === numbers[i]) run++;
    if (run > 2) {
      flush();
      bytes.push(128 + run, numbers[i]);
    } else {
      if (literal.length + run > 128) flush();
      literal.push(...numbers.slice(i, i + run));
    }
    i += run;
  }
  flush();
  return bytes;
}

const header = `#?RADIANCE\n# window.hdr of ray-scene, by make-window.mjs; CC0\nFORMAT=32-bit_rle_rgbe\n\n-Y ${HEIGHT} +X ${WIDTH}\n`;
const rows = Array.from({ length: HEIGHT }, (_, j) => {
  const pixels = Array.from({ length: WIDTH }, (_, i) => rgbe(texel(i, j)));
  return [2, 2, WIDTH >> 8, WIDTH & 255, ...[0, 1, 2, 3].flatMap((k) => packed(pixels.map((pixel) => pixel[k])))];
});
writeFileSync(new URL('window.hdr', import.meta.url), Buffer.concat([Buffer.from(header), Buffer.from(rows.flat())]));
