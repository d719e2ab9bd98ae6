/** The meter of the automatic exposure: the GPU averages the picture's cells, the CPU sorts them and follows. */
import { float, uv, vec2, vec4 } from 'three/tsl';
import { FloatType, type Node, type Texture, type WebGPURenderer } from 'three/webgpu';
import { adapted, METER_CELLS, meter } from '../color/exposure.ts';
import { BRIGHTEST_HALF } from '../material/half-float.ts';
import { inputTexture, Pass } from './frame/pass.ts';

/** Looks into each cell along each side; between four texels each, so that a cell of 8 x 8 is averaged whole. */
const TAPS = 4;

export class ExposureMeter {
  /** EV, as of now; null before anything was metered. */
  #exposure: number | null = null;
  /** EV, where it is going. */
  #goal: number | null = null;
  #reading = false;
  /** A reading from before a cut is of no use. */
  #cuts = 0;
  readonly #source = inputTexture();
  readonly #pass: Pass;

  constructor() {
    const cell = 1 / METER_CELLS;
    let sum: Node<'float'> = float(0);
    for (let i = 0; i < TAPS * TAPS; i++) {
      const [x, y] = [i % TAPS, Math.floor(i / TAPS)].map((k) => ((k! + 0.5) / TAPS - 0.5) * cell);
      const { r, g, b } = this.#source.sample(uv().add(vec2(x!, y!)));
      // Of ITU-R BT.709-6, item 3.2, as luminance() in src/color.
      const nits = r.mul(0.2126).add(g.mul(0.7152)).add(b.mul(0.0722));
      // An infinite pixel must not make the mean infinite.
      sum = sum.add(nits.clamp(0, BRIGHTEST_HALF)) as Node<'float'>;
    }
    this.#pass = new Pass('exposure meter', vec4(sum.div(TAPS * TAPS), 0, 0, 1), { type: FloatType });
  }

  get exposure(): number {
    return this.#exposure ?? 0;
  }

  /** Has not come to where it is going, or does not know where that is. */
  get unsettled(): boolean {
    return this.#reading || this.#goal !== this.#exposure;
  }

  /** What comes has nothing to do with what was: no way is gone from there to here. */
  cut(): void {
    this.#exposure = null;
    this.#goal = null;
    this.#cuts += 1;
  }

  /** Begins to look at a picture, unless it is still busy with one, and goes its way for `seconds`. */
  follow(three: WebGPURenderer, radiance: Texture, seconds: number): void {
    if (this.#goal !== null) {
      this.#exposure = this.#exposure === null ? this.#goal : adapted(this.#exposure, this.#goal, seconds);
    }
    if (this.#reading) return;
    this.#reading = true;
    const cuts = this.#cuts;
    this.#read(three, radiance)
      .then((goal) => {
        if (cuts !== this.#cuts) return;
        this.#goal = goal;
        this.#exposure ??= goal;
      })
      // A renderer that is gone says so elsewhere.
      .catch(() => {})
      .finally(() => {
        this.#reading = false;
      });
  }

  /** Exposes for this picture at once. */
  async settle(three: WebGPURenderer, radiance: Texture): Promise<void> {
    const goal = await this.#read(three, radiance);
    this.#goal = goal;
    this.#exposure = goal;
  }

  dispose(): void {
    this.#pass.dispose();
  }

  async #read(three: WebGPURenderer, radiance: Texture): Promise<number> {
    this.#source.value = radiance;
    const side = METER_CELLS;
    const target = this.#pass.render(three, side, side);
    const pixels = await three.readRenderTargetPixelsAsync(target, 0, 0, side, side);
    const cells = Float32Array.from({ length: side * side }, (_, i) => (pixels as Float32Array)[4 * i]!);
    return meter(cells, side);
  }
}
