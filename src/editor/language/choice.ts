/** Which language the page speaks: the one that the person chose here, else the browser's, else English. */

export const languages = ['en', 'es'] as const;
export type Language = (typeof languages)[number];

/** Each by its own name: whoever looks for theirs may not read the present one. */
export const languageNames: Readonly<Record<Language, string>> = { en: 'English', es: 'Español' };

const KEY = 'irradia.language';

export function chosenLanguage(): Language {
  return storedLanguage() ?? preferredLanguage(navigator.languages);
}

/** Null where the browser's own preference counts. */
export function storedLanguage(): Language | null {
  try {
    return languageOf(localStorage.getItem(KEY) ?? '');
  } catch {
    // Storage is forbidden here.
    return null;
  }
}

/** Null leaves it to the browser again. False where the browser keeps nothing for this page. */
export function storeLanguage(language: Language | null): boolean {
  try {
    if (language) localStorage.setItem(KEY, language);
    else localStorage.removeItem(KEY);
    return true;
  } catch {
    return false;
  }
}

/** The first of a person's languages, BCP 47 tags such as `es-MX`, that the page speaks. */
export function preferredLanguage(tags: readonly string[]): Language {
  for (const tag of tags) {
    const found = languageOf(tag);
    if (found) return found;
  }
  return 'en';
}

function languageOf(tag: string): Language | null {
  const primary = tag.toLowerCase().split('-')[0];
  return languages.find((language) => language === primary) ?? null;
}
