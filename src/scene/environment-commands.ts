/** What a person can do to the light from all around, each as one undo step. */
import {
  type EnvironmentSource,
  type SoftBox,
  type SunPosition,
  skyDefaults,
  softBoxDefaults,
  sunPositionDefaults,
} from './environment-schema.ts';
import { sunAngles } from './sky/sun.ts';
import type { DocumentStore, Draft } from './store.ts';

/** At this brightness the sky is as bright as on Earth. */
export const EARTHLY = 0;

/** Another source of light. One that was made to be seen is shown behind the scene; lamps in the sky cast shadows. */
export function setEnvironmentSource(store: DocumentStore, source: EnvironmentSource): void {
  store.edit('Change environment', (draft) => {
    const before = draft.environment.source.type;
    draft.environment.source = structuredClone(source) as EnvironmentSource;
    if (source.type !== 'sky' || before === 'sky') return;
    if (draft.background.type === 'color') draft.background = { type: 'environment', blur: 0 };
    draft.effects.shadows.enabled = true;
  });
}

export const newSky = (): EnvironmentSource => structuredClone(skyDefaults);
/** Says in the other way where the sun stands; a direction stays what the place and the time have made it. */
export function setSunPositionType(store: DocumentStore, type: SunPosition['type']): void {
  editSky(store, 'Change how the sun is placed', (sky) => {
    if (type === sky.sun.type) return;
    if (type === 'place') {
      sky.sun = { ...sunPositionDefaults.place };
      return;
    }
    const { azimuth, elevation } = sunAngles(sky.sun);
    const degrees = (angle: number) => Math.round((angle * 180 * 100) / Math.PI) / 100;
    sky.sun = { type, azimuth: degrees(azimuth), elevation: degrees(elevation) };
  });
}

/** The sun as it stands now at the place, by a clock that is so many hours ahead of UTC. */
export function setSunToNow(store: DocumentStore, now: Date): void {
  editSky(store, 'Set the sun to now', (sky) => {
    if (sky.sun.type !== 'place') return;
    const there = new Date(now.getTime() + sky.sun.utcOffset * 3_600_000);
    sky.sun.date = there.toISOString().slice(0, 10);
    sky.sun.time = Math.round((there.getUTCHours() + there.getUTCMinutes() / 60) * 100) / 100;
  });
}

/** As bright as on Earth, with a meter that exposes for it; or so that the scene's lamps keep their exposure. */
export function setEarthlySky(store: DocumentStore, earthly: boolean): void {
  store.edit(earthly ? 'Make the sky as bright as on Earth' : 'Make the sky as bright as lamps', (draft) => {
    const { source } = draft.environment;
    if (source.type !== 'sky') return;
    source.brightness = earthly ? EARTHLY : skyDefaults.brightness;
    exposeForSky(draft);
  });
}

/** A sky as bright as on Earth needs a meter. One as bright as lamps needs none, by whatever way it has become so. */
export function exposeForSky({ environment: { source }, view }: Draft): void {
  if (source.type !== 'sky') return;
  if (source.brightness === EARTHLY && view.exposureMode === 'manual') view.exposureMode = 'auto';
  else if (source.brightness === skyDefaults.brightness && view.exposureMode === 'auto')
    view.exposureMode = 'manual';
}

function editSky(
  store: DocumentStore,
  label: string,
  recipe: (sky: Extract<EnvironmentSource, { type: 'sky' }>) => void,
): void {
  store.edit(label, (draft) => {
    if (draft.environment.source.type === 'sky') recipe(draft.environment.source);
  });
}

/** Adds a soft box, where one is wanted. @returns its place in the list */
export function addSoftBox(store: DocumentStore, values: Partial<SoftBox> = {}): number {
  let index = -1;
  editStudio(store, 'Add soft box', (boxes) => {
    index = boxes.push({ ...structuredClone(softBoxDefaults), ...values }) - 1;
  });
  return index;
}

export function removeSoftBox(store: DocumentStore, index: number): void {
  editStudio(store, 'Delete soft box', (boxes) => {
    boxes.splice(index, 1);
  });
}

/** @param merge a key that the changes of one drag have in common */
export function changeSoftBox(
  store: DocumentStore,
  index: number,
  values: Partial<SoftBox>,
  label: string,
  merge?: string,
): void {
  editStudio(
    store,
    label,
    (boxes) => {
      const box = boxes[index];
      if (box) Object.assign(box, values);
    },
    merge,
  );
}

function editStudio(
  store: DocumentStore,
  label: string,
  recipe: (boxes: SoftBox[], draft: Draft) => void,
  merge?: string,
): void {
  const edit = (draft: Draft) => {
    const { source } = draft.environment;
    if (source.type === 'studio') recipe(source.boxes, draft);
  };
  store.edit(label, edit, merge === undefined ? {} : { merge });
}
