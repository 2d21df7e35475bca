import { expect } from '@open-wc/testing';
import { RenderDevice, WebGLUnavailableError } from '../../packages/ray-scene/src/render-device.ts';
import { countObjects, fillSource } from './gl-fixtures.ts';

describe('RenderDevice', () => {
  it('is one for the page, and a new one after it was disposed of', () => {
    const first = RenderDevice.shared;
    expect(RenderDevice.shared).to.equal(first);
    first.dispose();
    expect(RenderDevice.shared).not.to.equal(first);
    RenderDevice.shared.dispose();
  });

  it('says what is wrong when there is no WebGL 2', () => {
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement) {
      this.dispatchEvent(new WebGLContextEvent('webglcontextcreationerror', { statusMessage: 'GPU is on holiday' }));
      return null;
    } as typeof getContext;
    try {
      expect(() => RenderDevice.shared)
        .to.throw(WebGLUnavailableError)
        .with.property('message')
        .that.matches(/needs WebGL 2, .*: GPU is on holiday\. Hardware acceleration may be switched off/);
    } finally {
      HTMLCanvasElement.prototype.getContext = getContext;
    }
    RenderDevice.shared.dispose();
  });

  it('uses half floats where asked to', () => {
    const device = new RenderDevice({ precision: 'half' });
    expect(device.precision).to.equal('half');
    device.dispose();
  });

  it('compiles a program once for all who use it, and keeps some that nobody uses', () => {
    const device = new RenderDevice();
    const counts = countObjects(device.gl);
    const { programs } = device;
    const a = programs.acquire('a', fillSource('vec4(1)'));
    expect(programs.acquire('a', fillSource('vec4(1)'))).to.equal(a);
    programs.release('a', a);
    programs.release('a', a);
    expect(programs.acquire('a', fillSource('vec4(1)'))).to.equal(a);
    expect(device.compileCount).to.equal(1);
    for (let i = 0; i < 20; i++) programs.release(`${i}`, programs.acquire(`${i}`, fillSource('vec4(1)')));
    expect(counts.Program).to.equal(1 + 8);
    programs.release('a', a);
    device.dispose();
    expect(counts.Program).to.equal(0);
    expect(device.gl.isContextLost()).to.equal(true);
  });

  it('shows views of different sizes on canvases of their own', () => {
    const device = new RenderDevice();
    const { gl } = device;
    const sizes = [
      [40, 7],
      [3, 30],
      [1, 1],
      [12, 12],
    ] as const;
    const pictures = sizes.map(([width, height], i) => {
      const context = document.createElement('canvas').getContext('2d') as CanvasRenderingContext2D;
      device.present(context, width, height, () => {
        gl.clearBufferfv(gl.COLOR, 0, [0, 0, 0, 0]);
        gl.enable(gl.SCISSOR_TEST);
        // The upper right pixel of the view.
        gl.scissor(width - 1, height - 1, 1, 1);
        gl.clearBufferfv(gl.COLOR, 0, [i / 255, 1, 0, 1]);
        gl.disable(gl.SCISSOR_TEST);
      });
      return context;
    });
    sizes.forEach(([width, height], i) => {
      const { data } = (pictures[i] as CanvasRenderingContext2D).getImageData(0, 0, width, height);
      expect([...data.slice(4 * (width - 1), 4 * width)]).to.deep.equal([i, 255, 0, 255]);
      expect(data.filter((value) => value > 0).length).to.equal(i === 0 ? 2 : 3);
    });
    device.dispose();
  });
});
