import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Plugin } from 'vite';
import { repository } from './vite.shared.config.ts';

/** The folder of the package that a module is of, if it is of one. */
const PACKAGE = /^.*\/node_modules\/(?:@[^/]+\/)?[^/]+/;

const packages = new Set<string>();

/** Notes which packages a bundle has modules of. */
export const packagesOf: Plugin = {
  name: 'irradia:packages',
  generateBundle(_, bundle) {
    for (const chunk of Object.values(bundle)) {
      if (chunk.type !== 'chunk') continue;
      for (const id of chunk.moduleIds) {
        const [folder] = PACKAGE.exec(id.replace(/^\0/, '')) ?? [];
        if (folder && existsSync(join(folder, 'package.json'))) packages.add(folder);
      }
    }
  },
};

/** Writes licences.txt: of Irradia and of every package that is in the page or its workers, as they ask for. */
export const licences: Plugin = {
  name: 'irradia:licences',
  apply: 'build',
  enforce: 'post',
  generateBundle(...output) {
    (packagesOf.generateBundle as (...output: unknown[]) => void).apply(this, output);
    const texts = [repository, ...[...packages].sort()].map(licenceOf);
    this.emitFile({
      type: 'asset',
      fileName: 'licences.txt',
      source: texts.join(`\n\n${'-'.repeat(72)}\n\n`),
    });
  },
};

function licenceOf(folder: string): string {
  const { name, version, license } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8')) as {
    name: string;
    version: string;
    license?: string;
  };
  const file = readdirSync(folder).find((entry) => /^licen[cs]e/i.test(entry));
  const text = file ? readFileSync(join(folder, file), 'utf8').trim() : `Licence: ${license ?? 'not named'}`;
  return `${name} ${version}\n\n${text}`;
}
