/** The shader files of the integrator `path`, by their names under `shaders/`, beyond those of `glsl-files.ts`. */
import circle from '../../../shaders/circle.glsl';
import glint from '../../../shaders/glint.glsl';
import imageMap from '../../../shaders/image-map.glsl';
import lens from '../../../shaders/lens.glsl';
import emitterArea from '../../../shaders/light/emitter/area.glsl';
import emitterBox from '../../../shaders/light/emitter/box.glsl';
import emitterCone from '../../../shaders/light/emitter/cone.glsl';
import emitterCylinder from '../../../shaders/light/emitter/cylinder.glsl';
import emitterDirectional from '../../../shaders/light/emitter/directional.glsl';
import emitterDisc from '../../../shaders/light/emitter/disc.glsl';
import emitterImage from '../../../shaders/light/emitter/image.glsl';
import emitterInside from '../../../shaders/light/emitter/inside.glsl';
import emitterOwnCosine from '../../../shaders/light/emitter/own-cosine.glsl';
import emitterOwnSpace from '../../../shaders/light/emitter/own-space.glsl';
import emitterPlaced from '../../../shaders/light/emitter/placed.glsl';
import emitterPoint from '../../../shaders/light/emitter/point.glsl';
import emitterProfile from '../../../shaders/light/emitter/profile.glsl';
import emitterQuad from '../../../shaders/light/emitter/quad.glsl';
import emitterRectangle from '../../../shaders/light/emitter/rectangle.glsl';
import emitterShining from '../../../shaders/light/emitter/shining.glsl';
import emitterSphere from '../../../shaders/light/emitter/sphere.glsl';
import emitterSpot from '../../../shaders/light/emitter/spot.glsl';
import emitterSun from '../../../shaders/light/emitter/sun.glsl';
import emitterTriangle from '../../../shaders/light/emitter/triangle.glsl';
import emitters from '../../../shaders/light/emitters.glsl';
import environmentImage from '../../../shaders/light/environment-image.glsl';
import bsdf from '../../../shaders/material/bsdf.glsl';
import dielectric from '../../../shaders/material/dielectric.glsl';
import fresnel from '../../../shaders/material/fresnel.glsl';
import microfacet from '../../../shaders/material/microfacet.glsl';
import media from '../../../shaders/media.glsl';
import output from '../../../shaders/output.glsl';
import pathFragment from '../../../shaders/path.frag.glsl';
import path from '../../../shaders/path.glsl';
import sampler from '../../../shaders/sampler.glsl';
import surfaceFrame from '../../../shaders/surface-frame.glsl';
import tangents from '../../../shaders/tangents.glsl';
import vertex from '../../../shaders/vertex.glsl';
import whitted from '../../../shaders/whitted.glsl';

export const pathFiles: { readonly [file: string]: string } = {
  'circle.glsl': circle,
  'lens.glsl': lens,
  'output.glsl': output,
  'light/emitter/area.glsl': emitterArea,
  'light/emitter/box.glsl': emitterBox,
  'light/emitter/cone.glsl': emitterCone,
  'light/emitter/cylinder.glsl': emitterCylinder,
  'light/emitter/directional.glsl': emitterDirectional,
  'light/emitter/disc.glsl': emitterDisc,
  'light/emitter/image.glsl': emitterImage,
  'light/emitter/inside.glsl': emitterInside,
  'light/emitter/own-cosine.glsl': emitterOwnCosine,
  'light/emitter/own-space.glsl': emitterOwnSpace,
  'light/emitter/placed.glsl': emitterPlaced,
  'light/emitter/point.glsl': emitterPoint,
  'light/emitter/profile.glsl': emitterProfile,
  'light/emitter/quad.glsl': emitterQuad,
  'light/emitter/rectangle.glsl': emitterRectangle,
  'light/emitter/shining.glsl': emitterShining,
  'light/emitter/sphere.glsl': emitterSphere,
  'light/emitter/spot.glsl': emitterSpot,
  'light/emitter/sun.glsl': emitterSun,
  'light/emitter/triangle.glsl': emitterTriangle,
  'light/emitters.glsl': emitters,
  'glint.glsl': glint,
  'image-map.glsl': imageMap,
  'light/environment-image.glsl': environmentImage,
  'material/bsdf.glsl': bsdf,
  'material/dielectric.glsl': dielectric,
  'material/fresnel.glsl': fresnel,
  'material/microfacet.glsl': microfacet,
  'media.glsl': media,
  'path.frag.glsl': pathFragment,
  'path.glsl': path,
  'sampler.glsl': sampler,
  'surface-frame.glsl': surfaceFrame,
  'tangents.glsl': tangents,
  'vertex.glsl': vertex,
  'whitted.glsl': whitted,
};
