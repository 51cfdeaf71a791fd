// A cycle put into the program that is open in the editor, else into the one that is selected; or in place of the one that was opened.
import { t } from '$lib/i18n/index.svelte';
import { go } from '$lib/routing.svelte';
import { editing } from '$lib/state/editing.svelte';
import { machine } from '$lib/state/machine.svelte';
import { notify } from '$lib/state/notices.svelte';

/** Hands a cycle to the editor, which shows where it stands; nothing is stored until it is saved there. */
export function insert(text: string): void {
  const { opened } = editing;
  if (opened) {
    editing.put(opened.program, text, opened.lines);
    go('program', 'edit', opened.program);
    return;
  }
  const program = editing.program ?? machine.status?.program.selected;
  if (!program) {
    notify({ kind: 'warning', title: t('cycles.no_program'), text: t('cycles.no_program_text') });
    return;
  }
  editing.put(program, text);
  go('program', 'edit', program);
}
