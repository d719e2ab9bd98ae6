import {
  attribute,
  bitangentViewFrame,
  cross,
  dot,
  float,
  normalView,
  positionViewDirection,
  tangentView,
  tangentViewFrame,
} from 'three/tsl';
import type { Node, NodeBuilder } from 'three/webgpu';
import { createEvaluator, type Vector3 } from '../glsl/evaluator.ts';
import type { Model } from '../glsl/model.ts';
import { glslFunction } from '../glsl/tsl.ts';

type Vec3 = Node<'vec3'>;

/** The directions that a model is called with, in view space, but for L. */
export interface ShadingFrame {
  readonly V: Vec3;
  readonly N: Vec3;
  readonly X: Vec3;
  readonly Y: Vec3;
}

/**
 * Where interpolation or a normal map turns the normal away from the viewer, V is lifted to this cosine
 * above the horizon: the models are 0 below it, which would draw a black rim.
 */
const LEAST_COSINE = 1e-4;

/** The frame of the fragment that is being shaded. */
export function shadingFrame(builder: NodeBuilder, model: Model): ShadingFrame {
  const N = (normalView as Vec3).toVar('brdfN');
  const seen = positionViewDirection as Vec3;
  const lift = float(LEAST_COSINE).sub(dot(N, seen)).max(0);
  const V = seen.add(N.mul(lift)).normalize().toVar('brdfV') as Vec3;
  const X = (dependsOnTangent(model) ? surfaceTangent(builder, N) : anyTangent(N)).toVar('brdfX') as Vec3;
  const Y = (dependsOnTangent(model) ? cross(N, X).mul(handedness(builder, N, X)) : cross(N, X)).toVar(
    'brdfY',
  ) as Vec3;
  return { V, N, X, Y };
}

/** The tangent made orthogonal to N: the mesh's own, else that of its texture coordinates, else any. */
function surfaceTangent(builder: NodeBuilder, N: Vec3): Vec3 {
  const { geometry } = builder as unknown as { geometry: { hasAttribute(name: string): boolean } };
  const hasTangent = geometry.hasAttribute('tangent');
  if (!hasTangent && !geometry.hasAttribute('uv')) return anyTangent(N);
  return orthogonalTangent(N, (hasTangent ? tangentView : tangentViewFrame) as Vec3);
}

/** +1 or -1: mirrored texture coordinates turn the bitangent around. */
function handedness(builder: NodeBuilder, N: Vec3, X: Vec3): Node<'float'> {
  const { geometry } = builder as unknown as { geometry: { hasAttribute(name: string): boolean } };
  if (geometry.hasAttribute('tangent')) return (attribute('tangent', 'vec4') as Node<'vec4'>).w;
  if (!geometry.hasAttribute('uv')) return float(1);
  return dot(cross(N, X), bitangentViewFrame as Vec3)
    .lessThan(0)
    .select(float(-1), float(1)) as Node<'float'>;
}

/**
 * A unit vector orthogonal to N, without branches: T. Duff et al., 2017, "Building an Orthonormal Basis,
 * Revisited", JCGT 6(1), listing 3.
 */
const ANY_TANGENT = `
  vec3 anyTangent(vec3 N) {
    float s = N.z < 0.0 ? -1.0 : 1.0;
    float a = -1.0 / (s + N.z);
    return vec3(1.0 + s * N.x * N.x * a, s * N.x * N.y * a, -s * N.x);
  }
`;
const anyTangent = glslFunction(ANY_TANGENT) as unknown as (N: Vec3) => Vec3;

/** The part of a tangent that is orthogonal to N, as a unit vector; any, where there is none. */
const orthogonalTangent = glslFunction(`
  ${ANY_TANGENT}
  vec3 orthogonalTangent(vec3 N, vec3 T) {
    vec3 tangent = T - N * dot(N, T);
    float length2 = dot(tangent, tangent);
    // Where texture coordinates do not vary there is no tangent.
    if (!(length2 > 1e-12)) return anyTangent(N);
    return tangent * inversesqrt(length2);
  }
`) as unknown as (N: Vec3, T: Vec3) => Vec3;

const tangentDependence = new WeakMap<Model, boolean>();

/**
 * Whether turning the tangent about N changes what the model reflects: only then does it need tangents of
 * the mesh. Decided by evaluating it at fixed directions with random parameters, since a model may well
 * read X and Y without depending on how they are turned.
 */
export function dependsOnTangent(model: Model): boolean {
  const known = tangentDependence.get(model);
  if (known !== undefined) return known;
  let seed = 1;
  const random = () => {
    // Numerical Recipes' linear congruential generator: any will do, as long as it is the same each time.
    seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
    return seed / 2 ** 32;
  };
  const evaluator = createEvaluator(model);
  const turned = { N: [0, 0, 1], X: [0.6, 0.8, 0], Y: [-0.8, 0.6, 0] } as const;
  let depends = false;
  for (let i = 0; i < 64 && !depends; i++) {
    evaluator.set(
      Object.fromEntries(
        model.parameters.map((p) => [
          p.name,
          p.type === 'float'
            ? p.min + (p.max - p.min) * random()
            : p.type === 'bool'
              ? random() < 0.5
              : [random(), random(), random()],
        ]),
      ),
    );
    const direction = (): Vector3 => {
      const [z, phi] = [0.2 + 0.8 * random(), 2 * Math.PI * random()];
      const r = Math.sqrt(1 - z * z);
      return [r * Math.cos(phi), r * Math.sin(phi), z];
    };
    const [L, V] = [direction(), direction()];
    for (const term of model.terms) {
      const a = evaluator.f(L, V, undefined, term);
      const b = evaluator.f(L, V, turned, term);
      if (a.some((x, k) => Math.abs(x - (b[k] as number)) > 1e-6 * Math.max(Math.abs(x), 1e-3)))
        depends = true;
    }
  }
  tangentDependence.set(model, depends);
  return depends;
}
