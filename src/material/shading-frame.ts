import {
  attribute,
  cross,
  dot,
  float,
  mix,
  negateOnBackSide,
  normalView,
  positionView,
  step,
  tangentLocal,
  tangentView,
  uniform,
  varying,
  vec3,
} from 'three/tsl';
import {
  type BufferGeometry,
  type Camera,
  InterpolationSamplingType,
  type Mesh,
  type Node,
  type NodeBuilder,
  type OrthographicCamera,
  Vector3,
} from 'three/webgpu';
import type { Model } from '../glsl/model.ts';
import { glslFunction } from '../glsl/tsl.ts';
import type { BrdfMaterial } from './brdf-material.ts';
import { dependsOnTangent } from './tangent-dependence.ts';
import { ensureTangents } from './tangents.ts';
import { directionToView, isOwnNormalMatrix } from './view-space.ts';

type Vec3 = Node<'vec3'>;
type Float = Node<'float'>;

/** The directions that a model is called with, in view space, but for L. */
export interface ShadingFrame {
  readonly V: Vec3;
  readonly N: Vec3;
  readonly X: Vec3;
  readonly Y: Vec3;
}

/**
 * Where interpolation or a normal map turns the normal away from the viewer, V is lifted to a cosine of 1e-4
 * above the horizon: the models are 0 below it, which would draw a black rim. Hardly longer than 1 where it is
 * lifted at all: normalising it again would cost every fragment.
 */
const lifted = glslFunction(`
  vec3 lifted(vec3 V, vec3 N) {
    return V + N * max(1e-4 - dot(N, V), 0.0);
  }
`) as unknown as (V: Vec3, N: Vec3) => Vec3;

/** The frame of the fragment that is being shaded. */
export function shadingFrame(builder: NodeBuilder, model: Model): ShadingFrame {
  const N = (normalView as Vec3).toVar('brdfN');
  const { camera } = builder as unknown as { camera: Camera };
  // Not positionViewDirection, which is one more varying: where triangles are small, those are dear.
  const isOrthographic = (camera as Partial<OrthographicCamera>).isOrthographicCamera === true;
  const seen = (isOrthographic ? vec3(0, 0, 1) : (positionView as Vec3).negate().normalize()).toVar() as Vec3;
  const V = lifted(seen, N).toVar('brdfV') as Vec3;
  if (!dependsOnTangent(model)) {
    const X = anyTangent(N).toVar('brdfX') as Vec3;
    return { V, N, X, Y: cross(N, X).toVar('brdfY') as unknown as Vec3 };
  }
  const { geometry } = builder as unknown as { geometry: BufferGeometry };
  const hasTangents = geometry.hasAttribute('tangent');
  const T = (hasTangents ? meshTangent(builder) : aroundAxis(N)).toVar() as Vec3;
  // Around the axis T is 0 at the poles; a mesh's own is as long as the object is scaled.
  const scale2 = hasTangents ? dot(T, T) : float(1);
  const least = scale2.mul(leastTangent) as Float;
  const X = orthogonalTangent(N, T, least, anyTangent(N)).toVar('brdfX') as Vec3;
  const bitangent = cross(N, X) as unknown as Vec3;
  const turned = () => mix(1, handedness(), step(leastTangent, 1));
  const Y = (hasTangents ? bitangent.mul(turned()) : bitangent).toVar('brdfY') as Vec3;
  return { V, N, X, Y };
}

/**
 * A tangent for meshes that have none and whose texture coordinates give none: around the object's y axis,
 * as lathes leave their marks.
 */
function aroundAxis(N: Vec3): Vec3 {
  return cross(objectAxis, N) as unknown as Vec3;
}

/** The object's y axis in view space. A uniform: a product of matrices would cost every fragment as much as a lobe. */
const objectAxis = uniform(new Vector3()).onObjectUpdate(({ object, camera }, { value }) =>
  object && camera
    ? value.setFromMatrixColumn(object.matrixWorld, 1).transformDirection(camera.matrixWorldInverse)
    : value,
) as unknown as Vec3;

/**
 * Beside its length squared, how much of a tangent must be orthogonal to the normal. Where the material that is drawn is
 * isotropic, more than there is: its samples shall not turn with the seams of texture coordinates. Where it is not, the mesh
 * is given tangents, if it has none.
 */
const leastTangent = uniform(0).onObjectUpdate(({ material, object }) => {
  const matters = (material as unknown as BrdfMaterial | null)?.dependsOnTangent() ?? true;
  if (matters && object) ensureTangents((object as unknown as Mesh).geometry);
  return matters ? 1e-12 : 2;
}) as unknown as Float;

/** The mesh's own tangent in view space, of any length. */
function meshTangent(builder: NodeBuilder): Vec3 {
  const { context } = builder as unknown as { context: object };
  if (!isOwnNormalMatrix(context)) return tangentView as Vec3;
  return negateOnBackSide(directionToView(tangentLocal as Vec3).toVarying('brdfTangent') as Vec3) as Vec3;
}

/** -1 where mirrored texture coordinates turn the bitangent around, else 1. */
function handedness(): Float {
  return varying((attribute('tangent', 'vec4') as Node<'vec4'>).w, 'brdfHandedness').setInterpolation(
    InterpolationSamplingType.FLAT,
  ) as unknown as Float;
}

/**
 * A unit vector orthogonal to N, without branches: T. Duff et al., 2017, "Building an Orthonormal Basis,
 * Revisited", JCGT 6(1), listing 3.
 */
const anyTangent = glslFunction(`
  vec3 anyTangent(vec3 N) {
    float s = N.z < 0.0 ? -1.0 : 1.0;
    float a = -1.0 / (s + N.z);
    return vec3(1.0 + s * N.x * N.x * a, s * N.x * N.y * a, -s * N.x);
  }
`) as unknown as (N: Vec3) => Vec3;

/** The part of T that is orthogonal to N, as a unit vector; X where its length squared is `least` or less. */
const orthogonalTangent = glslFunction(`
  vec3 orthogonalTangent(vec3 N, vec3 T, float least, vec3 X) {
    vec3 tangent = T - N * dot(N, T);
    float length2 = dot(tangent, tangent);
    return length2 > least ? tangent * inversesqrt(length2) : X;
  }
`) as unknown as (N: Vec3, T: Vec3, least: Float, X: Vec3) => Vec3;
