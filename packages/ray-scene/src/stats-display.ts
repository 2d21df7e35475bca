import type { ReactiveController, ReactiveControllerHost } from '@lit/reactive-element';
import type { StatsHost, StatsPanel } from './stats-panel.ts';

interface Host extends StatsHost, ReactiveControllerHost {
  readonly showStats: boolean;
}

/** Loads the panel of `show-stats` when an element first asks for it. */
export class StatsDisplay implements ReactiveController {
  readonly #host: Host;
  #panel: StatsPanel | undefined;
  #loading = false;

  constructor(host: Host) {
    this.#host = host;
    host.addController(this);
  }

  hostUpdated(): void {
    const { shadowRoot, showStats } = this.#host;
    if (this.#panel) this.#panel.hidden = !showStats;
    if (!showStats || this.#loading || !shadowRoot) return;
    this.#loading = true;
    import('./stats-panel.ts').then(({ StatsPanel }) => {
      this.#panel = new StatsPanel(this.#host, shadowRoot);
    }, reportError);
  }
}
