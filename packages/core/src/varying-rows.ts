/** Uniform blocks handed to the fragment shader as flat varyings: row by row, as std140 has them. */
import { type BlockLayout, componentsGlsl } from './std140.ts';

export interface VaryingRows {
  /** The vertex shader: one triangle over the whole view, and the rows of the blocks. */
  readonly vertex: string;
  /** The declarations of the rows in the fragment shader. */
  readonly fragment: string;
  /** GLSL that makes a struct of an entry again: `Sphere(scene0.xyz, scene0.w)`. */
  construct(block: BlockLayout, entry: BlockLayout['entries'][number], index: number): string;
}

export function varyingRows(...blocks: readonly BlockLayout[]): VaryingRows {
  const rows = blocks.flatMap((block) =>
    Array.from({ length: block.size / 16 }, (_, i) => ({
      name: rowName(block, i),
      source: `${rowsName(block)}[${i}]`,
    })),
  );
  const uniforms = blocks.map(
    (block) => `layout(std140) uniform ${block.name} {\n  vec4 ${rowsName(block)}[${block.size / 16}];\n};\n`,
  );
  return {
    vertex: `#version 300 es
${uniforms.join('')}${rows.map(({ name }) => `flat out vec4 ${name};\n`).join('')}void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
${rows.map(({ name, source }) => `  ${name} = ${source};\n`).join('')}}
`,
    fragment: rows.map(({ name }) => `flat in vec4 ${name};\n`).join(''),
    construct(block, entry, index) {
      const members = entry.struct.members.map(({ type, offset }) => {
        const at = entry.offset + index * entry.struct.size + offset;
        return `${rowName(block, Math.floor(at / 16))}.${componentsGlsl(type, (at % 16) / 4)}`;
      });
      return `${entry.struct.name}(${members.join(', ')})`;
    },
  };
}

const rowsName = (block: BlockLayout): string => `${block.name.toLowerCase()}Rows`;
const rowName = (block: BlockLayout, row: number): string => `${block.name.toLowerCase()}${row}`;
