import type { AnalyticLightNode, Light, Node, NodeBuilder } from 'three/webgpu';

/** From the shaded point to a light, in view space: the unit direction l and 1/r. */
export function lightVector<T extends Light>(
  node: AnalyticLightNode<T>,
  builder: NodeBuilder,
): { lightDirection: Node<'vec3'>; inverseDistance: Node<'float'> } {
  const vector = (node.getLightVector(builder) as Node<'vec3'>).toVar();
  const inverseDistance = vector.dot(vector).inverseSqrt().toVar();
  return { lightDirection: vector.mul(inverseDistance), inverseDistance };
}

/** A light's colour times its intensity; @types/three leaves the field out. */
export function lightColor<T extends Light>(node: AnalyticLightNode<T>): Node<'vec3'> {
  return (node as unknown as { colorNode: Node<'vec3'> }).colorNode;
}
