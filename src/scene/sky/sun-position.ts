/** Where the sun stands: J. Meeus, 1998, "Astronomical Algorithms", 2nd edition; good to 0.01 degrees from 1900 to 2100. */

export interface PlaceAndTime {
  /** In degrees, north is positive. */
  readonly latitude: number;
  /** In degrees, east is positive. */
  readonly longitude: number;
  /** YYYY-MM-DD, Gregorian. */
  readonly date: string;
  /** What a clock there shows, in hours since midnight. */
  readonly time: number;
  /** Hours by which that clock is ahead of UTC. */
  readonly utcOffset: number;
}

export interface SunPosition {
  /** In degrees from north by east. */
  readonly azimuth: number;
  /** In degrees above the horizon, as it is seen: lifted by refraction. */
  readonly elevation: number;
}

const RADIANS = Math.PI / 180;
const sin = (degrees: number): number => Math.sin(degrees * RADIANS);
const cos = (degrees: number): number => Math.cos(degrees * RADIANS);
const turn = (degrees: number): number => ((degrees % 360) + 360) % 360;

export function julianDay({
  date,
  time,
  utcOffset,
}: Pick<PlaceAndTime, 'date' | 'time' | 'utcOffset'>): number {
  // Day 2440587.5 is the beginning of 1970.
  return Date.parse(`${date}T00:00:00Z`) / 86_400_000 + 2_440_587.5 + (time - utcOffset) / 24;
}

/** Apparent geocentric right ascension and declination in degrees: chapter 25, "low accuracy". @param day Julian, of UT */
export function sunEquatorial(day: number): { rightAscension: number; declination: number } {
  // Terrestrial time is 69 s ahead of UT in these years; the sun moves by 3e-5 degrees in that.
  const t = (day + 69 / 86_400 - 2_451_545) / 36_525;
  const meanLongitude = 280.46646 + t * (36_000.76983 + t * 0.0003032);
  const anomaly = 357.52911 + t * (35_999.05029 - t * 0.0001537);
  const centre =
    (1.914602 - t * (0.004817 + t * 0.000014)) * sin(anomaly) +
    (0.019993 - t * 0.000101) * sin(2 * anomaly) +
    0.000289 * sin(3 * anomaly);
  const node = 125.04 - 1934.136 * t;
  // Aberration and nutation.
  const longitude = meanLongitude + centre - 0.00569 - 0.00478 * sin(node);
  const obliquity = 23 + 26 / 60 + 21.448 / 3600 - t * 0.0130042 + 0.00256 * cos(node);
  return {
    rightAscension: turn(Math.atan2(cos(obliquity) * sin(longitude), cos(longitude)) / RADIANS),
    declination: Math.asin(sin(obliquity) * sin(longitude)) / RADIANS,
  };
}

/** Greenwich mean sidereal time in degrees: equation 12.4. */
function siderealTime(day: number): number {
  const t = (day - 2_451_545) / 36_525;
  return turn(280.46061837 + 360.98564736629 * (day - 2_451_545) + t * t * 0.000387933);
}

/** In degrees, for 1010 hPa and 10 degrees C: G. G. Bennett's formula turned round by T. Saemundsson, equation 16.4. */
function refraction(elevation: number): number {
  // Far below the horizon there is nothing to be lifted.
  if (elevation < -2) return 0;
  const minutes = 1.02 / Math.tan((elevation + 10.3 / (elevation + 5.11)) * RADIANS);
  return Math.max(0, minutes / 60) * Math.min(1, elevation + 2);
}

export function sunPosition(at: PlaceAndTime): SunPosition {
  const day = julianDay(at);
  const { rightAscension, declination } = sunEquatorial(day);
  const hour = siderealTime(day) + at.longitude - rightAscension;
  // Equations 13.5 and 13.6, whose azimuths are from south by west.
  const azimuth = Math.atan2(
    sin(hour) * cos(declination),
    cos(hour) * sin(at.latitude) * cos(declination) - sin(declination) * cos(at.latitude),
  );
  const height = sin(at.latitude) * sin(declination) + cos(at.latitude) * cos(declination) * cos(hour);
  const elevation = Math.asin(Math.min(1, Math.max(-1, height))) / RADIANS;
  return { azimuth: turn(azimuth / RADIANS + 180), elevation: elevation + refraction(elevation) };
}
