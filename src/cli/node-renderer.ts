import * as THREE from 'three/webgpu';
import { type DeviceChoice, type NodeGpu, requestGpu } from './gpu.ts';
import { decodeImage, flipRows, NodeImageBitmap } from './node-image.ts';

/** What three.js expects of a browser, for Node: a WebGPURenderer on Dawn, and its pixels read back. */
export interface NodeRenderer {
  renderer: THREE.WebGPURenderer;
  canvas: HTMLCanvasElement;
  gpu: NodeGpu;
  /** The last frame that was drawn to the canvas: 8-bit RGBA, rows from the top. */
  readCanvas(): Promise<Uint8Array>;
  dispose(): void;
}

export interface NodeRendererOptions {
  width: number;
  height: number;
  device?: DeviceChoice;
  antialias?: boolean;
  onFatal?: (message: string) => void;
}

export async function createNodeRenderer(options: NodeRendererOptions): Promise<NodeRenderer> {
  const { width, height, antialias = false } = options;
  const gpu = await requestGpu(options);
  installBrowserGlobals(gpu.gpu);
  const canvas = new NodeCanvas(width, height);
  const renderer = new THREE.WebGPURenderer({
    canvas: canvas as unknown as HTMLCanvasElement,
    device: gpu.device,
    antialias,
  });
  await renderer.init();
  renderer.setSize(width, height, false);
  return {
    renderer,
    canvas: canvas as unknown as HTMLCanvasElement,
    gpu,
    readCanvas: () => canvas.context.read(),
    dispose() {
      renderer.dispose();
      gpu.device.destroy();
    },
  };
}

/** A canvas as far as WebGPURenderer looks at it. */
class NodeCanvas {
  readonly context = new NodeCanvasContext(this);
  readonly style = {};
  constructor(
    public width: number,
    public height: number,
  ) {}
  getContext(kind: string): NodeCanvasContext | null {
    return kind === 'webgpu' ? this.context : null;
  }
  addEventListener(): void {}
  removeEventListener(): void {}
  setAttribute(): void {}
}

class NodeCanvasContext {
  #configuration: GPUCanvasConfiguration | null = null;
  #texture: GPUTexture | null = null;

  constructor(readonly canvas: NodeCanvas) {}

  configure(configuration: GPUCanvasConfiguration): void {
    this.#configuration = configuration;
    this.#texture?.destroy();
    this.#texture = null;
  }

  unconfigure(): void {
    this.#configuration = null;
  }

  getConfiguration(): GPUCanvasConfiguration | null {
    return this.#configuration;
  }

  getCurrentTexture(): GPUTexture {
    if (!this.#configuration) throw new Error('the canvas is not configured');
    const { device, format, usage = GPUTextureUsage.RENDER_ATTACHMENT } = this.#configuration;
    const { width, height } = this.canvas;
    if (this.#texture?.width !== width || this.#texture.height !== height) {
      this.#texture?.destroy();
      this.#texture = device.createTexture({
        size: [width, height],
        format,
        usage: usage | GPUTextureUsage.COPY_SRC,
      });
    }
    return this.#texture;
  }

  async read(): Promise<Uint8Array> {
    const texture = this.getCurrentTexture();
    const { device } = this.#configuration as GPUCanvasConfiguration;
    const { width, height } = texture;
    // WebGPU wants rows in a buffer to start at multiples of 256 bytes.
    const bytesPerRow = Math.ceil((width * 4) / 256) * 256;
    const buffer = device.createBuffer({
      size: bytesPerRow * height,
      usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ,
    });
    const encoder = device.createCommandEncoder();
    encoder.copyTextureToBuffer({ texture }, { buffer, bytesPerRow }, [width, height]);
    device.queue.submit([encoder.finish()]);
    await buffer.mapAsync(GPUMapMode.READ);
    const rows = new Uint8Array(buffer.getMappedRange());
    const pixels = new Uint8Array(width * height * 4);
    for (let y = 0; y < height; y++) {
      pixels.set(rows.subarray(y * bytesPerRow, y * bytesPerRow + width * 4), y * width * 4);
    }
    buffer.unmap();
    buffer.destroy();
    if (texture.format.startsWith('bgra')) swapRedAndBlue(pixels);
    return pixels;
  }
}

function swapRedAndBlue(pixels: Uint8Array): void {
  for (let i = 0; i < pixels.length; i += 4) {
    const blue = pixels[i]!;
    pixels[i] = pixels[i + 2]!;
    pixels[i + 2] = blue;
  }
}

let installed = false;

function installBrowserGlobals(gpu: GPU): void {
  // Node 21 and later have a navigator of their own, without a GPU.
  if (typeof navigator === 'undefined') define('navigator', { userAgent: 'Node.js' });
  Object.defineProperty(navigator, 'gpu', { value: gpu, configurable: true });
  if (installed) return;
  installed = true;

  define('self', globalThis);
  define('requestAnimationFrame', (callback: FrameRequestCallback) =>
    setTimeout(() => callback(performance.now()), 0),
  );
  define('cancelAnimationFrame', (handle: number) => clearTimeout(handle));
  define('ProgressEvent', class extends Event {});
  define('ImageBitmap', NodeImageBitmap);
  define('createImageBitmap', async (blob: Blob) => decodeImage(new Uint8Array(await blob.arrayBuffer())));
  GPUQueue.prototype.copyExternalImageToTexture = copyImage;
}

function define(name: string, value: unknown): void {
  if (!(name in globalThis))
    Object.defineProperty(globalThis, name, { value, configurable: true, writable: true });
}

/** Dawn for Node knows no images of its own; these are uploaded as the bytes that they are. */
function copyImage(
  this: GPUQueue,
  image: GPUCopyExternalImageSourceInfo,
  target: GPUCopyExternalImageDestInfo,
): undefined {
  const { width, height, data } = image.source as unknown as NodeImageBitmap;
  const pixels = image.flipY ? flipRows(data, width * 4) : data;
  this.writeTexture(target, pixels as Uint8Array<ArrayBuffer>, { bytesPerRow: width * 4 }, [width, height]);
}
