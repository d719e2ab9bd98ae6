/**
 * Shadows of directional, point, spot and rectangle lights, as soft as the lights are large, from maps of what lamps see; and
 * contact shadows from what the camera sees. Maps are drawn anew when something that casts, or the light, has moved: a scene
 * that stands still pays for looking alone. docs/effects.md has what they are compared with.
 */
import { dot, int, normalViewGeometry, positionView, renderGroup, texture, uniform, vec4 } from 'three/tsl';
import type {
  Light,
  Node,
  NodeBuilder,
  PerspectiveCamera,
  Scene,
  Texture,
  TextureNode,
  WebGPURenderer,
} from 'three/webgpu';
import type { LampShadow, LightShadows, PanelShadow } from '../../../material/light-shadows.ts';
import type { Effects } from '../../../scene/effects-schema.ts';
import { lightsOf } from '../../../scene/sky/sun.ts';
import type { Effect, EffectDefinition, EffectSettings } from '../../frame/effect.ts';
import type { FrameInputs, ShadowMaps } from '../../frame/inputs.ts';
import { ShadowAtlas } from './atlas.ts';
import { Casters } from './casters.ts';
import { lampFunction, panelBlockerFunction, panelSeenFunction } from './central-lookup.ts';
import { ContactShadows } from './contact.ts';
import { type Place, PlacedLight, type Shape, shapeOf, shapesOf, squares } from './lamps.ts';
import type { Float, Int, Maps, Vec3 } from './lookup.ts';
import { readRow } from './lookup.ts';
import { GROUP, LampMask, MASKED_LAMPS, type MaskedLamp, type SeenPoint } from './mask.ts';
import { cascadeFunction, sunFunction } from './parallel-lookup.ts';
import { Rows, type Tile } from './rows.ts';

/** The golden ratio's fraction: noise that is moved by it with each frame is spread evenly over a few. */
const GOLDEN = 0.6180339887498949;

class Shadows implements Effect {
  readonly context: { readonly shadows: LightShadows };
  /** Null where contact shadows are all there are. */
  readonly #atlas: ShadowAtlas | null;
  readonly #contact: ContactShadows | null;
  readonly #mask: LampMask;
  readonly #rows: Rows;
  readonly #free: Place[];
  readonly #placed = new Map<Light, PlacedLight>();
  readonly #casters = new Casters();
  readonly #samples = uniform(1).setGroup(renderGroup);
  readonly #turn = uniform(0);
  #settings: Effects['shadows'];
  /** Frames are gathered: noise may be another in each. */
  #isGathered = false;
  readonly #inputs: FrameInputs;
  readonly #maps: ShadowMaps | null;

  constructor(inputs: FrameInputs, settings: EffectSettings) {
    const { effects } = settings;
    this.#inputs = inputs;
    this.#settings = effects.shadows;
    const shapes = shapesIn(settings);
    const sizes = shapes.map((shape) => squares(shape, effects.shadows));
    this.#atlas = effects.shadows.enabled ? new ShadowAtlas(sizes.flat()) : null;
    this.#contact = effects.contactShadows.enabled ? new ContactShadows(inputs) : null;
    this.#rows = new Rows(shapes.length);
    let next = 0;
    const places = shapes.map((shape, row): Place => {
      const count = (sizes[row] as number[]).length;
      const tiles =
        this.#atlas?.tiles.slice(next, next + count) ?? Array.from({ length: count }, () => NO_TILE);
      next += count;
      return { shape, row, tiles };
    });
    this.#free = [...places];
    const maps: Maps = {
      atlas: mapTexture(this.#atlas?.target.texture ?? this.#rows.texture),
      rows: mapTexture(this.#rows.texture),
    };
    const masked = places.filter(({ shape }) => shape !== 'panel').slice(0, MASKED_LAMPS);
    const groups = Array.from(
      { length: Math.ceil(masked.length / GROUP) },
      (_, i) => () => this.#maskedLamps(masked.slice(i * GROUP, (i + 1) * GROUP), maps),
    );
    this.#mask = new LampMask(inputs, groups, this.#turn as unknown as Float);
    this.context = { shadows: this.#lookups(maps, new Map(masked.map(({ row }, i) => [row, i]))) };
    this.#maps = this.#atlas && {
      atlas: this.#atlas.target.texture,
      rows: this.#rows.texture,
      rowOf: (light) => this.#placed.get(light)?.place.row ?? null,
    };
  }

  update({ effects }: EffectSettings): void {
    this.#settings = effects.shadows;
    this.#isGathered = effects.antialiasing.method === 'temporal';
    if (this.#maps) this.#inputs.shadowMaps = this.#maps;
    this.#samples.value = effects.shadows.samples;
    this.#contact?.update(effects.contactShadows);
  }

  beforeScene(three: WebGPURenderer, scene: Scene, camera: PerspectiveCamera): void {
    scene.updateMatrixWorld();
    // It is told this when it is drawn with first, which is later.
    const { coordinateSystem } = three;
    const lights: Light[] = [];
    scene.traverseVisible((object) => {
      const light = object as Light;
      if (light.isLight && light.castShadow) lights.push(light);
    });
    this.#release(new Set(lights));
    const haveChanged = this.#casters.update(scene);
    for (const light of lights) {
      const placed = this.#place(light);
      if (placed === null) continue;
      const maps = placed.update(
        this.#casters,
        haveChanged,
        camera,
        { ...this.#settings, coordinateSystem },
        this.#rows,
      );
      for (const map of maps)
        this.#atlas?.draw(three, scene, map.camera, map.tile, map.isParallel, map.casts);
    }
    // Materials whose objects have not changed are not looked at: it is uploaded here.
    three.initTexture(this.#rows.texture);
    this.#contact?.render(three);
    this.#turn.value = this.#isGathered ? (this.#inputs.frameIndex.value * GOLDEN) % 1 : 0;
    this.#mask.render(three);
  }

  dispose(): void {
    // Its successor may have come before.
    if (this.#maps && this.#inputs.shadowMaps === this.#maps) this.#inputs.shadowMaps = null;
    this.#atlas?.dispose();
    this.#contact?.dispose();
    this.#mask.dispose();
    this.#rows.texture.dispose();
  }

  /** Frees the places of lights that are gone. */
  #release(lights: ReadonlySet<Light>): void {
    for (const [light, { place }] of this.#placed) {
      if (lights.has(light) && shapeOf(light) === place.shape) continue;
      this.#placed.delete(light);
      this.#free.push(place);
    }
  }

  /** A light's place; null if there is none for it. */
  #place(light: Light): PlacedLight | null {
    const known = this.#placed.get(light);
    if (known) return known;
    const shape = shapeOf(light);
    const i = this.#free.findIndex((place) => place.shape === shape);
    if (i < 0) return null;
    const [place] = this.#free.splice(i, 1) as [Place];
    const placed = new PlacedLight(light, place);
    this.#placed.set(light, placed);
    return placed;
  }

  /** What one pass of the mask asks for the lamps of these places. */
  #maskedLamps(places: readonly Place[], maps: Maps): MaskedLamp[] {
    const functions = functionsFor(maps);
    return places.map(({ shape, row }): MaskedLamp => {
      const read = readRow(maps, int(row) as unknown as Int);
      return {
        facing({ position, normal }) {
          if (shape === 'cascades') return dot(normal, read(3).xyz as Vec3).greaterThan(read(0).w.negate());
          const origin = read(0).toVar();
          return dot(normal, origin.xyz.sub(position) as Vec3).greaterThan(origin.w.negate());
        },
        seen: (point) => this.#seen(functions, maps, shape, row, point),
      };
    });
  }

  #seen(functions: Functions, maps: Maps, shape: Shape, row: number, point: SeenPoint): Float {
    const { position, normal, noise } = point;
    const call = shape === 'cascades' ? functions.sun : shape === 'single' ? functions.spot : functions.lamp;
    const far = this.#atlas ? call(int(row), position, normal, this.#samples, noise) : null;
    if (!this.#contact) return far as Float;
    const read = readRow(maps, int(row) as unknown as Int);
    const towards = shape === 'cascades' ? read(3).xyz : read(0).xyz.sub(position);
    const L = this.#inputs.view
      .mul(vec4(towards as Vec3, 0))
      .xyz.normalize()
      .toVar() as unknown as Vec3;
    const near = this.#contact.lit(point.P, point.N, L, noise);
    return far ? (far.mul(near) as Float) : near;
  }

  /** @param masked by their rows, the lamps that the mask has */
  #lookups(maps: Maps, masked: ReadonlyMap<number, number>): LightShadows {
    const found = new WeakMap<NodeBuilder, readonly Float[]>();
    // three.js keeps the text of a function for all shaders, with the first one's names of textures: each has its own here.
    const made = new WeakMap<NodeBuilder, Functions>();
    const functionsOf = (builder: NodeBuilder): Functions => {
      const functions = made.get(builder) ?? functionsFor(maps);
      made.set(builder, functions);
      return functions;
    };
    const placeOf = (light: Light) => (light.castShadow ? this.#place(light)?.place : undefined);
    return {
      start: (builder) => {
        if (masked.size > 0 && !isTransparent(builder)) found.set(builder, this.#mask.atFragment());
      },
      lamp: (light, builder): LampShadow | null => {
        const place = placeOf(light);
        if (!place) return null;
        const { shape, row } = place;
        // Behind what is transparent lies another surface: what is known of the pixel is that one's.
        if (isTransparent(builder)) {
          if (!this.#atlas) return null;
          const { lamp, spot, sun } = functionsOf(builder);
          const call = shape === 'cascades' ? sun : shape === 'single' ? spot : lamp;
          return ({ position, normal, noise }) => call(int(row), position, normal, this.#samples, noise);
        }
        const kept = found.get(builder)?.[masked.get(row) ?? MASKED_LAMPS];
        if (kept) return () => kept;
        const view = { P: positionView as Vec3, N: normalViewGeometry as unknown as Vec3 };
        return (point) => this.#seen(functionsOf(builder), maps, shape, row, { ...view, ...point });
      },
      cascade: (light, builder) => {
        const place = placeOf(light);
        if (!this.#atlas || place?.shape !== 'cascades') return null;
        const { cascade } = functionsOf(builder);
        return ({ position, noise }) => cascade(int(place.row), position, noise);
      },
      panel: (light, builder): PanelShadow | null => {
        const place = placeOf(light);
        if (!this.#atlas || !place) return null;
        const row = int(place.row);
        const { blocker, seen } = functionsOf(builder);
        return {
          blocker: ({ position, normal, noise }) => blocker(row, position, normal, this.#samples, noise),
          seen: ({ position, normal }, distance, place, turn) =>
            seen(row, position, normal, distance, place, turn),
        };
      },
    };
  }
}

/** Stands for the squares of an atlas that is not there. */
const NO_TILE: Tile = { x: 0, y: 0, size: 1 };

const isTransparent = (builder: NodeBuilder): boolean =>
  (builder as unknown as { material: { transparent: boolean } }).material.transparent;

/** Read texel by texel: there is no transform of texture coordinates. */
function mapTexture(map: Texture): TextureNode {
  const node = texture(map) as TextureNode & { setUpdateMatrix(value: boolean): TextureNode };
  return node.setUpdateMatrix(false);
}

type Call = (...args: readonly unknown[]) => Node<'float'>;
type Functions = Readonly<Record<'lamp' | 'spot' | 'sun' | 'cascade' | 'blocker' | 'seen', Call>>;

const functionsFor = (maps: Maps) =>
  ({
    lamp: lampFunction(maps, false),
    spot: lampFunction(maps, true),
    sun: sunFunction(maps),
    cascade: cascadeFunction(maps),
    blocker: panelBlockerFunction(maps),
    seen: panelSeenFunction(maps),
  }) as unknown as Functions;

/** A sky's sun is a light like those that are named. */
const shapesIn = ({ lights = {}, environment }: EffectSettings): Shape[] =>
  shapesOf(environment ? lightsOf({ lights, environment }) : lights);

export const shadows: EffectDefinition = {
  name: 'shadows',
  isOn: (settings) =>
    (settings.effects.shadows.enabled || settings.effects.contactShadows.enabled) &&
    shapesIn(settings).length > 0,
  variant(settings) {
    const { shadows, contactShadows } = settings.effects;
    const maps = shadows.enabled ? [shadows.resolution, shadows.cascades] : [];
    return [contactShadows.enabled, ...maps, ...shapesIn(settings).sort()].join(' ');
  },
  needsSurfaces: true,
  build: (inputs, settings) => new Shadows(inputs, settings),
};
