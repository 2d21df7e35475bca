/**
 * The std140 layout of uniform blocks (OpenGL ES 3.0, section 2.12.6.4) as arithmetic: members in, byte offsets out.
 * The GLSL text of the same members and their writer stand beside it, so the three cannot disagree.
 */

/** GLSL types that a record may hold: size and alignment in bytes, as std140 has them outside of arrays. */
const TYPES = {
  float: { size: 4, align: 4 },
  int: { size: 4, align: 4 },
  uint: { size: 4, align: 4 },
  vec3: { size: 12, align: 16 },
  vec4: { size: 16, align: 16 },
} as const;

export type GlslType = keyof typeof TYPES;

/** One member of a struct. `when` names the features without which it is left out: `'specular !specularTint'`. */
export interface Member<Name extends string = string> {
  readonly name: Name;
  readonly type: GlslType;
  readonly when?: string;
}

/** A value for each member: a number, or as many as the vector has. */
export type RecordValues<M extends readonly Member[]> = {
  readonly [K in M[number] as K['name']]: ValueOf<K['type']>;
};

type ValueOf<T extends GlslType> = T extends 'float' | 'int' | 'uint' ? number : readonly number[];

/** A struct whose members' places are known. `size` is also the stride of an array of it. */
export interface StructLayout {
  readonly name: string;
  readonly members: readonly (Member & { readonly offset: number })[];
  readonly size: number;
}

/**
 * Lays out the members whose features are present, in their order. `gapless`: not as std140 has it, but one number after
 * the other, for those who take them out of an array of vec4 by themselves.
 */
export function layoutStruct(
  name: string,
  members: readonly Member[],
  has: (feature: string) => boolean,
  gapless = false,
): StructLayout {
  let end = 0;
  const placed = members
    .filter(({ when = '' }) => when.split(' ').every((term) => term === '' || holds(term, has)))
    .map((member) => {
      const { size, align } = TYPES[member.type];
      const offset = gapless ? end : roundUp(end, align);
      end = offset + size;
      return { ...member, offset };
    });
  return { name, members: placed, size: gapless ? end : roundUp(end, 16) };
}

const holds = (term: string, has: (feature: string) => boolean): boolean =>
  term.startsWith('!') ? !has(term.slice(1)) : has(term);

/** One struct in a block, or `count` of them as an array. */
export interface BlockEntry {
  readonly name: string;
  readonly struct: StructLayout;
  readonly count?: number;
}

export interface BlockLayout {
  readonly name: string;
  readonly entries: readonly (BlockEntry & { readonly offset: number })[];
  /** In bytes, a multiple of 16; 0: GLSL does without the block. */
  readonly size: number;
}

/** Lays out structs one after the other. Empty ones, which GLSL does not know, are left out. */
export function layoutBlock(name: string, entries: readonly BlockEntry[]): BlockLayout {
  let end = 0;
  const placed = entries
    .filter(({ count, struct }) => count !== 0 && struct.members.length > 0)
    .map((entry) => {
      const offset = end;
      end += (entry.count ?? 1) * entry.struct.size;
      return { ...entry, offset };
    });
  return { name, entries: placed, size: roundUp(end, 16) };
}

/** The GLSL of the structs of a block. */
export const structGlsl = ({ entries }: BlockLayout): string =>
  entries
    .map(
      ({ struct }) =>
        `struct ${struct.name} {\n${struct.members.map(({ type, name }) => `  ${type} ${name};\n`).join('')}};\n`,
    )
    .join('');

/** The GLSL of a block: its structs, then the block itself. */
export function blockGlsl(block: BlockLayout): string {
  if (block.entries.length === 0) return '';
  const members = block.entries.map(
    ({ struct, name, count }) => `  ${struct.name} ${name}${count === undefined ? '' : `[${count}]`};\n`,
  );
  return `${structGlsl(block)}layout(std140) uniform ${block.name} {\n${members.join('')}};\n`;
}

/** How many numbers a type has. */
export const componentCount = (type: GlslType): number => TYPES[type].size / 4;

/** Writes one struct of a block, the `index`-th of an array. Values without a place in the layout are passed over. */
export function writeStruct(
  view: DataView,
  { struct, offset }: BlockLayout['entries'][number],
  index: number,
  values: { readonly [member: string]: number | readonly number[] | undefined },
): void {
  for (const member of struct.members) {
    const at = offset + index * struct.size + member.offset;
    const value = values[member.name];
    if (value === undefined) throw new TypeError(`${struct.name}.${member.name} has no value`);
    if (member.type === 'int') view.setInt32(at, value as number, true);
    else if (member.type === 'uint') view.setUint32(at, value as number, true);
    else {
      // A float takes the first component of a colour: it is there where all of them are equal.
      const components = [value].flat().slice(0, componentCount(member.type));
      components.forEach((component, i) => {
        // A zero has no sign here: which one rounding gave it must not make a difference in the bits.
        view.setFloat32(at + 4 * i, component + 0, true);
      });
    }
  }
}

const roundUp = (n: number, step: number): number => Math.ceil(n / step) * step;
