// What somebody does at the machine again and again: steps of the tests that walk through the panel.
import type { Page } from '@playwright/test';
import { expect, PASSWORDS, test } from './server';

/** A plate: its outline, twice, deeper the second time, and a round pocket. Some twenty seconds. */
export const PLATE = 'O1234 (PLATE)\nG21 G90 G54 G17\nM3 S3000\nG0 X0 Y0 Z20.\n'
  + [1, 2]
    .map((depth) => `G0 X-10. Y-10.\nG1 Z-${depth}. F600\nG1 X90. F1200\nG3 X100. Y0 R10.\nG1 Y60.\nG3 X90. Y70. R10.\nG1 X-10.\nG3 X-20. Y60. R10.\nG1 Y0\nG3 X-10. Y-10. R10.\n`)
    .join('')
  + 'G0 Z20.\nX40. Y30.\nG1 Z-3. F300\n'
  + [5, 10, 15, 20].map((radius) => `G1 X${40 + radius}. F1000\nG3 I-${radius}.\n`).join('')
  + 'G0 Z20.\nM5\nM30\n';

export const activity = (page: Page) => page.getByTestId('activity');
export const stands = (page: Page, what: string, timeout = 20_000) => expect(activity(page)).toHaveAttribute('data-activity', what, { timeout });
export const notice = (page: Page) => page.locator('.notice');
/** A key of the machine panel, let go as soon as the page has seen it. A page may have the same key too, before it. */
export async function press(page: Page, key: string): Promise<void> {
  const button = page.locator(`[data-signal="${key}"]`).last();
  await button.hover();
  await page.mouse.down();
  await expect(button).toHaveAttribute('data-held');
  await page.mouse.up();
}

/** Says commands over a connection of its own, one after the other; their answers. */
export async function say(page: Page, ...wishes: Record<string, unknown>[]): Promise<Record<string, unknown>[]> {
  const answers = await page.evaluate(
    (wishes) =>
      new Promise<string>((resolve) => {
        const socket = new WebSocket(`ws://${location.host}/api/socket`);
        const answers: Record<string, unknown>[] = [];
        const ask = () => socket.send(JSON.stringify({ id: answers.length + 1, ...wishes[answers.length] }));
        socket.onmessage = ({ data }) => {
          const message = JSON.parse(data as string) as Record<string, unknown>;
          if (message.hello) ask();
          else if (message.id === answers.length + 1) {
            answers.push(message);
            if (answers.length < wishes.length) ask();
            else {
              socket.close();
              resolve(JSON.stringify(answers));
            }
          }
        };
        socket.onerror = () => resolve('[{"error":"no connection"}]');
      }),
    wishes,
  );
  const all = JSON.parse(answers) as Record<string, unknown>[];
  expect(all.filter((answer) => 'refused' in answer || 'error' in answer)).toEqual([]);
  return all;
}

/** Releases the emergency stop: it is held until the machine has heard it. */
export async function release(page: Page, by: 'pointer' | 'Enter' | ' ' = 'pointer'): Promise<void> {
  const stop = page.getByTestId('emergency');
  await expect(stop).toHaveAttribute('aria-pressed', 'true');
  // One that was pressed a moment ago is not released.
  await page.waitForTimeout(1100);
  const [down, up] = by === 'pointer' ? [() => page.mouse.down(), () => page.mouse.up()] : [() => page.keyboard.down(by), () => page.keyboard.up(by)];
  if (by === 'pointer') await stop.hover();
  else await stop.focus();
  await down();
  await expect(stop).toHaveAttribute('aria-pressed', 'false');
  await up();
}

/** Chooses a mode. */
export async function mode(page: Page, key: string, name: string): Promise<void> {
  await press(page, key);
  await expect(page.getByTestId('mode')).toHaveText(name, { timeout: 40_000 });
}

/** The panel as one who has been here before finds it. */
export async function enter(page: Page, hash = '', commands = true): Promise<void> {
  await page.addInitScript(() => {
    if (!localStorage.getItem('ferrocut.panel')) localStorage.setItem('ferrocut.panel', '{"welcomed":true,"language":"en","theme":"dark"}');
  });
  await page.goto(`/${hash}`);
  await expect(page.getByTestId('mode')).toBeVisible();
  if (commands) await take(page);
}

export async function take(page: Page): Promise<void> {
  await expect(page.getByTestId('command')).toHaveText('Take command');
  await page.getByTestId('command').click();
  await expect(page.getByTestId('command')).toHaveText('In command');
}

/** Another page of the panel, without loading it anew. */
export async function show(page: Page, hash: string): Promise<void> {
  await page.evaluate((to) => (location.hash = to), `#/${hash}`);
  await expect(page.locator(`[data-page="${hash.split('/')[0]}"]`)).toBeVisible();
}

export async function logIn(page: Page, level: number, password = PASSWORDS[level]!): Promise<void> {
  await page.getByTestId('user').click();
  await page.getByTestId('log-in').click();
  await page.getByRole('dialog').locator('select').selectOption(String(level));
  await page.getByTestId('password').fill(password);
  await page.getByTestId('log-in-go').click();
}

export const selected = (page: Page) => page.locator('header a.program');

/** Brings a file, in place of what is there under its name. */
export async function bring(page: Page, name: string, bytes: Buffer): Promise<void> {
  await show(page, 'program/directory');
  await expect(page.getByTestId('directory')).toHaveAttribute('data-loaded', 'true');
  const row = page.locator(`[data-program="${name}"]`);
  const isThere = (await row.count()) > 0;
  const stored = page.waitForResponse((answer) => answer.url().endsWith(`/api/programs/${name}`) && answer.request().method() === 'PUT');
  await page.getByTestId('upload').setInputFiles({ name: `${name}.nc`, mimeType: 'text/plain', buffer: bytes });
  if (isThere) await page.getByTestId('replace').click();
  expect((await stored).status()).toBe(200);
  await expect(row).toBeVisible();
}

/** A program is brought as a file, chosen, and stands in AUTO. */
export async function load(page: Page, name: string, text: string): Promise<void> {
  await mode(page, 'KEY_AUTO', 'Automatic');
  await bring(page, name, Buffer.from(text));
  await page.locator(`[data-program="${name}"]`).getByRole('button').click();
  await page.getByTestId('select').click();
  await expect(selected(page)).toContainText(name);
}

/** Rapid at 100 %, as somebody sets it who knows the program. Feed and spindle are at 100 % from the start. */
export async function whole(page: Page): Promise<void> {
  await press(page, 'KEY_R_100');
  await expect(page.locator('[data-signal="KEY_R_100"]')).toHaveAttribute('aria-pressed', 'true');
}

export const x = async (page: Page) => Number((await page.locator('[data-axis="X"] .large').textContent())?.replace('−', '-'));

/** Machine zero return of the axes that are not homed yet. */
export async function home(page: Page): Promise<void> {
  const letter = (axis: string) => page.locator(`[data-axis="${axis}"] .letter`);
  const homed = (axis: string) => expect(letter(axis)).toHaveClass(/homed/, { timeout: 120_000 });
  if ((await Promise.all(['X', 'Y', 'Z'].map((axis) => letter(axis).getAttribute('class')))).every((names) => names?.includes('homed'))) return;
  await whole(page);
  await mode(page, 'KEY_HOME', 'Machine zero return');
  // The tool goes up first; then the table may move in both axes at once.
  await press(page, 'KEY_Z+');
  await homed('Z');
  await stands(page, 'idle', 60_000);
  await press(page, 'KEY_X+');
  await press(page, 'KEY_Y+');
  await homed('X');
  await homed('Y');
  await stands(page, 'idle', 60_000);
}

/** A page that fails fails its test. */
export function watchFaults(): void {
  let faults: string[] = [];
  test.beforeEach(({ page }) => {
    faults = [];
    page.on('pageerror', (fault) => faults.push(String(fault)));
  });
  test.afterEach(() => {
    expect(faults).toEqual([]);
  });
}

/** What of the page nobody can see or reach: parts that hide what does not fit into them, and do not scroll. */
export const cutOff = (page: Page) =>
  page.locator('main').evaluate((main) =>
    [...main.querySelectorAll<HTMLElement>('*')]
      .filter((part) => part.clientHeight > 30 && !part.closest('.cm-editor') && ['hidden', 'clip'].includes(getComputedStyle(part).overflowY) && part.scrollHeight > part.clientHeight + 3)
      .map((part) => `${part.tagName} ${part.className}: ${part.clientHeight} of ${part.scrollHeight}`),
  );
