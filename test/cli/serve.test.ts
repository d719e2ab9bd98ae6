import { type ChildProcess, spawn } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { beforeAll, expect, test } from 'vitest';
import { pageHeaders } from '../../src/page-policy.ts';
import { createDocument, serializeDocument } from '../../src/scene/document.ts';
import { built, called, irradiaPath } from '../support/cli.ts';
import { temporaryFolder } from '../support/folder.ts';

const folder = temporaryFolder();
beforeAll(() => built('lab', 'cli'));

/** Starts the lab, hands its address to `use`, and ends it as Ctrl+C does. */
async function serving(words: string[], use: (address: string) => Promise<void>): Promise<void> {
  const child = spawn(process.execPath, [irradiaPath, ...words]);
  try {
    await use(await addressOf(child));
  } finally {
    child.kill('SIGINT');
  }
  expect(await new Promise((resolve) => child.on('close', resolve))).toBe(0);
}

function addressOf(child: ChildProcess): Promise<string> {
  return new Promise((resolve, reject) => {
    let text = '';
    child.stderr?.on('data', (data) => {
      text += data;
    });
    child.stdout?.on('data', (data) => {
      text += data;
      const [address] = /http:\/\/\S+/.exec(text) ?? [];
      if (address) resolve(address);
    });
    child.on('close', () => reject(new Error(text)));
  });
}

test('serve is the default command; it serves the lab with a strict policy', async () => {
  await serving(['--port', '0'], async (address) => {
    expect(address).toMatch(/^http:\/\/localhost:\d+\/$/);
    const page = await fetch(address);
    expect(page.status).toBe(200);
    for (const [name, value] of Object.entries(pageHeaders)) expect(page.headers.get(name)).toBe(value);
    const html = await page.text();
    const [, script = ''] = /<script[^>]*src="([^"]+)"/.exec(html) ?? [];
    const response = await fetch(new URL(script, address));
    expect([response.status, response.headers.get('content-type')]).toEqual([
      200,
      'text/javascript; charset=utf-8',
    ]);
  });
});

test('serve SCENE hands a document to the page', async () => {
  const file = join(folder, 'mine.json');
  const document = createDocument('Mine');
  writeFileSync(file, serializeDocument(document));
  await serving(['serve', file, '--port', '0'], async (address) => {
    const scene = new URL(address).searchParams.get('scene') as string;
    expect(await (await fetch(new URL(scene, address))).json()).toEqual(document);
  });
});

test('serve SCENE names a scene that ships', async () => {
  await serving(['serve', 'thesis', '--port', '0'], async (address) => {
    expect(new URL(address).search).toBe('?scene=thesis');
  });
});

test('a taken port is an error if it was asked for', async () => {
  await serving(['--port', '0'], async (address) => {
    const { port } = new URL(address);
    const { code, stderr } = await called(['serve', '--port', port]);
    expect([code, stderr]).toEqual([1, `irradia: port ${port} is taken; choose another one with --port\n`]);
  });
});

test('a broken document is refused with the place of what is wrong', async () => {
  const file = join(folder, 'broken.json');
  writeFileSync(file, JSON.stringify({ format: 'irradia', version: 1, camera: { fov: 'wide' } }));
  const { code, stderr } = await called(['serve', file]);
  expect(code).toBe(1);
  expect(stderr).toMatch(/^irradia: .*broken\.json.*camera\.fov/s);
  expect(stderr).not.toContain('    at ');
});
