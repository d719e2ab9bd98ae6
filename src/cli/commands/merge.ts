import { extname } from 'node:path';
import { decodeExr, type ExrImage, encodeExr } from '../../io/exr.ts';
import { type Command, UsageError } from '../command.ts';
import { readInput } from '../files.ts';
import { mergeParts, partOf } from '../render/merge.ts';
import { radianceToPng } from '../render/picture.ts';
import { checkWritable, savePicture } from '../render/save.ts';

const command: Command = {
  usage: 'merge A.exr B.exr ... -o OUT.exr|.png',
  summary: 'Parts of a path traced picture as one: the samples of all of them.',
  details: [
    '  A.exr ...  by `irradia render --samples A:B`, of one document and with the same settings, no sample in two',
    '             of them; gaps between them are allowed. Layers are merged, too;',
    '             of what was denoised, the layer with the noise',
    '  -o         an .exr can be merged again; a .png is what the lab shows',
  ],
  options: { output: { type: 'string', short: 'o' } },
  arguments: { least: 1, most: Number.POSITIVE_INFINITY },
  async run({ arguments: words, options }) {
    const { output } = options as Record<string, string>;
    if (!output) throw new UsageError('merge: expected -o OUT.exr or -o OUT.png');
    const format = extname(output).slice(1).toLowerCase();
    if (format !== 'png' && format !== 'exr')
      throw new UsageError(`-o ${output}: expected a .png or an .exr`);
    checkWritable(output, `-o ${output}`);
    const { image, record } = mergeParts(words.map((word) => partOf(decodeExr(readInput(word), word), word)));
    const file =
      format === 'exr'
        ? encodeExr(image)
        : radianceToPng(interleaved(image), image, record, false, alphaOf(image));
    savePicture(output, `-o ${output}`, file);
    return 0;
  },
};

export default command;

const alphaOf = ({ channels }: ExrImage): Float32Array | undefined =>
  channels.find(({ name }) => name === 'A')?.pixels;

function interleaved({ channels, width, height }: ExrImage): Float32Array {
  const planes = ['R', 'G', 'B'].map((name) => channels.find((channel) => channel.name === name)?.pixels);
  return new Float32Array(3 * width * height).map((_, i) => planes[i % 3]?.[Math.floor(i / 3)] ?? 0);
}
