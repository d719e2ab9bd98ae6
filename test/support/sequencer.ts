import { BaseSequencer, type TestSpecification } from 'vitest/node';

/** The kinds of test, the quick ones first: what is wrong is seen soon. */
const KINDS = ['unit', 'e2e', 'gpu'];

/** Short files that take long. Of the others Vitest begins with the largest. */
const LONG = [
  'analysis/verdict/verdict.test.ts',
  'cli/brdf-check.test.ts',
  'cli/main.test.ts',
  'models/plausible.test.ts',
  'models/samplers.test.ts',
  'e2e/accessibility.e2e.test.ts',
  'e2e/lessons.e2e.test.ts',
  'e2e/presets.e2e.test.ts',
  'e2e/scenes.e2e.test.ts',
  'material/pixel-equals-equation.e2e.test.ts',
  'realtime/effects/back-ends.e2e.test.ts',
  'cli/measured.gpu.test.ts',
  'material/pixel-equals-equation.gpu.test.ts',
  'realtime/effects/ambient-occlusion.gpu.test.ts',
  'realtime/golden/golden.gpu.test.ts',
  'scene/soak.gpu.test.ts',
];
const rank = ({ moduleId }: TestSpecification): number =>
  LONG.some((name) => moduleId.endsWith(name)) ? 0 : 1;

/** One kind of test after the other, and of each the long files first: a run ends with many short ones on all cores. */
export default class LongestFirst extends BaseSequencer {
  override async sort(files: TestSpecification[]): Promise<TestSpecification[]> {
    const kind = ({ project }: TestSpecification) => KINDS.indexOf(project.name);
    return (await super.sort(files)).sort((a, b) => kind(a) - kind(b) || rank(a) - rank(b));
  }
}
