/** Draws the map of one law. To cancel it, end the worker. */
import { heatMap } from '../../../analysis/verdict/heat-map.ts';
import type { HeatMapAnswer, HeatMapJob } from './heat-map-job.ts';
import { modelOf } from './series.ts';

const answer = (message: HeatMapAnswer) => self.postMessage(message);

self.addEventListener('message', async ({ data }: MessageEvent<HeatMapJob>) => {
  try {
    const model = modelOf(data);
    if (!model) throw new Error(`there is no model ${data.model}`);
    const { property, axes } = data;
    const map = await heatMap(model, {
      property,
      ...(axes && { axes }),
      onProgress: (done) => answer({ kind: 'progress', done }),
    });
    answer({ kind: 'map', map });
  } catch (error) {
    answer({ kind: 'error', message: error instanceof Error ? error.message : String(error) });
  }
});
