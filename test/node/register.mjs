// `node --import ./test/node/register.mjs FILE.ts` runs the TypeScript sources without a build.
import { register } from 'node:module';

register('./hooks.mjs', import.meta.url);
process.setSourceMapsEnabled(true);
