/** A part of the inspector: built once for what is selected, then updated in place. */
export interface InspectorPanel {
  readonly element: HTMLElement;
  update(): void;
}
