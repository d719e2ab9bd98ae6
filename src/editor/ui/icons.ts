/** The page's icons: strokes on a 16 x 16 grid, drawn in the colour of the text beside them. */

const PATHS = {
  undo: 'M6 3 2.5 6.5 6 10M3 6.5h6.5a3.5 3.5 0 0 1 0 7H7',
  redo: 'M10 3l3.5 3.5L10 10M13 6.5H6.5a3.5 3.5 0 0 0 0 7H9',
  close: 'M4 4l8 8M12 4l-8 8',
  check: 'M3 8.5l3.5 3.5L13 4.5',
  warning: 'M8 2.5 14.5 13.5h-13zM8 6.5v3.5M8 11.9v.2',
  info: 'M8 14A6 6 0 1 0 8 2a6 6 0 0 0 0 12zM8 7.3V11M8 5v.2',
  eye: 'M1.5 8S4 3.5 8 3.5 14.5 8 14.5 8 12 12.5 8 12.5 1.5 8 1.5 8zM8 10a2 2 0 1 0 0-4 2 2 0 0 0 0 4z',
  eyeOff:
    'M2 2l12 12M6.5 3.7A6.3 6.3 0 0 1 8 3.5c4 0 6.5 4.5 6.5 4.5a11 11 0 0 1-2.2 2.7M4.2 5A11.5 11.5 0 0 0 1.5 8S4 12.5 8 12.5a6.5 6.5 0 0 0 3-.8',
  camera: 'M2 5h2.5l1-1.5h5l1 1.5H14v7.5H2zM8 10.8a2.3 2.3 0 1 0 0-4.6 2.3 2.3 0 0 0 0 4.6z',
  image: 'M2.5 3h11v10h-11zM2.5 11l3.5-3.5 3 3 2-2 2.5 2.5M10.5 6v.1',
  imageAdd: 'M13.5 8V3h-11v10H8M2.5 11l3.5-3.5 3 3M12 10v4M10 12h4',
  folder: 'M2 4h4l1.5 1.5H14V13H2z',
  file: 'M4 2h5l3 3v9H4zM9 2v3h3',
  save: 'M3 3h8l2 2v8H3zM5.5 3v3.5h4V3M5 13V9.5h6V13',
  link: 'M6.5 9.5 9.5 6.5M7 4.5l1.5-1.5a3.2 3.2 0 0 1 4.5 4.5L11.5 9M9 11.5 7.5 13A3.2 3.2 0 0 1 3 8.5L4.5 7',
  trash: 'M3 4.5h10M6.5 4.5V3h3v1.5M4.5 4.5 5 13h6l.5-8.5M7 7v3.5M9 7v3.5',
  plus: 'M8 3v10M3 8h10',
  copy: 'M5.5 5.5h8v8h-8zM3.5 10.5h-1v-8h8v1',
  scene: 'M8 2l5.5 3v6L8 14l-5.5-3V5zM2.7 5.1 8 8l5.3-2.9M8 8v6',
  sphere: 'M8 14A6 6 0 1 0 8 2a6 6 0 0 0 0 12zM2.2 8c1.5 1.3 10.1 1.3 11.6 0M8 2c2.7 2.5 2.7 9.5 0 12',
  box: 'M8 2l5.5 3v6L8 14l-5.5-3V5zM2.7 5.1 8 8l5.3-2.9M8 8v6',
  plane: 'M1.5 10.5 5 5.5h9.5L11 10.5z',
  circle: 'M8 13.5A5.5 5.5 0 1 0 8 2.5a5.5 5.5 0 0 0 0 11z',
  cone: 'M8 2 3 11.5c0 1 2.2 2 5 2s5-1 5-2z',
  cylinder:
    'M3.5 4.2c0-1 2-1.7 4.5-1.7s4.5.7 4.5 1.7v7.6c0 1-2 1.7-4.5 1.7s-4.5-.7-4.5-1.7zM3.5 4.2c0 1 2 1.7 4.5 1.7s4.5-.7 4.5-1.7',
  torus:
    'M8 12.5c3.6 0 6.5-2 6.5-4.5S11.6 3.5 8 3.5 1.5 5.5 1.5 8s2.9 4.5 6.5 4.5zM5.2 7.6c.8 1.5 4.8 1.5 5.6 0M6 8.4c.9-.9 3.1-.9 4 0',
  mesh: 'M8 2l6 11H2zM8 2v11M5 7.5h6',
  material: 'M8 14A6 6 0 1 0 8 2a6 6 0 0 0 0 12zM5 6.5A3.5 3.5 0 0 1 7.5 4.5',
  ambient: 'M8 10.5a2.5 2.5 0 1 0 0-5 2.5 2.5 0 0 0 0 5zM8 14.3a6.3 6.3 0 1 0 0-12.6 6.3 6.3 0 0 0 0 12.6z',
  directional:
    'M8 10.5a2.5 2.5 0 1 0 0-5 2.5 2.5 0 0 0 0 5zM8 1v2M8 13v2M1 8h2M13 8h2M3 3l1.5 1.5M11.5 11.5 13 13M13 3l-1.5 1.5M4.5 11.5 3 13',
  point: 'M6.2 11.5h3.6M6.7 13.5h2.6M6.2 11.5c0-2-2.2-2.6-2.2-5.3a4 4 0 0 1 8 0c0 2.7-2.2 3.3-2.2 5.3',
  spot: 'M6 2h4l4 9.5c-2 2.3-10 2.3-12 0zM2.3 11c2.5 1.7 8.9 1.7 11.4 0',
  hemisphere: 'M2 9a6 6 0 0 1 12 0zM4.5 12h7M6.5 14.3h3',
  rectangle: 'M2.5 3h11v6h-11zM4.5 11v2.5M8 11v3M11.5 11v2.5',
  plot: 'M2.5 2.5v11h11M4.5 11.5c2.5 0 2.5-7 4.5-7s1.5 5 5 5.5',
  focus:
    'M2.5 5.5v-3h3M10.5 2.5h3v3M13.5 10.5v3h-3M5.5 13.5h-3v-3M8 9.2a1.2 1.2 0 1 0 0-2.4 1.2 1.2 0 0 0 0 2.4z',
  cursor: 'M4 2.5 12.5 8l-3.7.9 2.2 4.1-1.9 1-2.2-4.1L4 12.5z',
  boxSelect: 'M2.5 4.5v-2h2M7 2.5h2M11.5 2.5h2v2M13.5 7v2M13.5 11.5v2h-2M9 13.5H7M4.5 13.5h-2v-2M2.5 9V7',
  move: 'M8 1.5v13M1.5 8h13M6 3.5l2-2 2 2M6 12.5l2 2 2-2M3.5 6l-2 2 2 2M12.5 6l2 2-2 2',
  rotate: 'M13 8.5A5 5 0 1 1 8 3.5h3.5M9.5 1.5l2 2-2 2M8 9.2a.7.7 0 1 0 0-1.4.7.7 0 0 0 0 1.4z',
  scale: 'M2.5 8.5h5v5h-5zM9 7l4.5-4.5M10 2.5h3.5V6M2.5 6V2.5H7M9.5 13.5h4V9',
  local: 'M3.5 12.5V3M1.5 5l2-2 2 2M3.5 12.5H13M11 10.5l2 2-2 2M3.5 12.5l5-5M8.5 10V7.5H6',
  pivot: 'M8 10a2 2 0 1 0 0-4 2 2 0 0 0 0 4zM8 1.5v4M8 10.5v4M1.5 8h4M10.5 8h4',
  magnet: 'M3 2.5h3V8a2 2 0 0 0 4 0V2.5h3V8a5 5 0 0 1-10 0zM3 5.5h3M10 5.5h3',
  loop: 'M13 8a5 5 0 1 1-1.5-3.5L13 6M13 2.5V6H9.5',
  pause: 'M5.5 3.5v9M10.5 3.5v9',
  play: 'M5 3l8 5-8 5z',
  expand: 'M9.5 2.5h4v4M13.5 2.5 9 7M6.5 13.5h-4v-4M2.5 13.5 7 9',
  stopwatch: 'M8 14a5 5 0 1 0 0-10 5 5 0 0 0 0 10zM8 6.5V9l1.7 1.2M6.5 1.8h3M8 1.8V4',
  lock: 'M4.5 7.5h7V13.5h-7zM5.8 7.5V5.2a2.2 2.2 0 0 1 4.4 0v2.3',
  lockOpen: 'M4.5 7.5h7V13.5h-7zM5.8 7.5V5.2a2.2 2.2 0 0 1 4.2-.9',
  search: 'M7 11.5a4.5 4.5 0 1 0 0-9 4.5 4.5 0 0 0 0 9zM10.3 10.3 14 14',
  chevronDown: 'M4 6l4 4 4-4',
  list: 'M6 4h7.5M6 8h7.5M6 12h7.5M2.8 4h.1M2.8 8h.1M2.8 12h.1',
  slider: 'M2 8h3.5M10 8h4M7.8 10.2a2.2 2.2 0 1 0 0-4.4 2.2 2.2 0 0 0 0 4.4z',
  gear: 'M8 10.2a2.2 2.2 0 1 0 0-4.4 2.2 2.2 0 0 0 0 4.4zM6.9 1.8h2.2l.4 1.8 1.2.7 1.8-.6 1.1 1.9-1.4 1.2v1.4l1.4 1.2-1.1 1.9-1.8-.6-1.2.7-.4 1.8H6.9l-.4-1.8-1.2-.7-1.8.6-1.1-1.9 1.4-1.2V7.8L2.4 5.6l1.1-1.9 1.8.6 1.2-.7z',
  keyboard: 'M1.5 4.5h13v7.5h-13zM4 7h.1M6.6 7h.1M9.3 7h.1M12 7h.1M5 9.7h6',
} as const;

export type IconName = keyof typeof PATHS;

const SVG = 'http://www.w3.org/2000/svg';

export function icon(name: IconName): SVGSVGElement {
  const svg = document.createElementNS(SVG, 'svg');
  svg.setAttribute('viewBox', '0 0 16 16');
  svg.setAttribute('class', 'icon');
  svg.setAttribute('aria-hidden', 'true');
  const path = document.createElementNS(SVG, 'path');
  path.setAttribute('d', PATHS[name]);
  svg.append(path);
  return svg;
}

export function setIcon(button: Element, name: IconName): void {
  button.querySelector('path')?.setAttribute('d', PATHS[name]);
}

export function isIcon(name: string): name is IconName {
  return Object.hasOwn(PATHS, name);
}

/** The path of an icon, for the viewport's overlay, which draws on a canvas. */
export function iconPath(name: IconName): string {
  return PATHS[name];
}
