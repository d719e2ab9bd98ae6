/**
 * The small square beside a value where its texture goes: empty, or a thumbnail. A click chooses
 * an image or shows how it is laid on; an image may be dropped on it.
 */
import type { Parameter } from '../../../brdf/model.ts';
import { keepAsset } from '../../../scene/commands.ts';
import {
  type MaterialMap,
  scaledTextureShape,
  type TextureRef,
  textureRef,
} from '../../../scene/material-schema.ts';
import { isPattern, patternNames } from '../../../scene/pattern/asset.ts';
import type { Document, Material } from '../../../scene/schema.ts';
import { attempt } from '../../commands.ts';
import { assetUrl, IMAGE_ACCEPT, isImageFile, readAsset } from '../../io/files.ts';
import { t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { icon } from '../../ui/icons.ts';
import { openPopup } from '../../ui/popup.ts';
import { toast, toastError } from '../../ui/toast.ts';
import { pathCell, tryEdit } from './cell.ts';
import { type Bound, labelOf, shapeFields } from './field.ts';

export type SlotPlace = { parameter: Parameter } | { map: MaterialMap };

export function textureSlot(session: Session, id: string, place: SlotPlace): Bound {
  const { store } = session;
  const label = labelOf('map' in place ? place.map : place.parameter.name);
  const button = h(
    'button',
    { type: 'button', class: 'texture-slot', 'aria-label': t('Texture of {label}', { label }) },
    icon('imageAdd'),
  );

  const current = (): TextureRef | null => readSlot(store.document.materials[id], place);
  const put = async (file: File) => {
    try {
      const asset = await readAsset(file);
      // What cannot be decoded must not get into the document.
      (await createImageBitmap(file)).close();
      tryEdit(store, t('Texture of {label}', { label: label.toLowerCase() }), (draft) => {
        const target = draft.materials[id];
        if (!target) return;
        const assetId = keepAsset(draft, asset);
        writeSlot(target, place, {
          ...(current() ?? textureRef(assetId, guess(place))),
          asset: assetId,
          texture: null,
        });
      });
    } catch (error) {
      toastError(t('{file} could not be read', { file: file.name }), error);
    }
  };
  const choose = async () => {
    const [file] = await session.chooseFiles(IMAGE_ACCEPT);
    if (file) await put(file);
  };
  const clear = () =>
    tryEdit(store, t('Remove texture of {label}', { label: label.toLowerCase() }), (draft) => {
      const target = draft.materials[id];
      if (target) writeSlot(target, place, null);
    });

  const replace = () => openSources(session, id, place, label, button, choose);

  button.addEventListener('click', () => {
    if (current()) openTexturePopup(session, id, place, label, button, { replace, clear });
    else replace();
  });
  button.addEventListener('dragover', (event) => {
    event.preventDefault();
    event.stopPropagation();
    button.classList.add('over');
  });
  button.addEventListener('dragleave', () => button.classList.remove('over'));
  button.addEventListener('drop', (event) => {
    event.preventDefault();
    event.stopPropagation();
    button.classList.remove('over');
    window.dispatchEvent(new Event('dragend'));
    const file = event.dataTransfer?.files[0];
    if (file && isImageFile(file)) void put(file);
    else if (file)
      toast(
        'error',
        t('{file} is not an image', { file: file.name }),
        t('Drop a PNG, JPEG, WebP or AVIF file here.'),
      );
  });

  let shown: TextureRef | null | undefined;
  return {
    element: button,
    update() {
      const texture = current();
      if (texture === shown) return;
      shown = texture;
      button.classList.toggle('filled', texture !== null);
      button.dataset.tip = texture
        ? t('{name}\nClick to lay it out, replace or remove it', {
            name: store.document.assets[texture.asset]?.name ?? texture.asset,
          })
        : t('Add a texture to {label}: click, or drop an image here', { label: label.toLowerCase() });
      const url = texture && assetUrl(store.document, texture.asset);
      button.replaceChildren(url ? h('img', { src: url, alt: '' }) : icon(texture ? 'image' : 'imageAdd'));
    },
  };
}

function openTexturePopup(
  session: Session,
  id: string,
  place: SlotPlace,
  label: string,
  anchor: HTMLElement,
  actions: { replace(): void; clear(): void },
): void {
  const { store } = session;
  const path =
    'map' in place ? ['materials', id, place.map] : ['materials', id, 'textures', place.parameter.name];
  const takesChannel = 'parameter' in place && place.parameter.type === 'float';
  const fields = shapeFields(scaledTextureShape, {
    cell: (name, field) =>
      pathCell(
        store,
        [...path, name],
        t('Change {label} {field}', { label: label.toLowerCase(), field: field.toLowerCase() }),
      ),
    skip: ['asset', 'texture', 'scale', ...(takesChannel ? [] : ['channel'])],
  });
  const update = () => {
    if (!readSlot(store.document.materials[id], place)) {
      close();
      return;
    }
    for (const field of fields) field.update();
    ofPattern?.update();
  };
  const replace = h('button', { type: 'button', class: 'text-button' }, t('Replace…'));
  const remove = h('button', { type: 'button', class: 'text-button' }, t('Remove'));
  const pattern = h('div', { class: 'pattern-fields' });
  const content = h(
    'div',
    { class: 'texture-popup' },
    h('strong', {}, t('{label} texture', { label })),
    ...fields.map((field) => field.element),
    pattern,
    h('div', { class: 'popup-actions' }, replace, remove),
  );
  const unsubscribe = store.subscribe(update);
  const close = openPopup({ anchor, content, label: t('{label} texture', { label }), onClose: unsubscribe });
  replace.addEventListener('click', () => {
    close();
    actions.replace();
  });
  remove.addEventListener('click', () => {
    close();
    actions.clear();
  });
  let ofPattern: Bound | null = null;
  update();
  const ref = readSlot(store.document.materials[id], place);
  if (ref && isPattern(store.document.assets[ref.asset]))
    void import('./pattern-fields.ts').then(({ patternFields }) => {
      ofPattern = patternFields(session, id, () => readSlot(store.document.materials[id], place)?.asset);
      pattern.replaceChildren(ofPattern.element);
    });
}

/** Where a texture comes from: a file, or a pattern. */
function openSources(
  session: Session,
  id: string,
  place: SlotPlace,
  label: string,
  anchor: HTMLElement,
  choose: () => Promise<void>,
): void {
  const file = h('button', { type: 'button', class: 'text-button primary' }, t('Image…'));
  const patterns = patternNames.map((name) => {
    const button = h('button', { type: 'button', class: 'text-button' }, labelOf(name));
    button.addEventListener('click', async () => {
      close();
      const { givePattern } = await import('../../../scene/pattern-commands.ts');
      const where = 'map' in place ? place : { parameter: place.parameter.name };
      attempt(t('The material stays as it was'), () =>
        givePattern(session.store, id, where, name, t('Texture of {label}', { label: label.toLowerCase() })),
      );
    });
    return button;
  });
  const content = h(
    'div',
    { class: 'texture-popup' },
    h('strong', {}, t('{label} texture', { label })),
    h('div', { class: 'popup-actions' }, file),
    h('p', { class: 'hint' }, t('Or a pattern, which is computed:')),
    h('div', { class: 'pattern-choices' }, ...patterns),
  );
  const close = openPopup({ anchor, content, label: t('{label} texture', { label }) });
  file.addEventListener('click', () => {
    close();
    void choose();
  });
}

function readSlot(material: Material | undefined, place: SlotPlace): TextureRef | null {
  if (!material) return null;
  return 'map' in place ? material[place.map] : (material.textures[place.parameter.name] ?? null);
}

function writeSlot(
  material: Document['materials'][string],
  place: SlotPlace,
  texture: TextureRef | null,
): void {
  if ('map' in place) material[place.map] = texture && { scale: 1, ...texture };
  else if (texture) material.textures[place.parameter.name] = texture;
  else delete material.textures[place.parameter.name];
}

/** Colours come as sRGB images; numbers as the data in one channel. */
function guess(place: SlotPlace): Partial<TextureRef> {
  const isColor = 'map' in place ? place.map === 'emissiveMap' : place.parameter.type === 'color';
  const isNumber = 'parameter' in place && place.parameter.type === 'float';
  return { colorSpace: isColor ? 'srgb' : 'linear', channel: isNumber ? 'r' : null };
}
