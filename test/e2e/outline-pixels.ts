import sharp from 'sharp';
import type { LabPage } from './lab.ts';

/** How many pixels of a PNG have the colour that the outline of the last chosen has; tools and lamps have others. */
export async function outlinePixels(png: Uint8Array): Promise<number> {
  const data = await sharp(png).removeAlpha().raw().toBuffer();
  let count = 0;
  for (let i = 0; i < data.length; i += 3)
    if (data[i] === 0xf6 && data[i + 1] === 0xa9 && data[i + 2] === 0x3b) count++;
  return count;
}

/** On the screen. */
export async function outlinedOn({ page }: LabPage, canvas = '.viewport canvas'): Promise<number> {
  return outlinePixels(await page.locator(canvas).first().screenshot());
}
