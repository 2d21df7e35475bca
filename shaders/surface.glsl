// What the shading needs to know of the point that a ray met. Precision: f32.
struct Surface {
  vec3 normal;
  Material material;
#ifdef REFLECTIVE
  float nv;
#endif
};
