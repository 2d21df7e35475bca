// The Moon's umbra on the Earth has the diameter that plane geometry gives it.
import { expect } from '@open-wc/testing';
import { parseScene, type Scene } from '@ray-scene/core';
import { renderReference } from '@ray-scene/core/reference';
import { drawn } from '../browser/drawn.ts';
import { eclipse, FOV } from './eclipse.ts';
import { eclipsed, fullSun, heightOf, measuredRadius, SIZE, umbraRadius } from './umbra.ts';

const { RAY_SCENE_FULL: full = false } = globalThis as { RAY_SCENE_FULL?: boolean };

/** The radius of the disc that is as large as the part of the picture without any light, at the distance of its edge. */
function darkRadius(size: number): number {
  const picture = drawn(parseScene(eclipse.scene), { width: size, height: size, bounces: 1, samples: 1 });
  const dark = Array.from({ length: size * size }, (_, pixel) => picture[4 * pixel] as number).filter((x) => x === 0);
  const pixel = (2 * Math.tan((FOV * Math.PI) / 360)) / size;
  const slope = pixel * Math.sqrt(dark.length / Math.PI);
  return slope * (eclipse.camera[0] - heightOf(umbraRadius()));
}

function expectRight(what: string, found: number): void {
  const expected = umbraRadius();
  console.log(`${what}: umbra ${(2e-3 * found).toFixed(2)} km, by geometry ${(2e-3 * expected).toFixed(2)} km`);
  expect(found / expected).to.be.within(0.99, 1.01);
}

/** By paths, a Sun of so many samples. */
const settings = (samples: number) => ({ integrator: 'path', width: SIZE, height: SIZE, bounces: 1, samples }) as const;

describe('a solar eclipse', function () {
  this.timeout(full ? 900_000 : 120_000);

  it('has an umbra of the right diameter, under lamps around the limb of the Sun', () =>
    expectRight('64 lamps', darkRadius(256)));

  it('has an umbra of the right diameter, under a Sun that is a ball of light', () => {
    const picture = (scene: Scene, samples: number): Float32Array => drawn(scene, settings(samples));
    expectRight('a ball of light', measuredRadius(picture(eclipsed, full ? 4096 : 256), picture(fullSun, 16)));
  });

  if (full) {
    it('has it in the reference too', () => {
      const picture = (scene: Scene, samples: number) => renderReference(scene, settings(samples)).data;
      expectRight('a ball of light, in f64', measuredRadius(picture(eclipsed, 256), picture(fullSun, 16)));
    });
  }
});
