/**
 * Wavefront OBJ: polygons with positions, texture coordinates and normals, by object, group and material.
 * Format: Alias|Wavefront, "Advanced Visualizer Manual", appendix B1, 1995. Curves, surfaces, lines and points are told.
 */
import type { Notes } from '../gltf/notes.ts';
import { ModelFileError } from './error.ts';
import { type MeshData, Numbers, smoothNormals } from './mesh.ts';
import { wordsOf } from './words.ts';

export interface ObjPart extends MeshData {
  /** The names of the object and of the group; '' where the file gives none. */
  object: string;
  group: string;
  /** As a .mtl file names it; null where the file says nothing. */
  material: string | null;
}

export interface ObjFile {
  parts: ObjPart[];
  /** The .mtl files that it asks for. */
  libraries: string[];
}

/** Far more than any polygon that a program writes has. */
const MOST_CORNERS = 4096;

/** @throws ModelFileError with the line that is wrong */
export function readObj(bytes: Uint8Array, file: string, notes: Notes): ObjFile {
  return new ObjReader(new TextDecoder().decode(bytes), file, notes).read();
}

const left = new Set(['p', 'l', 'curv', 'curv2', 'surf', 'vp', 'cstype', 'bmat']);

class ObjReader {
  readonly #text: string;
  readonly #file: string;
  readonly #notes: Notes;
  readonly #positions = new Numbers(Float32Array);
  readonly #uvs = new Numbers(Float32Array);
  readonly #normals = new Numbers(Float32Array);
  readonly #builders = new Map<string, PartBuilder>();
  readonly #libraries: string[] = [];
  #object = '';
  #group = '';
  #material: string | null = null;
  #smooth = false;
  #builder: PartBuilder | null = null;
  #line = 0;

  constructor(text: string, file: string, notes: Notes) {
    this.#text = text;
    this.#file = file;
    this.#notes = notes;
  }

  read(): ObjFile {
    const text = this.#text;
    for (let at = 0; at < text.length; ) {
      let end = text.indexOf('\n', at);
      if (end < 0) end = text.length;
      let line = text.slice(at, end);
      at = end + 1;
      this.#line += 1;
      const begin = this.#line;
      while (/\\\r?$/.test(line) && at < text.length) {
        end = text.indexOf('\n', at);
        if (end < 0) end = text.length;
        line = line.replace(/\\\r?$/, ' ') + text.slice(at, end);
        at = end + 1;
        this.#line += 1;
      }
      this.#statement(line.trim(), begin);
    }
    const parts = [...this.#builders.values()].map((builder) => builder.finish());
    if (parts.length === 0) throw new ModelFileError(this.#file, '', 'the file has no faces');
    return { parts, libraries: this.#libraries };
  }

  #statement(line: string, number: number): void {
    const words = wordsOf(line);
    const [word = ''] = words;
    if (word === '') return;
    switch (word) {
      case 'v':
        this.#numbers(words, 3, this.#positions, number);
        if (words.length > 5) this.#notes.add('its vertex colours are not read');
        return;
      case 'vt':
        this.#numbers(words.length === 2 ? [...words, '0'] : words, 2, this.#uvs, number);
        return;
      case 'vn':
        this.#numbers(words, 3, this.#normals, number);
        return;
      case 'f':
        this.#face(words, number);
        return;
      case 'o':
        this.#object = words.slice(1).join(' ');
        this.#group = '';
        this.#builder = null;
        return;
      case 'g':
        this.#group = words.slice(1).join(' ');
        this.#builder = null;
        return;
      case 'usemtl':
        this.#material = words.slice(1).join(' ');
        this.#builder = null;
        return;
      case 's':
        this.#smooth = !['off', '0', undefined].includes(words[1]);
        this.#builder = null;
        return;
      case 'mtllib':
        this.#libraries.push(words.slice(1).join(' '));
        return;
      default:
        if (left.has(word)) this.#notes.add('its points, lines and curves have no surface and are left out');
        // Of other words there are many, and none changes where the surface is.
        else if (!/^[a-zA-Z_]+$/.test(word))
          this.#fail(number, `"${word.slice(0, 40)}" is not a word of OBJ`);
    }
  }

  #numbers(words: readonly string[], count: number, to: Numbers<Float32Array>, line: number): void {
    for (let i = 1; i <= count; i++) {
      const value = words[i] === undefined ? Number.NaN : Number(words[i]);
      if (!Number.isFinite(value)) this.#fail(line, `expected ${count} numbers after "${words[0]}"`);
      to.push(value);
    }
  }

  #face(words: readonly string[], line: number): void {
    if (words.length < 4) this.#fail(line, 'a face needs three corners');
    if (words.length > MOST_CORNERS) this.#fail(line, `a face with more than ${MOST_CORNERS} corners`);
    this.#builder ??= this.#open();
    const corners = words.slice(1).map((word) => {
      const [v, vt, vn] = word.split('/');
      return this.#builder!.vertex(
        this.#index(v, this.#positions.length / 3, 'vertex', line) as number,
        this.#index(vt, this.#uvs.length / 2, 'texture coordinate', line),
        this.#index(vn, this.#normals.length / 3, 'normal', line),
      );
    });
    for (let i = 2; i < corners.length; i++)
      this.#builder.triangle(corners[0] as number, corners[i - 1] as number, corners[i] as number);
  }

  /** Numbers count from 1, negative ones from the last. */
  #index(word: string | undefined, count: number, what: string, line: number): number | null {
    if (word === undefined || word === '') {
      if (what === 'vertex') this.#fail(line, 'a corner without a vertex');
      return null;
    }
    const number = Number(word);
    const index = number < 0 ? count + number : number - 1;
    if (!Number.isInteger(number) || number === 0)
      this.#fail(line, `"${word.slice(0, 40)}" is not the number of a ${what}`);
    if (index < 0 || index >= count) this.#fail(line, `there is no ${what} ${number} before this line`);
    return index;
  }

  #open(): PartBuilder {
    const [object, group] = [this.#object, this.#group];
    const key = JSON.stringify([object, group, this.#material, this.#smooth]);
    const builder =
      this.#builders.get(key) ??
      new PartBuilder(object, group, this.#material, this.#smooth, this.#positions, this.#uvs, this.#normals);
    this.#builders.set(key, builder);
    return builder;
  }

  #fail(line: number, message: string): never {
    throw new ModelFileError(this.#file, `line ${line}`, message);
  }
}

/** No text has more lines of one kind than this: strings end at 2^29 characters. Two such numbers make an exact double. */
const MOST_LINES = 2 ** 26;

/** Numbers pairs in the order in which they come. */
function numberOf(pairs: Map<number, number>, a: number, b: number): number {
  const key = a * MOST_LINES + b + 1;
  const number = pairs.get(key) ?? pairs.size;
  if (number === pairs.size) pairs.set(key, number);
  return number;
}

/** Vertices are there once for each combination of position, coordinates and normal that faces use. */
class PartBuilder {
  readonly #pairs = new Map<number, number>();
  readonly #vertices = new Map<number, number>();
  readonly #position: number[] = [];
  readonly #uv: (number | null)[] = [];
  readonly #normal: (number | null)[] = [];
  readonly #indices = new Numbers(Uint32Array);

  constructor(
    readonly object: string,
    readonly group: string,
    readonly material: string | null,
    readonly smooth: boolean,
    readonly positions: Numbers<Float32Array>,
    readonly uvs: Numbers<Float32Array>,
    readonly normals: Numbers<Float32Array>,
  ) {}

  vertex(position: number, uv: number | null, normal: number | null): number {
    const pair = numberOf(this.#pairs, position, uv ?? -1);
    const known = this.#vertices.size;
    const index = numberOf(this.#vertices, pair, normal ?? -1);
    if (index === known) {
      this.#position.push(position);
      this.#uv.push(uv);
      this.#normal.push(normal);
    }
    return index;
  }

  triangle(a: number, b: number, c: number): void {
    this.#indices.push(a, b, c);
  }

  finish(): ObjPart {
    const indices = this.#indices.finish();
    const gather = (from: Numbers<Float32Array>, by: readonly (number | null)[], size: number) => {
      const values = new Float32Array(by.length * size);
      for (const [i, index] of by.entries())
        for (let c = 0; index !== null && c < size; c++) values[size * i + c] = from.at(size * index + c);
      return values;
    };
    const all = (by: readonly (number | null)[]) => !by.includes(null);
    const positions = gather(this.positions, this.#position, 3);
    const { object, group, material } = this;
    const normals = all(this.#normal)
      ? gather(this.normals, this.#normal, 3)
      : this.#smoothed(positions, indices);
    const uvs = this.#uv.some((uv) => uv !== null) ? gather(this.uvs, this.#uv, 2) : undefined;
    return { object, group, material, positions, normals, uvs, indices };
  }

  /** Over all faces around a position, whatever their texture coordinates are. */
  #smoothed(positions: Float32Array, indices: Uint32Array): Float32Array | undefined {
    if (!this.smooth) return undefined;
    const firsts = new Map<number, number>();
    const shared = this.#position.map((position, vertex) => {
      const first = firsts.get(position) ?? vertex;
      firsts.set(position, first);
      return first;
    });
    const normals = smoothNormals(
      positions,
      indices.map((vertex) => shared[vertex] as number),
    );
    for (const [vertex, first] of shared.entries()) normals.copyWithin(3 * vertex, 3 * first, 3 * first + 3);
    return normals;
  }
}
