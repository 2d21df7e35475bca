// What the shading needs to know of the point that a ray met.
struct Surface {
  vec3 normal;
  Material material;
#ifdef REFLECTIVE
  float nv;
#endif
};
