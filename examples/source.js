// Shows the markup of an element as its author wrote it: <pre data-source-of="SELECTOR">. Must run before the element does,
// which may add attributes of its own.
for (const pre of document.querySelectorAll('pre[data-source-of]')) {
  const markup = document.querySelector(pre.dataset.sourceOf).outerHTML;
  const [indentation] = /\n *(?=<\/[^>]*>$)/.exec(markup) ?? [''];
  pre.textContent = markup.replaceAll('=""', '').replaceAll(indentation, '\n');
}
