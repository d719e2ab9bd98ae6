import { join } from 'node:path';
import { chromiumPackage, readBrotli, unpackOnce, unpackTar } from './unpack.ts';

/**
 * SwiftShader, a Vulkan driver that runs on the CPU, out of the npm package @sparticuz/chromium: the one
 * place where the npm registry has it. The same archive holds the Vulkan loader, which a machine without a
 * GPU often lacks.
 */
export interface SwiftShader {
  /** The Vulkan loader, libvulkan.so.1. */
  loader: string;
  /** The file that tells the loader where the driver is. */
  icd: string;
}

const WANTED = ['libvk_swiftshader.so', 'libvulkan.so.1', 'vk_swiftshader_icd.json'];

/** Unpacks SwiftShader, once per version of the package, and says where it is. */
export function unpackSwiftShader(): SwiftShader {
  const { archives, version } = chromiumPackage();
  const folder = unpackOnce(`swiftshader-${version}`, (fresh) => {
    unpackTar(readBrotli(join(archives, 'swiftshader.tar.br')), fresh, (name) => WANTED.includes(name));
  });
  return { loader: join(folder, 'libvulkan.so.1'), icd: join(folder, 'vk_swiftshader_icd.json') };
}
