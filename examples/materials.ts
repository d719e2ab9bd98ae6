/** Five spheres with Irradia's materials in a plain three.js scene: `npx vite examples`. */
import { BrdfMaterial, BrdfSpotLight, CookTorranceMaterial, loadModel, PrincipledMaterial } from 'irradia';
import * as THREE from 'three/webgpu';

// A model of your own is a file; here it is a string.
const minnaert = loadModel(
  `analytic
# Minnaert's law of 1941: the Moon, and velvet.
::begin parameters
float k 0 2 .6    # darkening towards the edge
::end parameters
::begin shader
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
  return vec3(pow(max(dot(N, L) * dot(N, V), 1e-4), k - 1) / 3.14159265);
}
::end shader`,
  'minnaert.brdf',
);

const gold = new PrincipledMaterial({ baseColor: [1, 0.71, 0.29], metallic: 1, roughness: 0.3 });
const materials = [
  gold,
  new PrincipledMaterial({ baseColor: [0.5, 0.02, 0.02], roughness: 0.4, clearcoat: 1 }),
  new PrincipledMaterial({ baseColor: [0.05, 0.08, 0.3], roughness: 0.9, sheen: 1 }),
  new CookTorranceMaterial({ albedo: [0.1, 0.4, 0.2], roughness: 0.25, ior: 1.6 }),
  new BrdfMaterial(minnaert),
];

const renderer = new THREE.WebGPURenderer({ antialias: true });
renderer.setSize(innerWidth, innerHeight);
renderer.toneMapping = THREE.NeutralToneMapping;
document.body.append(renderer.domElement);

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x202428);
const sphere = new THREE.SphereGeometry(0.5, 64, 32);
for (const [i, material] of materials.entries()) {
  const mesh = new THREE.Mesh(sphere, material);
  mesh.position.x = (i - 2) * 1.2;
  scene.add(mesh);
}
const sun = new THREE.DirectionalLight(0xffffff, 3);
sun.position.set(2, 3, 4);
const spot = new BrdfSpotLight(0xffe0c0, 60, 0.6, 8); // cd, cut-off in radians, exponent
spot.position.set(-3, 3, 3);
scene.add(new THREE.AmbientLight(0xffffff, 0.6), sun, spot, spot.target);

const camera = new THREE.PerspectiveCamera(30, innerWidth / innerHeight, 0.1, 50);
camera.position.z = 9;
renderer.setAnimationLoop((time) => {
  gold.roughness = 0.3 + 0.2 * Math.sin(time / 1000);
  renderer.render(scene, camera);
});
