import { expect, it } from 'vitest';
import { julianDay, sunEquatorial, sunPosition } from '../../../src/scene/sky/sun-position.ts';

it('gives the right ascension and declination of the worked example of Meeus, 1998, 25.a', () => {
  // 1992 October 13, 0h TD; TD was 59 s ahead of UT. The book: 198.38083 and -7.78507 degrees.
  const { rightAscension, declination } = sunEquatorial(2_448_908.5 - 59 / 86_400);
  expect(rightAscension).toBeCloseTo(198.38083, 3);
  expect(declination).toBeCloseTo(-7.78507, 3);
});

it('counts days as Meeus, 1998, example 7.a', () => {
  // 1957 October 4.81.
  expect(julianDay({ date: '1957-10-04', time: 0.81 * 24, utcOffset: 0 })).toBeCloseTo(2_436_116.31, 6);
});

it('stands where the worked example of Reda and Andreas, 2004, "Solar Position Algorithm", says', () => {
  // Golden, Colorado: azimuth 194.34024, zenith angle 50.11162 at 820 hPa; at the sea's level refraction is 0.004 more.
  const { azimuth, elevation } = sunPosition({
    latitude: 39.742476,
    longitude: -105.1786,
    date: '2003-10-17',
    time: 12 + 30 / 60 + 30 / 3600,
    utcOffset: -7,
  });
  expect(Math.abs(azimuth - 194.34024)).toBeLessThan(0.01);
  expect(Math.abs(elevation - (90 - 50.11162))).toBeLessThan(0.01);
});

it('rises in the east and sets in the west at an equinox, twelve hours apart', () => {
  const at = (time: number) =>
    sunPosition({ latitude: 0, longitude: 0, date: '2024-03-20', time, utcOffset: 0 });
  // Local noon was at 12:07:20: the equation of time.
  expect(at(12 + 7.3 / 60).elevation).toBeGreaterThan(89.7);
  expect(at(9).azimuth).toBeCloseTo(90, 0);
  expect(at(15).azimuth).toBeCloseTo(270, 0);
  // It stands on the horizon six hours before and after, lifted by refraction of half a degree.
  expect(Math.abs(at(6 + 7.3 / 60).elevation - 0.48)).toBeLessThan(0.05);
  expect(Math.abs(at(18 + 7.3 / 60).elevation - 0.48)).toBeLessThan(0.05);
});

it('does not set at midsummer beyond the polar circle, nor rise at midwinter', () => {
  const at = (date: string, time: number) =>
    sunPosition({ latitude: 70, longitude: 25, date, time, utcOffset: 1 }).elevation;
  const hours = Array.from({ length: 24 }, (_, hour) => hour);
  expect(Math.min(...hours.map((hour) => at('2025-06-21', hour)))).toBeGreaterThan(3);
  expect(Math.max(...hours.map((hour) => at('2025-12-21', hour)))).toBeLessThan(-3);
});
