import type { Backup } from '$lib/api/answers';

/** What a control that runs takes from no backup: it knows where its axes are. */
const NOT_RESTORED = 'position';

export const isRestored = (item: string): boolean => item !== NOT_RESTORED;

/** Items that are restored from a file; none where the file is no backup that there is. */
export function restorable(file: string, chosen: string[], backups: Backup[]): string[] {
  return backups.some((one) => one.name === file) ? chosen.filter(isRestored) : [];
}
