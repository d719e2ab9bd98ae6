/** Geometries by what they are: equal primitives share one, and what nothing uses is disposed. */
import * as THREE from 'three/webgpu';
import type { AssetLoader } from '../assets.ts';
import type { Asset, Document, Geometry } from '../schema.ts';
import type { Pending } from './pending.ts';

interface Entry {
  users: number;
  /** Null until it has come. */
  geometry: THREE.BufferGeometry | null;
  waiting: Set<(geometry: THREE.BufferGeometry) => void>;
}

export interface GeometryUse {
  readonly key: string;
  /** No longer wanted. */
  release(): void;
}

export class GeometryCache {
  readonly #assets: AssetLoader;
  readonly #pending: Pending;
  readonly #entries = new Map<string, Entry>();
  readonly #serials = new WeakMap<Asset, number>();
  #lastSerial = 0;

  constructor(assets: AssetLoader, pending: Pending) {
    this.#assets = assets;
    this.#pending = pending;
  }

  /** Two geometries with the same key are the same triangles. */
  keyOf(geometry: Geometry, { assets }: Pick<Document, 'assets'>): string {
    if (geometry.type !== 'gltf') return JSON.stringify(geometry);
    const asset = assets[geometry.asset];
    return `gltf ${asset && this.#serial(asset)} ${geometry.node} ${geometry.primitive}`;
  }

  /** Calls `use` at once for what can be made at once, later for what has to be loaded. */
  acquire(
    geometry: Geometry,
    document: Pick<Document, 'assets'>,
    use: (geometry: THREE.BufferGeometry) => void,
  ): GeometryUse {
    const key = this.keyOf(geometry, document);
    const entry = this.#entries.get(key) ?? this.#create(key, geometry, document);
    entry.users += 1;
    if (entry.geometry === null) entry.waiting.add(use);
    else use(entry.geometry);
    return {
      key,
      release: () => {
        entry.waiting.delete(use);
        entry.users -= 1;
        if (entry.users > 0) return;
        this.#entries.delete(key);
        entry.geometry?.dispose();
      },
    };
  }

  #create(key: string, geometry: Geometry, { assets }: Pick<Document, 'assets'>): Entry {
    const entry: Entry = { users: 0, geometry: null, waiting: new Set() };
    this.#entries.set(key, entry);
    if (geometry.type === 'suzanne') this.#fill(entry, this.#assets.suzanne());
    else if (geometry.type !== 'gltf') entry.geometry = createPrimitive(geometry);
    else {
      const asset = assets[geometry.asset];
      if (asset !== undefined)
        this.#fill(entry, this.#assets.gltfGeometry(asset, geometry.node, geometry.primitive));
    }
    return entry;
  }

  #fill(entry: Entry, loading: Promise<THREE.BufferGeometry>): void {
    this.#pending.add(loading, (geometry) => {
      entry.geometry = geometry;
      for (const use of entry.waiting) use(geometry);
      entry.waiting.clear();
    });
  }

  #serial(asset: Asset): number {
    let serial = this.#serials.get(asset);
    if (serial === undefined) {
      this.#lastSerial += 1;
      serial = this.#lastSerial;
      this.#serials.set(asset, serial);
    }
    return serial;
  }
}

export type Primitive = Exclude<Geometry, { type: 'suzanne' | 'gltf' }>;

export function createPrimitive(g: Primitive): THREE.BufferGeometry {
  const angle = THREE.MathUtils.degToRad;
  switch (g.type) {
    case 'plane':
      return new THREE.PlaneGeometry(g.width, g.height, g.widthSegments, g.heightSegments);
    case 'circle':
      return new THREE.CircleGeometry(g.radius, g.segments, angle(g.thetaStart), angle(g.thetaLength));
    case 'box':
      return new THREE.BoxGeometry(
        g.width,
        g.height,
        g.depth,
        g.widthSegments,
        g.heightSegments,
        g.depthSegments,
      );
    case 'cone':
      return new THREE.ConeGeometry(
        g.radius,
        g.height,
        g.radialSegments,
        g.heightSegments,
        g.openEnded,
        angle(g.thetaStart),
        angle(g.thetaLength),
      );
    case 'cylinder':
      return new THREE.CylinderGeometry(
        g.radiusTop,
        g.radiusBottom,
        g.height,
        g.radialSegments,
        g.heightSegments,
        g.openEnded,
        angle(g.thetaStart),
        angle(g.thetaLength),
      );
    case 'torus':
      return new THREE.TorusGeometry(g.radius, g.tube, g.radialSegments, g.tubularSegments, angle(g.arc));
    case 'sphere':
      return new THREE.SphereGeometry(g.radius, g.widthSegments, g.heightSegments);
  }
}
