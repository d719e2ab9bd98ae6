import { createRenderer } from '../../src/realtime/renderer.ts';
import { compareRepeated, type Likeness } from './repeated.ts';

export default async function repeated(options: {
  readonly forceWebGL: boolean;
}): Promise<Readonly<Record<string, Likeness>>> {
  const renderer = await createRenderer({ ...options, samples: 1 });
  return compareRepeated(renderer, ['at first', 'all shown, and far more']);
}
