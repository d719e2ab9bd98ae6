import '../../examples/materials.ts';

/** Brightness of the example's picture, 0..1, where each of its five spheres is; it runs by itself. */
export default async function example(): Promise<number[]> {
  for (let frame = 0; frame < 5; frame++) await new Promise(requestAnimationFrame);
  const canvas = document.querySelector('canvas') as HTMLCanvasElement;
  const { width, height } = canvas;
  const copy = Object.assign(document.createElement('canvas'), { width, height });
  const context = copy.getContext('2d') as CanvasRenderingContext2D;
  // A canvas's picture is there until its next frame begins.
  await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
  context.drawImage(canvas, 0, 0);
  return [-2, -1, 0, 1, 2].map((i) => {
    // The camera sees 4.8 units from top to bottom: 2 x 9 x tan(15 degrees).
    const x = Math.round(width / 2 + (i * 1.2 * height) / 4.82);
    const [r = 0, g = 0, b = 0] = context.getImageData(x, Math.round(height / 2), 1, 1).data;
    return (r + g + b) / (3 * 255);
  });
}
