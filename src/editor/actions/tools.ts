/** Working with the hands in the viewport. */
import { t } from '../language/language.ts';
import type { Session } from '../session.ts';
import type { Tool } from '../state.ts';
import type { Nudge } from '../viewport/hands.ts';
import type { AxisDirection } from '../viewport/navigation/view-axes.ts';
import type { Action } from './action.ts';

/** m: what an arrow key moves by, and with Shift. */
const NUDGE = [0.01, 0.1] as const;

export function toolActions(session: Session): Action[] {
  const { state } = session;
  const tool = (name: Tool, title: string, key: string): Action => ({
    id: `tool.${name}`,
    title,
    keys: [key],
    on: () => state.value.tool === name,
    run: () => state.set({ tool: name }),
  });
  const look = (name: string, title: string, keys: string[], direction: AxisDirection): Action => ({
    id: `view.${name}`,
    title,
    keys,
    run: () => session.hands()?.look(direction),
  });
  const somethingPlaced = () => state.value.selected.some(({ kind }) => kind !== 'materials');
  const nudge = (name: string, title: string, key: string, along: Nudge['along'], sign: 1 | -1) =>
    NUDGE.map(
      (by, i): Action => ({
        id: `tool.nudge${name}${i === 0 ? '' : 'Far'}`,
        title: i === 0 ? title : t('{action}, by more', { action: title }),
        keys: [i === 0 ? key : `Shift+${key}`],
        enabled: () => isViewportFocused() && somethingPlaced(),
        run: () => session.hands()?.nudge({ along, by: sign * by }),
      }),
    );
  return [
    tool('select', t('Select'), 'Q'),
    tool('box', t('Select by a box'), 'Shift+Q'),
    tool('move', t('Move'), 'W'),
    tool('rotate', t('Rotate'), 'E'),
    tool('scale', t('Scale'), 'R'),
    {
      id: 'tool.grab',
      title: t('Take hold of what is selected'),
      keys: ['G'],
      enabled: somethingPlaced,
      run: () => session.hands()?.grab(),
    },
    {
      id: 'tool.space',
      title: t('Along the object’s own axes'),
      keys: ['X'],
      on: () => state.value.space === 'local',
      run: () => state.set({ space: state.value.space === 'local' ? 'world' : 'local' }),
    },
    {
      id: 'tool.pivot',
      title: t('About what was selected last'),
      keys: ['.'],
      on: () => state.value.pivot === 'last',
      run: () => state.set({ pivot: state.value.pivot === 'last' ? 'middle' : 'last' }),
    },
    {
      id: 'tool.snap',
      title: t('In steps'),
      keys: ['Shift+S'],
      on: () => state.value.snap,
      run: () => state.set({ snap: !state.value.snap }),
    },
    {
      id: 'tool.steps',
      title: t('How large the steps are…'),
      run: () =>
        document
          .querySelector('[data-keys="tool.snap"]')
          ?.dispatchEvent(new MouseEvent('contextmenu', { cancelable: true })),
    },
    {
      id: 'tool.drop',
      title: t('Drop to what is below'),
      keys: ['End', 'D'],
      enabled: () => state.value.selected.some(({ kind }) => kind === 'objects'),
      run: () => session.hands()?.drop(),
    },
    ...nudge('Left', t('Move to the left'), 'ArrowLeft', 'right', -1),
    ...nudge('Right', t('Move to the right'), 'ArrowRight', 'right', 1),
    ...nudge('Up', t('Move up in the view'), 'ArrowUp', 'up', 1),
    ...nudge('Down', t('Move down in the view'), 'ArrowDown', 'up', -1),
    ...nudge('Away', t('Move away'), 'PageUp', 'away', 1),
    ...nudge('Near', t('Move nearer'), 'PageDown', 'away', -1),
    {
      id: 'view.frameAll',
      title: t('Look at everything'),
      keys: ['Home'],
      run: () => session.hands()?.frameAll(),
    },
    look('front', t('Look from the front'), ['Numpad1'], { axis: 'z', sign: 1 }),
    look('back', t('Look from behind'), ['Ctrl+Numpad1'], { axis: 'z', sign: -1 }),
    look('right', t('Look from the right'), ['Numpad3'], { axis: 'x', sign: 1 }),
    look('left', t('Look from the left'), ['Ctrl+Numpad3'], { axis: 'x', sign: -1 }),
    look('top', t('Look from above'), ['Numpad7'], { axis: 'y', sign: 1 }),
    look('bottom', t('Look from below'), ['Ctrl+Numpad7'], { axis: 'y', sign: -1 }),
    {
      id: 'view.otherSide',
      title: t('Look from the other side'),
      keys: ['Numpad9'],
      run: () => session.hands()?.lookFromOtherSide(),
    },
  ];
}

/** Arrow keys mean something else in lists, sliders and menus. */
export function isViewportFocused(): boolean {
  const { activeElement, body } = document;
  return (
    activeElement === null || activeElement === body || activeElement.closest('.viewport > canvas') !== null
  );
}
