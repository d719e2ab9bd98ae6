/** The terms of a step's formulas: a click on one explains it, shows it in picture and plot, or offers its field. */

import { t } from '../../language/language.ts';
import type { Course } from '../../learn/course.ts';
import type { Definition } from '../../learn/lesson.ts';
import { typeset } from '../../learn/tex.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { icon } from '../../ui/icons.ts';
import type { Bound } from '../inspector/field.ts';
import { hasField, lessonField } from './field.ts';
import { inlineNodes } from './text.ts';

/** One for each term, in the order of their definitions: the colours of the plots' curves (tokens.css). */
const COLORS = 8;

export class Terms {
  readonly #session: Session;
  readonly #course: Course;
  /** Of this step, each with where its explanation goes. */
  readonly #places = new Map<HTMLElement, HTMLElement>();
  #open: { readonly key: string; readonly holder: HTMLElement; readonly fields: Bound[] } | null = null;

  constructor(session: Session, course: Course) {
    this.#session = session;
    this.#course = course;
  }

  /** A part of the text that has terms in it, with room below it to explain one. */
  block(
    make: (onTerm: (key: string) => void) => HTMLElement,
    terms: ReadonlyMap<string, string> = new Map(),
  ): HTMLElement {
    const room = h('div', { class: 'lesson-explanation', role: 'status' });
    const holder = h('div', { class: 'lesson-block' });
    const onTerm = (key: string) => this.#toggle(key, holder);
    const chips = this.#inOrder(terms).map(([key, tex]) => this.#chip(key, tex, onTerm));
    holder.append(make(onTerm));
    if (chips.length > 0) holder.append(h('div', { class: 'lesson-chips' }, ...chips));
    holder.append(room);
    this.#places.set(holder, room);
    for (const part of holder.querySelectorAll<HTMLElement>('[data-lesson-term]'))
      part.style.setProperty('--term', this.#color(part.dataset.lessonTerm ?? ''));
    return holder;
  }

  /** After every change of the document: what is shown alone may be shown no more. */
  update(): void {
    for (const field of this.#open?.fields ?? []) field.update();
    if (!this.#open) return;
    const { target } = this.#definition(this.#open.key);
    if (target.kind === 'term' && this.#course.term !== target.name) this.#close(false);
  }

  #definition(key: string): Definition {
    return this.#course.lesson.definitions.get(key) as Definition;
  }

  #inOrder(terms: ReadonlyMap<string, string>): [key: string, tex: string][] {
    const keys = [...this.#course.lesson.definitions.keys()];
    return [...terms].sort(([a], [b]) => keys.indexOf(a) - keys.indexOf(b));
  }

  #color(key: string): string {
    const at = [...this.#course.lesson.definitions.keys()].indexOf(key);
    return `var(--series-${at % COLORS})`;
  }

  #chip(key: string, tex: string, onTerm: (key: string) => void): HTMLElement {
    const { target } = this.#definition(key);
    const button = h('button', {
      type: 'button',
      class: 'lesson-chip',
      'aria-label': key,
      'aria-pressed': 'false',
    });
    typeset(tex, button, false);
    button.dataset.lessonTerm = key;
    if (target.kind === 'term') button.append(icon('eye'));
    else if (target.kind === 'field') button.append(icon('slider'));
    button.addEventListener('click', () => onTerm(key));
    return button;
  }

  #toggle(key: string, holder: HTMLElement): void {
    const same = this.#open?.key === key && this.#open.holder === holder;
    if (this.#open) this.#close(true);
    if (same) return;
    const { target, text } = this.#definition(key);
    const fields: Bound[] = [];
    if (target.kind === 'field' && hasField(this.#course, target.path))
      fields.push(lessonField(this.#session, this.#course, { path: target.path }));
    this.#open = { key, holder, fields };
    const whole = h('button', { type: 'button', class: 'text-button lesson-whole' }, t('As before'));
    whole.addEventListener('click', () => this.#toggle(key, holder));
    const body = h(
      'div',
      {},
      h('p', {}, ...inlineNodes(text, () => {})),
      ...fields.map((field) => field.element),
      target.kind === 'term'
        ? h('p', { class: 'lesson-alone' }, t('The picture shows it alone.'), ' ', whole)
        : null,
    );
    const room = this.#places.get(holder);
    room?.style.setProperty('--term', this.#color(key));
    room?.replaceChildren(body);
    this.#mark(key, holder, true);
    for (const field of fields) field.update();
    if (target.kind === 'term') this.#course.showTerm(target.name);
  }

  #close(showWhole: boolean): void {
    if (!this.#open) return;
    const { key, holder } = this.#open;
    this.#open = null;
    this.#places.get(holder)?.replaceChildren();
    this.#mark(key, holder, false);
    if (showWhole && this.#definition(key).target.kind === 'term') this.#course.showTerm(null);
  }

  #mark(key: string, holder: HTMLElement, on: boolean): void {
    for (const part of holder.querySelectorAll<HTMLElement>(`[data-lesson-term="${key}"]`)) {
      part.classList.toggle('on', on);
      if (part instanceof HTMLButtonElement) part.setAttribute('aria-pressed', String(on));
    }
  }
}
