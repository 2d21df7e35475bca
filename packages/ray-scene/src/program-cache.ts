/** The programs of a context: each compiled once, however many views use it. */
import { Program, type ProgramSource } from './program.ts';

/** Programs nobody uses that are kept, for a view that is taken out of the page and put back. */
const UNUSED_KEPT = 8;

interface Entry {
  readonly key: string;
  readonly program: Program;
  users: number;
}

export class ProgramCache {
  readonly #gl: WebGL2RenderingContext;
  readonly #entries = new Map<string, Entry>();
  #compileCount = 0;

  constructor(gl: WebGL2RenderingContext) {
    this.#gl = gl;
  }

  /** How many programs were ever compiled. */
  get compileCount(): number {
    return this.#compileCount;
  }

  /** The program of this key, which stands for its source. To be released by whoever acquired it. */
  acquire(key: string, source: ProgramSource): Program {
    const entry = this.#entries.get(key) ?? this.#compile(key, source);
    entry.users++;
    return entry.program;
  }

  release(key: string, program: Program): void {
    const entry = this.#entries.get(key);
    // A program from before a loss of the context went with it.
    if (entry?.program !== program) return;
    entry.users--;
    // To the end of the line: those that nobody has used for longest go first.
    this.#entries.delete(key);
    this.#entries.set(key, entry);
    this.#evict();
  }

  /** Forgets programs that went with their context. */
  clear(): void {
    this.#entries.clear();
  }

  dispose(): void {
    for (const { program } of this.#entries.values()) program.dispose();
    this.clear();
  }

  #compile(key: string, source: ProgramSource): Entry {
    const entry = { key, program: new Program(this.#gl, source), users: 0 };
    this.#entries.set(key, entry);
    this.#compileCount++;
    return entry;
  }

  #evict(): void {
    const unused = [...this.#entries.values()].filter(({ users }) => users === 0);
    for (const { key, program } of unused.slice(0, -UNUSED_KEPT)) {
      program.dispose();
      this.#entries.delete(key);
    }
  }
}
