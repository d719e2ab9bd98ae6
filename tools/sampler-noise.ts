/**
 * `node tools/run.mjs tools/sampler-noise.ts`: prints the table of docs/decisions/path-tracer.md, the noise of the generic
 * sampler beside that of the models' own.
 */
import { casesOf, DULL, SHARP } from '../test/pathtracer/generic-materials.ts';
import { compareNoise, LIGHTS, noiseRatio } from '../test/pathtracer/generic-noise.ts';

const SAMPLES = 20_000;
const lights = Object.keys(LIGHTS);

console.log(`| model | parameters | ${lights.join(' | ')} | own, generic where it is worst |`);
console.log(`| --- | --- |${' --- |'.repeat(lights.length + 1)}`);
for (const { name, parameters } of [...casesOf(DULL), ...casesOf(SHARP)]) {
  const compared = (await compareNoise(name, parameters, SAMPLES)).filter(({ generic }) => generic.mean > 0);
  if (compared.length === 0) continue;
  const worstOf = (list: typeof compared) => list.reduce((a, b) => (noiseRatio(b) > noiseRatio(a) ? b : a));
  const ratios = lights.map((light) =>
    noiseRatio(worstOf(compared.filter((one) => one.light === light))).toFixed(1),
  );
  const { own, generic } = worstOf(compared);
  const noise = [own, generic].map(({ deviation, mean }) => (deviation / mean).toFixed(2)).join(', ');
  const values = Object.entries(parameters).map(([key, value]) => `${key} ${round(value)}`);
  console.log(`| ${[name, values.join(', ') || 'defaults', ...ratios, noise].join(' | ')} |`);
}

function round(value: unknown): string {
  if (Array.isArray(value)) return value.join(' ');
  return typeof value === 'number' ? String(Math.round(1000 * value) / 1000) : String(value);
}
