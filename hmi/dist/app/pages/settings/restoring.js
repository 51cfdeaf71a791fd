// src/pages/settings/restoring.ts
/** What a control that runs takes from no backup: it knows where its axes are. */
var NOT_RESTORED = "position";
var isRestored = (item) => item !== NOT_RESTORED;
/** Items that are restored from a file; none where the file is no backup that there is. */
function restorable(file, chosen, backups) {
	return backups.some((one) => one.name === file) ? chosen.filter(isRestored) : [];
}
export { isRestored, restorable };
