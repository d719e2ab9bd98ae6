import { Color, Mesh, MeshBasicNodeMaterial, PerspectiveCamera, PlaneGeometry, Scene } from 'three/webgpu';
import { OutlinePass } from '../../src/realtime/outline/outline-pass.ts';
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
  return { scene, camera, upperHalf };
}

export const SIZE = { width: 31, height: 16 };

export interface FrameRequest {
  forceWebGL: boolean;
  view: ViewSettings;
}

export interface Frame {
  backend: string;
  radiance: { width: number; height: number; pixels: number[] };
  /** As it is read back once there is an outline on the canvas. */
  image: number[];
  /** What is on the canvas, with a red outline of 2 pixels and a black halo of 1 around the upper half. */
  outlined: number[];
}

export default async function frame({ forceWebGL, view }: FrameRequest): Promise<Frame> {
  const renderer = await createRenderer({ forceWebGL });
  const content = halves();
  await renderer.compile(content, { view }, SIZE);
  renderer.render(content, { view }, SIZE);
  new OutlinePass().render(renderer.three, content.camera, {
    front: { meshes: [content.upperHalf], color: '#f00', width: 2 },
    back: { meshes: [], color: '#0f0', width: 2 },
    halo: { width: 1, opacity: 1 },
  });
  const copy = new OffscreenCanvas(SIZE.width, SIZE.height).getContext('2d')!;
  // Readable in the task that drew it.
  copy.drawImage(renderer.canvas, 0, 0);
  const outlined = [...copy.getImageData(0, 0, SIZE.width, SIZE.height).data];
  const { pixels, ...size } = await renderer.readRadiance();
  const image = [...(await renderer.readImage(view))];
  return { backend: renderer.backend, radiance: { ...size, pixels: [...pixels] }, image, outlined };
}
