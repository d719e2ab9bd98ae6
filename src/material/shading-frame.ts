import {
  attribute,
  cross,
  dot,
  float,
  If,
  normalView,
  positionView,
  tangentView,
  uniform,
  vec3,
} from 'three/tsl';
import {
  type BufferGeometry,
  type Camera,
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
  const { camera } = builder as unknown as { camera: Camera };
  // Not positionViewDirection, which is one more varying: where triangles are small, those are dear.
  const isOrthographic = (camera as Partial<OrthographicCamera>).isOrthographicCamera === true;
  const seen = (isOrthographic ? vec3(0, 0, 1) : (positionView as Vec3).negate().normalize()).toVar() as Vec3;
  const lift = float(LEAST_COSINE).sub(dot(N, seen)).max(0);
  // Hardly longer than 1 where it is lifted at all: normalising it again would cost every fragment.
  const V = seen.add(N.mul(lift)).toVar('brdfV') as Vec3;
  const X = anyTangent(N).toVar('brdfX') as Vec3;
  const Y = cross(N, X).toVar('brdfY') as unknown as Vec3;
  if (dependsOnTangent(model)) {
    const { geometry } = builder as unknown as { geometry: BufferGeometry };
    // Most materials are isotropic at most times: they need not pay for the others.
    If(tangentMatters.greaterThan(0.5), () => {
      const hasTangents = geometry.hasAttribute('tangent');
      X.assign(orthogonalTangent(N, hasTangents ? (tangentView as Vec3) : aroundAxis(N), X));
      // Mirrored texture coordinates turn the bitangent around.
      const handedness = hasTangents
        ? (attribute('tangent', 'vec4') as Node<'vec4'>).w.toVarying('brdfHandedness')
        : float(1);
      Y.assign(cross(N, X).mul(handedness));
    });
  }
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

/** 1 where the material that is drawn is anisotropic; its mesh is given tangents, if it has none. */
const tangentMatters = uniform(0).onObjectUpdate(({ material, object }) => {
  const matters = (material as unknown as BrdfMaterial | null)?.dependsOnTangent() ?? true;
  if (matters && object) ensureTangents((object as unknown as Mesh).geometry);
  return Number(matters);
}) as unknown as Node<'float'>;

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

/** The part of T that is orthogonal to N, as a unit vector; X where there is none. */
const orthogonalTangent = glslFunction(`
  vec3 orthogonalTangent(vec3 N, vec3 T, vec3 X) {
    vec3 tangent = T - N * dot(N, T);
    float length2 = dot(tangent, tangent);
    return length2 > 1e-12 ? tangent * inversesqrt(length2) : X;
  }
`) as unknown as (N: Vec3, T: Vec3, X: Vec3) => Vec3;
