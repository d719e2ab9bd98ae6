/**
 * Polygon files (PLY), text and binary of either byte order.
 * Format: G. Turk, "The PLY Polygon File Format", 1994.
 */
import { ModelFileError } from './error.ts';
import { type MeshData, Numbers, smoothNormals } from './mesh.ts';

interface Property {
  name: string;
  type: Scalar;
  /** Of the number before a list; null for a single value. */
  countType: Scalar | null;
}
interface Element {
  name: string;
  count: number;
  properties: Property[];
}
interface Header {
  format: 'ascii' | 'binary_little_endian' | 'binary_big_endian';
  elements: Element[];
  /** Where the values begin. */
  end: number;
  lines: number;
}

const sizes = {
  int8: 1,
  uint8: 1,
  int16: 2,
  uint16: 2,
  int32: 4,
  uint32: 4,
  float32: 4,
  float64: 8,
} as const;
type Scalar = keyof typeof sizes;
const types: Readonly<Record<string, Scalar>> = {
  ...{ char: 'int8', uchar: 'uint8', short: 'int16', ushort: 'uint16', int: 'int32', uint: 'uint32' },
  ...{ float: 'float32', double: 'float64', int8: 'int8', uint8: 'uint8', int16: 'int16', uint16: 'uint16' },
  ...{ int32: 'int32', uint32: 'uint32', float32: 'float32', float64: 'float64' },
};

/** No polygon has more corners: what says so is not a polygon. */
const MOST_CORNERS = 4096;
const LONGEST_HEADER = 64 * 1024;

export interface PlyMesh extends MeshData {
  hasColors: boolean;
}

/** @throws ModelFileError with the line or byte that is wrong */
export function readPly(bytes: Uint8Array, file: string): PlyMesh {
  const header = readHeader(bytes, file);
  const values =
    header.format === 'ascii'
      ? new TextValues(bytes.subarray(header.end), header.lines, file)
      : new BinaryValues(bytes, header.end, header.format === 'binary_little_endian', file);
  const vertices = new Vertices(
    header.elements.find(({ name }) => name === 'vertex'),
    file,
  );
  const corners = new Numbers(Uint32Array);
  for (const element of header.elements) {
    values.need(element);
    if (element.name === 'vertex') vertices.read(values);
    else if (element.name === 'face') readFaces(values, element, corners);
    else skip(values, element);
  }
  if (corners.length === 0)
    throw new ModelFileError(
      file,
      '',
      'the file has no faces: points alone have no surface to reflect light',
    );
  const indices = corners.finish();
  const beyond = indices.findIndex((index) => index >= vertices.count);
  if (beyond >= 0)
    throw new ModelFileError(
      file,
      `triangle ${Math.floor(beyond / 3)}`,
      `there is no vertex ${indices[beyond]}; there are ${vertices.count}`,
    );
  const { positions, normals, uvs, hasColors } = vertices;
  return { positions, normals: normals ?? smoothNormals(positions, indices), uvs, indices, hasColors };
}

function readHeader(bytes: Uint8Array, file: string): Header {
  const text = new TextDecoder('latin1').decode(bytes.subarray(0, LONGEST_HEADER));
  const found = /^ply\r?\n([\s\S]*?)end_header[ \t]*(\r\n|\n|\r)/.exec(text);
  if (!found)
    throw new ModelFileError(file, 'line 1', 'not a PLY file: no header from "ply" to "end_header"');
  const elements: Element[] = [];
  let format: string | undefined;
  const lines = (found[1] ?? '').split(/\r\n|\n|\r/);
  for (const [i, line] of lines.entries()) {
    const words = line.trim().split(/\s+/);
    const fail = (message: string): never => {
      throw new ModelFileError(file, `line ${i + 2}`, message);
    };
    const scalar = (word = ''): Scalar => types[word] ?? fail(`"${word.slice(0, 40)}" is not a type of PLY`);
    if (words[0] === 'format') format = words[1];
    else if (words[0] === 'element') {
      const count = Number(words[2]);
      if (!Number.isSafeInteger(count) || count < 0) fail('expected "element NAME COUNT"');
      elements.push({ name: words[1] ?? '', count, properties: [] });
    } else if (words[0] === 'property') {
      const element = elements.at(-1) ?? fail('a property before the first element');
      if (words[1] === 'list')
        element.properties.push({
          name: words[4] ?? '',
          type: scalar(words[3]),
          countType: scalar(words[2]),
        });
      else element.properties.push({ name: words[2] ?? '', type: scalar(words[1]), countType: null });
    } else if (!['comment', 'obj_info', ''].includes(words[0] ?? ''))
      fail(`"${(words[0] ?? '').slice(0, 40)}" is not a word of a PLY header`);
  }
  if (format !== 'ascii' && format !== 'binary_little_endian' && format !== 'binary_big_endian')
    throw new ModelFileError(
      file,
      'line 2',
      `format ${(format ?? 'missing').slice(0, 40)} is not one of PLY`,
    );
  return { format, elements, end: found[0].length, lines: lines.length + 1 };
}

interface Values {
  /** Throws if there cannot be as many elements as the header says. */
  need(element: Element): void;
  next(type: Scalar): number;
  fail(message: string): never;
}

class BinaryValues implements Values {
  readonly #view: DataView;
  readonly #little: boolean;
  readonly #file: string;
  #at: number;

  constructor(bytes: Uint8Array, at: number, little: boolean, file: string) {
    this.#view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.#at = at;
    this.#little = little;
    this.#file = file;
  }

  need({ name, count, properties }: Element): void {
    const least = properties.reduce((sum, { type, countType }) => sum + sizes[countType ?? type], 0);
    const left = this.#view.byteLength - this.#at;
    if (count * least > left)
      this.fail(`the header says ${count} of "${name}", ${least} bytes each; ${left} bytes are left`);
  }

  next(type: Scalar): number {
    const at = this.#at;
    if (at + sizes[type] > this.#view.byteLength) this.fail('the file ends here, within an element');
    this.#at += sizes[type];
    switch (type) {
      case 'int8':
        return this.#view.getInt8(at);
      case 'uint8':
        return this.#view.getUint8(at);
      case 'int16':
        return this.#view.getInt16(at, this.#little);
      case 'uint16':
        return this.#view.getUint16(at, this.#little);
      case 'int32':
        return this.#view.getInt32(at, this.#little);
      case 'uint32':
        return this.#view.getUint32(at, this.#little);
      case 'float32':
        return this.#view.getFloat32(at, this.#little);
      case 'float64':
        return this.#view.getFloat64(at, this.#little);
    }
  }

  fail(message: string): never {
    throw new ModelFileError(this.#file, `byte ${this.#at}`, message);
  }
}

class TextValues implements Values {
  readonly #bytes: Uint8Array;
  readonly #file: string;
  #at = 0;
  #line: number;

  constructor(bytes: Uint8Array, lines: number, file: string) {
    this.#bytes = bytes;
    this.#line = lines + 1;
    this.#file = file;
  }

  need({ name, count, properties }: Element): void {
    const left = this.#bytes.length - this.#at;
    // A digit and what separates it from the next one.
    if (count * Math.max(1, properties.length) * 2 > left + 1)
      this.fail(`the header says ${count} of "${name}", for which the file is too short`);
  }

  next(): number {
    const bytes = this.#bytes;
    while (this.#at < bytes.length && bytes[this.#at]! <= 32) {
      if (bytes[this.#at] === 10) this.#line += 1;
      this.#at += 1;
    }
    const start = this.#at;
    while (this.#at < bytes.length && bytes[this.#at]! > 32) this.#at += 1;
    if (start === this.#at) this.fail('the file ends here, within an element');
    const word = String.fromCharCode(...bytes.subarray(start, Math.min(this.#at, start + 64)));
    const value = Number(word);
    if (Number.isNaN(value)) this.fail(`"${word.slice(0, 40)}" is not a number`);
    return value;
  }

  fail(message: string): never {
    throw new ModelFileError(this.#file, `line ${this.#line}`, message);
  }
}

const vertexFields: readonly (readonly string[])[] = [
  ['x', 'y', 'z'],
  ['nx', 'ny', 'nz'],
];
const uvFields: readonly (readonly [string, string])[] = [
  ['u', 'v'],
  ['s', 't'],
  ['texture_u', 'texture_v'],
  ['texture_s', 'texture_t'],
];

class Vertices {
  readonly #element: Element;
  readonly #file: string;
  readonly count: number;
  readonly hasColors: boolean;
  positions = new Float32Array(0);
  normals: Float32Array | undefined;
  uvs: Float32Array | undefined;

  constructor(element: Element | undefined, file: string) {
    const has = (names: readonly string[] = []) =>
      names.every((name) => element?.properties.some((p) => p.name === name && p.countType === null));
    if (element === undefined || !has(vertexFields[0]))
      throw new ModelFileError(file, 'header', 'no element "vertex" with x, y and z');
    this.#element = element;
    this.#file = file;
    this.count = element.count;
    this.hasColors = has(['red', 'green', 'blue']);
  }

  read(values: Values): void {
    const { properties, count } = this.#element;
    const index = (name: string) => properties.findIndex((property) => property.name === name);
    const uv = uvFields.find(([u, v]) => index(u) >= 0 && index(v) >= 0);
    this.positions = new Float32Array(3 * count);
    if (vertexFields[1]?.every((name) => index(name) >= 0)) this.normals = new Float32Array(3 * count);
    if (uv) this.uvs = new Float32Array(2 * count);
    // Where the value of each property goes: an array, its values a vertex, and which of them.
    const targets = properties.map(({ name }) => {
      const [axis, normal, side] = [
        vertexFields[0]?.indexOf(name) ?? -1,
        vertexFields[1]?.indexOf(name) ?? -1,
        uv?.indexOf(name) ?? -1,
      ];
      if (axis >= 0) return { to: this.positions, size: 3, c: axis };
      if (normal >= 0 && this.normals) return { to: this.normals, size: 3, c: normal };
      return side >= 0 && this.uvs ? { to: this.uvs, size: 2, c: side } : null;
    });
    for (let i = 0; i < count; i++)
      for (const [p, property] of properties.entries()) {
        if (property.countType !== null) {
          skipList(values, property);
          continue;
        }
        const value = values.next(property.type);
        const target = targets[p];
        if (!target) continue;
        if (target.to === this.positions && !Number.isFinite(value))
          throw new ModelFileError(this.#file, `vertex ${i}`, `${property.name} is not a finite number`);
        target.to[target.size * i + target.c] = value;
      }
  }
}

const isCorners = ({ name, countType }: Property): boolean =>
  countType !== null && (name === 'vertex_indices' || name === 'vertex_index');

/** Polygons as fans of triangles. */
function readFaces(values: Values, { count, properties }: Element, corners: Numbers<Uint32Array>): void {
  const face: number[] = [];
  for (let i = 0; i < count; i++)
    for (const property of properties) {
      if (!isCorners(property) || property.countType === null) {
        if (property.countType === null) values.next(property.type);
        else skipList(values, property);
        continue;
      }
      const size = listSize(values, property.countType);
      face.length = 0;
      for (let c = 0; c < size; c++) {
        const index = values.next(property.type);
        if (!Number.isInteger(index) || index < 0) values.fail(`${index} is not the number of a vertex`);
        face.push(index);
      }
      for (let c = 2; c < size; c++) corners.push(face[0]!, face[c - 1]!, face[c]!);
    }
}

function listSize(values: Values, type: Scalar): number {
  const size = values.next(type);
  if (!(Number.isInteger(size) && size >= 0 && size <= MOST_CORNERS))
    values.fail(`a list of ${size} values; at most ${MOST_CORNERS}`);
  return size;
}

function skipList(values: Values, { type, countType }: Property): void {
  const size = listSize(values, countType ?? type);
  for (let i = 0; i < size; i++) values.next(type);
}

function skip(values: Values, { count, properties }: Element): void {
  // An element without values takes no bytes, so its count proves nothing.
  if (properties.length === 0) return;
  for (let i = 0; i < count; i++)
    for (const property of properties)
      if (property.countType === null) values.next(property.type);
      else skipList(values, property);
}
