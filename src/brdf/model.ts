/**
 * The contract of a BRDF file.
 *
 * A model is a table of parameters and GLSL. Conventions, everywhere: L and V are unit vectors that point
 * away from the surface, N is the shading normal, X and Y are tangent and bitangent. BRDF() returns f in
 * 1/sr without the cosine. Colours are linear Rec. 709. Angles are in radians.
 */

interface ParameterBase {
  readonly name: string;
  /** What the parameter does and its unit, for a tooltip; empty if the file does not say. */
  readonly description: string;
}

/** A number; min and max are a slider's ends, values beyond them are allowed (Burley 2012, principle 4). */
export interface FloatParameter extends ParameterBase {
  readonly type: 'float';
  readonly min: number;
  readonly max: number;
  readonly default: number;
}

/** A linear Rec. 709 colour. */
export interface ColorParameter extends ParameterBase {
  readonly type: 'color';
  readonly default: Rgb;
}

/** A switch. */
export interface BoolParameter extends ParameterBase {
  readonly type: 'bool';
  readonly default: boolean;
}

export type Rgb = readonly [number, number, number];
export type Parameter = FloatParameter | ColorParameter | BoolParameter;
export type ParameterValue = number | boolean | Rgb;
export type ParameterValues = Readonly<Record<string, ParameterValue>>;

/** One line of GLSL and where it was written. */
export interface SourceLine {
  readonly text: string;
  readonly file: string;
  readonly line: number;
}

/** GLSL with its includes spliced in. */
export interface SourceText {
  readonly lines: readonly SourceLine[];
}

/** A law that a model breaks on purpose, as a whole or in one of its terms. */
export interface WaivedProperty {
  readonly property: 'positivity' | 'reciprocity' | 'energy' | 'continuity';
  /** null: the model and all of its terms. */
  readonly term: string | null;
}

/** A term that is the masking G1 of facets: with h for L, the share of the facets along h that V sees. */
export interface FacetMasking {
  readonly masking: string;
  /** The term that is those facets' distribution. */
  readonly distribution: string;
}

/** What a model's header says about it, for the checks of src/analysis/verdict. */
export interface Declarations {
  readonly givesUp: readonly WaivedProperty[];
  /** The terms that add up to BRDF; empty if the file does not say. */
  readonly lobes: readonly string[];
  /** The terms that are distributions D(h) of facet normals. */
  readonly distributions: readonly string[];
  readonly maskings: readonly FacetMasking[];
  /** The term that is BRDF() with the light that facets reflect to one another; null if the file names none. */
  readonly multipleScattering: string | null;
  /** Values with which the surface gives back all light; null if the file names none. */
  readonly lossless: ParameterValues | null;
}

/** How light passes through a surface, for models whose L may be on the other side of the surface than V. */
export interface Transmission {
  /** The parameter that is the index of refraction of the side without V over that of the side with V. */
  readonly ior: string;
  /** The switch that makes the surface a sheet, with V's side on both of its sides; null if there is none. */
  readonly thin: string | null;
  /** The parameters of what the surface encloses; null if it is clear. */
  readonly medium: TransmissionMedium | null;
}

/** A homogeneous medium (OpenPBR 1.1, section "Transmission"): extinction = -ln(color)/depth, scattering = scatter/depth. */
export interface TransmissionMedium {
  /** What is left of white light after `depth`. */
  readonly color: string;
  /** In metres; at 0 there is no medium. */
  readonly depth: string;
  /** The colour of scattered light; null if it only absorbs. */
  readonly scatter: string | null;
  /** g of Henyey and Greenstein's phase function, -1..1; null is 0. */
  readonly anisotropy: string | null;
}

/** A parsed `.brdf` file. */
export interface BrdfFile {
  /** The file's name without folder and extension. */
  readonly name: string;
  /** The file's name as it was given, for messages. */
  readonly fileName: string;
  /** First sentence of the header comment, or the name. */
  readonly title: string;
  /** The comment that heads the file: its manual page. */
  readonly documentation: string;
  readonly declarations: Declarations;
  /** null for an opaque surface: BRDF() is 0 where L is below it. */
  readonly transmission: Transmission | null;
  readonly parameters: readonly Parameter[];
  readonly shader: SourceText;
  /** sampleL() and pdf(), if the file brings its own. */
  readonly sampling: SourceText | null;
}
