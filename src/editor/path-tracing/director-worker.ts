/** The director's thread. Assets are decoded and scenes are packed here: nothing of it is the page's work. */
import { ScenePacker } from '../../pathtracer/scene/pack.ts';
import { AssetLoader } from '../../scene/assets.ts';
import { pageAssets } from '../../scene/page-assets.ts';
import { openStage } from './back-end.ts';
import { createDenoiser } from './denoiser.ts';
import { Director } from './director.ts';
import type { FromDirector, ToDirector } from './messages.ts';

const post = (message: FromDirector, transfer: Transferable[] = []) =>
  self.postMessage(message, { transfer });
const packer = new ScenePacker(new AssetLoader(pageAssets));
const director = new Director({
  pack: (document, options) => packer.pack(document, options),
  open: () => openStage((device) => post({ kind: 'device', device })),
  denoise: createDenoiser(),
  post,
});
self.addEventListener('message', ({ data }: MessageEvent<ToDirector>) => director.receive(data));
