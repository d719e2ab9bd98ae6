/** The brightest that a picture of half floats holds: (2 - 2^-10) 2^15. */
export const BRIGHTEST_HALF = 65504;
