/** A text on its way from a URL. */
export class Download {
  readonly url: string;
  readonly credentials: RequestCredentials;
  /** What has arrived, or why nothing did. */
  result: { readonly text: string } | { readonly problem: string } | undefined;
  readonly #abort = new AbortController();

  /** @param done told when there is a result. */
  constructor(url: string, credentials: RequestCredentials, done: () => void) {
    this.url = url;
    this.credentials = credentials;
    const { signal } = this.#abort;
    fetchText(url, { credentials, signal })
      .then(
        (text) => ({ text }),
        (error: Error) => ({ problem: `could not be loaded: ${error.message}` }),
      )
      .then((result) => {
        // An answer to a question that nobody asks any more.
        if (signal.aborted) return;
        this.result = result;
        done();
      });
  }

  cancel(): void {
    this.#abort.abort();
  }
}

async function fetchText(url: string, init: RequestInit): Promise<string> {
  const response = await fetch(url, init);
  if (!response.ok) throw new Error(`${response.status} ${response.statusText}`.trim());
  return response.text();
}
