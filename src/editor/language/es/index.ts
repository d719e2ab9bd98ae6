/** Spanish. glossary.md beside this file says which word stands for which. */
import type { Catalogue } from '../catalogue.ts';
import { bench } from './bench.ts';
import { documents } from './documents.ts';
import { edits } from './edits.ts';
import { files } from './files.ts';
import { glsl } from './glsl.ts';
import { inspector } from './inspector.ts';
import { lessons } from './lessons.ts';
import { library } from './library.ts';
import { models } from './models.ts';
import { page } from './page.ts';
import { patterns } from './patterns.ts';
import { schema } from './schema.ts';
import { substances } from './substances.ts';
import { verdict } from './verdict.ts';
import { viewport } from './viewport.ts';

const catalogue: Catalogue = {
  ...bench,
  ...documents,
  ...edits,
  ...files,
  ...glsl,
  ...inspector,
  ...lessons,
  ...library,
  ...models,
  ...page,
  ...patterns,
  ...schema,
  ...substances,
  ...verdict,
  ...viewport,
};

export default catalogue;
