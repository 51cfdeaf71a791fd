/** Units whose keys are not their signs. */
const others: Record<string, string> = { 'r/min': 'rpm', '°': 'deg' };

/** The key of a unit, from the sign that the control's tables write: `mm/s2` has `unit.mm_s2`. */
export const unitKey = (sign: string): string => `unit.${others[sign] ?? sign.replace('/', '_')}`;
