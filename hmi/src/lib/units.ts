// Units of what stands in tables. The control keeps places and offsets in mm whatever its programs are written in.
import { t } from '$lib/i18n/index.svelte';
import { machine } from '$lib/state/machine.svelte';

const turns = (axis: string) => 'ABC'.includes(axis);

/** The unit of places of an axis. */
export const unitOf = (axis: string) => t(turns(axis) ? 'unit.deg' : 'unit.mm');

/** The units of places of the machine's axes. */
export const placeUnit = () => (machine.axes.some(turns) ? `${t('unit.mm')}, ${t('unit.deg')}` : t('unit.mm'));
