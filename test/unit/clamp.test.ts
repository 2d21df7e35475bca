// `clamp`: off, it is not there; on, no sample is brighter, and what that costs is measured.
import '@ray-scene/core/parts';
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { describe, it } from 'node:test';
import { parseScene, parseSettings, type Scene } from '@ray-scene/core';
import { renderReference } from '@ray-scene/core/reference';

const example = (name: string): Scene => parseScene(readFileSync(`examples/scenes/${name}.json`, 'utf8'));

const SIZE = { width: 16, height: 16 };

const mean = (values: ArrayLike<number>): number => {
  const colors = Array.from(values).filter((_, i) => i % 4 < 3);
  return colors.reduce((sum, value) => sum + value, 0) / colors.length;
};

/** How much of the light of a picture a clamp takes, by the same random numbers with and without. */
function biasOf(scene: Scene, clamp: number): number {
  const settings = { ...SIZE, samples: 16, integrator: 'path' } as const;
  const whole = mean(renderReference(scene, settings).data);
  return mean(renderReference(scene, { ...settings, clamp }).data) / whole - 1;
}

describe('clamp', () => {
  it('is off where nobody asks for it', () => {
    assert.equal(parseSettings().clamp, undefined);
    for (const quality of ['draft', 'balanced', 'accurate', 'reference']) {
      assert.equal(parseSettings({ quality }).clamp, undefined);
    }
  });

  it('lets no sample be brighter, keeps its colour, and leaves alone what shines where it is seen', () => {
    const scene = parseScene({
      camera: { position: [0, 0, 5] },
      lights: [{ type: 'point', position: [0, 3, 3], color: [1, 0.5, 0.25], intensity: 1000 }],
      objects: [
        { type: 'sphere', center: [-1, 0, 0] },
        { type: 'sphere', center: [1.5, 0, 0], radius: 0.5, emission: [40, 20, 10], color: 'black', specular: 0 },
      ],
    });
    const settings = { ...SIZE, samples: 1, integrator: 'path' } as const;
    const without = renderReference(scene, settings).data;
    const { data } = renderReference(scene, { ...settings, clamp: 2 });
    let [dimmed, seen] = [0, 0];
    for (let i = 0; i < data.length; i += 4) {
      const [pixel, before] = [data.subarray(i, i + 3), without.subarray(i, i + 3)];
      const largest = Math.max(...pixel);
      if (largest === 40) seen++;
      else assert.ok(largest <= 2 * (1 + 1e-12), `${largest}`);
      if (Math.max(...before) <= 2 || largest === 40) assert.deepEqual(pixel, before);
      else {
        dimmed++;
        for (const c of [1, 2]) {
          const ratio = (values: Float64Array): number => (values[c] as number) / (values[0] as number);
          assert.ok(Math.abs(ratio(pixel) / ratio(before) - 1) < 1e-12);
        }
      }
    }
    assert.ok(dimmed > 10 && seen > 5, `${dimmed}, ${seen}`);
  });

  it('takes light, the less the higher it is', (t) => {
    for (const name of ['cornell', 'rough-glass', 'shadows', 'whitted', 'ball-lens']) {
      const scene = example(name);
      const biases = [1, 10, 100].map((clamp) => biasOf(scene, clamp));
      t.diagnostic(
        `${name}: bias of clamp 1, 10, 100: ${biases.map((bias) => `${(100 * bias).toFixed(2)} %`).join(', ')}`,
      );
      assert.ok(
        biases.every((bias, i) => bias <= 0 && bias >= (biases[i - 1] ?? -1)),
        `${name}: ${biases}`,
      );
    }
  });
});
