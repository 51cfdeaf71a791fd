// A page that sleeps, or is loaded anew again and again, disturbs no job: each setpoint of it is the same. That a hundred
// reloads change no bit of a job is tried without a browser (`crates/server/tests/safety.rs`).
import type { Page } from '@playwright/test';
import { expect, test } from './server';
import { sleeper } from './sleeper';
import { enter, home, load, press, say, show, stands, take, watchFaults, whole } from './walk';

watchFaults();

/** Round a square with round corners three times, from the zero point and back to it; some twenty seconds. */
const ROUND = 'G1 X-70.\nG3 X-80. Y-20. J-10.\nG1 Y-70.\nG3 X-70. Y-80. I10.\nG1 X-20.\nG3 X-10. Y-70. J10.\nG1 Y-20.\nG3 X-20. Y-10. I-10.\n';
const JOB = `O7300 (ROUND)\nG21 G90 G54 G17\nG1 X-20. Y-10. F2400\n${ROUND.repeat(3)}G1 X0 Y0\nM30\n`;
const SECONDS = 16;

type Part = { done: boolean; samples: number; csv: string };
const part = async (page: Page, from: number, most: number) => (await say(page, { do: 'captured', from, most }))[0] as unknown as Part;

/** Every setpoint of the job, as a text, from its first straight line on. */
async function recorded(page: Page): Promise<string> {
  await expect.poll(async () => (await part(page, 0, 0)).done, { timeout: 90_000 }).toBe(true);
  const { samples } = await part(page, 0, 0);
  let [text, rows] = ['', 0];
  while (rows < samples) {
    const { csv } = await part(page, rows, 4000);
    text += csv;
    rows = text.trimEnd().split('\n').length - 1;
  }
  expect(rows).toBe(SECONDS * 1000);
  return text;
}

/** The first sample that is another in any digit, in both; nothing where none is. */
function different(wanted: string, found: string): string {
  const [one, other] = [wanted.split('\n'), found.split('\n')];
  const at = one.findIndex((row, index) => row !== other[index]);
  return at < 0 && one.length === other.length ? '' : `${one[at]} is ${other[at]}`;
}

test('a page that is loaded anew, or asleep, changes no sample of a job', async ({ page, browser, server }) => {
  test.setTimeout(400_000);
  const beside = await (await browser.newContext()).newPage();
  await beside.goto(server.url);
  const command = page.getByTestId('command');
  /** Records what is run next, for which whoever records needs command. */
  const record = async () => {
    await command.click();
    await expect(command).toHaveText('Take command');
    const capture = { do: 'capture', quantities: ['setpoint.X', 'setpoint.Y', 'velocity'], seconds: SECONDS, trigger: { quantity: 'setpoint.X', level: -20.5, rises: false } };
    await say(beside, { do: 'take_command' }, capture, { do: 'give_command' });
  };
  const start = async () => {
    await press(page, 'KEY_START');
    await stands(page, 'running');
  };
  await enter(page, '#/position');
  await home(page);
  await load(page, 'O7300', JOB);
  await show(page, 'position');
  await whole(page);

  await record();
  await take(page);
  await start();
  const wanted = await recorded(beside);
  await stands(page, 'idle', 60_000);

  await record();
  await take(page);
  await start();
  // Within the job, on a slow computer too.
  const until = Date.now() + 10_000;
  for (let reload = 0; reload < 3 || (reload < 10 && Date.now() < until); reload++) await page.reload({ waitUntil: reload % 2 ? 'load' : 'domcontentloaded' });
  await stands(page, 'running');
  expect(different(wanted, await recorded(beside)), 'the samples beside a page that is loaded anew').toBe('');
  await stands(page, 'idle', 60_000);

  // Who is in command starts the job, and falls asleep: he hears nothing and does nothing.
  await expect(command).toHaveText('In command', { timeout: 60_000 });
  await record();
  const other = await sleeper(server.url);
  try {
    const holds = (expression: string) => expect.poll(() => other.evaluate(expression), { message: expression, timeout: 60_000 }).toBe(true);
    await holds(`document.querySelector('[data-testid="command"]') !== null`);
    await other.evaluate(`localStorage.setItem('ferrocut.panel', '{"welcomed":true,"panel":true,"language":"en"}'), location.reload()`);
    await holds(`document.querySelector('[data-testid="command"]')?.textContent.includes('Take command') ?? false`);
    // A page that was loaded just now may not be connected yet: then nobody hears what is asked for.
    const taken = `(({ textContent }) => textContent.includes('In command'))(document.querySelector('[data-testid="command"]'))`;
    await expect
      .poll(async () => (await other.evaluate(taken)) || (await other.evaluate(`document.querySelector('[data-testid="command"]').click()`)), { message: taken, intervals: [3000], timeout: 90_000 })
      .toBe(true);
    const key = 'footer [data-signal="KEY_START"]';
    await other.down(key);
    await holds(`'held' in document.querySelector('${key}').dataset`);
    await other.up(key);
    await holds(`document.querySelector('[data-testid="activity"]').dataset.activity === 'running'`);
    await other.evaluate('globalThis.beats = 0, setInterval(() => (globalThis.beats += 1), 20)');
    await other.sleep(true);
    expect(different(wanted, await recorded(beside)), 'the samples while who commands is asleep').toBe('');
    expect(await other.evaluate<number>('globalThis.beats'), 'beats while it slept').toBeLessThan(50);
    // When it wakes it shows how things stand.
    await other.sleep(false);
    await holds(`document.querySelector('[data-testid="activity"]').dataset.activity === 'idle'`);
  } finally {
    await other.end();
  }
  await beside.context().close();
});
