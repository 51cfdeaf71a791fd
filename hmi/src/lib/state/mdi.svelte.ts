// MDI (GSK990MC part 2, 8.1, 8.2): what cycle start runs there, as the control has it, and what was typed and not sent yet, kept
// while other pages are shown and when the page is loaded anew.
import { machine } from './machine.svelte';

/** The text, and the block that runs once before it; none where it is not known. */
let held = $state.raw<{ text: string; block: string } | null>(null);
const KEY = 'ferrocut.mdi-unsent';
const before = kept();
let draft = $state.raw<string | null>(before.draft);
let block = $state(before.block);

function kept(): { draft: string | null; block: string } {
  try {
    const { draft, block } = JSON.parse(sessionStorage.getItem(KEY) ?? '{}') as Record<string, unknown>;
    return { draft: typeof draft === 'string' ? draft : null, block: typeof block === 'string' ? block : '' };
  } catch {
    return { draft: null, block: '' };
  }
}

function put(text: string | null, one: string): void {
  if (text === draft && one === block) return;
  [draft, block] = [text, one];
  try {
    if (text === null && one === '') sessionStorage.removeItem(KEY);
    else sessionStorage.setItem(KEY, JSON.stringify({ draft: text, block: one }));
  } catch {
    // Nothing is kept then.
  }
}

export const mdi = {
  /** What the control has; null until it has said so. */
  get held() {
    return held;
  },
  /** What was typed in the place of the control's text; null where nothing was. */
  get draft() {
    return draft;
  },
  /** What was typed of one block. */
  get block() {
    return block;
  },
  set block(typed: string) {
    put(draft, typed);
  },
  get isUnsent() {
    return draft !== null || block.trim() !== '';
  },
  /** Whether cycle start would run something else than what was typed last. */
  get locksStart() {
    return machine.mode === 'mdi' && this.isUnsent;
  },
  /** Whether cycle start runs what is shown. */
  get isShown() {
    return held !== null && !this.isUnsent;
  },
  type(text: string): void {
    put(text === held?.text ? null : text, block);
  },
  /** What was not sent is given up. */
  drop(): void {
    put(null, '');
  },
  /** What the control has may be another by now. */
  forget(): void {
    held = null;
  },
  async read(): Promise<void> {
    const reply = await machine.fetch('mdi_text', { do: 'mdi_text' });
    if (!reply) return;
    held = { text: reply.text, block: reply.block };
    if (draft === reply.text) put(null, block);
  },
  /** Whether the control took it. */
  async send(text: string): Promise<boolean> {
    if (!(await machine.tell({ do: 'mdi', text }))) return false;
    await this.read();
    return true;
  },
  /** The same of one block; an empty one takes back the one that waits. */
  async sendBlock(sent: string): Promise<boolean> {
    if (!(await machine.tell({ do: 'mdi_block', block: sent }))) return false;
    await this.read();
    if (block === sent) put(draft, '');
    return true;
  },
};
