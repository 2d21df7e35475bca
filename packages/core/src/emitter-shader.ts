/** The part of a shader that tells the kinds of emitters apart: none of it for a scene with but one kind. */
import { POINTS, presentEmitters } from './emitter-record.ts';
import { type EmitterKind, emitterKinds } from './emitters.ts';
import type { Feature } from './features.ts';
import { structName } from './pack-scene.ts';
import { ROULETTE_FROM } from './path-needs.ts';
import type { Requirements } from './requirements.ts';

/** The file `generated/emitters.glsl`. */
export function emittersGlsl(features: readonly Feature[]): string {
  const kinds = presentEmitters(features);
  const includes = kinds.map((kind) => `#include "light/emitter/${kind}.glsl"\n`);
  const pdfOf = (kind: EmitterKind): string =>
    POINTS.includes(kind) ? 'return 0.0;' : `return ${kind}Pdf(e, from, d, t, cosine, own);`;
  const isPlaced = features.includes('placedEmitter');
  const [sampleName, pdfName] = isPlaced ? ['ownSampleOf', 'ownPdfOf'] : ['sampleOf', 'pdfOf'];
  return `${includes.join('')}
EmitterSample ${sampleName}(Emitter e, vec3 p, vec2 u, bool own) {
${forKind(kinds, (kind) => `return ${kind}Sample(e, p, u, own);`)}}
#ifdef AREA_EMITTER
float ${pdfName}(Emitter e, vec3 from, vec3 d, float t, float cosine, bool own) {
${forKind(kinds, pdfOf)}}
#endif
${isPlaced ? ownSpaceGlsl(kinds) : ''}${isKindGlsl(kinds, 'sun')}${isKindGlsl(kinds, 'image')}`;
}

/** Where some are in a space of their own. */
const ownSpaceGlsl = (kinds: readonly EmitterKind[]): string => `#include "light/emitter/own-cosine.glsl"
float ownCosine(Emitter e, vec3 q, vec3 d) {
${forKind(kinds, (kind) => `return ${cosineOf[kind] ?? '1.0'};`)}}
#include "light/emitter/own-space.glsl"
`;

/** With the normal where a ray along d met an emitter, q from where it is; of kinds whose pdf asks for it. */
const cosineOf: { readonly [K in EmitterKind]?: string } = {
  quad: 'dotInOrder(e.axis, d)',
  disc: 'dotInOrder(e.axis, d)',
  triangle: 'dotInOrder(e.axis, d)',
  box: 'boxCosine(e, q, d)',
  cylinder: 'cylinderCosine(e, q, d)',
};

/** `isSun(Emitter e)`, where there are suns. */
function isKindGlsl(kinds: readonly EmitterKind[], kind: EmitterKind): string {
  if (!kinds.includes(kind)) return '';
  const test = kinds.length > 1 ? `e.kind == ${emitterKinds.indexOf(kind)}` : 'true';
  return `bool is${structName(kind)}(Emitter e) {\n  return ${test};\n}\n`;
}

function forKind(kinds: readonly EmitterKind[], statement: (kind: EmitterKind) => string): string {
  const lines = kinds.map((kind, i) => {
    const condition = i === kinds.length - 1 ? '' : `if (e.kind == ${emitterKinds.indexOf(kind)}) `;
    return `  ${condition}${statement(kind)}\n`;
  });
  return lines.join('');
}

/** The file `generated/limits.glsl`. */
export function limitsGlsl({ bounces, features, emitters }: Requirements): string {
  const roulette = features.includes('roulette') ? `const int ROULETTE_FROM = ${ROULETTE_FROM};\n` : '';
  const isListed = (['sunEmitter', 'imageEmitter', 'whitted'] as const).some((feature) => features.includes(feature));
  const list = isListed ? `const int EMITTERS = ${emitters};\n` : '';
  return `const int BOUNCES = ${bounces};\n${roulette}${list}`;
}
