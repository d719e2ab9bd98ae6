/** Measured BRDFs as models like any other. It stands here because it joins a format of io to a lookup of models. */
import { compileMeasured } from '../../models/index.ts';
import type { Model } from '../glsl/model.ts';
import { PACKED_MERL_TYPE, packMerl, readMerl } from '../io/merl.ts';
import { encodeBase64 } from './base64.ts';
import type { Asset } from './schema.ts';

/**
 * The model of a file of measurements: a MERL `.binary`.
 *
 * @throws ByteError naming the file, the byte and what is wrong there
 */
export function loadMeasured(bytes: Uint8Array, fileName: string): Model {
  const name = fileName.replace(/^.*[/\\]/, '').replace(/\.[A-Za-z0-9]+$/, '') || 'measured';
  return compileMeasured('merl', readMerl(bytes, fileName), name);
}

/**
 * A file of measurements as a document keeps it: packed to a quarter of its size.
 *
 * @throws ByteError as loadMeasured()
 */
export function measuredAsset(bytes: Uint8Array, fileName: string): Asset {
  const data = encodeBase64(packMerl(readMerl(bytes, fileName)));
  return { name: fileName.replace(/^.*[/\\]/, '').slice(0, 200), mediaType: PACKED_MERL_TYPE, data };
}
