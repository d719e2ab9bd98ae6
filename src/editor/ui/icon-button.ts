/** A button that shows a picture alone: what it does is its name and its tooltip. */
import { h } from './dom.ts';
import { type IconName, icon } from './icons.ts';

export interface IconButtonOptions {
  readonly disabled?: boolean;
  /** The action whose keys the tooltip says. */
  readonly keys?: string;
}

export function iconButton(
  name: IconName,
  label: string,
  run: () => void,
  { disabled, keys }: IconButtonOptions = {},
): HTMLButtonElement {
  const button = h(
    'button',
    { type: 'button', class: 'icon-button', 'aria-label': label, tip: label, disabled, keys },
    icon(name),
  );
  button.addEventListener('click', run);
  return button;
}
