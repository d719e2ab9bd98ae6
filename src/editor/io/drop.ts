/** Dropping files anywhere on the page; while they hover, the viewport says what it takes. */
import { measuredExtensions } from '../../scene/measured.ts';
import { t } from '../language/language.ts';
import { h } from '../ui/dom.ts';
import { droppedFiles } from './dropped-files.ts';

export function installDrop(viewport: HTMLElement, onFiles: (files: File[]) => void): void {
  const measured = measuredExtensions.map((extension) => `.${extension}`).join(' ');
  const target = h(
    'div',
    { class: 'drop-target', hidden: true },
    h('strong', {}, t('Drop to open')),
    h(
      'p',
      {},
      t(
        'Scene .json, three.js .json · model .glb .gltf .obj .ply .stl · folder, .zip · BRDF .brdf .bparam {measured} · environment .hdr .exr .jpg .png',
        { measured },
      ),
    ),
  );
  viewport.append(target);
  const hasFiles = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false;

  window.addEventListener('dragover', (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    target.hidden = false;
  });
  window.addEventListener('dragleave', (event) => {
    if (event.relatedTarget === null) target.hidden = true;
  });
  // A texture slot keeps its own drop to itself and says so with this event.
  window.addEventListener('dragend', () => {
    target.hidden = true;
  });
  window.addEventListener('drop', (event) => {
    target.hidden = true;
    if (!hasFiles(event)) return;
    event.preventDefault();
    if (event.dataTransfer) void droppedFiles(event.dataTransfer).then(onFiles);
  });
}
