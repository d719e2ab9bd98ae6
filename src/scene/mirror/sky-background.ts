/** The sky behind the scene with the sun's disc in it, which no image of the sky has. */
import {
  backgroundIntensity,
  backgroundRotation,
  equirectUV,
  Fn,
  float,
  fwidth,
  mix,
  normalWorldGeometry,
  step,
  texture,
  uniform,
  vec2,
  vec3,
  vec4,
} from 'three/tsl';
import { DataTexture, type Node, type TextureNode, Vector3 } from 'three/webgpu';
import { SUN_ANGULAR_RADIUS } from '../sky/atmosphere.ts';
import { LIMB_POWERS, type Sun } from '../sky/sun.ts';

/** (2 - 2^-10) 2^15: what half floats hold. */
const BRIGHTEST_HALF = 65_504;

export class SkyBackground {
  readonly #image: TextureNode<'vec4'> = texture(new DataTexture());
  readonly #direction = uniform(new Vector3(0, 1, 0));
  /** Of the disc's middle, divided by what the background is multiplied by. */
  readonly #luminance = uniform(new Vector3());
  readonly #rows = uniform(1);
  readonly #node = this.#build();

  /** @param intensity by which the background is multiplied */
  show(image: DataTexture, sun: Sun | null, intensity: number): Node {
    this.#image.value = image;
    this.#rows.value = image.image.height;
    if (sun !== null) {
      this.#direction.value.set(...sun.direction);
      this.#luminance.value.set(...sun.luminance).divideScalar(intensity);
    } else this.#luminance.value.set(0, 0, 0);
    return this.#node;
  }

  dispose(): void {
    this.#node.dispose();
  }

  #build(): Node {
    const draw = Fn(() => {
      const direction = (normalWorldGeometry as Node<'vec3'>).normalize().toVar();
      const turned = (backgroundRotation as unknown as Node<'mat3'>).mul(
        direction,
      ) as unknown as Node<'vec3'>;
      // No mean of sky and ground at the horizon, which is sharp: each is read from its own rows.
      const place = equirectUV(turned).toVar();
      const half = float(0.5).div(this.#rows);
      const read = (v: Node<'float'>) => this.#image.sample(vec2(place.x, v)).level(float(0)).rgb;
      const above = float(0.5).add(
        direction.y.div((fwidth(direction.y) as unknown as Node<'float'>).max(1e-6)),
      );
      const sky = mix(
        read(place.y.min(float(0.5).sub(half)) as Node<'float'>),
        read(place.y.max(float(0.5).add(half)) as Node<'float'>),
        above.clamp(0, 1),
      );
      // The sine of the angle to the sun's middle over that of its edge: more exact than a cosine close to 1.
      const sine = direction.cross(this.#direction).length().div(Math.sin(SUN_ANGULAR_RADIUS)).toVar();
      const inside = float(0.5)
        .sub(sine.sub(1).div((fwidth(sine) as unknown as Node<'float'>).max(1e-6)))
        .clamp(0, 1);
      const ahead = step(float(0), direction.dot(this.#direction)).mul(step(float(0), direction.y));
      const mu = float(1).sub(sine.mul(sine)).max(1e-4).sqrt();
      const disc = this.#luminance.mul(mu.pow(vec3(...LIMB_POWERS))).mul(inside.mul(ahead));
      const most = float(BRIGHTEST_HALF).div((backgroundIntensity as unknown as Node<'float'>).max(1e-20));
      return vec4(sky.add(disc).min(most), 1);
    });
    return draw() as unknown as Node;
  }
}
