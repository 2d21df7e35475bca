/** Timer queries: what a batch took the GPU, without the time until somebody looks. Loaded with what measures noise. */
import type { GpuTimer } from './gpu-clock.ts';

/** EXT_disjoint_timer_query_webgl2, which TypeScript does not know. */
interface TimerExtension {
  readonly TIME_ELAPSED_EXT: number;
  readonly GPU_DISJOINT_EXT: number;
}

const NANOSECONDS = 1e-6;

/** Undefined where there are none, as in Firefox and WebKit, which keep exact times from pages. */
export function gpuTimer(gl: WebGL2RenderingContext): GpuTimer | undefined {
  const extension: TimerExtension | null = gl.getExtension('EXT_disjoint_timer_query_webgl2');
  if (!extension) return undefined;
  const { TIME_ELAPSED_EXT, GPU_DISJOINT_EXT } = extension;
  let query: WebGLQuery;
  return {
    begin() {
      query = gl.createQuery();
      gl.beginQuery(TIME_ELAPSED_EXT, query);
    },
    end() {
      const ended = query;
      gl.endQuery(TIME_ELAPSED_EXT);
      return () => {
        const isKnown = gl.getQueryParameter(ended, gl.QUERY_RESULT_AVAILABLE);
        // The clock was set back or went at another speed meanwhile; a driver that has none says 0.
        const isValid = isKnown && !gl.getParameter(GPU_DISJOINT_EXT);
        const nanoseconds = isValid ? gl.getQueryParameter(ended, gl.QUERY_RESULT) : 0;
        gl.deleteQuery(ended);
        return nanoseconds > 0 ? nanoseconds * NANOSECONDS : undefined;
      };
    },
  };
}
