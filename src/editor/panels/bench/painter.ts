/** What plots are drawn with: a canvas on the page and in a PNG, elements in an SVG. Units are CSS pixels. */
export interface Stroke {
  readonly color: string;
  readonly width?: number;
  readonly dash?: readonly number[];
}

export interface TextStyle {
  readonly color: string;
  readonly align?: 'left' | 'center' | 'right';
  /** Degrees, about the given point. */
  readonly turn?: number;
}

export interface Area {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

export interface Pixels {
  readonly width: number;
  readonly height: number;
  /** sRGB, rows from the top. */
  readonly rgba: Uint8ClampedArray<ArrayBuffer>;
}

export type Point = readonly [number, number];

export interface Painter {
  readonly width: number;
  readonly height: number;
  fill(area: Area, color: string): void;
  line(points: readonly Point[], stroke: Stroke): void;
  /** @param edge of a line as wide as edgeWidth() says; in the polygon's own colour it closes the seam to the next one */
  polygon(points: readonly Point[], color: string, edge: string | null): void;
  disc(center: Point, radius: number, color: string): void;
  /** Centred on y. */
  text(text: string, at: Point, style: TextStyle): void;
  /** @param smooth between the pixels, for pictures of things; data shows its own pixels */
  image(pixels: Pixels, area: Area, smooth?: boolean): void;
  /** Draws only inside the area. */
  clip(area: Area, draw: () => void): void;
}

/** A seam is closed by an overlap of half a unit on both sides; a wire is finer. */
export const edgeWidth = (color: string, edge: string): number => (edge === color ? 1 : 0.5);

export const FONT_SIZE = 11;
export const FONT = '"Inter", "Segoe UI", system-ui, sans-serif';
