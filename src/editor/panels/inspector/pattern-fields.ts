/** What kind of pattern a texture is, and its numbers: rows made from the kind's own table. */
import { patternNames } from '../../../scene/pattern/asset.ts';
import { commonDefaults } from '../../../scene/pattern/kind.ts';
import {
  defaultPattern,
  kindOf,
  type Pattern,
  readPatternAsset,
  shapeOf,
} from '../../../scene/pattern/pattern.ts';
import { setPattern } from '../../../scene/pattern-commands.ts';
import type { Asset } from '../../../scene/schema.ts';
import { attempt } from '../../commands.ts';
import { t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { row, selectField } from '../../ui/fields.ts';
import type { Gesture } from '../../ui/gesture.ts';
import { type Bound, labelOf, shapeFields } from './field.ts';

/** @param assetId of the texture, as it is now */
export function patternFields({ store }: Session, id: string, assetId: () => string | undefined): Bound {
  let read: { readonly asset: Asset; readonly pattern: Pattern | null } | null = null;
  const pattern = (): Pattern | null => {
    const asset = store.document.assets[assetId() ?? ''];
    if (!asset) return null;
    if (read?.asset !== asset) read = { asset, pattern: tryRead(asset) };
    return read.pattern;
  };
  const change = (next: Pattern, label: string, gesture?: Gesture) => {
    const asset = assetId();
    if (asset !== undefined)
      attempt(t('That value is not possible'), () =>
        setPattern(store, id, asset, next, label, gesture && `pattern ${id} ${gesture}`),
      );
  };
  const choice = selectField(
    t('Pattern'),
    patternNames.map((value) => ({ value, label: labelOf(value) })),
    (value) => {
      const name = patternNames.find((known) => known === value);
      const now = pattern();
      if (!name) return;
      const { size, seed, color, relief } = now ?? { ...commonDefaults, color: [...commonDefaults.color] };
      change({ ...defaultPattern(name), size, seed, color, relief }, t('Change pattern'));
    },
  );
  const rows = h('div');
  const element = h('div', {}, row({ label: t('Pattern') }, choice.element), rows);
  let fields: Bound[] = [];
  let shown: string | undefined;
  const update = () => {
    const now = pattern();
    choice.show(now?.pattern ?? '');
    if (now?.pattern !== shown) {
      shown = now?.pattern;
      fields = now ? fieldsOf(now) : [];
      rows.replaceChildren(...fields.map((field) => field.element));
    }
    for (const field of fields) field.update();
  };
  const fieldsOf = ({ pattern: name }: Pattern): Bound[] =>
    shapeFields(shapeOf(name), {
      defaults: { ...commonDefaults, ...kindOf(name).defaults },
      cell: (field, label) => ({
        get: () => pattern()?.[field],
        set: (value, gesture) => {
          const now = pattern();
          if (now)
            change(
              { ...now, [field]: value } as Pattern,
              t('Change {label}', { label: label.toLowerCase() }),
              gesture && `${field} ${gesture}`,
            );
        },
      }),
    });
  update();
  return { element, update };
}

/** What cannot be read has no numbers to show; another kind may be chosen for it. */
function tryRead(asset: Asset): Pattern | null {
  try {
    return readPatternAsset(asset);
  } catch {
    return null;
  }
}
