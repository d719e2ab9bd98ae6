/**
 * Which nodes of a file become groups of the document (docs/editing.md, "What comes from files"): those under which several
 * things are. Nodes that only hold another one, that hold nothing, and joints of skeletons are passed through.
 */
import type { Notes } from './notes.ts';

/** A group to be, named as in the file. */
export interface ImportedGroup {
  name: string;
  /** Its place in the list, before this one's; null where it is in none. */
  parent: number | null;
}

export interface TreeNode {
  name: string;
  /** Its place in the list, before this one's. */
  parent: number | null;
  /** How many surfaces and lights the node itself has. */
  own: number;
  /** `always`: Irradia wrote it for a group; `never`: a joint. */
  group: 'always' | 'never' | 'if several';
}

export interface Grouping {
  groups: ImportedGroup[];
  /** Of each node, the group that its own surfaces and lights are in. */
  groupOf: (number | null)[];
}

/** More would be no help to anybody, and what asks how deep a thing is would take long. */
const DEEPEST = 32;
/** Half of what a document has room for. */
const MOST_GROUPS = 2048;

/** Names that programs give the root of any file; the file's own says more. */
const ROOT_NAMES = new Set([
  ...['', 'Scene', 'AuxScene', 'root', 'Root', 'RootNode', 'Group', 'Object3D', 'World'],
  ...['Sketchfab_model', 'GLTF_SceneRootNode', 'Collada visual scene group'],
]);

/** @param title the group around all of the file, if there are several things in it; null for none */
export function groupNodes(nodes: readonly TreeNode[], title: string | null, notes: Notes): Grouping {
  /** What a node hands up to the one that it is in: groups, surfaces and lights. */
  const inside = nodes.map(({ own }) => own);
  let top = 0;
  const isGroup = nodes.map(() => false);
  for (let i = nodes.length - 1; i >= 0; i--) {
    const { parent, group } = nodes[i]!;
    const count = inside[i]!;
    isGroup[i] = group !== 'never' && count > (group === 'always' ? 0 : 1);
    const handed = isGroup[i] ? 1 : count;
    if (parent === null) top += handed;
    else inside[parent]! += handed;
  }
  const groups: ImportedGroup[] = [];
  const whole = title !== null && top > 1 ? groups.push({ name: title, parent: null }) - 1 : null;
  const deepest = depthFor(nodes, isGroup, whole === null ? 0 : 1, notes);
  const groupOf: (number | null)[] = [];
  const depths: number[] = [];
  for (const [i, { name, parent, group }] of nodes.entries()) {
    const around = parent === null ? whole : groupOf[parent]!;
    const depth = parent === null ? (whole === null ? 0 : 1) : depths[parent]!;
    const isOwn = isGroup[i]! && depth < deepest;
    const isRoot = around === null && top === 1 && group !== 'always' && ROOT_NAMES.has(name);
    const called = (isRoot && title) || name || 'Group';
    groupOf.push(isOwn ? groups.push({ name: called, parent: around }) - 1 : around);
    depths.push(isOwn ? depth + 1 : depth);
  }
  return { groups, groupOf };
}

/** How deep groups may be in one another so that there are not too many. */
function depthFor(
  nodes: readonly TreeNode[],
  isGroup: readonly boolean[],
  around: number,
  notes: Notes,
): number {
  /** How many groups are how deep. */
  const counts: number[] = [];
  const depths: number[] = [];
  for (const [i, { parent }] of nodes.entries()) {
    const depth = (parent === null ? around : depths[parent]!) + (isGroup[i] ? 1 : 0);
    depths.push(depth);
    if (isGroup[i]) counts[depth] = (counts[depth] ?? 0) + 1;
  }
  let [depth, sum] = [0, 0];
  while (depth < counts.length - 1 && depth < DEEPEST) {
    sum += counts[depth + 1] ?? 0;
    if (sum > MOST_GROUPS) break;
    depth += 1;
  }
  const last = counts.length - 1;
  if (depth < last)
    notes.add(`its groups are ${last} deep: those deeper than ${depth} are not kept, what is in them is`);
  return depth;
}
