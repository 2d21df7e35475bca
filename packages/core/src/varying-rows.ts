/** Uniform blocks handed to the fragment shader as flat varyings: row by row, as std140 has them. */
import { type BlockLayout, componentsGlsl } from './std140.ts';

export interface VaryingRows {
  /** In the vertex shader: the blocks as rows, and `passRows()`, which hands them on. */
  readonly vertex: string;
  /** In the fragment shader: the rows. */
  readonly fragment: string;
}

export function varyingRows(block: BlockLayout): VaryingRows {
  const rows = Array.from({ length: block.size / 16 }, (_, i) => rowName(block, i));
  return {
    vertex: `layout(std140) uniform ${block.name} {
  vec4 rows[${rows.length}];
};
${rows.map((row) => `flat out vec4 ${row};\n`).join('')}void passRows() {
${rows.map((row, i) => `  ${row} = rows[${i}];\n`).join('')}}
`,
    fragment: rows.map((row) => `flat in vec4 ${row};\n`).join(''),
  };
}

/** GLSL that makes a struct of an entry out of rows again: `Sphere(row0.xyz, row0.w)`. */
export function structFromRows(block: BlockLayout, entry: BlockLayout['entries'][number], index: number): string {
  const members = entry.struct.members.map(({ type, offset }) => {
    const at = entry.offset + index * entry.struct.size + offset;
    return `${rowName(block, Math.floor(at / 16))}.${componentsGlsl(type, (at % 16) / 4)}`;
  });
  return `${entry.struct.name}(${members.join(', ')})`;
}

const rowName = (block: BlockLayout, row: number): string => `${block.name.toLowerCase()}${row}`;
