// Which closed objects a path is inside of, the one that it entered last first. That one is the medium, whatever else is
// there. Kept as far as the scene tells media apart: with one object that light goes through, its sides say enough.
// Precision: f32; which medium it is, is exact.

struct Media {
#ifdef NESTED
  ivec4 objects;
  // Indices of refraction; 1 where there is no object.
  vec4 indices;
#ifdef ATTENUATION
  mat4x3 attenuations;
#endif
#elif defined(ATTENUATION)
  vec3 attenuation;
#else
  // GLSL knows no empty struct.
  bool none;
#endif
};

Media enter(Media m, int object, Material entered) {
#ifdef NESTED
  m.objects = ivec4(object, m.objects.xyz);
  m.indices = vec4(entered.ior, m.indices.xyz);
#ifdef ATTENUATION
  m.attenuations = mat4x3(entered.attenuation, m.attenuations[0], m.attenuations[1], m.attenuations[2]);
#endif
#elif defined(ATTENUATION)
  m.attenuation = entered.attenuation;
#endif
  return m;
}

// Those entered before the object move up by one place.
Media leave(Media m, int object) {
#ifdef NESTED
  bool x = m.objects.x == object;
  bool y = x || m.objects.y == object;
  bool z = y || m.objects.z == object;
  bool w = z || m.objects.w == object;
  m.objects = ivec4(x ? m.objects.y : m.objects.x, y ? m.objects.z : m.objects.y, z ? m.objects.w : m.objects.z,
    w ? -1 : m.objects.w);
  m.indices = mix(m.indices, vec4(m.indices.yzw, 1.0), bvec4(x, y, z, w));
#ifdef ATTENUATION
  if (x) m.attenuations[0] = m.attenuations[1];
  if (y) m.attenuations[1] = m.attenuations[2];
  if (z) m.attenuations[2] = m.attenuations[3];
  if (w) m.attenuations[3] = vec3(0.0);
#endif
#elif defined(ATTENUATION)
  m.attenuation = vec3(0.0);
#endif
  return m;
}

// What the camera is inside of.
Media startMedia(Parts scene) {
  Media m;
#ifdef NESTED
  m.objects = ivec4(-1);
  m.indices = vec4(1.0);
#ifdef ATTENUATION
  m.attenuations = mat4x3(0.0);
#endif
  for (int i = 3; i >= 0; i--) {
    int object = int(scene.surroundings.around[i]);
    if (object >= 0) m = enter(m, object, metAt(scene, fromPoint(scene, vec3(0.0), Hit(0.0, object)), vec3(0.0)).material);
  }
#elif defined(ATTENUATION)
  m.attenuation = vec3(0.0);
#else
  m.none = true;
#endif
  return m;
}

float mediumIndex(Media m) {
#ifdef NESTED
  return m.indices.x;
#else
  return 1.0;
#endif
}

#ifdef ATTENUATION
// What is left of light after a way through the medium. Source: Beer-Lambert, as in KHR_materials_volume.
vec3 transmittance(Media m, float t) {
#ifdef NESTED
  return exp(-t * m.attenuations[0]);
#else
  return exp(-t * m.attenuation);
#endif
}
#endif
