// A browser whose page can be put to sleep. Playwright keeps its own pages in focus, and a page in focus is never frozen: so
// this one is led by the browser's protocol alone.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Readable, Writable } from 'node:stream';

const executable = process.env.CHROMIUM ?? '/usr/bin/chromium';

export async function sleeper(url: string) {
  const profile = mkdtempSync(join(tmpdir(), 'ferrocut-sleeper-'));
  const child = spawn(executable, ['--headless=new', '--no-sandbox', '--window-size=1366,820', '--remote-debugging-pipe', `--user-data-dir=${profile}`, 'about:blank'], {
    stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'],
  });
  const [out, into] = [child.stdio[3] as Writable, child.stdio[4] as Readable];
  const waiting: ((result: Record<string, unknown>) => void)[] = [];
  let heard = '';
  into.on('data', (part: Buffer) => {
    const messages = (heard + part.toString()).split('\0');
    heard = messages.pop()!;
    for (const message of messages) {
      const { id, result } = JSON.parse(message) as { id?: number; result?: Record<string, unknown> };
      if (id !== undefined) waiting[id]?.(result ?? {});
    }
  });
  let sessionId: string | undefined;
  const send = (method: string, params: object = {}) =>
    new Promise<Record<string, unknown>>((resolve) => {
      out.write(`${JSON.stringify({ id: waiting.push(resolve) - 1, method, params, sessionId })}\0`);
    });
  async function end(): Promise<void> {
    const ended = new Promise((resolve) => child.once('exit', resolve));
    if (child.exitCode === null && child.signalCode === null && child.kill()) await ended;
    rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  }
  // Its page is there a little later than it is.
  let targetId: string | undefined;
  for (let tries = 0; !targetId; tries++) {
    const { targetInfos } = (await send('Target.getTargets')) as { targetInfos: { type: string; targetId: string }[] };
    targetId = targetInfos.find(({ type }) => type === 'page')?.targetId;
    if (targetId) break;
    if (tries > 100) {
      await end();
      throw new Error(`${executable} opens no page`);
    }
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  sessionId = (await send('Target.attachToTarget', { targetId, flatten: true })).sessionId as string;

  /** What an expression comes to in the page. */
  const evaluate = async <Value>(expression: string): Promise<Value> =>
    ((await send('Runtime.evaluate', { expression, returnByValue: true })).result as { value: Value } | undefined)?.value as Value;
  const mouse = async (type: string, selector: string) => {
    const [x, y] = await evaluate<[number, number]>(`(({ x, y, width, height }) => [x + width / 2, y + height / 2])(document.querySelector('${selector}').getBoundingClientRect())`);
    await send('Input.dispatchMouseEvent', { type, x, y, button: 'left', clickCount: 1 });
  };
  // A browser that is only just starting may lose the first of these.
  for (let tries = 0; tries < 20 && !(await evaluate<boolean>(`location.href.startsWith('${url}')`)); tries++) {
    await send('Page.navigate', { url });
    await new Promise((resolve) => setTimeout(resolve, 1000));
  }
  return {
    evaluate,
    down: (selector: string) => mouse('mousePressed', selector),
    up: (selector: string) => mouse('mouseReleased', selector),
    /** Puts the page to sleep, or wakes it. */
    sleep: (sleeps: boolean) => send('Page.setWebLifecycleState', { state: sleeps ? 'frozen' : 'active' }),
    end,
  };
}
