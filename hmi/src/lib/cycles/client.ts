// What is asked of the server about cycles.
import { request } from '$lib/api/http';
import type { Drawing, Form, Request, Written } from '$lib/api/cycles';

const query = (values: Record<string, string>) => new URLSearchParams(values).toString();

const kept = new Map<string, Promise<Form[]>>();

function post(body: Request, signal?: AbortSignal): RequestInit {
  const options: RequestInit = {
    method: 'POST',
    headers: { 'content-type': 'application/json' },
    body: JSON.stringify(body),
  };
  if (signal) options.signal = signal;
  return options;
}

export const client = {
  /** Every cycle as a form; they stay the same while the server runs. */
  forms(language: string): Promise<Form[]> {
    let answer = kept.get(language);
    if (!answer) {
      answer = request(`/api/cycles?${query({ language })}`).then((response) => response.json() as Promise<Form[]>);
      kept.set(language, answer);
      answer.catch(() => kept.delete(language));
    }
    return answer;
  },
  /** The cycle as text in a control's language, and what is wrong with it. */
  async write(body: Request, dialect: string, language: string, signal?: AbortSignal): Promise<Written> {
    const response = await request(`/api/cycle?${query({ dialect, language })}`, post(body, signal));
    return (await response.json()) as Written;
  },
  /** The path of the cycle alone. */
  async path(body: Request, signal?: AbortSignal): Promise<ArrayBuffer> {
    return (await request('/api/cycle/path', post(body, signal))).arrayBuffer();
  },
  /** Contours of a DXF drawing. */
  async drawing(file: Blob, language: string): Promise<Drawing> {
    const response = await request(`/api/profile/dxf?${query({ language })}`, { method: 'POST', body: file });
    return (await response.json()) as Drawing;
  },
};
