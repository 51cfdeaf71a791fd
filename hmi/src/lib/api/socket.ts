// The connection to the machine: commands with their answers, events, the status, and the dead man's switch.
// `docs/serve.md` has the lines, `docs/api.md` the commands.
import type { ConnectionCommand, ConnectionEvent, Hello } from './connection';
import type { AlarmInfo, Command, Event, Reply, Status } from './types';

/** What a connection is asked for. */
export type Wish = Command | ConnectionCommand;

/** Why a command came to nothing: the control refused it, or the connection did. */
export class Refused extends Error {
  constructor(
    readonly code: string,
    readonly alarm: AlarmInfo | null,
    readonly detail = '',
    /** Whether the machine may have done it all the same: the connection was lost before it answered. */
    readonly open = false,
  ) {
    super(alarm ? alarm.id : `${code} ${detail}`.trim());
    this.name = 'Refused';
  }
}

/** What the owner of a connection wants to hear. */
export type Listener = {
  state(state: 'connecting' | 'open' | 'lost'): void;
  hello(hello: Hello): void;
  event(event: Event | ConnectionEvent): void;
  status(status: Status): void;
  end(reason: string): void;
};

type Waiting = { resolve(reply: Reply): void; reject(refused: Refused): void };

/** ms between signs of life while a key is held: a third of the dead man's 250 ms. */
const ALIVE_MS = 80;
/** ms between signs of life else: the server closes a socket of which nothing comes for 35 s. */
const QUIET_MS = 10_000;
/** ms before the first and the longest attempt to connect anew. */
const RETRY_MS = [250, 3000] as const;

/** One connection, which comes back by itself. */
export class Connection {
  #socket: WebSocket | null = null;
  #next = 1;
  #waiting = new Map<number, Waiting>();
  #held = new Set<string>();
  #alive: ReturnType<typeof setInterval> | undefined;
  #quiet: ReturnType<typeof setInterval> | undefined;
  #retry: ReturnType<typeof setTimeout> | undefined;
  #attempts = 0;
  #closed = false;
  #greeted = false;

  constructor(
    readonly url: string,
    readonly listener: Listener,
  ) {}

  /** Connects, and again whenever the connection is lost. */
  open(): void {
    this.#closed = false;
    clearTimeout(this.#retry);
    this.listener.state('connecting');
    const socket = new WebSocket(this.url);
    this.#socket = socket;
    this.#greeted = false;
    socket.onmessage = (message) => this.#hear(String(message.data));
    socket.onclose = () => {
      if (this.#socket === socket) this.#lost();
    };
  }

  /** Ends the connection for good. Keys that it holds are let go by the machine. */
  close(): void {
    this.#closed = true;
    clearTimeout(this.#retry);
    this.releaseAll();
    const socket = this.#socket;
    if (socket) this.#lost();
    socket?.close();
  }

  /** Says a command and waits for the answer. */
  ask(wish: Wish): Promise<Reply> {
    return new Promise((resolve, reject) => {
      const socket = this.#socket;
      if (!socket || socket.readyState !== WebSocket.OPEN || !this.#greeted) {
        reject(new Refused('no_connection', null));
        return;
      }
      const id = this.#next++;
      this.#waiting.set(id, { resolve, reject });
      socket.send(JSON.stringify({ id, ...wish }));
    });
  }

  /** Presses a key and keeps it alive until `release`. */
  hold(key: string): Promise<Reply> {
    this.#held.add(key);
    this.#alive ??= setInterval(() => {
      this.#tell({ do: 'alive' });
    }, ALIVE_MS);
    return this.ask({ do: 'key', key, down: true });
  }

  /** Lets a key go. */
  release(key: string): Promise<Reply> | null {
    if (!this.#held.delete(key)) return null;
    if (this.#held.size === 0) {
      clearInterval(this.#alive);
      this.#alive = undefined;
    }
    return this.ask({ do: 'key', key, down: false });
  }

  /** Lets all keys go: the page is left, or lost the focus. */
  releaseAll(): void {
    for (const key of [...this.#held]) this.release(key)?.catch(() => undefined);
  }

  #tell(wish: Wish): void {
    if (this.#socket?.readyState === WebSocket.OPEN) this.#socket.send(JSON.stringify(wish));
  }

  #hear(text: string): void {
    const line = JSON.parse(text);
    if (line.status !== undefined && line.id === undefined) {
      this.listener.status(line.status as Status);
    } else if (line.id !== undefined) {
      const waiting = this.#waiting.get(line.id);
      this.#waiting.delete(line.id);
      if (!waiting) return;
      if (line.reply !== undefined) waiting.resolve(line as Reply);
      else if (line.refused !== undefined) waiting.reject(new Refused('refused', line.refused.alarm ?? line.refused));
      else waiting.reject(new Refused(String(line.error), null, String(line.detail ?? '')));
    } else if (line.event !== undefined) {
      this.listener.event(line as Event | ConnectionEvent);
    } else if (line.hello !== undefined) {
      this.#attempts = 0;
      this.#greeted = true;
      this.listener.hello(line as Hello);
      this.listener.state('open');
      this.#quiet = setInterval(() => this.#tell({ do: 'alive' }), QUIET_MS);
      this.ask({ do: 'watch', events: true, status: true }).catch(() => undefined);
    } else if (line.end !== undefined) {
      this.listener.end(String(line.end));
    }
  }

  #lost(): void {
    this.#socket = null;
    this.#greeted = false;
    clearInterval(this.#quiet);
    this.#held.clear();
    clearInterval(this.#alive);
    this.#alive = undefined;
    const waiting = [...this.#waiting.values()];
    this.#waiting.clear();
    for (const one of waiting) one.reject(new Refused('no_connection', null, '', true));
    this.listener.state('lost');
    if (this.#closed) return;
    const [first, longest] = RETRY_MS;
    this.#retry = setTimeout(() => this.open(), Math.min(first * 2 ** this.#attempts++, longest));
  }
}
