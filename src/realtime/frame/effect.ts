/** What an effect is to the frame: a definition that says when it is there, and what it draws when it is. */
import type { PerspectiveCamera, RenderTarget, Scene, WebGPURenderer } from 'three/webgpu';
import type { EffectName, Effects } from '../../scene/effects-schema.ts';
import type { Background, Camera, Document, Environment, Fog, Ground, View } from '../../scene/schema.ts';
import type { FrameInputs } from './inputs.ts';

export type ViewSettings = Pick<View, 'exposure' | 'toneMapping' | 'resolutionScale'> &
  Partial<Pick<View, 'exposureMode' | 'show'>>;

/** The parts of a document that a frame depends on, beside the scene itself. A document is one. */
export interface FrameSettings {
  readonly view: ViewSettings;
  /** Left out: none. */
  readonly effects?: Effects;
  readonly camera?: Camera;
  readonly fog?: Fog;
  readonly lights?: Document['lights'];
  readonly environment?: Environment;
  /** A transparent one gives the picture alpha. */
  readonly background?: Background;
  /** Left out: none. */
  readonly ground?: Ground;
}

/** The settings of a frame that has effects. */
export interface EffectSettings extends FrameSettings {
  readonly effects: Effects;
}

export interface EffectDefinition {
  readonly name: EffectName;
  /** Whether the frame has it. */
  isOn(settings: EffectSettings): boolean;
  /** What is built for these settings; when it changes, the effect is built anew, which compiles. */
  variant?(settings: EffectSettings): string;
  /** It reads what the surfaces pass draws: depth, normals and motion. */
  readonly needsSurfaces: boolean;
  build(inputs: FrameInputs, settings: EffectSettings): Effect;
}

/** Its methods are called in this order, once a frame. */
export interface Effect {
  /** Takes numbers over into uniforms: compiles nothing. */
  update?(settings: EffectSettings): void;
  /** Where in its pixel the scene is looked at, once a frame, in pixels from the middle: each within -0.5..0.5. */
  jitter?(): readonly [x: number, y: number];
  /** Draws what the scene's materials read, when the surfaces are known and the scene is not drawn yet. */
  beforeScene?(renderer: WebGPURenderer, scene: Scene, camera: PerspectiveCamera): void;
  /** What all materials are told: see FrameContext in src/material/frame-context.ts. */
  readonly context?: Readonly<Record<string, unknown>>;
  /** From linear radiance to linear radiance, in a target of its own; undefined where it changes nothing this time. */
  afterScene?(renderer: WebGPURenderer, input: RenderTarget): RenderTarget | undefined;
  /** From the picture as a screen shows it to another, in 8-bit sRGB. */
  afterOutput?(renderer: WebGPURenderer, input: RenderTarget): RenderTarget;
  /** Further frames of a scene that stands still would be better. */
  readonly unsettled?: boolean;
  dispose(): void;
}
