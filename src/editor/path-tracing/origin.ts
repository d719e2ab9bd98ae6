/** What a saved rendering says of where it is from. */
import { version } from '../../../package.json';
import { documentHash } from '../../pathtracer/record.ts';
import type { Document } from '../../scene/schema.ts';
import type { Origin } from './messages.ts';

/** @param exposure in EV, of the picture as it is shown */
export async function originOf(document: Document, exposure: number): Promise<Origin> {
  const { name, view, pathTracing } = document;
  const { samples, error } = pathTracing;
  return {
    version,
    // Not from a server without TLS, unless it is this machine: such a file merges with none.
    document: isSecureContext ? await documentHash(document) : '',
    name,
    until: error > 0 ? `error ${error}, ${samples} samples` : `samples 0:${samples}`,
    exposure,
    toneMapping: view.toneMapping,
  };
}
