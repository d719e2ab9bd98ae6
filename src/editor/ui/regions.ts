/** The regions of the page, in the order in which the keyboard goes round them. */
import { tabStops } from './focus.ts';

const REGIONS = [
  ...['.topbar', '.lesson-panel', '.panel-left', '.viewport', '.bench'],
  ...['.library', '.source', '.panel-right', '.status', '.sheet-tabs'],
];

/** What had the focus when a region was left. */
const left = new WeakMap<Element, HTMLElement>();

/** Puts the focus into the next region that is shown, where it last was in it, or on its first control. */
export function focusRegion(step: 1 | -1): void {
  const regions = REGIONS.map((selector) => document.querySelector<HTMLElement>(`#app > ${selector}`)).filter(
    (region) => region?.checkVisibility() ?? false,
  ) as HTMLElement[];
  const active = document.activeElement;
  const at = regions.findIndex((region) => region.contains(active));
  const present = regions[at];
  if (present && active instanceof HTMLElement) left.set(present, active);
  const start = at < 0 ? (step === 1 ? -1 : 0) : at;
  const next = regions[(start + step + regions.length) % regions.length];
  if (!next) return;
  const before = left.get(next);
  const target = before?.isConnected && next.contains(before) ? before : tabStops(next)[0];
  target?.focus();
}
