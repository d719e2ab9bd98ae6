/** A fit as code that someone can paste into a program with three.js. */
import type { Parameter, ParameterValue, ParameterValues } from '../../brdf/model.ts';
import type { Model } from '../../glsl/model.ts';

/**
 * @param shipped whether the package has a class of its own for the model
 * @param measured the file that has the measurements, if the model is of some
 */
export function codeSample(
  model: Model,
  values: ParameterValues,
  shipped: boolean,
  measured?: string,
): string {
  const properties = changed(model.parameters, values).map(([name, text]) => `  ${name}: ${text},\n`);
  const literal = properties.length ? `{\n${properties.join('')}}` : '';
  if (shipped) {
    const name = `${className(model.name)}Material`;
    return `import { ${name} } from 'irradia';\n\nconst material = new ${name}(${literal});\n`;
  }
  if (measured !== undefined) {
    const file = JSON.stringify(measured);
    return [
      "import { BrdfMaterial, loadMeasured } from 'irradia';\n",
      `const bytes = new Uint8Array(await (await fetch(${file})).arrayBuffer());`,
      `const material = new BrdfMaterial(loadMeasured(bytes, ${file})${literal ? `, ${literal}` : ''});\n`,
    ].join('\n');
  }
  const file = JSON.stringify(model.file.fileName.replace(/^.*[/\\]/, ''));
  return [
    "import { BrdfMaterial, loadModel } from 'irradia';\n",
    `const source = await (await fetch(${file})).text();`,
    `const material = new BrdfMaterial(loadModel(source, ${file})${literal ? `, ${literal}` : ''});\n`,
  ].join('\n');
}

/** As tools/named-materials.mjs names the classes. */
function className(model: string): string {
  return model.replace(/(?:^|[-_])(\w)/g, (_, letter: string) => letter.toUpperCase());
}

function changed(parameters: readonly Parameter[], values: ParameterValues): [string, string][] {
  return parameters.flatMap((parameter): [string, string][] => {
    const value = values[parameter.name];
    const text = value === undefined ? '' : valueText(value);
    return text === '' || text === valueText(parameter.default) ? [] : [[parameter.name, text]];
  });
}

/** With four digits, which no eye can tell from more. */
export function valueText(value: ParameterValue): string {
  const digits = (x: number) => String(+x.toPrecision(4));
  if (typeof value === 'boolean') return String(value);
  return typeof value === 'number' ? digits(value) : `[${value.map(digits).join(', ')}]`;
}
