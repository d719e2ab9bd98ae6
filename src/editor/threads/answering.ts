/** The other end of Thread (thread.ts): imported by what runs there. */
import { messageOf } from '../../scene/assets.ts';
import type { FromThread, ToThread } from './thread.ts';

export interface Answered<Answer> {
  readonly answer: Answer;
  /** Handed over, not copied. */
  readonly transfer?: Transferable[];
}

/** What a thread is told beside its questions, for others that listen. */
interface Told {
  readonly kind: string;
}

export function answerQuestions<Question, Answer>(
  answerTo: (question: Question) => Promise<Answered<Answer>> | Answered<Answer>,
): void {
  const post = (message: FromThread<Answer>, transfer: Transferable[] = []) =>
    self.postMessage(message, { transfer });
  self.addEventListener('message', async ({ data }: MessageEvent<ToThread<Question> | Told>) => {
    if (!('question' in data)) return;
    const { ticket, question } = data;
    try {
      const { answer, transfer } = await answerTo(question);
      post({ ticket, answer }, transfer);
    } catch (error) {
      post({ ticket, refusal: messageOf(error) });
    }
  });
}
