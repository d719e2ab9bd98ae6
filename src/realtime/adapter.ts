/** What draws: a GPU, or the processor in the place of one. */
import type { WebGPURenderer } from 'three/webgpu';

const SOFTWARE = /swiftshader|llvmpipe|lavapipe|softpipe|swrast|software|basic render/i;

/** Whether it is a program that does as if it were a GPU; false where the browser does not tell. */
export function isSoftware({ backend }: WebGPURenderer): boolean {
  const { device, gl } = backend as { device?: GPUDevice; gl?: WebGL2RenderingContext };
  if (device) {
    // Browsers of before 2025 do not have it.
    const info = device.adapterInfo as (GPUAdapterInfo & { isFallbackAdapter?: boolean }) | undefined;
    if (!info) return false;
    const { vendor, architecture, device: name, description } = info;
    return (
      info.isFallbackAdapter === true || SOFTWARE.test([vendor, architecture, name, description].join(' '))
    );
  }
  const extension = gl?.getExtension('WEBGL_debug_renderer_info');
  const name = gl?.getParameter(extension?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER);
  return typeof name === 'string' && SOFTWARE.test(name);
}
