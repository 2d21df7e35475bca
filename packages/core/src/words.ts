/**
 * What a page needs that has colours or built-in materials by name, or something wrong in it: the colours of CSS, those
 * materials, and the sentences that tell an author what to mend. Importing this makes them known.
 */
import './css-colors.ts';
import { builtInMaterials } from './built-in-materials.ts';
import { registerMaterials } from './named-materials.ts';
import { nearestWord } from './nearest-word.ts';
import { problemTexts } from './problem-texts.ts';
import { registerSpeech } from './say.ts';
import { lengthProblems } from './scene-lengths.ts';

registerMaterials(builtInMaterials);
registerSpeech({ texts: problemTexts, nearestWord, lengthProblems });
