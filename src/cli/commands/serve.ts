import { spawn } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { pageHeaders } from '../../page-policy.ts';
import { serializeDocument } from '../../scene/document.ts';
import { CliError, type Command, UsageError } from '../command.ts';
import { packageRoot } from '../package-root.ts';
import { sceneArgument } from '../scene-argument.ts';
import { startStaticServer } from '../static-server.ts';

const DEFAULT_PORT = 4280;

const command: Command = {
  usage: 'serve [SCENE] [--port N] [--open]',
  summary: 'The lab, as a page for a browser on this machine (the default command).',
  details: [
    '  SCENE    a document, or the name of a scene that ships',
    `  --port   where to listen; otherwise ${DEFAULT_PORT}, or the next port that is free`,
    '  --open   open the page in a browser, where there is a display',
  ],
  options: { port: { type: 'string' }, open: { type: 'boolean' } },
  arguments: { least: 0, most: 1 },
  async run({ arguments: [scene], options }) {
    const port = parsePort(options.port as string | undefined);
    const { files, query } = scene === undefined ? { files: new Map(), query: '' } : await openedScene(scene);
    const folder = join(packageRoot, 'dist/lab');
    if (!existsSync(join(folder, 'index.html'))) {
      throw new CliError('the lab is not built yet; run `npm run build` first');
    }
    const server = await startStaticServer({ folder, files, headers: pageHeaders, ...port });
    const address = `${server.url}${query}`;
    // Before anyone can know that it runs, and end it.
    const ended = new Promise((resolve) => {
      process.once('SIGINT', resolve);
      process.once('SIGTERM', resolve);
    });
    console.log(`Irradia is at ${address} (Ctrl+C ends it)`);
    if (options.open && hasDisplay()) openBrowser(address);
    await ended;
    await server.close();
    return 0;
  },
};

export default command;

interface Opened {
  files: Map<string, string>;
  query: string;
}

/** The page fetches what `?scene=` names: a scene that ships, or an address of this server. */
async function openedScene(word: string): Promise<Opened> {
  const { document, shipped } = await sceneArgument(word);
  if (shipped) return { files: new Map(), query: `?scene=${shipped}` };
  return { files: new Map([['/scene.json', serializeDocument(document)]]), query: '?scene=/scene.json' };
}

function parsePort(text: string | undefined): { port: number; tries: number } {
  if (text === undefined) return { port: DEFAULT_PORT, tries: 100 };
  if (!/^\d{1,5}$/.test(text) || Number(text) > 65535)
    throw new UsageError(`--port ${text}: expected 0 to 65535`);
  return { port: Number(text), tries: 1 };
}

function hasDisplay(): boolean {
  return process.platform !== 'linux' || Boolean(process.env.DISPLAY || process.env.WAYLAND_DISPLAY);
}

function openBrowser(address: string): void {
  const commands: Partial<Record<NodeJS.Platform, [string, string[]]>> = {
    darwin: ['open', [address]],
    win32: ['cmd', ['/c', 'start', '', address]],
  };
  const [program, words] = commands[process.platform] ?? ['xdg-open', [address]];
  const child = spawn(program, words, { stdio: 'ignore', detached: true });
  // The address is printed; whoever has no such program opens it themselves.
  child.on('error', () => {});
  child.unref();
}
