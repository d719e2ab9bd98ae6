import { cellParameters, type HeatMap, heatMap, MAPPED, worstCell } from '../analysis/verdict/heat-map.ts';
import { heatMapCsv, heatMapSvg } from '../analysis/verdict/heat-map-picture.ts';
import type { Model } from '../glsl/model.ts';
import { type OptionValue, UsageError } from './command.ts';
import { checkOutput, writeOutput } from './files.ts';
import { progressLine } from './progress.ts';

const KINDS = ['svg', 'png', 'csv'] as const;

export interface HeatMapFile {
  /** Two names with a comma, or 'main'. */
  readonly axes: string;
  readonly law: OptionValue;
  readonly output: OptionValue;
}

/** Writes a law's map over two parameters, and says where it is worst. */
export async function writeHeatMap(model: Model, { axes, law, output }: HeatMapFile): Promise<string> {
  const property = MAPPED.find((name) => name === law);
  if (!property) throw new UsageError(`--law ${law}: expected ${MAPPED.join(' or ')}`);
  const kind = KINDS.find((ending) => String(output).endsWith(`.${ending}`));
  if (typeof output !== 'string' || !kind)
    throw new UsageError(`--map: expected -o FILE, a ${KINDS.map((ending) => `.${ending}`).join(', ')}`);
  checkOutput(output, `-o ${output}`);
  const line = progressLine(true);
  const map = await heatMap(model, {
    property,
    ...(axes !== 'main' && { axes: namesOf(axes) }),
    onProgress: (done) => line(done, property),
  }).catch((error: unknown) => {
    throw error instanceof RangeError ? new UsageError(`--map ${axes}: ${error.message}`) : error;
  });
  writeOutput(output, `-o ${output}`, await fileOf(map, kind));
  return summary(map);
}

function namesOf(axes: string): readonly [string, string] {
  const [x, y, ...others] = axes.split(',').map((name) => name.trim());
  if (x && y && others.length === 0) return [x, y];
  throw new UsageError(`--map ${axes}: expected two parameters with a comma between, or main`);
}

async function fileOf(map: HeatMap, kind: (typeof KINDS)[number]): Promise<Uint8Array> {
  if (kind === 'csv') return Buffer.from(heatMapCsv(map));
  const svg = Buffer.from(heatMapSvg(map));
  if (kind === 'svg') return svg;
  const { default: sharp } = await import('sharp');
  // Twice the size on the screen, on white.
  return sharp(svg, { density: 144 }).flatten({ background: '#ffffff' }).png().toBuffer();
}

function summary(map: HeatMap): string {
  const { column, row, cell } = worstCell(map);
  const set = cellParameters(map, column, row);
  const digits = (x: number) => String(+x.toPrecision(4));
  const places = [map.x, map.y].map(({ name }) => `${name} ${digits(set[name] as number)}`);
  return `${map.property} of ${map.model}: worst ${digits(cell.value)} at ${places.join(', ')}, v [${cell.v.map(digits).join(', ')}]`;
}
