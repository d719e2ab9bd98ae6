/** The preset of effects that a device draws without effort, from what a plain frame takes it. */
import { type PresetName, presetNames } from '../scene/effect-presets.ts';

/** What a frame may take, in ms: of the 16.7 of a screen with 60 pictures a second, the rest is the browser's. */
const BUDGET_MS = 10;

/** Frames by preset as multiples of the plain one; see docs/benchmarks.md, "Effects". */
const COST: Readonly<Record<PresetName, number>> = { low: 1, medium: 5, high: 10, ultra: 14 };

/** @param milliseconds that the GPU takes for a plain frame */
export function devicePreset(milliseconds: number): PresetName {
  const within = presetNames.filter((name) => milliseconds * COST[name] <= BUDGET_MS);
  return within.at(-1) ?? 'low';
}
