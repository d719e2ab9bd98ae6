/**
 * The code editor: CodeMirror in a shadow root. There its styles are constructed style sheets, which the page's
 * Content-Security-Policy allows; in the page itself it would add <style> elements, which it does not.
 */
import {
  autocompletion,
  type Completion,
  type CompletionContext,
  type CompletionResult,
  closeBrackets,
  closeBracketsKeymap,
  completionKeymap,
  completionStatus,
} from '@codemirror/autocomplete';
import { defaultKeymap, history, historyKeymap, indentWithTab } from '@codemirror/commands';
import { bracketMatching, indentOnInput, indentUnit } from '@codemirror/language';
import { lintGutter, setDiagnostics } from '@codemirror/lint';
import { EditorState, Transaction } from '@codemirror/state';
import {
  drawSelection,
  EditorView,
  highlightActiveLine,
  highlightActiveLineGutter,
  keymap,
  lineNumbers,
} from '@codemirror/view';
import type { Parameter } from '../../../brdf/model.ts';
import { t } from '../../language/language.ts';
import { directiveOffers, type Offer, offersInGlsl } from './completions.ts';
import type { SourceFault } from './edit-model.ts';
import { brdfLanguage } from './language.ts';

export interface CodeEditor {
  readonly element: HTMLElement;
  text(): string;
  /** Another text, without a way back to this one; from the first section on, which is after a long header. */
  open(text: string): void;
  /** The same text as it has become elsewhere: only what differs is changed, so that the caret stays. */
  replace(text: string): void;
  showFault(fault: SourceFault | null): void;
  focus(): void;
}

export interface CodeEditorOptions {
  onChange(text: string): void;
  /** Escape. */
  onLeave(): void;
  /** Those of the model when it last compiled. */
  parameters(): readonly Parameter[];
}

const theme = EditorView.theme({
  '&': { height: '100%', backgroundColor: 'var(--bg-field)', color: 'var(--text)', fontSize: '12px' },
  '&.cm-focused': { outline: 'none' },
  '.cm-scroller': {
    fontFamily: '"JetBrains Mono", "SF Mono", "Cascadia Mono", Consolas, "DejaVu Sans Mono", monospace',
    lineHeight: '1.5',
  },
  '.cm-content': { caretColor: 'var(--accent)' },
  '.cm-cursor': { borderLeftColor: 'var(--accent)' },
  '.cm-gutters': { backgroundColor: 'var(--bg-field)', color: 'var(--text-faint)', border: 'none' },
  '.cm-activeLine': { backgroundColor: 'var(--tint)' },
  '.cm-activeLineGutter': { backgroundColor: 'var(--tint)', color: 'var(--text-dim)' },
  '&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground': {
    backgroundColor: 'var(--code-selection)',
  },
  '.cm-matchingBracket': { backgroundColor: 'var(--tint-strong)', outline: 'none' },
  '.cm-tooltip': {
    backgroundColor: 'var(--bg-raised)',
    border: '1px solid var(--edge)',
    borderRadius: '4px',
    color: 'var(--text)',
  },
  '.cm-tooltip-autocomplete > ul > li[aria-selected]': {
    backgroundColor: 'var(--bg-selected)',
    color: 'var(--accent)',
  },
  '.cm-tooltip-autocomplete > ul': { fontSize: '11.5px', maxWidth: '420px' },
  '.cm-completionDetail': { color: 'var(--text-faint)', fontStyle: 'normal' },
  '.cm-completionInfo': { maxWidth: '340px', whiteSpace: 'pre-wrap', padding: '6px 8px' },
  '.cm-diagnostic-error': { borderLeft: '3px solid var(--error)', padding: '4px 8px' },
});

export function createCodeEditor({ onChange, onLeave, parameters }: CodeEditorOptions): CodeEditor {
  const element = document.createElement('div');
  element.className = 'source-editor';
  const root = element.attachShadow({ mode: 'open' });
  let opening = false;

  const extensions = [
    lineNumbers(),
    lintGutter(),
    history(),
    drawSelection(),
    indentOnInput(),
    indentUnit.of('    '),
    bracketMatching(),
    closeBrackets(),
    highlightActiveLine(),
    highlightActiveLineGutter(),
    autocompletion({ override: [(context) => complete(context, parameters())], icons: false }),
    brdfLanguage(),
    theme,
    EditorView.contentAttributes.of({
      'aria-label': t('Source of the model'),
      'data-gramm': 'false',
      // It can be typed in and so has the focus by Tab; this says so to what reads the page.
      tabindex: '0',
    }),
    keymap.of([
      ...closeBracketsKeymap,
      ...completionKeymap,
      {
        key: 'Escape',
        run(view) {
          // The list of completions closes first.
          if (completionStatus(view.state) !== null) return false;
          onLeave();
          return true;
        },
      },
      ...historyKeymap,
      indentWithTab,
      ...defaultKeymap,
    ]),
    EditorView.updateListener.of((update) => {
      if (update.docChanged && !opening) onChange(update.state.doc.toString());
    }),
  ];
  const view = new EditorView({ parent: root, root, state: EditorState.create({ extensions }) });
  // The root holds nothing but the editor, which is to fill it.
  view.dom.part.add('editor');

  return {
    element,
    text: () => view.state.doc.toString(),
    open(text) {
      opening = true;
      view.setState(EditorState.create({ doc: text, extensions }));
      opening = false;
      const at = Math.max(0, view.state.doc.toString().indexOf('::begin'));
      view.dispatch({
        selection: { anchor: at },
        effects: EditorView.scrollIntoView(at, { y: 'start', yMargin: 24 }),
      });
    },
    replace(text) {
      opening = true;
      const changes = difference(view.state.doc.toString(), text);
      view.dispatch({ changes, annotations: Transaction.addToHistory.of(false), scrollIntoView: true });
      opening = false;
    },
    showFault(fault) {
      view.dispatch(setDiagnostics(view.state, fault ? [diagnosticOf(view.state, fault)] : []));
    },
    focus: () => view.focus(),
  };
}

/** From the first character that differs to the last. */
function difference(before: string, after: string): { from: number; to: number; insert: string } {
  const shorter = Math.min(before.length, after.length);
  let from = 0;
  while (from < shorter && before[from] === after[from]) from++;
  let end = 0;
  while (end < shorter - from && before.at(-1 - end) === after.at(-1 - end)) end++;
  return { from, to: before.length - end, insert: after.slice(from, after.length - end) };
}

function diagnosticOf({ doc }: EditorState, { line, column, message }: SourceFault) {
  const at = doc.line(Math.max(1, Math.min(doc.lines, line)));
  const from = column === undefined ? at.from : Math.min(at.to, at.from + column - 1);
  const word = /^(\w+|\S)/.exec(doc.sliceString(from, at.to))?.[0].length ?? 0;
  return { from, to: column === undefined ? at.to : from + word, severity: 'error' as const, message };
}

function complete(context: CompletionContext, parameters: readonly Parameter[]): CompletionResult | null {
  const line = context.state.doc.lineAt(context.pos);
  const before = line.text.slice(0, context.pos - line.from);
  if (before.startsWith('::'))
    return { from: line.from, options: directiveOffers().map(asCompletion), validFor: /^::.*$/ };
  if (/^\s*#|\/\//.test(before) || !inGlsl(context)) return null;
  const word = context.matchBefore(/[A-Za-z_]\w*/);
  if (!word && !context.explicit) return null;
  const options = offersInGlsl(context.state.doc.toString(), parameters).map(asCompletion);
  return { from: word?.from ?? context.pos, options, validFor: /^\w*$/ };
}

/** Whether the last section that began before the place is one of GLSL. */
function inGlsl({ state, pos }: CompletionContext): boolean {
  const sections = [...state.doc.sliceString(0, pos).matchAll(/^::(begin|end)\s+(\w+)/gm)];
  const [, what, name] = sections.at(-1) ?? [];
  return what === 'begin' && name !== 'parameters';
}

const BOOSTS: Partial<Record<Offer['kind'], number>> = { property: 3, constant: 1 };

function asCompletion({ label, kind, detail, info }: Offer): Completion {
  return {
    label,
    type: kind,
    boost: BOOSTS[kind] ?? 0,
    ...(detail && { detail }),
    ...(info && { info }),
  };
}
