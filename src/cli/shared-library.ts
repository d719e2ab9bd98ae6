import { constants } from 'node:os';

/**
 * Loads a shared library and keeps it, so that it is found by its name from then on; false when there is
 * none. Node takes it for an addon and complains that it registers nothing; RTLD_NODELETE keeps it loaded
 * all the same.
 */
export function loadSharedLibrary(library: string): boolean {
  const { RTLD_NOW, RTLD_GLOBAL } = constants.dlopen;
  const RTLD_NODELETE = 0x1000;
  try {
    process.dlopen({ exports: {} }, library, RTLD_NOW | RTLD_GLOBAL | RTLD_NODELETE);
    return true;
  } catch (error) {
    return error instanceof Error && error.message.includes('did not self-register');
  }
}
