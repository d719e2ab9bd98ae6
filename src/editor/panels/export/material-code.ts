/** A material of a document as code for a program with three.js and the package. */
import { codeSample, valueText } from '../../../analysis/fit/code-sample.ts';
import { findModel } from '../../../scene/models.ts';
import type { Document } from '../../../scene/schema.ts';

/** Null if its model is not there. Its textures are not part of it. */
export function materialCode(document: Document, id: string): string | null {
  const material = document.materials[id];
  const model = material && findModel(document, material.model);
  if (!material || !model) return null;
  const source = Object.hasOwn(document.models, material.model) ? document.models[material.model] : undefined;
  const measured = source && 'measured' in source ? document.assets[source.measured]?.name : undefined;
  const lines: string[] = [];
  if (Math.max(...material.emissive) > 0) {
    lines.push(`material.emissive.setRGB(${valueText(material.emissive).slice(1, -1)});`);
    lines.push(`material.emissiveIntensity = ${valueText(material.emissiveIntensity)};`);
  }
  if (material.alphaMode !== 'opaque') lines.push(`material.opacity = ${valueText(material.opacity)};`);
  if (material.alphaMode === 'blend') lines.push('material.transparent = true;');
  if (material.alphaMode === 'mask') lines.push(`material.alphaTest = ${valueText(material.alphaCutoff)};`);
  // three.js's DoubleSide is 2.
  if (material.doubleSided) lines.push('material.side = 2;');
  const code = codeSample(model, material.parameters, source === undefined, measured);
  return code + lines.map((line) => `${line}\n`).join('');
}
