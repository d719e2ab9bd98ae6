/** A model file that cannot be used: which file, where in it, and what is wrong there. */
export class ModelFileError extends Error {
  override readonly name = 'ModelFileError';

  /** @param place such as 'line 12' or 'materials[2]'; '' is the file as a whole */
  constructor(
    readonly file: string,
    readonly place: string,
    message: string,
    options?: ErrorOptions,
  ) {
    super(`${file}: ${place === '' ? '' : `${place}: `}${message}`, options);
  }
}
