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
  let beforePrevious: number[] = [];
  let previous = Array.from({ length: b.length + 1 }, (_, j) => j);
  for (let i = 1; i <= a.length; i++) {
    const row = [i];
    for (let j = 1; j <= b.length; j++) {
      const differs = a[i - 1] === b[j - 1] ? 0 : 1;
      let edits = Math.min(at(previous, j) + 1, at(row, j - 1) + 1, at(previous, j - 1) + differs);
      if (i > 1 && j > 1 && a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1]) {
        edits = Math.min(edits, at(beforePrevious, j - 2) + 1);
      }
      row.push(edits);
    }
    beforePrevious = previous;
    previous = row;
  }
  return at(previous, b.length);
}

const at = (row: readonly number[], j: number): number => row[j] ?? Number.POSITIVE_INFINITY;
