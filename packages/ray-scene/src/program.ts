/** Compiling and linking shaders, with errors that point at the file that was written. */

/** A line of a shader file. */
interface ShaderLine {
  readonly file: string;
  readonly line: number;
}

/** What a program is made of. */
export interface ProgramSource {
  readonly vertex: string;
  readonly fragment: string;
  /** `lines[i]` is where line i + 1 of `fragment` stands in the shader files. */
  readonly lines: readonly ShaderLine[];
}

/** A shader that the driver refuses. The message names file and line and shows the lines around. */
export class ShaderError extends Error {
  override readonly name = 'ShaderError';
}

/** The binding points of uniform blocks, the same in every program. */
export const blockBindings = { Scene: 0, View: 1 } as const;

/**
 * A program whose compilation begins when it is made. Nobody asks how it went before it is first used, so that a
 * driver may compile in the background.
 */
export class Program {
  readonly #gl: WebGL2RenderingContext;
  readonly #source: ProgramSource;
  readonly #vertex: WebGLShader;
  readonly #fragment: WebGLShader;
  readonly #program: WebGLProgram;
  readonly #uniforms = new Map<string, WebGLUniformLocation | null>();
  #linked = false;

  constructor(gl: WebGL2RenderingContext, source: ProgramSource) {
    this.#gl = gl;
    this.#source = source;
    this.#vertex = compile(gl, gl.VERTEX_SHADER, source.vertex);
    this.#fragment = compile(gl, gl.FRAGMENT_SHADER, source.fragment);
    this.#program = gl.createProgram();
    gl.attachShader(this.#program, this.#vertex);
    gl.attachShader(this.#program, this.#fragment);
    gl.linkProgram(this.#program);
  }

  /** Whether using it waits for nothing. A driver that does not tell whether it is done is taken to be. */
  get isReady(): boolean {
    const parallel = this.#linked ? null : this.#gl.getExtension('KHR_parallel_shader_compile');
    // A lost context answers null, and no program is worth waiting for.
    return !parallel || this.#gl.getProgramParameter(this.#program, parallel.COMPLETION_STATUS_KHR) !== false;
  }

  /**
   * Makes it the program that draws. The first use waits for the driver.
   * @throws {ShaderError} when it does not compile.
   */
  use(): void {
    if (!this.#linked) this.#finish();
    this.#gl.useProgram(this.#program);
  }

  /** Where a uniform is; null, which WebGL ignores, where the compiler left it out. */
  uniform(name: string): WebGLUniformLocation | null {
    let location = this.#uniforms.get(name);
    if (location === undefined) {
      location = this.#gl.getUniformLocation(this.#program, name);
      this.#uniforms.set(name, location);
    }
    return location;
  }

  dispose(): void {
    this.#gl.deleteShader(this.#vertex);
    this.#gl.deleteShader(this.#fragment);
    this.#gl.deleteProgram(this.#program);
  }

  #finish(): void {
    const gl = this.#gl;
    // A lost context answers no question; its programs are made anew when it is back.
    if (!gl.getProgramParameter(this.#program, gl.LINK_STATUS) && !gl.isContextLost()) throw this.#error();
    for (const [name, binding] of Object.entries(blockBindings)) {
      const index = gl.getUniformBlockIndex(this.#program, name);
      if (index !== gl.INVALID_INDEX) gl.uniformBlockBinding(this.#program, index, binding);
    }
    this.#linked = true;
  }

  #error(): ShaderError {
    const gl = this.#gl;
    const fragmentLog = gl.getShaderInfoLog(this.#fragment);
    if (fragmentLog) return new ShaderError(explain(fragmentLog, this.#source));
    const log = gl.getShaderInfoLog(this.#vertex) || gl.getProgramInfoLog(this.#program);
    return new ShaderError(log || 'the shader does not link, and the driver does not say why');
  }
}

function compile(gl: WebGL2RenderingContext, type: GLenum, text: string): WebGLShader {
  const shader = gl.createShader(type);
  // Happens only after a loss: a type that WebGL knows gives a shader.
  if (!shader) throw new Error('WebGL has lost its context');
  gl.shaderSource(shader, text);
  gl.compileShader(shader);
  return shader;
}

/** How all browsers write a message of the compiler: `ERROR: 0:12: 'x' : undeclared identifier`. */
const MESSAGE = /^ERROR: \d+:(\d+): (.*)$/;

/** Rewrites a compiler's log in terms of the shader files; shows the source around its first error. */
function explain(log: string, { fragment, lines }: ProgramSource): string {
  const text = fragment.split('\n');
  const at = (index: number): string => `${lines[index]?.file}:${lines[index]?.line}`;
  let excerpt = '';
  const messages = log
    .replaceAll('\0', '')
    .split('\n')
    .map((entry) => {
      const [, number, message] = MESSAGE.exec(entry) ?? [];
      const index = Number(number) - 1;
      if (!lines[index]) return entry;
      excerpt ||= [index - 1, index, index + 1]
        .filter((i) => lines[i])
        .map((i) => `\n${i === index ? '>' : ' '} ${at(i)} | ${text[i]}`)
        .join('');
      return `${at(index)}: ${message}`;
    });
  return messages.join('\n').trim() + excerpt;
}
