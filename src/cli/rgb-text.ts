/** A colour in three columns of four digits. */
export function rgbText(rgb: readonly number[]): string {
  return rgb.map((value) => value.toFixed(4).padStart(7)).join(' ');
}
