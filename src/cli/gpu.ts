import { loadSharedLibrary } from './shared-library.ts';
import { unpackSwiftShader } from './swiftshader.ts';

/**
 * A GPU for Node: Dawn (the npm package `webgpu`) on a real GPU where there is one, otherwise on
 * SwiftShader, which computes the same on the CPU.
 */
export type DeviceChoice = 'auto' | 'gpu' | 'software';

export interface NodeGpu {
  gpu: GPU;
  adapter: GPUAdapter;
  device: GPUDevice;
  /** Whether the CPU does the work. */
  software: boolean;
}

export class GpuUnavailableError extends Error {
  override readonly name = 'GpuUnavailableError';
}

export interface GpuOptions {
  device?: DeviceChoice;
  /** Called on a GPU error that nobody awaited, and when the device is lost. Ends the process by default. */
  onFatal?: (message: string) => void;
}

export async function requestGpu({ device = 'auto', onFatal = exitWith }: GpuOptions = {}): Promise<NodeGpu> {
  const { create } = await loadDawn();
  let found: Found | null = null;
  if (device !== 'software') found = await findAdapter(create, false);
  if (!found && device !== 'gpu') found = await findSoftware(create);
  if (!found) throw new GpuUnavailableError(missing(device));

  const { gpu, adapter } = found;
  const created = await adapter.requestDevice({
    requiredFeatures: [...adapter.features] as GPUFeatureName[],
    requiredLimits: sizeLimits(adapter),
  });
  created.addEventListener('uncapturederror', (event) => onFatal(`GPU error: ${event.error.message}`));
  void created.lost.then(({ reason, message }) => {
    if (reason !== 'destroyed') onFatal(`the GPU device was lost: ${message}`);
  });
  return { gpu, adapter, device: created, software: adapter.info.isFallbackAdapter };
}

type Create = (options: string[]) => GPU;
type Found = { gpu: GPU; adapter: GPUAdapter };

async function loadDawn(): Promise<{ create: Create }> {
  try {
    const { create, globals } = await import('webgpu');
    Object.assign(globalThis, globals);
    return { create };
  } catch (cause) {
    throw new GpuUnavailableError(
      "the npm package 'webgpu' does not load here; install it with `npm install webgpu`, or use the CPU",
      { cause },
    );
  }
}

async function findAdapter(create: Create, software: boolean): Promise<Found | null> {
  // Dawn writes a warning of its own when there is no Vulkan loader at all.
  if (process.platform === 'linux' && !software && !loadSharedLibrary('libvulkan.so.1')) return null;
  const gpu = create([]);
  const adapter = await gpu.requestAdapter({
    powerPreference: 'high-performance',
    forceFallbackAdapter: software,
  });
  // A driver of the system's that runs on the CPU (lavapipe) is not preferred to SwiftShader, which is tested.
  return adapter && adapter.info.isFallbackAdapter === software ? { gpu, adapter } : null;
}

async function findSoftware(create: Create): Promise<Found | null> {
  // Elsewhere the system brings its own software adapter, or always has a GPU.
  if (process.platform !== 'linux') return findAdapter(create, true);
  if (process.arch !== 'x64') return null;
  const { loader, icd } = unpackSwiftShader();
  if (!loadSharedLibrary('libvulkan.so.1')) loadSharedLibrary(loader);
  // The loader reads both, the second since 1.3.207, each time that Dawn makes an instance.
  process.env.VK_ICD_FILENAMES = icd;
  process.env.VK_DRIVER_FILES = icd;
  return findAdapter(create, true);
}

/** WebGPU's defaults (256 MiB a buffer, 8192 pixels a side) are too small for large scenes and pictures. */
function sizeLimits({ limits }: GPUAdapter): Record<string, number> {
  const { maxBufferSize, maxStorageBufferBindingSize, maxTextureDimension2D } = limits;
  return { maxBufferSize, maxStorageBufferBindingSize, maxTextureDimension2D };
}

function missing(device: DeviceChoice): string {
  if (device === 'gpu') return 'no GPU was found; leave the choice of device out to use the software GPU';
  return `no GPU was found, and there is no software GPU for ${process.platform} ${process.arch}`;
}

function exitWith(message: string): never {
  console.error(`irradia: ${message}`);
  process.exit(1);
}
