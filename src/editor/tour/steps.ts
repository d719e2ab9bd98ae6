/** What the tour points at, in its order: real things, which can be tried while it is there. */
import { t } from '../language/language.ts';
import type { Session } from '../session.ts';

export interface TourStep {
  readonly title: string;
  readonly text: string;
  /** The first of them that is seen is pointed at; the step is left out if none is. */
  readonly targets: readonly string[];
  /** Makes it be there. */
  prepare?(): void;
}

/** @param keys those of an action, to be read */
export function tourSteps({ store, state, actions }: Session): TourStep[] {
  const keys = (id: string) => actions.shortcut(id) ?? t('none');
  return [
    {
      title: t('The picture'),
      text: t(
        'Drag to go round what you see, turn the wheel or pinch to come nearer, drag with the right button or two fingers to move along. A click selects.',
      ),
      targets: ['.viewport > canvas'],
    },
    {
      title: t('What is in the scene'),
      text: t(
        'Lights, objects and materials. Choose one, and its properties are at hand; Add has more of them.',
      ),
      targets: ['.panel-left', '.sheet-tab:nth-child(2)'],
    },
    {
      title: t('A slider'),
      text: t(
        'Every parameter of the material’s formula has one. The picture follows at once; a double click on its name brings back the default, and every change can be undone.',
      ),
      targets: ['.panel-right .row:has(.slider)', '.panel-right', '.sheet-tab:nth-child(3)'],
      prepare() {
        const [object] = Object.values(store.document.objects).filter(({ visible }) => visible);
        if (object && state.value.selection?.kind !== 'materials')
          state.select({ kind: 'materials', id: object.material });
      },
    },
    {
      title: t('One term of the formula'),
      text: t(
        'Look at a single term alone, such as the distribution of the microfacets or the Fresnel reflectance.',
      ),
      targets: ['.term-select'],
    },
    {
      title: t('Path traced'),
      text: t(
        'The same scene with all light paths, as ground truth: alone, beside the interactive picture, or as a difference.',
      ),
      targets: ['.mode-switch'],
    },
    {
      title: t('The bench'),
      text: t(
        'Plots of the selected formula, and a verdict on its physics: reciprocity, energy, sampling. {keys} opens it.',
        {
          keys: keys('view.bench'),
        },
      ),
      targets: ['.topbar [data-keys="view.bench"]', '.sheet-tab:nth-child(4)'],
    },
    {
      title: t('Lessons'),
      text: t('From Lambert to microfacets, with scenes in which each formula can be tried.'),
      targets: ['.topbar [data-keys="learn.lessons"]'],
    },
    {
      title: t('Settings and help'),
      text: t('Theme, language, and this tour. {keys} lists all shortcuts, which you can change.', {
        keys: keys('help.shortcuts'),
      }),
      targets: ['.topbar .settings'],
    },
  ];
}
