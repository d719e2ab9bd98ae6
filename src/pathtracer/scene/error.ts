/** A scene that cannot be path traced: what, where, and the limit that it breaks. */
export class PathTracerError extends Error {
  override readonly name = 'PathTracerError';
}
