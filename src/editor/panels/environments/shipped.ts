/** Small pictures of the shipped environments; tools/environment-thumbnails.ts makes them. */
import { type EnvironmentPreset, environmentPresets } from '../../../scene/presets.ts';
import { h } from '../../ui/dom.ts';
import address from './shipped.webp';

const [WIDTH, HEIGHT, COLUMNS] = [96, 48, 6];

export function presetPicture(name: EnvironmentPreset): HTMLElement {
  const i = environmentPresets.indexOf(name);
  const element = h('span', { class: 'environment-picture' });
  element.style.backgroundImage = `url("${address}")`;
  element.style.backgroundPosition = `${-WIDTH * (i % COLUMNS)}px ${-HEIGHT * Math.floor(i / COLUMNS)}px`;
  return element;
}
