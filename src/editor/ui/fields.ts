/** The small fields: choice, switch, text; and the row that puts a label before any field. */
import { h } from './dom.ts';
import { isKeyboardOn } from './focus.ts';

export interface Choice {
  value: string;
  label: string;
  group?: string;
}

export interface SelectField {
  readonly element: HTMLSelectElement;
  setChoices(choices: readonly Choice[]): void;
  show(value: string): void;
}

export function selectField(
  label: string,
  choices: readonly Choice[],
  onChange: (value: string) => void,
): SelectField {
  const element = h('select', { 'aria-label': label });
  let shown: readonly Choice[] = [];
  const setChoices = (next: readonly Choice[]) => {
    if (sameChoices(next, shown)) return;
    shown = next;
    const value = element.value;
    element.replaceChildren();
    const groups = new Map<string, HTMLOptGroupElement>();
    for (const choice of next) {
      const option = h('option', { value: choice.value }, choice.label);
      if (!choice.group) {
        element.append(option);
        continue;
      }
      let group = groups.get(choice.group);
      if (!group) {
        group = h('optgroup', { label: choice.group });
        groups.set(choice.group, group);
        element.append(group);
      }
      group.append(option);
    }
    element.value = value;
  };
  setChoices(choices);
  element.addEventListener('change', () => {
    const byKeyboard = isKeyboardOn(element);
    onChange(element.value);
    // The keys belong to the page again: what was chosen is chosen. By keyboard the place must not be lost.
    if (!byKeyboard) element.blur();
  });
  return {
    element,
    setChoices,
    show(value) {
      if (element.value !== value) element.value = value;
    },
  };
}

function sameChoices(a: readonly Choice[], b: readonly Choice[]): boolean {
  return (
    a.length === b.length &&
    a.every((x, i) => x.value === b[i]?.value && x.label === b[i]?.label && x.group === b[i]?.group)
  );
}

export interface SwitchField {
  readonly element: HTMLElement;
  show(value: boolean): void;
}

export function switchField(label: string, onChange: (value: boolean) => void): SwitchField {
  const input = h('input', { type: 'checkbox', class: 'switch', role: 'switch', 'aria-label': label });
  input.addEventListener('change', () => onChange(input.checked));
  return {
    element: h('div', { class: 'switch-cell' }, input),
    show(value) {
      input.checked = value;
    },
  };
}

export interface TextField {
  readonly element: HTMLInputElement;
  show(value: string): void;
}

export function textField(label: string, onChange: (value: string) => void): TextField {
  const element = h('input', { type: 'text', 'aria-label': label, autocomplete: 'off', spellcheck: 'false' });
  let value = '';
  element.addEventListener('blur', () => {
    const typed = element.value.trim();
    if (typed && typed !== value) onChange(typed);
    element.value = value;
  });
  element.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') {
      element.value = value;
      event.stopPropagation();
    }
    if (event.key === 'Enter' || event.key === 'Escape') element.blur();
  });
  return {
    element,
    show(next) {
      value = next;
      if (document.activeElement !== element) element.value = next;
    },
  };
}

export interface RowOptions {
  label: string;
  tip?: string | undefined;
  /** Double click on the label. */
  onReset?: () => void;
  /** Controls after the field, such as a texture slot. */
  after?: HTMLElement | null;
}

export function row(options: RowOptions, field: HTMLElement): HTMLElement {
  const label = h(
    'span',
    { class: options.onReset ? 'row-label resettable' : 'row-label', tip: options.tip },
    options.label,
  );
  if (options.onReset) label.addEventListener('dblclick', options.onReset);
  const element = h('div', { class: options.after ? 'row with-after' : 'row' }, label, field, options.after);
  element.dataset.label = options.label;
  return element;
}
