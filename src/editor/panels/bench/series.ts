/** The curves of the bench: one that follows the selected material, one for each pin. */
import type { Reflectance } from '../../../analysis/plots/curve.ts';
import { createQuickEvaluator } from '../../../analysis/quick-evaluator.ts';
import type { FloatParameter } from '../../../brdf/model.ts';
import { createEvaluator, type Evaluator } from '../../../glsl/evaluator.ts';
import { findModel, modelOrigin } from '../../../scene/models.ts';
import type { Document } from '../../../scene/schema.ts';
import { selectedMaterial } from '../../selected-material.ts';
import type { Selection } from '../../state.ts';
import type { SweptParameter } from './frame.ts';
import { CURRENT, CURRENT_COLOR, type OwnModel, type Pin } from './settings.ts';

/** A model, its parameters and where the model comes from: enough to evaluate it, here or in a worker. */
export interface Subject {
  readonly id: string;
  readonly name: string;
  readonly color: string;
  readonly model: string;
  readonly source: OwnModel | null;
  readonly parameters: Readonly<Record<string, unknown>>;
}

export function subjectsOf(document: Document, selection: Selection, pins: readonly Pin[]): Subject[] {
  const id = selectedMaterial(document, selection);
  const material = id === undefined ? undefined : document.materials[id];
  if (!material) return [...pins];
  const { name, model, parameters } = material;
  const source = ownModel(document, model);
  return [{ id: CURRENT, name, model, source, parameters, color: CURRENT_COLOR }, ...pins];
}

/** The same object as long as the model stays the same: curves are computed anew when it changes. */
const ownModels = new WeakMap<object, OwnModel>();

export function ownModel(document: Document, name: string): OwnModel | null {
  const origin = modelOrigin(document, name);
  const entry = document.models[name];
  if (!origin || !entry || !Object.hasOwn(document.models, name)) return null;
  const known = ownModels.get(origin);
  if (known && Object.hasOwn(known.models, name)) return known;
  const assets = 'measured' in entry && 'data' in origin ? { [entry.measured]: origin } : {};
  const own = { models: { [name]: entry }, assets };
  ownModels.set(origin, own);
  return own;
}

/** The terms of a subject's model; none where the model is missing or broken. */
export function termsOf(subject: Subject): readonly string[] {
  try {
    return modelOf(subject)?.terms ?? [];
  } catch {
    // The inspector says what is wrong with the model; the bench has nothing to draw.
    return [];
  }
}

/** A number of the first subject's model: that of the given name, or the first there is. */
export function sweptParameter(subject: Subject | undefined, name: string): SweptParameter | null {
  const numbers = numbersOf(subject);
  const found = numbers.find((parameter) => parameter.name === name) ?? numbers[0];
  if (!found || !subject) return null;
  const value = subject.parameters[found.name];
  const { min, max } = found;
  return { name: found.name, min, max, value: typeof value === 'number' ? value : found.default };
}

/** The parameters of a subject's model that are numbers. */
export function numbersOf(subject: Subject | undefined): readonly FloatParameter[] {
  try {
    const parameters = (subject && modelOf(subject)?.parameters) ?? [];
    return parameters.filter((parameter) => parameter.type === 'float');
  } catch {
    // As in termsOf().
    return [];
  }
}

/** @throws if it is broken */
export function modelOf({ model, source }: Pick<Subject, 'model' | 'source'>) {
  return findModel(source ?? { models: {}, assets: {} }, model);
}

/** @throws if there is no such model, it is broken, or a parameter does not suit it */
export function evaluatorOf(subject: Pick<Subject, 'model' | 'source' | 'parameters'>): Evaluator {
  const model = modelOf(subject);
  if (!model) throw new Error(`there is no model ${subject.model}`);
  return createEvaluator(model, subject.parameters);
}

/** One term of a subject as functions of l and v. */
export interface SubjectReflectance {
  /** In float32, for what is drawn. */
  readonly quick: Reflectance;
  /** In float64, for what is read. */
  readonly exact: Reflectance;
}

interface Kept extends SubjectReflectance {
  readonly subject: Subject;
  readonly term: string;
  readonly evaluator: Evaluator;
}

/** Keeps an evaluator for each subject: making one is far slower than setting its parameters. */
export class Evaluators {
  readonly #kept = new Map<string, Kept>();

  /** The same functions as long as model and parameters stay; null where there is no such term. */
  reflectance(subject: Subject, term: string): SubjectReflectance | null {
    if (!termsOf(subject).includes(term)) return null;
    const kept = this.#kept.get(subject.id);
    const sameModel = kept?.subject.model === subject.model && kept.subject.source === subject.source;
    const sameValues = kept?.subject.parameters === subject.parameters;
    if (kept && sameModel && sameValues && kept.term === term) return kept;
    const evaluator = kept && sameModel ? kept.evaluator : evaluatorOf(subject);
    if (sameModel && !sameValues) evaluator.set(subject.parameters);
    const { f: evaluate } = evaluator;
    const exact: Reflectance = (l, v) => evaluate(l, v, undefined, term);
    const quick = createQuickEvaluator(evaluator.model, subject.parameters).term(term);
    const now = { subject, term, evaluator, exact, quick };
    this.#kept.set(subject.id, now);
    return now;
  }
}
