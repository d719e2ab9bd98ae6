/** In the outliner and in the inspector, materials are shown by their pictures, and can be dragged onto objects. */
import type { SceneMirror } from '../../../scene/mirror.ts';
import type { Session } from '../../session.ts';
import { endDrag, startDrag } from './drag.ts';
import { sceneJob } from './scene-job.ts';
import { keyOf } from './thumbnail-job.ts';
import { drawThumbnail, type Thumbnails, thumbnailCanvas } from './thumbnails.ts';

export interface PicturePlaces {
  readonly outliner: HTMLElement;
  readonly inspector: HTMLElement;
}

/** After an edit. */
const REST_MS = 300;
const KIND = 'materials/';

/** Where there is a picture. */
interface Place {
  readonly selector: string;
  /** Pixels: sharp on a screen of twice as many as there is room for. */
  readonly size: number;
  material(element: HTMLElement): string;
  put(element: HTMLElement, canvas: HTMLCanvasElement): void;
}

const ROW: Place = {
  selector: `[data-entity^="${KIND}"]`,
  size: 40,
  material: ({ dataset }) => dataset.entity?.slice(KIND.length) ?? '',
  // Beside the icon, which is seen until the picture has come.
  put: (element, canvas) => element.querySelector(':scope > .icon')?.after(canvas),
};
const PREVIEW: Place = {
  selector: '[data-preview]',
  size: 132,
  material: ({ dataset }) => dataset.preview ?? '',
  put: (element, canvas) => element.replaceChildren(canvas),
};

export function installScenePictures(
  { store }: Session,
  { outliner, inspector }: PicturePlaces,
  mirror: SceneMirror,
  thumbnails: Thumbnails,
): void {
  const shown = new WeakMap<HTMLCanvasElement, string | null>();
  const places = [
    [outliner, ROW],
    [inspector, PREVIEW],
  ] as const;

  const show = (element: HTMLElement, place: Place) => {
    const job = sceneJob(store.document, mirror, place.material(element));
    if (!job) return;
    let canvas = element.querySelector<HTMLCanvasElement>('.material-picture');
    if (!canvas) {
      canvas = thumbnailCanvas(place.size);
      place.put(element, canvas);
      element.draggable = true;
    }
    const picture = canvas;
    const key = keyOf(job, place.size);
    if (shown.get(picture) === key) return;
    shown.set(picture, key);
    void thumbnails.picture(job, place.size).then((pixels) => {
      if (shown.get(picture) === key) drawThumbnail(picture, pixels);
    });
  };
  const showIn = (root: HTMLElement, place: Place) => {
    for (const element of root.querySelectorAll<HTMLElement>(place.selector)) show(element, place);
  };
  const showAll = () => {
    for (const [root, place] of places) showIn(root, place);
  };
  let timer = 0;
  const later = () => {
    clearTimeout(timer);
    timer = window.setTimeout(() => void mirror.settled().then(showAll), REST_MS);
  };
  store.subscribe(({ document, previous }) => {
    if (document.materials !== previous.materials || document.models !== previous.models) later();
  });
  for (const [root, place] of places) {
    // Rows come and go as the outliner is scrolled, and the inspector is made anew for what is selected.
    new MutationObserver((changes) => {
      for (const { addedNodes } of changes)
        for (const node of addedNodes) {
          if (!(node instanceof HTMLElement)) continue;
          if (node.matches(place.selector)) show(node, place);
          else showIn(node, place);
        }
    }).observe(root, { childList: true, subtree: true });
    root.addEventListener('dragstart', (event) => {
      const element = event.target instanceof HTMLElement ? event.target : null;
      if (!element?.matches(place.selector)) return;
      const id = place.material(element);
      const name = store.document.materials[id]?.name;
      if (name !== undefined)
        startDrag(
          event,
          { kind: 'scene', id },
          name,
          element.querySelector<HTMLElement>('canvas') ?? element,
        );
    });
    root.addEventListener('dragend', endDrag);
  }
  void mirror.settled().then(showAll);
}
