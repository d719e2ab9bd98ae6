/** How well a text fits what was typed: its letters in their order, best where words begin and in one piece. */

/** Without case and accents. */
export function plain(text: string): string {
  return text.normalize('NFD').replace(/\p{M}/gu, '').toLowerCase();
}

const WORD_START = 8;
const IN_A_ROW = 10;
const GAP = 0.25;
/** Every place of the first letter is tried as a beginning, up to so many. */
const MOST_STARTS = 8;

/**
 * Null if a letter is missing, else higher for a better fit. Words that are typed are looked for one by one, so
 * that their order does not matter. Both texts as plain() makes them.
 */
export function matchScore(query: string, text: string): number | null {
  let sum = 0;
  for (const word of query.split(/\s+/)) {
    if (word === '') continue;
    const score = fitWord(word, text);
    if (score === null) return null;
    sum += score;
  }
  // Of two that fit alike, the one with less beside it.
  return sum - text.length * 0.01;
}

function fitWord(word: string, text: string): number | null {
  let best: number | null = null;
  let start = text.indexOf(word.charAt(0));
  for (let tries = 0; start >= 0 && tries < MOST_STARTS; tries += 1) {
    const score = fitFrom(word, text, start);
    if (score === null) break;
    if (best === null || score > best) best = score;
    start = text.indexOf(word.charAt(0), start + 1);
  }
  return best;
}

function fitFrom(word: string, text: string, start: number): number | null {
  let score = 0;
  let at = start - 1;
  for (const letter of word) {
    const next = text.indexOf(letter, at + 1);
    if (next < 0) return null;
    const isStart = next === 0 || /[^\p{L}\d]/u.test(text.charAt(next - 1));
    if (isStart) score += WORD_START;
    if (next === at + 1 && next > start) score += IN_A_ROW;
    else if (next > start) score -= (next - at) * GAP;
    at = next;
  }
  return score;
}
