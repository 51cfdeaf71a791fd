// What is asked over HTTP: tables and texts that do not change, checks, paths, files.
import { unit } from '$lib/i18n/index.svelte';
import type { AlarmText, Backup, DncFile, Explanation, Findings, Found, Parameter, Signal, Trouble, Word } from './answers';
import type { SessionInfo } from './connection';
import type { AlarmInfo } from './types';

/** An answer that is no success. */
export class HttpError extends Error {
  /** Why, for programs. */
  readonly code: string = '';
  /** What of it, for programs. */
  readonly detail: string = '';
  /** The alarm with which the control refused it. */
  readonly alarm: AlarmInfo | null = null;
  constructor(
    readonly status: number,
    message: string,
  ) {
    super(message);
    this.name = 'HttpError';
    try {
      const { error, detail, refused } = JSON.parse(message) as Partial<Trouble>;
      this.code = error ?? '';
      this.detail = detail ?? '';
      this.alarm = refused?.alarm ?? null;
    } catch {
      // No answer of the control's.
    }
  }
}

/** Asks a path of the server. Throws an `HttpError` unless it succeeds. */
export async function request(path: string, options: RequestInit = {}): Promise<Response> {
  const response = await fetch(path, { ...options, credentials: 'same-origin' });
  if (!response.ok) throw new HttpError(response.status, (await response.text()).slice(0, 500));
  return response;
}

async function json<T>(path: string, options?: RequestInit): Promise<T> {
  return (await (await request(path, options)).json()) as T;
}

const query = (values: Record<string, string>) => new URLSearchParams(values).toString();

/** The same of a large body, which tells how much of it went. */
function bring(path: string, body: Blob, signal: AbortSignal, went: (bytes: number) => void): Promise<string> {
  return new Promise((done, fail) => {
    const sending = new XMLHttpRequest();
    sending.open('PUT', path);
    sending.upload.onprogress = (event) => went(event.loaded);
    sending.onload = () => {
      if (sending.status >= 200 && sending.status < 300) done(sending.responseText);
      else fail(new HttpError(sending.status, sending.responseText.slice(0, 500)));
    };
    sending.onerror = () => fail(new TypeError());
    sending.onabort = () => fail(signal.reason);
    signal.addEventListener('abort', () => sending.abort());
    sending.send(body);
  });
}

/** Answers that stay the same while the server runs. */
const kept = new Map<string, Promise<unknown>>();

function once<T>(path: string): Promise<T> {
  let answer = kept.get(path) as Promise<T> | undefined;
  if (!answer) {
    answer = json<T>(path);
    kept.set(path, answer);
    answer.catch(() => kept.delete(path));
  }
  return answer;
}

export const http = {
  session(): Promise<SessionInfo> {
    return json('/api/session');
  },
  logIn(level: number, password: string): Promise<SessionInfo> {
    return json('/api/session', {
      method: 'POST',
      headers: { 'content-type': 'application/json' },
      body: JSON.stringify({ level, password }),
    });
  },
  async logOut(): Promise<void> {
    await request('/api/session', { method: 'DELETE' });
  },
  check(text: string, dialect: string, language: string, signal?: AbortSignal): Promise<Findings> {
    const options: RequestInit = { method: 'POST', body: text, headers: { 'content-type': 'text/plain' } };
    if (signal) options.signal = signal;
    return json(`/api/check?${query({ dialect, language })}`, options);
  },
  async path(program: string, signal?: AbortSignal): Promise<ArrayBuffer> {
    return (await request(`/api/path?${query({ program })}`, signal ? { signal } : {})).arrayBuffer();
  },
  async pathOf(text: string, dialect: string, signal?: AbortSignal): Promise<ArrayBuffer> {
    const options: RequestInit = { method: 'POST', body: text, headers: { 'content-type': 'text/plain' } };
    if (signal) options.signal = signal;
    return (await request(`/api/path?${query({ dialect })}`, options)).arrayBuffer();
  },
  alarm(id: string, values: Record<string, string>, language: string): Promise<AlarmText> {
    return once(`/api/alarm?${query({ id, values: JSON.stringify(values), language })}`);
  },
  explain(word: string, dialect: string, language: string): Promise<Explanation> {
    return once(`/api/explain?${query({ word, dialect, language })}`);
  },
  words(dialect: string, language: string): Promise<Word[]> {
    return once(`/api/words?${query({ dialect, language })}`);
  },
  /** The control's parameters, with the signs of units in the user's language. */
  async parameters(language: string): Promise<Parameter[]> {
    const all = await once<Parameter[]>(`/api/parameters?${query({ language })}`);
    return all.map((one) => ({ ...one, unit: unit(one.unit) }));
  },
  signals(language: string): Promise<Signal[]> {
    return once(`/api/signals?${query({ language })}`);
  },
  search(q: string, language: string): Promise<Found[]> {
    return json(`/api/search?${query({ q, language })}`);
  },
  list(kind: string, language: string): Promise<Found[]> {
    return json(`/api/list?${query({ kind, language })}`);
  },
  backups(): Promise<Backup[]> {
    return json('/api/backups');
  },
  /** Brings a backup into the folder of the memory. */
  async bringBackup(name: string, body: Blob): Promise<void> {
    await request(this.backup(name), { method: 'PUT', body });
  },
  /** Where a backup is taken away. */
  backup(name: string): string {
    return `/api/backups/${encodeURIComponent(name)}`;
  },
  dnc(): Promise<DncFile | null> {
    return json('/api/dnc');
  },
  stopDnc(): Promise<DncFile | null> {
    return json('/api/dnc', { method: 'DELETE' });
  },
  async bringDnc(file: File, signal: AbortSignal, went: (bytes: number) => void): Promise<DncFile> {
    return JSON.parse(await bring(`/api/dnc/${encodeURIComponent(file.name)}`, file, signal, went)) as DncFile;
  },
  async upload(name: string, body: Blob | string): Promise<void> {
    await request(`/api/programs/${encodeURIComponent(name)}`, { method: 'PUT', body });
  },
  async program(name: string): Promise<string> {
    // `text()` would take the mark away that a program may begin with.
    const bytes = await (await request(this.download(name))).arrayBuffer();
    return new TextDecoder('utf-8', { ignoreBOM: true }).decode(bytes);
  },
  download(name: string): string {
    return `/api/programs/${encodeURIComponent(name)}`;
  },
};
