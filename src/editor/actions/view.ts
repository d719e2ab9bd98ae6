/** What is seen, and how. */
import { presetNames, presetOf } from '../../scene/effect-presets.ts';
import { toggleBench, toggleBenchPage, toggleHelpers } from '../commands.ts';
import { t } from '../language/language.ts';
import { choiceLabel } from '../panels/inspector/field.ts';
import { setPreset } from '../panels/inspector/preset.ts';
import type { Session } from '../session.ts';
import { type Rendering, renderings } from '../state.ts';
import { stepShown } from '../viewport/show.ts';
import type { Action } from './action.ts';

export function viewActions(session: Session): Action[] {
  const { store, state } = session;
  const titles: Record<Rendering, string> = {
    interactive: t('Show the interactive picture'),
    traced: t('Show the path traced picture'),
    split: t('Show both pictures side by side'),
    difference: t('Show how the pictures differ'),
  };
  return [
    { id: 'view.focus', title: t('Look at what is selected'), keys: ['F'], run: session.focusSelection },
    { id: 'view.pickFocus', title: t('Focus the lens'), keys: ['Shift+F'], run: session.pickFocus },
    { id: 'view.nextData', title: t('Show the next data'), keys: ['V'], run: () => stepShown(session, 1) },
    {
      id: 'view.previousData',
      title: t('Show the previous data'),
      keys: ['Shift+V'],
      run: () => stepShown(session, -1),
    },
    {
      id: 'view.helpers',
      title: t('Light helpers'),
      keys: ['H'],
      on: () => store.document.view.helpers,
      run: () => toggleHelpers(store),
    },
    {
      id: 'view.bench',
      title: t('BRDF bench'),
      keys: ['B'],
      on: () => state.value.benchOpen,
      run: () => toggleBench(state),
    },
    {
      id: 'view.benchPage',
      title: t('BRDF bench over the whole page'),
      keys: ['Shift+B'],
      on: () => state.value.benchOpen && state.value.benchPage,
      run: () => toggleBenchPage(state),
    },
    ...renderings.map(
      (rendering, i): Action => ({
        id: `view.${rendering}`,
        title: titles[rendering],
        keys: [`${i + 1}`],
        on: () => state.value.rendering === rendering,
        run: () => state.set({ rendering }),
      }),
    ),
    ...presetNames.map(
      (name): Action => ({
        id: `view.${name}Effects`,
        title: t('Effects: {preset}', { preset: choiceLabel(name) }),
        on: () => presetOf(store.document.effects) === name,
        run: () => void setPreset(session, name),
      }),
    ),
    {
      id: 'view.pauseTracing',
      title: t('Pause path tracing'),
      keys: ['P'],
      on: () => state.value.tracingPaused,
      run: () => state.set({ tracingPaused: !state.value.tracingPaused }),
    },
  ];
}
