/** The command line: the process around a call. */
import { irradia } from './irradia.ts';

// `irradia brdf list | head -1` closes the pipe early; that is no error.
process.stdout.on('error', (error: NodeJS.ErrnoException) => {
  if (error.code !== 'EPIPE') throw error;
  process.exit(0);
});

const code = await irradia(process.argv.slice(2));
// Dawn keeps threads that would hold the process; what was written must be out before it ends.
process.stdout.write('', () => process.exit(code));
