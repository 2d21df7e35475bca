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

/** @throws {Error} naming file and line, for a missing file, a circle of includes, or a condition that is off. */
export function assembleGlsl(root: string, sources: GlslSources): AssembledGlsl {
  const assembler = new Assembler(sources);
  assembler.include(root, []);
  return { text: `${assembler.text.join('\n')}\n`, lines: assembler.lines };
}

/** One `#if` that is open: whether its present branch counts, and whether an earlier one did. */
interface Branch {
  active: boolean;
  taken: boolean;
}

class Assembler {
  readonly text: string[] = [];
  readonly lines: { file: string; line: number }[] = [];
  readonly #included = new Set<string>();
  readonly #sources: GlslSources;

  constructor(sources: GlslSources) {
    this.#sources = sources;
  }

  include(file: string, from: readonly string[]): void {
    const trail = [...from, file];
    if (from.includes(file)) throw new Error(`#include goes in a circle: ${trail.join(' > ')}`);
    if (this.#included.has(file)) return;
    this.#included.add(file);
    const source = this.#sources.files[file];
    if (source === undefined) throw new Error(`no shader file ${trail.join(' > ')}`);
    const branches: Branch[] = [];
    source.split('\n').forEach((line, i) => {
      this.#line(line.replace(/\/\/.*/, '').trimEnd(), trail, i + 1, branches);
    });
    if (branches.length > 0) throw new Error(`${file}: an #if has no #endif`);
  }

  #line(line: string, trail: readonly string[], number: number, branches: Branch[]): void {
    const file = trail.at(-1) as string;
    const [, directive, rest = ''] = /^\s*#\s*(\w+)\s*(.*)$/.exec(line) ?? [];
    if (directive && this.#condition(directive, rest, branches, `${file}:${number}`)) return;
    if (line.trim() === '' || branches.some(({ active }) => !active)) return;
    if (directive === 'include') this.include(rest.replace(/"/g, ''), trail);
    else {
      this.text.push(line);
      this.lines.push({ file, line: number });
    }
  }

  /** Handles the directives of conditions; returns false for any other. */
  #condition(directive: string, rest: string, branches: Branch[], where: string): boolean {
    const current = branches.at(-1);
    switch (directive) {
      case 'ifdef':
      case 'ifndef':
      case 'if': {
        const holds = this.#holds(
          directive === 'if' ? rest : `${directive === 'ifndef' ? '!' : ''}defined(${rest})`,
          where,
        );
        branches.push({ active: holds, taken: holds });
        return true;
      }
      case 'elif':
      case 'else': {
        if (!current) throw new Error(`${where}: #${directive} without #if`);
        current.active = !current.taken && (directive === 'else' || this.#holds(rest, where));
        current.taken ||= current.active;
        return true;
      }
      case 'endif':
        if (!branches.pop()) throw new Error(`${where}: #endif without #if`);
        return true;
      default:
        return false;
    }
  }

  /** `defined(A) && !defined(B) || defined(C)`, with && before || and no parentheses. */
  #holds(condition: string, where: string): boolean {
    return condition.split('||').some((all) =>
      all.split('&&').every((term) => {
        const [, not, name = ''] = /^\s*(!?)\s*defined\s*\(\s*(\w+)\s*\)\s*$/.exec(term) ?? [];
        if (!name) throw new Error(`${where}: a condition that is off: "${term.trim()}"`);
        return this.#sources.defined.has(name) === (not === '');
      }),
    );
  }
}
