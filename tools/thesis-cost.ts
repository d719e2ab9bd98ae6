/** What the product in the thesis's subsurface term costs: the albedo of both forms over the angle, as a figure. */
import { albedoAngles, albedoAt } from '../src/analysis/plots/albedo-curve.ts';
import { createEvaluator } from '../src/glsl/evaluator.ts';
import type { Model } from '../src/glsl/model.ts';

const TITLE = 'directional albedo, white, subsurface 1, roughness .5';

const VALUES = { baseColor: [1, 1, 1], subsurface: 1, roughness: 0.5 };
const [LEFT, TOP, WIDTH, HEIGHT] = [48, 32, 420, 240];
/** Albedos from .5 to 100, on a logarithmic axis. */
const [LOWEST, HIGHEST] = [0.5, 100];
const COLORS = ['#4c86c6', '#d0683c'];

export function thesisCost(models: readonly [Model, Model]): string {
  const curves = models.map((model) => {
    const evaluator = createEvaluator(model, VALUES);
    const f: Parameters<typeof albedoAt>[0] = (l, v) => evaluator.f(l, v);
    return albedoAngles.map((angle) => ({ angle, albedo: Math.max(...albedoAt(f, angle, 0).rgb) }));
  });
  const x = (angle: number) => LEFT + (angle / 90) * WIDTH;
  const y = (albedo: number) =>
    TOP + HEIGHT * (1 - Math.log(Math.max(LOWEST, albedo) / LOWEST) / Math.log(HIGHEST / LOWEST));
  const round = (value: number) => +value.toFixed(1);
  const line = (px: number, py: number, qx: number, qy: number, dash = '') =>
    `<line x1="${px}" y1="${round(py)}" x2="${qx}" y2="${round(qy)}" stroke="#7d828c" stroke-opacity=".4"${dash}/>`;
  const text = (words: string, px: number, py: number, anchor: string, fill = '#7d828c') =>
    `<text x="${px}" y="${round(py)}" text-anchor="${anchor}" fill="${fill}">${words}</text>`;
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${LEFT + WIDTH + 150}" height="${TOP + HEIGHT + 48}" font-family="system-ui, sans-serif" font-size="12">`,
    `<title>${TITLE}</title>`,
    text(TITLE, LEFT, 18, 'start'),
    ...[0.5, 1, 2, 5, 10, 20, 50, 100].flatMap((albedo) => [
      line(LEFT, y(albedo), LEFT + WIDTH, y(albedo), albedo === 1 ? '' : ' stroke-dasharray="2 3"'),
      text(String(albedo), LEFT - 8, y(albedo) + 4, 'end'),
    ]),
    ...[0, 30, 60, 90].map((angle) => text(`${angle}°`, x(angle), TOP + HEIGHT + 18, 'middle')),
    text('θv', x(45), TOP + HEIGHT + 38, 'middle'),
    ...curves.flatMap((curve, i) => {
      const points = curve.map(({ angle, albedo }) => `${round(x(angle))},${round(y(albedo))}`).join(' ');
      const last = curve.at(-1);
      return [
        `<polyline points="${points}" fill="none" stroke="${COLORS[i]}" stroke-width="2"/>`,
        last ? text(models[i]?.name ?? '', x(last.angle) + 8, y(last.albedo) + 4, 'start', COLORS[i]) : '',
      ];
    }),
    '</svg>',
    '',
  ].join('\n');
}
