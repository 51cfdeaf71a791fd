// src/lib/i18n/units.ts
/** Units whose keys are not their signs. */
var others = {
	"r/min": "rpm",
	"°": "deg"
};
/** The key of a unit, from the sign that the control's tables write: `mm/s2` has `unit.mm_s2`. */
var unitKey = (sign) => `unit.${others[sign] ?? sign.replace("/", "_")}`;
export { unitKey };
