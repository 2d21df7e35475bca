import { ReactiveElement } from '@lit/reactive-element';
import {
  Mismatch,
  type Problem,
  parseSettings,
  type RenderSettings,
  say,
  settingsFields,
  settingsOf,
} from '@ray-scene/core';
import type { RaySceneEvents } from './events.ts';
import { attributeOf, defineFieldProperties, type FieldHost, fieldOf, give, readAs } from './field-properties.ts';
import { unknownAttributes } from './read-markup.ts';

const names = Object.keys(settingsFields);
const attributes = names.map(attributeOf);

/** An element with the settings of the core's table as attributes and properties. */
class LitSettingsElement extends ReactiveElement implements FieldHost {
  static override get observedAttributes(): string[] {
    // biome-ignore lint/complexity/noThisInStatic: lit lists the attributes of the class that is asked, a subclass.
    return [...super.observedAttributes, ...attributes];
  }

  readonly given: { [field: string]: unknown } = {};
  #settings: RenderSettings | undefined;

  get fields(): typeof settingsFields {
    return settingsOf(this.given.quality);
  }

  /** What is given, and the defaults of what is not or cannot be read. The same object until one of them changes. */
  get settings(): RenderSettings {
    this.#settings ??= parseSettings(Object.fromEntries(names.map((name) => [name, Reflect.get(this, name)])));
    return this.#settings;
  }

  /** What is wrong with the attributes: settings that cannot be read, and words that mean nothing. */
  get attributeProblems(): readonly Problem[] {
    const known = (this.constructor as typeof LitSettingsElement).observedAttributes;
    const where = this.localName;
    const unknown = unknownAttributes(this).map((name) => say('unknownField', 'attribute', name, where, known));
    const unreadable = names.flatMap((name) => {
      const value = this.given[name];
      const read = readAs(this, name, value);
      return read instanceof Mismatch ? read.sentence(attributeOf(name), value) : [];
    });
    return [...unknown, ...unreadable].map((message) => ({ path: [], where, message }));
  }

  override attributeChangedCallback(attribute: string, before: string | null, text: string | null): void {
    if (attributes.includes(attribute)) give(this, fieldOf(attribute), text);
    else super.attributeChangedCallback(attribute, before, text);
  }

  fieldChanged(): void {
    this.#settings = undefined;
    this.requestUpdate();
  }
}

defineFieldProperties(LitSettingsElement, settingsFields);

type Settings = { -readonly [K in keyof typeof settingsFields]: (typeof settingsFields)[K]['default'] };

/**
 * The base class of `<ray-scene>`, with the properties that `defineFieldProperties` gave it. Its own events come first:
 * of several overloads TypeScript takes the first that fits.
 */
export const SettingsElement = LitSettingsElement as unknown as Omit<typeof LitSettingsElement, 'prototype'> &
  (new () => RaySceneEvents & LitSettingsElement & Settings);
