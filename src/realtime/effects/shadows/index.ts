/**
 * Shadows of directional, point, spot and rectangle lights, as soft as the lights are large. Maps are drawn anew when something
 * that casts, or the light, has moved: a scene that stands still pays for looking alone. docs/effects.md has what they are
 * compared with.
 */
import { int, renderGroup, texture, uniform } from 'three/tsl';
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
import { type Place, PlacedLight, type Shape, shapeOf, shapesOf, squares } from './lamps.ts';
import { cascadeFunction, sunFunction } from './parallel-lookup.ts';
import { Rows, type Tile } from './rows.ts';

class Shadows implements Effect {
  readonly context: { readonly shadows: LightShadows };
  readonly #atlas: ShadowAtlas;
  readonly #rows: Rows;
  readonly #free: Place[];
  readonly #placed = new Map<Light, PlacedLight>();
  readonly #casters = new Casters();
  readonly #samples = uniform(1).setGroup(renderGroup);
  #settings: Effects['shadows'];
  readonly #inputs: FrameInputs;
  readonly #maps: ShadowMaps;

  constructor(inputs: FrameInputs, settings: EffectSettings) {
    const { effects } = settings;
    this.#inputs = inputs;
    this.#settings = effects.shadows;
    const shapes = shapesIn(settings);
    const sizes = shapes.map((shape) => squares(shape, effects.shadows));
    this.#atlas = new ShadowAtlas(sizes.flat());
    this.#rows = new Rows(shapes.length);
    let next = 0;
    this.#free = shapes.map((shape, row): Place => {
      const count = (sizes[row] as number[]).length;
      const tiles = this.#atlas.tiles.slice(next, next + count) as Tile[];
      next += count;
      return { shape, row, tiles };
    });
    this.context = { shadows: this.#lookups() };
    this.#maps = {
      atlas: this.#atlas.target.texture,
      rows: this.#rows.texture,
      rowOf: (light) => this.#placed.get(light)?.place.row ?? null,
    };
  }

  update({ effects }: EffectSettings): void {
    this.#settings = effects.shadows;
    this.#inputs.shadowMaps = this.#maps;
    this.#samples.value = effects.shadows.samples;
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
      for (const map of maps) this.#atlas.draw(three, scene, map.camera, map.tile, map.isParallel, map.casts);
    }
    // Materials whose objects have not changed are not looked at: it is uploaded here.
    three.initTexture(this.#rows.texture);
  }

  dispose(): void {
    // Its successor may have come before.
    if (this.#inputs.shadowMaps === this.#maps) this.#inputs.shadowMaps = null;
    this.#atlas.dispose();
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

  #lookups(): LightShadows {
    const maps = {
      atlas: mapTexture(this.#atlas.target.texture),
      rows: mapTexture(this.#rows.texture),
    };
    // three.js keeps the text of a function for all shaders, with the first one's names of textures: each has its own here.
    const functions = new WeakMap<NodeBuilder, Functions>();
    const functionsOf = (builder: NodeBuilder): Functions => {
      let made = functions.get(builder);
      if (!made) {
        made = {
          lamp: lampFunction(maps),
          sun: sunFunction(maps),
          cascade: cascadeFunction(maps),
          blocker: panelBlockerFunction(maps),
          seen: panelSeenFunction(maps),
        } as unknown as Functions;
        functions.set(builder, made);
      }
      return made;
    };
    const samples = this.#samples as unknown as Node<'float'>;
    const rowOf = (light: Light) => {
      const place = light.castShadow ? this.#place(light)?.place : undefined;
      return place ? int(place.row) : null;
    };
    return {
      lamp(light, builder): LampShadow | null {
        const row = rowOf(light);
        if (row === null) return null;
        const { lamp, sun } = functionsOf(builder);
        const call = shapeOf(light) === 'cascades' ? sun : lamp;
        return ({ position, normal, noise }) => call(row, position, normal, samples, noise);
      },
      cascade(light, builder) {
        const row = rowOf(light);
        if (row === null || shapeOf(light) !== 'cascades') return null;
        const { cascade } = functionsOf(builder);
        return ({ position, noise }) => cascade(row, position, noise);
      },
      panel(light, builder): PanelShadow | null {
        const row = rowOf(light);
        if (row === null) return null;
        const { blocker, seen } = functionsOf(builder);
        return {
          blocker: ({ position, normal, noise }) => blocker(row, position, normal, samples, noise),
          seen: ({ position, normal }, found, place, turn) => seen(row, position, normal, found, place, turn),
        };
      },
    };
  }
}

/** Read texel by texel: there is no transform of texture coordinates. */
function mapTexture(map: Texture): TextureNode {
  const node = texture(map) as TextureNode & { setUpdateMatrix(value: boolean): TextureNode };
  return node.setUpdateMatrix(false);
}

type Call = (...args: readonly unknown[]) => Node<'float'>;
type Functions = Readonly<Record<'lamp' | 'sun' | 'cascade' | 'blocker' | 'seen', Call>>;

/** A sky's sun is a light like those that are named. */
const shapesIn = ({ lights = {}, environment }: EffectSettings): Shape[] =>
  shapesOf(environment ? lightsOf({ lights, environment }) : lights);

export const shadows: EffectDefinition = {
  name: 'shadows',
  isOn: (settings) => settings.effects.shadows.enabled && shapesIn(settings).length > 0,
  variant(settings) {
    const { resolution, cascades } = settings.effects.shadows;
    return [resolution, cascades, ...shapesIn(settings).sort()].join(' ');
  },
  needsSurfaces: false,
  build: (inputs, settings) => new Shadows(inputs, settings),
};
