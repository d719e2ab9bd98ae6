/** The tools for the hand, at the viewport's left edge. */
import { t } from '../language/language.ts';
import type { Session } from '../session.ts';
import type { EditorState } from '../state.ts';
import { h } from '../ui/dom.ts';
import { type IconName, icon } from '../ui/icons.ts';

interface Button {
  readonly action: string;
  readonly icon: IconName;
  readonly tip: string;
  readonly on: (state: EditorState) => boolean;
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
        tip: t('In steps of 0.1 m, 15° and 0.1; Ctrl does so, or not, for a moment'),
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
