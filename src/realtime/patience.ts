/** Waits for a promise, but not for ever. @returns whether it was settled within that time, in ms, one way or the other */
export function settledWithin(ms: number, promise: Promise<unknown>): Promise<boolean> {
  return new Promise((resolve) => {
    const timer = setTimeout(() => resolve(false), ms);
    const settled = () => {
      // A process of Node's ends only when nothing is left to wait for.
      clearTimeout(timer);
      resolve(true);
    };
    promise.then(settled, settled);
  });
}
