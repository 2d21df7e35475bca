/**
 * The word of `words` that someone who typed `typed` most probably meant, or undefined when none is near:
 * at most a third of the letters (but at least one) may be wrong. Case, hyphens and underscores do not count.
 */
export function nearestWord(typed: string, words: Iterable<string>): string | undefined {
  const wanted = plain(typed);
  let best: string | undefined;
  let fewest = Math.max(1, Math.floor(wanted.length / 3)) + 1;
  for (const word of words) {
    const edits = editDistance(wanted, plain(word));
    if (edits < fewest) {
      fewest = edits;
      best = word;
    }
  }
  return best;
}

const plain = (word: string): string => word.toLowerCase().replace(/[-_\s]/g, '');

/** Optimal string alignment distance: insertions, deletions, substitutions and swaps of neighbours cost 1 each. */
function editDistance(a: string, b: string): number {
  const rows: number[][] = [];
  const at = (i: number, j: number): number => rows[i]?.[j] ?? Number.POSITIVE_INFINITY;
  for (let i = 0; i <= a.length; i++) {
    const row: number[] = [];
    rows.push(row);
    for (let j = 0; j <= b.length; j++) {
      const differs = a[i - 1] === b[j - 1] ? 0 : 1;
      const swapped = a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1] ? at(i - 2, j - 2) + 1 : Number.POSITIVE_INFINITY;
      row[j] = Math.min(i + j === 0 ? 0 : swapped, at(i - 1, j) + 1, at(i, j - 1) + 1, at(i - 1, j - 1) + differs);
    }
  }
  return at(a.length, b.length);
}
