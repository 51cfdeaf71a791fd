// Texts of alarms, which the server has in its catalogues; asked for once each and language.
import type { AlarmText } from '$lib/api/answers';
import { http } from '$lib/api/http';
import { has, language, t } from '$lib/i18n/index.svelte';
import { SvelteMap } from 'svelte/reactivity';

const texts = new SvelteMap<string, AlarmText>();
const asked = new Set<string>();

/** The text of an alarm; its number alone until the server has answered. */
export function alarmText(alarm: { id: string; values: Record<string, string> }): AlarmText {
  const lang = language();
  const key = `${lang} ${alarm.id} ${JSON.stringify(alarm.values)}`;
  const known = texts.get(key);
  if (known) return known;
  if (!asked.has(key)) {
    asked.add(key);
    http.alarm(alarm.id, alarm.values, lang).then(
      (text) => texts.set(key, text),
      () => asked.delete(key),
    );
  }
  return { id: alarm.id, text: '', help: '' };
}

/** What a message of the ladder says; its name where it is of a ladder that brought its own. */
export function messageText(name: string): string {
  return has(`message.${name}`) ? t(`message.${name}`) : name;
}
