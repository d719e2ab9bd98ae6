/**
 * Copy, cut and paste of what is selected. By the keys it goes through the browser's own events, which ask for
 * no permission; by a menu through its clipboard interface, and where that is refused it stays in this page.
 */
import { copyEntities, isClipboardText, pasteEntities } from '../scene/clipboard.ts';
import { describeEntities } from '../scene/entity.ts';
import { attempt } from './commands.ts';
import { t, translate } from './language/language.ts';
import { deleteSelected } from './selection.ts';
import type { Session } from './session.ts';
import { isTextEntry } from './ui/dom.ts';
import { toast, toastError } from './ui/toast.ts';

/** A longer text would hold up every program that looks at the clipboard. */
const MOST_CHARACTERS = 64 * 1024 * 1024;

export interface Clipboard {
  copy(): Promise<void>;
  cut(): Promise<void>;
  paste(): Promise<void>;
}

export function installClipboard(session: Session): Clipboard {
  const { store, state } = session;
  /** What was copied last and is not in the system's clipboard. */
  let kept: string | null = null;

  /** The text of what is selected; null where there is none, or it cannot be told. */
  const textOf = (): string | null =>
    state.value.selected.length === 0
      ? null
      : (attempt(t('Not copied'), () => copyEntities(store.document, state.value.selected)) ?? null);

  const tell = (isCut: boolean, isHere: boolean) => {
    const what = translate(describeEntities(store.document, state.value.selected));
    const title = isCut ? t('Cut: {what}', { what }) : t('Copied: {what}', { what });
    if (isHere)
      toast(
        'info',
        title,
        t('It can be pasted in this page only: the system’s clipboard was not available.'),
      );
    else toast('success', title);
  };
  const done = (isCut: boolean, isHere: boolean) => {
    tell(isCut, isHere);
    if (isCut) deleteSelected(session);
  };

  const put = (text: string) => {
    const pasted = attempt(t('Not pasted; the scene is unchanged'), () => pasteEntities(store, text));
    if (pasted) state.selectAll(pasted);
  };
  const putOrTell = (text: string) => {
    if (isClipboardText(text)) put(text);
    else if (kept !== null) put(kept);
    else
      toast(
        'info',
        t('There is nothing to paste'),
        t('Objects, lights and materials can be pasted that were copied in Irradia.'),
      );
  };

  const onCopy = (event: ClipboardEvent, isCut: boolean) => {
    if (isOthers(event) || !document.getSelection()?.isCollapsed) return;
    const text = textOf();
    if (text === null) return;
    event.preventDefault();
    kept = text.length > MOST_CHARACTERS ? text : null;
    if (kept === null) event.clipboardData?.setData('text/plain', text);
    done(isCut, kept !== null);
  };
  document.addEventListener('copy', (event) => onCopy(event, false));
  document.addEventListener('cut', (event) => onCopy(event, true));
  document.addEventListener('paste', (event) => {
    if (isOthers(event)) return;
    event.preventDefault();
    const files = [...(event.clipboardData?.files ?? [])];
    if (files.length > 0) void session.openFiles(files);
    else putOrTell(event.clipboardData?.getData('text/plain') ?? '');
  });

  const copy = async (isCut: boolean) => {
    const text = textOf();
    if (text === null) return;
    try {
      if (text.length > MOST_CHARACTERS) throw new RangeError('too long for the clipboard');
      await navigator.clipboard.writeText(text);
      kept = null;
    } catch {
      // The person said no, or the browser has none here.
      kept = text;
    }
    done(isCut, kept !== null);
  };
  return {
    copy: () => copy(false),
    cut: () => copy(true),
    async paste() {
      try {
        putOrTell(await navigator.clipboard.readText());
      } catch (error) {
        if (kept !== null) put(kept);
        else toastError(t('The browser does not let a menu read the clipboard; the keys may work'), error);
      }
    },
  };
}

/** Whether the event belongs to what is being typed, or to a dialog. */
function isOthers(event: Event): boolean {
  return isTextEntry(event.composedPath()[0] ?? null) || document.querySelector('dialog[open]') !== null;
}
