/** What can be added to the scene, and the scenes that ship. */
import { addLight, addObject } from '../../scene/commands.ts';
import { addableGeometries, geometryNames } from '../../scene/geometry-schema.ts';
import { lightDefaults, lightTypes } from '../../scene/light-schema.ts';
import { addMaterial } from '../../scene/material-commands.ts';
import { attempt } from '../commands.ts';
import { t, translate } from '../language/language.ts';
import type { Session } from '../session.ts';
import type { EntityKind } from '../state.ts';
import type { Action } from './action.ts';

export function addActions(session: Session): Action[] {
  const { store, state } = session;
  const action = (kind: EntityKind, type: string, name: string, add: () => string): Action => ({
    id: `add.${type}`,
    title: t('Add {what}', { what: translate(name).toLocaleLowerCase() }),
    run() {
      const id = attempt(t('Not added'), add);
      if (id) state.select({ kind, id });
    },
  });
  return [
    ...addableGeometries.map((type) =>
      action('objects', type, geometryNames[type], () =>
        addObject(store, type, undefined, translate(geometryNames[type])),
      ),
    ),
    ...lightTypes.map((type) =>
      action('lights', type, lightDefaults[type].name, () =>
        addLight(store, type, { name: translate(lightDefaults[type].name) }),
      ),
    ),
    action('materials', 'material', 'Material', () => addMaterial(store)),
    {
      id: 'add.menu',
      title: t('Add…'),
      keys: ['Shift+A'],
      run: () => session.hands()?.openAddMenu(),
    },
  ];
}

export function sceneActions(
  scenes: readonly { name: string; title: string }[],
  open: (name: string) => void,
): Action[] {
  return scenes.map(({ name, title }) => ({
    id: `scene.${name}`,
    title: t('Open the scene {title}', { title: translate(title) }),
    run: () => open(name),
  }));
}
