/**
 * Depth of field: the light of every point is spread over its circle of confusion, by gathering what reaches a pixel from
 * those around, at half the size. What is before the focus spreads over everything; what is behind it is hidden by what
 * is nearer, so what is sharp leaves no halo in what is not. After J. Jimenez, 2014, "Next Generation Post Processing in
 * Call of Duty: Advanced Warfare", SIGGRAPH course.
 */
import { texture, uniform } from 'three/tsl';
import { type RenderTarget, Vector2, type WebGPURenderer } from 'three/webgpu';
import type { Effect, EffectDefinition, EffectSettings } from '../../frame/effect.ts';
import type { FrameInputs } from '../../frame/inputs.ts';
import { inputTexture, Pass } from '../../frame/pass.ts';
import { CircleOfConfusion } from './circle.ts';
import { composed } from './compose.ts';
import { farGathered, nearGathered } from './gather.ts';
import { halved, TILE, tileReach, tileSpread } from './prepare.ts';

class DepthOfField implements Effect {
  readonly #circle: CircleOfConfusion;
  readonly #samples = uniform(16, 'int');
  readonly #picture = inputTexture();
  /** Pixels of the picture and of its half. */
  readonly #halfSize = uniform(new Vector2(1, 1));
  readonly #tileSize = uniform(new Vector2(1, 1));
  readonly #passes: Readonly<Record<'half' | 'tiles' | 'across' | 'reach' | 'far' | 'near' | 'result', Pass>>;

  constructor(inputs: FrameInputs) {
    this.#circle = new CircleOfConfusion(inputs);
    const shared = { inputs, circle: this.#circle, samples: this.#samples, halfSize: this.#halfSize };
    const exact = { isBlended: false };
    const half = new Pass('half and circles', halved(shared, this.#picture), exact);
    const halfMap = texture(half.target.texture);
    const tiles = new Pass('tiles of circles', tileReach(shared, halfMap), exact);
    // As many tiles as the largest circle may reach, for any size of the picture.
    const across = new Pass(
      'reach across',
      tileSpread(shared, this.#tileSize, texture(tiles.target.texture), 'x'),
      exact,
    );
    const reach = new Pass(
      'reach',
      tileSpread(shared, this.#tileSize, texture(across.target.texture), 'y'),
      exact,
    );
    const reachMap = texture(reach.target.texture);
    const far = new Pass('far', farGathered(shared, halfMap));
    const near = new Pass('near', nearGathered(shared, halfMap, reachMap));
    const result = new Pass(
      'depth of field',
      composed(shared, this.#picture, {
        half: halfMap,
        far: texture(far.target.texture),
        near: texture(near.target.texture),
        reach: reachMap,
      }),
    );
    this.#passes = { half, tiles, across, reach, far, near, result };
  }

  update({ camera, effects }: EffectSettings): void {
    if (camera) this.#circle.update(camera);
    this.#samples.value = effects.depthOfField.samples;
  }

  afterScene(renderer: WebGPURenderer, input: RenderTarget): RenderTarget {
    const { half, tiles, across, reach, far, near, result } = this.#passes;
    const size = [input.width, input.height] as const;
    const halfSize = size.map((length) => Math.max(1, Math.ceil(length / 2))) as [number, number];
    const tileSize = halfSize.map((length) => Math.ceil(length / TILE)) as [number, number];
    this.#halfSize.value.set(...halfSize);
    this.#tileSize.value.set(...tileSize);
    this.#picture.value = input.texture;
    half.render(renderer, ...halfSize);
    for (const pass of [tiles, across, reach]) pass.render(renderer, ...tileSize);
    for (const pass of [far, near]) pass.render(renderer, ...halfSize);
    return result.render(renderer, ...size);
  }

  dispose(): void {
    for (const pass of Object.values(this.#passes)) pass.dispose();
  }
}

export const depthOfField: EffectDefinition = {
  name: 'depthOfField',
  isOn: ({ effects, camera }) => effects.depthOfField.enabled && (camera?.fStop ?? 0) > 0,
  needsSurfaces: true,
  build: (inputs) => new DepthOfField(inputs),
};
