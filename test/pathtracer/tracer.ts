/** The path tracer for tests: in this thread, without workers, so that nothing needs to be built. */

import { nodeAssets } from '../../src/cli/node-assets.ts';
import { CpuPathTracer } from '../../src/pathtracer/cpu/cpu-path-tracer.ts';
import type { FromWorker, WorkerPort } from '../../src/pathtracer/cpu/protocol.ts';
import { WorkerCore } from '../../src/pathtracer/cpu/worker-core.ts';
import type { Film } from '../../src/pathtracer/film.ts';
import type { PathTracer } from '../../src/pathtracer/path-tracer.ts';
import type { RenderSettings } from '../../src/pathtracer/scene/camera.ts';
import { type PackedScene, ScenePacker } from '../../src/pathtracer/scene/pack.ts';
import { AssetLoader } from '../../src/scene/assets.ts';
import type { Document } from '../../src/scene/schema.ts';

function spawn(): WorkerPort {
  let listener: (message: FromWorker) => void = () => {};
  const core = new WorkerCore((message) => queueMicrotask(() => listener(message)));
  return {
    post: (message) => core.receive(message),
    onMessage: (next) => (listener = next),
    onError: () => {},
    terminate: () => {},
  };
}

export function testTracer(): CpuPathTracer {
  return new CpuPathTracer({ workers: 1, spawn, shared: false });
}

export const testSettings: RenderSettings = {
  width: 16,
  height: 16,
  maxDepth: 8,
  seed: 0,
  strategy: 'mis',
  clamp: 0,
};

export interface TestRender extends Partial<RenderSettings> {
  readonly samples: number;
  /** The first sample's number. */
  readonly first?: number;
}

export function packDocument(document: Document): Promise<PackedScene> {
  return new ScenePacker(new AssetLoader(nodeAssets)).pack(document);
}

/** Those that are not rendering: a kernel takes longer to compile than a small picture to render. */
const idle: { readonly tracer: CpuPathTracer; readonly models: PackedScene['models'] }[] = [];

/** A whole rendering of a document. */
export async function trace(
  document: Document,
  { samples, first = 0, ...settings }: TestRender,
): Promise<Film> {
  const scene = await packDocument(document);
  const { models } = scene;
  const isFor = (others: typeof models) =>
    others.length === models.length && others.every((model, i) => model === models[i]);
  const at = idle.findIndex((kept) => isFor(kept.models));
  const tracer = at < 0 ? testTracer() : (idle.splice(at, 1)[0] as (typeof idle)[number]).tracer;
  await tracer.load(scene);
  const film = await render(tracer, document, { samples, first, ...settings });
  idle.push({ tracer, models });
  return film;
}

/** A rendering by a tracer that has the document's scene loaded. */
export async function render(
  tracer: PathTracer,
  document: Document,
  { samples, first = 0, ...settings }: TestRender,
): Promise<Film> {
  tracer.start(document.camera, { ...testSettings, ...settings });
  await tracer.render(first, samples);
  return tracer.film();
}
