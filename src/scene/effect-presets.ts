/**
 * Presets of effects: how much of the light's way the interactive picture follows, from none to all that there is. They
 * set what costs time and leave alone what is a matter of taste or of the scene's size: glow, faults of the lens, motion
 * blur, radii and lengths.
 */
import { type EffectName, type Effects, effectsDefaults } from './effects-schema.ts';
import type { Document } from './schema.ts';
import type { DocumentStore } from './store.ts';

/** From the cheapest to the dearest. */
export const presetNames = ['low', 'medium', 'high', 'ultra'] as const;
export type PresetName = (typeof presetNames)[number];

type PresetFields = { readonly [E in EffectName]?: Readonly<Partial<Effects[E]>> };

interface Preset {
  readonly description: string;
  readonly effects: PresetFields;
}

export const presets: Readonly<Record<PresetName, Preset>> = {
  low: {
    description: 'Plain shading, four samples a pixel: every lamp shines through everything',
    // What documents have that say nothing about effects.
    effects: {
      shadows: { enabled: false },
      ambientOcclusion: { enabled: false },
      contactShadows: { enabled: false },
      reflections: { enabled: false },
      indirectLight: { enabled: false },
      fog: { steps: 24, halfResolution: true },
      antialiasing: { method: 'msaa' },
      depthOfField: { enabled: false },
    },
  },
  medium: {
    description: 'Shadows of all lamps, darker corners, depth of field where the lens has an aperture',
    effects: {
      shadows: { enabled: true, resolution: 1024, samples: 12, cascades: 2 },
      ambientOcclusion: { enabled: true, directions: 2, steps: 4, halfResolution: true },
      contactShadows: { enabled: false },
      reflections: { enabled: false },
      indirectLight: { enabled: false },
      fog: { steps: 24, halfResolution: true },
      antialiasing: { method: 'smaa' },
      depthOfField: { enabled: true, samples: 32 },
    },
  },
  high: {
    description: 'Also contact shadows and reflections of what is in the picture; edges smoothed over time',
    effects: {
      shadows: { enabled: true, resolution: 1024, samples: 12, cascades: 3 },
      ambientOcclusion: { enabled: true, directions: 3, steps: 6, halfResolution: true },
      contactShadows: { enabled: true, steps: 8 },
      reflections: { enabled: true, rays: 1, steps: 24, halfResolution: true, denoise: true },
      indirectLight: { enabled: false },
      fog: { steps: 24, halfResolution: true },
      antialiasing: { method: 'temporal' },
      depthOfField: { enabled: true, samples: 48 },
    },
  },
  ultra: {
    description: 'Also light that bounces between surfaces, and more samples of everything',
    effects: {
      shadows: { enabled: true, resolution: 2048, samples: 24, cascades: 4 },
      ambientOcclusion: { enabled: true, directions: 4, steps: 8, halfResolution: true },
      contactShadows: { enabled: true, steps: 12 },
      reflections: { enabled: true, rays: 2, steps: 32, halfResolution: true, denoise: true },
      indirectLight: { enabled: true, rays: 2, steps: 32, halfResolution: true, denoise: true },
      fog: { steps: 48, halfResolution: false },
      antialiasing: { method: 'temporal' },
      depthOfField: { enabled: true, samples: 96 },
    },
  },
};

/** These effects as a preset has them; what it does not set stays. */
export function withPreset(effects: Effects, name: PresetName): Effects {
  const entries = Object.entries(presets[name].effects);
  const changed = entries.map(([effect, fields]) => [
    effect,
    { ...effects[effect as EffectName], ...fields },
  ]);
  return { ...effects, ...Object.fromEntries(changed) };
}

/** The preset that these effects are, or null: a person's own choice. */
export function presetOf(effects: Effects): PresetName | null {
  const isSet = (name: PresetName) =>
    Object.entries(presets[name].effects).every(([effect, fields]) =>
      Object.entries(fields).every(
        ([field, value]) => (effects[effect as EffectName] as Record<string, unknown>)[field] === value,
      ),
    );
  return presetNames.find(isSet) ?? null;
}

/** One undo step. */
export function applyPreset(store: DocumentStore, name: PresetName): void {
  store.edit(`Effects: ${name}`, (draft) => {
    draft.effects = withPreset(store.document.effects, name);
  });
}

/** Whether the document says nothing about effects: it has those of every new one. */
export function hasDefaultEffects({ effects }: Document): boolean {
  const [given, usual] = [effects, effectsDefaults] as readonly Record<string, object>[];
  return Object.entries(usual!).every(([effect, fields]) =>
    Object.entries(fields).every(
      ([field, value]) => (given![effect] as Record<string, unknown>)[field] === value,
    ),
  );
}
