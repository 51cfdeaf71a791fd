// The figures of the panel, measured and written to `test-results/figures.json` (`docs/panel-figures.md`). They are told,
// not judged: how fast a machine is that runs the tests says nothing of the panel. `FIGURES=strict` judges them,
// `FIGURES=loose` by five times the times, as on a computer that others use too.
import { expect, test, type Page } from '@playwright/test';
import { test as served } from './server';
import { enter, load, PLATE, press, show, stands, whole } from './walk';
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { mock } from './mock';

const figures: Record<string, number> = {};
/** By how much a figure may be above its bound; none judges it. */
const tolerance = ({ strict: 1, loose: 5 } as Record<string, number>)[process.env.FIGURES ?? ''];

function tell(name: string, value: number, limit: number, isTime = true): void {
  figures[name] = Math.round(value * 100) / 100;
  console.log(`${name}: ${figures[name]} (at most ${limit})`);
  if (tolerance) expect(value, name).toBeLessThanOrEqual(limit * (isTime ? tolerance : 1));
}

test.afterAll(() => {
  const folder = join(import.meta.dirname, '../test-results');
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, 'figures.json'), `${JSON.stringify(figures, null, 2)}\n`);
});

test('the first page', async ({ context }) => {
  const dist = join(import.meta.dirname, '../dist');
  const asked: string[] = [];
  context.on('request', (request) => asked.push(new URL(request.url()).pathname));
  const { page } = await mock(context);
  await expect(page.getByTestId('axes')).toBeVisible();
  const files = new Set(asked.filter((path) => !path.startsWith('/api/')).map((path) => (path === '/' ? '/index.html' : path)));
  const bytes = [...files].reduce((sum, file) => sum + gzipSync(readFileSync(join(dist, file))).length, 0);
  expect(files.size).toBeGreaterThan(20);
  expect(readdirSync(dist)).toContain('vendor');
  tell('first page, kB gzip', bytes / 1000, 450, false);
});

// Playwright's own recorder would be measured besides: it copies the page at every step and reads each answer once more.
test.use({ trace: 'off' });
served.use({ trace: 'off' });

type Traced = { name: string; ph: string; ts: number; dur?: number; tdur?: number; pid: number; tid: number; args?: { name?: string; data?: { type?: string } } };

const ALL = ['devtools.timeline', 'disabled-by-default-devtools.timeline', 'toplevel', '__metadata'];
/** Tasks and messages without what they are made of: the less is written down, the less is measured besides. */
const TASKS = ['devtools.timeline', 'toplevel', '__metadata'];

/** What the main thread of the page did meanwhile, in its order. */
async function traced(page: Page, meanwhile: () => Promise<unknown>, includedCategories = ALL): Promise<Traced[]> {
  const cdp = await page.context().newCDPSession(page);
  const events: Traced[] = [];
  cdp.on('Tracing.dataCollected', ({ value }) => events.push(...(value as unknown as Traced[])));
  const complete = new Promise((resolve) => cdp.once('Tracing.tracingComplete', resolve));
  await cdp.send('Tracing.start', { traceConfig: { includedCategories } });
  await meanwhile();
  await cdp.send('Tracing.end');
  await complete;
  const main = events.find((one) => one.name === 'thread_name' && one.args?.name === 'CrRendererMain');
  return events.filter((one) => one.pid === main?.pid && one.tid === main?.tid).sort((a, b) => a.ts - b.ts);
}

/** Each piece of work of a kind. */
const pieces = async (page: Page, kind: string, meanwhile: () => Promise<unknown>): Promise<Traced[]> =>
  (await traced(page, meanwhile)).filter((one) => one.name === kind && one.ph === 'X');

/** ms of processor time, since other programs on the computer that measures are no work of the panel. */
const taken = (piece: Traced) => (piece.tdur ?? piece.dur ?? 0) / 1000;
const sorted = (times: number[]) => times.filter((ms) => ms > 0).sort((a, b) => a - b);
/** ms by the clock where figures are judged strictly: what holds up an input does so however it came about. */
const blocked = (piece: Traced) => (process.env.FIGURES === 'strict' ? (piece.dur ?? 0) / 1000 : taken(piece));

/** What the main thread did from each of these moments to the next one, ms: script, style, layout, paint, and whatever else. */
function between(events: Traced[], moments: number[]): number[] {
  const spent = moments.map(() => 0);
  let at = 0;
  for (const task of events.filter((one) => one.name === 'ThreadControllerImpl::RunTask' && one.ph === 'X')) {
    const end = task.ts + (task.dur ?? 0);
    // The task that a moment is in begins before it.
    while (at < moments.length - 1 && moments[at + 1]! <= end) at += 1;
    if (end > moments[0]!) spent[at]! += taken(task);
  }
  return spent;
}

/** What each keystroke took, with the frames that show it, to the next one; the last one has no end. */
async function keystrokes(page: Page, meanwhile: () => Promise<unknown>): Promise<number[]> {
  const events = await traced(page, meanwhile, TASKS);
  const downs = events.filter((one) => one.name === 'EventDispatch' && one.ph === 'X' && one.args?.data?.type === 'keydown').map((one) => one.ts);
  return sorted(between(events, downs).slice(0, -1));
}

const part = (times: number[], share: number) => times[Math.min(times.length - 1, Math.floor(times.length * share))] ?? 0;

served('position updates at 50 Hz', async ({ page }) => {
  // A job runs: digits, speeds, block and times change with each status.
  await enter(page);
  await load(page, 'O1234', PLATE);
  await whole(page);
  await show(page, 'position/absolute');
  await press(page, 'KEY_START');
  await stands(page, 'running');
  await page.mouse.move(5, 400);
  await page.waitForTimeout(1500);
  const events = await traced(page, () => page.waitForTimeout(8000), TASKS);
  await stands(page, 'running');
  // From one message of the socket to the next.
  const messages = events.filter((one) => one.name === 'WebSocketReceive').map((one) => one.ts);
  expect(messages.length).toBeGreaterThan(300);
  const times = sorted(between(events, messages).slice(0, -1));
  tell('a position update, ms of the main thread, half', part(times, 0.5), 2);
  tell('a position update, ms of the main thread, 99 %', part(times, 0.99), 2);
});

/** The time from the choice of a page until what it shows is there, ms. */
async function shownAfter(page: Page, hash: string, selector: string, begins = ''): Promise<number> {
  return page.evaluate(
    ([hash, selector, begins]) => {
      location.hash = hash!;
      const start = performance.now();
      return new Promise<number>((resolve) => {
        const look = () => {
          const found = document.querySelector(selector!);
          if (found && (found.textContent ?? '').startsWith(begins!)) requestAnimationFrame(() => resolve(performance.now() - start));
          else setTimeout(look, 2);
        };
        look();
      });
    },
    [hash, selector, begins],
  );
}

/** Turns the path, and tells how long that blocks at most. */
async function turned(page: Page): Promise<number> {
  const box = (await page.getByTestId('path').boundingBox())!;
  const turning = async () => {
    await page.mouse.move(box.x + 200, box.y + 200);
    await page.mouse.down();
    for (let step = 0; step < 60; step++) await page.mouse.move(box.x + 200 + 4 * step, box.y + 200 + step);
    await page.mouse.up();
    await page.waitForTimeout(1000);
  };
  const tasks = sorted((await pieces(page, 'RunTask', turning)).map(blocked));
  expect(tasks.length).toBeGreaterThan(60);
  return tasks.at(-1) ?? 0;
}

/** Types at the end of the first line and behind it. So many keys that the highest hundredth is more than the one that
    something else on the computer held up. */
async function written(page: Page): Promise<number[]> {
  await page.locator('[data-testid="editor"] .cm-content').click();
  const typed = await keystrokes(page, async () => {
    for (let index = 1; index <= 480; index++) await page.keyboard.press(index % 120 === 0 ? 'Enter' : index % 3 ? 'X' : '1');
  });
  expect(typed.length).toBe(479);
  return typed;
}

/** The panel of a machine on which nothing runs: the one before may have left a job. */
async function rest(page: Page): Promise<void> {
  await enter(page);
  await page.getByTestId('reset').click();
  await stands(page, 'idle');
}

/** 10 MB of blocks. */
const tenMB = Array.from({ length: 240_000 }, (_, index) => `N${index} G01 X${(index % 997) / 10} Y${(index % 613) / 10} Z-${index % 7} F900 (pass)`).join('\n');

/** A part of so many segments, each a block. */
const segments = (count: number) =>
  `G90 G54 G0 X0 Y0 Z0\nG1 Z-1 F900\n${Array.from({ length: count }, (_, index) => {
    const [row, along] = [Math.floor(index / 1000), index % 1000];
    return `X${((row % 2 ? 999 - along : along) / 10).toFixed(1)}Y${(row / 10 + (index % 2) / 20).toFixed(2)}`;
  }).join('\n')}\nM30\n`;

served('a path of a million segments that the server makes of a program', async ({ page }) => {
  test.setTimeout(300_000);
  await rest(page);
  await load(page, 'O7001', segments(1_000_000));
  // The page of the path itself is loaded once.
  await show(page, 'position/absolute');
  await page.reload();
  await expect(page.getByTestId('command')).toHaveText('In command');
  tell('1 M segments of a program at the server, ms to the first picture', await shownAfter(page, '#/graphics', '[data-points]:not([data-points="0"])'), 3000);
  expect(Number(await page.locator('[data-points]').getAttribute('data-points'))).toBeGreaterThan(1_000_000);
  await page.waitForTimeout(3000);
  tell('1 M segments of a program at the server, ms that turning blocks at most', await turned(page), 100);
});

served('a program of 10 MB at the server', async ({ page }) => {
  test.setTimeout(300_000);
  await rest(page);
  await load(page, 'O7002', tenMB);
  await show(page, 'program/mdi');
  await page.locator('.cm-content').first().waitFor();
  tell('10 MB program at the server, ms to open', await shownAfter(page, '#/program/edit/O7002', '[data-testid="editor"] .cm-line', 'N0 '), 500);
  await page.waitForTimeout(1500);
  const typed = await written(page);
  tell('10 MB program at the server, ms of a keystroke, half', part(typed, 0.5), 16);
  tell('10 MB program at the server, ms of a keystroke, 99 %', part(typed, 0.99), 16);
});

/** A path of so many segments, as the server sends it. */
function path(count: number): Buffer {
  const bytes = Buffer.alloc(64 + 21 * count);
  bytes.write('FCP1');
  bytes.writeUInt32LE(count, 4);
  [-100, -100, -20, 100, 100, 0].forEach((value, index) => bytes.writeDoubleLE(value, 16 + 8 * index));
  for (let index = 0; index < count; index++) {
    const row = Math.floor(index / 1000);
    const along = index % 1000;
    const x = -100 + 0.2 * (row % 2 ? 999 - along : along);
    const y = -100 + (200 * row) / (count / 1000);
    bytes.writeFloatLE(x, 64 + 12 * index);
    bytes.writeFloatLE(y, 68 + 12 * index);
    bytes.writeFloatLE(-10 + 8 * Math.sin(x / 9) * Math.cos(y / 11), 72 + 12 * index);
    bytes.writeFloatLE(index * 0.01, 64 + 12 * count + 4 * index);
    bytes.writeUInt32LE(index + 1, 64 + 16 * count + 4 * index);
    bytes.writeUInt8(index === 0 ? 0 : 2, 64 + 20 * count + index);
  }
  return bytes;
}

test('a path of a million segments', async ({ context }) => {
  test.setTimeout(180_000);
  const { page } = await mock(context, { path: path(1_000_001), moves: false });
  await expect(page.getByTestId('axes')).toBeVisible();
  tell('1 M segments, ms to the first picture', await shownAfter(page, '#/graphics', '[data-points="1000001"]'), 3000);
  await page.waitForTimeout(3000);
  tell('1 M segments, ms that turning blocks at most', await turned(page), 100);
});

test('a program of 10 MB', async ({ context }) => {
  test.setTimeout(180_000);
  const { page } = await mock(context, { program: tenMB, moves: false });
  await expect(page.getByTestId('axes')).toBeVisible();
  // The editor itself is loaded once; what is measured is the program.
  await page.evaluate(() => (location.hash = '#/program/mdi'));
  await page.locator('.cm-content').first().waitFor();
  const opened = await shownAfter(page, '#/program/edit/O0001', '[data-testid="editor"] .cm-line', 'N0 ');
  tell(`${(tenMB.length / 1e6).toFixed(1)} MB program, ms to open`, opened, 500);
  await page.waitForTimeout(1500);
  const typed = await written(page);
  tell('10 MB program, ms of a keystroke, half', part(typed, 0.5), 16);
  tell('10 MB program, ms of a keystroke, 99 %', part(typed, 0.99), 16);
});
