import type { Requirements } from './requirements.ts';
export function indexedObjects(_required: Requirements): string {
  return '';
}
