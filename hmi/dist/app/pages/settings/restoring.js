// src/pages/settings/restoring.ts
/** What a control that runs takes from no backup: it knows where its axes are. */
var NOT_RESTORED = "position";
var isRestored = (item) => item !== NOT_RESTORED;
export { isRestored };
