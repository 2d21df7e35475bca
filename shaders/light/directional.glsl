// Light that comes from so far away that it is parallel, seen by way of a surface. See lights.glsl. Precision: f32.
vec3 directionalLight(DirectionalLight light, Parts scene, From from, Surface s, vec3 p, vec3 d) {
  float strength = 1.0;
#ifdef SHADOWS
  strength *= step(occlusion(scene, from, light.toLight, MISS), 0.0);
#endif
  return scattered(light.irradiance, strength, s, light.toLight, d);
}
