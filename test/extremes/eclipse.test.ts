// The Moon's umbra on the Earth has the diameter that plane geometry gives it.
import { expect } from '@open-wc/testing';
import { parseScene } from '@ray-scene/core';
import { drawn } from '../browser/drawn.ts';
import { EARTH, eclipse, FOV, MOON, SUN } from './eclipse.ts';

/** Its radius across the axis, on the ground: where the cone that touches Sun and Moon from outside meets the Earth. */
function umbraRadius(): number {
  const sine = (SUN.radius - MOON.radius) / (SUN.distance - MOON.distance);
  const apex = MOON.distance - MOON.radius / sine;
  const slope = sine / Math.sqrt(1 - sine * sine);
  let radius = 0;
  // Towards the edge the ground falls away by less than a hundredth of what the radius is: this settles at once.
  for (let i = 0; i < 50; i++) radius = (Math.sqrt(EARTH.radius ** 2 - radius ** 2) - apex) * slope;
  return radius;
}

/** The radius of the disc that is as large as the part of the picture without any light, at the distance of its edge. */
function darkRadius(size: number): number {
  const picture = drawn(parseScene(eclipse.scene), { width: size, height: size, bounces: 1, samples: 1 });
  const dark = Array.from({ length: size * size }, (_, pixel) => picture[4 * pixel] as number).filter((x) => x === 0);
  const pixel = (2 * Math.tan((FOV * Math.PI) / 360)) / size;
  const slope = pixel * Math.sqrt(dark.length / Math.PI);
  const edge = Math.sqrt(EARTH.radius ** 2 - umbraRadius() ** 2);
  return slope * (eclipse.camera[0] - edge);
}

describe('a solar eclipse', function () {
  this.timeout(60_000);

  it('has an umbra of the right diameter', () => {
    const [found, expected] = [darkRadius(256), umbraRadius()];
    console.log(`umbra ${(2e-3 * found).toFixed(2)} km, by geometry ${(2e-3 * expected).toFixed(2)} km`);
    expect(found / expected).to.be.within(0.99, 1.01);
  });
});
