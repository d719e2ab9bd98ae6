/** A material as tracer of rays: directions drawn by the model itself, so that its own lobes shape what they find. */
import { dot, float, If, normalViewGeometry, vec2, vec3 } from 'three/tsl';
import type { Node } from 'three/webgpu';
import type { EnvironmentLightNode } from './environment-light.ts';
import type { RayTracer } from './frame-context.ts';
import { albedoOf, type Reflector, sharpness, sumOf } from './light-from-everywhere.ts';
import { latticePoint } from './sampler.ts';
import { repeat } from './statements.ts';

type Vec3 = Node<'vec3'>;
type Float = Node<'float'>;

/** Reflectances below this are too dark for what they reflect to matter. */
const LEAST = 1e-3;

/**
 * What rays find is counted less the far light of their direction, which the material gathers by itself, with more
 * directions and without noise: where rays find nothing, nothing changes.
 */
export function traceRays(
  { frame, sampler, hasTable, f }: Reflector,
  environment: EnvironmentLightNode | null,
  ambient: Vec3 | null,
  tracer: RayTracer,
): void {
  const { V, N, X, Y } = frame;
  const { rays, reflections, indirectLight } = tracer;
  const albedo = hasTable ? (albedoOf(frame).toVar() as Vec3) : null;
  sampler.start(V, N, X, Y);
  const shift = tracer.shift().toVar() as Node<'vec2'>;
  const [wide, sharp, weights] = [vec3(0).toVar(), vec3(0).toVar(), vec3(0).toVar()] as [Vec3, Vec3, Vec3];
  const [spread, parts] = [float(0).toVar(), float(1e-6).toVar()] as [Float, Float];
  const add = (sum: Node, value: Node) =>
    (sum as unknown as { addAssign(value: Node): void }).addAssign(value);
  repeat(rays, (i) => {
    const u = latticePoint(i, rays);
    const place = vec2(u.x, u.y).add(shift).fract() as unknown as Node<'vec2'>;
    const L = sampler.sampleL(place, V, N, X, Y).toVar() as Vec3;
    const cosine = dot(N, L).toVar() as Float;
    If(cosine.greaterThan(0), () => {
      const density = sampler.pdf(L, V, N, X, Y).toVar() as Float;
      If(density.greaterThan(0), () => {
        const weight = f(L).mul(cosine.div(density)).toVar() as Vec3;
        add(weights, weight);
        const part = sharpness(density).toVar() as Float;
        // Below the mesh's own plane there is only itself.
        const wanted = dot(normalViewGeometry as unknown as Vec3, L)
          .greaterThan(0)
          .and(
            (reflections ? part : float(0)).add(indirectLight ? part.oneMinus() : float(0)).greaterThan(0.01),
          );
        If(wanted, () => {
          const ray = tracer.trace(L, density, part);
          add(spread, ray.spread.mul(part));
          add(parts, part);
          If(ray.share.greaterThan(0), () => {
            const far = sumOf(environment?.radiance(L, density.mul(rays) as Float), ambient);
            const more = ray.radiance.sub(far).mul(weight).mul(ray.share).toVar() as Vec3;
            if (indirectLight) add(wide, more.mul(part.oneMinus()));
            if (reflections) add(sharp, more.mul(part));
          });
        });
      });
    });
  });
  const mean = (albedo ? albedo.max(LEAST).mul(rays) : weights.max(LEAST)).reciprocal() as Vec3;
  tracer.write(wide.mul(mean) as Vec3, sharp.mul(mean) as Vec3, spread.div(parts) as Float);
}
