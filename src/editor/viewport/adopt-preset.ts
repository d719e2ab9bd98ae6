/**
 * A scene that nobody has worked on is shown at first without effects, and then with the preset that this device draws
 * without effort. See docs/decisions/presets.md.
 */
import { isSoftware } from '../../realtime/adapter.ts';
import { devicePreset } from '../../realtime/device-preset.ts';
import type { RealtimeRenderer } from '../../realtime/renderer.ts';
import { hasDefaultEffects, type PresetName, withPreset } from '../../scene/effect-presets.ts';
import type { Document } from '../../scene/schema.ts';
import type { Session } from '../session.ts';
import { onlyTheCameraDiffers } from '../storage/autosave.ts';
import type { Viewport } from './viewport.ts';

export class PresetOfDevice {
  readonly #session: Session;
  readonly #renderer: RealtimeRenderer;
  readonly #viewport: Viewport;
  #measured: Promise<PresetName> | null = null;

  constructor(session: Session, renderer: RealtimeRenderer, viewport: Viewport) {
    this.#session = session;
    this.#renderer = renderer;
    this.#viewport = viewport;
  }

  /** @param fresh a new or a shipped scene, which has just been opened and drawn */
  async adopt(fresh: Document): Promise<void> {
    const { store, workspace } = this.#session;
    // Looking around is not work.
    const isUntouched = () => workspace.kept === null && onlyTheCameraDiffers(store.document, fresh);
    if (!hasDefaultEffects(fresh)) return;
    this.#measured ??= this.#measure();
    const name = await this.#measured;
    if (name === 'low' || !isUntouched()) return;
    const effects = withPreset(fresh.effects, name);
    await this.#viewport.prepare({ ...store.document, effects });
    if (isUntouched()) workspace.amend({ ...store.document, effects });
  }

  async #measure(): Promise<PresetName> {
    if (isSoftware(this.#renderer.three)) return 'low';
    return devicePreset(await this.#viewport.measureFrame());
  }
}
