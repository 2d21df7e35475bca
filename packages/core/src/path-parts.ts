/** What scenes need that are gone through path by path. Importing this makes it known. */
import { ABSENT_EMITTER, emitterEntries, packChoice, packEmitter } from './emitter-record.ts';
import { emittersGlsl, limitsGlsl } from './emitter-shader.ts';
import { emitterTable } from './emitter-table.ts';
import { sceneEmitters } from './emitters.ts';
import { ABSENT_GLINT, glintPlaces, packGlint, sceneGlints } from './glints.ts';
import { type PathParts, registerPaths } from './parts.ts';
import { pathFiles } from './path-files.ts';
import { packPathMaterial, pathMaterialRecord } from './path-material.ts';
import { pathFeatures, pathNeeds } from './path-needs.ts';
import { packPathEye, pathEyeRecord } from './path-view.ts';
import { packingOrigin } from './ray-start.ts';

const packEmitters: PathParts['packEmitters'] = (scene, frame, numbers, { emitters: count, features }) => {
  const emitters = sceneEmitters(scene);
  const table = emitterTable(emitters);
  const records = emitters.map((emitter, i) => {
    const object = 'object' in emitter ? emitter.object : undefined;
    const record = packEmitter(emitters, table, i, frame);
    return { object, record: object === undefined ? record : { ...record, object: numbers[object] as number } };
  });
  const missing = Array.from({ length: count - records.length }, () => ({ object: undefined, record: ABSENT_EMITTER }));
  const glints = sceneGlints(scene, emitters).map((glint) => packGlint(glint, frame, numbers[glint.object] as number));
  const places = Array.from({ length: glintPlaces(features) }, (_, i) => glints[i] ?? ABSENT_GLINT);
  return { emitters: [...records, ...missing], choice: packChoice(emitters), glints: places };
};

registerPaths({
  files: pathFiles,
  needs: pathNeeds,
  features: pathFeatures,
  materialRecord: pathMaterialRecord,
  packMaterial: packPathMaterial,
  origin: packingOrigin,
  eyeRecord: pathEyeRecord,
  packEye: packPathEye,
  emitterEntries,
  emittersGlsl,
  limitsGlsl,
  packEmitters,
});
