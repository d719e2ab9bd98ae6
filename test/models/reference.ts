/**
 * The models of the thesis, written from its formulas and from nothing else: not fast, not careful at
 * degenerate spots, but independent of models/ so that the two can be compared.
 *
 * E. Yerga, 2018, "Iluminación basada en la física para gráficos por computador", algorithms 3 and 4.
 * n = +z, x = +x, y = +y.
 */

type Vec3 = readonly [number, number, number];
type Rgb = readonly [number, number, number];

export interface CookTorranceParameters {
  readonly albedo: Rgb;
  readonly kd: number;
  readonly metallic: number;
  readonly roughness: number;
  readonly ior: number;
}

export interface PrincipledParameters {
  readonly baseColor: Rgb;
  readonly subsurface: number;
  readonly metallic: number;
  readonly specular: number;
  readonly specularTint: number;
  readonly roughness: number;
  readonly anisotropic: number;
  readonly sheen: number;
  readonly sheenTint: number;
  readonly clearcoat: number;
  readonly clearcoatGloss: number;
}

const white: Rgb = [1, 1, 1];
const dot = (a: Vec3, b: Vec3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const scale = (a: Vec3, s: number): Vec3 => [a[0] * s, a[1] * s, a[2] * s];
const multiply = (a: Vec3, b: Vec3): Vec3 => [a[0] * b[0], a[1] * b[1], a[2] * b[2]];
const mix = (a: number, b: number, t: number) => a * (1 - t) + b * t;
const mixRgb = (a: Rgb, b: Rgb, t: number): Rgb => [
  mix(a[0], b[0], t),
  mix(a[1], b[1], t),
  mix(a[2], b[2], t),
];
const sum = (...terms: readonly Rgb[]): Rgb =>
  terms.reduce<Rgb>((a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]], [0, 0, 0]);

function halfVector(l: Vec3, v: Vec3): Vec3 {
  const h: Vec3 = [l[0] + v[0], l[1] + v[1], l[2] + v[2]];
  return scale(h, 1 / Math.sqrt(dot(h, h)));
}

const schlick = (r0: number, cosine: number) => r0 + (1 - r0) * (1 - cosine) ** 5;
const r0FromIor = (ior: number) => ((ior - 1) / (ior + 1)) ** 2;

export function lambert(albedo: Rgb): Rgb {
  return scale(albedo, 1 / Math.PI);
}

/** The specular D, F and G of Cook and Torrance. */
export function cookTorranceFactors(l: Vec3, v: Vec3, p: CookTorranceParameters) {
  const h = halfVector(l, v);
  const r = p.roughness;
  const [nh, nl, nv, vh] = [h[2], l[2], v[2], dot(v, h)];
  return {
    distribution: Math.exp((nh ** 2 - 1) / (r ** 2 * nh ** 2)) / (Math.PI * r ** 2 * nh ** 4),
    fresnel: schlick(r0FromIor(p.ior), dot(l, h)),
    masking: Math.min(1, (2 * nh * nv) / vh, (2 * nh * nl) / vh),
  };
}

export function cookTorrance(l: Vec3, v: Vec3, p: CookTorranceParameters): Rgb {
  const { distribution: d, fresnel: f, masking: g } = cookTorranceFactors(l, v, p);
  const specular = (d * f * g) / (4 * l[2] * v[2]);
  const dielectric = sum(scale(p.albedo, p.kd / Math.PI), scale(white, (1 - p.kd) * specular));
  return mixRgb(dielectric, scale(p.albedo, specular), p.metallic);
}

const alphas = (p: PrincipledParameters) => {
  const aspect = Math.sqrt(1 - 0.9 * p.anisotropic);
  return [Math.max(0.001, p.roughness ** 2 / aspect), Math.max(0.001, p.roughness ** 2 * aspect)] as const;
};

/** What both forms of the principled model share; D and the masking of a single direction. */
export function principledFactors(l: Vec3, v: Vec3, p: PrincipledParameters) {
  const h = halfVector(l, v);
  const [ax, ay] = alphas(p);
  const cosD = dot(l, h);

  const stretched = (h[0] / ax) ** 2 + (h[1] / ay) ** 2 + h[2] ** 2;
  const gtr2 = 1 / (Math.PI * ax * ay * stretched ** 2);
  const g = (w: Vec3) => 1 / (w[2] + Math.sqrt((w[0] * ax) ** 2 + (w[1] * ay) ** 2 + w[2] ** 2));

  const alpha = mix(0.1, 0.001, p.clearcoatGloss);
  const gtr1 = (alpha ** 2 - 1) / (Math.PI * Math.log(alpha ** 2) * (1 + (alpha ** 2 - 1) * h[2] ** 2));
  const ag = 0.25;
  const gcc = (w: Vec3) => 1 / (w[2] + Math.sqrt(ag ** 2 + w[2] ** 2 - ag ** 2 * w[2] ** 2));

  const fromF90 = (f90: number) => (1 + (f90 - 1) * (1 - l[2]) ** 5) * (1 + (f90 - 1) * (1 - v[2]) ** 5);
  return {
    cosD,
    gtr2,
    g: g(l) * g(v),
    gtr1,
    diffuse: fromF90(0.5 + 2 * cosD ** 2 * p.roughness),
    fss: fromF90(cosD ** 2 * p.roughness),
    clearcoat: gtr1 * schlick(0.04, cosD) * gcc(l) * gcc(v),
    grazing: (1 - cosD) ** 5,
  };
}

/** As Burley published it. */
export function principled(l: Vec3, v: Vec3, p: PrincipledParameters): Rgb {
  const part = principledFactors(l, v, p);
  const luminance = 0.3 * p.baseColor[0] + 0.6 * p.baseColor[1] + 0.1 * p.baseColor[2];
  const tint = luminance > 0 ? scale(p.baseColor, 1 / luminance) : white;
  const r0 = mixRgb(scale(mixRgb(white, tint, p.specularTint), 0.08 * p.specular), p.baseColor, p.metallic);

  const subsurface = 1.25 * (part.fss * (1 / (l[2] + v[2]) - 0.5) + 0.5);
  const base = scale(p.baseColor, mix(part.diffuse, subsurface, p.subsurface) / Math.PI);
  const sheen = scale(mixRgb(white, tint, p.sheenTint), p.sheen * part.grazing);
  const fresnel: Rgb = [schlick(r0[0], part.cosD), schlick(r0[1], part.cosD), schlick(r0[2], part.cosD)];
  return sum(
    scale(sum(base, sheen), 1 - p.metallic),
    scale(fresnel, part.gtr2 * part.g),
    scale(white, 0.25 * p.clearcoat * part.clearcoat),
  );
}

/** As the thesis writes it. */
export function principledThesis(l: Vec3, v: Vec3, p: PrincipledParameters): Rgb {
  const part = principledFactors(l, v, p);
  const fresnel = schlick(r0FromIor(1 + 0.8 * p.specular), part.cosD);
  const specular = part.gtr2 * fresnel * part.g;

  const subsurface = 1.25 * (part.fss * (1 / (l[2] * v[2]) - 0.5) + 0.5);
  const dielectric = sum(
    scale(p.baseColor, mix(part.diffuse, subsurface, p.subsurface) / Math.PI),
    scale(mixRgb(white, p.baseColor, p.sheenTint), p.sheen * part.grazing),
    scale(mixRgb(white, p.baseColor, p.specularTint), specular),
  );
  const metal = multiply(p.baseColor, scale(white, specular));
  return sum(
    scale(dielectric, 1 - p.metallic),
    scale(metal, p.metallic),
    scale(white, 0.25 * p.clearcoat * part.clearcoat),
  );
}
