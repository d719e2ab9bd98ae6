/** The way to the database. What the browser has closed is opened again: at once, and later whenever it is needed. */
import { t } from '../language/language.ts';
import { openDatabase } from './database.ts';

/** After how long it is tried again, and how often before it is only tried when it is needed. */
const REOPEN_MS = 500;
const REOPENINGS = 20;

/** The browser has closed the database, and does not open it at present. */
export class DatabaseLost extends Error {
  constructor() {
    super(t('The browser has closed its database.'));
  }
}

export class Connection {
  #database: IDBDatabase | null = null;
  #isOpening = false;
  /** What was kept may no longer be there. */
  onOpenedAgain: () => void = () => {};

  private constructor() {}

  static async open(): Promise<Connection> {
    const connection = new Connection();
    await connection.#open();
    return connection;
  }

  /** Throws while there is none. */
  get database(): IDBDatabase {
    if (this.#database) return this.#database;
    void this.#openAgain();
    throw new DatabaseLost();
  }

  async #open(): Promise<void> {
    this.#database = await openDatabase(() => {
      this.#database = null;
      void this.#openAgain();
    });
  }

  async #openAgain(): Promise<void> {
    if (this.#isOpening) return;
    this.#isOpening = true;
    // Told while the browser is still clearing, when it opens nothing.
    for (let tries = 0; tries < REOPENINGS && !this.#database; tries++) {
      await new Promise((resolve) => setTimeout(resolve, REOPEN_MS));
      await this.#open().catch(() => {});
    }
    this.#isOpening = false;
    if (this.#database) this.onOpenedAgain();
  }
}
