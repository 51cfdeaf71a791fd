/** What a control that runs takes from no backup: it knows where its axes are. */
const NOT_RESTORED = 'position';

export const isRestored = (item: string): boolean => item !== NOT_RESTORED;
