/** Numbers and tables as reports have them, in Markdown. */

/** Two digits, but no more than hundredths: nobody sees less, and no measurement tells that there is nothing at all. */
export function percent(share: number): string {
  const digits = share >= 0.0995 ? 0 : share >= 0.000995 ? 1 : 2;
  return share < 0.00005 ? '< 0.01 %' : `${(100 * share).toFixed(digits)} %`;
}

export const signed = (share: number): string => `${share < 0 ? '−' : '+'}${Math.abs(100 * share).toFixed(0)} %`;

export const ms = (time: number): string =>
  time < 10 ? time.toFixed(2) : time < 100 ? time.toFixed(1) : time.toFixed(0);

export const table = (head: readonly string[], rows: readonly (readonly (string | number)[])[]): string =>
  [head, head.map((_, i) => (i === 0 ? '---' : '---:')), ...rows].map((row) => `| ${row.join(' | ')} |`).join('\n');
