/** The tools for the hand, at the viewport's left edge. */
import { t } from '../language/language.ts';
import type { Session } from '../session.ts';
import { type EditorState, type EditorStateStore, type Steps, stepChoices } from '../state.ts';
import { h } from '../ui/dom.ts';
import { type IconName, icon } from '../ui/icons.ts';
import { type MenuEntry, openMenu } from '../ui/menu.ts';

interface Button {
  readonly action: string;
  readonly icon: IconName;
  readonly tip: string;
  readonly on: (state: EditorState) => boolean;
}

/** How large the steps of drags are. */
function openStepsMenu(anchor: HTMLElement, state: EditorStateStore): void {
  const { steps } = state.value;
  const part = (name: keyof Steps, heading: string, unit: string): MenuEntry[] => [
    { heading },
    ...stepChoices[name].map((size) => ({
      label: `${size}${unit}`,
      checked: steps[name] === size,
      run: () => state.set({ steps: { ...steps, [name]: size } }),
    })),
  ];
  openMenu(anchor, t('Steps'), [
    ...part('move', t('Move'), ' m'),
    ...part('rotate', t('Rotate'), '°'),
    ...part('scale', t('Scale'), ''),
  ]);
}

export function createToolbar({ state, actions }: Session): HTMLElement {
  const groups: readonly (readonly Button[])[] = [
    [
      {
        action: 'tool.select',
        icon: 'cursor',
        tip: t('Select: click; with Shift or Ctrl beside what is selected, with Alt what is behind'),
        on: ({ tool }) => tool === 'select',
      },
      {
        action: 'tool.box',
        icon: 'boxSelect',
        tip: t('Select by a box: to the right what is within it, to the left what it touches'),
        on: ({ tool }) => tool === 'box',
      },
      { action: 'tool.move', icon: 'move', tip: t('Move'), on: ({ tool }) => tool === 'move' },
      { action: 'tool.rotate', icon: 'rotate', tip: t('Rotate'), on: ({ tool }) => tool === 'rotate' },
      { action: 'tool.scale', icon: 'scale', tip: t('Scale'), on: ({ tool }) => tool === 'scale' },
    ],
    [
      {
        action: 'tool.space',
        icon: 'local',
        tip: t('Along the axes of what is selected, not the world’s'),
        on: ({ space }) => space === 'local',
      },
      {
        action: 'tool.pivot',
        icon: 'pivot',
        tip: t('About what was selected last, not about the middle of all'),
        on: ({ pivot }) => pivot === 'last',
      },
      {
        action: 'tool.snap',
        icon: 'magnet',
        tip: t('In steps; Ctrl does so, or not, for a moment. The right button: how large they are'),
        on: ({ snap }) => snap,
      },
    ],
  ];
  const buttons = groups.flat().map(({ action, icon: name, tip, on }) => {
    const element = h(
      'button',
      {
        type: 'button',
        class: 'icon-button tool-button',
        tip,
        'data-keys': action,
        'aria-label': actions.get(action).title,
        on: { click: () => actions.run(action) },
      },
      icon(name),
    );
    return { action, element, on };
  });
  const magnet = buttons.find(({ action }) => action === 'tool.snap')?.element;
  magnet?.addEventListener('contextmenu', (event) => {
    event.preventDefault();
    openStepsMenu(magnet, state);
  });
  const show = () => {
    for (const { element, on } of buttons) element.setAttribute('aria-pressed', String(on(state.value)));
  };
  state.subscribe(show);
  show();
  return h(
    'div',
    { class: 'tool-bar', role: 'toolbar', 'aria-label': t('Tools'), 'aria-orientation': 'vertical' },
    ...groups.map((group) =>
      h(
        'div',
        { class: 'tool-group' },
        ...group.map(({ action }) => buttons.find((button) => button.action === action)?.element),
      ),
    ),
  );
}
