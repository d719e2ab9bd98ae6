/** Lessons: walked through, in English and Spanish; a person's own; what was open before comes back. */
import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { openLab, small } from './lab.ts';

const lab = await openLab();
/** The scenes of lessons are as they ship, and the GPU is made of software: so few pixels. */
const size = { width: 760, height: 420 };
/** Something to come back to. */
const mine = small({ name: 'Mine' }, size);

it('a lesson shows, explains and changes the picture, and leaves nothing behind', async () => {
  const lesson = await (await lab.open(mine)).ready();
  const { page } = lesson;

  await page.click('.topbar >> text="Learn"');
  await page.waitForSelector('.lesson-card');
  expect(await page.locator('.lesson-card').count()).toBeGreaterThanOrEqual(8);
  await page.click('[data-lesson="masking"]');
  await page.waitForSelector('.lesson-step h2:has-text("In each other")');
  expect((await lesson.document()).name).toBe('Masking and shadowing');
  expect(page.url()).toContain('?lesson=masking');

  const whole = await lesson.picture();
  await page.click('.lesson-formula .lesson-term');
  await lesson.until(`irradia.store.document.view.term?.name === 'masking'`);
  expect(await page.locator('.lesson-explanation').allInnerTexts()).toContainEqual(
    expect.stringContaining('masking and shadowing'),
  );
  expect((await lesson.picture()).hash).not.toBe(whole.hash);
  await page.click('.lesson-whole');
  await lesson.until('irradia.store.document.view.term === null');
  expect((await lesson.picture()).hash).toBe(whole.hash);
  // Looking is no work that could be undone, or would be kept.
  expect(await page.evaluate('irradia.store.canUndo')).toBe(false);

  await lesson.dragSlider('[data-path="materials.ball.parameters.roughness"]', 0.9);
  expect((await lesson.document()).materials.ball?.parameters.roughness).toBeGreaterThan(0.7);
  expect((await lesson.picture()).hash).not.toBe(whole.hash);

  await page.keyboard.press('PageDown');
  await page.waitForSelector('.lesson-step h2:has-text("Grooves")');
  expect((await lesson.document()).materials.ball?.parameters.roughness).toBe(0.5);
  expect(await page.locator('.bench-tab[aria-selected=true]').getAttribute('data-view')).toBe('thetaL');
  expect(await page.evaluate('irradia.store.undoLabel')).toBe('Lesson: Grooves');
  await page.keyboard.press('PageUp');
  await page.waitForSelector('.lesson-step h2:has-text("In each other")');
  expect(await page.locator('.bench').isHidden()).toBe(true);

  await lesson.dragSlider('[data-path="materials.ball.parameters.roughness"]', 0.8);
  await page.click('.lesson-panel header button >> nth=-1');
  await lesson.until(`irradia.store.document.name === 'Mine'`);
  expect(await page.locator('.lesson-panel').count()).toBe(0);
  // What was changed on the step that was left last was work: it is kept.
  await lesson.waitForToast('“Masking and shadowing” is kept');
  expect(lesson.errors).toEqual([]);
});

it('a lesson by its address, in Spanish, begins where it was left', async () => {
  const options = {
    ...size,
    query: '?lesson=masking',
    init: "localStorage.setItem('irradia.language', 'es')",
  };
  const first = await lab.open(options);
  // The page waits for its Spanish words.
  await first.page.waitForSelector('.lesson-step h2:has-text("Unas estorban a otras")');
  await first.page.keyboard.press(']');
  await first.page.waitForSelector('.lesson-step h2:has-text("Surcos")');
  const again = await lab.open({ ...options, beside: first });
  await again.page.waitForSelector('.lesson-step h2:has-text("Surcos")');
  expect((await again.document()).view.term?.name).toBe('masking');
  expect([...first.errors, ...again.errors]).toEqual([]);
});

it('a lesson of a teacher’s own opens by its address or when it is dropped, and says what is wrong with it', async () => {
  const scene = readFileSync(new URL('../../lessons/lambert/scene.json', import.meta.url), 'utf8');
  const text = '---\ntitle: My own\n---\n## <b>First</b>\nText.\n:set materials.ball.albedo [1, 0, 0]\n';
  const page = await lab.open({
    ...size,
    query: '?lesson=./own/',
    files: { '/own/lesson.md': text, '/own/scene.json': scene },
  });
  await page.page.waitForSelector('.lesson-step h2:has-text("<b>First</b>")');
  const { name, materials } = await page.document();
  expect(name).toBe('My own');
  expect(materials.ball?.parameters.albedo).toEqual([1, 0, 0]);
  // What is not there in the page's language, the browser itself notes.
  const notFound = (error: string) => !error.includes('404');

  const drop = (content: string) =>
    page.drop([
      { name: 'lesson.en.md', content },
      { name: 'scene.json', content: scene },
    ]);
  await drop(text.replace('albedo', 'albdo'));
  await page.waitForToast('lesson.en.md:6: lambert has no parameter “albdo”; expected one of albedo');
  expect((await page.document()).name).toBe('My own');
  await drop(text.replace('My own', 'Another').replace('First', 'Begin'));
  await page.page.waitForSelector('.lesson-step h2:has-text("<b>Begin</b>")');
  expect((await page.document()).name).toBe('Another');
  expect(page.errors.filter(notFound)).toEqual([]);
});
