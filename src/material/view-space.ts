/**
 * From an object's space to the camera's. three.js multiplies the matrices for every vertex, unless its renderer is set to
 * high precision; here the product is a uniform of the object. It is taken in float64, so that far from the origin
 * vertices stay where they are.
 */
import { mat3, positionLocal, uniform } from 'three/tsl';
import {
  type ArrayCamera,
  type Camera,
  Matrix3,
  Matrix4,
  type Node,
  type NodeBuilder,
  RenderObjectRefreshType,
  Vector3,
} from 'three/webgpu';
import { glslFunction } from '../glsl/tsl.ts';

type Vec3 = Node<'vec3'>;
type Mat3 = Node<'mat3'>;

const product = new Matrix4();

const turn = uniform(new Matrix3()).onObjectUpdate(({ object, camera }, { value }) =>
  object && camera
    ? value.setFromMatrix4(product.multiplyMatrices(camera.matrixWorldInverse, object.matrixWorld))
    : value,
) as unknown as Mat3;

const origin = uniform(new Vector3()).onObjectUpdate(({ object, camera }, { value }) =>
  object && camera
    ? value.setFromMatrixPosition(object.matrixWorld).applyMatrix4(camera.matrixWorldInverse)
    : value,
) as unknown as Vec3;

/** The columns of the matrix that turns normals: of the inverse transposed, but for its length, which nobody asks for. */
const [normalX, normalY, normalZ] = ['Y, Z', 'Z, X', 'X, Y'].map((other) =>
  glslFunction(`
    vec3 normalColumn(mat3 turn) {
      vec3 X = turn[0];
      vec3 Y = turn[1];
      vec3 Z = turn[2];
      return cross(${other}) * (dot(X, cross(Y, Z)) < 0.0 ? -1.0 : 1.0);
    }
  `),
) as unknown as [(turn: Mat3) => Vec3, (turn: Mat3) => Vec3, (turn: Mat3) => Vec3];

const turnOfNormals = mat3(normalX(turn), normalY(turn), normalZ(turn)) as unknown as Mat3;

/** What three.js takes for its own normal matrix. */
type NormalContext = { modelViewMatrix?: Node; modelNormalViewMatrix?: Node };

/** Whether there is one camera's space: an array of cameras, as for a headset, has one for each. */
export function hasOneView(builder: NodeBuilder): boolean {
  const { camera } = builder as unknown as { camera: Partial<ArrayCamera> };
  return !camera.isArrayCamera;
}

/** Has normals turned so, unless three.js does otherwise, too: for several cameras at once, and in high precision. */
export function useViewSpace(builder: NodeBuilder): void {
  const { context } = builder as unknown as { context: NormalContext };
  if (hasOneView(builder) && !context.modelViewMatrix) context.modelNormalViewMatrix = turnOfNormals;
}

export function isOwnNormalMatrix(context: NormalContext): boolean {
  return context.modelNormalViewMatrix === turnOfNormals;
}

/** A direction of the object's space, such as a tangent, in view space. */
export function directionToView(direction: Vec3): Vec3 {
  return turn.mul(direction) as unknown as Vec3;
}

/** The vertex in view space. */
export function positionInView(): Vec3 {
  return directionToView(positionLocal as Vec3).add(origin) as Vec3;
}

interface Observer {
  needsRefresh(renderObject: object, frame: object): number;
}

/** An observer of changes that sees the camera's, too: three.js' own takes it that no uniform of an object depends on it. */
export function seesCamera<T>(observer: T): T {
  const own = observer as Observer;
  const needsRefresh = own.needsRefresh.bind(observer);
  const views = new WeakMap<object, Matrix4>();
  own.needsRefresh = (renderObject, frame) => {
    const { camera } = renderObject as { camera: Camera };
    const view = views.get(renderObject);
    const hasMoved = !view?.equals(camera.matrixWorldInverse);
    if (hasMoved) views.set(renderObject, (view ?? new Matrix4()).copy(camera.matrixWorldInverse));
    const type = needsRefresh(renderObject, frame);
    return hasMoved ? RenderObjectRefreshType.FULL : type;
  };
  return observer;
}
