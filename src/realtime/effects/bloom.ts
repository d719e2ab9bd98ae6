/**
 * Glow: a part of the light of every pixel is spread over its surroundings, as the glass of a lens and the eye do. What is
 * spread is taken from the pixel, so the picture's mean stays as it was; there is no threshold.
 *
 * A pyramid of half sizes, down by 13 taps and up by 9 (J. Jimenez, 2014, "Next Generation Post Processing in Call of Duty:
 * Advanced Warfare", SIGGRAPH course), mixed by the radius.
 */
import { mix, texture, uniform, uv, vec2, vec4 } from 'three/tsl';
import { type Node, type RenderTarget, Vector2, type WebGPURenderer } from 'three/webgpu';
import { BRIGHTEST_HALF } from '../../material/half-float.ts';
import type { Effects } from '../../scene/effects-schema.ts';
import type { Effect, EffectDefinition, EffectSettings } from '../frame/effect.ts';
import type { FrameInputs } from '../frame/inputs.ts';
import { inputTexture, Pass } from '../frame/pass.ts';
import { lensDirt } from './lens-dirt.ts';

/** Halvings; 7 of them reach across a picture of some hundred pixels and a tenth of a large one. */
const LEVELS = 7;
/** Pixels of the picture along a side of the smallest level's. */
export const BLOOM_GRID = 2 ** LEVELS;

/** How many times as much light is spread behind the thickest dirt, less one. */
const DIRTIEST = 12;

/** Offsets in texels of the source, and weights; each of its five boxes of four has a mean of 1. */
const DOWN: readonly (readonly [x: number, y: number, weight: number])[] = [
  [0, 0, 0.125],
  ...[
    [-1, -1],
    [1, -1],
    [-1, 1],
    [1, 1],
  ].map(([x, y]) => [x!, y!, 0.125] as const),
  ...[
    [-2, 0],
    [2, 0],
    [0, -2],
    [0, 2],
  ].map(([x, y]) => [x!, y!, 0.0625] as const),
  ...[
    [-2, -2],
    [2, -2],
    [-2, 2],
    [2, 2],
  ].map(([x, y]) => [x!, y!, 0.03125] as const),
];

/** A tent of 3 x 3 texels. */
const UP = [-1, 0, 1].flatMap((y) =>
  [-1, 0, 1].map((x) => [x, y, ((2 - Math.abs(x)) * (2 - Math.abs(y))) / 16] as const),
);

class Bloom implements Effect {
  readonly #strength = uniform(0);
  readonly #radius = uniform(0);
  readonly #dirt = uniform(0);
  readonly #source = inputTexture();
  readonly #down: Level[];
  readonly #up: Level[];
  readonly #result: Pass;

  /** @param hasDirt whether there may be any on the lens */
  constructor(inputs: FrameInputs, hasDirt: boolean) {
    this.#down = Array.from({ length: LEVELS }, (_, i) => new Level(`bloom down ${i}`, DOWN));
    // From the second smallest to the largest: what is below, spread, mixed with what is here.
    this.#up = Array.from({ length: LEVELS - 1 }, (_, i) => new Level(`bloom up ${i}`, UP, this.#radius));
    const glow = texture((this.#up.at(-1) as Level).pass.target.texture);
    const own = this.#source.rgb;
    // Where there is dirt on the lens, more of the light is spread.
    const strength = hasDirt
      ? this.#strength.mul(lensDirt(inputs).mul(this.#dirt).mul(DIRTIEST).add(1)).min(1)
      : this.#strength;
    this.#result = new Pass('bloom', vec4(mix(own, glow.rgb, strength), this.#source.a));
  }

  update({ effects: { bloom, lens } }: EffectSettings): void {
    this.#dirt.value = lens.dirt;
    this.#strength.value = bloom.strength;
    this.#radius.value = bloom.radius;
  }

  afterScene(renderer: WebGPURenderer, input: RenderTarget): RenderTarget {
    const { width, height } = input;
    let source = input;
    const sizes = this.#down.map((_, i) => [width / 2 ** (i + 1), height / 2 ** (i + 1)] as const);
    for (const [i, level] of this.#down.entries()) source = level.render(renderer, source, ...sizes[i]!);
    for (const [i, level] of this.#up.entries()) {
      const at = LEVELS - 2 - i;
      source = level.render(renderer, source, ...sizes[at]!, this.#down[at]!.pass.target);
    }
    this.#source.value = input.texture;
    return this.#result.render(renderer, width, height);
  }

  dispose(): void {
    for (const level of [...this.#down, ...this.#up]) level.pass.dispose();
    this.#result.dispose();
  }
}

/** One size of the pyramid: a filter of what comes from another, mixed with what is here where there is something. */
class Level {
  readonly pass: Pass;
  readonly #source = inputTexture();
  readonly #here = inputTexture();
  readonly #texel = uniform(new Vector2());

  constructor(name: string, taps: readonly (readonly [number, number, number])[], share?: Node<'float'>) {
    let sum: Node<'vec3'> | null = null;
    for (const [x, y, weight] of taps) {
      // An infinite pixel would be spread over all of them.
      const look = this.#source.sample(uv().add(vec2(x, y).mul(this.#texel))).rgb.clamp(0, BRIGHTEST_HALF);
      const tap = look.mul(weight);
      sum = (sum === null ? tap : sum.add(tap)) as Node<'vec3'>;
    }
    const filtered = sum as Node<'vec3'>;
    this.pass = new Pass(name, vec4(share ? mix(this.#here.rgb, filtered, share) : filtered, 1));
  }

  render(
    renderer: WebGPURenderer,
    source: RenderTarget,
    width: number,
    height: number,
    here?: RenderTarget,
  ): RenderTarget {
    this.#source.value = source.texture;
    this.#texel.value.set(1 / source.width, 1 / source.height);
    if (here) this.#here.value = here.texture;
    return this.pass.render(renderer, width, height);
  }
}

const hasDirt = ({ enabled, dirt }: Effects['lens']): boolean => enabled && dirt > 0;

export const bloom: EffectDefinition = {
  name: 'bloom',
  isOn: ({ effects }) => effects.bloom.enabled && effects.bloom.strength > 0,
  needsSurfaces: false,
  variant: ({ effects: { lens } }) => (hasDirt(lens) ? 'dirt' : ''),
  build: (inputs, { effects: { lens } }) => new Bloom(inputs, hasDirt(lens)),
};
