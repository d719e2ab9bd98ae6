import type { Reporter, TestModule } from 'vitest/node';

/** Closes the run with one line that people and machines can read: `N passed, N failed`. */
export default class ClosingLine implements Reporter {
  onTestRunEnd(modules: readonly TestModule[], unhandledErrors: readonly unknown[]): void {
    let passed = Number(process.env.IRRADIA_CHECKS_PASSED ?? 0);
    let failed = Number(process.env.IRRADIA_CHECKS_FAILED ?? 0) + unhandledErrors.length;
    let skipped = 0;
    for (const module of modules) {
      // A file that could not be loaded, or whose hooks failed, has no failed test to show for it.
      failed += module.errors().length;
      for (const suite of module.children.allSuites()) failed += suite.errors().length;
      for (const test of module.children.allTests()) {
        const { state } = test.result();
        if (state === 'passed') passed += 1;
        else if (state === 'failed') failed += 1;
        else skipped += 1;
      }
    }
    console.log(`${passed} passed, ${failed} failed${skipped ? `, ${skipped} skipped` : ''}`);
  }
}
