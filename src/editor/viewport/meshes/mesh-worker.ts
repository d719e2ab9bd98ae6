/** The thread of meshes: what is found out about many triangles once, so that the page need not wait for it. */
import { answerQuestions } from '../../threads/answering.ts';
import { meshAnswers } from './mesh-jobs.ts';

answerQuestions(meshAnswers());
