/** The dialog that asks how large a picture shall be, shows how far it is, and hands it over. */
import { download, fileNameOf } from '../../io/files.ts';
import { t } from '../../language/language.ts';
import { h } from '../../ui/dom.ts';
import { row, selectField } from '../../ui/fields.ts';
import { numberField } from '../../ui/number-field.ts';
import { toast, toastError } from '../../ui/toast.ts';
import { makePicture, type PictureContext, type PictureRequest } from './picture.ts';
import type { PictureFormat } from './picture-messages.ts';
import { MOST_TRACED_PIXELS } from './traced.ts';

/** The most a canvas and a texture of any browser in use take. */
const LARGEST_SIDE = 16_384;

const SIZES = [
  { value: '1', label: t('As the viewport') },
  { value: '2', label: t('Twice the viewport') },
  { value: '4', label: t('Four times the viewport') },
  { value: '1920x1080', label: t('1920 × 1080, full HD') },
  { value: '3840x2160', label: '3840 × 2160, 4K' },
  { value: '7680x4320', label: '7680 × 4320, 8K' },
  { value: 'own', label: t('Of your own') },
];

/** Rounded down, so that a limit is never said to be more than it is. */
const megapixels = (pixels: number): string => (Math.floor(pixels / 1e5) / 10).toFixed(1);

/** The largest picture of these proportions that has so many pixels at most. */
function largestOf(width: number, height: number, pixels: number): { width: number; height: number } {
  const scale = Math.min(1, Math.sqrt(pixels / (width * height)));
  return { width: Math.max(1, Math.floor(width * scale)), height: Math.max(1, Math.floor(height * scale)) };
}

export function openPictureDialog(context: PictureContext): void {
  const { document: scene, renderer } = context;
  const { width, height } = renderer.canvas;
  const request: { -readonly [K in keyof PictureRequest]: PictureRequest[K] } = {
    source: 'interactive',
    format: 'png',
    width,
    height,
    samples: scene.pathTracing.samples,
  };
  let running: AbortController | null = null;

  const side = (key: 'width' | 'height', label: string) => {
    const field = numberField({
      label,
      min: 1,
      max: LARGEST_SIDE,
      step: 1,
      integer: true,
      onChange(value) {
        request[key] = value;
        size.show('own');
        update();
      },
    });
    return field;
  };
  const [widthField, heightField] = [side('width', t('Width')), side('height', t('Height'))];
  const size = selectField(t('Size'), SIZES, (value) => {
    const [w, h] = value.split('x').map(Number);
    if (value !== 'own') {
      request.width = h ? (w as number) : width * Number(value);
      request.height = h ?? height * Number(value);
    }
    update();
  });
  const source = selectField(
    t('Picture'),
    [
      { value: 'interactive', label: t('Interactive') },
      { value: 'traced', label: t('Path traced') },
    ],
    (value) => {
      request.source = value as PictureRequest['source'];
      update();
    },
  );
  const samples = numberField({
    label: t('Samples'),
    min: 1,
    max: 65_536,
    step: 1,
    integer: true,
    onChange: (value) => {
      request.samples = value;
    },
  });
  const format = selectField(
    t('Format'),
    [
      { value: 'png', label: t('PNG, as the screen shows it') },
      { value: 'jpg', label: t('JPEG, as the screen shows it') },
      { value: 'exr', label: t('EXR, linear radiance') },
    ],
    (value) => {
      request.format = value as PictureFormat;
    },
  );
  const samplesRow = row({ label: t('Samples'), tip: t('Paths per pixel') }, samples.element);
  const status = h('p', { class: 'hint', role: 'status' });
  const bar = h('progress', { max: 1, value: 0, 'aria-label': t('Export'), hidden: true });
  const start = h('button', { type: 'submit', class: 'text-button primary' }, t('Export'));
  const cancel = h('button', { type: 'button', class: 'text-button' }, t('Cancel'));
  const form = h(
    'form',
    { method: 'dialog' },
    h('h1', {}, t('Export a picture')),
    row({ label: t('Picture'), tip: t('Which of the two renderers draws it') }, source.element),
    row({ label: t('Size'), tip: t('In pixels') }, size.element),
    row({ label: t('Width'), tip: t('Pixels') }, widthField.element),
    row({ label: t('Height'), tip: t('Pixels') }, heightField.element),
    samplesRow,
    row(
      { label: t('Format'), tip: t('EXR has the linear radiance before exposure and tone mapping') },
      format.element,
    ),
    status,
    bar,
    h('div', { class: 'popup-actions' }, cancel, start),
  );
  const dialog = h('dialog', { class: 'confirm export-picture' }, form);

  const update = () => {
    widthField.show(request.width);
    heightField.show(request.height);
    samples.show(request.samples);
    samplesRow.hidden = request.source !== 'traced';
    const { width: across, height: down } = request;
    const isTraced = request.source === 'traced';
    const tooLarge = isTraced && across * down > MOST_TRACED_PIXELS;
    start.disabled = tooLarge;
    const count = megapixels(across * down);
    const most = megapixels(MOST_TRACED_PIXELS);
    status.classList.toggle('fault', tooLarge);
    status.replaceChildren();
    if (!tooLarge) {
      status.textContent = isTraced
        ? t('{count} megapixels; path traced, a page has room for {most}', { count, most })
        : t('{count} megapixels', { count });
      return;
    }
    const fitting = largestOf(across, down, MOST_TRACED_PIXELS);
    const take = h('button', { type: 'button', class: 'text-button' }, t('Take {width} × {height}', fitting));
    take.addEventListener('click', () => {
      Object.assign(request, fitting);
      size.show('own');
      update();
      start.focus();
    });
    status.append(
      t(
        '{count} megapixels: a path traced picture of more than {most} does not fit into a page’s memory. `irradia render --size {width}x{height}` makes it.',
        { count, most, width: across, height: down },
      ),
      take,
    );
  };
  const run = async () => {
    running = new AbortController();
    const fields = form.querySelectorAll<HTMLInputElement>('select, input');
    for (const field of fields) field.disabled = true;
    start.disabled = true;
    bar.hidden = false;
    try {
      const file = await makePicture(context, request, running.signal, (text, fraction) => {
        bar.value = fraction;
        status.textContent = `${text} ${Math.floor(fraction * 100)} %`;
      });
      const name = `${fileNameOf(scene.name)}-${request.width}x${request.height}.${request.format}`;
      download(name, file);
      toast('success', t('Exported {name}', { name }));
      dialog.close();
    } catch (error) {
      if (!running?.signal.aborted) toastError(t('The picture was not exported'), error);
      for (const field of fields) field.disabled = false;
      bar.hidden = true;
      update();
    } finally {
      running = null;
    }
  };
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    if (running === null) void run();
  });
  cancel.addEventListener('click', () => dialog.close());
  dialog.addEventListener('close', () => {
    running?.abort();
    dialog.remove();
  });
  document.body.append(dialog);
  source.show(request.source);
  format.show(request.format);
  size.show('1');
  update();
  dialog.showModal();
  start.focus();
}
