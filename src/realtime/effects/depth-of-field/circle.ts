/** Circles of confusion: how far the light of a point is spread by the lens. */
import { uniform } from 'three/tsl';
import type { Node } from 'three/webgpu';
import { focusDistance, lensRadius } from '../../../scene/lens.ts';
import type { Camera } from '../../../scene/schema.ts';
import type { FrameInputs } from '../../frame/inputs.ts';

type Float = Node<'float'>;

/** The largest radius, as a part of the whole picture's height: what is blurred more would need more samples than there are. */
export const MOST_RADIUS = 1 / 12;

export class CircleOfConfusion {
  readonly #inputs: FrameInputs;
  readonly #radius = uniform(0);
  readonly #focus = uniform(1);
  /** Corners of the aperture; 0 is round. */
  readonly corners = uniform(0);

  constructor(inputs: FrameInputs) {
    this.#inputs = inputs;
  }

  update(camera: Camera): void {
    this.#radius.value = lensRadius(camera);
    this.#focus.value = focusDistance(camera);
    this.corners.value = camera.apertureBlades < 3 ? 0 : camera.apertureBlades;
  }

  /**
   * The radius in pixels of the picture, below 0 before what is in focus: a lens of radius R throws a point at distance z
   * to places R (1/f - 1/z) apart, on a plane at distance 1, if f is in focus.
   */
  radius(depth: Float): Float {
    const { projection, near, far, size, part } = this.#inputs;
    // Linear in the depth, on both back ends; 0 where nothing is.
    const inverseDistance = depth
      .oneMinus()
      .div(near)
      .add(depth.div(far))
      .mul(depth.lessThan(1).select(1, 0));
    const pixels = (projection as unknown as { element(i: number): Node<'vec4'> })
      .element(1)
      .y.mul(size.y)
      .mul(0.5);
    const most = size.y.mul(MOST_RADIUS).div(part.w);
    const radius = this.#radius.mul(this.#focus.reciprocal().sub(inverseDistance)).mul(pixels);
    return radius.clamp(most.negate(), most) as Float;
  }
}
