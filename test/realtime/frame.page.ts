import { Color, Mesh, MeshBasicNodeMaterial, PerspectiveCamera, PlaneGeometry, Scene } from 'three/webgpu';
import { createRenderer, type ViewSettings } from '../../src/realtime/renderer.ts';

/** A frame whose upper half has the radiance (8, 0.5, 0.125) and whose lower half shows the background. */
export function halves() {
  const scene = new Scene();
  scene.background = new Color().setRGB(0, 0, 0.25);
  const camera = new PerspectiveCamera(90, 1, 0.1, 10);
  const material = new MeshBasicNodeMaterial({ color: new Color().setRGB(8, 0.5, 0.125) });
  const upperHalf = new Mesh(new PlaneGeometry(100, 1), material);
  upperHalf.position.set(0, 0.5, -1);
  scene.add(upperHalf);
  return { scene, camera };
}

export const SIZE = { width: 31, height: 16 };

export interface FrameRequest {
  forceWebGL: boolean;
  view: ViewSettings;
}

export interface Frame {
  backend: string;
  radiance: { width: number; height: number; pixels: number[] };
  image: number[];
}

export default async function frame({ forceWebGL, view }: FrameRequest): Promise<Frame> {
  const renderer = await createRenderer({ forceWebGL });
  const content = halves();
  await renderer.compile(content, { view }, SIZE);
  renderer.render(content, { view }, SIZE);
  const { pixels, ...size } = await renderer.readRadiance();
  const image = await renderer.readImage(view);
  return { backend: renderer.backend, radiance: { ...size, pixels: [...pixels] }, image: [...image] };
}
