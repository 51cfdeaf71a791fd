// A key that acts while it is held: pressed by touch, mouse or keyboard, and let go by whatever ends that – the finger
// lifted, the pointer lost or taken away, the focus gone, the element removed.
import type { Attachment } from 'svelte/attachments';

export type Held = {
  /** `at` is when it was pressed, as `performance.now()`: a page that is held up hears of it later. */
  down(at: number): void;
  up(): void;
};

/** Makes an element a held key. */
export function held(key: () => Held): Attachment<HTMLElement> {
  return (element) => {
    let pointer: number | null = null;
    let byKeyboard = false;
    let current: Held | null = null;

    const press = (at: number) => {
      if (current) return;
      current = key();
      element.dataset.held = '';
      current.down(at);
    };
    const letGo = () => {
      pointer = null;
      byKeyboard = false;
      if (!current) return;
      const was = current;
      current = null;
      delete element.dataset.held;
      was.up();
    };
    const on = {
      pointerdown(event: PointerEvent) {
        if (event.button !== 0 || element.hasAttribute('disabled')) return;
        // Another finger holds it already; unless that one went unseen, such as while the key was disabled.
        if (pointer !== null && element.hasPointerCapture(pointer)) return;
        letGo();
        pointer = event.pointerId;
        try {
          element.setPointerCapture(event.pointerId);
        } catch {
          // A pointer that is gone already: its `pointerup` came first.
        }
        press(event.timeStamp);
      },
      pointerup(event: PointerEvent) {
        if (event.pointerId === pointer) letGo();
      },
      pointercancel: letGo,
      lostpointercapture(event: PointerEvent) {
        if (event.pointerId === pointer) letGo();
      },
      keydown(event: KeyboardEvent) {
        if ((event.key !== ' ' && event.key !== 'Enter') || event.repeat || element.hasAttribute('disabled')) return;
        event.preventDefault();
        byKeyboard = true;
        press(event.timeStamp);
      },
      keyup(event: KeyboardEvent) {
        if (!byKeyboard || (event.key !== ' ' && event.key !== 'Enter')) return;
        // Browsers make a click of a space bar that is let go.
        event.preventDefault();
        letGo();
      },
      blur() {
        if (byKeyboard) letGo();
      },
      contextmenu(event: Event) {
        event.preventDefault();
      },
    };
    const away = () => {
      if (document.visibilityState === 'hidden') letGo();
    };
    for (const [name, handler] of Object.entries(on)) element.addEventListener(name, handler as EventListener);
    window.addEventListener('blur', letGo);
    document.addEventListener('visibilitychange', away);
    return () => {
      letGo();
      for (const [name, handler] of Object.entries(on)) element.removeEventListener(name, handler as EventListener);
      window.removeEventListener('blur', letGo);
      document.removeEventListener('visibilitychange', away);
    };
  };
}
