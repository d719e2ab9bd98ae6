/** Brightness of the example's picture, 0..1, where each of its five spheres is; it runs by itself. */
export default async function example(): Promise<number[]> {
  const frame = requestAnimationFrame.bind(window);
  const copy = document.createElement('canvas');
  const context = copy.getContext('2d', { willReadFrequently: true }) as CanvasRenderingContext2D;
  const pixel = (x: number) => context.getImageData(Math.round(x), Math.round(copy.height / 2), 1, 1).data;
  const drawn = new Promise<void>((resolve) => {
    window.requestAnimationFrame = (callback) =>
      frame(() => {
        // One of the materials changes with the time of its frames.
        callback(0);
        // A canvas's picture is there until its next frame begins; the GPU may take a while to give the first.
        const canvas = document.querySelector('canvas');
        if (!canvas) return;
        [copy.width, copy.height] = [canvas.width, canvas.height];
        context.drawImage(canvas, 0, 0);
        if (pixel(copy.width / 2)[3] !== 0) resolve();
      });
  });
  await import('../../examples/materials.ts');
  await drawn;
  return [-2, -1, 0, 1, 2].map((i) => {
    // The camera sees 4.8 units from top to bottom: 2 x 9 x tan(15 degrees).
    const [r = 0, g = 0, b = 0] = pixel(copy.width / 2 + (i * 1.2 * copy.height) / 4.82);
    return (r + g + b) / (3 * 255);
  });
}
