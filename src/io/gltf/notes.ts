/** What an import could not keep, for a person to read; each said once. */
export class Notes {
  readonly #notes = new Set<string>();

  add(note: string): void {
    this.#notes.add(note);
  }

  get list(): string[] {
    return [...this.#notes];
  }
}
