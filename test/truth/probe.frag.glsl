#version 300 es
// One ray against the scene, by the functions and the numbers of pictures: how far it is to what it meets, and the normal
// there. START and OWN are put in by probe.ts.
precision highp float;
precision highp int;

#include "generated/limits.glsl"
#include "generated/scene.glsl"
#include "constants.glsl"
#include "surface.glsl"
#include "generated/objects.glsl"

// In the frame that the scene is packed in; the origin is the camera's where START says so.
uniform vec3 origin;
// Not of unit length.
uniform vec3 direction;
// 1 where the ray leaves the first object.
uniform float own;

out vec4 answer;

void main() {
  Parts scene = loadParts();
  From from = START;
  from.own = OWN;
  Hit hit = nearest(scene, from, direction);
  from = fromPoint(scene, origin + hit.t * direction, hit);
#ifdef INDEXED
  answer = vec4(hit.t, metAt(scene, from, direction).normal);
#else
  answer = vec4(hit.t, normalAt(scene, from, direction));
#endif
}
