import type { ReactiveController, ReactiveControllerHost } from '@lit/reactive-element';
import type { StatsHost, StatsPanel } from './stats-panel.ts';

interface Host extends StatsHost, ReactiveControllerHost {
  readonly showStats: boolean;
}

/** Loads the panel of `show-stats` when an element first asks for it. */
export class StatsDisplay implements ReactiveController {
  readonly #host: Host;
  readonly #root: ShadowRoot;
  #panel: Promise<StatsPanel> | undefined;

  constructor(host: Host, root: ShadowRoot) {
    this.#host = host;
    this.#root = root;
    host.addController(this);
  }

  hostUpdated(): void {
    const { showStats } = this.#host;
    if (showStats) {
      this.#panel ??= import('./stats-panel.ts').then(({ StatsPanel }) => new StatsPanel(this.#host, this.#root));
    }
    this.#panel?.then((panel) => {
      panel.hidden = !showStats;
    }, reportError);
  }
}
