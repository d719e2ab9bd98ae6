/** The lights of the document, and its sky's sun, as three.js lights: a changed field sets a field. */
import * as THREE from 'three/webgpu';
import { BrdfDirectionalLight } from '../../lights/directional-light.ts';
import { BrdfPointLight } from '../../lights/point-light.ts';
import { BrdfRectLight } from '../../lights/rect-light.ts';
import { BrdfSpotLight } from '../../lights/spot-light.ts';
import { temperatureColor } from '../../lights/units.ts';
import type { Document, Light, LightOf, LightType } from '../schema.ts';
import { lightsOf } from '../sky/sun.ts';
import { diff } from './diff.ts';

interface ThreeLights {
  ambient: THREE.AmbientLight;
  hemisphere: THREE.HemisphereLight;
  directional: BrdfDirectionalLight;
  point: BrdfPointLight;
  spot: BrdfSpotLight;
  rectangle: BrdfRectLight;
}

export type MirroredLight = ThreeLights[LightType];

type Kinds = {
  readonly [T in LightType]: {
    create(): ThreeLights[T];
    set(light: ThreeLights[T], source: LightOf<T>): void;
  };
};

const kinds: Kinds = {
  ambient: {
    create: () => new THREE.AmbientLight(),
    set: (light, { luminance }) => {
      // three.js counts ambient light as the irradiance pi L of the radiance L from everywhere.
      light.intensity = Math.PI * luminance;
    },
  },
  hemisphere: {
    create: () => new THREE.HemisphereLight(),
    set: (light, { luminance, groundColor }) => {
      light.intensity = Math.PI * luminance;
      light.groundColor.setRGB(...groundColor);
    },
  },
  directional: {
    create: () => new BrdfDirectionalLight(),
    set: (light, { illuminance, position, target, angularDiameter, castShadow }) => {
      light.intensity = illuminance;
      light.angularDiameter = THREE.MathUtils.degToRad(angularDiameter);
      light.castShadow = castShadow;
      light.position.fromArray(position);
      light.target.position.fromArray(target);
    },
  },
  point: {
    create: () => new BrdfPointLight(),
    set: (light, { intensity, position, falloff, range, radius, castShadow }) => {
      light.intensity = intensity;
      light.radius = radius;
      light.castShadow = castShadow;
      light.position.fromArray(position);
      light.falloff = falloff;
      light.distance = range;
    },
  },
  spot: {
    create: () => new BrdfSpotLight(),
    set: (light, source) => {
      light.intensity = source.intensity;
      light.position.fromArray(source.position);
      light.target.position.fromArray(source.target);
      light.angle = THREE.MathUtils.degToRad(source.cutoff);
      light.exponent = source.exponent;
      light.penumbra = source.penumbra;
      light.falloff = source.falloff;
      light.distance = source.range;
      light.radius = source.radius;
      light.castShadow = source.castShadow;
    },
  },
  rectangle: {
    create: () => new BrdfRectLight(),
    set: (light, { luminance, position, target, width, height, castShadow }) => {
      light.intensity = luminance;
      light.castShadow = castShadow;
      light.width = width;
      light.height = height;
      light.position.fromArray(position);
      light.lookAt(...target);
    },
  },
};

interface Entry {
  type: LightType;
  three: MirroredLight;
}

/** More than anybody deletes and wants back. */
const MOST_GONE = 128;

export class LightsMirror {
  readonly group = new THREE.Group();
  readonly #entries = new Map<string, Entry>();
  /**
   * What has gone and may come back by undo. Light is summed in the order in which three's lights were made: with others in
   * their place the picture would be another in its last bit, and every material compiled anew.
   */
  readonly #gone = new Map<string, MirroredLight>();

  constructor() {
    this.group.name = 'lights';
  }

  /** What has gone does not come back. */
  forget(): void {
    this.#gone.clear();
  }

  apply(document: Document, before: Document | null): void {
    diff(before === null ? {} : lightsOf(before), lightsOf(document), {
      removed: (id) => this.#remove(id),
      added: (id, light) => this.#add(id, light),
      changed: (id, light) => {
        const entry = this.#entries.get(id);
        if (entry?.type === light.type) setLight(entry.three, light);
        else {
          this.#remove(id);
          this.#add(id, light);
        }
      },
    });
  }

  get(id: string): MirroredLight | undefined {
    return this.#entries.get(id)?.three;
  }

  dispose(): void {
    for (const id of [...this.#entries.keys()]) this.#remove(id);
  }

  #add(id: string, light: Light): void {
    const three = this.#gone.get(keyOf(id, light.type)) ?? kinds[light.type].create();
    this.#gone.delete(keyOf(id, light.type));
    setLight(three, light);
    this.#entries.set(id, { type: light.type, three });
    this.group.add(three);
    // A target outside the scene would keep the world matrix that it was born with.
    if ('target' in three) this.group.add(three.target);
  }

  #remove(id: string): void {
    const entry = this.#entries.get(id);
    if (entry === undefined) return;
    const { type, three } = entry;
    this.#entries.delete(id);
    this.#gone.set(keyOf(id, type), three);
    const [oldest] = this.#gone.keys();
    if (oldest !== undefined && this.#gone.size > MOST_GONE) this.#gone.delete(oldest);
    three.removeFromParent();
    if ('target' in three) three.target.removeFromParent();
    three.dispose();
  }
}

const keyOf = (id: string, type: LightType) => `${type} ${id}`;

function setLight<T extends LightType>(three: ThreeLights[T], source: LightOf<T>): void {
  const kind: Kinds[T] = kinds[source.type as T];
  const { name, visible, color, temperature } = source as Light;
  three.name = name;
  three.visible = visible;
  three.color.setRGB(...color);
  if (temperature !== null) three.color.multiply(new THREE.Color(...temperatureColor(temperature)));
  kind.set(three, source);
}
