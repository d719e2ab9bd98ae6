/**
 * Writes docs/models: a page for each shipped model, its pictures, and an index: `npm run docs`, which takes some
 * minutes; `npm run docs -- NAME...` writes the pages of these models alone.
 */
import { writeFileSync } from 'node:fs';
import { shippedModels } from '../models/index.ts';
import { spherePicture } from '../src/analysis/fit/sphere.ts';
import { heatMap } from '../src/analysis/verdict/heat-map.ts';
import { heatMapSvg } from '../src/analysis/verdict/heat-map-picture.ts';
import { checkModel } from '../src/analysis/verdict/verdict.ts';
import { resolveParameters } from '../src/brdf/values.ts';
import type { Model } from '../src/glsl/model.ts';
import { encodePng } from '../src/io/png.ts';
import { filePart, verdictPart } from './model-page.ts';
import { thesisCost } from './thesis-cost.ts';

const SPHERE = 160;
const folder = new URL('../docs/models/', import.meta.url);
const write = (name: string, content: string | Uint8Array) => writeFileSync(new URL(name, folder), content);

/** The map's file, or null for a model with fewer than two numbers. */
async function writeMap(model: Model): Promise<string | null> {
  if (model.parameters.filter(({ type }) => type === 'float').length < 2) return null;
  write(`${model.name}-energy.svg`, heatMapSvg(await heatMap(model, { property: 'energy' })));
  return `${model.name}-energy.svg`;
}

const wanted = process.argv.slice(3);
const rows: string[] = [];
for (const model of shippedModels.values()) {
  const { name, file, parameters } = model;
  if (wanted.length > 0 && !wanted.includes(name)) continue;
  console.log(name);
  const pixels = await spherePicture(model, resolveParameters(file), SPHERE);
  write(`${name}.png`, await encodePng(new Uint8Array(pixels), SPHERE, SPHERE));
  const verdict = await checkModel(model, { seed: 1 });
  write(`${name}.md`, filePart(model) + verdictPart(verdict, parameters, await writeMap(model)));
  const energy = verdict.checks.find(({ property }) => property === 'energy');
  rows.push(
    `| [${name}](${name}.md) | ${file.title} | ${verdict.sound ? 'sound' : 'broken'} | ${energy?.figureText ?? ''} |`,
  );
}

if (wanted.length === 0) writeIndex();

function writeIndex(): void {
  const [burley, thesis] = ['principled', 'principled-thesis'].map(
    (name) => shippedModels.get(name) as Model,
  );
  write('thesis-cost.svg', thesisCost([burley as Model, thesis as Model]));
  write(
    'README.md',
    `<!-- Written by \`npm run docs\`. Do not edit. -->
# Models

| Model | What it is | Verdict | Energy |
| --- | --- | --- | --- |
${rows.join('\n')}

## principled and principled-thesis

Both are the same model but for what the headers list. What costs most is the subsurface term, which has
1/((n.l)(n.v)) in the thesis where Burley has 1/(n.l + n.v): the share of the light that the surface gives back
grows without bound towards the horizon. Above the solid line there is more light than came.

![Directional albedo of both over the angle](thesis-cost.svg)

| ![principled](principled-energy.svg) | ![principled-thesis](principled-thesis-energy.svg) |
| --- | --- |
`,
  );
}
