/** What a kind of pattern is: a table of parameters and a function of the place. */
import type { z } from 'zod';
import { color, integer, number } from '../fields.ts';

export type Rgb = readonly [number, number, number];

/** A point of the surface. */
export interface Point {
  /** Linear Rec. 709, up to a factor: the picture is scaled to the mean that is asked for. */
  red: number;
  green: number;
  blue: number;
  /** 0..1 from the deepest to the highest. */
  height: number;
  /** Relative to the others. */
  roughness: number;
}

export type Sampler = (u: number, v: number, out: Point) => void;

export type Settings<Shape extends z.ZodRawShape> = Common & {
  readonly [K in keyof Shape]: z.output<Shape[K] & z.ZodType>;
};

export interface Kind<Shape extends z.ZodRawShape = z.ZodRawShape> {
  readonly title: string;
  readonly shape: Shape;
  readonly defaults: Readonly<{ [K in keyof Shape]: z.output<Shape[K] & z.ZodType> }>;
  /** u and v are 0..1 over the picture, v upwards; the same at 0 and at 1. */
  /** From the lowest to the highest point at relief 1, in widths of the picture: what makes the normals. */
  depth(settings: Settings<Shape>): number;
  sampler(settings: Settings<Shape>): Sampler;
}

/** Infers the types of a kind's settings from its table. */
export const kind = <Shape extends z.ZodRawShape>(made: Kind<Shape>): Kind<Shape> => made;

/** Texels of a side. */
export const MOST_SIZE = 1024;

/** What every pattern has. */
export const commonShape = {
  size: integer('Texels along each side', { range: [16, MOST_SIZE], slider: [64, MOST_SIZE] }),
  seed: integer('Another number is another piece of the same', { range: [0, 9999] }),
  color: color('Mean colour of the picture, linear Rec. 709'),
  relief: number('Height of bumps, for the normals', { range: [0, 10], slider: [0, 3], step: 0.01 }),
};
export const commonDefaults = { size: 512, seed: 1, color: [0.5, 0.5, 0.5], relief: 1 } as const;
export interface Common {
  readonly size: number;
  readonly seed: number;
  readonly color: Rgb;
  readonly relief: number;
}

/** A number 0..1 of a table. */
export const share = (description: string) => number(description, { range: [0, 1], step: 0.01 });
/** A whole number that is dragged. */
export const count = (description: string, min: number, max: number) =>
  integer(description, { range: [min, max], slider: [min, max] });

/** A colour that gets darker as it does below more of its own pigment: Beer's law, more saturated at the same time. */
export function deeper(color: Rgb, by: number, scale: number, out: Point): void {
  out.red = scale * deepened(color[0], by);
  out.green = scale * deepened(color[1], by);
  out.blue = scale * deepened(color[2], by);
}
/** Of what is black nothing is left to deepen. */
const deepened = (c: number, by: number): number => Math.max(c, 1e-4) ** (1 + by);

export function paint(color: Rgb, scale: number, out: Point): void {
  out.red = color[0] * scale;
  out.green = color[1] * scale;
  out.blue = color[2] * scale;
}
