/** The thread that reads files, so that the page never waits for them; afterwards it serves what is in a model. */

import { answerQuestions } from '../../threads/answering.ts';
import type { ToThread } from '../../threads/thread.ts';
import { runJob } from './jobs.ts';
import type { FromImporter, ModelAnswer, ModelQuestion, ToImporter } from './messages.ts';
import { Server } from './server.ts';

const post = (message: FromImporter, transfer: Transferable[] = []) =>
  self.postMessage(message, { transfer });
const server = new Server();

answerQuestions<ModelQuestion, ModelAnswer>((question) => server.answer(question));
self.addEventListener('message', ({ data }: MessageEvent<ToImporter | ToThread<ModelQuestion>>) => {
  if ('question' in data) return;
  if (data.kind === 'open') server.open(data.asset);
  else void runJob(data, server, post);
});
