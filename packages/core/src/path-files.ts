/** The shader files of the integrator `path`, by their names under `shaders/`, beyond those of `glsl-files.ts`. */
import circle from '../../../shaders/circle.glsl';
import bsdf from '../../../shaders/material/bsdf.glsl';
import dielectric from '../../../shaders/material/dielectric.glsl';
import fresnel from '../../../shaders/material/fresnel.glsl';
import microfacet from '../../../shaders/material/microfacet.glsl';
import tangents from '../../../shaders/tangents.glsl';

export const pathFiles: { readonly [file: string]: string } = {
  'circle.glsl': circle,
  'material/bsdf.glsl': bsdf,
  'material/dielectric.glsl': dielectric,
  'material/fresnel.glsl': fresnel,
  'material/microfacet.glsl': microfacet,
  'tangents.glsl': tangents,
};
