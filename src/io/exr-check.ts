/**
 * Whether an OpenEXR file of any kind is what its header says, before three.js's reader gets it: that one trusts lengths, and
 * looks for the end of a name beyond the end of the file for ever.
 */
import { ByteReader } from './bytes.ts';
import { COMPRESSIONS, MAGIC } from './exr-format.ts';
import { MOST_TEXELS } from './image-size.ts';

const TILES = 0x200;
const DEEP = 0x800;
const SEVERAL_PARTS = 0x1000;
/** Lines that are compressed together, in the order of COMPRESSIONS. */
const LINES = [1, 1, 1, 16, 32, 16, 32, 32, 32, 256];
/** Bytes of the attributes that the reader takes to be of one size. */
const SIZES: Readonly<Record<string, number>> = {
  ...{ box2i: 16, chromaticities: 32, compression: 1, double: 8, envmap: 1, float: 4, int: 4, keycode: 28 },
  ...{ lineOrder: 1, m33f: 36, m44f: 64, rational: 8, tiledesc: 9, timecode: 8, v2f: 8, v2i: 8, v3f: 12 },
};
/** More are in no image that lights a scene, and each takes as much memory as the image has texels. */
const MOST_CHANNELS = 64;

/** @throws ByteError */
export function checkExr(bytes: Uint8Array, fileName: string): void {
  const input = new ByteReader(bytes, fileName);
  if (input.int32() !== MAGIC) throw input.error('not an OpenEXR file');
  const flags = input.int32();
  if (flags & DEEP) throw input.error('a file of deep data, which is not read');
  const severalParts = (flags & SEVERAL_PARTS) !== 0;
  let chunks = 0;
  do chunks += checkPart(input, (flags & TILES) !== 0);
  while (severalParts && bytes[input.position] !== 0);
  if (severalParts) input.uint8();
  // The places of the chunks follow, eight bytes each, and each of them has eight bytes before its data.
  input.need(16 * chunks);
  for (let i = 0; i < chunks; i++) {
    const at = input.uint64();
    if (!(at <= bytes.length - 8)) throw input.error(`chunk ${i} is at byte ${at}, outside the file`);
  }
}

/** Returns how many chunks there must be; 0 where that is not known here, as of tiles. */
function checkPart(input: ByteReader, isTiled: boolean): number {
  let height: number | undefined;
  let lines: number | undefined;
  let hasChannels = false;
  let hasTiles = !isTiled;
  for (let name = input.cString(); name !== ''; name = input.cString()) {
    const type = input.cString();
    const length = input.int32();
    input.need(length);
    const end = input.position + length;
    const size = Object.hasOwn(SIZES, type) ? SIZES[type] : length;
    if (size !== length) throw input.error(`${name}: ${length} bytes for a ${type}; expected ${size}`);
    if (type === 'chlist') {
      checkChannels(input, end);
      hasChannels ||= name === 'channels';
    } else if (name === 'dataWindow' && type === 'box2i') height = windowHeight(input);
    else if (name === 'tiles' && type === 'tiledesc') {
      const [width, rows] = [input.int32(), input.int32()] as const;
      if (width < 1 || rows < 1) throw input.error(`tiles of ${width} x ${rows} texels`);
      hasTiles = true;
    } else if (name === 'compression' && type === 'compression') {
      const index = input.uint8();
      lines = LINES[index];
      if (lines === undefined)
        throw input.error(`compression ${index}; expected one of ${COMPRESSIONS.join(', ')}`);
    }
    input.seek(end);
  }
  if (height === undefined) throw input.error('the header has no dataWindow');
  if (lines === undefined) throw input.error('the header has no compression');
  if (!hasChannels) throw input.error('the header has no channels');
  if (!hasTiles) throw input.error('the header has no tiles');
  return isTiled ? 0 : Math.ceil(height / lines);
}

function windowHeight(input: ByteReader): number {
  const [left, top, right, bottom] = [input.int32(), input.int32(), input.int32(), input.int32()] as const;
  const [width, height] = [right - left + 1, bottom - top + 1];
  if (width < 1 || height < 1 || width * height > MOST_TEXELS)
    throw input.error(`an image of ${width} x ${height} texels; expected 1 to ${MOST_TEXELS} in all`);
  return height;
}

/** Each is a name and 16 bytes; an empty name ends them. */
function checkChannels(input: ByteReader, end: number): void {
  let count = 0;
  for (let name = input.cString(); name !== ''; name = input.cString()) {
    input.bytes(16);
    count += 1;
    if (count > MOST_CHANNELS) throw input.error(`more than ${MOST_CHANNELS} channels`);
  }
  if (count === 0 || input.position !== end) throw input.error('a list of channels that does not end');
}
