/** A material that is dragged over the picture goes to the object under the pointer, which is framed meanwhile. */
import { Box3 } from 'three/webgpu';
import type { SceneMirror } from '../../../scene/mirror.ts';
import { t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { ignoreEnd } from '../../threads/thread.ts';
import { h } from '../../ui/dom.ts';
import { boxCorners } from '../../viewport/light-lines.ts';
import { createProjector } from '../../viewport/projector.ts';
import { type Picked, pickAlong, rayAt, whenPicked } from '../../viewport/selecting/picking.ts';
import { giveToObjects, titleOf } from './chosen.ts';
import { DRAG_TYPE, draggedOffer, endDrag } from './drag.ts';

const SVG = 'http://www.w3.org/2000/svg';

export function installDropTarget(session: Session, view: HTMLElement, mirror: SceneMirror): void {
  const { store, state } = session;
  const frame = document.createElementNS(SVG, 'svg');
  frame.setAttribute('class', 'material-drop-frame');
  const lines = document.createElementNS(SVG, 'path');
  frame.append(lines);
  const label = h('div', { class: 'material-drop-label' });
  const element = h('div', { class: 'material-drop', hidden: true }, label);
  element.prepend(frame);
  view.append(element);
  let target: string | null = null;

  const isMaterial = (event: DragEvent) =>
    draggedOffer() !== null && event.dataTransfer?.types.includes(DRAG_TYPE) === true;
  const rayOf = ({ clientX, clientY }: DragEvent) => {
    const { left, top, width, height } = view.getBoundingClientRect();
    return rayAt(mirror, ((clientX - left) / width) * 2 - 1, 1 - ((clientY - top) / height) * 2);
  };
  const first = (picked: readonly Picked[]): string | null =>
    picked.find(({ id }) => !store.document.objects[id]?.locked)?.id ?? null;
  const show = (id: string | null) => {
    const offer = draggedOffer();
    element.hidden = id === null || offer === null;
    if (id === target || id === null || offer === null) {
      target = id;
      return;
    }
    target = id;
    const object = mirror.objectFor(id);
    if (!object) return;
    if (!object.geometry.boundingBox) object.geometry.computeBoundingBox();
    const projector = createProjector(mirror.camera, view.clientWidth, view.clientHeight);
    const box = object.geometry.boundingBox ?? new Box3();
    lines.setAttribute(
      'd',
      boxCorners(box, object.matrixWorld)
        .map(([from, to]) => from && to && projector.segment(from, to))
        .map((ends) =>
          ends ? `M${ends.map(({ x, y }) => `${x.toFixed(1)} ${y.toFixed(1)}`).join('L')}` : '',
        )
        .join(''),
    );
    label.textContent = t('{material} for {object}', {
      material: titleOf(offer, store.document),
      object: store.document.objects[id]?.name ?? '',
    });
  };

  view.addEventListener('dragover', (event) => {
    if (!isMaterial(event)) return;
    event.preventDefault();
    if (event.dataTransfer) event.dataTransfer.dropEffect = 'copy';
    const picked = pickAlong(mirror, rayOf(event));
    // Until it is known what is there, the browser asks again.
    if (!(picked instanceof Promise)) show(first(picked));
  });
  view.addEventListener('dragleave', (event) => {
    if (!(event.relatedTarget instanceof Node && view.contains(event.relatedTarget))) show(null);
  });
  view.addEventListener('drop', (event) => {
    const offer = draggedOffer();
    if (!isMaterial(event) || !offer) return;
    event.preventDefault();
    show(null);
    endDrag();
    void whenPicked(
      mirror,
      rayOf(event),
      () => [store.document.objects],
      (picked) => {
        const id = first(picked);
        if (id === null) return;
        giveToObjects(session, offer, [id]);
        state.select({ kind: 'objects', id });
      },
    ).catch(ignoreEnd);
  });
  window.addEventListener('dragend', () => {
    endDrag();
    show(null);
  });
}
