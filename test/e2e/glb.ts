/** Small GLBs made on the spot, so that no test depends on a stored model. */

export interface GlbMesh {
  readonly name: string;
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly uvs?: Float32Array;
  readonly indices: Uint16Array | Uint32Array;
  readonly color?: readonly [number, number, number, number];
}

/** A quad with a material. */
export function quadGlb(color: readonly [number, number, number, number] = [0.8, 0.1, 0.1, 1]): Uint8Array {
  return meshGlb({
    name: 'Quad',
    positions: new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]),
    normals: new Float32Array([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1]),
    indices: new Uint16Array([0, 1, 2, 0, 2, 3]),
    color,
  });
}

/** A sphere about (0, 1, 0) with waves on it, of about so many triangles: 2 n² of a grid of 2 n by n. */
export function wavyGlb(triangles: number, name = 'Wavy'): Uint8Array {
  const rows = Math.round(Math.sqrt(triangles) / 2);
  const columns = 2 * rows;
  const vertices = (rows + 1) * (columns + 1);
  const [positions, normals, uvs] = [3, 3, 2].map((size) => new Float32Array(size * vertices)) as [
    Float32Array,
    Float32Array,
    Float32Array,
  ];
  let at = 0;
  for (let row = 0; row <= rows; row++)
    for (let column = 0; column <= columns; column++, at++) {
      const [theta, phi] = [(Math.PI * row) / rows, (2 * Math.PI * (column % columns)) / columns];
      const unit = [
        Math.sin(theta) * Math.cos(phi),
        Math.cos(theta),
        Math.sin(theta) * Math.sin(phi),
      ] as const;
      const radius = 0.9 + 0.1 * Math.sin(7 * theta) * Math.cos(9 * phi);
      positions.set([radius * unit[0], 1 + radius * unit[1], radius * unit[2]], 3 * at);
      normals.set(unit, 3 * at);
      uvs.set([column / columns, row / rows], 2 * at);
    }
  const indices = new Uint32Array(6 * rows * columns);
  at = 0;
  for (let row = 0; row < rows; row++)
    for (let column = 0; column < columns; column++, at += 6) {
      const a = row * (columns + 1) + column;
      const b = a + columns + 1;
      indices.set([a, a + 1, b, b, a + 1, b + 1], at);
    }
  return meshGlb({ name, positions, normals, uvs, indices });
}

export function meshGlb({ name, positions, normals, uvs, indices, color }: GlbMesh): Uint8Array {
  const attributes: [string, Float32Array, number][] = [
    ['POSITION', positions, 3],
    ['NORMAL', normals, 3],
    ...(uvs ? [['TEXCOORD_0', uvs, 2] satisfies [string, Float32Array, number]] : []),
  ];
  const parts = [...attributes.map(([, array]) => array), indices].map((array) =>
    padded(Buffer.from(array.buffer), 0),
  );
  let byteOffset = 0;
  const bufferViews = parts.map(({ length: byteLength }) => {
    const view = { buffer: 0, byteOffset, byteLength };
    byteOffset += byteLength;
    return view;
  });
  const json = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ name, mesh: 0 }],
    meshes: [
      {
        primitives: [
          {
            attributes: Object.fromEntries(attributes.map(([attribute], i) => [attribute, i])),
            indices: attributes.length,
            material: 0,
          },
        ],
      },
    ],
    materials: [
      {
        name: 'Paint',
        pbrMetallicRoughness: {
          baseColorFactor: color ?? [0.8, 0.1, 0.1, 1],
          metallicFactor: 0,
          roughnessFactor: 0.6,
        },
      },
    ],
    buffers: [{ byteLength: byteOffset }],
    bufferViews,
    accessors: [
      ...attributes.map(([attribute, array, size], bufferView) => ({
        bufferView,
        componentType: 5126,
        count: array.length / size,
        type: `VEC${size}`,
        ...(attribute === 'POSITION' && boundsOf(array)),
      })),
      {
        bufferView: attributes.length,
        componentType: indices instanceof Uint16Array ? 5123 : 5125,
        count: indices.length,
        type: 'SCALAR',
      },
    ],
  };
  const text = padded(Buffer.from(JSON.stringify(json)), 0x20);
  const header = Buffer.alloc(12);
  header.write('glTF');
  header.writeUInt32LE(2, 4);
  header.writeUInt32LE(12 + 8 + text.length + 8 + byteOffset, 8);
  return Buffer.concat([
    header,
    chunk(text, 0x4e4f534a),
    text,
    chunk({ length: byteOffset }, 0x004e4942),
    ...parts,
  ]);
}

function boundsOf(positions: Float32Array): { min: number[]; max: number[] } {
  const [min, max] = [Array(3).fill(Infinity), Array(3).fill(-Infinity)] as [number[], number[]];
  positions.forEach((x, i) => {
    min[i % 3] = Math.min(min[i % 3] as number, x);
    max[i % 3] = Math.max(max[i % 3] as number, x);
  });
  return { min, max };
}

function chunk({ length }: { length: number }, type: number): Buffer {
  const head = Buffer.alloc(8);
  head.writeUInt32LE(length, 0);
  head.writeUInt32LE(type, 4);
  return head;
}

function padded(content: Buffer, fill: number): Buffer {
  return Buffer.concat([content, Buffer.alloc((4 - (content.length % 4)) % 4, fill)]);
}
