/** An action as an entry of a menu. */
import type { IconName } from '../ui/icons.ts';
import type { MenuAction } from '../ui/menu.ts';
import type { Actions } from './action.ts';

export interface EntryLook {
  /** In place of the action's title. */
  readonly label?: string;
  readonly icon?: IconName;
  readonly tip?: string;
}

export function actionEntry(actions: Actions, id: string, look: EntryLook = {}): MenuAction {
  const { title, enabled } = actions.get(id);
  const shortcut = actions.shortcut(id);
  return {
    label: title,
    ...(shortcut !== undefined && { shortcut }),
    disabled: enabled?.() === false,
    run: () => actions.run(id),
    ...look,
  };
}
