/** A worker thread: pictures of the f64 reference on a core of its own. */
import { parentPort } from 'node:worker_threads';
import { type ReferenceJob, renderJob } from './reference-job.ts';

parentPort?.on('message', (job: ReferenceJob) => {
  const rgb = renderJob(job);
  parentPort?.postMessage(rgb, [rgb.buffer as ArrayBuffer]);
});
