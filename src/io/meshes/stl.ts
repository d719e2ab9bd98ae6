/**
 * Stereolithography files, binary and text: triangles, nothing else.
 * Format: 3D Systems, "StereoLithography Interface Specification", 1989.
 */
import { ByteReader } from '../bytes.ts';
import { ModelFileError } from './error.ts';
import { type MeshData, Numbers } from './mesh.ts';

const HEADER = 80;
/** A normal, three corners, and two bytes that programs use as they like. */
const TRIANGLE = 50;

export interface StlSolid extends MeshData {
  /** '' where the file gives none. */
  name: string;
}

/** @throws ByteError or ModelFileError with the byte or line that is wrong */
export function readStl(bytes: Uint8Array, file: string): StlSolid[] {
  return isText(bytes) ? readText(bytes, file) : [readBinary(bytes, file)];
}

/** Binary files may begin with "solid", too: then their length is right for the number of triangles that they tell. */
function isText(bytes: Uint8Array): boolean {
  const begins = /^\s*solid/.test(new TextDecoder('latin1').decode(bytes.subarray(0, HEADER)));
  if (!begins || bytes.length < HEADER + 4) return begins;
  const count = new DataView(bytes.buffer, bytes.byteOffset).getUint32(HEADER, true);
  return bytes.length !== HEADER + 4 + count * TRIANGLE;
}

function readBinary(bytes: Uint8Array, file: string): StlSolid {
  const reader = new ByteReader(bytes, file);
  reader.need(HEADER + 4);
  reader.seek(HEADER);
  const count = reader.uint32();
  reader.need(count * TRIANGLE);
  if (count === 0) throw reader.error('the file has no triangles');
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const positions = new Float32Array(count * 9);
  for (let triangle = 0; triangle < count; triangle++) {
    const start = HEADER + 4 + triangle * TRIANGLE + 12;
    for (let i = 0; i < 9; i++) {
      const value = view.getFloat32(start + 4 * i, true);
      if (!Number.isFinite(value)) {
        reader.seek(start + 4 * i);
        throw reader.error('a coordinate that is not a finite number');
      }
      positions[9 * triangle + i] = value;
    }
  }
  return { name: '', positions };
}

function readText(bytes: Uint8Array, file: string): StlSolid[] {
  const lines = new TextDecoder().decode(bytes).split(/\r\n|\r|\n/);
  const solids: StlSolid[] = [];
  let name = '';
  let positions = new Numbers(Float32Array);
  let corners = 0;
  const end = (): void => {
    if (positions.length > 0) solids.push({ name, positions: positions.finish() });
    positions = new Numbers(Float32Array);
  };
  for (const [i, line] of lines.entries()) {
    const fail = (message: string): never => {
      throw new ModelFileError(file, `line ${i + 1}`, message);
    };
    const [word = '', ...rest] = line.trim().split(/\s+/);
    switch (word.toLowerCase()) {
      case 'solid':
        end();
        name = rest.join(' ');
        break;
      case 'outer':
        corners = 0;
        break;
      case 'vertex': {
        const values = rest.slice(0, 3).map(Number);
        if (values.length < 3 || !values.every(Number.isFinite))
          fail('expected three numbers after "vertex"');
        positions.push(...values);
        corners += 1;
        break;
      }
      case 'endloop':
        if (corners !== 3) fail(`a facet with ${corners} corners; expected 3`);
        corners = 0;
        break;
      case '':
      case 'facet':
      case 'endfacet':
      case 'endsolid':
        break;
      default:
        fail(`"${word.slice(0, 40)}" is not a word of STL`);
    }
  }
  if (corners !== 0) throw new ModelFileError(file, `line ${lines.length}`, 'the file ends within a facet');
  end();
  if (solids.length === 0) throw new ModelFileError(file, '', 'the file has no triangles');
  return solids;
}
