/** A line on standard error. */
export const say = (text: string): void => void process.stderr.write(`irradia: ${text}\n`);
