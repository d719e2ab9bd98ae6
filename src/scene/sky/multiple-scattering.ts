/**
 * Light that air and ground scatter more than once: its mean over all directions, by height and by the sun's elevation.
 *
 * Orders of scattering are found one after the other, as by E. Bruneton and F. Neyret, 2008, "Precomputed Atmospheric
 * Scattering"; that what is scattered again goes evenly into all directions is from S. Hillaire, 2020, "A Scalable and
 * Production Ready Sky and Atmosphere Rendering Technique". What haze scatters straight on counts as not scattered.
 */
import { type Atmosphere, BANDS, EARTH_RADIUS, rayleighPhase, turningPhase } from './atmosphere.ts';
import { march, sunlightAt } from './ray-march.ts';

const HEIGHTS = 10;
const HIGHEST = 50_000;
const ELEVATIONS = 24;
/** In degrees: below this the sun lights no air. */
const LOWEST = -20;
/** Nodes lie closer about the horizon. */
const POWER = 1.6;
const LEAST = -((-LOWEST / 90) ** (1 / POWER));

const ZENITHS = 12;
const AZIMUTHS = 4;
const STEPS = 10;
/** So many are found one by one; the rest as a geometric series. */
const ORDERS = 5;
/** Of an order to the one before it; in any air some light is lost. */
const MOST_RATIO = 0.95;

export interface ScatteredLight {
  /** Mean radiance over all directions, of each band for 1 lx from the sun outside the air. */
  mean(radius: number, sunCosine: number, out: Float64Array): void;
  /** What the ground has from sun and sky, by the sun's zenith cosine. */
  groundIrradiance(sunCosine: number, out: Float64Array): void;
}

const heightOf = (i: number): number => HIGHEST * (i / (HEIGHTS - 1)) ** 2;
const sineOf = (i: number): number => {
  const w = LEAST + (i / (ELEVATIONS - 1)) * (1 - LEAST);
  return Math.sin((Math.PI / 2) * Math.sign(w) * Math.abs(w) ** POWER);
};

/** Where a sun stands between the nodes. */
function placeOfSun(cosine: number): number {
  const part = Math.asin(Math.min(1, Math.max(-1, cosine))) / (Math.PI / 2);
  const w = Math.sign(part) * Math.abs(part) ** (1 / POWER);
  return Math.min(Math.max((w - LEAST) / (1 - LEAST), 0), 1) * (ELEVATIONS - 1);
}

/** Adds what a table by the sun's elevation has between its nodes. */
function readSun(table: Float64Array, offset: number, place: number, out: Float64Array, scale: number): void {
  const i = Math.min(Math.floor(place), ELEVATIONS - 2);
  const far = scale * (place - i);
  const near = scale - far;
  const at = offset + i * BANDS;
  for (let b = 0; b < BANDS; b += 1) out[b] = out[b]! + near * table[at + b]! + far * table[at + BANDS + b]!;
}

/** The same by height and by the sun's elevation. */
function read(table: Float64Array, height: number, sun: number, out: Float64Array): void {
  const i = Math.min(Math.floor(height), HEIGHTS - 2);
  const t = height - i;
  const s = Math.min(Math.floor(sun), ELEVATIONS - 2);
  const [farBelow, farAbove] = [(1 - t) * (sun - s), t * (sun - s)];
  const [nearBelow, nearAbove] = [1 - t - farBelow, t - farAbove];
  const below = i * LAYER + s * BANDS;
  const above = below + LAYER;
  for (let b = 0; b < BANDS; b += 1)
    out[b] =
      out[b]! +
      nearBelow * table[below + b]! +
      farBelow * table[below + BANDS + b]! +
      nearAbove * table[above + b]! +
      farAbove * table[above + BANDS + b]!;
}
const LAYER = ELEVATIONS * BANDS;

const placeOfHeight = (radius: number): number =>
  Math.sqrt(Math.min(Math.max(radius - EARTH_RADIUS, 0), HIGHEST) / HIGHEST) * (HEIGHTS - 1);

export function scatteredLight(air: Atmosphere): ScatteredLight {
  const rays = Array.from({ length: HEIGHTS }, (_, i) => raysFrom(air, EARTH_RADIUS + heightOf(i)));
  const total = new Float64Array(HEIGHTS * LAYER);
  const totalGround = new Float64Array(LAYER);
  const first = firstOrder(air, rays);
  add(totalGround, first.direct);
  let order: Order = first;
  for (let n = 1; n < ORDERS; n += 1) {
    add(total, order.mean);
    add(totalGround, order.ground);
    const next = nextOrder(air, rays, order);
    // What later orders add falls off as between the last two.
    if (n === ORDERS - 1) {
      addRest(total, order.mean, next.mean);
      addRest(totalGround, order.ground, next.ground);
    }
    order = next;
  }
  return {
    mean(radius, sunCosine, out) {
      out.fill(0);
      read(total, placeOfHeight(radius), placeOfSun(sunCosine), out);
    },
    groundIrradiance(sunCosine, out) {
      out.fill(0);
      readSun(totalGround, 0, placeOfSun(sunCosine), out, 1);
    },
  };
}

interface Order {
  /** By height and sun. */
  readonly mean: Float64Array;
  /** On the ground, by the sun. */
  readonly ground: Float64Array;
}

type Ray = ReturnType<typeof raysFrom>[number];

/** Calls back for each ray of each node; what it leaves in `found` is the sum over the azimuths. */
function gather(
  rays: readonly (readonly Ray[])[],
  found: Float64Array,
  along: (ray: Ray, sine: number, cosine: number, first: number) => void,
): Order {
  const mean = new Float64Array(HEIGHTS * LAYER);
  const ground = new Float64Array(LAYER);
  for (let i = 0; i < HEIGHTS; i += 1) {
    for (let s = 0; s < ELEVATIONS; s += 1) {
      const sine = sineOf(s);
      const at = (i * ELEVATIONS + s) * BANDS;
      for (const ray of rays[i]!) {
        found.fill(0);
        for (let a = 0; a < AZIMUTHS; a += 1) {
          const level = ray.sine * Math.sqrt(1 - sine * sine) * AZIMUTH_COSINES[a]!;
          along(ray, sine, ray.cosine * sine + level, (s * AZIMUTHS + a) * STEPS);
        }
        const share = ray.weight / 2 / AZIMUTHS;
        for (let b = 0; b < BANDS; b += 1) {
          mean[at + b] = mean[at + b]! + share * found[b]!;
          if (i === 0 && ray.cosine > 0)
            ground[s * BANDS + b] = ground[s * BANDS + b]! + 4 * Math.PI * share * ray.cosine * found[b]!;
        }
      }
    }
  }
  return { mean, ground };
}

const AZIMUTH_COSINES = Array.from({ length: AZIMUTHS }, (_, a) =>
  Math.cos((Math.PI * (a + 0.5)) / AZIMUTHS),
);

/** Sunlight that is scattered once or reflected by the ground, and what of it reaches the ground unscattered. */
function firstOrder(air: Atmosphere, rays: readonly (readonly Ray[])[]): Order & { direct: Float64Array } {
  const direct = new Float64Array(LAYER);
  const light = new Float64Array(BANDS);
  for (let s = 0; s < ELEVATIONS; s += 1) {
    sunlightAt(air, EARTH_RADIUS, sineOf(s), light);
    for (let b = 0; b < BANDS; b += 1) direct[s * BANDS + b] = light[b]! * Math.max(0, sineOf(s));
  }
  const found = new Float64Array(BANDS);
  const order = gather(rays, found, (ray, sine, cosine) => {
    const [pr, ph] = [rayleighPhase(cosine), turningPhase(cosine)];
    for (const { distance, radius, rayleigh, haze } of ray.points) {
      sunlightAt(air, radius, (sine * ray.radius + cosine * distance) / radius, light);
      for (let b = 0; b < BANDS; b += 1)
        found[b] = found[b]! + light[b]! * (rayleigh[b]! * pr + haze[b]! * ph);
    }
    if (ray.meetsGround) addGround(air, ray, sine, cosine, direct, found);
  });
  return { ...order, direct };
}

function nextOrder(air: Atmosphere, rays: readonly (readonly Ray[])[], before: Order): Order {
  const found = new Float64Array(BANDS);
  const light = new Float64Array(BANDS);
  return gather(rays, found, (ray, sine, cosine, first) => {
    for (let k = 0; k < STEPS; k += 1) {
      const { rayleigh, haze, height } = ray.points[k]!;
      light.fill(0);
      read(before.mean, height, ray.suns[first + k]!, light);
      for (let b = 0; b < BANDS; b += 1) found[b] = found[b]! + light[b]! * (rayleigh[b]! + haze[b]!);
    }
    if (ray.meetsGround) addGround(air, ray, sine, cosine, before.ground, found);
  });
}

function addGround(
  air: Atmosphere,
  ray: Ray,
  sine: number,
  cosine: number,
  irradiance: Float64Array,
  found: Float64Array,
): void {
  const light = new Float64Array(BANDS);
  const sun = (sine * ray.radius + cosine * ray.length) / EARTH_RADIUS;
  readSun(irradiance, 0, placeOfSun(sun), light, 1 / Math.PI);
  for (let b = 0; b < BANDS; b += 1)
    found[b] = found[b]! + light[b]! * air.ground[b]! * ray.transmittance[b]!;
}

function add(to: Float64Array, from: Float64Array): void {
  for (let i = 0; i < to.length; i += 1) to[i] = to[i]! + from[i]!;
}

/** The sum of a geometric series from `last` on. */
function addRest(to: Float64Array, before: Float64Array, last: Float64Array): void {
  for (let i = 0; i < to.length; i += 1) {
    const ratio = before[i]! > 0 ? Math.min(last[i]! / before[i]!, MOST_RATIO) : 0;
    to[i] = to[i]! + last[i]! / (1 - ratio);
  }
}

/** The zenith's cosines are spread over sky and ground apart, close to the horizon; their weights sum to 2. */
function raysFrom(air: Atmosphere, radius: number) {
  const horizon = -Math.sqrt(Math.max(0, 1 - (EARTH_RADIUS / radius) ** 2));
  const half = ZENITHS / 2;
  return Array.from({ length: ZENITHS }, (_, i) => {
    const isUp = i < half;
    const span = isUp ? 1 - horizon : horizon + 1;
    const edge = (k: number) => span * (k / half) ** 2;
    const k = isUp ? i : i - half;
    const [from, to] = [edge(k), edge(k + 1)];
    const middle = (from + to) / 2;
    const cosine = isUp ? horizon + middle : horizon - middle;
    const sine = Math.sqrt(1 - cosine * cosine);
    const path = march(air, radius, cosine, STEPS);
    const points = path.points.map((point) => ({ ...point, height: placeOfHeight(point.radius) }));
    // Where the sun stands over each point, for each of its elevations and azimuths.
    const suns = new Float64Array(ELEVATIONS * AZIMUTHS * STEPS);
    for (let at = 0; at < suns.length; at += 1) {
      const { distance, radius: there } = points[at % STEPS]!;
      const sun = sineOf(Math.floor(at / STEPS / AZIMUTHS));
      const azimuth = AZIMUTH_COSINES[Math.floor(at / STEPS) % AZIMUTHS]!;
      const towards = cosine * sun + sine * Math.sqrt(1 - sun * sun) * azimuth;
      suns[at] = placeOfSun((sun * radius + towards * distance) / there);
    }
    return { ...path, points, suns, radius, cosine, sine, weight: to - from };
  });
}
