// Shader text for scenes in which some names are never defined: what stands under them goes, and every line stays where it is.

/** @param absent the names that are not defined. */
export function plainGlsl(text, absent) {
  const open = [];
  const isLive = () => open.every(({ live }) => live);
  return text
    .split('\n')
    .map((line) => {
      const [, directive, rest = ''] = /^\s*#\s*(if|ifdef|ifndef|elif|else|endif)\b\s*([^/]*)/.exec(line) ?? [];
      if (!directive) return isLive() ? line : '';
      if (directive.startsWith('if')) open.push({ live: true, kept: false, decided: false, outer: isLive() });
      const branch = open.at(-1);
      if (directive === 'endif') open.pop();
      const kept =
        directive === 'endif' ? branch.kept && '#endif' : nextBranch(branch, condition(directive, rest, absent));
      return kept && branch.outer ? kept : '';
    })
    .join('\n');
}

/** Goes on to a branch under a condition: returns the directive that is left of it, if there is one. */
function nextBranch(branch, holds) {
  branch.live = !branch.decided && holds !== false;
  if (!branch.live) return undefined;
  branch.decided = holds === true;
  if (holds === true) return branch.kept ? '#else' : undefined;
  const directive = branch.kept ? '#elif' : '#if';
  branch.kept = true;
  return `${directive} ${holds}`;
}

/** Whether a branch is taken; where that is open, what remains of its condition. */
function condition(directive, rest, absent) {
  if (directive === 'else') return true;
  const name = rest.trim();
  const whole = directive === 'ifdef' ? `defined(${name})` : directive === 'ifndef' ? `!defined(${name})` : rest;
  const any = whole.split('||').map((all) => {
    const terms = all.split('&&').map((term) => {
      const [, not, asked] = /^\s*(!?)\s*defined\s*\(\s*(\w+)\s*\)\s*$/.exec(term);
      return absent.has(asked) ? not === '!' : term.trim();
    });
    return terms.includes(false) ? false : terms.filter((term) => term !== true).join(' && ') || true;
  });
  return any.includes(true) || any.filter((all) => all !== false).join(' || ') || false;
}
