/** Something on its way from a URL. */
export class Download<T> {
  readonly url: string;
  readonly credentials: RequestCredentials;
  /** What it makes of the answer. */
  readonly read: (answer: Response) => Promise<T>;
  /** What has arrived, or why nothing did. */
  result: { readonly value: T } | { readonly problem: string } | undefined;
  readonly #abort = new AbortController();

  /**
   * @param done told when there is a result.
   */
  constructor(url: string, credentials: RequestCredentials, read: (answer: Response) => Promise<T>, done: () => void) {
    this.url = url;
    this.credentials = credentials;
    this.read = read;
    const { signal } = this.#abort;
    fetch(url, { credentials, signal })
      .then((answer) => {
        if (!answer.ok) throw new Error(`${answer.status} ${answer.statusText}`.trim());
        return read(answer);
      })
      .then(
        (value) => ({ value }),
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
