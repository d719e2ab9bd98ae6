/** The thread that draws patterns. */
import { drawPatternAsset, type PatternImage } from '../../scene/pattern/draw.ts';
import type { Asset } from '../../scene/schema.ts';
import { answerQuestions } from '../threads/answering.ts';

export interface PatternQuestion {
  readonly asset: Asset;
  readonly texture: number | null;
}

answerQuestions<PatternQuestion, PatternImage>(({ asset, texture }) => {
  const answer = drawPatternAsset(asset, texture);
  return { answer, transfer: [answer.data.buffer] };
});
