/** Triangles as a geometry has them. */
export interface Shape {
  /** xyz of each vertex. */
  readonly positions: Float32Array;
  /** Three vertices for each triangle; null if they follow one another. */
  readonly index: Uint16Array | Uint32Array | null;
}

/** Of the corner `i`: three a triangle, one after another. */
export const vertexOf = ({ index }: Shape, i: number): number => (index ? (index[i] as number) : i);
