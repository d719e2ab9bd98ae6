/** The thread that makes files and links of documents. */
import { serializeDocument } from '../../scene/document.ts';
import { linkFor } from '../share/link-text.ts';
import { answerQuestions } from '../threads/answering.ts';
import { receivedDocument } from '../threads/sent-assets.ts';
import type { DocumentAnswer, DocumentQuestion } from './document-work.ts';

answerQuestions<DocumentQuestion, DocumentAnswer>(async (question) => {
  switch (question.kind) {
    case 'file':
      return {
        answer: new Blob([serializeDocument(await receivedDocument(question.document))], {
          type: 'application/json',
        }),
      };
    case 'link':
      return { answer: await linkFor(await receivedDocument(question.document)) };
    case 'thumbnail': {
      const { image } = question;
      const canvas = new OffscreenCanvas(image.width, image.height);
      canvas.getContext('2d')?.drawImage(image, 0, 0);
      image.close();
      return { answer: await canvas.convertToBlob({ type: 'image/webp', quality: 0.8 }) };
    }
  }
});
