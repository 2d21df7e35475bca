// Serves the examples: `npm start` on a fresh machine installs the packages, builds them, and prints the page to open.
// With --no-build it serves what is there. Only Node's own modules may be imported here: nothing is installed yet.
import { spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { createReadStream, existsSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, resolve, sep } from 'node:path';
import { pipeline } from 'node:stream';
import { fileURLToPath } from 'node:url';

const ROOT = fileURLToPath(new URL('..', import.meta.url)).replace(/[\\/]$/, '');
const FIRST_PORT = 8080;

const MIME_TYPES = {
  '.css': 'text/css; charset=utf-8',
  '.hdr': 'image/vnd.radiance',
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.json': 'application/json; charset=utf-8',
  '.mjs': 'text/javascript; charset=utf-8',
  '.png': 'image/png',
  '.jpg': 'image/jpeg',
  '.svg': 'image/svg+xml',
  '.glsl': 'text/plain; charset=utf-8',
  '.ts': 'text/plain; charset=utf-8',
};

function npm(...args) {
  // On Windows npm is a script of the command interpreter.
  const options = { cwd: ROOT, stdio: 'inherit', shell: process.platform === 'win32' };
  const { status } = spawnSync('npm', args, options);
  if (status !== 0) throw new Error(`npm ${args.join(' ')} failed`);
}

/** npm writes the marker as the last thing of a complete installation. */
export function installPackages() {
  if (!existsSync(resolve(ROOT, 'node_modules/.package-lock.json'))) npm('ci');
}

/** The file that a URL path stands for, or undefined if there is none or it is not for the public. */
function fileOf(pathname) {
  const path = resolve(ROOT, `.${pathname}`);
  const inside = path.startsWith(ROOT + sep) && !path.slice(ROOT.length).includes(`${sep}.`);
  const stats = inside ? statSync(path, { throwIfNoEntry: false }) : undefined;
  if (stats?.isFile()) return path;
  const index = resolve(path, 'index.html');
  return stats?.isDirectory() && existsSync(index) ? index : undefined;
}

function pathOf(url) {
  try {
    const pathname = decodeURIComponent(new URL(url, 'http://localhost').pathname);
    return pathname.includes('\0') ? undefined : pathname;
  } catch {
    return undefined;
  }
}

function respond(request, response) {
  const pathname = pathOf(request.url);
  const file = pathname === undefined ? undefined : fileOf(pathname);
  if (pathname === '/') {
    response.writeHead(302, { location: '/examples/' }).end();
  } else if (!file) {
    response.writeHead(404, { 'content-type': 'text/plain' }).end('Not found\n');
  } else if (file.endsWith(`${sep}index.html`) && !/(\/|index\.html)$/.test(pathname)) {
    // Relative links of a folder's page need the slash.
    response.writeHead(302, { location: `${pathname}/` }).end();
  } else {
    const type = MIME_TYPES[extname(file)] ?? 'application/octet-stream';
    response.writeHead(200, { 'content-type': type, 'cache-control': 'no-store' });
    pipeline(createReadStream(file), response, () => {});
  }
}

/** Serves the repository's files to this machine, at the first free port from `port` on (0: any). */
export async function serve(port) {
  const server = createServer(respond);
  for (;;) {
    server.listen(port, '127.0.0.1');
    try {
      await once(server, 'listening');
      const { port: found } = /** @type {import('node:net').AddressInfo} */ (server.address());
      return { url: `http://localhost:${found}/`, server };
    } catch (error) {
      if (error.code !== 'EADDRINUSE') throw error;
      port++;
    }
  }
}

if (resolve(process.argv[1] ?? '') === fileURLToPath(import.meta.url)) {
  if (!process.argv.includes('--no-build')) {
    installPackages();
    npm('run', '--silent', 'build');
  }
  const { url } = await serve(Number(process.env.PORT ?? FIRST_PORT));
  console.log(`Examples: ${url}examples/`);
}
