/** The thread that computes skies and studios. What does not depend on the sun is computed once for as long as it lives. */
import { type ComputedSource, computeEnvironment, type EnvironmentMap } from '../../scene/environment-map.ts';
import { answerQuestions } from '../threads/answering.ts';

answerQuestions<ComputedSource, EnvironmentMap>(async (source) => {
  const answer = await computeEnvironment(source);
  return { answer, transfer: [answer.texels.buffer as ArrayBuffer] };
});
