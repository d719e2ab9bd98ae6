/** The effects of the present frame: builds those that are switched on, keeps them while they stay, and has them draw. */
import { context } from 'three/tsl';
import type { PerspectiveCamera, RenderTarget, Scene, WebGPURenderer } from 'three/webgpu';
import type { EffectName } from '../../scene/effects-schema.ts';
import { effects as definitions } from '../effects/index.ts';
import type { Effect, EffectDefinition, EffectSettings, FrameSettings } from './effect.ts';
import type { FrameInputs } from './inputs.ts';

interface Entry {
  readonly definition: EffectDefinition;
  readonly variant: string;
  readonly effect: Effect;
}

export class EffectChain {
  readonly #inputs: FrameInputs;
  /** Told when an effect has drawn what it draws at one of its places in the frame. */
  readonly #onDrawn: (effect: EffectName) => void;
  #entries: readonly Entry[] = [];
  /** What all materials are told, and the node that tells them. */
  #told: Readonly<Record<string, unknown>> = {};
  #context = context(this.#told) as WebGPURenderer['contextNode'];

  constructor(inputs: FrameInputs, onDrawn: (effect: EffectName) => void = () => {}) {
    this.#inputs = inputs;
    this.#onDrawn = onDrawn;
  }

  /**
   * Makes the chain that these settings ask for.
   *
   * @param more that all materials are told, beside what effects tell them
   */
  follow(three: WebGPURenderer, settings: FrameSettings, more: Readonly<Record<string, unknown>> = {}): void {
    const before = this.#entries;
    const wanted = settings.effects === undefined ? [] : this.#wanted(settings as EffectSettings);
    const kept = new Map(before.map((entry) => [`${entry.definition.name} ${entry.variant}`, entry]));
    this.#entries = wanted.map(({ definition, variant }) => {
      const known = kept.get(`${definition.name} ${variant}`);
      if (known) return known;
      return { definition, variant, effect: definition.build(this.#inputs, settings as EffectSettings) };
    });
    for (const entry of before) if (!this.#entries.includes(entry)) entry.effect.dispose();
    for (const { effect } of this.#entries) effect.update?.(settings as EffectSettings);
    // Materials are compiled anew where it differs: only when what they are told does.
    const told = Object.assign({}, ...this.#entries.map(({ effect }) => effect.context ?? {}), more);
    if (!sameEntries(this.#told, told)) {
      this.#told = told;
      this.#context = context(told) as WebGPURenderer['contextNode'];
    }
    // Another renderer beside this one may have drawn since: materials would be told of its frames.
    three.contextNode = this.#context;
  }

  get needsSurfaces(): boolean {
    return this.#entries.some(({ definition }) => definition.needsSurfaces);
  }

  /** Whether materials ask for the shadows of single lamps. */
  get drawsShadows(): boolean {
    return 'shadows' in this.#told;
  }

  get unsettled(): boolean {
    return this.#entries.some(({ effect }) => effect.unsettled === true);
  }

  jitter(): readonly [x: number, y: number] {
    for (const { effect } of this.#entries) if (effect.jitter) return effect.jitter();
    return [0, 0];
  }

  beforeScene(three: WebGPURenderer, scene: Scene, camera: PerspectiveCamera): void {
    for (const { definition, effect } of this.#entries) {
      effect.beforeScene?.(three, scene, camera);
      this.#onDrawn(definition.name);
    }
  }

  afterScene(three: WebGPURenderer, radiance: RenderTarget): RenderTarget {
    return this.#entries.reduce((input, { definition, effect }) => {
      const output = effect.afterScene?.(three, input) ?? input;
      this.#onDrawn(definition.name);
      return output;
    }, radiance);
  }

  /** Whether any of them works on the picture as a screen shows it. */
  get worksOnOutput(): boolean {
    return this.#entries.some(({ effect }) => effect.afterOutput !== undefined);
  }

  afterOutput(three: WebGPURenderer, picture: RenderTarget): RenderTarget {
    return this.#entries.reduce((input, { definition, effect }) => {
      const output = effect.afterOutput?.(three, input) ?? input;
      this.#onDrawn(definition.name);
      return output;
    }, picture);
  }

  dispose(): void {
    for (const { effect } of this.#entries) effect.dispose();
    this.#entries = [];
  }

  #wanted(settings: EffectSettings): { definition: EffectDefinition; variant: string }[] {
    return definitions
      .filter((definition) => definition.isOn(settings))
      .map((definition) => ({ definition, variant: definition.variant?.(settings) ?? '' }));
  }
}

function sameEntries(a: object, b: object): boolean {
  const [x, y] = [Object.entries(a), Object.entries(b)];
  return x.length === y.length && x.every(([key, value]) => (b as Record<string, unknown>)[key] === value);
}
