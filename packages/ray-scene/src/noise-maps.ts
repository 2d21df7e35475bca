/** What `output` shows instead of the picture, of what is known about its samples. */
import type { RenderSettings } from '@ray-scene/core';
import errorMapFragment from '../../../shaders/noise/error-map.frag.glsl';
import samplesMapFragment from '../../../shaders/noise/samples-map.frag.glsl';
import type { Accumulation } from './accumulation.ts';
import { type NoiseMeter, noiseSource } from './noise-meter.ts';
import type { Program } from './program.ts';
import type { RenderDevice } from './render-device.ts';

export type NoiseOutput = Extract<RenderSettings['output'], 'error' | 'samples'>;

/** What a map is drawn from. There is no meter before anything was measured. */
interface Sources {
  readonly gl: WebGL2RenderingContext;
  readonly accumulation: Accumulation;
  readonly meter: NoiseMeter | undefined;
}

interface NoiseMap {
  readonly fragment: string;
  /** Gives the program in use what it reads; returns whether there is anything to show. */
  readonly bind: (program: Program, sources: Sources) => boolean;
}

const maps = {
  error: {
    fragment: errorMapFragment,
    bind: (program, { gl, meter }) => {
      if (!meter) return false;
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(gl.TEXTURE_2D, meter.blocks.texture);
      gl.uniform1i(program.uniform('blocks'), 0);
      return true;
    },
  },
  samples: {
    fragment: samplesMapFragment,
    bind: (program, { gl, accumulation }) => {
      accumulation.bindTextures(program);
      const most = accumulation.cells.counts.reduce((a, b) => Math.max(a, b));
      gl.uniform1f(program.uniform('most'), most);
      return true;
    },
  },
} as const satisfies { [O in NoiseOutput]: NoiseMap };

/** Draws a map over the viewport, or clears it where nothing is known yet. */
export function drawNoiseMap(device: RenderDevice, output: NoiseOutput, sources: Omit<Sources, 'gl'>): void {
  const { gl, programs } = device;
  const key = `noise map ${output}`;
  const root = `noise/${output}-map.frag.glsl`;
  const { fragment, bind } = maps[output];
  const program = programs.acquire(key, noiseSource(root, { [root]: fragment }));
  program.use();
  if (bind(program, { gl, ...sources })) gl.drawArrays(gl.TRIANGLES, 0, 3);
  else gl.clearBufferfv(gl.COLOR, 0, [0, 0, 0, 0]);
  // It stays for the next frame: the cache keeps some programs that nobody uses.
  programs.release(key, program);
}
