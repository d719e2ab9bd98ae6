/**
 * A call names a command (`brdf show`), which is looked up in the table below; `serve` is what runs when none is
 * named.
 */
import { CliError, type Command, helpText, parseCall, UsageError } from './command.ts';
import { packageVersion } from './package-root.ts';

const COMMANDS: Readonly<Record<string, () => Promise<{ default: Command }>>> = {
  serve: () => import('./commands/serve.ts'),
  render: () => import('./commands/render.ts'),
  merge: () => import('./commands/merge.ts'),
  convert: () => import('./commands/convert.ts'),
  'brdf list': () => import('./commands/brdf-list.ts'),
  'brdf show': () => import('./commands/brdf-show.ts'),
  'brdf eval': () => import('./commands/brdf-eval.ts'),
  'brdf check': () => import('./commands/brdf-check.ts'),
  'brdf fit': () => import('./commands/brdf-fit.ts'),
  'substance list': () => import('./commands/substance-list.ts'),
  'substance show': () => import('./commands/substance-show.ts'),
};

/** The first words of commands that have two. */
const GROUPS = new Set(
  Object.keys(COMMANDS).flatMap((name) => (name.includes(' ') ? [name.split(' ')[0]] : [])),
);

/**
 * Runs `irradia` with these words; what goes wrong is said on standard error.
 *
 * @returns the exit code
 */
export const irradia = (words: readonly string[]): Promise<number> => run(words).catch(report);

async function run(words: readonly string[]): Promise<number> {
  const [first, second] = words;
  if (first === '--help' || first === '-h' || first === 'help') return print(await overview());
  if (first === '--version' || first === '-v') return print(`${packageVersion()}\n`);
  if (first !== undefined && GROUPS.has(first) && !Object.hasOwn(COMMANDS, `${first} ${second}`)) {
    const text = await overview(first);
    if (second === '--help' || second === '-h') return print(text);
    throw new UsageError(
      `${second ? `there is no command '${first} ${second}'` : `${first} what?`}\n${text.trimEnd()}`,
    );
  }
  const name = [`${first} ${second}`, `${first}`].find((words) => Object.hasOwn(COMMANDS, words));
  const { default: command } = await (COMMANDS[name ?? 'serve'] as (typeof COMMANDS)[string])();
  const call = parseCall(command, words.slice(name?.split(' ').length ?? 0));
  return call === 'help' ? print(helpText(command)) : command.run(call);
}

async function overview(group = ''): Promise<string> {
  const names = Object.keys(COMMANDS).filter((name) => name.startsWith(group));
  const commands = await Promise.all(
    names.map(async (name) => (await COMMANDS[name]?.())?.default as Command),
  );
  const entries = commands.map(({ usage, summary }) => `  irradia ${usage}\n      ${summary}`);
  const title = 'Irradia, a lab for physically based lighting.';
  return `${[title, ...entries, '--help after a command tells more.'].join('\n\n')}\n`;
}

function print(text: string): number {
  process.stdout.write(text);
  return 0;
}

function report(error: unknown): number {
  const expected = error instanceof CliError || (error instanceof Error && isUsersFault(error));
  const text = expected ? error.message : error instanceof Error ? error.stack : String(error);
  process.stderr.write(`irradia: ${text}\n`);
  return error instanceof UsageError ? 2 : 1;
}

const USERS_FAULTS = new Set([
  'BrdfError',
  'BrdfParameterError',
  'DocumentError',
  'ByteError',
  'GpuUnavailableError',
  'PathTracerError',
  'GltfError',
  'ModelFileError',
]);

/** Errors of files, documents and models say by their names that their message is all there is to say. */
function isUsersFault(error: Error): boolean {
  return USERS_FAULTS.has(error.name) || 'syscall' in error;
}
