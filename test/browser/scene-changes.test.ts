// What one scene leaves behind in a renderer (features and places stay compiled) must not show in the next.
import '@ray-scene/core/parts';
import { expect } from '@open-wc/testing';
import { parseScene, parseSettings, type Scene } from '@ray-scene/core';
import { Renderer } from '../../packages/ray-scene/src/renderer.ts';
import { drawn } from './drawn.ts';

const names = ['classic', 'hello', 'metals', 'planes', 'planet', 'rings', 'studio'];
const size = { width: 24, height: 16 };
const sceneFile = async (name: string): Promise<Scene> =>
  parseScene(await (await fetch(`/examples/scenes/${name}.json`)).text());

describe('a scene after another', function () {
  this.timeout(60_000);

  for (const first of names) {
    it(`is drawn after ${first} as if it were the first`, async () => {
      for (const second of names) {
        const renderer = new Renderer(document.createElement('canvas'));
        renderer.onerror = (error) => {
          throw new Error(`${first}, ${second}: ${error.message}`);
        };
        renderer.setSettings(parseSettings({ integrator: 'direct', samples: 2 }));
        renderer.resize(size.width, size.height);
        for (const name of [first, second]) {
          renderer.setScene(await sceneFile(name));
          while (renderer.draw(100));
        }
        const picture = renderer.readRadiance();
        const alone = drawn(await sceneFile(second), { ...size, samples: 2 });
        // More code may round otherwise, and at an edge a sample may fall on its other side.
        const different = picture.filter((value, i) => !(Math.abs(value - (alone[i] as number)) < 1e-4)).length;
        expect(different / picture.length, `${second} after ${first}`).to.be.below(0.02);
        renderer.dispose();
      }
    });
  }
});
