import { DirectionalLight } from 'three/webgpu';

/** The sun, or any light so far away that it comes from one side; intensity in lx. Shaded as three.js' own. */
export class BrdfDirectionalLight extends DirectionalLight {
  /**
   * The angle in radians that the light fills in the sky. Shadows alone know it: what is not in one is lit as from the
   * middle (docs/decisions/light-sizes.md).
   */
  angularDiameter = 0;

  override copy(source: this): this {
    super.copy(source);
    this.angularDiameter = source.angularDiameter;
    return this;
  }
}
