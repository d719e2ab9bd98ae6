import { parseBrdf } from '../src/brdf/parse.ts';
import { compileModel, type Model } from '../src/glsl/model.ts';

/**
 * The models that ship. Nobody registers them: every `.brdf` file of this folder is one. Those in measured/
 * are none of their own: they look up data that a file of measurements brings.
 */

const sources: Record<string, string> = {
  ...import.meta.glob<string>('./*.brdf', { query: '?raw', import: 'default', eager: true }),
  ...import.meta.glob<string>('./measured/*.brdf', { query: '?raw', import: 'default', eager: true }),
  ...import.meta.glob<string>('./lib/*.glsl', { query: '?raw', import: 'default', eager: true }),
};

/** The text of every model and include file, by its path inside models/. */
export const modelSources: ReadonlyMap<string, string> = new Map(
  Object.entries(sources).map(([path, text]) => [path.replace(/^\.\//, ''), text]),
);

/** The shipped models by name, in alphabetical order. */
export const shippedModels: ReadonlyMap<string, Model> = new Map(
  [...modelSources.keys()]
    .filter((path) => /^[^/]+\.brdf$/.test(path))
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
  return compile(text, fileName, null);
}

/**
 * A model that looks up data by a file of measured/.
 *
 * @param lookup the file's name there, such as 'merl'
 * @param data the RGB triples that it reads
 */
export function compileMeasured(lookup: string, data: Float32Array, name: string): Model {
  const text = modelSources.get(`measured/${lookup}.brdf`);
  if (text === undefined) throw new RangeError(`there is no models/measured/${lookup}.brdf`);
  return compile(text, `${name}.brdf`, data);
}

function compile(text: string, fileName: string, data: Float32Array | null): Model {
  return compileModel(parseBrdf(text, fileName, { include: (path) => modelSources.get(path) }), data);
}
