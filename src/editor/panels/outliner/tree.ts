/** What the outliner shows, as plain rows: the scene, the groups with what is in them, then the rest by kind. */
import type { EntityKind } from '../../../scene/entity.ts';
import { geometryNames } from '../../../scene/geometry-schema.ts';
import { lightDefaults } from '../../../scene/light-schema.ts';
import { contentsOf } from '../../../scene/order.ts';
import type { Document } from '../../../scene/schema.ts';
import { t, translate } from '../../language/language.ts';
import type { Entity } from '../../state.ts';
import { type IconName, isIcon } from '../../ui/icons.ts';
import { plain } from '../palette/fuzzy.ts';

/** What a row stands for. */
export type RowTarget =
  | { readonly type: 'scene' }
  | { readonly type: 'section'; readonly kind: EntityKind | 'groups' }
  | { readonly type: 'group'; readonly id: string }
  | { readonly type: 'entity'; readonly entity: Entity };

export interface TreeRow {
  /** Of what it stands for; no other row has it. */
  readonly key: string;
  readonly target: RowTarget;
  readonly name: string;
  readonly icon: IconName | null;
  /** From 1. */
  readonly level: number;
  /** Its place among the rows of the same parent, from 1, and their number. */
  position: number;
  siblings: number;
  /** Null for what has nothing in it. */
  readonly expanded: boolean | null;
  /** Null for what cannot be hidden or locked, or has nothing in it that could. */
  readonly visible: boolean | null;
  readonly locked: boolean | null;
  /** How many rows are in a section; null for the others. */
  readonly count: number | null;
}

export interface TreeOptions {
  /** Keys of the rows that are folded. */
  readonly folded: ReadonlySet<string>;
  /** Words that what is shown has in its name or kind; nothing is folded then. */
  readonly query: string;
}

const SECTIONS: readonly { kind: EntityKind; title: string }[] = [
  { kind: 'lights', title: t('Lights') },
  { kind: 'objects', title: t('Objects') },
  { kind: 'materials', title: t('Materials') },
];

export const entityKey = ({ kind, id }: Entity): string => `${kind}/${id}`;
export const groupKey = (id: string): string => `groups/${id}`;
export const sectionKey = (kind: EntityKind | 'groups'): string => `section/${kind}`;

interface Item {
  readonly row: TreeRow;
  readonly children: readonly Item[];
}

export function treeRows(document: Document, { folded, query }: TreeOptions): TreeRow[] {
  const words = plain(query).split(/\s+/).filter(Boolean);
  const contents = contentsOf(document);
  const searching = words.length > 0;
  const isFolded = (key: string) => !searching && folded.has(key);
  const matches = (...texts: string[]) => {
    const text = plain(texts.join(' '));
    return words.every((word) => text.includes(word));
  };

  const entityItem = (entity: Entity, level: number, all: boolean): Item | null => {
    const { kind, id } = entity;
    const found = document[kind][id];
    if (!found) return null;
    const { visible, locked } = 'visible' in found ? found : { visible: null, locked: null };
    const isFound = () => {
      const state = [visible === false ? t('hidden') : '', locked ? t('locked') : ''];
      return matches(found.name, ...kindWords(document, entity), ...state);
    };
    if (!all && !isFound()) return null;
    const icon = iconOf(document, entity);
    const target = { type: 'entity', entity } as const;
    return item({ key: entityKey(entity), target, name: found.name, icon, level, visible, locked });
  };
  const groupItem = (id: string, level: number, all: boolean): Item | null => {
    const group = document.groups[id];
    const inside = contents.get(id);
    if (!group || !inside) return null;
    const name = group.name;
    const shown = all || matches(name, t('group'));
    const children = [
      ...inside.groups.map((child) => groupItem(child, level + 1, shown)),
      ...inside.members.map((member) => entityItem(member, level + 1, shown)),
    ].filter((child) => child !== null);
    if (children.length === 0 && !shown) return null;
    const all_ = (field: 'visible' | 'locked', value: boolean) =>
      children.every(({ row }) => row[field] === null || row[field] === value);
    const key = groupKey(id);
    return item(
      {
        key,
        target: { type: 'group', id },
        name,
        icon: 'folder',
        level,
        expanded: children.length > 0 ? !isFolded(key) : null,
        visible: children.length > 0 ? !all_('visible', false) : null,
        locked: children.length > 0 ? all_('locked', true) : null,
      },
      children,
    );
  };
  const sectionItem = (kind: EntityKind | 'groups', title: string, children: (Item | null)[]): Item => {
    const there = children.filter((child) => child !== null);
    const key = sectionKey(kind);
    const target = { type: 'section', kind } as const;
    const expanded = !isFolded(key);
    return item({ key, target, name: title, icon: null, level: 1, expanded, count: there.length }, there);
  };

  const top = contents.get(null) ?? { groups: [], members: [] };
  const loose = (kind: EntityKind): readonly Entity[] =>
    kind === 'materials'
      ? Object.keys(document.materials).map((id) => ({ kind, id }))
      : top.members.filter((member) => member.kind === kind);
  const sections = SECTIONS.map(({ kind, title }) =>
    sectionItem(
      kind,
      title,
      loose(kind).map((entity) => entityItem(entity, 2, !searching)),
    ),
  );
  if (top.groups.length > 0)
    sections.unshift(
      sectionItem(
        'groups',
        t('Groups'),
        top.groups.map((id) => groupItem(id, 2, !searching)),
      ),
    );
  const scene = item({ key: 'scene', target: { type: 'scene' }, name: t('Scene'), icon: 'scene', level: 1 });
  const rows: TreeRow[] = [];
  flatten(searching ? sections.filter(({ children }) => children.length > 0) : [scene, ...sections], rows);
  return rows;
}

function item(
  row: Partial<TreeRow> & Pick<TreeRow, 'key' | 'target' | 'name' | 'icon' | 'level'>,
  children: readonly Item[] = [],
): Item {
  const nothing = { position: 1, siblings: 1, expanded: null, visible: null, locked: null, count: null };
  return { row: { ...nothing, ...row }, children };
}

function flatten(items: readonly Item[], into: TreeRow[]): void {
  items.forEach(({ row, children }, i) => {
    row.position = i + 1;
    row.siblings = items.length;
    into.push(row);
    if (row.expanded) flatten(children, into);
  });
}

/** The symbol of what it is. */
export function iconOf(document: Document, { kind, id }: Entity): IconName {
  if (kind === 'materials') return 'material';
  if (kind === 'lights') return document.lights[id]?.type ?? 'point';
  const type = document.objects[id]?.geometry.type ?? 'gltf';
  return isIcon(type) ? type : 'mesh';
}

/** The words by which it is found; the last of them says most. */
export function kindWords(document: Document, { kind, id }: Entity): readonly [general: string, own: string] {
  if (kind === 'materials') return [t('material'), document.materials[id]?.model ?? ''];
  if (kind === 'lights')
    return [t('light'), inWords(lightDefaults[document.lights[id]?.type ?? 'point'].name)];
  return [t('object'), inWords(geometryNames[document.objects[id]?.geometry.type ?? 'gltf'])];
}

/** There are few kinds and thousands of things; a translation is looked up once. */
const translated = new Map<string, string>();

function inWords(english: string): string {
  const text = translated.get(english) ?? translate(english);
  translated.set(english, text);
  return text;
}
