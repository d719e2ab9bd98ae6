import { parseBrdf } from '../src/brdf/parse.ts';
import { compileModel, type Model } from '../src/glsl/model.ts';

/**
 * The models that ship. Nobody registers them: every `.brdf` file of this folder is one.
 */

const sources: Record<string, string> = {
  ...import.meta.glob<string>('./*.brdf', { query: '?raw', import: 'default', eager: true }),
  ...import.meta.glob<string>('./lib/*.glsl', { query: '?raw', import: 'default', eager: true }),
};

/** The text of every model and include file, by its path inside models/. */
export const modelSources: ReadonlyMap<string, string> = new Map(
  Object.entries(sources).map(([path, text]) => [path.replace(/^\.\//, ''), text]),
);

/** The shipped models by name, in alphabetical order. */
export const shippedModels: ReadonlyMap<string, Model> = new Map(
  [...modelSources.keys()]
    .filter((path) => path.endsWith('.brdf'))
    .sort()
    .map((path) => {
      const model = loadModel(modelSources.get(path) as string, `models/${path}`);
      return [model.name, model];
    }),
);

/**
 * Parses and compiles a model file, which may include what ships in models/lib.
 *
 * @throws BrdfError naming file, line and what was expected
 */
export function loadModel(text: string, fileName: string): Model {
  return compileModel(parseBrdf(text, fileName, { include: (path) => modelSources.get(path) }));
}
