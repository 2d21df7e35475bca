/** One thing that is wrong with a scene, told so that its author can mend it. */
export interface Problem {
  /** Where: keys and indices from the root of the scene, e.g. `['objects', 2, 'radius']`. */
  readonly path: readonly (string | number)[];
  /** Where, for people: a JSON path (`objects[2].radius`) or an element (`ray-scene > ray-sphere[2]`). */
  readonly where: string;
  /** What was found, what is allowed, and the nearest right word where there is one. */
  readonly message: string;
}

/** Says where a path of keys and indices is, in the words of the source that the scene came from. */
export type Locate = (path: Problem['path']) => string;

/** `['objects', 2, 'radius']` as `objects[2].radius`; the root is `scene`. */
export const jsonPath: Locate = (path) =>
  path.map((key, i) => (typeof key === 'number' ? `[${key}]` : i === 0 ? key : `.${key}`)).join('') || 'scene';

/** Everything that is wrong with a scene, all at once. `message` holds one line per problem. */
export class SceneError extends Error {
  override readonly name = 'SceneError';
  readonly problems: readonly Problem[];

  constructor(problems: readonly Problem[]) {
    super(problems.map(({ where, message }) => `${where}: ${message}`).join('\n'));
    this.problems = Object.freeze([...problems]);
  }
}
