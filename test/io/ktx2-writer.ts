/** KTX 2.0 files of Basis Universal UASTC whose blocks of 4 x 4 texels have one colour each. */

/** Mode 8 of UASTC (a solid block): its code is 10111 from the last bit; then come the four channels, 8 bits each. */
function solidBlock(rgba: readonly number[]): Uint8Array {
  const block = new Uint8Array(16);
  let bits = 0x17n;
  rgba.forEach((value, i) => {
    bits |= BigInt(value) << BigInt(5 + 8 * i);
  });
  for (let i = 0; i < 16; i++) block[i] = Number((bits >> BigInt(8 * i)) & 0xffn);
  return block;
}

/** @param colors of blocks from the top left, row by row */
export function ktx2(width: number, height: number, colors: readonly (readonly number[])[]): Uint8Array {
  const level = Buffer.concat(colors.map(solidBlock));
  const descriptor = Buffer.alloc(4 + 40);
  descriptor.writeUInt32LE(44, 0);
  descriptor.writeUInt16LE(2, 4 + 4);
  descriptor.writeUInt16LE(40, 4 + 6);
  // Colour model UASTC, primaries of BT.709, sRGB.
  descriptor.set([166, 1, 2, 0, 3, 3, 0, 0, 16], 4 + 8);
  // One sample of 128 bits: RGBA.
  descriptor.set([0, 0, 127, 3], 4 + 24);
  descriptor.writeUInt32LE(0xffffffff, 4 + 36);
  const levelIndex = 80;
  const dfdAt = levelIndex + 24;
  const levelAt = Math.ceil((dfdAt + descriptor.length) / 16) * 16;
  const head = Buffer.alloc(levelAt);
  head.set([0xab, 0x4b, 0x54, 0x58, 0x20, 0x32, 0x30, 0xbb, 0x0d, 0x0a, 0x1a, 0x0a]);
  const words = [0, 1, width, height, 0, 0, 1, 1, 0, dfdAt, descriptor.length, 0, 0];
  words.forEach((word, i) => {
    head.writeUInt32LE(word, 12 + 4 * i);
  });
  head.writeBigUInt64LE(BigInt(levelAt), levelIndex);
  head.writeBigUInt64LE(BigInt(level.length), levelIndex + 8);
  head.writeBigUInt64LE(BigInt(level.length), levelIndex + 16);
  head.set(descriptor, dfdAt);
  return Buffer.concat([head, level]);
}
