/** Messages that say what happened and what to do, and progress of what takes time. */

import { t, translate } from '../language/language.ts';
import { h } from './dom.ts';
import { icon } from './icons.ts';

/** A note is information that may take a while to read. */
export type ToastKind = 'info' | 'note' | 'success' | 'error';

/** What a message offers to do about it. */
export interface ToastAction {
  readonly label: string;
  run(): void;
  /** The message has gone, and the offer was not taken. */
  onGone?(): void;
}

export interface Progress {
  /** `fraction` 0..1, or null when the total is not known. */
  update(text: string, fraction: number | null): void;
  done(): void;
}

const LIFE_MS: Record<ToastKind, number> = { info: 4000, note: 0, success: 3000, error: 0 };
/** Whoever is offered something needs the time to read it and to decide. */
const OFFER_LIFE_MS = 15_000;
const TICK_MS = 500;
const MOST = 4;

let stack: HTMLElement | null = null;

function host(): HTMLElement {
  stack ??= h('div', { class: 'toasts', role: 'status', 'aria-live': 'polite' });
  const dialog = document.querySelector('dialog[open]');
  const place = dialog ?? document.body;
  if (stack.parentElement !== place) {
    // Nothing outside an open dialog can be clicked.
    place.append(stack);
    dialog?.addEventListener('close', () => stack && document.body.append(stack), { once: true });
  }
  return stack;
}

/** An error stays until it is closed, and a note, too: it may have to be read, or copied. */
export function toast(kind: ToastKind, title: string, detail?: string, action?: ToastAction): void {
  const same = [...host().children].find(
    (other) => other instanceof HTMLElement && other.dataset.text === title + (detail ?? ''),
  );
  same?.remove();
  const close = h(
    'button',
    { type: 'button', class: 'icon-button', 'aria-label': t('Close this message') },
    icon('close'),
  );
  const element = h(
    'div',
    { class: `toast ${kind === 'note' ? 'info' : kind}`, ...(kind === 'error' && { role: 'alert' }) },
    icon(kind === 'error' ? 'warning' : kind === 'success' ? 'check' : 'info'),
    h('div', { class: 'toast-text' }, h('strong', {}, title), detail ? h('p', {}, detail) : null),
    action ? actionButton(action, () => element.remove()) : null,
    close,
  );
  element.classList.toggle('with-action', action !== undefined);
  element.dataset.text = title + (detail ?? '');
  const go = () => {
    element.remove();
    action?.onGone?.();
  };
  close.addEventListener('click', go);
  host().append(element);
  while (host().children.length > MOST) host().firstElementChild?.remove();
  const life = action && LIFE_MS[kind] > 0 ? OFFER_LIFE_MS : LIFE_MS[kind];
  if (life > 0) expire(element, life, go);
}

/** Time passes only while the message can be read and is not being pointed at; a page that hangs has no ticks. */
function expire(element: HTMLElement, life: number, go: () => void): void {
  let left = life;
  const timer = window.setInterval(() => {
    if (element.isConnected && (document.hidden || element.matches(':hover, :focus-within'))) return;
    left -= TICK_MS;
    if (left > 0 && element.isConnected) return;
    clearInterval(timer);
    if (element.isConnected) go();
  }, TICK_MS);
}

function actionButton({ label, run }: ToastAction, close: () => void): HTMLButtonElement {
  const button = h('button', { type: 'button', class: 'text-button' }, label);
  button.addEventListener('click', () => {
    close();
    run();
  });
  return button;
}

export function toastError(title: string, error: unknown): void {
  toast('error', title, messageOf(error));
}

export function messageOf(error: unknown): string {
  return translate(error instanceof Error ? error.message : String(error));
}

/** @param onCancel offers to give it up */
export function startProgress(text: string, onCancel?: () => void): Progress {
  const label = h('strong', {}, text);
  const bar = h('div', { class: 'bar' }, h('div', { class: 'bar-fill' }));
  const cancel = onCancel && h('button', { type: 'button', class: 'text-button' }, t('Cancel'));
  if (cancel) cancel.addEventListener('click', () => onCancel());
  const element = h(
    'div',
    { class: 'toast progress' },
    h('div', { class: 'toast-text' }, label, bar),
    cancel,
  );
  host().append(element);
  return {
    update(next, fraction) {
      label.textContent = fraction === null ? next : `${next} ${Math.floor(fraction * 100)} %`;
      bar.classList.toggle('unknown', fraction === null);
      bar.style.setProperty('--fraction', `${(fraction ?? 0) * 100}%`);
    },
    done: () => element.remove(),
  };
}
