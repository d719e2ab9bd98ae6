/**
 * The environments that ship: equirectangular EXR images of @pmndrs/assets (CC0), each
 * loaded on demand. The bundler has to see every import, hence the list.
 */

type DataUrlModule = Promise<{ default: string }>;

const sources = {
  apartment: (): DataUrlModule => import('@pmndrs/assets/hdri/apartment.exr.js'),
  bridge: (): DataUrlModule => import('@pmndrs/assets/hdri/bridge.exr.js'),
  city: (): DataUrlModule => import('@pmndrs/assets/hdri/city.exr.js'),
  dawn: (): DataUrlModule => import('@pmndrs/assets/hdri/dawn.exr.js'),
  esplanade: (): DataUrlModule => import('@pmndrs/assets/hdri/esplanade.exr.js'),
  forest: (): DataUrlModule => import('@pmndrs/assets/hdri/forest.exr.js'),
  hall: (): DataUrlModule => import('@pmndrs/assets/hdri/hall.exr.js'),
  lab: (): DataUrlModule => import('@pmndrs/assets/hdri/lab.exr.js'),
  lobby: (): DataUrlModule => import('@pmndrs/assets/hdri/lobby.exr.js'),
  night: (): DataUrlModule => import('@pmndrs/assets/hdri/night.exr.js'),
  park: (): DataUrlModule => import('@pmndrs/assets/hdri/park.exr.js'),
  sky: (): DataUrlModule => import('@pmndrs/assets/hdri/sky.exr.js'),
  studio: (): DataUrlModule => import('@pmndrs/assets/hdri/studio.exr.js'),
  sunrise: (): DataUrlModule => import('@pmndrs/assets/hdri/sunrise.exr.js'),
  sunset: (): DataUrlModule => import('@pmndrs/assets/hdri/sunset.exr.js'),
  venice: (): DataUrlModule => import('@pmndrs/assets/hdri/venice.exr.js'),
  warehouse: (): DataUrlModule => import('@pmndrs/assets/hdri/warehouse.exr.js'),
  workshop: (): DataUrlModule => import('@pmndrs/assets/hdri/workshop.exr.js'),
};

export type EnvironmentPreset = keyof typeof sources;
export const environmentPresets = Object.keys(sources) as [EnvironmentPreset, ...EnvironmentPreset[]];

/** The image as a data URL. */
export async function loadPreset(name: EnvironmentPreset): Promise<string> {
  return (await sources[name]()).default;
}

/** Blender's Suzanne as a GLB in a data URL. */
export async function loadSuzanne(): Promise<string> {
  return (await import('@pmndrs/assets/models/suzi.glb.js')).default;
}
