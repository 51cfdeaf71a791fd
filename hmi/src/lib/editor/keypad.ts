// The keys of the editor's keypad, for those who have neither a keyboard nor one of their device on the screen.
import {
  cursorCharLeft,
  cursorCharRight,
  cursorLineDown,
  cursorLineEnd,
  cursorLineStart,
  cursorLineUp,
  deleteCharBackward,
  insertNewlineAndIndent,
  redo,
  selectCharLeft,
  selectCharRight,
  selectLineDown,
  selectLineEnd,
  selectLineStart,
  selectLineUp,
  undo,
} from '@codemirror/commands';
import type { EditorState } from '@codemirror/state';
import type { Command, EditorView } from '@codemirror/view';
import type { IconName } from '$lib/parts/icons';

/** What is typed: words as they are met most, then the rest, then signs of names and remarks. The space stands for itself. */
export const LAYERS: readonly (readonly string[])[] = [
  [...'GXYZAIJKRMFST', ...'1234567890.-'],
  [...'NOPQHDLUVWBCE', ...'+*/()[]#=,<>'],
  [...';:%_$&|!', ...'"\'?@^~\\'],
];

/** Keys that move the cursor; what they do while a piece is being selected. */
export const MOVES: Record<'left' | 'right' | 'up' | 'down' | 'home' | 'end', { icon: IconName; move: Command; select: Command }> = {
  left: { icon: 'left', move: cursorCharLeft, select: selectCharLeft },
  right: { icon: 'right', move: cursorCharRight, select: selectCharRight },
  up: { icon: 'up', move: cursorLineUp, select: selectLineUp },
  down: { icon: 'down', move: cursorLineDown, select: selectLineDown },
  home: { icon: 'home', move: cursorLineStart, select: selectLineStart },
  end: { icon: 'end', move: cursorLineEnd, select: selectLineEnd },
};

export const erase: Command = deleteCharBackward;
export const endBlock: Command = insertNewlineAndIndent;
export { redo, undo };

/** Types in the place of what is selected, as a keyboard does: codes are completed. */
export function type(view: EditorView, text: string): void {
  view.dispatch(view.state.update(view.state.replaceSelection(text), { scrollIntoView: true, userEvent: 'input.type' }));
}

/** What was taken last, for a browser that gives nobody its clipboard; and whether it is a whole line. */
let taken = { text: '', line: false };

/** What is selected, else the line of the cursor with its end. */
function chosen(state: EditorState): { from: number; to: number } {
  const { from, to, empty } = state.selection.main;
  if (!empty) return { from, to };
  const line = state.doc.lineAt(from);
  return { from: line.from, to: Math.min(line.to + 1, state.doc.length) };
}

/** Takes a piece, which is selected no longer then. */
export function copy(view: EditorView): void {
  take(view);
  view.dispatch({ selection: { anchor: view.state.selection.main.head } });
}

function take({ state }: EditorView): void {
  const { from, to } = chosen(state);
  const line = state.selection.main.empty;
  const text = state.sliceDoc(from, to);
  taken = { text: line && !text.endsWith('\n') ? `${text}\n` : text, line };
  navigator.clipboard?.writeText(taken.text).catch(() => undefined);
}

export function cut(view: EditorView): void {
  take(view);
  view.dispatch({ changes: chosen(view.state), userEvent: 'delete.cut', scrollIntoView: true });
}

/** A whole line is put before that of the cursor. */
export async function paste(view: EditorView): Promise<void> {
  const text = (await navigator.clipboard?.readText().catch(() => '')) || taken.text;
  if (!text) return;
  const { state } = view;
  const { empty, head } = state.selection.main;
  const insert = state.toText(text);
  const put = taken.line && text === taken.text && empty
    ? { changes: { from: state.doc.lineAt(head).from, insert }, selection: { anchor: head + insert.length } }
    : state.replaceSelection(insert);
  view.dispatch(state.update(put, { scrollIntoView: true, userEvent: 'input.paste' }));
}
