/** Terms of models as a person reads them: functions have English names. */
import { translate } from './language.ts';

/** `distribución · distribution`: the word, and the name that the source and the verdict have. */
export function termLabel(name: string): string {
  const word = translate(name);
  return word === name ? name : `${word} · ${name}`;
}
