// Units of what stands in tables. The control keeps places and offsets in mm whatever its programs are written in.
import { t } from '$lib/i18n/index.svelte';
import { machine } from '$lib/state/machine.svelte';

/** The unit of places: mm, and degrees where the machine has an axis that turns. */
export const placeUnit = () => (machine.axes.some((axis) => 'ABC'.includes(axis)) ? `${t('unit.mm')}, ${t('unit.deg')}` : t('unit.mm'));
