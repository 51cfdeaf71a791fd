// The machine as this browser knows it: connection, status, who commands, events. One for the whole page.
import type { Asking, ConnectionEvent, Hello } from '$lib/api/connection';
import { Connection, Refused, type Wish } from '$lib/api/socket';
import { http, HttpError } from '$lib/api/http';
import type { AlarmInfo, Event, Mode, Reply, Status } from '$lib/api/types';
import { has, language, t } from '$lib/i18n/index.svelte';
import { SvelteMap } from 'svelte/reactivity';
import { notify } from './notices.svelte';
import { share } from './share';

export type Version = Extract<Reply, { reply: 'version' }>;

let link = $state.raw<'connecting' | 'open' | 'lost'>('connecting');
let greeting = $state.raw<Hello | null>(null);
let version = $state.raw<Version | null>(null);
/** The latest status, as it came. */
let latest: Status | null = null;
/** Its fields, each by itself: what shows one is not asked again when another changes. */
const fields = new SvelteMap<string | symbol, unknown>();
const status = new Proxy({} as Status, {
  get: (_, field) => fields.get(field),
  has: (_, field) => fields.has(field),
});
let hasStatus = $state.raw(false);
/** Fields that change all the time while a machine moves: as often as eyes read is enough, and each status brings one of them.
    What draws them itself hears all of them (`watch`). */
const MEASURES: readonly (keyof Status)[] = ['periods', 'position', 'feed', 'counters', 'spindle'];
let turns = 0;
/** A status of which each 50th is told, for texts that nobody sees, and each with which the machine begins or ends something or
    comes to rest. */
class Calm {
  told = $state.raw<Status | null>(null);
}
const CALM = 50;
/** They are told one after the other, so that no status has all texts, each with the measure that the fewest look at. */
const calm = Array.from({ length: 2 }, () => new Calm());
const isTurningPoint = (before: Status, now: Status) => before.activity !== now.activity || (before.feed.actual !== 0 && now.feed.actual === 0);

/** Puts what has changed before those who look at it. */
function put(now: Status): void {
  for (const field of fields.keys()) if (!((field as string) in now)) fields.delete(field);
  for (const [index, one] of calm.entries()) {
    const isDue = turns % CALM === index * (CALM / calm.length);
    if (!one.told || isDue || isTurningPoint(one.told, now)) one.told = now;
  }
  const turn = turns % MEASURES.length;
  turns += 1;
  for (const field in now) {
    const value = now[field as keyof Status];
    const waits = fields.has(field) && (MEASURES as readonly string[]).includes(field) && field !== MEASURES[turn];
    if (!waits) fields.set(field, value);
  }
  hasStatus = true;
}
let inCommand = $state.raw(false);
let holder = $state.raw<number | null>(null);
/** Those who ask for command. */
let asking = $state.raw<Asking[]>([]);
/** Whether nothing is told before somebody logs in; null until the server has said so. */
let gate = $state.raw<boolean | null>(null);
/** Of the session, 1 to 4; 0 for the operator. */
let rights = $state.raw(0);
let messages = $state.raw<string[]>([]);
let mode = $state.raw<Mode | null>(null);
let lit: readonly string[] = [];
let lamps = $state.raw<ReadonlySet<string>>(new Set());
/** Counts up with each event `changed`, by item; pages that show an item read it again. */
const changes = $state<Record<string, number>>({});

const hearers = new Set<(event: Event) => void>();
const watchers = new Set<(status: Status) => void>();

const isMine = (one: Asking) => one.connection === greeting?.connection;

function heard(event: Event | ConnectionEvent): void {
  switch (event.event) {
    case 'command':
      if (event.you && asking.some(isMine)) notify({ kind: 'info', title: t('app.handed_to_you') });
      inCommand = event.you;
      holder = event.holder;
      asking = event.asking;
      keepCommand(event.you, event.holder);
      return;
    case 'declined':
      notify({ kind: 'warning', title: t('app.declined') });
      return;
    case 'refused':
      void tellAlarm(event.alarm);
      break;
    case 'changed':
      changes[event.item] = (changes[event.item] ?? 0) + 1;
      break;
    default:
  }
  for (const hear of hearers) hear(event);
}

/** Who commanded before a reload or a lost connection takes command again, if nobody else did. */
const COMMANDED = 'ferrocut.commanded';
let again = sessionStorage.getItem(COMMANDED) !== null;

/** Until it is answered. */
let asks = false;

function keepCommand(you: boolean, by: number | null): void {
  if (you) {
    again = false;
    sessionStorage.setItem(COMMANDED, '');
  } else if (by !== null) {
    again = false;
    sessionStorage.removeItem(COMMANDED);
  }
}

function takeAgain(): void {
  if (!again) return;
  again = false;
  asks = true;
  connection
    .ask({ do: 'take_command' })
    .catch(() => undefined)
    .finally(() => (asks = false));
}

/** What a user is told of something that came to nothing, in his language; never the words of a program. */
export type Reason = { title: string; text?: string; code?: string };

async function reasonOfAlarm(alarm: AlarmInfo): Promise<Reason> {
  try {
    const { text, help } = await http.alarm(alarm.id, alarm.values, language());
    return { title: text, text: help ?? '', code: alarm.id };
  } catch {
    return { title: alarm.id };
  }
}

/** Why: the alarm with which the control refused it, or the text of its code. */
async function reasonOf(refused: unknown): Promise<Reason> {
  // A request that found no server.
  if (refused instanceof TypeError) return { title: t('error.no_connection') };
  if (!(refused instanceof Refused || refused instanceof HttpError)) return { title: t('error.failed') };
  if (refused.alarm) return reasonOfAlarm(refused.alarm);
  const { code, detail } = refused;
  const key = [`error.${detail}`, `error.${code}`].find((one) => has(one));
  if (key) return { title: t(key) };
  return { title: t('error.failed'), code: code || (refused instanceof HttpError ? String(refused.status) : '') };
}

async function tellAlarm(alarm: AlarmInfo): Promise<void> {
  notify({ kind: 'warning', ...(await reasonOfAlarm(alarm)) });
}

const protocol = location.protocol === 'https:' ? 'wss:' : 'ws:';
const connection = new Connection(`${protocol}//${location.host}/api/socket`, {
  state(now) {
    link = now;
    if (now === 'lost') {
      again ||= inCommand;
      inCommand = false;
      holder = null;
      asking = [];
      // The session may have ended, as it does with the server: then no socket opens before a log-in.
      if (gate === false) void admit();
    }
  },
  hello(now) {
    greeting = now;
    rights = now.session?.level ?? 0;
    takeAgain();
    connection.ask({ do: 'version' }).then(
      (reply) => {
        if (reply.reply === 'version') version = reply;
      },
      () => undefined,
    );
  },
  event: heard,
  status(told) {
    const now = share(latest, told);
    latest = now;
    put(now);
    // The same object where they are as they were.
    messages = now.messages;
    mode = now.mode;
    if (now.lamps !== lit) {
      lit = now.lamps;
      lamps = new Set(lit);
    }
    for (const watch of watchers) watch(now);
  },
  end(reason) {
    const key = `error.${reason}`;
    if (reason !== 'closed') notify({ kind: 'warning', title: t('app.ended'), text: has(key) ? t(key) : '', code: has(key) ? '' : reason });
  },
});

/** Asks who this browser is. Where it must log in first the socket is closed: the server would refuse it. */
async function admit(): Promise<void> {
  try {
    const session = await http.session();
    gate = session.needs_log_in && session.level === 0;
  } catch {
    // The server is away, and the connection goes on trying.
    gate ??= false;
  }
  if (!gate) return;
  rights = 0;
  connection.close();
  // Who logs in next may be somebody else.
  again = false;
  sessionStorage.removeItem(COMMANDED);
}

/** Tells the user what was refused. */
function tellRefused(refused: unknown): void {
  void reasonOf(refused).then((reason) => notify({ kind: 'warning', ...reason }));
}

export const machine = {
  get link() {
    return link;
  },
  get hello() {
    return greeting;
  },
  get version() {
    return version;
  },
  /** Whether somebody must log in before the server says anything; null until that is known. */
  get gate() {
    return gate;
  },
  /** The latest status; null before the first. It comes 50 times a second and is never changed in place; parts that are as they
      were are the same objects as before. Each field is followed by itself: positions, feeds and times ten times a second
      (`watch` has each), all others as they change. */
  get status(): Status | null {
    return hasStatus ? status : null;
  },
  /** A status of the last second: for what stands behind numbers that are drawn, to be heard and not seen. Null before the first.
      Texts of one `part` follow together, those of another at another time. */
  calm(part: number): Status | null {
    return calm[part % calm.length]!.told;
  },
  /** The mode of the latest status: for what looks at that alone. */
  get mode() {
    return mode;
  },
  /** The lamps that are lit, likewise. */
  get lamps() {
    return lamps;
  },
  /** Whether this browser commands. */
  get inCommand() {
    return inCommand;
  },
  /** Whether command is asked for again after the connection was lost. */
  get regains() {
    return again || asks;
  },
  /** The connection that commands. */
  get holder() {
    return holder;
  },
  /** Those who ask for command, first come first. */
  get asking() {
    return asking;
  },
  /** Whether this browser asks for it. */
  get asksForCommand() {
    return asking.some(isMine);
  },
  /** Messages of the ladder that stand. */
  get messages() {
    return messages;
  },
  /** What the program says. */
  get programMessage(): string {
    return this.status?.program_message ?? '';
  },
  /** The level whose rights this browser has: 5 is the operator. The level of the status is that of all who gave their
      password over the socket, and says nothing of a session. */
  get level(): number {
    return rights || 5;
  },
  /** Letters of the axes. */
  get axes(): string[] {
    return version?.axes ?? Object.keys(this.status?.position.machine ?? {});
  },
  get dialect(): string {
    return version?.dialect ?? 'gsk990mc';
  },
  /** How often an item of the memory was changed: to be read where it must be shown anew. */
  changed(item: string): number {
    return changes[item] ?? 0;
  },

  start(): void {
    // The socket is of the session whose cookie the browser has when it opens.
    void admit().then(() => {
      if (!gate) connection.open();
    });
    const letGo = () => connection.releaseAll();
    addEventListener('blur', letGo);
    addEventListener('pagehide', letGo);
    document.addEventListener('visibilitychange', () => {
      if (document.visibilityState === 'hidden') letGo();
    });
  },
  /** Connects anew, such as after a log-in. */
  reconnect(): void {
    connection.close();
    connection.open();
  },
  /** Gives command away: a reload does not take it again. */
  giveCommand(): void {
    sessionStorage.removeItem(COMMANDED);
    void this.tell({ do: 'give_command' });
  },
  /** Takes the rights of a level, and connects where that had to wait for them. */
  async logIn(level: number, password: string): Promise<void> {
    rights = (await http.logIn(level, password)).level;
    if (!gate) return;
    gate = false;
    connection.open();
  },
  /** Gives up the rights that were logged in with. */
  async logOut(): Promise<void> {
    try {
      await http.logOut();
    } catch (failed) {
      tellRefused(failed);
    }
    await admit();
    if (!gate) this.reconnect();
  },
  /** Says a command; the answer, or `Refused`. */
  ask(wish: Wish): Promise<Reply> {
    return connection.ask(wish);
  },
  /** Says a command and tells the user where it is refused. Whether it was done. */
  async tell(wish: Wish): Promise<boolean> {
    try {
      await connection.ask(wish);
      return true;
    } catch (refused) {
      tellRefused(refused);
      return false;
    }
  },
  /** Asks for data of one kind; null, and the user was told, where it is refused. */
  async fetch<R extends Reply['reply']>(kind: R, wish: Wish): Promise<Extract<Reply, { reply: R }> | null> {
    try {
      const reply = await connection.ask(wish);
      return reply.reply === kind ? (reply as Extract<Reply, { reply: R }>) : null;
    } catch (refused) {
      if (!(refused instanceof Refused && refused.code === 'no_connection')) tellRefused(refused);
      return null;
    }
  },
  hold(key: string): void {
    connection.hold(key).catch((refused) => {
      void connection.release(key)?.catch(() => undefined);
      tellRefused(refused);
    });
  },
  release(key: string): void {
    connection.release(key)?.catch(() => undefined);
  },
  /** Hears events until the answer is called. */
  hear(hearer: (event: Event) => void): () => void {
    hearers.add(hearer);
    return () => hearers.delete(hearer);
  },
  /** Hears each status until the answer is called: for what draws itself. */
  watch(watcher: (status: Status) => void): () => void {
    watchers.add(watcher);
    return () => watchers.delete(watcher);
  },
  refused: tellRefused,
  /** Why something came to nothing. */
  reason: reasonOf,
  /** Tells the user that a command was not even sent. */
  refuse(code: string): void {
    tellRefused(new Refused(code, null));
  },
};
