/** The lights of a scene that cast shadows, each with its row and its squares of the atlas. */
import {
  type Camera,
  type CoordinateSystem,
  type DirectionalLight,
  type Light,
  Matrix4,
  type PerspectiveCamera,
  type PointLight,
  type RectAreaLight,
  type SpotLight,
  Vector3,
} from 'three/webgpu';
import type { LightOf } from '../../../scene/light-schema.ts';
import type { Document } from '../../../scene/schema.ts';
import type { Caster, Casters } from './casters.ts';
import { type CentralLight, fitCentral } from './central.ts';
import { fitParallel } from './parallel.ts';
import type { Placement, Rows, Tile } from './rows.ts';

/** How many squares of which size a light has. */
export type Shape = 'single' | 'half' | 'cube' | 'cascades' | 'panel';

/** Beyond this tangent a spot's single map would be coarse in its middle: the faces of a cube take over. */
const WIDEST = Math.tan((55 * Math.PI) / 180);
/** Filters look beyond the cone. */
const BEYOND = 1.06;

/** Faces of a cube; the back of what shines to one side sees nothing. */
const HALF = [0, 2, 3, 4, 5];
const CUBE = [0, 1, 2, 3, 4, 5];

export interface AtlasSettings {
  readonly resolution: number;
  readonly cascades: number;
}

/** The sizes of a light's squares. */
export function squares(shape: Shape, { resolution, cascades }: AtlasSettings): number[] {
  if (shape === 'single') return [resolution];
  if (shape === 'cascades') return Array.from({ length: cascades }, () => resolution);
  // A face of a cube sees a quarter of what surrounds it.
  return (shape === 'cube' ? CUBE : HALF).map(() => Math.ceil(resolution / 2));
}

/** The shapes of a document's shadowed lights, in order. */
export function shapesOf(lights: Document['lights']): Shape[] {
  return Object.values(lights).flatMap((light): Shape[] => {
    if (!light.visible || !('castShadow' in light && light.castShadow)) return [];
    switch (light.type) {
      case 'directional':
        return ['cascades'];
      case 'point':
        return ['cube'];
      case 'spot':
        return [spotShape(((light as LightOf<'spot'>).cutoff * Math.PI) / 180)];
      case 'rectangle':
        return ['panel'];
      default:
        return [];
    }
  });
}

const spotShape = (angle: number): Shape => (angle < 1.5 && Math.tan(angle) <= WIDEST ? 'single' : 'half');

/** Null for lights that have no shadows: ambient ones. */
export function shapeOf(light: Light): Shape | null {
  const kind = light as Partial<DirectionalLight & PointLight & SpotLight & RectAreaLight>;
  if (kind.isDirectionalLight) return 'cascades';
  if (kind.isPointLight) return 'cube';
  if (kind.isRectAreaLight) return 'panel';
  return kind.isSpotLight ? spotShape(kind.angle as number) : null;
}

/** A light's place in the atlas and the rows; what it holds. */
export interface Place {
  readonly shape: Shape;
  readonly row: number;
  readonly tiles: readonly Tile[];
}

export interface DrawnMap {
  readonly tile: Tile;
  readonly camera: Camera;
  readonly isParallel: boolean;
  readonly casts: readonly Caster[];
}

export interface FitSettings extends AtlasSettings {
  readonly maxDistance: number;
  /** Of the renderer: the range of its depth. */
  readonly coordinateSystem: CoordinateSystem;
}

/** What a light's row said when it was last fitted, to see what has changed. */
export class PlacedLight {
  #signature = '';
  /** By tile. */
  #drawn: readonly (Drawn | undefined)[] = [];

  constructor(
    readonly light: Light,
    readonly place: Place,
  ) {}

  /** Fits the maps to what is there now, and writes the row. @returns the maps that have to be drawn anew */
  update(
    casters: Casters,
    haveChanged: boolean,
    camera: PerspectiveCamera,
    settings: FitSettings,
    rows: Rows,
  ): DrawnMap[] {
    const { light, place } = this;
    const isParallel = place.shape === 'cascades';
    const signature = [
      ...light.matrixWorld.elements,
      ...shapeNumbers(light),
      ...targetOf(light).toArray(),
    ].join();
    const isSame = !haveChanged && signature === this.#signature;
    if (isSame && !isParallel) return [];
    if (signature !== this.#signature) this.#drawn = [];
    this.#signature = signature;
    return isParallel
      ? this.#parallel(casters, camera, settings, rows)
      : this.#central(casters, settings, rows);
  }

  #central(casters: Casters, { coordinateSystem }: FitSettings, rows: Rows): DrawnMap[] {
    const { light, place } = this;
    const central = centralLight(light, place.shape);
    const { frame, reach, faces } = central;
    const fit = fitCentral(central, casters.list, coordinateSystem);
    const axes = [0, 1, 2].map((i) => new Vector3().setFromMatrixColumn(frame, i));
    const [width, height] = central.isPanel
      ? [(light as RectAreaLight).width / 2, (light as RectAreaLight).height / 2]
      : [0, 0];
    const radius = central.isPanel ? 0 : ((light as PointLight & { radius?: number }).radius ?? 0);
    rows.set(place.row, 0, new Vector3().setFromMatrixPosition(frame), radius);
    rows.set(place.row, 1, axes[0] as Vector3, width as number);
    rows.set(place.row, 2, axes[1] as Vector3, height as number);
    rows.set(place.row, 3, axes[2] as Vector3, reach);
    rows.set(place.row, 4, { x: fit.nearest, y: 0, z: 0 }, 0);
    for (let face = 0; face < CUBE.length; face++) {
      const i = faces.indexOf(face);
      rows.setMap(place.row, face, place.tiles[Math.max(i, 0)] as Tile, fit.maps[i]?.placement ?? null);
    }
    return this.#changed(fit.maps, '', false);
  }

  #parallel(
    casters: Casters,
    camera: PerspectiveCamera,
    { maxDistance, coordinateSystem }: FitSettings,
    rows: Rows,
  ): DrawnMap[] {
    const { light, place } = this;
    const { tiles, row } = place;
    const frame = parallelFrame(light as DirectionalLight);
    const tangent = Math.tan(((light as { angularDiameter?: number }).angularDiameter ?? 0) / 2);
    const fit = fitParallel(frame, casters.list, camera, {
      cascades: tiles.length,
      maxDistance,
      coordinateSystem,
      size: (tiles[0] as Tile).size,
      tangent,
    });
    const axes = [0, 1, 2].map((i) => new Vector3().setFromMatrixColumn(frame, i));
    rows.set(row, 0, { x: 0, y: 0, z: 0 }, tangent);
    rows.set(row, 1, axes[0] as Vector3, fit.maps.length);
    rows.set(row, 2, axes[1] as Vector3, fit.height);
    rows.set(row, 3, axes[2] as Vector3, fit.highest);
    for (const [i, tile] of tiles.entries()) rows.setMap(row, i, tile, fit.maps[i]?.placement ?? null);
    // Distances are from there.
    return this.#changed(fit.maps, `${fit.height}`, true);
  }

  /** Those of the maps that are not as they were drawn last. */
  #changed(maps: readonly (FittedMap | null)[], key: string, isParallel: boolean): DrawnMap[] {
    const before = this.#drawn;
    this.#drawn = maps.map((map) => {
      if (map === null) return undefined;
      const { u, v } = map.placement;
      return { key: [key, ...u, ...v].join(), casters: map.casters };
    });
    return maps.flatMap((map, i) => {
      if (map === null || sameDrawn(before[i], this.#drawn[i])) return [];
      const tile = this.place.tiles[i] as Tile;
      return [{ tile, camera: map.camera, isParallel, casts: map.casters }];
    });
  }
}

interface FittedMap {
  readonly placement: Placement;
  readonly camera: Camera;
  readonly casters: readonly Caster[];
}

/** What a map shows: the place of its window, and what is in it. */
interface Drawn {
  readonly key: string;
  readonly casters: readonly Caster[];
}

const sameDrawn = (a: Drawn | undefined, b: Drawn | undefined): boolean =>
  a?.key === b?.key &&
  a?.casters.length === b?.casters.length &&
  (a?.casters.every((caster, i) => caster === b?.casters[i]) ?? true);

function targetOf(light: Light): Vector3 {
  const { target } = light as Partial<DirectionalLight>;
  return target ? new Vector3().setFromMatrixPosition(target.matrixWorld) : new Vector3();
}

function shapeNumbers(light: Light): number[] {
  const { radius, angularDiameter, angle, width, height } = light as {
    radius?: number;
    angularDiameter?: number;
    angle?: number;
    width?: number;
    height?: number;
  };
  return [radius ?? 0, angularDiameter ?? 0, angle ?? 0, width ?? 0, height ?? 0];
}

function centralLight(light: Light, shape: Shape): CentralLight {
  const position = new Vector3().setFromMatrixPosition(light.matrixWorld);
  const faces = shape === 'single' ? [0] : shape === 'cube' ? CUBE : HALF;
  const { isRectAreaLight, isSpotLight, angle } = light as Partial<RectAreaLight & SpotLight>;
  if (isRectAreaLight) {
    const axis = (i: number) => new Vector3().setFromMatrixColumn(light.matrixWorld, i).normalize();
    // It shines along its -z.
    const frame = new Matrix4().makeBasis(axis(0).negate(), axis(1), axis(2).negate()).setPosition(position);
    return { frame, reach: 1, faces, isPanel: true };
  }
  if (isSpotLight) {
    const frame = lookingTo(targetOf(light).sub(position)).setPosition(position);
    const reach = shape === 'single' ? Math.tan(angle as number) * BEYOND + 0.02 : 1;
    return { frame, reach, faces, isPanel: false };
  }
  return { frame: new Matrix4().setPosition(position), reach: 1, faces, isPanel: false };
}

/** Rotation to a light: z is towards it. */
function parallelFrame(light: DirectionalLight): Matrix4 {
  const position = new Vector3().setFromMatrixPosition(light.matrixWorld);
  return lookingTo(position.sub(targetOf(light)));
}

/** A frame whose z axis is along a direction; any where there is none. */
function lookingTo(direction: Vector3): Matrix4 {
  const z = direction.lengthSq() > 0 ? direction.normalize() : new Vector3(0, 0, 1);
  const up = Math.abs(z.y) > 0.999 ? new Vector3(1, 0, 0) : new Vector3(0, 1, 0);
  const x = up.cross(z).normalize();
  return new Matrix4().makeBasis(x, new Vector3().crossVectors(z, x), z);
}
