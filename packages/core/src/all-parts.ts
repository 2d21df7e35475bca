/** `@ray-scene/core/parts`: everything that scenes may need, for those who do not want to wait for `loadParts`. */
export { moreKinds } from './more-parts.ts';

import './css-colors.ts';
import './path-parts.ts';
