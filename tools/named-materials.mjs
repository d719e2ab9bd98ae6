/**
 * Writes src/material/named.generated.ts: a material class for each shipped model, with its parameters as
 * typed properties. Run before every build, type check and test (`npm run generate`); the file is not kept
 * in git, so that the model files stay the only place that knows their names and parameters.
 */
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';

const place = new URL('../src/material/named.generated.ts', import.meta.url);
const { module } = await runnerImport(fileURLToPath(new URL('../models/index.ts', import.meta.url)));

const pascal = (name) => name.replace(/(?:^|[-_])(\w)/g, (_, letter) => letter.toUpperCase());
const comment = (text) => text.replaceAll('*/', '* /');

function declarations({ name, file, parameters }) {
  const id = pascal(name);
  const types = {
    float: ['number', 'number'],
    bool: ['boolean', 'boolean'],
    color: ['Color', 'Color | Rgb'],
  };
  const doc = (p) => {
    const range =
      p.type === 'float' ? ` ${p.min} to ${p.max}, default ${p.default}.` : ` Default ${p.default}.`;
    return `/** ${comment(`${p.description}${range}`.trim())} */`;
  };
  const values = parameters.map((p) => `  ${doc(p)}\n  ${p.name}?: ${types[p.type][1]};`);
  const properties = parameters.flatMap((p) => [
    `  ${doc(p)}`,
    `  get ${p.name}(): ${types[p.type][0]};`,
    `  set ${p.name}(value: ${types[p.type][1]});`,
    `  /** The texture that ${p.name} is multiplied by. */`,
    `  ${p.name}Map: Texture | null;`,
  ]);
  return `
export interface ${id}Parameters {
${values.join('\n')}
}

/** ${comment(file.title)}. */
export class ${id}Material extends BrdfMaterial {
  static override get type(): string {
    return '${id}Material';
  }

  constructor(values: ${id}Parameters = {}) {
    super(shippedModels.get('${name}') as Model, { ...values });
  }
}

export interface ${id}Material {
${properties.join('\n')}
}
`;
}

const text = `// Written by tools/named-materials.mjs from models/*.brdf. Do not edit.
import type { Color, Texture } from 'three/webgpu';
import { shippedModels } from '../../models/index.ts';
import type { Rgb } from '../brdf/model.ts';
import type { Model } from '../glsl/model.ts';
import { BrdfMaterial } from './brdf-material.ts';
${[...module.shippedModels.values()].map(declarations).join('')}`;

// An unchanged file keeps its time, and what was built from it.
if (!existsSync(place) || readFileSync(place, 'utf8') !== text) writeFileSync(place, text);
