/** Slots of 4 floats that the kernel writes for a pixel (docs/decisions/path-tracer.md). */
export const FILM_SLOTS = 5;
export const FILM_FLOATS = 4 * FILM_SLOTS;

/**
 * What has been gathered for every pixel of a picture, row 0 at the top: sums over the samples, so that parts of a
 * rendering add up whatever their order.
 */
export class Film {
  readonly width: number;
  readonly height: number;
  /** Samples of each pixel. */
  readonly count: Float64Array;
  /** Radiance, RGB. */
  readonly radiance: Float64Array;
  /** Squares of the samples' radiance, RGB. */
  readonly squares: Float64Array;
  /** What the first surface reflects of white light from everywhere, as far as one direction tells; RGB. */
  readonly albedo: Float32Array;
  /** Squares of the samples' albedo, over R, G and B together. */
  readonly albedoSquares: Float32Array;
  /** Shading normals of the first surface in the world. */
  readonly normal: Float32Array;
  /** Distances of the first surface in metres; 0 where there is none. */
  readonly depth: Float32Array;
  /** 1 where a sample hit something. */
  readonly alpha: Float32Array;
  /** The part of the background that the shadows on the ground take, as luminance. */
  readonly shadow: Float32Array;
  /** Its squares where the picture is transparent: then all that is seen of shadows is in here. */
  readonly shadowSquares: Float32Array;

  constructor(width: number, height: number) {
    const pixels = width * height;
    this.width = width;
    this.height = height;
    this.count = new Float64Array(pixels);
    this.radiance = new Float64Array(3 * pixels);
    this.squares = new Float64Array(3 * pixels);
    this.albedo = new Float32Array(3 * pixels);
    this.albedoSquares = new Float32Array(pixels);
    this.normal = new Float32Array(3 * pixels);
    this.depth = new Float32Array(pixels);
    this.alpha = new Float32Array(pixels);
    this.shadow = new Float32Array(pixels);
    this.shadowSquares = new Float32Array(pixels);
  }

  /** Adds what the kernel wrote for pixels `from` and following. @param values FILM_FLOATS a pixel */
  add(values: Float32Array, from = 0): void {
    const { count, radiance, squares, albedo, albedoSquares, normal, depth, alpha, shadow, shadowSquares } =
      this;
    const pixels = values.length / FILM_FLOATS;
    for (let i = 0; i < pixels; i++) {
      const at = FILM_FLOATS * i;
      const pixel = from + i;
      count[pixel]! += values[at + 3]!;
      albedoSquares[pixel]! += values[at + 11]!;
      depth[pixel]! += values[at + 16]!;
      alpha[pixel]! += values[at + 17]!;
      shadow[pixel]! += values[at + 18]!;
      shadowSquares[pixel]! += values[at + 19]!;
      for (let c = 0; c < 3; c++) {
        radiance[3 * pixel + c]! += values[at + c]!;
        squares[3 * pixel + c]! += values[at + 4 + c]!;
        albedo[3 * pixel + c]! += values[at + 8 + c]!;
        normal[3 * pixel + c]! += values[at + 12 + c]!;
      }
    }
  }

  /** Mean radiance, RGB; 0 where there are no samples. In a deep shadow on the ground few samples may find less than none. */
  mean(): Float32Array {
    return this.#means(this.radiance).map((x) => (x < 0 ? 0 : x));
  }

  /** Mean albedo, RGB. */
  meanAlbedo(): Float32Array {
    return this.#means(this.albedo);
  }

  /** Mean normal, not of length 1 where a pixel sees several surfaces. */
  meanNormal(): Float32Array {
    return this.#means(this.normal);
  }

  /** Mean distance of what was hit, in metres; 0 where nothing was. */
  meanDepth(): Float32Array {
    return this.depth.map((sum, pixel) => (this.alpha[pixel]! > 0 ? sum / this.alpha[pixel]! : 0));
  }

  /** How much of the background a pixel covers: the part of the samples that hit something, and shadows on the ground. */
  meanAlpha(): Float32Array {
    return this.alpha.map((sum, pixel) => {
      const n = this.count[pixel]!;
      return n > 0 ? Math.min(1, Math.max(0, (sum + this.shadow[pixel]!) / n)) : 0;
    });
  }

  /**
   * Variance of the mean, RGB, as if the samples were independent. They are spread more evenly than that, so the
   * true error is smaller.
   */
  variance(): Float32Array {
    return new Float32Array(this.radiance.length).map((_, i) => {
      const n = this.count[Math.floor(i / 3)]!;
      if (n < 2) return 0;
      const mean = this.radiance[i]! / n;
      return Math.max(0, this.squares[i]! / n - mean * mean) / (n - 1);
    });
  }

  /** Variance of the mean of what shadows cover of a transparent picture; 0 where it is known without it. */
  shadowVariance(pixel: number): number {
    const [n, squares] = [this.count[pixel]!, this.shadowSquares[pixel]!];
    if (n < 2 || squares === 0) return 0;
    return Math.max(0, squares / n - (this.shadow[pixel]! / n) ** 2) / (n - 1);
  }

  /**
   * The picture's error: the standard deviation of the pixels' means over the mean of the picture, which no single
   * dark pixel can blow up. Infinite before two samples. Shadows in a transparent picture count as before a background
   * as bright as the picture is in the mean.
   */
  relativeError(): number {
    let sum = 0;
    let variance = 0;
    for (let i = 0; i < this.radiance.length; i++) {
      const n = this.count[Math.floor(i / 3)]!;
      if (n < 2) return Number.POSITIVE_INFINITY;
      const mean = this.radiance[i]! / n;
      sum += mean;
      variance += Math.max(0, this.squares[i]! / n - mean * mean) / (n - 1);
    }
    const mean = sum / this.radiance.length;
    const shadows = this.count.reduce((total, _, pixel) => total + this.shadowVariance(pixel), 0);
    variance += 3 * shadows * mean * mean;
    return mean > 0 ? Math.sqrt(variance / this.radiance.length) / mean : 0;
  }

  #means(sums: Float32Array | Float64Array): Float32Array {
    return new Float32Array(sums.length).map((_, i) => {
      const n = this.count[Math.floor(i / 3)]!;
      return n > 0 ? sums[i]! / n : 0;
    });
  }
}
