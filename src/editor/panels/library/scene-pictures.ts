/** In the outliner, materials are shown by their pictures, and can be dragged onto objects. */
import type { SceneMirror } from '../../../scene/mirror.ts';
import type { Session } from '../../session.ts';
import { endDrag, startDrag } from './drag.ts';
import { sceneJob } from './scene-job.ts';
import { keyOf } from './thumbnail-job.ts';
import { drawThumbnail, type Thumbnails, thumbnailCanvas } from './thumbnails.ts';

/** Pixels: sharp on a screen of twice as many as a row has room for. */
const SIZE = 40;
/** After an edit. */
const REST_MS = 300;
const KIND = 'materials/';

export function installScenePictures(
  { store }: Session,
  outliner: HTMLElement,
  mirror: SceneMirror,
  thumbnails: Thumbnails,
): void {
  const shown = new WeakMap<HTMLCanvasElement, string | null>();

  const show = (row: HTMLElement) => {
    const id = row.dataset.entity?.slice(KIND.length) ?? '';
    const job = sceneJob(store.document, mirror, id);
    if (!job) return;
    let canvas = row.querySelector<HTMLCanvasElement>('.material-picture');
    if (!canvas) {
      canvas = thumbnailCanvas(SIZE);
      // Beside the icon, which is seen until the picture has come.
      row.querySelector(':scope > .icon')?.after(canvas);
      row.draggable = true;
    }
    const picture = canvas;
    const key = keyOf(job, SIZE);
    if (shown.get(picture) === key) return;
    shown.set(picture, key);
    void thumbnails.picture(job, SIZE).then((pixels) => {
      if (shown.get(picture) === key) drawThumbnail(picture, pixels);
    });
  };
  const showAll = () => {
    for (const row of outliner.querySelectorAll<HTMLElement>(`[data-entity^="${KIND}"]`)) show(row);
  };
  let timer = 0;
  const later = () => {
    clearTimeout(timer);
    timer = window.setTimeout(() => void mirror.settled().then(showAll), REST_MS);
  };
  store.subscribe(({ document, previous }) => {
    if (document.materials !== previous.materials || document.models !== previous.models) later();
  });
  // Rows come and go as the outliner is scrolled.
  new MutationObserver((changes) => {
    const rows = changes.flatMap(({ addedNodes }) => [...addedNodes]);
    for (const row of rows) if (row instanceof HTMLElement && row.dataset.entity?.startsWith(KIND)) show(row);
  }).observe(outliner, { childList: true, subtree: true });
  outliner.addEventListener('dragstart', (event) => {
    const row = event.target instanceof HTMLElement ? event.target : null;
    if (!row?.dataset.entity?.startsWith(KIND)) return;
    const id = row.dataset.entity.slice(KIND.length);
    const name = store.document.materials[id]?.name;
    if (name !== undefined)
      startDrag(event, { kind: 'scene', id }, name, row.querySelector<HTMLElement>('canvas') ?? row);
  });
  outliner.addEventListener('dragend', endDrag);
  void mirror.settled().then(showAll);
}
