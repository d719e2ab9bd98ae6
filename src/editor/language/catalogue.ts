/** What a catalogue is: English text to the language's text. */

/** The forms of a text that counts; Intl.PluralRules says which one a number takes. */
export type PluralForms = Readonly<Partial<Record<Intl.LDMLPluralRule, string>> & { other: string }>;

export type Catalogue = Readonly<Record<string, string | PluralForms>>;
