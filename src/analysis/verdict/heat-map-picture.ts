/** How a heat map is drawn: its colours, and a file with axes and a key. */
import type { FloatParameter } from '../../brdf/model.ts';
import { cellParameters, type HeatMap, type MappedProperty, worstCell } from './heat-map.ts';

type Rgb8 = readonly [number, number, number];

/** Dark to light up to the limit of the law; yellow to dark red beyond. */
const KEPT: readonly Rgb8[] = [
  [24, 27, 36],
  [38, 72, 110],
  [84, 140, 176],
  [214, 228, 226],
];
const BROKEN: readonly Rgb8[] = [
  [250, 214, 110],
  [228, 110, 50],
  [134, 22, 44],
];

/** Where on the scale a value is: 0 to 1 within the law, 1 to 2 beyond it. */
function scaled(property: MappedProperty, value: number, largest: number): number {
  if (property === 'energy') {
    // A thousandth above is the quadrature's.
    if (value <= 1.002) return Math.max(0, Math.min(1, value));
    return 1 + Math.min(1, Math.log(value) / Math.log(Math.max(2, largest)));
  }
  // From 1e-12 to the limit of 1e-6 that the law has, and on to 1.
  const decades = Math.log10(Math.max(1e-12, value)) + 6;
  return Math.max(0, Math.min(2, 1 + decades / 6));
}

/** A cell's colour, sRGB, 0 to 255. */
export function heatColor(property: MappedProperty, value: number, largest: number): Rgb8 {
  const at = scaled(property, value, largest);
  return at <= 1 ? between(KEPT, at) : between(BROKEN, at - 1);
}

function between(stops: readonly Rgb8[], share: number): Rgb8 {
  const place = share * (stops.length - 1);
  const i = Math.min(stops.length - 2, Math.floor(place));
  const [a, b] = [stops[i] as Rgb8, stops[i + 1] as Rgb8];
  return [0, 1, 2].map((c) => Math.round(a[c]! + (b[c]! - a[c]!) * (place - i))) as unknown as Rgb8;
}

/** What a map shows, in words. */
export const FIGURES: Readonly<Record<MappedProperty, string>> = {
  energy: 'largest albedo',
  reciprocity: 'change when l and v swap',
};

/** Grey that can be read on white and on black. */
const INK = '#7d828c';
const [LEFT, TOP, SIDE, KEY] = [64, 34, 336, 16];
const [WIDTH, HEIGHT] = [LEFT + SIDE + 100, TOP + SIDE + 52];

export function heatMapSvg(map: HeatMap): string {
  const { model, property, size, cells, x, y } = map;
  const { column, row, cell } = worstCell(map);
  const largest = cell.value;
  const step = SIDE / size;
  const fill = (value: number) => `rgb(${heatColor(property, value, largest).join(' ')})`;
  const parts = cells.map(({ value }, i) => {
    const [px, py] = [LEFT + (i % size) * step, TOP + SIDE - (Math.floor(i / size) + 1) * step];
    return `<rect x="${round(px)}" y="${round(py)}" width="${round(step)}" height="${round(step)}" fill="${fill(value)}"/>`;
  });
  const text = (words: string, px: number, py: number, anchor = 'middle', extra = '') =>
    `<text x="${round(px)}" y="${round(py)}" text-anchor="${anchor}"${extra}>${escaped(words)}</text>`;
  const labels = [
    text(`${model}: ${FIGURES[property]}`, LEFT, 20, 'start', ' font-size="14"'),
    ...ticks(x).map(({ share, label }) => text(label, LEFT + share * SIDE, TOP + SIDE + 18)),
    ...ticks(y).map(({ share, label }) => text(label, LEFT - 8, TOP + SIDE * (1 - share) + 4, 'end')),
    text(x.name, LEFT + SIDE / 2, TOP + SIDE + 40),
    text(y.name, 16, TOP + SIDE / 2, 'middle', ` transform="rotate(-90 16 ${TOP + SIDE / 2})"`),
  ];
  const [cx, cy] = [LEFT + (column + 0.5) * step, TOP + SIDE - (row + 0.5) * step];
  const mark = `<circle cx="${round(cx)}" cy="${round(cy)}" r="${round(step / 3)}" fill="none" stroke="#fff" stroke-width="1.5"/>`;
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${WIDTH}" height="${HEIGHT}" viewBox="0 0 ${WIDTH} ${HEIGHT}" font-family="system-ui, sans-serif" font-size="12" fill="${INK}">`,
    `<title>${escaped(`${model}: ${FIGURES[property]}`)}</title>`,
    `<g shape-rendering="crispEdges">${parts.join('')}</g>`,
    mark,
    ...labels,
    ...key(property, largest, fill, text),
    '</svg>',
    '',
  ].join('\n');
}

function key(
  property: MappedProperty,
  largest: number,
  fill: (value: number) => string,
  text: (words: string, x: number, y: number, anchor: string) => string,
): string[] {
  const values =
    property === 'energy'
      ? [
          0,
          0.25,
          0.5,
          0.75,
          1,
          ...(largest > 1.002 ? [1.01, Math.sqrt(Math.max(2, largest)), Math.max(2, largest)] : []),
        ]
      : [1e-12, 1e-9, 1e-6, 1e-3, 1];
  const left = LEFT + SIDE + 24;
  const height = SIDE / values.length;
  return values.flatMap((value, i) => {
    const top = TOP + SIDE - (i + 1) * height;
    return [
      `<rect x="${left}" y="${round(top)}" width="${KEY}" height="${round(height)}" fill="${fill(value)}"/>`,
      text(String(+value.toPrecision(3)), left + KEY + 6, top + height / 2 + 4, 'start'),
    ];
  });
}

function ticks({ min, max }: FloatParameter): { share: number; label: string }[] {
  return [0, 0.25, 0.5, 0.75, 1].map((share) => ({
    share,
    label: String(+(min + share * (max - min)).toPrecision(3)),
  }));
}

export function heatMapCsv(map: HeatMap): string {
  const { x, y, cells, size } = map;
  const lines = cells.map(({ value }, i) => {
    const set = cellParameters(map, i % size, Math.floor(i / size));
    return [set[x.name], set[y.name], value].join(',');
  });
  return `${[`${x.name},${y.name},${map.property}`, ...lines].join('\n')}\n`;
}

const round = (x: number) => +x.toFixed(2);

function escaped(words: string): string {
  return words.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
}
