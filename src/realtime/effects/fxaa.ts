/** Anti-aliasing of the finished picture, the quick one: T. Lottes, 2011, "FXAA", as three.js has it. */
import FXAANode from 'three/addons/tsl/display/FXAANode.js';
import { UnsignedByteType } from 'three/webgpu';
import type { Effect, EffectDefinition } from '../frame/effect.ts';
import { inputTexture, Pass } from '../frame/pass.ts';

function build(): Effect {
  const source = inputTexture();
  const pass = new Pass('FXAA', new FXAANode(source), { type: UnsignedByteType });
  return {
    afterOutput(renderer, input) {
      source.value = input.texture;
      return pass.render(renderer, input.width, input.height);
    },
    dispose: () => pass.dispose(),
  };
}

export const fxaa: EffectDefinition = {
  name: 'antialiasing',
  isOn: ({ effects }) => effects.antialiasing.method === 'fxaa',
  variant: () => 'fxaa',
  needsSurfaces: false,
  build,
};
