/** The shader files that most scenes need, by their names under `shaders/`; for the others see `parts.ts`. */
import accumulated from '../../../shaders/accumulated.glsl';
import background from '../../../shaders/background.glsl';
import camera from '../../../shaders/camera.glsl';
import checker from '../../../shaders/checker.glsl';
import constants from '../../../shaders/constants.glsl';
import direct from '../../../shaders/direct.glsl';
import pbrNeutral from '../../../shaders/display/pbr-neutral.glsl';
import srgb from '../../../shaders/display/srgb.glsl';
import displayFragment from '../../../shaders/display.frag.glsl';
import fullscreenVertex from '../../../shaders/fullscreen.vert.glsl';
import lights from '../../../shaders/light/lights.glsl';
import metallicRoughness from '../../../shaders/material/metallic-roughness.glsl';
import planeGlsl from '../../../shaders/shape/plane.glsl';
import sphereGlsl from '../../../shaders/shape/sphere.glsl';
import surface from '../../../shaders/surface.glsl';
import trace from '../../../shaders/trace.frag.glsl';

export const glslFiles: { readonly [file: string]: string } = {
  'accumulated.glsl': accumulated,
  'background.glsl': background,
  'camera.glsl': camera,
  'checker.glsl': checker,
  'constants.glsl': constants,
  'direct.glsl': direct,
  'display.frag.glsl': displayFragment,
  'display/pbr-neutral.glsl': pbrNeutral,
  'display/srgb.glsl': srgb,
  'fullscreen.vert.glsl': fullscreenVertex,
  'light/lights.glsl': lights,
  'material/metallic-roughness.glsl': metallicRoughness,
  'shape/plane.glsl': planeGlsl,
  'shape/sphere.glsl': sphereGlsl,
  'surface.glsl': surface,
  'trace.frag.glsl': trace,
};
