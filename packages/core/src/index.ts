/** `@ray-scene/core`: scenes, what they require, and the shaders and buffers that draw them. No DOM, no GL. */
import './words.ts';

export * from './on-demand.ts';
