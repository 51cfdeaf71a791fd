// Texts of alarms, which the server has in its catalogues, and of messages of the ladder; asked for once each and language.
import type { AlarmText } from '$lib/api/answers';
import { http } from '$lib/api/http';
import { has, language, t } from '$lib/i18n/index.svelte';
import { SvelteMap } from 'svelte/reactivity';
import { machine } from './machine.svelte';

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

/** What the ladder remarks on its messages, by their names. */
let remarks = $state.raw<Readonly<Record<string, string>>>({});
/** Of which language and ladder they were asked. */
let askedOf = '';

/** What a message of the ladder says: of one that brought its own, its remark; its name where it has none. */
export function messageText(name: string): string {
  if (has(`message.${name}`)) return t(`message.${name}`);
  const lang = language();
  const wanted = `${lang} ${machine.changed('ladder')}`;
  if (machine.link === 'open' && wanted !== askedOf) {
    askedOf = wanted;
    machine.ask({ do: 'signal_table', area: 'A', language: lang }).then(
      (reply) => {
        if (reply.reply === 'signal_table' && askedOf === wanted) remarks = Object.fromEntries(reply.signals.map((one) => [one.name, one.meaning]));
      },
      () => {
        if (askedOf === wanted) askedOf = '';
      },
    );
  }
  return remarks[name] || name;
}

/** The number of what the machine said through its ladder, in the history. */
const SAID = 'FC-1446';

/** What stands in the history: of a message what it says, where the ladder that runs still knows it. */
export function pastText(alarm: { id: string; values: Record<string, string> }): AlarmText {
  const about = alarmText(alarm);
  const name = alarm.id === SAID ? (alarm.values.name ?? '') : '';
  const says = name && messageText(name);
  return says && says !== name ? { ...about, text: says } : about;
}
