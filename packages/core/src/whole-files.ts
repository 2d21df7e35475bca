/**
 * The shader files of `glslFiles` that have branches for some scenes only. Where the one file of a page holds them without
 * those branches, these take their place.
 */
import background from '../../../shaders/background.glsl';
import camera from '../../../shaders/camera.glsl';
import direct from '../../../shaders/direct.glsl';
import lights from '../../../shaders/light/lights.glsl';
import metallicRoughness from '../../../shaders/material/metallic-roughness.glsl';
import planeGlsl from '../../../shaders/shape/plane.glsl';
import sphereGlsl from '../../../shaders/shape/sphere.glsl';

export const wholeFiles = {
  'background.glsl': background,
  'camera.glsl': camera,
  'direct.glsl': direct,
  'light/lights.glsl': lights,
  'material/metallic-roughness.glsl': metallicRoughness,
  'shape/plane.glsl': planeGlsl,
  'shape/sphere.glsl': sphereGlsl,
} as const;
