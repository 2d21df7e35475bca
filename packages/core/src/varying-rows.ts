/** The numbers of a scene handed to the fragment shader as flat varyings: vec4 rows, in which they lie without gaps. */
import { type BlockLayout, componentCount } from './std140.ts';

export interface VaryingRows {
  /** In the vertex shader: the numbers, and `passRows()`, which hands them on. */
  readonly vertex: string;
  /** In the fragment shader: the rows. */
  readonly fragment: string;
}

export function varyingRows({ name, size }: BlockLayout): VaryingRows {
  const count = rowCount(size);
  // The loop is for the sake of drivers that take long to compile each read of a uniform.
  return {
    vertex: `layout(std140) uniform ${name} {
  vec4 numbers[${count}];
};
flat out vec4 rows[${count}];
void passRows() {
  for (int i = 0; i < ${count}; i++) rows[i] = numbers[i];
}
`,
    fragment: `flat in vec4 rows[${count}];\n`,
  };
}

/** How many rows so many bytes take. */
export const rowCount = (size: number): number => size / 16;

/** GLSL that makes a struct of an entry out of rows again: `Sphere(vec3(rows[0].zw, rows[1].x), rows[1].y)`. */
export function structFromRows({ struct, offset }: BlockLayout['entries'][number], index: number): string {
  const first = (offset + index * struct.size) / 4;
  const members = struct.members.map((member) => memberFromRows(member.type, first + member.offset / 4));
  return `${struct.name}(${members.join(', ')})`;
}

function memberFromRows(type: Parameters<typeof componentCount>[0], first: number): string {
  const swizzles = new Map<number, string>();
  for (let i = first; i < first + componentCount(type); i++) {
    const row = Math.floor(i / 4);
    swizzles.set(row, (swizzles.get(row) ?? '') + 'xyzw'[i % 4]);
  }
  const pieces = [...swizzles].map(([row, swizzle]) => `rows[${row}].${swizzle}`);
  return pieces.length === 1 ? (pieces[0] as string) : `${type}(${pieces.join(', ')})`;
}
