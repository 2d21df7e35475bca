/**
 * What a page needs that has colours by name, or something wrong in it: the colours of CSS, and the sentences that tell an
 * author what to mend. Importing this makes them known.
 */
import './css-colors.ts';
import { nearestWord } from './nearest-word.ts';
import { problemTexts } from './problem-texts.ts';
import { registerSpeech } from './say.ts';
import { lengthProblems } from './scene-lengths.ts';

registerSpeech({ texts: problemTexts, nearestWord, lengthProblems });
