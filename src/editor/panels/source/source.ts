/**
 * The source of a model, edited beside the picture. A text that compiles goes into the document at once, so that
 * viewport, plots and sliders follow; one that does not leaves the last good one where it is.
 */
import { findModel } from '../../../scene/models.ts';
import { attempt } from '../../commands.ts';
import { t, translate } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { newGesture } from '../../ui/gesture.ts';
import { icon } from '../../ui/icons.ts';
import { toastError } from '../../ui/toast.ts';
import type { CodeEditor } from './code-editor.ts';
import { applySource, faultOf, isOwn, type Remembered, type SourceFault, sourceOf } from './edit-model.ts';

/** After the last key, before what was typed is compiled, ms. */
const PAUSE = 300;

export function createSourcePanel({ store, state }: Session): HTMLElement {
  let editor: CodeEditor | null = null;
  /** The model that the editor has; null while there is none. */
  let shown: string | null = null;
  let timer = 0;
  let merge = newGesture();
  /** The document's text of the model that the editor has seen or written. */
  let known: string | null = null;
  const remembered: Remembered = new Map();

  const title = h('strong', { class: 'source-title' });
  const message = h('p', { class: 'source-message', role: 'status' });
  const place = h('div', { class: 'source-place' });
  const close = h(
    'button',
    {
      type: 'button',
      class: 'icon-button',
      'aria-label': t('Close the source'),
      tip: t('Close'),
      keys: 'edit.source',
    },
    icon('close'),
  );
  close.addEventListener('click', () => state.set({ source: null }));
  const element = h(
    'section',
    { class: 'source', 'aria-label': t('Source of the model'), hidden: true },
    h('div', { class: 'source-head' }, title, h('span', { class: 'spacer' }), close),
    place,
    message,
    h('p', { class: 'source-keys' }, t('Tab indents, Esc leaves the text, Ctrl+Space completes')),
  );

  const say = (fault: SourceFault | null) => {
    editor?.showFault(fault);
    message.classList.toggle('error', fault !== null);
    message.textContent = fault
      ? t('Line {line}: {message}. The last version that compiled is in use.', {
          line: fault.line,
          message: translate(fault.message),
        })
      : t('Compiles; in use.');
  };

  const compile = () => {
    const text = editor?.text();
    if (text === undefined || shown === null || text === known) return;
    const name = shown;
    const fault = faultOf(text, name);
    say(fault);
    if (fault) return;
    known = text;
    attempt(t('The model stays as it was'), () => applySource(store, name, text, merge, remembered));
  };
  const typed = () => {
    message.classList.remove('error');
    message.textContent = '…';
    clearTimeout(timer);
    timer = window.setTimeout(compile, PAUSE);
  };

  const ensureEditor = async (): Promise<CodeEditor> => {
    if (editor) return editor;
    // CodeMirror is as large as half of the page: it comes when it is first wanted.
    const { createCodeEditor } = await import('./code-editor.ts');
    editor ??= createCodeEditor({
      onChange: typed,
      onLeave: () => close.focus(),
      parameters: () => (shown === null ? [] : (findModel(store.document, shown)?.parameters ?? [])),
    });
    place.replaceChildren(editor.element);
    return editor;
  };

  const read = (name: string, how: (text: string) => void) => {
    clearTimeout(timer);
    known = sourceOf(store.document, name);
    merge = newGesture();
    how(known ?? '');
    say(known === null ? null : faultOf(known, name));
  };

  const follow = async () => {
    const { source } = state.value;
    element.hidden = source === null;
    if (source === shown) return;
    if (shown !== null) finish();
    shown = source;
    if (source === null) return;
    title.textContent = `${source}.brdf`;
    try {
      const ready = await ensureEditor();
      if (shown !== source) return;
      read(source, ready.open);
      ready.focus();
    } catch (error) {
      toastError(t('The editor could not be loaded'), error);
      state.set({ source: null });
    }
  };
  /** What was typed last is not lost; what comes later is another undo step. */
  const finish = () => {
    clearTimeout(timer);
    compile();
    store.endMerge();
    remembered.clear();
  };

  state.subscribe(() => void follow());
  store.subscribe(({ document }) => {
    if (shown === null) return;
    if (!isOwn(document, shown)) state.set({ source: null });
    else if (editor && sourceOf(document, shown) !== known) read(shown, editor.replace);
  });
  return element;
}
