/** On a first visit: a card that offers the tour, once the first picture is there. It is in nobody's way. */
import { t } from '../language/language.ts';
import { h } from '../ui/dom.ts';

const STORAGE_KEY = 'irradia.tour';

/** @param start begins the tour */
export function inviteToTour(place: HTMLElement, start: () => void): void {
  // A page that is driven by a program has nobody to invite.
  if (navigator.webdriver || wasInvited()) return;
  const take = h('button', { type: 'button', class: 'text-button primary' }, t('Take the tour, one minute'));
  const leave = h('button', { type: 'button', class: 'text-button' }, t('No, thanks'));
  const card = h(
    'aside',
    { class: 'invitation', 'aria-label': t('Invitation to the tour') },
    h('strong', {}, t('New here?')),
    h('div', { class: 'popup-actions' }, take, leave),
  );
  take.addEventListener('click', () => {
    settle(card);
    start();
  });
  leave.addEventListener('click', () => settle(card));
  place.append(card);
}

/** Never again by itself: also for whoever found the tour alone. */
export function settle(card = document.querySelector('.invitation')): void {
  card?.remove();
  try {
    localStorage.setItem(STORAGE_KEY, 'seen');
  } catch {
    // Storage may be forbidden; the next visit then asks again.
  }
}

function wasInvited(): boolean {
  try {
    return localStorage.getItem(STORAGE_KEY) !== null;
  } catch {
    return false;
  }
}
