#version 300 es
// FLOOR of the classic scene: that one scene written by hand, as fast as we could make it on SwiftShader, with its
// numbers inlined and no generality. `npm run bench` divides the generated shader's time by this one's.
//
// The picture: classic-scene.md, integrator `direct`, 10 vertices. Spheres (0,0,0) r 2, (-1,-1,-2) r .8, (1,.2,-3) r .5
// over the checkered plane y = -3; a point light at (10,10,-10) of radiant intensity pi without decay; black behind.
// glTF dielectrics: f0 = .9 .5 .2 .1, alpha = .01 .25 .81 .81, base (0,.1,0) (.1,0,0) (0,0,.6), .5 or .25. Each vertex:
// L += T n.l ((1-F(v.h)) base + F(v.h) pi D V) if the light is seen, T *= F(n.v), on along the mirror direction.
//
// One file, two stages: compile it as it is for the fragment stage, and with `#define VERTEX` put in after the first
// line for the vertex stage. Draw TRIANGLES 0..3 without attributes (one triangle over the viewport) into RGBA32F with
// blend ONE, ONE (EXT_float_blend): linear radiance is added up, alpha counts samples. Blending costs next to nothing;
// ping-pong with texelFetch takes 12 to 17 % more (llvmpipe 20 to 30 %).
//
// What made it fast, measured on SwiftShader (Subzero; it runs 2x2 pixels as four lanes with a mask):
// - An `if` never skips: both sides always run. So do `?:`, `&&`, `||` on anything but constants, as branches with masks.
//   Everything here is min, max, step and mix(a, b, bool), which is one select. Worth 44 %.
// - Only a loop's back edge looks at the mask, at the loop's end. So: do {} while, the first ray peeled, shading before
//   the next ray, which also shares c and k with the shadow rays. Worth 8 % against tracing at the loop's head.
// - A scalar read from a uniform costs as much as ten operations, again at each use, so the camera comes in as varyings.
//   Worth 20 %. (A flat varying costs two or three.)
// - The nearest object is three weights 0 or 1, which mix the inlined numbers; no index, no hit record.
//
// Same formulas as the product, less what this scene cannot do: rays start outside all spheres and above the plane and
// stay there. So a hit is the first root k / (b + sqrt D), which needs b > 0; the sphere just left has b = -r n.d < 0,
// the plane just left has d.y > 0, so both exclude themselves, exactly, without offsets. The light is above and outside
// everything, so the shadow rays ask for signs only and leave out the plane. k = |c|^2 - r^2 is, in f32, 1.4 times more
// accurate than (|c|-r)(|c|+r) (the root's rounding counts twice), and cheaper.
precision highp float;
precision highp int;

#ifdef VERTEX

uniform vec3 origin, forward, right, up; // right and up scaled by tan(fov/2) and aspect
uniform vec2 jitter, resolution;         // jitter in [0,1)^2, resolution in pixels
flat out vec3 eye;
out vec3 ray;

void main() {
  vec2 q = vec2(gl_VertexID == 1 ? 3. : -1., gl_VertexID == 2 ? 3. : -1.);
  gl_Position = vec4(q, 0, 1);
  q += (2. * jitter - 1.) / resolution;
  ray = forward + q.x * right + q.y * up;
  eye = origin;
}

#else

flat in vec3 eye;
in vec3 ray;
out vec4 outColor;

// v = c.dir and the quarter discriminant for the unit vector dir, Haines' choice of two forms. Macros, as the names
// of all three spheres' numbers are wanted outside.
#define SPHERE(c, k, rr, dir, b, D) \
  float b = dot(c, dir), D; \
  { \
    vec3 m = c - b * dir; \
    float q = b * b; \
    D = mix(rr - dot(m, m), q - k, q < rr); \
  }
// Distance, or something huge where b or D is negative.
#define DISTANCE(k, b, D) max(k / (abs(b) + sqrt(max(D, 0.))), -1e37 * min(b, D))
#define CENTRES \
  vec3 c0 = -p, c1 = vec3(-1, -1, -2) - p, c2 = vec3(1, .2, -3) - p; \
  float k0 = dot(c0, c0) - 4., k1 = dot(c1, c1) - .64, k2 = dot(c2, c2) - .25;
// The next hit from p along d: t (1e15: none), one weight per sphere, and p moved there. Only spheres 0 and 1 meet.
#define TRACE \
  SPHERE(c0, k0, 4., d, b0, D0) \
  SPHERE(c1, k1, .64, d, b1, D1) \
  SPHERE(c2, k2, .25, d, b2, D2) \
  float t0 = DISTANCE(k0, b0, D0), t1 = DISTANCE(k1, b1, D1), t2 = DISTANCE(k2, b2, D2); \
  float t3 = mix(1e15, (-3. - p.y) / d.y, d.y < 0.); \
  t = min(min(t0, t1), min(min(t2, t3), 1e15)); \
  w0 = step(t0, t); \
  w1 = min(step(t1, t), 1. - w0); \
  w2 = step(t2, t); \
  p += t * d;

void main() {
  vec3 d = ray / sqrt(dot(ray, ray)), p = eye, L = vec3(0);
  float t, w0, w1, w2, i = 0.;
  bool more;
  {
    CENTRES
    TRACE
  }
  float T = step(t, 9e14);
  do {
    CENTRES
    // What was hit. Where nothing was (first vertex only), the plane, with T = 0.
    float w3 = 1. - w0 - w1 - w2;
    vec3 n = p * (.5 * w0 + 1.25 * w1 + 2. * w2) + vec3(1.25 * w1 - 2. * w2, 1.25 * w1 - .4 * w2 + w3, 2.5 * w1 + 6. * w2);
    float f0 = .1 + .8 * w0 + .4 * w1 + .1 * w2, a2 = .0001 * w0 + .0625 * w1 + .6561 * (w2 + w3);
    float grey = w3 * (.5 - .5 * fract(.5 * (floor(p.x) + floor(-p.z))));
    // The light.
    vec3 l = vec3(10, 10, -10) - p;
    l /= sqrt(dot(l, l));
    SPHERE(c0, k0, 4., l, s0, S0)
    SPHERE(c1, k1, .64, l, s1, S1)
    SPHERE(c2, k2, .25, l, s2, S2)
    float hidden = max(max(min(s0, S0), min(s1, S1)), min(s2, S2));
    // GGX without cancellation: h is not normalised, |n x h|^2 = |h - (n.h) n|^2, v.h = |h| / 2.
    float nl = max(dot(n, l), 0.), nv = abs(dot(n, d)), nh = nl + nv, ia = 1. - a2, if0 = 1. - f0;
    vec3 h = l - d, hn = h - nh * n;
    float hh = dot(h, h), den = dot(hn, hn) + a2 * (nh * nh);
    float smith = (nl + sqrt(a2 + ia * (nl * nl))) * (nv + sqrt(a2 + ia * (nv * nv)));
    float u = 1. - .5 * sqrt(hh), uu = u * u, F = f0 + if0 * (uu * uu * u);
    float w = T * nl * step(hidden, 0.), wf = w * F, wd = w - wf;
    float y = wf * (a2 * (hh * hh)) / (den * den * smith) + wd * grey, z = .1 * wd;
    L += vec3(y + z * w1, y + z * w0, y + .6 * (wd * w2));
    // On along the mirror direction.
    float e = 1. - nv, ee = e * e;
    T *= f0 + if0 * (ee * ee * e);
    d += (2. * nv / dot(n, n)) * n;
    TRACE
    i += 1.;
    more = max(t, i * 1e14) < 1e15;
  } while (more);
  outColor = vec4(L, 1);
}

#endif
