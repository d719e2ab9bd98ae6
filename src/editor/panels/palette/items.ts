/** What the command palette offers: everything that can be done, everything in the scene. */
import type { EntityKind } from '../../../scene/entity.ts';
import { membersOf } from '../../../scene/groups.ts';
import type { Action } from '../../actions/action.ts';
import { t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import type { Entity } from '../../state.ts';
import type { IconName } from '../../ui/icons.ts';
import { iconOf, kindWords } from '../outliner/tree.ts';
import { matchScore, plain } from './fuzzy.ts';

export interface PaletteItem {
  readonly title: string;
  /** What it is, in a word or two; found, too. */
  readonly kind: string;
  readonly icon: IconName | null;
  readonly shortcut?: string;
  /** It cannot be done now; who looks for it learns that there is such a thing, and its keys. */
  readonly disabled?: boolean;
  /** What is looked for, as plain() makes it. */
  readonly text: string;
  run(): void;
}

const SUBJECTS: Readonly<Record<string, string>> = {
  file: t('File'),
  edit: t('Edit'),
  view: t('View'),
  add: t('Add'),
  scene: t('Scenes'),
  material: t('Materials'),
  tool: t('In the viewport'),
  camera: t('In the viewport'),
  learn: t('Lessons'),
  help: t('Help'),
  page: t('Page'),
};

export function paletteItems({ actions, store, state, focusSelection }: Session): PaletteItem[] {
  const { document } = store;
  const ofAction = (action: Action): PaletteItem => {
    const subject = SUBJECTS[action.id.replace(/\..*/, '')] ?? '';
    const shortcut = actions.shortcut(action.id);
    return {
      title: action.title,
      kind: subject,
      icon: action.on?.() ? 'check' : null,
      ...(shortcut !== undefined && { shortcut }),
      disabled: action.enabled?.() === false,
      text: plain(`${action.title} ${subject}`),
      run: () => actions.run(action.id),
    };
  };
  const ofEntity = (entity: Entity, name: string): PaletteItem => {
    const [general, kind] = kindWords(document, entity);
    return {
      title: name,
      kind,
      icon: iconOf(document, entity),
      text: plain(`${name} ${general} ${kind}`),
      run() {
        state.select(entity);
        if (entity.kind !== 'materials') focusSelection();
      },
    };
  };
  const ofGroup = ([id, { name }]: [string, { name: string }]): PaletteItem => ({
    title: name,
    kind: t('group'),
    icon: 'folder',
    text: plain(`${name} ${t('group')}`),
    run() {
      state.selectAll(membersOf(document, id));
      focusSelection();
    },
  });
  const kinds: readonly EntityKind[] = ['objects', 'lights', 'materials'];
  return [
    ...actions.all.filter(({ id }) => id !== 'page.palette').map(ofAction),
    ...kinds.flatMap((kind) =>
      Object.entries<{ name: string }>(document[kind]).map(([id, { name }]) => ofEntity({ kind, id }, name)),
    ),
    ...Object.entries(document.groups).map(ofGroup),
  ];
}

/** What is found in the title alone comes first. */
const IN_TITLE = 12;

function scoreOf(typed: string, item: PaletteItem): number | null {
  const title = matchScore(typed, plain(item.title));
  return title === null ? matchScore(typed, item.text) : title + IN_TITLE;
}

/** The items that fit, the best first, what cannot be done last; where nothing was typed what can be done, in its order. */
export function findItems(items: readonly PaletteItem[], query: string, most: number): PaletteItem[] {
  const typed = plain(query.trim());
  if (typed === '') return items.filter(({ disabled }) => !disabled).slice(0, most);
  return items
    .map((item) => ({ item, score: scoreOf(typed, item) }))
    .filter((found): found is { item: PaletteItem; score: number } => found.score !== null)
    .sort((a, b) => Number(a.item.disabled ?? false) - Number(b.item.disabled ?? false) || b.score - a.score)
    .slice(0, most)
    .map(({ item }) => item);
}
