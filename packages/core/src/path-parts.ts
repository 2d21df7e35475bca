/** What scenes need that are gone through path by path. Importing this makes it known. */
import { emitterRecord, packEmitters } from './emitter-record.ts';
import { registerPaths } from './parts.ts';
import { pathFiles } from './path-files.ts';
import { pathNeeds } from './path-needs.ts';

registerPaths({ files: pathFiles, needs: pathNeeds, emitterRecord, packEmitters });
