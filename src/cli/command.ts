import { type ParseArgsConfig, parseArgs } from 'node:util';

/** One command of the command line. Each has a file of its own in commands/, loaded when it is called. */
export interface Command {
  /** What follows `irradia`, with its arguments: 'brdf show MODEL|FILE'. */
  usage: string;
  /** One line for the list of commands. */
  summary: string;
  /** What its arguments and options mean, for `--help`; one line each. */
  details: readonly string[];
  options: NonNullable<ParseArgsConfig['options']>;
  /** How many arguments it takes besides options. */
  arguments: { least: number; most: number };
  /** Returns the exit code. */
  run(call: Call): Promise<number>;
}

export interface Call {
  arguments: readonly string[];
  options: Readonly<Record<string, OptionValue>>;
}

/** An option that may be given several times has a list of its values. */
export type OptionValue = string | boolean | (string | boolean)[] | undefined;

/** Something that the user can put right: shown without a stack, the process exits with 1. */
export class CliError extends Error {}

/** A call that is not as `--help` says: the process exits with 2. */
export class UsageError extends CliError {}

export function parseCall(command: Command, words: readonly string[]): Call | 'help' {
  const help = { type: 'boolean', short: 'h' } as const;
  const name = command.usage.replace(/ [[A-Z-].*$/, '');
  let parsed: ReturnType<typeof parseArgs>;
  try {
    parsed = parseArgs({
      args: joinNegative(words, command.options),
      options: { ...command.options, help },
      allowPositionals: true,
      strict: true,
    });
  } catch (error) {
    // Node adds advice on how to escape a dash, which is of no use to most.
    const [problem = ''] = (error as Error).message.split(/\.\s/);
    throw new UsageError(`${name}: ${problem}; \`irradia ${name} --help\` lists the options`);
  }
  const { values, positionals } = parsed;
  if (values.help) return 'help';
  const { least, most } = command.arguments;
  if (positionals.length < least || positionals.length > most) {
    throw new UsageError(`${name}: expected \`irradia ${command.usage}\``);
  }
  return { arguments: positionals, options: values as Call['options'] };
}

/**
 * `--size -3x10` as `--size=-3x10`, so that the command can say what is wrong with the value; Node takes a word
 * that begins with a dash for an option and refuses it.
 */
function joinNegative(words: readonly string[], options: Command['options']): string[] {
  const joined: string[] = [];
  for (const word of words) {
    const option = joined.at(-1)?.replace(/^--/, '') ?? '';
    if (/^-\d/.test(word) && joined.at(-1)?.startsWith('--') && options[option]?.type === 'string')
      joined.push(`${joined.pop()}=${word}`);
    else joined.push(word);
  }
  return joined;
}

export function helpText({ usage, summary, details }: Command): string {
  return [`irradia ${usage}`, '', summary, '', ...details, ''].join('\n');
}
