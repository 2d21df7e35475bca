const sheets = new Map<string, CSSStyleSheet>();

/**
 * Gives a shadow tree these styles, of which all elements share one sheet. They come before those that are there, so that
 * classes that go further win.
 */
export function adoptStyles(root: ShadowRoot, text: string): void {
  const sheet = sheets.get(text) ?? new CSSStyleSheet();
  if (!sheets.has(text)) sheet.replaceSync(text);
  sheets.set(text, sheet);
  root.adoptedStyleSheets.unshift(sheet);
}
