import { readFile, stat } from 'node:fs/promises';
import { createServer, type IncomingMessage, type Server, type ServerResponse } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join, posix } from 'node:path';
import { isolationHeaders } from '../page-policy.ts';
import { CliError } from './command.ts';

/** A small web server for files that are on this machine, for this machine. */
export interface StaticServerOptions {
  /** Its files are served; index.html at the root. */
  folder?: string;
  /** Served beside the folder's files and before them, by path: '/scene.json'. */
  files?: ReadonlyMap<string, Uint8Array | string>;
  /** Sent with every answer. */
  headers?: Readonly<Record<string, string>>;
  /** 0 for any free port. */
  port: number;
  /** How many ports to try from `port` on, when it is taken. */
  tries?: number;
}

export interface StaticServer {
  url: string;
  close(): Promise<void>;
}

const MEDIA_TYPES: Readonly<Record<string, string>> = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.json': 'application/json; charset=utf-8',
  '.webmanifest': 'application/manifest+json',
  '.map': 'application/json; charset=utf-8',
  '.brdf': 'text/plain; charset=utf-8',
  '.glsl': 'text/plain; charset=utf-8',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.jpg': 'image/jpeg',
  '.webp': 'image/webp',
  '.ico': 'image/x-icon',
  '.wasm': 'application/wasm',
  '.woff2': 'font/woff2',
  '.glb': 'model/gltf-binary',
  '.gltf': 'model/gltf+json',
};

export async function startStaticServer(options: StaticServerOptions): Promise<StaticServer> {
  const server = createServer((request, response) => void answer(request, response, options));
  const port = await listen(server, options.port, options.tries ?? 1);
  return {
    // A browser takes http://localhost for a secure context, which WebGPU asks for.
    url: `http://localhost:${port}/`,
    close: () =>
      new Promise((resolve) => {
        server.close(() => resolve());
        server.closeAllConnections();
      }),
  };
}

async function listen(server: Server, port: number, tries: number): Promise<number> {
  try {
    await new Promise<void>((resolve, reject) => {
      server.once('error', reject);
      server.listen(port, '127.0.0.1', () => {
        server.off('error', reject);
        resolve();
      });
    });
    return (server.address() as AddressInfo).port;
  } catch (error) {
    const taken = (error as NodeJS.ErrnoException).code === 'EADDRINUSE';
    if (!taken) throw error;
    if (tries <= 1)
      throw new CliError(`port ${port} is taken; choose another one with --port`, { cause: error });
    return listen(server, port + 1, tries - 1);
  }
}

async function answer(
  request: IncomingMessage,
  response: ServerResponse,
  { folder, files, headers }: StaticServerOptions,
): Promise<void> {
  const send = (status: number, type: string, body: Uint8Array | string) => {
    const always = { 'Content-Type': type, 'X-Content-Type-Options': 'nosniff', 'Cache-Control': 'no-cache' };
    response.writeHead(status, {
      ...isolationHeaders,
      ...headers,
      ...always,
      'Content-Length': Buffer.byteLength(body),
    });
    response.end(request.method === 'HEAD' ? undefined : body);
  };
  const refuse = (status: number, text: string) => send(status, 'text/plain; charset=utf-8', `${text}\n`);

  if (request.method !== 'GET' && request.method !== 'HEAD') return refuse(405, 'only GET and HEAD');
  const path = requestedPath(request.url ?? '/');
  if (!path) return refuse(400, 'not a path');
  const type = MEDIA_TYPES[extname(path).toLowerCase()] ?? 'application/octet-stream';
  const body = files?.get(path) ?? (folder === undefined ? undefined : await readServed(folder, path));
  if (body === undefined) return refuse(404, `there is no ${path}`);
  send(200, type, body);
}

/** The path asked for, decoded, with index.html where it names a folder; null if it is no path. */
function requestedPath(url: string): string | null {
  try {
    // An absolute path has no `..` left once it is normal, so it cannot lead out of the root.
    const path = posix.normalize(decodeURIComponent(new URL(url, 'http://localhost').pathname));
    if (!path.startsWith('/') || /[\0\\]/.test(path)) return null;
    return path.endsWith('/') ? `${path}index.html` : path;
  } catch {
    return null;
  }
}

async function readServed(folder: string, path: string): Promise<Buffer | undefined> {
  const file = join(folder, path);
  const found = await stat(file).catch(() => null);
  return found?.isFile() ? readFile(file) : undefined;
}
