/** What the path tracer puts over the viewport: the choice of the rendering, its figures, divider and difference. */
import type { Session } from '../session.ts';
import { h } from '../ui/dom.ts';
import { createDifference, type DifferenceView, type ImagePair } from './difference.ts';
import { createDivider } from './divider.ts';
import { createModeSwitch } from './mode-switch.ts';
import type { PathTracing } from './path-tracing.ts';
import { createProgress } from './progress.ts';

export interface PathTracingView {
  readonly element: HTMLElement;
  /** What the viewport shows in place of a picture, if it does. */
  readonly difference: DifferenceView;
}

export function createPathTracingView(
  session: Session,
  tracing: PathTracing,
  readPair: () => Promise<ImagePair | null>,
  onMap: () => void,
): PathTracingView {
  const difference = createDifference(session, tracing, readPair, onMap);
  const element = h(
    'div',
    { class: 'path-tracing' },
    difference.element,
    createDivider(session, tracing),
    h('div', { class: 'path-tracing-head' }, createModeSwitch(session), createProgress(session, tracing)),
  );
  return { element, difference };
}
