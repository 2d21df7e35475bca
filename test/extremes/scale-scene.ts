/** A scene file with all lengths multiplied: by DESIGN the same scene, if the light of its lamps is multiplied with them. */
type Json = { readonly [key: string]: unknown };

const LENGTHS = new Set([
  'position',
  'target',
  'center',
  'radius',
  'tube',
  'point',
  'corner',
  'edgeU',
  'edgeV',
  'size',
  'base',
  'top',
  'tip',
  'a',
  'b',
  'c',
  'checkerSize',
]);

const times = (value: unknown, factor: number): unknown =>
  Array.isArray(value) ? value.map((x) => x * factor) : Number(value) * factor;

/** A camera, a shape, or a group with all that is in it: what a group scales is lengths that are scaled already. */
const scaleNode = (node: Json, factor: number): Json => ({
  ...Object.fromEntries(
    Object.entries(node).map(([key, value]) => [key, LENGTHS.has(key) ? times(value, factor) : value]),
  ),
  ...(node.objects ? { objects: nodesOf(node, 'objects').map((object) => scaleNode(object, factor)) } : {}),
  ...(node.lights ? { lights: nodesOf(node, 'lights').map((light) => scaleLight(light, factor)) } : {}),
});

const nodesOf = (node: Json, key: string): readonly Json[] => (node[key] as readonly Json[] | undefined) ?? [];

const scaleLight = (light: Json, factor: number): Json => {
  const scaled = scaleNode(light, factor);
  const fades = (light.type ?? 'point') === 'point' && light.decay !== 0;
  const intensity = Math.min(Number(light.intensity ?? 1) * factor * factor, 1e60);
  return fades ? { ...scaled, intensity } : scaled;
};

/**
 * Multiplies all lengths of a scene by a factor, and intensities of lights that fade by its square, as far as a file may
 * say it.
 */
export const scaleScene = (scene: Json, factor: number): Json => ({
  ...scaleNode(scene, factor),
  ...(scene.camera ? { camera: scaleNode(scene.camera as Json, factor) } : {}),
});
