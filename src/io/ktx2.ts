/**
 * What surrounds the transcoding of KTX 2.0 images with Basis Universal data, in a page and in Node alike.
 * Format: Khronos, "KTX File Format Specification 2.0", section 3.
 */
import { ByteError } from './bytes.ts';

const IDENTIFIER = [0xab, 0x4b, 0x54, 0x58, 0x20, 0x32, 0x30, 0xbb, 0x0d, 0x0a, 0x1a, 0x0a];
const HEADER = 80;
const LARGEST = 16_384;

export interface Ktx2Size {
  width: number;
  height: number;
}

/** Of a file that a transcoder can be trusted with; @throws ByteError */
export function checkKtx2(bytes: Uint8Array, file: string): Ktx2Size {
  if (bytes.length < HEADER || IDENTIFIER.some((byte, i) => bytes[i] !== byte))
    throw new ByteError(file, 0, 'not a KTX 2.0 image');
  const header = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const [vkFormat, width, height, depth] = [12, 20, 24, 28].map((at) => header.getUint32(at, true)) as [
    number,
    number,
    number,
    number,
  ];
  if (vkFormat !== 0)
    throw new ByteError(file, 12, `its texels have Vulkan's format ${vkFormat}; Basis Universal is read`);
  if (!(width >= 1 && height >= 1 && width <= LARGEST && height <= LARGEST) || depth > 0)
    throw new ByteError(file, 20, `an image of ${width} x ${height} x ${depth} texels`);
  return { width, height };
}

/** What a transcoder gives, with its rows from the bottom, and without what some add to fill blocks of 4 x 4. */
export function cropAndFlip(
  texels: Uint8Array,
  { width, height }: Ktx2Size,
): { data: Uint8Array; width: number; height: number } {
  const data = new Uint8Array(4 * width * height);
  const stride = texels.length === data.length ? width : 4 * Math.ceil(width / 4);
  for (let y = 0; y < height; y++) {
    const from = 4 * stride * (height - 1 - y);
    data.set(texels.subarray(from, from + 4 * width), 4 * width * y);
  }
  return { data, width, height };
}

/**
 * The transcoder's glue between JavaScript and WebAssembly (Emscripten's embind) writes functions as text, which the page's
 * policy forbids. These do the same without it. The names are those that are in scope where the text is made into a
 * function: for a method of a class the types of the result, of `this` and of the arguments, and `cppInvokerFunc`, which
 * calls `cppTargetFunc`; for a call out of WebAssembly the types of the arguments, which lie one after another at `args`.
 */
const WITHOUT_TEXT: readonly (readonly [generated: string, instead: string])[] = [
  [
    'newFunc(Function,args)(...closureArgs)',
    `(function (...given) {
  const destructors = [];
  const wired = argTypes.map((type, i) =>
    i === 0 || (i === 1 && !isClassMethodFunc) ? undefined : type.toWireType(destructors, i === 1 ? this : given[i - 2]));
  const result = cppInvokerFunc(cppTargetFunc, ...wired.slice(isClassMethodFunc ? 1 : 2));
  if (needsDestructorStack) runDestructors(destructors);
  else
    for (let i = isClassMethodFunc ? 1 : 2; i < argTypes.length; i++)
      argTypes[i].destructorFunction?.(wired[i]);
  return returns ? argTypes[0].fromWireType(result) : undefined;
})`,
  ],
  [
    'newFunc(Function,params)(...args)',
    `(function (obj, func, destructorsRef, args) {
  let at = args;
  const given = types.map((type) => {
    const value = type.readValueFromPointer(at);
    at += type.argPackAdvance;
    return value;
  });
  const result = kind === 1 ? new func(...given) : func.call(obj, ...given);
  return retType.isVoid ? undefined : emval_returnValue(retType, destructorsRef, result);
})`,
  ],
];

/** @param transcoder the text of basis_transcoder.js */
export function withoutGeneratedCode(transcoder: string): string {
  return WITHOUT_TEXT.reduce(
    (text, [generated, instead]) => text.replace(generated, () => instead),
    transcoder,
  );
}
