// Samples: an Owen-scrambled Sobol sequence whose points are dealt to the pixels along a Morton curve, so that
// neighbours complement one another and what error remains is blue noise.
//   B. Burley, 2020, "Practical Hash-based Owen Scrambling", JCGT 9(4).
//   A. G. M. Ahmed and P. Wonka, 2020, "Screen-Space Blue-Noise Diffusion of Monte Carlo Sampling Error via
//   Hierarchical Ordering of Pixels", ACM TOG 39(6).
// The number of samples need not be known: samples 2^j to 2^(j+1) - 1 are a set of their own in which every pixel
// has 2^j consecutive points.

uint sampleSeed;      // of the rendering and the octave j
uint sampleBlock;     // number of this point in the octave's sequence
uint sampleDimension;

// A hash of 32 bits, C. Wellons, 2018, "Prospecting for Hash Functions": lowbias32.
uint mixBits(uint x) {
  x ^= x >> 16u;
  x *= 0x7feb352du;
  x ^= x >> 15u;
  x *= 0x846ca68bu;
  return x ^ (x >> 16u);
}

// Owen scrambling of a number with its bits in reverse: S. Laine and T. Karras, 2011, with N. Vegdahl's constants
// ("Building a Better LK Hash", 2021).
uint scrambleReversed(uint x, uint seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16u) | 1u;
  x ^= x * 0x05526c56u;
  return x ^ (x * 0x53a22864u);
}

// The bits of x, 16 of them, with zeros between.
uint spreadBits(uint x) {
  x &= 0xffffu;
  x = (x ^ (x << 8u)) & 0x00ff00ffu;
  x = (x ^ (x << 4u)) & 0x0f0f0f0fu;
  x = (x ^ (x << 2u)) & 0x33333333u;
  return (x ^ (x << 1u)) & 0x55555555u;
}

// The second dimension of Sobol's sequence, its bits in reverse: Pascal's triangle modulo 2 times the index.
uint pascal(uint x) {
  x ^= (x >> 1u) & 0x55555555u;
  x ^= (x >> 2u) & 0x33333333u;
  x ^= (x >> 4u) & 0x0f0f0f0fu;
  x ^= (x >> 8u) & 0x00ff00ffu;
  return x ^ ((x >> 16u) & 0x0000ffffu);
}

// Starts the sample of this number of a pixel.
void startSample(uint x, uint y, uint index, uint seed) {
  uint octave = 0u;
  uint rest = index >> 1u;
  while (rest > 0u) {
    octave++;
    rest = rest >> 1u;
  }
  uint first = index == 0u ? 0u : 1u << octave;
  uint morton = spreadBits(x) | (spreadBits(y) << 1u);
  // Beyond 32 bits tiles of pixels share points, each tile scrambled in its own way.
  uint kept = 32u - octave;
  uint tile = octave == 0u ? 0u : morton >> kept;
  uint place = octave == 0u ? morton : morton & ((1u << kept) - 1u);
  sampleBlock = (place << octave) | (index - first);
  sampleSeed = mixBits(seed ^ mixBits((index == 0u ? 0u : octave + 1u) ^ (tile << 6u)));
  sampleDimension = 0u;
}

// The next two dimensions, each in 0 <= u < 1.
vec2 random2() {
  uint key = mixBits(sampleSeed ^ (sampleDimension * 0x9e3779b9u));
  sampleDimension++;
  // Each pair of dimensions has the points in another order, or they would be correlated.
  uint index = bitfieldReverse(scrambleReversed(bitfieldReverse(sampleBlock), key));
  uint a = bitfieldReverse(scrambleReversed(index, mixBits(key ^ 0xa511e9b3u)));
  uint b = bitfieldReverse(scrambleReversed(pascal(index), mixBits(key ^ 0x63d83595u)));
  return vec2(float(a >> 8u), float(b >> 8u)) * (1.0 / 16777216.0);
}

float random1() {
  return random2().x;
}
