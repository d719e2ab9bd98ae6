/**
 * Fog as the path tracer has it, with the light that lamps send into it: of light that is scattered once. What lamps do not
 * see is dark, so that shafts of light stand in the air. Light from everywhere is taken to be as bright inside as outside:
 * what it loses to the fog on one way it gets back from all others (exact where nothing is absorbed; docs/effects.md).
 *
 * Ways through fog are exact, at full resolution; what lamps add is looked at along each pixel's ray at half of it, in the
 * part that a lamp can reach, and brought up by distance.
 */
import {
  Fn,
  float,
  If,
  int,
  ivec2,
  perspectiveDepthToViewZ,
  renderGroup,
  uniform,
  uv,
  vec2,
  vec3,
  vec4,
} from 'three/tsl';
import {
  DataTexture,
  FloatType,
  type Node,
  RedFormat,
  type RenderTarget,
  type Scene,
  Vector3,
  Vector4,
  type WebGPURenderer,
} from 'three/webgpu';
import type { Air } from '../../../material/air.ts';
import { keptFloat, keptVec3, repeat } from '../../../material/statements.ts';
import type { Effect, EffectDefinition, EffectSettings } from '../../frame/effect.ts';
import type { FrameInputs } from '../../frame/inputs.ts';
import { inputTexture, Pass } from '../../frame/pass.ts';
import { type Guide, NOTHING, positionAt, releaseGuide, takeGuide } from '../screen-space/guide.ts';
import { gradientNoise } from '../screen-space/noise.ts';
import { brought, smoothed } from './bring.ts';
import { dataTexture } from './data-texture.ts';
import { airSample, fogTransmittance, litWay, scattered } from './functions.ts';
import { AirLamps } from './lamps.ts';
import { boundingSphere } from './sphere.ts';
import { seesLamp } from './visibility.ts';

type Float = Node<'float'>;
type Int = Node<'int'>;
type Vec2 = Node<'vec2'>;
type Vec3 = Node<'vec3'>;
type Vec4 = Node<'vec4'>;

/** Beyond any scene, in metres. */
const FAR = 1e30;
/** Of the lit way: a lamp's light is not taken to be stronger than at this distance. */
const LEAST_DISTANCE = 1e-4;
/** Without shadows light varies so little that a part of the places is enough, */
const SMOOTH_SHARE = 0.25;
/** but no fewer. */
const LEAST_STEPS = 4;
/** The golden ratio's: frames' shifts of the noise fill 0..1 evenly. */
const TURN = (Math.sqrt(5) - 1) / 2;
/** A float that no picture has more of. */
const MOST = 3e38;

class FogEffect implements Effect {
  readonly context: { readonly air: Air };
  readonly #inputs: FrameInputs;
  readonly #guide: Guide;
  readonly #lamps = new AirLamps();
  /** Centre and radius. */
  readonly #sphere = uniform(new Vector4()).setGroup(renderGroup);
  /** Density, anisotropy, height, base. */
  readonly #fog = uniform(new Vector4()).setGroup(renderGroup);
  readonly #albedo = uniform(new Vector3());
  readonly #ambient = uniform(new Vector3());
  readonly #count = uniform(0);
  readonly #steps = uniform(1);
  readonly #turn = uniform(0);
  readonly #scene = inputTexture();
  readonly #rows = dataTexture();
  readonly #maps = { atlas: dataTexture(), rows: dataTexture() };
  readonly #none = new DataTexture(new Float32Array(1), 1, 1, RedFormat, FloatType);
  readonly #light: Pass;
  readonly #smoothed: Pass;
  readonly #result: Pass;
  #isTemporal = false;

  constructor(inputs: FrameInputs, scale: number) {
    this.#inputs = inputs;
    this.#guide = takeGuide(inputs, scale);
    this.#none.needsUpdate = true;
    this.context = {
      air: (from, direction, distance) =>
        fogTransmittance(this.#ball, this.#thickness, from, direction, distance),
    };
    this.#light = new Pass('fog light', this.#march());
    this.#smoothed = new Pass('fog light smoothed', smoothed(this.#guide, this.#light));
    this.#result = new Pass('fog', this.#compose());
  }

  update({ fog, effects }: EffectSettings): void {
    if (!fog) return;
    this.#fog.value.set(fog.density, fog.anisotropy, fog.height, fog.base);
    this.#albedo.value.fromArray(fog.color);
    this.#steps.value = effects.fog.steps;
    this.#isTemporal = effects.antialiasing.method === 'temporal';
  }

  beforeScene(three: WebGPURenderer, scene: Scene): void {
    scene.updateMatrixWorld();
    const { shadowMaps } = this.#inputs;
    boundingSphere(scene, this.#sphere.value);
    this.#lamps.update(scene, shadowMaps);
    this.#count.value = this.#lamps.count;
    const { r, g, b } = this.#lamps.ambient;
    this.#ambient.value.set(r, g, b);
    this.#rows.value = this.#lamps.texture;
    this.#maps.atlas.value = shadowMaps?.atlas ?? this.#none;
    this.#maps.rows.value = shadowMaps?.rows ?? this.#lamps.texture;
    this.#turn.value = this.#isTemporal ? (this.#inputs.frameIndex.value * TURN) % 1 : 0;
    this.#guide.render(three);
  }

  afterScene(renderer: WebGPURenderer, input: RenderTarget): RenderTarget {
    const { x, y } = this.#guide.size.value;
    this.#light.render(renderer, x, y);
    this.#smoothed.render(renderer, x, y);
    this.#scene.value = input.texture;
    return this.#result.render(renderer, input.width, input.height);
  }

  dispose(): void {
    releaseGuide(this.#inputs, this.#guide);
    this.#light.dispose();
    this.#smoothed.dispose();
    this.#result.dispose();
    this.#lamps.texture.dispose();
    this.#none.dispose();
  }

  get #ball(): Vec4 {
    return this.#sphere as unknown as Vec4;
  }

  get #thickness(): Vec4 {
    return this.#fog as unknown as Vec4;
  }

  /** The camera's ray through a place of the picture whose surface is at a distance along the view. */
  #ray(place: Vec2, distance: Float): { direction: Vec3; far: Float } {
    const ndc = place.mul(2).sub(1).mul(vec2(1, -1)) as Vec2;
    const toWorld = this.#inputs.viewInverse as unknown as { mul(v: Node): Vec4 };
    const way = toWorld.mul(vec4(positionAt(this.#inputs, ndc, float(1)), 0)).xyz.toVar() as Vec3;
    const isOpen = distance.greaterThanEqual(NOTHING);
    return {
      direction: keptVec3(way.normalize() as Vec3),
      far: keptFloat(isOpen.select(float(FAR), way.length().mul(distance)) as unknown as Float),
    };
  }

  /** What lamps add along each ray, at the guide's resolution. */
  #march(): Node {
    return Fn(() => {
      const place = this.#guide.texel(uv() as Vec2);
      const { direction: d, far } = this.#ray(place, this.#guide.sample(place).w as Float);
      const o = this.#inputs.cameraPosition as unknown as Vec3;
      const shift = gradientNoise((uv() as Vec2).mul(this.#guide.size).floor() as Vec2);
      const noise = keptFloat(shift.add(this.#turn).fract() as Float);
      const sum = vec3(0).toVar();
      repeat(this.#count as unknown as Float, (i) => {
        const texel = (k: number) => this.#rows.load(ivec2(int(k), int(i))) as unknown as Vec4;
        const lamp = texel(0).toVar() as Vec4;
        const power = texel(1).toVar() as Vec4;
        const axis = texel(2).toVar() as Vec4;
        const way = litWay(this.#ball, o, d, far, lamp, power.w as Float, axis).toVar() as Vec2;
        If(way.y.greaterThan(way.x), () => {
          const edge = texel(3).toVar() as Vec4;
          const width = texel(4).toVar() as Vec4;
          const height = texel(5).xyz.toVar() as Vec3;
          const row = width.w.toVar() as Float;
          const share = row.greaterThanEqual(0).select(float(1), float(SMOOTH_SHARE));
          const steps = this.#steps.mul(share).ceil().max(LEAST_STEPS).toVar() as unknown as Float;
          const least = way.y.sub(way.x).mul(LEAST_DISTANCE) as Float;
          const found = vec3(0).toVar();
          repeat(steps, (j) => {
            const u = j.add(noise).div(steps) as Float;
            const at = airSample(u, this.#ball, this.#thickness, o, d, way, lamp).toVar() as Vec2;
            const P = o.add(d.mul(at.x)).toVar() as Vec3;
            const light = scattered(
              P,
              d,
              this.#ball,
              this.#thickness,
              lamp,
              power,
              axis,
              edge,
              width.xyz as Vec3,
              height,
              least,
            ).toVar() as Vec3;
            If(light.x.add(light.y).add(light.z).mul(at.y).greaterThan(0), () => {
              const seen = float(1).toVar();
              If(row.greaterThanEqual(0), () => {
                const isFar = lamp.w.lessThan(0.5).select(float(1), float(0)) as unknown as Float;
                seen.assign(seesLamp(this.#maps, int(row) as unknown as Int, isFar, P));
              });
              found.addAssign(light.mul(at.y).mul(seen));
            });
          });
          sum.addAssign(found.div(steps));
        });
      });
      return vec4(sum.mul(this.#albedo), 1);
    })();
  }

  /** The picture behind the fog, and the fog's light before it. */
  #compose(): Node {
    return Fn(() => {
      const depth = this.#inputs.depth.sample(uv()).r as unknown as Float;
      const z = perspectiveDepthToViewZ(depth, this.#inputs.near, this.#inputs.far) as unknown as Float;
      const open = depth.lessThan(1).select(z.negate().min(NOTHING), float(NOTHING));
      const distance = keptFloat(open as unknown as Float);
      const { direction, far } = this.#ray(uv() as Vec2, distance);
      const o = this.#inputs.cameraPosition as unknown as Vec3;
      const left = keptFloat(fogTransmittance(this.#ball, this.#thickness, o, direction, far));
      const behind = this.#scene.sample(uv()).min(MOST).toVar() as unknown as Vec4;
      const even = this.#albedo.mul(this.#ambient).mul(left.oneMinus()) as Vec3;
      const color = behind.rgb
        .mul(left)
        .add(even)
        .add(brought(this.#guide, this.#smoothed, distance));
      return vec4(color, behind.a.oneMinus().mul(left).oneMinus());
    })();
  }
}

export const fog: EffectDefinition = {
  name: 'fog',
  isOn: ({ effects, fog: air }) => effects.fog.enabled && (air?.density ?? 0) > 0,
  variant: ({ effects }) => String(effects.fog.halfResolution),
  needsSurfaces: true,
  build: (inputs, { effects }) => new FogEffect(inputs, effects.fog.halfResolution ? 0.5 : 1),
};
