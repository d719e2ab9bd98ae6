/** A material that one can start from: a model, its values, and where they come from. */
import type { ParameterValue } from '../../brdf/model.ts';
import type { Material } from '../../scene/schema.ts';

export const categories = [
  'metals',
  'transparent',
  'plastics',
  'paints',
  'car paint',
  'fabrics',
  'skin',
  'wax',
  'food',
  'wood',
  'stone',
  'ceramics',
  'rubber',
  'paper',
  'ground',
] as const;
export type Category = (typeof categories)[number];

/** What of a material is its look; the rest of it is textures, transparency and light of its own. */
export interface Look {
  readonly model: string;
  /** Complete but for what stays at the model's default. */
  readonly parameters: Readonly<Record<string, ParameterValue>>;
  readonly multipleScattering: boolean;
}

export interface LibraryEntry {
  readonly id: string;
  /** English. */
  readonly title: string;
  readonly category: Category;
  readonly look: Look;
  /** Where the values come from, what is measured and what is judged by eye. English. */
  readonly source: string;
}

/** A document's material of that look. */
export function materialOf({ title, look }: Pick<LibraryEntry, 'title' | 'look'>): Partial<Material> {
  const { model, parameters, multipleScattering } = look;
  return {
    name: title,
    model,
    parameters: structuredClone(parameters) as Material['parameters'],
    multipleScattering,
  };
}
