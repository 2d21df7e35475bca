/**
 * Puts shader files together: `#include` once each, `#ifdef`, `#ifndef`, `#if defined(A) && !defined(B)`, `#elif`,
 * `#else` and `#endif` over defined names are decided here, and comments and blank lines are dropped, so that the
 * driver gets what the scene needs and nothing else. A side table says where each line comes from.
 */

export interface AssembledGlsl {
  readonly text: string;
  /** `lines[i]` is where line i + 1 of `text` stands in the files. */
  readonly lines: readonly { readonly file: string; readonly line: number }[];
}

export interface GlslSources {
  /** Text by file name, relative to `shaders/`; `#include` is relative to that folder too. */
  readonly files: { readonly [file: string]: string };
  /** The names that are defined. */
  readonly defined: ReadonlySet<string>;
}

/** One `#if` that is open: whether its present branch counts, and whether an earlier one did. */
interface Branch {
  active: boolean;
  taken: boolean;
}

/** Whether `defined(A) && !defined(B) || defined(C)` holds, with && before || and no parentheses. */
const holds = (condition: string, defined: ReadonlySet<string>): boolean =>
  condition.split('||').some((all) =>
    all.split('&&').every((term) => {
      const [, not, name = ''] = /^\s*(!?)\s*defined\s*\(\s*(\w+)\s*\)\s*$/.exec(term) ?? [];
      if (!name) throw new Error(term);
      return defined.has(name) === !not;
    }),
  );

/** Handles the directives of conditions; returns false for any other. */
function isCondition(
  directive: string | undefined,
  rest: string,
  branches: Branch[],
  defined: ReadonlySet<string>,
): boolean {
  if (directive === 'if' || directive === 'ifdef' || directive === 'ifndef') {
    const active = holds(directive === 'if' ? rest : `${directive === 'ifndef' ? '!' : ''}defined(${rest})`, defined);
    branches.push({ active, taken: active });
    return true;
  }
  if (directive !== 'elif' && directive !== 'else' && directive !== 'endif') return false;
  const branch = branches.at(-1);
  if (!branch) throw new Error(directive);
  if (directive === 'endif') branches.pop();
  else branch.active = !branch.taken && (directive === 'else' || holds(rest, defined));
  branch.taken ||= branch.active;
  return true;
}

/** @throws {Error} naming the file, for one that is missing, and the line, for a condition that is off. */
export function assembleGlsl(root: string, { files, defined }: GlslSources): AssembledGlsl {
  const text: string[] = [];
  const lines: { file: string; line: number }[] = [];
  const included = new Set<string>();

  const include = (file: string, from: readonly string[]): void => {
    const trail = [...from, file];
    if (included.has(file)) return;
    included.add(file);
    const source = files[file];
    if (source === undefined) throw new Error(`no shader file ${trail.join(' > ')}`);
    const branches: Branch[] = [];
    for (const [i, whole] of source.split('\n').entries()) {
      const line = whole.replace(/\/\/.*/, '').trimEnd();
      const [, directive, rest = ''] = /^\s*#\s*(\w+)\s*(.*)$/.exec(line) ?? [];
      try {
        if (isCondition(directive, rest, branches, defined)) continue;
      } catch (error) {
        throw new Error(`${file}:${i + 1}: a condition that is off: ${(error as Error).message}`);
      }
      if (!line || branches.some(({ active }) => !active)) continue;
      if (directive === 'include') include(rest.replace(/"/g, ''), trail);
      else {
        text.push(line);
        lines.push({ file, line: i + 1 });
      }
    }
  };

  include(root, []);
  return { text: `${text.join('\n')}\n`, lines };
}
