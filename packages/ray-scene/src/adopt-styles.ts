const sheets = new Map<string, CSSStyleSheet>();

/**
 * Gives a shadow tree these styles, of which all elements of a document share one sheet. They come before those that are
 * there, so that classes that go further win. To be called again when the tree may have come into another document: a
 * sheet is of one document, and a tree that goes into another leaves it behind.
 */
export function adoptStyles(root: ShadowRoot, text: string): void {
  let sheet = sheets.get(text);
  const Sheet = root.ownerDocument.defaultView?.CSSStyleSheet;
  // Nobody sees a document without a window.
  if (!Sheet) return;
  if (!(sheet instanceof Sheet)) {
    sheet = new Sheet();
    sheet.replaceSync(text);
    sheets.set(text, sheet);
  }
  if (!root.adoptedStyleSheets.includes(sheet)) root.adoptedStyleSheets.unshift(sheet);
}
