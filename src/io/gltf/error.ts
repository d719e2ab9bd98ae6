/** A glTF file that cannot be used: the message names the file and what in it is wrong. */
export class GltfError extends Error {
  override readonly name = 'GltfError';
  readonly file: string;

  constructor(file: string, message: string, options?: ErrorOptions) {
    super(`${file}: ${message}`, options);
    this.file = file;
  }
}
