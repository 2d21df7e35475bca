/** What our scenes cannot say, as a reason to skip a picture. */
export class Untranslatable extends Error {
  override readonly name = 'Untranslatable';
}

type Given<T, K extends keyof T> = { readonly [N in K]-?: Exclude<T[N], undefined> };

/** Fields that must be there. */
export function given<T extends object, K extends keyof T & string>(node: T, ...names: readonly K[]): Given<T, K> {
  const missing = names.filter((name) => node[name] === undefined);
  if (missing.length > 0) throw new Untranslatable(`${missing.join(' and ')} not given in ${JSON.stringify(node)}`);
  return Object.fromEntries(names.map((name) => [name, node[name]])) as Given<T, K>;
}
