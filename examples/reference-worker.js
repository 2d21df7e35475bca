// The f64 picture of a scene, which pixels f32 cannot be asked to get right, and how far a picture is from it. All that
// takes seconds, so it happens beside the page.
import { illConditioned, relativeDifference, renderReference } from '../packages/core/dist/reference.min.js';

const LIMIT = 1e-3;

addEventListener('message', ({ data: { picture, scene, settings } }) => {
  const reference = renderReference(scene, settings);
  postMessage({
    reference,
    differences: relativeDifference(picture, reference),
    excluded: illConditioned(scene, settings, LIMIT, reference),
  });
});
