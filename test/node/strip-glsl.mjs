// Shader text as the one file holds it.

/** Comments and needless blanks and zeros go; every line stays where it is, as messages about shaders count them. */
export function stripGlsl(text) {
  return shortLocalNames(text.replace(/\/\/.*/g, ''))
    .replace(/^[ \t]+|[ \t\r]+$/gm, '')
    .replace(/^[^#\n].*$/gm, (line) =>
      line
        .replace(/ ?([=*/<>(),;{}?:]|&&|\|\|) ?/g, '$1')
        // `a - -b` must not become `a--b`.
        .replace(/(?<![-+]) ?([-+]) ?(?![-+])/g, '$1')
        .replace(/(\d\.)0\b/g, '$1')
        .replace(/\b0(\.\d)/g, '$1'),
    );
}

const GLSL_FUNCTION = /^(\w+ \w+)\(([^\n]*)\) \{\n(.*?)^\}/gms;
const GLSL_LOCAL = /\b(?:float|u?int|bool|[biu]?vec[234]|mat[234]|[A-Z]\w*) (\w+)(?=[,;)]| =)/g;
const GLSL_WORD = /(?<![.\w])[a-z]\w*/gi;

/** Gives one letter to the parameters and variables of each function, where it has a letter to spare. */
function shortLocalNames(text) {
  return text.replace(GLSL_FUNCTION, (all, head, parameters, body) => {
    // What comes from elsewhere may use the names.
    if (/#\s*(include|define)/.test(body)) return all;
    const locals = new Set([...`${parameters};${body}`.matchAll(GLSL_LOCAL)].map(([, name]) => name));
    const words = new Set(`${parameters} ${body}`.match(GLSL_WORD));
    const spare = [...'abcdefghijklmnopqrstuvwxyz'].filter((letter) => !words.has(letter));
    const long = [...locals].filter((name) => name.length > 1).slice(0, spare.length);
    const short = new Map(long.map((name, i) => [name, spare[i]]));
    const renamed = (glsl) => glsl.replace(GLSL_WORD, (word) => short.get(word) ?? word);
    return `${head}(${renamed(parameters)}) {\n${renamed(body)}}`;
  });
}
