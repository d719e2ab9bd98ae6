import { type BinaryTree, halfArea } from './binary-tree.ts';
import { LEAF, NODE_CHILDREN, NODE_SLOTS, NODE_WIDTH, NONE, WORDS_PER_SLOT } from './layout.ts';

/** A binary tree's nodes gathered into nodes of four, without what their leaves refer to. */
export interface WideTree {
  /** Four entries a node: a node of the binary tree, or -1. The root is the first. */
  readonly children: Int32Array;
  /** For each entry whose child is inner: the wide node that it became. */
  readonly nodes: Uint32Array;
  /** Entries that a traversal's stack can have at most: the siblings of the path to the deepest leaf. */
  readonly stack: number;
}

/**
 * Each node opens the child with the largest surface until it has four (I. Wald, C. Benthin and S. Boulos, 2008,
 * "Getting Rid of Packets", IEEE Symposium on Interactive Ray Tracing, section 3.2).
 */
export function widen(tree: BinaryTree): WideTree {
  const isInner = (node: number): boolean => tree.count[node] === 0;
  // A wide node takes the place of at least one inner node of the binary tree, of which there are (nodes - 1) / 2.
  const most = Math.max(1, (tree.nodes - 1) / 2);
  const children = new Int32Array(NODE_WIDTH * most).fill(-1);
  const wide = new Uint32Array(NODE_WIDTH * most);
  let [length, stack] = [1, 0];
  const pending: [binary: number, node: number, waiting: number][] = tree.nodes > 0 ? [[0, 0, 0]] : [];
  for (let next = pending.pop(); next !== undefined; next = pending.pop()) {
    const [binary, node, waiting] = next;
    const gathered =
      tree.nodes > 1 ? [tree.first[binary] as number, (tree.first[binary] as number) + 1] : [0];
    while (gathered.length < NODE_WIDTH) {
      let [largest, area] = [-1, -1];
      for (let i = 0; i < gathered.length; i += 1) {
        const child = gathered[i] as number;
        const own = halfArea(tree.boxes, 6 * child);
        if (isInner(child) && own > area) [largest, area] = [i, own];
      }
      if (largest < 0) break;
      const first = tree.first[gathered[largest] as number] as number;
      gathered.splice(largest, 1, first, first + 1);
    }
    const deep = waiting + gathered.length - 1;
    stack = Math.max(stack, deep);
    for (let i = 0; i < gathered.length; i += 1) {
      const child = gathered[i] as number;
      children[NODE_WIDTH * node + i] = child;
      if (!isInner(child)) continue;
      wide[NODE_WIDTH * node + i] = length;
      pending.push([child, length, deep]);
      length += 1;
    }
  }
  const entries = NODE_WIDTH * length;
  return { children: children.subarray(0, entries), nodes: wide.subarray(0, entries), stack: stack + 1 };
}

/**
 * Writes the nodes at the word `at`.
 *
 * @param slot the slot to which children are counted, that of the first node
 * @param leafReference what a leaf's reference is, without the leaf's bit
 */
export function writeNodes(
  words: Uint32Array<ArrayBuffer>,
  at: number,
  slot: number,
  tree: BinaryTree,
  wide: WideTree,
  leafReference: (leaf: number) => number,
): void {
  const floats = new Float32Array(words.buffer, words.byteOffset, words.length);
  for (let entry = 0; entry < wide.children.length; entry += 1) {
    const child = wide.children[entry] as number;
    const node = at + Math.floor(entry / NODE_WIDTH) * NODE_SLOTS * WORDS_PER_SLOT;
    const lane = entry % NODE_WIDTH;
    for (let axis = 0; axis < 3; axis += 1) {
      const min = node + 2 * axis * WORDS_PER_SLOT + lane;
      floats[min] = child < 0 ? Number.POSITIVE_INFINITY : (tree.boxes[6 * child + axis] as number);
      floats[min + WORDS_PER_SLOT] =
        child < 0 ? Number.NEGATIVE_INFINITY : (tree.boxes[6 * child + axis + 3] as number);
    }
    const reference =
      child < 0
        ? NONE
        : tree.count[child] === 0
          ? slot + (wide.nodes[entry] as number) * NODE_SLOTS
          : (LEAF | leafReference(child)) >>> 0;
    words[node + NODE_CHILDREN * WORDS_PER_SLOT + lane] = reference;
  }
}

/** Adds `slots` to the references of `nodes` nodes at the word `at`, whose leaves refer to slots, too. */
export function moveNodes(words: Uint32Array, at: number, nodes: number, slots: number): void {
  for (let node = 0; node < nodes; node += 1) {
    const children = at + (node * NODE_SLOTS + NODE_CHILDREN) * WORDS_PER_SLOT;
    for (let lane = 0; lane < NODE_WIDTH; lane += 1) {
      const reference = words[children + lane] as number;
      if (reference !== NONE) words[children + lane] = reference + slots;
    }
  }
}
