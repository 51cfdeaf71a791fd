// MDI (GSK990MC part 2, 8.1, 8.2): what cycle start runs there, as the control has it, and what was typed and not sent yet, kept
// while other pages are shown.
import { machine } from './machine.svelte';

/** The text, and the block that runs once before it; none where it is not known. */
let held = $state.raw<{ text: string; block: string } | null>(null);
let draft = $state.raw<string | null>(null);
let block = $state('');

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
    block = typed;
  },
  get isUnsent() {
    return draft !== null || block.trim() !== '';
  },
  /** Whether cycle start runs what is shown. */
  get isShown() {
    return held !== null && !this.isUnsent;
  },
  type(text: string): void {
    draft = text === held?.text ? null : text;
  },
  /** What was not sent is given up. */
  drop(): void {
    draft = null;
    block = '';
  },
  /** What the control has may be another by now. */
  forget(): void {
    held = null;
  },
  async read(): Promise<void> {
    const reply = await machine.fetch('mdi_text', { do: 'mdi_text' });
    if (!reply) return;
    held = { text: reply.text, block: reply.block };
    if (draft === reply.text) draft = null;
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
    if (block === sent) block = '';
    return true;
  },
};
