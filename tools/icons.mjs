/** Draws the icons of the installed lab from its one drawing: `node tools/icons.mjs`. */
import { readFileSync, writeFileSync } from 'node:fs';
import sharp from 'sharp';

const editor = new URL('../src/editor/', import.meta.url);
const drawing = readFileSync(new URL('icon.svg', editor), 'utf8');
/** Of the page's panels. */
const GROUND = '#191b1f';

/** `share` is the part of the width that the drawing has; the rest is ground, or nothing. */
async function draw(name, size, share, ground) {
  const side = Math.round(size * share);
  const picture = await sharp(Buffer.from(drawing), { density: (72 * side) / 32 })
    .resize(side, side)
    .png()
    .toBuffer();
  const background = ground ?? { r: 0, g: 0, b: 0, alpha: 0 };
  const icon = await sharp({ create: { width: size, height: size, channels: 4, background } })
    .composite([{ input: picture, gravity: 'centre' }])
    .png({ compressionLevel: 9, palette: true })
    .toBuffer();
  writeFileSync(new URL(`pwa/${name}`, editor), icon);
}

await draw('icon-192.png', 192, 1);
await draw('icon-512.png', 512, 1);
// Systems cut these to a shape of their own; the middle four fifths are safe.
await draw('icon-maskable-512.png', 512, 0.8, GROUND);
await draw('icon-apple-180.png', 180, 0.86, GROUND);
