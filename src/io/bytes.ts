/** A binary file that is broken: which file, at which byte, and what is wrong there. */
export class ByteError extends Error {
  override readonly name = 'ByteError';
  constructor(
    readonly fileName: string,
    readonly offset: number,
    message: string,
    cause?: unknown,
  ) {
    super(`${fileName}: byte ${offset}: ${message}`, { cause });
  }
}

/** @throws ByteError if a file of samples is not exactly as long as its head says */
export function checkSize(bytes: Uint8Array, size: number, fileName: string): void {
  const more = size - bytes.length;
  if (more > 0)
    throw new ByteError(fileName, bytes.length, `the file ends here; expected ${more} more bytes of samples`);
  if (more < 0)
    throw new ByteError(fileName, size, `${-more} bytes after the last sample; expected the end of the file`);
}

/** Reads little-endian values and never beyond the end. */
export class ByteReader {
  #at = 0;
  readonly #view: DataView;

  constructor(
    readonly file: Uint8Array,
    readonly fileName: string,
  ) {
    this.#view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  }

  get position(): number {
    return this.#at;
  }

  seek(offset: number): void {
    if (!(offset >= 0 && offset <= this.file.length))
      throw this.error(`points to byte ${offset}, outside the file`);
    this.#at = offset;
  }

  need(size: number): void {
    if (!(size >= 0 && this.#at + size <= this.file.length)) {
      throw this.error(`the file ends here; expected ${size} more bytes`);
    }
  }

  error(message: string, cause?: unknown): ByteError {
    return new ByteError(this.fileName, this.#at, message, cause);
  }

  uint8(): number {
    return this.#view.getUint8(this.#take(1));
  }
  uint16(): number {
    return this.#view.getUint16(this.#take(2), true);
  }
  int32(): number {
    return this.#view.getInt32(this.#take(4), true);
  }
  uint32(): number {
    return this.#view.getUint32(this.#take(4), true);
  }
  uint64(): number {
    return Number(this.#view.getBigUint64(this.#take(8), true));
  }
  bytes(size: number): Uint8Array {
    const at = this.#take(size);
    return this.file.subarray(at, at + size);
  }
  utf8(size: number): string {
    return new TextDecoder().decode(this.bytes(size));
  }
  /** Text up to a zero byte, of the 255 bytes at most that formats allow their names. */
  cString(): string {
    const end = this.file.subarray(0, this.#at + 256).indexOf(0, this.#at);
    if (end < 0) throw this.error('a name that does not end');
    const text = this.utf8(end - this.#at);
    this.#at++;
    return text;
  }

  #take(size: number): number {
    this.need(size);
    this.#at += size;
    return this.#at - size;
  }
}

/** Writes little-endian values into a buffer that grows. */
export class ByteWriter {
  #bytes = new Uint8Array(1024);
  #view = new DataView(this.#bytes.buffer);
  #length = 0;

  get length(): number {
    return this.#length;
  }

  // Growing comes first, in a statement of its own: it replaces the view.
  uint8(value: number): void {
    const at = this.#grow(1);
    this.#view.setUint8(at, value);
  }
  uint16(value: number): void {
    const at = this.#grow(2);
    this.#view.setUint16(at, value, true);
  }
  int32(value: number): void {
    const at = this.#grow(4);
    this.#view.setInt32(at, value, true);
  }
  float32(value: number): void {
    const at = this.#grow(4);
    this.#view.setFloat32(at, value, true);
  }
  uint64(value: number): void {
    const at = this.#grow(8);
    this.setUint64(at, value);
  }
  bytes(data: Uint8Array): void {
    const at = this.#grow(data.length);
    this.#bytes.set(data, at);
  }
  utf8(text: string): void {
    this.bytes(new TextEncoder().encode(text));
  }
  cString(text: string): void {
    this.utf8(text);
    this.uint8(0);
  }

  setInt32(at: number, value: number): void {
    this.#view.setInt32(at, value, true);
  }
  setUint64(at: number, value: number): void {
    this.#view.setBigUint64(at, BigInt(value), true);
  }

  finish(): Uint8Array {
    return this.#bytes.slice(0, this.#length);
  }

  #grow(size: number): number {
    const at = this.#length;
    this.#length += size;
    if (this.#length > this.#bytes.length) {
      const larger = new Uint8Array(Math.max(this.#length, this.#bytes.length * 2));
      larger.set(this.#bytes);
      this.#bytes = larger;
      this.#view = new DataView(larger.buffer);
    }
    return at;
  }
}
