// A child process that never outlives this one.
import { spawn } from 'node:child_process';

export function startChild(command, args, options) {
  const child = spawn(command, args, options);
  const kill = () => child.kill();
  process.once('exit', kill);
  for (const signal of ['SIGINT', 'SIGTERM']) {
    process.once(signal, () => {
      kill();
      // A signal that has a listener no longer ends the process: the last listener to go sends it again.
      if (process.listenerCount(signal) === 0) process.kill(process.pid, signal);
    });
  }
  child.once('exit', () => process.off('exit', kill));
  return child;
}
