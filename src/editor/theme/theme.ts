/** Dark, light or as the system: colours are in style/tokens.css, the choice is kept in this browser. */
import { t } from '../language/language.ts';

export const themes = ['dark', 'light', 'system'] as const;
export type Theme = (typeof themes)[number];

/** Also in first-paint.js, which reads it before this. */
const STORAGE_KEY = 'irradia.theme';

const listeners = new Set<() => void>();
/** Colours as the browser computes them, until the theme changes. */
const computed = new Map<string, string>();
let probe: HTMLElement | null = null;

export function themeNames(): Readonly<Record<Theme, string>> {
  return { dark: t('Dark'), light: t('Light|theme'), system: t('As the system') };
}

export function chosenTheme(): Theme {
  return themes.find((theme) => theme === document.documentElement.dataset.theme) ?? 'dark';
}

export function chooseTheme(theme: Theme): void {
  document.documentElement.dataset.theme = theme;
  try {
    localStorage.setItem(STORAGE_KEY, theme);
  } catch {
    // Storage may be forbidden or full; the theme is then that of this visit.
  }
  changed();
}

/** Calls back whenever colours have changed, by the person or by the system. */
export function onThemeChange(listener: () => void): () => void {
  listeners.add(listener);
  return () => listeners.delete(listener);
}

/** A colour of the stylesheet, such as `var(--plot-grid)`, as a canvas takes it. Any other colour is itself. */
export function computedColor(color: string): string {
  if (!color.includes('var(')) return color;
  let known = computed.get(color);
  if (known === undefined) {
    if (!probe) {
      probe = document.createElement('span');
      probe.hidden = true;
      // A canvas has the page's own colours, also where a person has chosen colours for all texts.
      probe.style.forcedColorAdjust = 'none';
      document.body.append(probe);
    }
    probe.style.color = color;
    known = getComputedStyle(probe).color;
    computed.set(color, known);
  }
  return known;
}

/** The system's own change, which is seen only where it was chosen. */
export function followSystemTheme(): void {
  matchMedia('(prefers-color-scheme: light)').addEventListener('change', changed);
  changed();
}

function changed(): void {
  computed.clear();
  // The colour of a browser's frame on a phone, or of an installed window.
  document.querySelector('meta[name=theme-color]')?.setAttribute('content', computedColor('var(--bg-panel)'));
  for (const listener of [...listeners]) listener();
}
