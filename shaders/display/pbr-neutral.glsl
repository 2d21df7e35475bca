// Maps linear Rec. 709 in [0, infinity) into [0, 1]: keeps the base colours of surfaces, compresses only highlights.
// Source: Khronos PBR Neutral Tone Mapper, specification,
// https://github.com/KhronosGroup/ToneMapping/tree/main/PBR_Neutral, with its names F90, Ks, Kd, f, p, pn and g. Precision: f32.
const float F90 = 0.04;
const float KS = 0.8 - F90;
const float KD = 0.15;

vec3 toneMapNeutral(vec3 color) {
  float x = min(color.r, min(color.g, color.b));
  float f = x < 2.0 * F90 ? x - x * x / (4.0 * F90) : F90;
  color -= f;
  float p = max(color.r, max(color.g, color.b));
  if (p <= KS) return color;
  float pn = 1.0 - (1.0 - KS) * (1.0 - KS) / (p + 1.0 - 2.0 * KS);
  float g = 1.0 / (KD * (p - pn) + 1.0);
  return mix(vec3(pn), color * (pn / p), g);
}
