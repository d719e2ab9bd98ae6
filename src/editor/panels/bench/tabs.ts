/** The views of the bench: one tab stop, arrow keys between them (WAI-ARIA tabs). */
import { h } from '../../ui/dom.ts';
import { type BenchView, views } from './settings.ts';

const TITLES: Readonly<Record<BenchView, { label: string; tip: string }>> = {
  polar: { label: 'Polar', tip: 'The plane of incidence from the side' },
  thetaL: { label: 'θl', tip: 'Over the angle of the light, in the plane of incidence' },
  thetaH: { label: 'θh', tip: 'Over the angle of the half vector: the highlight' },
  thetaD: { label: 'θd', tip: 'Over the difference angle: Fresnel, grazing light' },
  albedo: { label: 'Albedo', tip: 'The share of light that is reflected, over the angle of the viewer' },
  image: { label: 'Image', tip: 'All of θh and θd at once' },
};

export interface Tabs {
  readonly element: HTMLElement;
  show(view: BenchView): void;
}

export function createTabs(change: (view: BenchView) => void): Tabs {
  const buttons = views.map((view) => {
    const { label, tip } = TITLES[view];
    const button = h(
      'button',
      { type: 'button', role: 'tab', class: 'bench-tab', tip, 'aria-controls': 'bench-plot' },
      label,
    );
    button.dataset.view = view;
    button.addEventListener('click', () => change(view));
    return { view, button };
  });
  const element = h(
    'div',
    { class: 'bench-tabs', role: 'tablist', 'aria-label': 'Plot' },
    ...buttons.map(({ button }) => button),
  );
  element.addEventListener('keydown', (event) => {
    const direction = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!direction) return;
    event.preventDefault();
    const now = buttons.findIndex(({ button }) => button.getAttribute('aria-selected') === 'true');
    const next = buttons[(now + direction + buttons.length) % buttons.length];
    if (!next) return;
    change(next.view);
    next.button.focus();
  });
  return {
    element,
    show(current) {
      for (const { view, button } of buttons) {
        button.setAttribute('aria-selected', String(view === current));
        button.tabIndex = view === current ? 0 : -1;
      }
    },
  };
}
