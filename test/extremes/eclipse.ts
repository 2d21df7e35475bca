/**
 * A total eclipse at true scale, in metres: the Sun in its mean distance, the Moon as near as it gets. The camera is in
 * space between Earth and Moon, and looks at where the umbra falls.
 */
type Vec3 = readonly [number, number, number];

export const SUN = { radius: 6.957e8, distance: 1.496e11 } as const;
export const MOON = { radius: 1.7374e6, distance: 3.633e8 } as const;
export const EARTH = { radius: 6.371e6 } as const;

/**
 * The integrator `direct` knows lights without extent: as many as a scene may hold, around the Sun's limb. The umbra is
 * where all of them are hidden. A sphere light in their place would show the same umbra, and the penumbra around it.
 */
const LAMPS = 64;

/** From the Earth's centre, which is the origin, to the Sun: along x. */
const limb = (i: number): Vec3 => {
  const angle = (2 * Math.PI * i) / LAMPS;
  // Where lines from the Moon touch the Sun.
  const slope = SUN.radius / (SUN.distance - MOON.distance);
  const aside = SUN.radius * Math.sqrt(1 - slope * slope);
  return [SUN.distance - SUN.radius * slope, aside * Math.cos(angle), aside * Math.sin(angle)];
};

/** 2 million metres above the ground, so that the umbra fills half of the view. */
const CAMERA: Vec3 = [8.4e6, 0, 0];
export const FOV = 5.6;

export const eclipse = {
  camera: CAMERA,
  scene: {
    camera: { position: CAMERA, target: [0, 0, 0], fov: FOV },
    lights: Array.from({ length: LAMPS }, (_, i) => ({
      type: 'point',
      position: limb(i),
      intensity: (3 * SUN.distance ** 2) / LAMPS,
    })),
    objects: [
      { type: 'sphere', name: 'Earth', radius: EARTH.radius, color: '#88a', specular: 0 },
      { type: 'sphere', name: 'Moon', center: [MOON.distance, 0, 0], radius: MOON.radius, color: 'gray', specular: 0 },
    ],
  },
} as const;
