import type { FunctionIR } from '../ir.ts';
import { compileKernel, type Kernel, kernelSource } from '../kernel.ts';

/**
 * sin(), exp() and their like in float32, one or four at once: in GLSL, so that they are compiled and inlined
 * like everything else. A call of JavaScript's Math costs 20 to 200 ns instead of some 5.
 *
 * The polynomials are minimax ones (Remez' exchange in float64); the figure at each is its error. Errors of the
 * functions in float32 are in test/glsl/wasm/math.test.ts.
 */
const SOURCE = `
const float PI = 3.14159265358979;
const float LEAST_NORMAL = 1.17549435e-38;
const float GREATEST = 3.40282347e38;
const int SIGN = -2147483647 - 1;

F withSign(F x, F sign) { return intBitsToFloat(floatBitsToInt(x) ^ (floatBitsToInt(sign) & SIGN)); }
F choose(I mask, F yes, F no) {
  return intBitsToFloat((floatBitsToInt(yes) & mask) | (floatBitsToInt(no) & ~mask));
}

// x - n pi/2, with pi/2 in three parts of few bits, so that their products with n are exact
// (W. J. Cody and W. Waite, 1980, "Software Manual for the Elementary Functions").
F reduced(F x, F n) { return ((x - n * 1.5703125) - n * 0.0004837512969970703) - n * 7.549790126404332e-8; }
// For |r| <= pi/4; relative errors 4e-9 and 2e-10.
F sinOf(F r) {
  F s = r * r;
  return r + r * s * (-0.166666545 + s * (0.00833215605 - s * 0.000195146319));
}
F cosOf(F r) {
  F s = r * r;
  return 1.0 - 0.5 * s + s * s * (0.0416666456 + s * (-0.00138873099 + s * 0.0000244324130));
}
// sin(r + q pi/2).
F quarter(F r, I q) {
  F y = choose(-(q & 1), cosOf(r), sinOf(r));
  return intBitsToFloat(floatBitsToInt(y) ^ ((q & 2) << 30));
}
F sin_(F x) { F n = roundEven(x * (2.0 / PI)); return quarter(reduced(x, n), I(n)); }
F cos_(F x) { F n = roundEven(x * (2.0 / PI)); return quarter(reduced(x, n), I(n) + 1); }
F tan_(F x) {
  F n = roundEven(x * (2.0 / PI));
  F r = reduced(x, n);
  F s = sinOf(r), c = cosOf(r);
  I odd = -(I(n) & 1);
  return choose(odd, -c, s) / choose(odd, s, c);
}

// 2^n for whole n from -127 (0) to 128 (infinity).
F powerOfTwo(F n) { return intBitsToFloat((I(n) + 127) << 23); }
// Relative error 2e-9 for the fraction in 0..1.
F exp2_(F x) {
  F y = clamp(x, -127.0, 128.0);
  F n = floor(y), r = y - n;
  F p = 1.0 + r * (0.693147044 + r * (0.240229306 + r * (0.0554852806 + r * (0.00967545157
    + r * (0.00124678464 + r * 0.000216129149)))));
  return p * powerOfTwo(n);
}
// e^x = 2^n e^r, with ln 2 in two parts as above; relative error 3e-9 for r in 0..ln 2.
F exp_(F x) {
  F y = clamp(x, -88.0, 89.0);
  F n = floor(y * 1.44269504);
  F r = (y - n * 0.693115234375) - n * 0.00003194618329871446;
  F p = 1.0 + r + r * r * (0.500002286 + r * (0.166631900 + r * (0.0418550416
    + r * (0.00786832614 + r * 0.00191254686))));
  return p * powerOfTwo(n);
}

// x = 2^e m, sqrt(1/2) <= m < sqrt(2).
I exponentOf(F x) { return (floatBitsToInt(x) - 0x3f3504f3) >> 23; }
// 2 artanh((m - 1) / (m + 1)) by its series; relative error 2e-9.
F logOf(F m) {
  F s = (m - 1.0) / (m + 1.0), z = s * s;
  return s * (2.0 + z * (0.666666667 + z * (0.4 + z * (0.285714286 + z * 0.222222222))));
}
// What a logarithm is outside the normal numbers, which it does not see there.
F beyond(F x, F y) {
  F z = mix(y, F(-1.0 / 0.0), LESS(x, F(LEAST_NORMAL)));
  F w = mix(z, F(0.0 / 0.0), LESS(x, F(0.0)));
  return mix(w, x, not(LESS_EQUAL(x, F(GREATEST))));
}
F log_(F x) {
  I e = exponentOf(x);
  return beyond(x, F(e) * 0.693147181 + logOf(intBitsToFloat(floatBitsToInt(x) - (e << 23))));
}
F log2_(F x) {
  I e = exponentOf(x);
  return beyond(x, F(e) + 1.44269504 * logOf(intBitsToFloat(floatBitsToInt(x) - (e << 23))));
}
F pow_(F x, F y) { return mix(exp2_(y * log2_(x)), F(1.0), EQUAL(y, F(0.0))); }

// For |t| <= tan(pi/8); relative error 2e-8.
F atanOf(F t) {
  F s = t * t;
  return t + t * s * (-0.333329489 + s * (0.199776981 + s * (-0.138775380 + s * 0.0805323429)));
}
F atan2_(F y, F x) {
  F ax = abs(x), ay = abs(y);
  F high = max(ax, ay), low = min(ax, ay);
  // atan(t) = pi/4 + atan((t - 1) / (t + 1)).
  B steep = LESS(0.414213562 * high, low);
  F t = mix(low, low - high, steep) / max(mix(high, low + high, steep), F(LEAST_NORMAL));
  F a = atanOf(t) + mix(F(0.0), F(PI / 4.0), steep);
  F b = mix(a, PI / 2.0 - a, LESS(ax, ay));
  return withSign(mix(b, PI - b, LESS(x, F(0.0))), y);
}
F atan_(F x) { return atan2_(x, F(1.0)); }

// For 0 <= t <= 1/2; relative error 5e-9.
F asinOf(F t) {
  F s = t * t;
  return t + t * s * (0.166667527 + s * (0.0749528867 + s * (0.0454716072 + s * (0.0241729514 + s * 0.0421782304))));
}
// asin(a) = pi/2 - 2 asin(sqrt((1 - a) / 2)).
F asin_(F x) {
  F a = abs(x);
  B large = LESS(F(0.5), a);
  F p = asinOf(mix(a, sqrt(0.5 - 0.5 * a), large));
  return withSign(mix(p, PI / 2.0 - 2.0 * p, large), x);
}
F acos_(F x) {
  F a = abs(x);
  B large = LESS(F(0.5), a);
  F p = asinOf(mix(a, sqrt(0.5 - 0.5 * a), large));
  return mix(PI / 2.0 - withSign(p, x), mix(2.0 * p, PI - 2.0 * p, LESS(x, F(0.0))), large);
}
`;

const SCALAR = `
#define F float
#define I int
#define B bool
#define LESS(a, b) ((a) < (b))
#define LESS_EQUAL(a, b) ((a) <= (b))
#define EQUAL(a, b) ((a) == (b))
#define not(a) (!(a))
`;
const VECTOR = `
#define F vec4
#define I ivec4
#define B bvec4
#define LESS(a, b) lessThan(a, b)
#define LESS_EQUAL(a, b) lessThanEqual(a, b)
#define EQUAL(a, b) equal(a, b)
`;

const NAMES = new Set(['sin', 'cos', 'tan', 'exp', 'exp2', 'log', 'log2', 'pow', 'atan', 'asin', 'acos']);
const kernels: { scalar: Kernel | null; vector: Kernel | null } = { scalar: null, vector: null };

/** The function that computes a built-in one, for a float or for a vec4; null if there is none. */
export function mathFunction(name: string, count: number, kind: 'scalar' | 'vector'): FunctionIR | null {
  if (!NAMES.has(name)) return null;
  const text = () => (kind === 'scalar' ? SCALAR : VECTOR) + SOURCE;
  const kernel = kernels[kind] ?? compileKernel(kernelSource('mathematics', text()), []);
  kernels[kind] = kernel;
  return kernel.entry(name === 'atan' && count === 2 ? 'atan2_' : `${name}_`);
}
