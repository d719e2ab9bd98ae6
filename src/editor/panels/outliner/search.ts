/** The field above the outliner that filters it by names and kinds. */
import { plural, t } from '../../language/language.ts';
import { h } from '../../ui/dom.ts';
import { icon } from '../../ui/icons.ts';

export interface SearchOptions {
  onQuery(query: string): void;
  /** The person is done with the field; whether the first that was found is meant. */
  onLeave(intoList: boolean): void;
}

export interface Search {
  readonly element: HTMLElement;
  focus(): void;
  /** How many things were found; null while nothing is searched. */
  showFound(count: number | null): void;
}

export function createSearch({ onQuery, onLeave }: SearchOptions): Search {
  const input = h('input', {
    type: 'text',
    placeholder: t('Search'),
    'aria-label': t('Search the scene'),
    autocomplete: 'off',
    spellcheck: 'false',
  });
  const found = h('span', { class: 'found', role: 'status' });
  const clear = h(
    'button',
    { type: 'button', class: 'icon-button', 'aria-label': t('Clear the search'), hidden: true },
    icon('close'),
  );
  const set = (query: string) => {
    input.value = query;
    clear.hidden = query === '';
    onQuery(query.trim());
  };
  input.addEventListener('input', () => set(input.value));
  clear.addEventListener('click', () => {
    set('');
    input.focus();
  });
  input.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') {
      event.stopPropagation();
      set('');
      onLeave(false);
    } else if (event.key === 'ArrowDown' || event.key === 'Enter') {
      event.preventDefault();
      onLeave(true);
    }
  });
  return {
    element: h('div', { class: 'outliner-search', role: 'search' }, icon('search'), input, found, clear),
    focus() {
      input.focus();
      input.select();
    },
    showFound(count) {
      found.textContent = count === null ? '' : plural(count, '{count} found', '{count} found');
    },
  };
}
