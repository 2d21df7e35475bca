// What a camera ray shows that meets nothing. Precision: f32.
vec4 background(Parts scene, vec3 d) {
#if defined(BACKGROUND_ENVIRONMENT)
  return vec4(environmentRadiance(scene.surroundings, d), 1.0);
#elif defined(BACKGROUND_COLOR)
  return vec4(scene.surroundings.background, 1.0);
#else
  return vec4(0.0);
#endif
}
