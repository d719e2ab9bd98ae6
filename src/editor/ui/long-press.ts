/** A finger that rests asks for the context menu, as a right click does; not every browser says so by itself. */

const HOLD_MS = 550;
const STILL_PX = 8;

export function installLongPress(): void {
  let timer = 0;
  let from: PointerEvent | null = null;
  const end = () => {
    clearTimeout(timer);
    from = null;
  };
  document.addEventListener('pointerdown', (event) => {
    end();
    if (event.pointerType !== 'touch' || !event.isPrimary) return;
    // A finger that rests on what can be dragged holds it (touch-drag.ts).
    if (event.target instanceof Element && event.target.closest('[draggable="true"]')) return;
    from = event;
    timer = window.setTimeout(() => {
      const { target, clientX, clientY } = event;
      end();
      // The menu is under the finger: letting go must not choose from it.
      document.addEventListener('touchend', (up) => up.preventDefault(), {
        once: true,
        capture: true,
        passive: false,
      });
      target?.dispatchEvent(
        new MouseEvent('contextmenu', { bubbles: true, cancelable: true, clientX, clientY }),
      );
    }, HOLD_MS);
  });
  document.addEventListener('pointermove', (event) => {
    if (from && Math.hypot(event.clientX - from.clientX, event.clientY - from.clientY) > STILL_PX) end();
  });
  document.addEventListener('pointerup', end);
  document.addEventListener('pointercancel', end);
  // The browser's own comes sooner or later than ours: one is enough.
  document.addEventListener('contextmenu', (event) => event.isTrusted && end(), true);
}
