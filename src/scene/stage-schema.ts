/** What a scene has once: camera, fog, view, path tracing; environment-schema.ts has its surroundings. */
import { z } from 'zod';
import { boolean, choice, color, id, integer, number, vector3, withDefaults } from './fields.ts';

export const cameraShape = {
  fov: number('Vertical field of view', { range: [1, 170], unit: '°', slider: [10, 120], step: 0.5 }),
  position: vector3('Where the camera is', { range: [-1e6, 1e6], unit: 'm', step: 0.01 }),
  target: vector3('The point that the camera looks at and orbits', {
    range: [-1e6, 1e6],
    unit: 'm',
    step: 0.01,
  }),
  near: number('Nothing closer than this is drawn', {
    range: [1e-4, 1e5],
    unit: 'm',
    slider: [0.01, 10],
    step: 0.01,
  }),
  far: number('Nothing farther than this is drawn', {
    range: [1e-3, 1e7],
    unit: 'm',
    slider: [10, 1000],
    step: 1,
  }),
  sensorHeight: number('Height of the picture behind the lens; a small one leaves more in focus', {
    range: [0.1, 1000],
    unit: 'mm',
    slider: [4, 60],
    step: 0.1,
  }),
  fStop: number(
    'Focal length over the aperture’s diameter: a small f-number lets in more light and leaves less in focus; 0 is a pinhole, all in focus, exposed as f/16',
    { range: [0, 1000], slider: [0, 22], step: 0.1 },
  ),
  shutter: number(
    'How long the picture is exposed: the longer, the brighter and the more blurred by motion',
    {
      range: [1e-6, 3600],
      unit: 's',
      slider: [0.001, 0.1],
      step: 0.001,
    },
  ),
  iso: number('Sensitivity of film or sensor: the higher, the brighter', {
    range: [1, 1e6],
    slider: [50, 6400],
    step: 1,
  }),
  focusDistance: number('Distance along the view that is in focus; 0 is the target’s', {
    range: [0, 1e7],
    unit: 'm',
    slider: [0, 20],
    step: 0.01,
  }),
  apertureBlades: integer('Corners of what is out of focus; fewer than 3 is round', {
    range: [0, 16],
    slider: [0, 16],
  }),
};

export const fogShape = {
  density: number('Part of the light that is scattered or absorbed per metre; 0 is clear air', {
    range: [0, 1e4],
    slider: [0, 1],
    step: 0.001,
  }),
  color: color('Part of that light which is scattered, not absorbed, linear Rec. 709'),
  anisotropy: number('Mean cosine of the angle by which light is turned; above 0 it goes on forwards', {
    range: [-0.99, 0.99],
    slider: [-0.95, 0.95],
    step: 0.01,
  }),
  height: number(
    'Above its base, fog is thinner by a factor e with every step of this height; 0 is as dense everywhere',
    {
      range: [0, 1e6],
      unit: 'm',
      slider: [0, 10],
      step: 0.01,
    },
  ),
  base: number('How high fog lies that is thinner above', {
    range: [-1e6, 1e6],
    unit: 'm',
    slider: [-5, 5],
    step: 0.01,
  }),
};

export const termSchema = z.strictObject({
  material: id.describe('The material whose model is looked at'),
  name: z
    .string()
    .regex(/^[A-Za-z_][A-Za-z0-9_]{0,63}$/)
    .describe('A function of the model with the signature of BRDF()'),
});

/** What the picture shows instead of light, each true data of the frame. */
export const SHOWN = [
  'picture',
  'luminance',
  'depth',
  'shadingNormals',
  'meshNormals',
  'tangents',
  'textureCoordinates',
  'motion',
  'overdraw',
  'lights',
  'cascades',
  'ambientOcclusion',
] as const;

export const viewShape = {
  show: choice(
    'The picture, or what is behind it: luminance in false colours, distance, directions of the surface, texture coordinates, motion, how often a pixel is drawn, how many lamps reach it, which of the sun’s shadow maps it has, how much of its surroundings is open',
    SHOWN,
  ),
  exposureMode: choice(
    'What exposes the picture: this panel alone, the camera’s f-number, shutter and ISO, or a meter that follows what is seen',
    ['manual', 'camera', 'auto'],
  ),
  exposure: number(
    'Exposure, beside what camera or meter say: the picture is multiplied by 2 to this power',
    {
      range: [-32, 32],
      unit: 'EV',
      slider: [-8, 8],
      step: 0.05,
    },
  ),
  toneMapping: choice('How radiance becomes a colour on the screen', ['none', 'aces', 'agx', 'neutral']),
  resolutionScale: number('Pixels rendered per pixel of the viewport, along each side', {
    range: [0.05, 4],
    unit: '×',
    slider: [0.25, 2],
    step: 0.05,
  }),
  targetFrameTime: number(
    'What a frame may take the GPU: while things move, fewer pixels are rendered, half along each side at the least, to hold it; 0 renders all',
    { range: [0, 1000], unit: 'ms', slider: [0, 50], step: 1 },
  ),
  helpers: boolean('Show where the lights are and where they shine'),
  term: termSchema
    .nullable()
    .describe('Show one term of a material’s model alone; null shows the whole model'),
};

export const pathTracingShape = {
  samples: integer('Paths per pixel after which the picture is complete', {
    range: [1, 1_048_576],
    slider: [1, 4096],
  }),
  error: number(
    'Relative error at which the picture is complete: standard deviation of a pixel over the mean of all; 0 renders all samples',
    { range: [0, 1], slider: [0, 0.1], step: 0.001 },
  ),
  maxDepth: integer('The most surfaces and scatterings that a path of light meets', {
    range: [1, 1024],
    slider: [1, 32],
  }),
  clamp: number(
    'The most radiance that a sample of indirect light brings, against bright specks; loses light; 0 does not bound it',
    { range: [0, 1e6], unit: 'nt', slider: [0, 100], step: 0.1 },
  ),
  seed: integer('Chooses the random numbers', { range: [0, 2 ** 32 - 1], slider: [0, 100] }),
};

export const cameraSchema = z.strictObject(cameraShape);
export const fogSchema = z.strictObject(fogShape);
export const viewSchema = z.strictObject(viewShape);
export const pathTracingSchema = z.strictObject(pathTracingShape);

export type Camera = z.output<typeof cameraSchema>;
export type Fog = z.output<typeof fogSchema>;
export type View = z.output<typeof viewSchema>;
export type PathTracing = z.output<typeof pathTracingSchema>;

export const cameraDefaults: Readonly<Camera> = {
  fov: 75,
  position: [0, 1.6, 4],
  target: [0, 0.5, 0],
  near: 0.05,
  far: 200,
  sensorHeight: 24,
  fStop: 0,
  shutter: 1 / 60,
  iso: 100,
  focusDistance: 0,
  apertureBlades: 0,
};
export const fogDefaults: Readonly<Fog> = {
  density: 0,
  color: [0.9, 0.9, 0.9],
  anisotropy: 0,
  height: 0,
  base: 0,
};
export const viewDefaults: Readonly<View> = {
  show: 'picture',
  exposureMode: 'manual',
  exposure: 0,
  toneMapping: 'neutral',
  resolutionScale: 1,
  targetFrameTime: 0,
  helpers: false,
  term: null,
};

export const pathTracingDefaults: Readonly<PathTracing> = {
  samples: 256,
  error: 0.01,
  maxDepth: 16,
  clamp: 0,
  seed: 0,
};

export const cameraFileSchema = withDefaults(cameraShape, cameraDefaults);
export const fogFileSchema = withDefaults(fogShape, fogDefaults);
export const viewFileSchema = withDefaults(viewShape, viewDefaults);
export const pathTracingFileSchema = withDefaults(pathTracingShape, pathTracingDefaults);
