/** `@ray-scene/core` for pages that load what only some scenes need when one needs it, be it a colour. */
export { type AssembledGlsl, assembleGlsl, type GlslSources } from './assemble-glsl.ts';
export { builtInMaterials } from './built-in-materials.ts';
export {
  type CameraFrame,
  cameraAxes,
  cameraFrame,
  cameraRay,
  type ResolvedCamera,
  rayDirection,
} from './camera-frame.ts';
export { type EnvironmentImage, imageTable, imageTableByRows } from './environment-image.ts';
export { type Feature, features } from './features.ts';
export { type Field, type Fields, type Limits, Mismatch, type Values } from './fields.ts';
export type { Frame } from './frame.ts';
export { frameObjects } from './frame-objects.ts';
export { generateShader, type ShaderOptions, type ShaderSource } from './generate-shader.ts';
export { glslFiles } from './glsl-files.ts';
export { IMAGE_ROW, type ImageAtlas, imageAtlas } from './image-map.ts';
export { type JsonSchema, sceneJsonSchema } from './json-schema.ts';
export { loadPaths, loadShaderParts, loadShapes, loadWords, namesImages } from './load-parts.ts';
export { orbitCamera, panCamera, zoomCamera } from './move-camera.ts';
export { nearestWord } from './nearest-word.ts';
export { packingFrame, packScene, packView } from './pack-scene.ts';
export { parseScene, type SourceWords } from './parse-scene.ts';
export { primitives, type ShapeKind, shapeKinds } from './primitives/index.ts';
export { radianceImageByRows, readRadianceImage } from './radiance-image.ts';
export { pixelSample } from './random.ts';
export { type Intersection, intersect } from './reference/intersect.ts';
export { mergeRequirements, type Requirements, requirements, requirementsKey } from './requirements.ts';
export { type EnvironmentImages, type ResolvedScene, resolveScene } from './resolve-scene.ts';
export type { RowByRow } from './row-by-row.ts';
export { meantWord, say } from './say.ts';
export { jsonPath, type Locate, type Problem, SceneError } from './scene-error.ts';
export { isSurfaceOutput } from './scene-needs.ts';
export * from './schema.ts';
export { serializeScene } from './serialize-scene.ts';
export { parseSettings, qualities, type RenderSettings, settingsFields, settingsOf } from './settings.ts';
export type { BlockLayout } from './std140.ts';
export type { Vec3 } from './vector.ts';
export type { SampleNumber } from './view-record.ts';
