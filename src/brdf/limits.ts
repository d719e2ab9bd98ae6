/** Bounds on what a stranger's file may ask of us. Disney's largest file has 4 kB and 14 parameters. */
export const BRDF_LIMITS = {
  characters: 1 << 20,
  includedLines: 20_000,
  includeDepth: 8,
  parameters: 256,
} as const;

/** Text from a stranger's file, short enough for a message. */
export function clip(text: string): string {
  return text.length > 40 ? `${text.slice(0, 40)}...` : text;
}
