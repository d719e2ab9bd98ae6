/** The thread that reads files, so that the page never waits for them; afterwards it serves what is in a model. */

import { runJob } from './jobs.ts';
import type { FromImporter, ToImporter } from './messages.ts';
import { Server } from './server.ts';

const post = (message: FromImporter, transfer: Transferable[] = []) =>
  self.postMessage(message, { transfer });
const server = new Server(post);

self.addEventListener('message', ({ data }: MessageEvent<ToImporter>) => {
  switch (data.kind) {
    case 'open':
      server.open(data.asset);
      return;
    case 'geometry':
    case 'image':
      void server.answer(data);
      return;
    default:
      void runJob(data, server, post);
  }
});
