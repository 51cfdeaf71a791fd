import { t } from "./i18n/index.svelte.js";
import { machine } from "./state/machine.svelte.js";
// src/lib/units.ts
var turns = (axis) => "ABC".includes(axis);
/** The unit of places of an axis. */
var unitOf = (axis) => t(turns(axis) ? "unit.deg" : "unit.mm");
/** The units of places of the machine's axes. */
var placeUnit = () => machine.axes.some(turns) ? `${t("unit.mm")}, ${t("unit.deg")}` : t("unit.mm");
export { placeUnit, unitOf };
