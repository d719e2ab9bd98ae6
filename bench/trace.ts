/** What the page's thread did, from a trace of Chromium. */
import type { Browser, Page } from 'playwright-core';

export interface TaskTimes {
  /** Of the longest task, ms of the thread's own time. */
  readonly longest: number;
  /** How many took more than LONG. */
  readonly long: number;
  /** The longest by the clock on the wall, ms: with what else the machine does, and with waiting for the GPU. */
  readonly wall: number;
  /** What the longest task was made of, if that was asked for. */
  readonly made: string;
}

/** ms: what the page's thread should not spend at a stretch. */
export const LONG = 50;

interface ProfileNode {
  readonly id: number;
  readonly parent?: number;
  readonly callFrame: { readonly functionName: string; readonly url?: string; readonly lineNumber?: number };
}

interface TraceEvent {
  readonly name: string;
  readonly ph: string;
  readonly pid: number;
  readonly tid: number;
  /** Microseconds. */
  readonly ts: number;
  /** Microseconds by the thread's own clock. */
  readonly tdur?: number;
  readonly dur?: number;
  readonly id?: string;
  readonly args?: {
    readonly data?: {
      readonly startTime?: number;
      readonly cpuProfile?: { readonly nodes?: readonly ProfileNode[]; readonly samples?: readonly number[] };
      readonly timeDeltas?: readonly number[];
    };
  };
}

const MARK = 'irradia-bench';
const CATEGORIES = [
  'toplevel',
  'blink.user_timing',
  'disabled-by-default-devtools.timeline',
  'devtools.timeline',
  'v8',
];
const PROFILER = 'disabled-by-default-v8.cpu_profiler';

/** @param profiled with the calls of the longest task; sampling them costs time of its own */
export async function traced(
  browser: Browser,
  page: Page,
  profiled: boolean,
  run: () => Promise<void>,
): Promise<TaskTimes> {
  await browser.startTracing(page, { categories: profiled ? [...CATEGORIES, PROFILER] : CATEGORIES });
  await page.evaluate((mark) => void performance.mark(mark), MARK);
  await run();
  await page.evaluate((mark) => void performance.mark(mark), MARK);
  const { traceEvents } = JSON.parse((await browser.stopTracing()).toString()) as {
    traceEvents: TraceEvent[];
  };
  const [first, last] = traceEvents.filter(({ name, ph }) => name === MARK && ph !== 'E');
  if (!first || !last) throw new Error('the trace lacks the marks of the page');
  const own = traceEvents.filter(({ pid, tid }) => pid === first.pid && tid === first.tid);
  const tasks = own.filter(({ name, ts }) => name === 'RunTask' && ts >= first.ts && ts <= last.ts);
  const spent = tasks.map(({ tdur = 0 }) => tdur / 1000);
  const longest = Math.max(0, ...spent);
  return {
    longest,
    long: spent.filter((ms) => ms > LONG).length,
    wall: Math.max(0, ...tasks.map(({ dur = 0 }) => dur / 1000)),
    made: profiled
      ? tasks
          .filter(({ tdur = 0 }) => tdur / 1000 > Math.min(longest * 0.999, LONG * 0.6))
          .map((task) => composition(traceEvents, own, task))
          .join('\n')
      : '',
  };
}

/** The steps of a task that the browser names, and the calls within it, with the ms of each. */
function composition(all: readonly TraceEvent[], own: readonly TraceEvent[], task: TraceEvent): string {
  const end = task.ts + (task.dur ?? 0);
  const within = own.filter(
    ({ ph, ts, name }) => ph === 'X' && name !== 'RunTask' && ts >= task.ts && ts <= end,
  );
  const steps = new Map<string, number>();
  for (const { name, tdur = 0 } of within) steps.set(name, (steps.get(name) ?? 0) + tdur / 1000);
  const lines = [
    `task of ${((task.tdur ?? 0) / 1000).toFixed(0)} ms (wall ${((task.dur ?? 0) / 1000).toFixed(0)})`,
  ];
  const named = [...steps].filter(([, ms]) => ms > 1).sort((a, b) => b[1] - a[1]);
  lines.push(`  ${named.map(([name, ms]) => `${name} ${ms.toFixed(0)}`).join(', ')}`);
  lines.push(...calls(all, task));
  return lines.join('\n');
}

interface Call {
  ms: number;
  readonly callees: Map<string, Call>;
}

/** The tree of calls that were sampled in a task, with their parts of its time. */
function calls(all: readonly TraceEvent[], task: TraceEvent): string[] {
  const { pid, tid, ts, dur = 0, tdur = 0 } = task;
  const start = all.find((event) => event.name === 'Profile' && event.pid === pid && event.tid === tid);
  const nodes = new Map<number, ProfileNode>();
  const calls = new Map<string, Call>();
  let at = start?.args?.data?.startTime ?? 0;
  for (const { name, pid: of, id, args } of all) {
    if (of !== pid || id !== start?.id || !name.startsWith('Profile')) continue;
    for (const node of args?.data?.cpuProfile?.nodes ?? []) nodes.set(node.id, node);
    for (const [i, sample] of (args?.data?.cpuProfile?.samples ?? []).entries()) {
      const delta = args?.data?.timeDeltas?.[i] ?? 0;
      at += delta;
      if (at < ts || at > ts + dur) continue;
      let level = calls;
      for (const name of stackOf(nodes, sample)) {
        const call = level.get(name) ?? { ms: 0, callees: new Map() };
        // The profiler's clock is the wall's.
        call.ms += (delta / 1000) * (tdur / dur);
        level.set(name, call);
        level = call.callees;
      }
    }
  }
  return [...listed(calls, 2)];
}

function stackOf(nodes: ReadonlyMap<number, ProfileNode>, sample: number): string[] {
  const stack: string[] = [];
  for (let node = nodes.get(sample); node?.parent !== undefined; node = nodes.get(node.parent)) {
    const { functionName, lineNumber = 0 } = node.callFrame;
    stack.unshift(`${functionName || '(anonymous)'}:${lineNumber + 1}`);
  }
  return stack;
}

/** ms: less is not listed. */
const LEAST = 0.7;

function* listed(calls: ReadonlyMap<string, Call>, depth: number): Generator<string> {
  for (const [name, { ms, callees }] of [...calls].sort(([, a], [, b]) => b.ms - a.ms)) {
    if (ms < LEAST) continue;
    yield `${' '.repeat(depth)}${ms.toFixed(1)} ${name}`;
    yield* listed(callees, depth + 1);
  }
}
