/** A line that is overwritten while work goes on, only where a person watches. */
export function progressLine(wanted: boolean): (done: number, text: string) => void {
  if (!wanted || !process.stderr.isTTY) return () => {};
  let width = 0;
  return (done, text) => {
    const line = done < 1 ? `${Math.round(100 * done)} % ${text}` : '';
    process.stderr.write(`\r${line.padEnd(width)}${done < 1 ? '' : '\r'}`);
    width = line.length;
  };
}
