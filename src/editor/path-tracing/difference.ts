/** placeholder */
import type { Session } from '../session.ts';
import { h } from '../ui/dom.ts';
import type { PathTracing } from './path-tracing.ts';

/** Both renderings as a screen shows them: RGBA bytes in sRGB, row 0 at the top. */
export interface ImagePair {
  readonly width: number;
  readonly height: number;
  readonly interactive: Uint8Array;
  readonly traced: Uint8Array;
}

export function createDifference(
  _session: Session,
  _tracing: PathTracing,
  _readPair: () => Promise<ImagePair | null>,
): HTMLElement {
  return h('div', { class: 'difference', hidden: true });
}
