// What textbook float code makes of a scene of spheres: the quadratic formula in 32 bits and in the scene's own coordinates,
// and shadow rays that start a little above the surface. Nothing of this is in the product.
// <canvas data-textbook="scenes/NAME.json"> is drawn so, when the page has loaded.

const VERTEX = `#version 300 es
void main() { gl_Position = vec4(4 * (gl_VertexID & 1) - 1, 2 * (gl_VertexID & 2) - 1, 0, 1); }`;

const fragment = (spheres, lights) => `#version 300 es
precision highp float;
const float OFFSET = 1e-3;
uniform vec4 spheres[${spheres}];
uniform vec3 colors[${spheres}];
uniform vec4 lights[${lights}];
uniform float intensities[${lights}];
uniform vec3 eye, right, up, forward, sky, ground;
uniform vec2 size;
out vec4 shown;

float meet(vec4 sphere, vec3 o, vec3 d) {
  vec3 oc = o - sphere.xyz;
  float a = dot(d, d);
  float b = 2.0 * dot(oc, d);
  float c = dot(oc, oc) - sphere.w * sphere.w;
  float discriminant = b * b - 4.0 * a * c;
  if (discriminant < 0.0) return 1e30;
  float near = (-b - sqrt(discriminant)) / (2.0 * a);
  float far = (-b + sqrt(discriminant)) / (2.0 * a);
  return near > 0.0 ? near : (far > 0.0 ? far : 1e30);
}

bool isHidden(vec3 p, vec3 l, float limit) {
  for (int i = 0; i < ${spheres}; i++) if (meet(spheres[i], p, l) < limit) return true;
  return false;
}

void main() {
  vec2 at = 2.0 * gl_FragCoord.xy / size - 1.0;
  vec3 d = normalize(forward + at.x * right + at.y * up);
  float t = 1e30;
  int hit = -1;
  for (int i = 0; i < ${spheres}; i++) {
    float one = meet(spheres[i], eye, d);
    if (one < t) { t = one; hit = i; }
  }
  vec3 color = mix(ground, sky, 0.5 + 0.5 * d.y);
  if (hit >= 0) {
    vec3 p = eye + t * d;
    vec3 n = normalize(p - spheres[hit].xyz);
    if (dot(n, d) > 0.0) n = -n;
    vec3 start = p + OFFSET * n;
    float received = 0.0;
    for (int i = 0; i < ${lights}; i++) {
      // A direction has 0 in the last place.
      vec3 l = lights[i].xyz - lights[i].w * start;
      float far = length(l);
      float strength = intensities[i] * max(dot(n, l / far), 0.0) / (lights[i].w > 0.0 ? far * far : 1.0);
      if (strength > 0.0 && !isHidden(start, l / far, lights[i].w > 0.0 ? far : 1e30)) received += strength;
    }
    color = colors[hit] * (received / 3.14159265 + mix(ground, sky, 0.5 + 0.5 * n.y));
  }
  vec3 low = 12.92 * color;
  vec3 high = 1.055 * pow(max(color, 0.0), vec3(1.0 / 2.4)) - 0.055;
  shown = vec4(mix(low, high, greaterThan(color, vec3(0.0031308))), 1.0);
}`;

const subtract = (a, b) => a.map((x, i) => x - b[i]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const scaled = (a, s) => a.map((x) => x * s);
const unit = (a) => scaled(a, 1 / Math.hypot(...a));

/** Linear colour of a CSS colour, by way of a canvas. */
function linear(color) {
  const context = document.createElement('canvas').getContext('2d');
  context.fillStyle = color;
  context.fillRect(0, 0, 1, 1);
  const [r, g, b] = context.getImageData(0, 0, 1, 1).data;
  return [r, g, b].map((byte) => (byte <= 10 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4));
}

function programOf(gl, source) {
  const program = gl.createProgram();
  for (const [type, text] of [
    [gl.VERTEX_SHADER, VERTEX],
    [gl.FRAGMENT_SHADER, source],
  ]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  gl.useProgram(program);
  return program;
}

function setCamera(gl, uniform, { camera: { position, target = [0, 0, 0], fov = 45 } }, aspect) {
  const forward = unit(subtract(target, position));
  const right = unit(cross(forward, [0, 1, 0]));
  const half = Math.tan((fov * Math.PI) / 360);
  gl.uniform3fv(uniform('eye'), position);
  gl.uniform3fv(uniform('forward'), forward);
  gl.uniform3fv(uniform('right'), scaled(right, half * aspect));
  gl.uniform3fv(uniform('up'), scaled(cross(right, forward), half));
}

function setScene(gl, uniform, { objects, lights, environment }) {
  const spheres = objects.map(({ center = [0, 0, 0], radius }) => [...center, radius]);
  const places = lights.map(({ position, direction }) => (position ? [...position, 1] : [...scaled(direction, -1), 0]));
  gl.uniform4fv(uniform('spheres'), spheres.flat());
  gl.uniform3fv(
    uniform('colors'),
    objects.flatMap(({ color }) => linear(color)),
  );
  gl.uniform4fv(uniform('lights'), places.flat());
  gl.uniform1fv(
    uniform('intensities'),
    lights.map(({ intensity }) => intensity),
  );
  gl.uniform3fv(uniform('sky'), environment ? linear(environment.top) : [0, 0, 0]);
  gl.uniform3fv(uniform('ground'), environment ? linear(environment.bottom) : [0, 0, 0]);
}

async function draw(canvas) {
  const scene = await (await fetch(canvas.dataset.textbook)).json();
  const gl = canvas.getContext('webgl2', { preserveDrawingBuffer: true });
  if (!gl) return;
  const program = programOf(gl, fragment(scene.objects.length, scene.lights.length));
  const uniform = (name) => gl.getUniformLocation(program, name);
  setCamera(gl, uniform, scene, canvas.width / canvas.height);
  setScene(gl, uniform, scene);
  gl.uniform2f(uniform('size'), canvas.width, canvas.height);
  gl.viewport(0, 0, canvas.width, canvas.height);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
  canvas.dataset.drawn = '';
}

for (const canvas of document.querySelectorAll('canvas[data-textbook]')) draw(canvas);
