import { gather } from '$lib/i18n/gather';

export default gather(import.meta.glob<Record<string, string>>('./*.json', { eager: true, import: 'default' }));
