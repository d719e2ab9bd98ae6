/** Where a lesson comes from, and the lesson made from it in the page's language. */
import { type ShippedLesson, shippedLessons } from '../../../lessons/index.ts';
import { parseDocument } from '../../scene/document.ts';
import { lessonFile } from '../io/files.ts';
import { language } from '../language/language.ts';
import { frontMatter } from './front-matter.ts';
import { parseLesson } from './parse.ts';
import { prepareLesson, type ReadyLesson } from './prepare.ts';

export interface LessonSource {
  /** By which progress is kept: a shipped lesson's folder, or an address. */
  readonly name: string;
  /** What, behind the page's own address, opens it again; null if nothing does. */
  readonly address: string | null;
  /** By language; the empty one is for all who have none of their own. */
  readonly texts: ReadonlyMap<string, string>;
  /** A document, as JSON or as text. */
  readonly scene: unknown;
}

/** More than the longest text of a lesson, four bytes a character at the most (parse.ts). */
const MOST_BYTES = 2 * 1024 * 1024;

export interface LessonSummary {
  readonly name: string;
  readonly title: string;
  readonly summary: string;
  readonly minutes: number;
}

export function lessonSummaries(): LessonSummary[] {
  return shippedLessons
    .map((lesson) => {
      const { text, file } = textOf(sourceOf(lesson));
      return { name: lesson.name, ...frontMatter(text.split(/\r\n?|\n/), file).matter };
    })
    .toSorted((a, b) => a.order - b.order);
}

/** Throws an Error that names the lessons there are. */
export function shippedLesson(name: string): LessonSource {
  const found = shippedLessons.find((lesson) => lesson.name === name);
  if (found) return sourceOf(found);
  const names = shippedLessons.map((lesson) => lesson.name).join(', ');
  throw new Error(`There is no lesson “${name}”. These ship: ${names}.`);
}

function sourceOf({ name, texts, scene }: ShippedLesson): LessonSource {
  return { name, address: `?lesson=${encodeURIComponent(name)}`, texts, scene };
}

/** A folder of files that a person gave: lesson.en.md, lesson.es.md, scene.json. */
export async function lessonOfFiles(files: readonly File[]): Promise<LessonSource> {
  const texts = new Map<string, string>();
  let name = '';
  for (const file of files) {
    const match = lessonFile.exec(file.name);
    if (!match) continue;
    // Whatever is longer is refused as too long, without being read.
    texts.set(match[1]?.toLowerCase() ?? '', await file.slice(0, MOST_BYTES).text());
    name ||= file.webkitRelativePath.split('/').at(-2) ?? '';
  }
  const scene = files.find((file) => file.name.toLowerCase() === 'scene.json');
  if (!scene) throw new Error('The lesson has no scene. Expected scene.json beside its text.');
  return { name: name || 'lesson', address: null, texts, scene: await scene.text() };
}

/** A folder at an address of this server. */
export async function lessonOfAddress(address: string): Promise<LessonSource> {
  const folder = new URL(address.endsWith('/') ? address : `${address}/`, location.href);
  if (folder.origin !== location.origin)
    throw new Error(
      `${folder.host}: a lesson is opened from this page’s own server. Download it and drop its folder here.`,
    );
  const [own, english, any, scene] = await Promise.all(
    [`lesson.${language}.md`, 'lesson.en.md', 'lesson.md', 'scene.json'].map((file) =>
      fetched(new URL(file, folder)),
    ),
  );
  if (typeof scene !== 'string') throw new Error(`${folder.pathname}scene.json: ${scene?.message}`);
  const texts = new Map<string, string>();
  for (const [key, text] of [
    ['', any],
    ['en', english],
    [language, own],
  ] as const)
    if (typeof text === 'string') texts.set(key, text);
  if (texts.size === 0) throw new Error(`${folder.pathname}lesson.${language}.md: ${(own as Error).message}`);
  return { name: folder.pathname, address: `?lesson=${encodeURIComponent(address)}`, texts, scene };
}

/** What is not there is no fault: another language may be. */
async function fetched(url: URL): Promise<string | Error> {
  // Another server is not asked by a detour, either.
  const response = await fetch(url, { redirect: 'error' });
  if (!response.ok) return new Error(`the server answered ${response.status} ${response.statusText}`);
  return response.text();
}

/** Throws LessonError or DocumentError. */
export function readLesson(source: LessonSource): ReadyLesson {
  const { text, file } = textOf(source);
  return prepareLesson(parseLesson(text, file), parseDocument(source.scene, `${source.name}/scene.json`));
}

function textOf({ name, texts }: LessonSource): { text: string; file: string } {
  const found = [language, '', 'en', ...texts.keys()].find((key) => texts.has(key));
  if (found === undefined) throw new Error(`${name}: there is no lesson.en.md`);
  return { text: texts.get(found) ?? '', file: `${name}/lesson${found && `.${found}`}.md` };
}
