/** What the shader is told of emitters: one record for all kinds, whose members are there when a kind needs them. */
import type { Affine } from './affine.ts';
import type { AliasTable } from './emitter-table.ts';
import { type Emitter, type EmitterKind, type EmitterOf, emitterKinds, type Profile } from './emitters.ts';
import type { Feature } from './features.ts';
import { type Frame, toFrame } from './frame.ts';
import { glintPlaces, glintRecord } from './glints.ts';
import { lowWord } from './primitives/flat.ts';
import { planeAxes } from './primitives/plane.ts';
import { quadNormal } from './primitives/quad-shape.ts';
import { triangleNormal } from './primitives/triangle-shape.ts';
import { type BlockEntry, layoutStruct, type RecordValues } from './std140.ts';
import { cross, length, normalize, scale, subtract, type Vec3 } from './vector.ts';

/** Which kinds a member is for, by the names that `when` asks for; see `emitterEntries`. */
const groups: { readonly [group: string]: readonly EmitterKind[] } = {
  shining: ['sphere', 'quad', 'disc', 'triangle', 'box', 'cylinder'],
  placed: ['point', 'spot', 'sphere', 'quad', 'disc', 'triangle', 'box', 'cylinder'],
  directed: ['directional', 'sun', 'quad', 'disc', 'triangle', 'cylinder'],
  edged: ['quad', 'triangle', 'box'],
  spanned: ['quad', 'triangle'],
  round: ['sphere', 'disc', 'cylinder'],
  fading: ['point', 'spot'],
};

export const emitterRecord = [
  /** Intensity, irradiance or radiance, whatever is the measure of the kind. */
  { name: 'strength', type: 'vec3' },
  { name: 'kind', type: 'int', when: 'mixed' },
  { name: 'position', type: 'vec3', when: 'placed' },
  { name: 'object', type: 'int', when: 'shining' },
  { name: 'positionLow', type: 'vec3', when: 'placed wideRange' },
  { name: 'side', type: 'float', when: 'shining' },
  /** The normal of what is flat, else along the axis or to the light. */
  { name: 'axis', type: 'vec3', when: 'directed' },
  { name: 'radius', type: 'float', when: 'round' },
  { name: 'edgeU', type: 'vec3', when: 'edged' },
  { name: 'area', type: 'float', when: 'spanned' },
  { name: 'edgeV', type: 'vec3', when: 'spanned' },
  { name: 'leastAngle', type: 'float', when: 'quadEmitter' },
  { name: 'aim', type: 'vec3', when: 'aimed' },
  { name: 'outer', type: 'float', when: 'aimed' },
  { name: 'perPenumbra', type: 'float', when: 'aimed' },
  { name: 'height', type: 'float', when: 'cylinderEmitter' },
  { name: 'cone', type: 'float', when: 'sunEmitter' },
  { name: 'turn', type: 'float', when: 'imageEmitter' },
  { name: 'decays', type: 'float', when: 'fading steadyEmitter' },
  /** Of what is in a space of its own: the rows of the map into it, and its axes in the scene. */
  { name: 'ownX', type: 'vec3', when: 'placedEmitter' },
  { name: 'inOwnSpace', type: 'float', when: 'placedEmitter' },
  { name: 'ownY', type: 'vec3', when: 'placedEmitter' },
  { name: 'ownZ', type: 'vec3', when: 'placedEmitter' },
  { name: 'sceneX', type: 'vec3', when: 'placedEmitter' },
  { name: 'sceneY', type: 'vec3', when: 'placedEmitter' },
  { name: 'sceneZ', type: 'vec3', when: 'placedEmitter' },
  { name: 'probability', type: 'float', when: 'severalEmitters' },
  { name: 'threshold', type: 'float', when: 'severalEmitters' },
  { name: 'alias', type: 'int', when: 'severalEmitters' },
] as const;

const choiceRecord = [{ name: 'count', type: 'float', when: 'severalEmitters' }] as const;

type Values = RecordValues<typeof emitterRecord>;

/** The kinds that features name, in their order. */
export const presentEmitters = (features: readonly Feature[]): readonly EmitterKind[] =>
  emitterKinds.filter((kind) => features.includes(`${kind}Emitter`));

/** Kinds that no ray meets by chance. */
export const POINTS: readonly EmitterKind[] = ['point', 'spot', 'directional'];

/** The features that emitters bring with them, but for `severalEmitters`, which follows from their number. */
export function emitterFeatures(emitters: readonly Emitter[]): readonly Feature[] {
  const kinds = emitterKinds.filter((one) => emitters.some(({ kind }) => kind === one));
  const is = (feature: Feature, test: (emitter: Emitter) => boolean): readonly Feature[] =>
    emitters.some(test) ? [feature] : [];
  return [
    ...kinds.map((kind) => `${kind}Emitter` as const),
    ...is('areaEmitter', ({ kind }) => !POINTS.includes(kind)),
    ...is('steadyEmitter', (one) => 'decay' in one && one.decay === 0),
    ...is('aimedBall', (one) => one.kind === 'sphere' && !!one.profile),
    ...is('innerEmitter', (one) => hasInside(one) && one.side !== 'front'),
    ...is('placedEmitter', (one) => !!placeOfOwn(one)),
  ];
}

const hasInside = (emitter: Emitter): emitter is EmitterOf<'sphere' | 'box' | 'cylinder'> =>
  emitter.kind === 'sphere' || emitter.kind === 'box' || emitter.kind === 'cylinder';

/** What the block `Scene` holds of emitters: `emitters[capacity]`, how many of them there are, and their glints. */
export function emitterEntries(features: readonly Feature[], capacity: number): readonly BlockEntry[] {
  const present = presentEmitters(features);
  const has = (term: string): boolean => {
    if (term === 'mixed') return present.length > 1;
    if (term === 'aimed') return features.includes('aimedBall') || features.includes('spotEmitter');
    return groups[term]?.some((kind) => present.includes(kind)) ?? features.some((feature) => feature === term);
  };
  return [
    { name: 'emitters', struct: layoutStruct('Emitter', emitterRecord, has), count: capacity },
    { name: 'choice', struct: layoutStruct('Choice', choiceRecord, has) },
    { name: 'glints', struct: layoutStruct('Glint', glintRecord, has), count: glintPlaces(features) },
  ];
}

/** Of the values of a choice. */
export const packChoice = (emitters: readonly Emitter[]): RecordValues<typeof choiceRecord> => ({
  count: emitters.length,
});

/** The values of the `index`-th emitter, in f64: rounding to f32 is the last step. */
export function packEmitter(emitters: readonly Emitter[], table: AliasTable, index: number, frame: Frame): Values {
  const emitter = emitters[index] as Emitter;
  return {
    ...ABSENT_EMITTER,
    ...placedIn(emitter, frame),
    kind: emitterKinds.indexOf(emitter.kind),
    strength: strengthOf(emitter, frame),
    ...('object' in emitter ? { object: emitter.object, side: SIDES[emitter.side] } : {}),
    ...('profile' in emitter && emitter.profile ? packProfile(emitter.profile) : {}),
    probability: table.probabilities[index] as number,
    threshold: table.thresholds[index] as number,
    alias: table.aliases[index] as number,
  };
}

/** More than this would be infinite in f32 before long. */
const LARGEST = 1e30;

/** What sends out no light, for places that no emitter fills. */
export const ABSENT_EMITTER: Values = {
  strength: [0, 0, 0],
  kind: 0,
  position: [0, 0, 0],
  object: -1,
  positionLow: [0, 0, 0],
  side: 0,
  axis: [0, 0, 1],
  radius: 0,
  edgeU: [0, 0, 0],
  area: 0,
  edgeV: [0, 0, 0],
  leastAngle: LARGEST,
  aim: [0, 0, 1],
  // What has no profile is the same in all directions.
  outer: 5,
  perPenumbra: 1,
  height: 0,
  cone: 1,
  turn: 0,
  decays: 1,
  ownX: [1, 0, 0],
  inOwnSpace: 0,
  ownY: [0, 1, 0],
  ownZ: [0, 0, 1],
  sceneX: [1, 0, 0],
  sceneY: [0, 1, 0],
  sceneZ: [0, 0, 1],
  probability: 0,
  threshold: 0,
  alias: 0,
};

const SIDES = { front: 1, back: -1, both: 0 } as const;

function strengthOf(emitter: Emitter, { scale: unit }: Frame): Vec3 {
  switch (emitter.kind) {
    case 'point':
    case 'spot':
      // Distances are in units of the frame, so candelas are too.
      return limited(scale(emitter.intensity, emitter.decay === 2 ? unit * unit : 1));
    case 'directional':
      return limited(emitter.irradiance);
    case 'image':
      return limited([emitter.intensity, emitter.intensity, emitter.intensity]);
    default:
      return limited(emitter.radiance);
  }
}

const limited = ([r, g, b]: Vec3): Vec3 => [Math.min(r, LARGEST), Math.min(g, LARGEST), Math.min(b, LARGEST)];

const packProfile = ({ axis, outer, penumbra }: Profile) => ({
  aim: axis,
  outer,
  // A hard edge is very steep.
  perPenumbra: Math.min(1 / (outer * penumbra), LARGEST),
});

const placeOfOwn = (emitter: Emitter): Affine | undefined => ('place' in emitter ? emitter.place : undefined);

/** Where an emitter is, in the scene or in a space of its own, whose unit makes volumes there as large as in the scene. */
function placedIn(emitter: Emitter, frame: Frame): Partial<Values> {
  const place = placeOfOwn(emitter);
  if (!place) return placeOf(emitter, frame);
  const factor = place.meanFactor;
  const [ownX, ownY, ownZ] = place.inverse.map((row) => scale(row, factor)) as [Vec3, Vec3, Vec3];
  const [sceneX, sceneY, sceneZ] = place.columns.map((column) => scale(column, 1 / factor)) as [Vec3, Vec3, Vec3];
  const own: Frame = { origin: place.pointBack(frame.origin), scale: frame.scale * factor };
  return { ...placeOf(emitter, own), inOwnSpace: 1, ownX, ownY, ownZ, sceneX, sceneY, sceneZ };
}

/** Where an emitter is, and how large. */
function placeOf(emitter: Emitter, frame: Frame): Partial<Values> {
  const at = (position: Vec3) => {
    const packed = toFrame(frame, position);
    return { position: packed, positionLow: lowWord(packed) };
  };
  const inFrame = (v: Vec3): Vec3 => scale(v, frame.scale);
  switch (emitter.kind) {
    case 'directional':
      return { axis: emitter.toLight };
    case 'sun':
      return { axis: emitter.toLight, cone: emitter.cone };
    case 'image':
      return { turn: emitter.turn - Math.floor(emitter.turn) };
    case 'sphere':
      return { ...at(emitter.center), radius: emitter.radius * frame.scale };
    case 'disc':
      return { ...at(emitter.center), axis: planeAxes(emitter).normal, radius: emitter.radius * frame.scale };
    case 'quad': {
      const [edgeU, edgeV] = [inFrame(emitter.edgeU), inFrame(emitter.edgeV)];
      const leastAngle = Math.min(emitter.leastAngle, LARGEST);
      const axis = quadNormal(emitter);
      return { ...at(emitter.corner), axis, edgeU, edgeV, area: length(cross(edgeU, edgeV)), leastAngle };
    }
    case 'triangle': {
      const edgeU = inFrame(subtract(emitter.b, emitter.a));
      const edgeV = inFrame(subtract(emitter.c, emitter.a));
      return { ...at(emitter.a), axis: triangleNormal(emitter), edgeU, edgeV, area: length(cross(edgeU, edgeV)) / 2 };
    }
    case 'box':
      return { ...at(emitter.center), edgeU: inFrame(scale(emitter.size, 0.5)) };
    case 'cylinder': {
      const along = subtract(emitter.top, emitter.base);
      const sizes = { radius: emitter.radius * frame.scale, height: length(along) * frame.scale };
      return { ...at(emitter.base), axis: normalize(along), ...sizes };
    }
    default:
      return { ...at(emitter.position), decays: emitter.decay === 2 ? 1 : 0 };
  }
}
