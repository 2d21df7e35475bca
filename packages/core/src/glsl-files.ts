/** The shader files by their names under `shaders/`: the one place that imports them. */
import arcTangent from '../../../shaders/arc-tangent.glsl';
import camera from '../../../shaders/camera.glsl';
import constants from '../../../shaders/constants.glsl';
import direct from '../../../shaders/direct.glsl';
import pbrNeutral from '../../../shaders/display/pbr-neutral.glsl';
import srgb from '../../../shaders/display/srgb.glsl';
import displayFragment from '../../../shaders/display.frag.glsl';
import fullscreenVertex from '../../../shaders/fullscreen.vert.glsl';
import environment from '../../../shaders/light/environment.glsl';
import lights from '../../../shaders/light/lights.glsl';
import metallicRoughness from '../../../shaders/material/metallic-roughness.glsl';
import plane from '../../../shaders/shape/plane.glsl';
import sphere from '../../../shaders/shape/sphere.glsl';
import torus from '../../../shaders/shape/torus.glsl';
import splitDot from '../../../shaders/split-dot.glsl';
import surface from '../../../shaders/surface.glsl';
import trace from '../../../shaders/trace.frag.glsl';
import varyingsVertex from '../../../shaders/varyings.vert.glsl';
import type { ShapeKind } from './primitives/index.ts';

/** The file that defines a kind of shape. */
export const shapeFile = (kind: string): string => `shape/${kind}.glsl`;

/** The file of each kind of shape. */
const shapes: { readonly [K in ShapeKind]: string } = { sphere, plane, torus };

export const glslFiles: { readonly [file: string]: string } = {
  'arc-tangent.glsl': arcTangent,
  'camera.glsl': camera,
  'constants.glsl': constants,
  'direct.glsl': direct,
  'display.frag.glsl': displayFragment,
  'display/pbr-neutral.glsl': pbrNeutral,
  'display/srgb.glsl': srgb,
  'fullscreen.vert.glsl': fullscreenVertex,
  'light/environment.glsl': environment,
  'light/lights.glsl': lights,
  'material/metallic-roughness.glsl': metallicRoughness,
  'split-dot.glsl': splitDot,
  'surface.glsl': surface,
  'trace.frag.glsl': trace,
  'varyings.vert.glsl': varyingsVertex,
  ...Object.fromEntries(Object.entries(shapes).map(([kind, text]) => [shapeFile(kind), text])),
};
