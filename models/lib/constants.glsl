// Numbers that every model shares.

const float PI = 3.14159265358979323846;
const float INV_PI = 1.0 / PI;

// A direction whose cosine to the normal is smaller than this counts as below the surface.
// It is the spacing of float32 numbers just below 1 (2^-24 = 6e-8) rounded up: beyond it a
// unit vector's cosine is noise, and above it no formula here divides by zero or overflows,
// not even 1/(n.l n.v) or h = (l+v)/|l+v| for l close to -v.
const float HORIZON = 1e-7;

float sqr(float x) { return x * x; }
