import type { ObjectEvents, ObjectEventsHost } from './object-events.ts';

/** Holds back what a pointer does to a scene of child elements until it can be told to them. */
export class Pointing {
  constructor(host: ObjectEventsHost, canvas: HTMLCanvasElement) {
    let told: ObjectEvents | undefined;
    const held = (event: Event): void => {
      if (told || !host.elementOf(['objects', 0])) return;
      event.stopPropagation();
      import('./object-events.ts').then(({ ObjectEvents }) => {
        told ??= new ObjectEvents(host, canvas);
        told.handleEvent(event);
      }, reportError);
    };
    // Every pointer comes by the first of them, and a quick one goes on to the second before there is an answer.
    for (const type of ['pointerover', 'click']) canvas.addEventListener(type, held);
  }
}
