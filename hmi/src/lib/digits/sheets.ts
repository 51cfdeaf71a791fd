// Numbers of the status that a thread of their own draws at each status, 50 times a second. The page only formats them.
import { untrack } from 'svelte';
import type { Status } from '$lib/api/types';
import { machine } from '$lib/state/machine.svelte';
import type { Place, Shown, Told } from './protocol';

/** What a sheet shows. */
export type Contents = {
  /** Its numbers of a status. */
  numbers(status: Status): Shown[];
  /** Where they stand on so many px of the screen, `scale` to one of the page. Asked again when size or theme change. */
  places(style: CSSStyleDeclaration, width: number, height: number, scale: number): Place[];
};
type Sheet = Contents & { last: Shown[]; failed: () => void };

let thread: Worker | null = null;
/** The thread has failed: of what is shown from then on nothing is drawn either. */
let isBroken = false;
/** Whether numbers can be drawn: this browser has what sheets need, and the thread has not failed. */
export const canDraw = () => !isBroken && 'transferControlToOffscreen' in HTMLCanvasElement.prototype;

let next = 1;
const sheets = new Map<number, Sheet>();
let latest: Status | null = null;

const tell = (told: Told, moved: Transferable[] = []) => thread?.postMessage(told, moved);
const isSame = (one: Shown[], other: Shown[]) =>
  one.length === other.length && one.every((shown, index) => shown.text === other[index]!.text && shown.tone === other[index]!.tone);

/** Says what has changed, of all sheets in one message. */
function show(status: Status): void {
  latest = status;
  const changed: [number, Shown[]][] = [];
  for (const [number, sheet] of sheets) {
    const shown = sheet.numbers(status);
    if (isSame(shown, sheet.last)) continue;
    sheet.last = shown;
    changed.push([number, shown]);
  }
  if (changed.length) tell({ do: 'show', numbers: changed });
}

function open(): void {
  if (thread) return;
  thread = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' });
  // Numbers that stand still would be worse than none: whoever shows them writes them himself then.
  thread.onerror = () => {
    isBroken = true;
    for (const { failed } of [...sheets.values()]) failed();
  };
  machine.watch(show);
}

/** An attachment: a canvas becomes a sheet of numbers. `failed` is called where they cannot be drawn any more. */
export function sheet(contents: Contents, failed: () => void): (canvas: HTMLCanvasElement) => () => void {
  return (canvas) => {
    if (isBroken) {
      failed();
      return () => {};
    }
    open();
    const number = next++;
    const mine: Sheet = { ...contents, last: [], failed };
    const drawn = canvas.transferControlToOffscreen();
    tell({ do: 'new', sheet: number, canvas: drawn }, [drawn]);
    sheets.set(number, mine);
    const look = () => {
      const { left, top, right, bottom } = canvas.getBoundingClientRect();
      const scale = devicePixelRatio;
      // A browser puts its edges on whole px of the screen: anything else would be blurred.
      const width = Math.round(right * scale) - Math.round(left * scale);
      const height = Math.round(bottom * scale) - Math.round(top * scale);
      if (!width || !height) return;
      tell({ do: 'look', sheet: number, width, height, places: contents.places(getComputedStyle(canvas), width, height, scale) });
    };
    const sizes = new ResizeObserver(look);
    sizes.observe(canvas);
    const themes = new MutationObserver(look);
    themes.observe(document.documentElement, { attributeFilter: ['data-theme'] });
    // A canvas is given away once: what its first numbers are made of must not bring the attachment about again.
    untrack(() => latest && show(latest));
    return () => {
      sizes.disconnect();
      themes.disconnect();
      sheets.delete(number);
      tell({ do: 'drop', sheet: number });
    };
  };
}
