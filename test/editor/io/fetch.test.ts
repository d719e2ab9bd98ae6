import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { type StaticServer, startStaticServer } from '../../../src/cli/static-server.ts';
import { fetchFiles } from '../../../src/editor/io/importer/fetch.ts';

const asked: string[] = [];
let server: StaticServer;
let other: StaticServer;
beforeAll(async () => {
  other = await startStaticServer({ files: new Map([['/secret.bin', 'x']]), port: 0 });
  const files = new Map([
    ['/m/wall.obj', 'mtllib wall.mtl\nv 0 0 0\n'],
    ['/m/wall.mtl', 'newmtl a\nmap_Kd -s 2 2 2 maps/wood grain.png\nmap_Ks lost.png\n'],
    ['/m/maps/wood grain.png', 'png'],
    [
      '/m/far.gltf',
      JSON.stringify({
        buffers: [{ uri: `${other.url}secret.bin` }, { uri: '//elsewhere/x.bin' }, { uri: 'near.bin' }],
      }),
    ],
    ['/m/near.bin', 'bin'],
    ['/m/download/17', '#?RADIANCE\n'],
  ]);
  server = await startStaticServer({ files, port: 0 });
});
afterAll(async () => {
  await server.close();
  await other.close();
});
const progress = (text: string): void => void asked.push(text);

describe('a file from an address', () => {
  test('comes with what it refers to, and with what that does; what is missing is left out', async () => {
    const files = await fetchFiles(`${server.url}m/wall.obj`, progress);
    expect(files.map(({ path }) => path)).toEqual(['wall.obj', 'wall.mtl', 'maps/wood grain.png']);
  });

  test('is what it begins as, where its address does not say', async () => {
    const files = await fetchFiles(`${server.url}m/download/17`, progress);
    expect(files.map(({ path }) => path)).toEqual(['17.hdr']);
  });

  test('makes nobody ask other servers', async () => {
    const files = await fetchFiles(`${server.url}m/far.gltf`, progress);
    expect(files.map(({ path }) => path)).toEqual(['far.gltf', 'near.bin']);
  });

  test.each([
    ['javascript:alert(1)', 'only http and https'],
    ['data:text/plain,x', 'only http and https'],
    ['file:///etc/passwd', 'only http and https'],
  ])('%s is refused', async (address, message) => {
    await expect(fetchFiles(address, progress)).rejects.toThrow(message);
  });

  test('that is not there says what the server answered', async () => {
    await expect(fetchFiles(`${server.url}nothing.glb`, progress)).rejects.toThrow('the server answered 404');
  });
});
