/** What the path tracer puts over the viewport: the choice of the rendering, its figures, divider and difference. */
import type { Session } from '../session.ts';
import { h } from '../ui/dom.ts';
import { createDifference, type ImagePair } from './difference.ts';
import { createDivider } from './divider.ts';
import { createModeSwitch } from './mode-switch.ts';
import type { PathTracing } from './path-tracing.ts';
import { createProgress } from './progress.ts';

export function createPathTracingView(
  session: Session,
  tracing: PathTracing,
  readPair: () => Promise<ImagePair | null>,
): HTMLElement {
  return h(
    'div',
    { class: 'path-tracing' },
    createDifference(session, tracing, readPair),
    createDivider(session, tracing),
    h('div', { class: 'path-tracing-head' }, createModeSwitch(session), createProgress(session, tracing)),
  );
}
