// Encodes linear Rec. 709 in [0, 1] for an sRGB display: the exact curve with its straight foot.
// Source: IEC 61966-2-1:1999, section 5.3. Precision: f32.
vec3 encodeSrgb(vec3 linear) {
  return mix(1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, 12.92 * linear, lessThanEqual(linear, vec3(0.0031308)));
}
