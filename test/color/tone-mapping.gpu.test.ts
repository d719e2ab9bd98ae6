import { DataTexture, FloatType, RenderTarget, RGBAFormat, UnsignedByteType } from 'three/webgpu';
import { expect, test } from 'vitest';
import { type Display, displayPixels, TONE_MAPPINGS } from '../../src/color/tone-mapping.ts';
import { OutputPass } from '../../src/realtime/output-pass.ts';
import { testRenderer } from '../support/gpu.ts';

const SIDE = 64;
const { renderer } = await testRenderer(SIDE, SIDE);

/** Colours of all hues from black to far beyond white, and grays. */
const radiance = new Float32Array(3 * SIDE * SIDE).map((_, i) => {
  const [pixel, channel] = [Math.floor(i / 3), i % 3];
  const [x, y] = [pixel % SIDE, Math.floor(pixel / SIDE)];
  const luminance = 2 ** (-12 + (18 * y) / SIDE);
  const hue = 1 + Math.cos(2 * Math.PI * (x / (SIDE - 8) - channel / 3));
  return y === 0 ? 0 : luminance * (x < 8 ? 1 : hue);
});

async function both(display: Display) {
  const rgba = new Float32Array(4 * SIDE * SIDE).fill(1);
  for (let i = 0; i < SIDE * SIDE; i++) rgba.set(radiance.subarray(3 * i, 3 * i + 3), 4 * i);
  const texture = new DataTexture(rgba, SIDE, SIDE, RGBAFormat, FloatType);
  texture.needsUpdate = true;
  const pass = new OutputPass(texture);
  const target = new RenderTarget(SIDE, SIDE, { type: UnsignedByteType, depthBuffer: false });
  renderer.setRenderTarget(target);
  pass.render(renderer, texture, { ...display, show: display.falseColor ? 'luminance' : 'picture' });
  renderer.setRenderTarget(null);
  const shown = (await renderer.readRenderTargetPixelsAsync(target, 0, 0, SIDE, SIDE)) as Uint8Array;
  pass.dispose();
  target.dispose();
  return { shown, computed: displayPixels(radiance, display) };
}

test.each(TONE_MAPPINGS)('%s on the CPU is what the GPU shows', async (toneMapping) => {
  const { shown, computed } = await both({ exposure: 0.7, toneMapping });
  const difference = Math.max(...shown.map((value, i) => Math.abs(value - computed[i]!)));
  expect(difference).toBeLessThanOrEqual(1);
  expect(new Set(computed).size).toBeGreaterThan(200);
});

test('false colours on the CPU are what the GPU shows', async () => {
  const { shown, computed } = await both({ exposure: 0.7, toneMapping: 'none', falseColor: true });
  // Where a luminance is just between two zones, float32 may choose the other one.
  const differing = shown.filter((value, i) => Math.abs(value - computed[i]!) > 1).length;
  expect(differing / shown.length).toBeLessThan(0.005);
  const zones = new Set(
    Array.from({ length: SIDE * SIDE }, (_, i) => computed.slice(4 * i, 4 * i + 3).join(' ')),
  );
  expect(zones.size).toBe(13);
});
