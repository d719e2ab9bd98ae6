/** Makes the viewport show what is compared, as long as it is there. */
import type { MaterialFile } from '../../io/material-file.ts';
import type { RealtimeRenderer } from '../../realtime/renderer.ts';
import type { AssetLoader } from '../../scene/assets.ts';
import type { SceneMirror } from '../../scene/mirror.ts';
import type { Document } from '../../scene/schema.ts';
import { t } from '../language/language.ts';
import { contentOf } from '../panels/library/chosen.ts';
import type { Session } from '../session.ts';
import { toast, toastError } from '../ui/toast.ts';
import type { Viewport } from '../viewport/viewport.ts';
import { type Comparison, missingOf, withModel } from './comparison.ts';
import { SecondPicture } from './second-picture.ts';
import { createComparisonView } from './view.ts';

export interface ComparisonContext {
  readonly session: Session;
  readonly mirror: SceneMirror;
  readonly assets: AssetLoader;
  readonly renderer: RealtimeRenderer;
  readonly viewport: Viewport;
  readonly view: HTMLElement;
}

export function installComparison(context: ComparisonContext): void {
  const { session, mirror, assets, renderer, viewport, view } = context;
  const { store, state } = session;
  view.append(createComparisonView(session));
  let picture: SecondPicture | null = null;

  const end = () => {
    viewport.drawBeside(null);
    picture?.dispose();
    picture = null;
  };
  const show = (comparison: Comparison) => {
    const { document } = store;
    const missing = missingOf(document, comparison);
    const content = missing ? null : otherOf(document, comparison);
    if (!content) {
      state.set({ comparison: null });
      toast(
        'info',
        t('The comparison has ended'),
        missing === 'objects'
          ? t('No object has A any more.')
          : t('One of the materials is no longer there.'),
      );
      return;
    }
    picture ??= new SecondPicture({
      mirror,
      renderer,
      assets,
      onError: (message) => toast('error', t('A part of B is missing'), message),
    });
    const shown = picture;
    shown.show(document, content);
    const draw = () => {
      if (picture !== shown) return;
      shown.changed();
      viewport.drawBeside({
        draw: (settings, size, divider) => shown.draw(settings, comparison.material, size, divider),
        last: (divider) => shown.last(divider),
      });
    };
    draw();
    void shown.settled().then(draw);
  };
  const follow = () => {
    const { comparison } = state.value;
    try {
      if (comparison) show(comparison);
      else end();
    } catch (error) {
      state.set({ comparison: null });
      toastError(t('The materials cannot be compared'), error);
    }
  };
  state.subscribe((now, before) => {
    if (now.comparison !== before.comparison) follow();
  });
  store.subscribe(({ document, previous, reason }) => {
    const { comparison } = state.value;
    if (!comparison) return;
    if (reason === 'open') state.set({ comparison: null });
    else if (
      document.materials !== previous.materials ||
      missingOf(document, comparison) !== null ||
      document.models !== previous.models ||
      document.assets !== previous.assets
    )
      follow();
  });
  follow();
}

/** B with all that it needs; null when A or B has gone. */
function otherOf(document: Document, { material, other }: Comparison): MaterialFile | null {
  const own = document.materials[material];
  if (!own) return null;
  if (other.kind === 'model') return withModel(document, own, other.model);
  return contentOf(other, document) ?? null;
}
