/** Groups of a document as nodes of a glTF file: with children, and where the world is, for what is in them is placed in it. */
import { entity, memberKinds } from '../../scene/entity.ts';
import { groupsAround, keyOf } from '../../scene/groups.ts';
import type { Document } from '../../scene/schema.ts';
import { OUR_GROUP } from '../gltf/schema.ts';
import type { GltfWriter } from '../gltf/writer.ts';

/** The nodes of what has been written, by keyOf(). */
export type NodeOf = Map<string, number>;

/** Groups in which nothing was written have no node. */
export function exportGroups(document: Document, writer: GltfWriter, nodes: NodeOf): void {
  const members = new Map<string, number[]>();
  const inside = new Map<string, number[]>();
  const put = (into: Map<string, number[]>, group: string | null, node: number | undefined): void => {
    if (group === null || node === undefined) return;
    const others = into.get(group);
    if (others) others.push(node);
    else into.set(group, [node]);
  };
  for (const kind of memberKinds)
    for (const [id, { group }] of Object.entries<{ group: string | null }>(document[kind]))
      put(members, group, nodes.get(keyOf({ kind, id })));
  // From within: a node is known before the one that it is in. Those of one depth keep their order.
  const depths = Object.keys(document.groups).map(
    (id) => [id, [...groupsAround(document.groups, id)].length] as const,
  );
  for (const [id] of depths.toSorted(([, a], [, b]) => b - a)) {
    const { name, parent } = entity(document, 'groups', id);
    const children = [...(inside.get(id) ?? []), ...(members.get(id) ?? [])];
    if (children.length > 0) put(inside, parent, writer.add('nodes', { name, children, extras: OUR_GROUP }));
  }
}
