/** What there is for materials beside their sliders; all of it comes with this module, which is loaded late. */
import type { RealtimeRenderer } from '../../../realtime/renderer.ts';
import type { AssetLoader } from '../../../scene/assets.ts';
import type { SceneMirror } from '../../../scene/mirror.ts';
import { comparisonEntries } from '../../compare/entries.ts';
import { installComparison } from '../../compare/install.ts';
import { t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { openMenu } from '../../ui/menu.ts';
import type { Viewport } from '../../viewport/viewport.ts';
import { pictureJob } from './chosen.ts';
import { installDropTarget } from './drop-target.ts';
import { createLibrary, type LibraryPanel } from './library.ts';
import { sceneJob } from './scene-job.ts';
import { installScenePictures } from './scene-pictures.ts';
import { Thumbnails } from './thumbnails.ts';
import { nextSeed, openVary, randomise } from './vary.ts';

export interface MaterialContext {
  readonly session: Session;
  readonly mirror: SceneMirror;
  readonly assets: AssetLoader;
  /** The picture's element. */
  readonly view: HTMLElement;
  readonly outliner: HTMLElement;
  readonly inspector: HTMLElement;
  /** Null until they have started, and where they cannot. */
  renderer(): RealtimeRenderer | null;
  viewport(): Viewport | null;
}

export interface MaterialTools {
  readonly library: LibraryPanel;
  vary(id: string): void;
  /** Asks what to compare it with. */
  compare(id: string): void;
  randomise(id: string): void;
}

export function createMaterialTools(context: MaterialContext): MaterialTools {
  const { session, mirror, assets, view } = context;
  const thumbnails = new Thumbnails();
  const library = createLibrary(session, thumbnails, (offer) =>
    offer.kind === 'scene'
      ? sceneJob(session.store.document, mirror, offer.id)
      : pictureJob(offer, session.store.document),
  );
  document.getElementById('app')?.append(library.element);
  installDropTarget(session, view, mirror);
  installScenePictures(session, context, mirror, thumbnails);
  // Not before somebody wants one, by when the renderer has started.
  const compareFirst = session.state.subscribe(({ comparison }) => {
    const [renderer, viewport] = [context.renderer(), context.viewport()];
    if (!comparison || !renderer || !viewport) return;
    compareFirst();
    installComparison({ session, mirror, assets, renderer, viewport, view });
  });
  return {
    library,
    compare(id) {
      const anchor = document.querySelector<HTMLElement>('[data-keys="material.compare"]') ?? view;
      openMenu(anchor, t('Compare with'), comparisonEntries(session, id, library.open));
    },
    vary: (id) => void openVary(session, thumbnails, id),
    randomise(id) {
      nextSeed();
      randomise(session, id);
    },
  };
}
