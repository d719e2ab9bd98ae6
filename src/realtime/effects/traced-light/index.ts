/**
 * Reflections and one bounce of indirect light from what the picture shows: each material draws rays by its own model, the
 * depth buffer is marched along them, and what they hit has the radiance that it had in the last frame. So whatever was
 * lit by a bounce there lights on: in a scene that stands still, every frame adds a bounce.
 */
import { uniform, vec4 } from 'three/tsl';
import type { Node, PerspectiveCamera, RenderTarget, Scene, WebGPURenderer } from 'three/webgpu';
import type { FrameContext } from '../../../material/frame-context.ts';
import type { Effect, EffectDefinition, EffectSettings } from '../../frame/effect.ts';
import type { FrameInputs } from '../../frame/inputs.ts';
import { type Guide, releaseGuide, takeGuide } from '../screen-space/guide.ts';
import { atFragment } from '../screen-space/upsample.ts';
import { Denoiser, GATHERED } from './denoiser.ts';
import { RadianceHistory } from './radiance-history.ts';
import { TracePass } from './trace-pass.ts';

type Vec3 = Node<'vec3'>;

/** After as many, noise is where it was. */
const FRAMES = 256;

type Groups = readonly EffectSettings['effects']['reflections'][];

/** The groups that are switched on. */
const groupsOf = ({ effects: { reflections, indirectLight } }: EffectSettings): Groups =>
  [reflections, indirectLight].filter(({ enabled }) => enabled);

class TracedLightEffect implements Effect {
  readonly context: FrameContext;
  readonly #inputs: FrameInputs;
  readonly #guide: Guide;
  readonly #history: RadianceHistory;
  readonly #trace: TracePass;
  readonly #denoiser: Denoiser;
  readonly #numbers = {
    rays: uniform(4),
    steps: uniform(32),
    thickness: uniform(0.5),
    frame: uniform(0),
    hasHistory: uniform(0),
  };
  #denoises = true;

  constructor(inputs: FrameInputs, settings: EffectSettings) {
    const { reflections, indirectLight } = settings.effects;
    const kinds = { reflections: reflections.enabled, indirectLight: indirectLight.enabled };
    this.#inputs = inputs;
    this.#guide = takeGuide(inputs, scaleOf(settings));
    this.#history = new RadianceHistory(inputs);
    this.#trace = new TracePass(inputs, this.#guide, this.#history, { ...this.#numbers, ...kinds });
    this.#denoiser = new Denoiser(inputs, this.#guide);
    this.context = {
      tracedLight: {
        ...kinds,
        incident: () =>
          atFragment(this.#guide, this.#denoiser.result, (texel) => vec4(texel.rgb, 1)).rgb as Vec3,
      },
    };
  }

  get unsettled(): boolean {
    // A frame at least for the first bounce; then until the noise is gone.
    return this.#inputs.steady < (this.#denoises ? GATHERED : 1);
  }

  update(settings: EffectSettings): void {
    const groups = groupsOf(settings);
    const { rays, steps, thickness } = this.#numbers;
    rays.value = Math.max(...groups.map((group) => group.rays));
    steps.value = Math.max(...groups.map((group) => group.steps));
    thickness.value = Math.max(...groups.map((group) => group.thickness));
    this.#denoises = groups.some(({ denoise }) => denoise);
  }

  beforeScene(renderer: WebGPURenderer, scene: Scene, camera: PerspectiveCamera): void {
    this.#guide.render(renderer);
    const { x: width, y: height } = this.#inputs.size.value;
    const isKnown = !this.#inputs.isCut && this.#history.isOf(width, height);
    this.#numbers.hasHistory.value = Number(isKnown);
    // Noise that nothing gathers stays where it is.
    this.#numbers.frame.value = this.#denoises ? this.#inputs.frameIndex.value % FRAMES : 0;
    const { x, y } = this.#guide.size.value;
    const found = this.#trace.render(renderer, scene, camera, x, y);
    this.#denoiser.render(renderer, found, this.#denoises, !isKnown);
  }

  afterScene(renderer: WebGPURenderer, input: RenderTarget): RenderTarget {
    this.#history.keep(renderer, input);
    return input;
  }

  dispose(): void {
    releaseGuide(this.#inputs, this.#guide);
    this.#history.dispose();
    this.#trace.dispose();
    this.#denoiser.dispose();
  }
}

const scaleOf = (settings: EffectSettings): number =>
  groupsOf(settings).every(({ halfResolution }) => halfResolution) ? 0.5 : 1;

export const tracedLight: EffectDefinition = {
  name: 'reflections',
  isOn: (settings) => groupsOf(settings).length > 0,
  variant: (settings) => {
    const { reflections, indirectLight } = settings.effects;
    return `${reflections.enabled} ${indirectLight.enabled} ${scaleOf(settings)}`;
  },
  needsSurfaces: true,
  build: (inputs, settings) => new TracedLightEffect(inputs, settings),
};
