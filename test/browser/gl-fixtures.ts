/** Helpers for tests that look into WebGL. */
import type { Accumulation } from '../../packages/ray-scene/src/accumulation.ts';

type Rgba = readonly [number, number, number, number];

/** Counts the objects of a context that are alive, by kind, from now on. */
export function countObjects(gl: WebGL2RenderingContext) {
  const counts = { Buffer: 0, Framebuffer: 0, Program: 0, Shader: 0, Texture: 0 };
  for (const kind of Object.keys(counts) as (keyof typeof counts)[]) {
    const count = (method: string, step: number): void => {
      const original = Reflect.get(gl, method) as (...args: unknown[]) => unknown;
      Reflect.set(gl, method, (...args: unknown[]) => {
        counts[kind] += step;
        return original.apply(gl, args);
      });
    };
    count(`create${kind}`, 1);
    count(`delete${kind}`, -1);
  }
  return counts;
}

/** Adds a sample whose pixels are given, the bottom row first. Clearing does not blend: only a first sample is right. */
export function addPixels(gl: WebGL2RenderingContext, target: Accumulation, pixels: readonly Rgba[]): void {
  target.add(() => {
    gl.enable(gl.SCISSOR_TEST);
    pixels.forEach((pixel, i) => {
      gl.scissor(i % target.width, Math.floor(i / target.width), 1, 1);
      gl.clearBufferfv(gl.COLOR, 0, pixel);
    });
    gl.disable(gl.SCISSOR_TEST);
  });
}

/** Source of a program that fills the viewport with what `body`, in GLSL, says of the pixel. */
export const fillSource = (body: string) => ({
  vertex: `#version 300 es
    void main() { gl_Position = vec4(4 * (gl_VertexID & 1) - 1, 2 * (gl_VertexID & 2) - 1, 0, 1); }`,
  fragment: `#version 300 es\nprecision highp float;\nout vec4 color;\nvoid main() { color = ${body}; }`,
  lines: [],
});

/** Loses the context and brings it back, as a driver that was reset would. */
export async function loseAndRestore(gl: WebGL2RenderingContext, whileLost = () => {}): Promise<void> {
  const extension = gl.getExtension('WEBGL_lose_context');
  if (!extension) throw new Error('this browser cannot lose a context on purpose');
  const lost = nextEvent(gl, 'webglcontextlost');
  extension.loseContext();
  await lost;
  whileLost();
  // Only a later task than that of the event may restore.
  await new Promise((resolve) => setTimeout(resolve));
  const restored = nextEvent(gl, 'webglcontextrestored');
  extension.restoreContext();
  await restored;
}

const nextEvent = (gl: WebGL2RenderingContext, type: string): Promise<Event> =>
  new Promise((resolve) => gl.canvas.addEventListener(type, resolve, { once: true }));
