import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { zipSync } from 'fflate';
import { beforeAll, describe, expect, test, vi } from 'vitest';
import { readGlb } from '../../src/io/gltf/glb.ts';
import { encodePng } from '../../src/io/png.ts';
import { parseDocument } from '../../src/scene/document.ts';
import { built, called, irradia } from '../support/cli.ts';
import { temporaryFolder } from '../support/folder.ts';

beforeAll(() => built('cli'));
vi.setConfig({ testTimeout: 180_000 });

const folder = temporaryFolder();
const path = (name: string) => join(folder, name);
const bytesOf = (text: string) => new TextEncoder().encode(text);
const obj =
  'mtllib wall.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl Bricks\nf 1/1 2/2 3/3 4/4\n';
const mtl = 'newmtl Bricks\nKd 0.9 0.8 0.7\nmap_Kd maps/bricks.png\n';
const png = encodePng(new Uint8Array(16).fill(128), 2, 2);

beforeAll(() => {
  mkdirSync(path('maps'));
  writeFileSync(path('wall.obj'), obj);
  writeFileSync(path('wall.mtl'), mtl);
  writeFileSync(path('maps/bricks.png'), png);
});

describe('irradia convert', () => {
  test('an OBJ with what lies beside it, to a document, and that to a GLB', async () => {
    const first = await irradia(['convert', path('wall.obj'), '-o', path('wall.json')]);
    expect(first).toMatchObject({ code: 0, stderr: '' });
    const document = parseDocument(readFileSync(path('wall.json'), 'utf8'), 'wall.json');
    const [material] = Object.values(document.materials);
    expect(material).toMatchObject({ name: 'Bricks', parameters: { baseColor: [0.9, 0.8, 0.7] } });
    expect(material?.textures.baseColor?.texture).toBe(0);
    // It is seen whole, in light.
    expect(document.camera.position[2]).toBeGreaterThan(1);
    expect(document.environment.source.type).toBe('preset');

    const second = await irradia(['convert', path('wall.json'), '-o', path('wall.glb')]);
    expect(second.code).toBe(0);
    expect(second.stderr).toContain('note: the environment is not in a glTF file');
    const glb = readGlb(readFileSync(path('wall.glb')), 'wall.glb');
    const json = JSON.parse(new TextDecoder().decode(glb.json));
    expect(json.materials[0]).toMatchObject({ name: 'Bricks' });
    expect(json.images).toHaveLength(1);
  });

  test('a zip, and says what is wrong with a file', async () => {
    writeFileSync(path('wall.zip'), zipSync({ 'x/wall.obj': bytesOf(obj), 'x/wall.mtl': bytesOf(mtl) }));
    const zipped = await called(['convert', path('wall.zip'), '-o', path('zip.json')]);
    expect(zipped.code).toBe(0);
    expect(zipped.stderr).toContain('maps/bricks.png did not come along');
    writeFileSync(path('bad.ply'), 'ply\nformat ascii 1.0\nelement vertex many\nend_header\n');
    const bad = await called(['convert', path('bad.ply'), '-o', path('bad.json')]);
    expect(bad).toMatchObject({ code: 1 });
    expect(bad.stderr).toBe('irradia: bad.ply: line 3: expected "element NAME COUNT"\n');
    expect((await called(['convert', path('wall.obj'), '-o', path('wall.fbx')])).code).toBe(2);
  });
});

test('irradia render takes a model', async () => {
  const words = [
    'render',
    path('wall.obj'),
    '-o',
    path('wall.png'),
    '--size',
    '32x24',
    '--spp',
    '2',
    '--device',
    'software',
  ];
  expect((await called(words)).code).toBe(0);
  expect(readFileSync(path('wall.png')).length).toBeGreaterThan(500);
});
