import { expect } from '@open-wc/testing';
import { curveOf, stopRules } from '../../packages/ray-scene/src/stats-panel.ts';
import { QuietConsole, sceneWith } from './element-fixtures.ts';

type Scene = Awaited<ReturnType<typeof sceneWith>>;

const panelOf = ({ shadowRoot }: Scene) => shadowRoot?.querySelector<HTMLElement>('[part=stats]');

const loaded = async (scene: Scene): Promise<HTMLElement> => {
  for (;;) {
    const panel = panelOf(scene);
    if (panel) return panel;
    await new Promise(requestAnimationFrame);
  }
};

describe('show-stats', () => {
  let quiet: QuietConsole;
  beforeEach(() => {
    quiet = new QuietConsole();
  });
  afterEach(() => quiet.restore());

  it('has no panel where nobody asks for one', async () => {
    const scene = await sceneWith('<ray-sphere></ray-sphere>');
    await scene.complete;
    expect(panelOf(scene)).to.equal(null);
    expect(quiet.lines).to.deep.equal([]);
  });

  it('tells samples, size and what has ended the picture, in words that nobody is interrupted by', async () => {
    const scene = await sceneWith('<ray-sphere></ray-sphere>', 'show-stats');
    const panel = await loaded(scene);
    await scene.complete;
    scene.samples = 16;
    await scene.complete;
    await new Promise(requestAnimationFrame);
    const { width, height } = scene.stats as NonNullable<Scene['stats']>;
    expect(panel.textContent).to.contain('samples16');
    expect(panel.textContent).to.contain(`size${width} × ${height}`);
    expect(panel.textContent).to.contain('ended by16 samples');
    expect(panel.getAttribute('role')).to.equal('group');
    expect(panel.getAttribute('aria-live')).to.equal(null);
  });

  it('goes and comes back with the attribute', async () => {
    const scene = await sceneWith('<ray-sphere></ray-sphere>', 'show-stats');
    const panel = await loaded(scene);
    scene.showStats = false;
    await scene.updateComplete;
    expect(getComputedStyle(panel).display).to.equal('none');
    scene.setAttribute('show-stats', '');
    await scene.updateComplete;
    expect(getComputedStyle(panel).display).to.equal('block');
  });

  it('knows how near each rule is: noise falls with the root of time', () => {
    const stats = { samples: 64, error: 0.04, seconds: 3 } as Parameters<typeof stopRules>[0];
    const settings = { samples: 256, maxError: 0.02, maxTime: 30 } as Parameters<typeof stopRules>[1];
    expect(stopRules(stats, settings).map(({ done }) => done)).to.deep.equal([0.25, 0.25, 0.1]);
    expect(stopRules({ ...stats, error: undefined }, { ...settings, maxTime: 30 })).to.have.length(2);
  });

  it('draws an error that falls with the root of time as a straight line', () => {
    const points = [1, 2, 4, 8].map((seconds) => ({ seconds, error: 0.1 / Math.sqrt(seconds) }));
    expect(curveOf(points)).to.equal('0.0,0.0 40.0,13.3 80.0,26.7 120.0,40.0');
  });
});
