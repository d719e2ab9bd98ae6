import { mkdirSync, writeFileSync } from 'node:fs';
import { request } from 'node:http';
import { join } from 'node:path';
import { afterAll, describe, expect, test } from 'vitest';
import { startStaticServer } from '../../src/cli/static-server.ts';
import { temporaryFolder } from '../support/folder.ts';

const root = temporaryFolder();
const folder = join(root, 'served');
mkdirSync(join(folder, 'assets'), { recursive: true });
writeFileSync(join(root, 'secret.txt'), 'secret');
writeFileSync(join(folder, 'index.html'), '<!doctype html>');
writeFileSync(join(folder, 'assets/main.js'), 'export {};');
writeFileSync(join(folder, 'empty.json'), '');

const files = new Map([['/scene.json', '{"name":"é"}']]);
const server = await startStaticServer({ folder, files, headers: { 'X-Test': 'yes' }, port: 0 });
afterAll(() => server.close());

/** fetch() would tidy a path like /../ up before it sends it. */
const raw = (path: string, method = 'GET') =>
  new Promise<{ status: number | undefined; headers: Record<string, unknown>; body: string }>(
    (resolve, reject) => {
      const { hostname, port } = new URL(server.url);
      const sent = request({ hostname, port, path, method }, (response) => {
        let body = '';
        response.on('data', (data) => {
          body += data;
        });
        response.on('end', () => resolve({ status: response.statusCode, headers: response.headers, body }));
      });
      sent.on('error', reject);
      sent.end();
    },
  );

describe('the static server', () => {
  test.each([
    ['/', 'text/html; charset=utf-8', '<!doctype html>'],
    ['/?scene=thesis', 'text/html; charset=utf-8', '<!doctype html>'],
    ['/assets/main.js', 'text/javascript; charset=utf-8', 'export {};'],
    ['/scene.json', 'application/json; charset=utf-8', '{"name":"é"}'],
    ['/empty.json', 'application/json; charset=utf-8', ''],
  ])('serves %s', async (path, type, body) => {
    const response = await raw(path);
    expect(response).toMatchObject({ status: 200, body });
    expect(response.headers).toMatchObject({
      'content-type': type,
      'x-test': 'yes',
      'x-content-type-options': 'nosniff',
    });
  });

  test.each(['/nosuch.js', '/assets', '/scene'])('has no %s', async (path) => {
    expect((await raw(path)).status).toBe(404);
  });

  test.each([
    '/../secret.txt',
    '/%2e%2e/secret.txt',
    '/assets/..%2f..%2fsecret.txt',
    '//../secret.txt',
    '/%',
    '/%00',
  ])('gives nothing away at %s', async (path) => {
    const { status, body } = await raw(path);
    expect([400, 404]).toContain(status);
    expect(body).not.toContain('secret\n');
    expect(body).not.toBe('secret');
  });

  test('answers HEAD without a body, and nothing but GET and HEAD', async () => {
    const head = await raw('/', 'HEAD');
    expect([head.status, head.body, head.headers['content-length']]).toEqual([200, '', '15']);
    expect((await raw('/', 'POST')).status).toBe(405);
  });

  test('is reached from this machine only, and takes the next port if told to', async () => {
    const port = Number(new URL(server.url).port);
    await expect(startStaticServer({ folder, port })).rejects.toThrow(`port ${port} is taken`);
    const next = await startStaticServer({ folder, port, tries: 20 });
    expect(Number(new URL(next.url).port)).toBeGreaterThan(port);
    await next.close();
  });
});
