/** What each preset has, put together from what three.js ships: its physical material, its shadows, its display nodes. */
import { CSMShadowNode } from 'three/addons/csm/CSMShadowNode.js';
import { denoise } from 'three/addons/tsl/display/DenoiseNode.js';
import { dof } from 'three/addons/tsl/display/DepthOfFieldNode.js';
import { ao } from 'three/addons/tsl/display/GTAONode.js';
import { recurrentDenoise } from 'three/addons/tsl/display/RecurrentDenoiseNode.js';
import { smaa } from 'three/addons/tsl/display/SMAANode.js';
import { ssgi } from 'three/addons/tsl/display/SSGINode.js';
import { ssr } from 'three/addons/tsl/display/SSRNode.js';
import { sss } from 'three/addons/tsl/display/SSSNode.js';
import { temporalReproject } from 'three/addons/tsl/display/TemporalReprojectNode.js';
import { traa } from 'three/addons/tsl/display/TRAANode.js';
import {
  metalness,
  mrt,
  normalView,
  output,
  pass,
  renderOutput,
  roughness,
  vec2,
  vec4,
  velocity,
} from 'three/tsl';
import * as THREE from 'three/webgpu';
import type { Effects } from '../src/scene/effects-schema.ts';

type Vec4 = THREE.Node<'vec4'>;

/** A frame of a scene with the effects that these settings have. */
export function stockPipeline(
  renderer: THREE.WebGPURenderer,
  scene: THREE.Scene,
  camera: THREE.PerspectiveCamera,
  effects: Effects,
  fStop: number,
): THREE.RenderPipeline {
  const pipeline = new THREE.RenderPipeline(renderer);
  const over = effects.antialiasing.method === 'temporal';
  const single = effects.antialiasing.method !== 'msaa';
  const scenePass = pass(scene, camera, { samples: single ? 0 : 4 });
  const lens = effects.depthOfField.enabled && fStop > 0;
  const traced = effects.reflections.enabled || effects.indirectLight.enabled;
  const occluded = effects.ambientOcclusion.enabled && !effects.indirectLight.enabled;
  if (!(occluded || traced || over || lens)) {
    pipeline.outputNode = scenePass;
    return pipeline;
  }
  // Several samples a pixel serve the picture, not the data: a pass of its own, as three.js' examples do it.
  const data = single ? scenePass : pass(scene, camera, { samples: 0 });
  data.setMRT(
    mrt({ output, normal: vec4(normalView, 1), surface: vec4(vec2(metalness, roughness), 0, 1), velocity }),
  );
  const color = scenePass.getTextureNode('output');
  const depth = data.getTextureNode('depth');
  const normal = data.getTextureNode('normal');
  const surface = data.getTextureNode('surface');
  const motion = data.getTextureNode('velocity');
  let radiance = vec4(color) as Vec4;

  const gathered = (raw: THREE.TextureNode, mode: 'diffuse' | 'specular'): Vec4 => {
    const resolved = temporalReproject(raw as never, depth, normal, motion, camera, { mode });
    const filtered = recurrentDenoise(resolved as never, camera, {
      depth: depth as never,
      normal: normal as never,
      metalRoughness: surface as never,
      raw: raw as never,
      mode,
    });
    resolved.setHistoryTexture(filtered as never);
    return filtered as unknown as Vec4;
  };

  if (occluded) {
    const occlusion = ao(depth, normal as never, camera);
    occlusion.resolutionScale = effects.ambientOcclusion.halfResolution ? 0.5 : 1;
    const smooth = denoise(occlusion.getTextureNode() as never, depth, normal as never, camera);
    radiance = vec4(radiance.rgb.mul((smooth as unknown as Vec4).r), radiance.a) as Vec4;
  }
  if (effects.indirectLight.enabled) {
    const bounced = ssgi(color, depth, normal as never, camera);
    Object.assign(bounced, { resolutionScale: effects.indirectLight.halfResolution ? 0.5 : 1 });
    const filtered = gathered(bounced.getGINode() as never, 'diffuse');
    // It finds the occlusion, too, and so takes the place of GTAO.
    const occlusion = (bounced.getAONode() as unknown as Vec4).r;
    radiance = vec4(radiance.rgb.mul(occlusion).add(filtered.rgb), radiance.a) as Vec4;
  }
  if (effects.reflections.enabled) {
    const reflected = ssr(
      color as never,
      depth as never,
      normal as never,
      {
        stochastic: true,
        metalnessNode: (surface as unknown as Vec4).r as never,
        roughnessNode: (surface as unknown as Vec4).g as never,
        camera,
      } as never,
    );
    reflected.resolutionScale = effects.reflections.halfResolution ? 0.5 : 1;
    const filtered = gathered(
      (reflected as unknown as { getTextureNode(): THREE.TextureNode }).getTextureNode(),
      'specular',
    );
    radiance = vec4(radiance.rgb.add(filtered.rgb), radiance.a) as Vec4;
  }
  const sun = scene.getObjectByProperty('isDirectionalLight', true) as THREE.DirectionalLight;
  if (effects.contactShadows.enabled) {
    const contact = sss(depth, camera, sun);
    contact.maxDistance.value = effects.contactShadows.length;
    radiance = vec4(radiance.rgb.mul((contact.getTextureNode() as unknown as Vec4).r), radiance.a) as Vec4;
  }
  if (over) radiance = traa(radiance as never, depth, motion, camera) as unknown as Vec4;
  if (lens) radiance = dof(radiance as never, data.getViewZNode() as never, 4, 1, 2) as unknown as Vec4;
  if (effects.antialiasing.method === 'smaa') {
    // It looks for edges in the picture as it is shown.
    pipeline.outputColorTransform = false;
    radiance = smaa(renderOutput(radiance)) as unknown as Vec4;
  }
  pipeline.outputNode = radiance;
  return pipeline;
}

/** Stock shadows of these settings, for every light that can have them. */
export function stockShadows(scene: THREE.Scene, { shadows }: Effects): void {
  scene.traverse((object) => {
    if (object instanceof THREE.Mesh) object.castShadow = object.receiveShadow = shadows.enabled;
    if (!(object instanceof THREE.Light) || !('shadow' in object)) return;
    const light = object as THREE.DirectionalLight;
    light.castShadow = shadows.enabled;
    light.shadow.mapSize.set(shadows.resolution, shadows.resolution);
    if (!shadows.enabled || !light.isDirectionalLight) return;
    const cascades = new CSMShadowNode(light, { cascades: shadows.cascades, maxFar: 20, mode: 'practical' });
    (light.shadow as { shadowNode?: unknown }).shadowNode = cascades;
  });
}
