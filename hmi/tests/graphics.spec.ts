// The drawing of a part whose measures are known: views, points, distances, sections, and how far it is done.
import type { Page } from '@playwright/test';
import { expect, shoot, test } from './server';
import { bring, enter, load, mode, press, say, show, stands, watchFaults } from './walk';

watchFaults();
// A loaded computer takes its time.
test.describe.configure({ timeout: 180_000 });

/** A frame of 40 × 30 mm at Z-2 and, 20 mm beside it, a groove of 40 mm at Z-8. */
const PART = 'O1600 (KNOWN)\nG21 G90 G54 G17\nG0 X0 Y0 Z10.\nG1 Z-2. F500\nX40. F1000\nY30.\nX0\nY0\nG0 Z10.\nX60.\nG1 Z-8. F500\nX100. F1000\nG0 Z10.\nM30\n';
const LOW = [0, 0, -8] as const;
const HIGH = [100, 30, 10] as const;
type View = 'top' | 'front' | 'side' | 'turned';
/** The axes that a view has to the right and up. */
const SEEN: Record<View, [number, number]> = { top: [0, 1], front: [0, 2], side: [1, 2], turned: [2, 1] };

async function look(page: Page, view: View): Promise<void> {
  await page.locator(`[data-view="${view}"]`).click();
  await page.getByRole('button', { name: 'Show all' }).click();
}

/** Where a point of the machine is on the canvas when the whole is shown. */
async function pixel(page: Page, view: View, point: readonly [number, number, number], low: readonly number[] = LOW, high: readonly number[] = HIGH): Promise<{ x: number; y: number }> {
  const box = (await page.getByTestId('path').boundingBox())!;
  const span = Math.hypot(...high.map((most, axis) => most - low[axis]!)) * 1.15;
  const scale = Math.min(box.width, box.height) / span;
  const [right, up] = SEEN[view].map((axis) => (point[axis]! - (low[axis]! + high[axis]!) / 2) * scale) as [number, number];
  return { x: box.width / 2 + right, y: box.height / 2 - up };
}

async function pick(page: Page, view: View, point: readonly [number, number, number]): Promise<void> {
  await page.getByTestId('path').click({ position: await pixel(page, view, point) });
}

/** Whether something of the path is drawn at a point in one of the panel's shades. */
async function drawn(page: Page, view: View, point: readonly [number, number, number], shade: string): Promise<boolean> {
  return page.evaluate(
    ([{ x, y }, shade]) => {
      const canvas = document.querySelector<HTMLCanvasElement>('.view canvas:not(.above)')!;
      const copy = document.createElement('canvas');
      [copy.width, copy.height] = [1, 1];
      const context = copy.getContext('2d', { willReadFrequently: true })!;
      context.fillStyle = getComputedStyle(document.documentElement).getPropertyValue(shade);
      context.fillRect(0, 0, 1, 1);
      const [red, green, blue] = context.getImageData(0, 0, 1, 1).data;
      [copy.width, copy.height] = [canvas.width, canvas.height];
      context.drawImage(canvas, 0, 0);
      const ratio = canvas.width / canvas.clientWidth;
      const { data } = context.getImageData(Math.round(x * ratio) - 3, Math.round(y * ratio) - 3, 7, 7);
      for (let at = 0; at < data.length; at += 4) {
        if (data[at + 3]! > 200 && Math.max(Math.abs(data[at]! - red!), Math.abs(data[at + 1]! - green!), Math.abs(data[at + 2]! - blue!)) < 12) return true;
      }
      return false;
    },
    [await pixel(page, view, point), shade] as const,
  );
}

async function open(page: Page): Promise<void> {
  await enter(page);
  await load(page, 'O1600', PART);
  await page.evaluate(() => (location.hash = '#/graphics'));
  await expect(page.locator('.graphics')).toHaveAttribute('data-loaded', 'true');
}

test('where no program is selected the trail of the tool is drawn alone', async ({ page }) => {
  await enter(page);
  // The one that another test has selected goes.
  const [told] = await say(page, { do: 'status' });
  const name = (told as { program: { selected: string | null } }).program.selected;
  if (name) {
    await show(page, 'program/directory');
    await page.locator(`[data-program="${name}"]`).getByRole('button').click();
    await page.locator('.preview').getByRole('button', { name: 'Delete' }).click();
    await page.getByTestId('delete-go').click();
    await expect(page.locator(`[data-program="${name}"]`)).toHaveCount(0);
  }
  await show(page, 'graphics');
  await expect(page.locator('[data-page="graphics"]')).toContainText('No program is selected');
  await mode(page, 'KEY_JOG', 'Jog');
  await page.locator('[data-signal="KEY_Y+"]').hover();
  await page.mouse.down();
  const drawing = page.locator('.graphics');
  await expect(drawing).toHaveAttribute('data-trail', 'true');
  await page.waitForTimeout(500);
  await page.mouse.up();
  await stands(page, 'idle');
  await expect(drawing.getByTestId('time')).toHaveCount(0);
  // From the bottom to the top of the picture, or a good part of it.
  await look(page, 'top');
  const shade = () =>
    page.evaluate(() => {
      const canvas = document.querySelector<HTMLCanvasElement>('.view canvas:not(.above)')!;
      const copy = document.createElement('canvas');
      [copy.width, copy.height] = [canvas.width, canvas.height];
      const context = copy.getContext('2d', { willReadFrequently: true })!;
      context.drawImage(canvas, 0, 0);
      const { data } = context.getImageData(Math.floor(canvas.width / 2) - 3, 0, 7, canvas.height);
      const rows = new Set<number>();
      for (let at = 0; at < data.length / 4; at++) if (data[4 * at + 3]! > 200) rows.add(Math.floor(at / 7));
      return rows.size / canvas.height;
    });
  await expect.poll(shade).toBeGreaterThan(0.6);
  await page.getByTestId('erase').click();
  await expect(page.locator('[data-page="graphics"]')).toContainText('No program is selected');
});

test('points of a known part are measured in each view', async ({ page }) => {
  await open(page);
  await expect(page.locator('.facts')).toContainText('100.0 × 30.0 × 18.0 mm');
  await page.getByTestId('measure').click();
  const picked = page.getByTestId('picked');
  await look(page, 'top');
  await pick(page, 'top', [40, 30, -2]);
  await expect(picked).toContainText('Machine');
  await expect(picked).toContainText('X 40.000 Y 30.000 Z −2.000 line 6');
  await expect(picked).toContainText('Choose the second point');
  await pick(page, 'top', [100, 0, -8]);
  await expect(picked).toContainText('X 100.000 Y 0.000 Z −8.000 line 12');
  await expect(picked).toContainText('ΔX 60.000 ΔY −30.000 ΔZ −6.000');
  await expect(picked).toContainText(`${Math.hypot(60, 30, 6).toFixed(3)} mm apart`);
  await shoot(page, 'graphics-measured');
  // A third point begins anew.
  await look(page, 'front');
  await pick(page, 'front', [60, 0, -8]);
  await expect(picked).not.toContainText('apart');
  await expect(picked).toContainText('X 60.000 Y 0.000 Z −8.000 line 11');
  await pick(page, 'front', [100, 0, -8]);
  await expect(picked).toContainText('40.000 mm apart');
  await look(page, 'side');
  await pick(page, 'side', [40, 30, -2]);
  await expect(picked).toContainText('X 40.000 Y 30.000 Z −2.000 line 6');
  // Nothing is near here, and what was picked stays.
  await pick(page, 'side', [0, 15, 6]);
  await expect(picked).toContainText('Y 30.000');
  await look(page, 'turned');
  await pick(page, 'turned', [100, 0, -8]);
  await expect(picked).toContainText('Y 0.000 Z −8.000');
  // Two corners of the frame lie one behind the other.
  await pick(page, 'turned', [40, 30, -2]);
  await expect(picked).toContainText('Y 30.000 Z −2.000');
});

test('six views come one after the other', async ({ page }) => {
  await open(page);
  const next = page.getByTestId('next-view');
  await expect(page.locator('[data-view]')).toHaveText(['XY', 'YZ', 'ZY', 'XZ', 'XYZ', 'ZXY']);
  await page.locator('[data-view="top"]').click();
  const seen: string[] = [];
  const pictures = new Set<string>();
  for (let view = 0; view < 6; view++) {
    seen.push((await next.getAttribute('data-seen'))!);
    // The directions of the axes, drawn above the path at once.
    pictures.add(await page.getByTestId('path').evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL()));
    if (seen.at(-1) === 'around') await shoot(page, 'graphics-zxy');
    await next.click();
  }
  expect(seen).toEqual(['top', 'side', 'turned', 'front', 'iso', 'around']);
  expect(pictures.size).toBe(6);
  await expect(next).toHaveAttribute('data-seen', 'top');
});

test('a section shows and offers what lies at its height alone, and hidden rapids are not offered', async ({ page }) => {
  await open(page);
  await look(page, 'top');
  await expect.poll(() => drawn(page, 'top', [80, 0, -8], '--accent')).toBe(true);
  await expect.poll(() => drawn(page, 'top', [40, 15, -2], '--accent')).toBe(true);
  await page.getByTestId('section').click();
  const height = page.getByRole('slider', { name: 'Height of the section' });
  // It begins where the part is cut, not above it.
  expect(Number(await height.inputValue())).toBeLessThan(0);
  await height.fill('-2');
  await expect(page.locator('.graphics output', { hasText: 'Z −2.000' })).toBeVisible();
  await expect.poll(() => drawn(page, 'top', [80, 0, -8], '--accent')).toBe(false);
  expect(await drawn(page, 'top', [40, 15, -2], '--accent')).toBe(true);
  await shoot(page, 'graphics-section');
  const picked = page.getByTestId('picked');
  await pick(page, 'top', [40, 30, -2]);
  await expect(picked).toContainText('line 6');
  await pick(page, 'top', [100, 0, -8]);
  await expect(picked).toContainText('line 6');
  await height.fill('-8');
  await expect.poll(() => drawn(page, 'top', [80, 0, -8], '--accent')).toBe(true);
  await expect.poll(() => drawn(page, 'top', [40, 15, -2], '--accent')).toBe(false);
  await pick(page, 'top', [100, 0, -8]);
  await expect(picked).toContainText('Z −8.000 line 12');
  await page.getByTestId('section').click();

  // The corner above the groove is reached by a rapid alone.
  await look(page, 'front');
  await pick(page, 'front', [100, 0, 10]);
  await expect(picked).toContainText('Z 10.000 line 13');
  await page.getByRole('button', { name: 'Rapids' }).click();
  await pick(page, 'front', [60, 0, -8]);
  await expect(picked).toContainText('line 11');
  await pick(page, 'front', [100, 0, 10]);
  await expect(picked).toContainText('line 11');
});

test('time is moved over the path: what is done has its own shade', async ({ page }) => {
  await open(page);
  await look(page, 'top');
  const time = page.getByTestId('time');
  const end = Number(await time.getAttribute('max'));
  // 40 + 30 + 40 + 30 + 40 mm at 1000 mm/min, 12 + 18 mm at 500 mm/min, and the rapids.
  expect(end).toBeGreaterThan(10.8 + 3.6);
  expect(end).toBeLessThan(10.8 + 3.6 + 2);
  await time.fill('0');
  await expect(page.getByTestId('live')).toHaveAttribute('aria-pressed', 'false');
  await expect.poll(() => drawn(page, 'top', [40, 15, -2], '--accent')).toBe(true);
  await time.fill(String(end / 2));
  await expect.poll(() => drawn(page, 'top', [40, 15, -2], '--run')).toBe(true);
  expect(await drawn(page, 'top', [80, 0, -8], '--accent')).toBe(true);
  await time.fill(String(end));
  await expect.poll(() => drawn(page, 'top', [80, 0, -8], '--run')).toBe(true);
  await page.getByTestId('live').click();
  await expect(page.getByTestId('live')).toHaveAttribute('aria-pressed', 'true');
  await expect.poll(() => drawn(page, 'top', [80, 0, -8], '--accent')).toBe(true);
});

test('the tool and what is done go on while a subprogram of another file runs', async ({ page }) => {
  await enter(page);
  await bring(page, 'O1611', Buffer.from('O1611 (THREE SIDES)\nG91 G1 X60. F600\nY40.\nX-60.\nG90\nM99\n'));
  await load(page, 'O1610', 'O1610 (CALLS)\nG21 G90 G54 G17\nG0 X0 Y0 Z10.\nM98 P1611\nG1 X0 Y0 F1200\nM30\n');
  await show(page, 'graphics');
  const drawing = page.locator('.graphics');
  await expect(drawing).toHaveAttribute('data-loaded', 'true');
  await page.locator('[data-view="top"]').click();
  await press(page, 'KEY_START');
  await expect(page.locator('header a.program')).toContainText('O1611', { timeout: 20_000 });
  // The layer above has nothing that moves but the tool.
  const tool = () => page.getByTestId('path').evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL());
  const places = new Set<number>();
  const pictures = new Set<string>();
  let looks = 0;
  for (; looks < 200; looks++) {
    const running = await page.locator('header a.program').textContent();
    const [place, picture] = [Number(await drawing.getAttribute('data-place')), await tool()];
    if (!running?.includes('O1611')) break;
    places.add(place);
    pictures.add(picture);
    await page.waitForTimeout(100);
  }
  // Sixteen seconds of three lines: the tool is elsewhere at each look.
  expect(looks).toBeGreaterThanOrEqual(5);
  expect(pictures.size).toBeGreaterThanOrEqual(0.9 * looks);
  expect([...places].filter((place) => place > 0).length).toBeGreaterThanOrEqual(3);
  expect([...places]).toEqual([...places].sort((one, other) => one - other));
  await stands(page, 'idle', 60_000);
});

test('the range that is shown is set, kept by the browser, and taken back', async ({ page }) => {
  await open(page);
  await look(page, 'top');
  const range = async (...values: [string, string][]) => {
    await page.getByTestId('drawing').click();
    for (const [name, value] of values) {
      const field = page.getByLabel(name, { exact: true });
      await field.fill(value);
      await field.press('Enter');
      await expect(field).toHaveValue(Number(value).toFixed(3));
    }
    await page.getByRole('dialog').getByRole('button', { name: 'Close' }).last().click();
  };
  await range(['X Greatest', '50'], ['Y Least', '-10'], ['Y Greatest', '40']);
  const [low, high] = [[0, -10, -8], [50, 40, 10]];
  const picked = page.getByTestId('picked');
  const corner = async () => page.getByTestId('path').click({ position: await pixel(page, 'top', [40, 30, -2], low, high) });
  await corner();
  await expect(picked).toContainText('line 6');
  // A page that is loaded anew looks at the same.
  await page.reload();
  await expect(page.locator('.graphics')).toHaveAttribute('data-loaded', 'true');
  await look(page, 'top');
  await corner();
  await expect(picked).toContainText('X 40.000 Y 30.000 Z −2.000 line 6');
  await page.getByTestId('drawing').click();
  await page.getByTestId('whole-path').click();
  await expect(page.getByLabel('X Greatest')).toHaveValue('100.000');
  await page.getByRole('dialog').getByRole('button', { name: 'Close' }).last().click();
  await pick(page, 'top', [100, 0, -8]);
  await expect(picked).toContainText('line 12');
});

test('the scale and the centre of the drawing are set, and follow from the range again once that is set', async ({ page }) => {
  await open(page);
  const field = (name: string) => page.getByLabel(name, { exact: true });
  const close = () => page.getByRole('dialog').getByRole('button', { name: 'Close' }).last().click();
  const set = async (name: string, value: string) => {
    await field(name).fill(value);
    await field(name).press('Enter');
    await expect(field(name)).toHaveValue(Number(value).toFixed(3));
  };
  await page.getByTestId('drawing').click();
  await set('X Centre', '60');
  await set('Y Centre', '20');
  await set('Scale', '1');
  await close();
  const picked = page.getByTestId('picked');
  // 96 px are an inch.
  const corner = async () => {
    const box = (await page.getByTestId('path').boundingBox())!;
    const px = 96 / 25.4;
    await page.getByTestId('path').click({ position: { x: box.width / 2 + (100 - 60) * px, y: box.height / 2 + (20 - 0) * px } });
  };
  await look(page, 'top');
  await corner();
  await expect(picked).toContainText('line 12');
  // A page that is loaded anew looks at the same.
  await page.reload();
  await expect(page.locator('.graphics')).toHaveAttribute('data-loaded', 'true');
  await look(page, 'top');
  await corner();
  await expect(picked).toContainText('line 12');
  await page.getByTestId('drawing').click();
  await set('X Greatest', '80');
  await expect(field('X Centre')).toHaveValue('40.000');
  await expect(field('Scale')).not.toHaveValue('1.000');
  await page.getByTestId('whole-path').click();
  await expect(field('X Centre')).toHaveValue('50.000');
  await close();
});

test('what was run stays drawn until the next cycle start, or until it is erased', async ({ page }) => {
  await enter(page);
  await load(page, 'O1612', 'O1612\nG21 G90 G54 G17\nG4 X3.\nG91 G1 X10. F3000\nY10.\nX-10.\nY-10.\nM30\n');
  await show(page, 'graphics');
  const drawing = page.locator('.graphics');
  await expect(drawing).toHaveAttribute('data-loaded', 'true');
  const drawn = async () => Number(await drawing.getAttribute('data-drawn'));
  const run = async () => {
    await press(page, 'KEY_START');
    await stands(page, 'running');
  };
  await run();
  await stands(page, 'idle', 60_000);
  const all = await drawn();
  expect(all).toBeGreaterThanOrEqual(4);
  // It goes as the next one starts, which dwells first.
  await run();
  await expect.poll(drawn).toBeLessThan(all);
  await stands(page, 'idle', 60_000);
  await expect.poll(drawn).toBe(all);
  await page.getByTestId('drawing').click();
  await page.getByTestId('erases').click();
  await expect(page.getByTestId('erases')).toHaveAttribute('aria-pressed', 'false');
  await page.getByRole('dialog').getByRole('button', { name: 'Close' }).last().click();
  await run();
  await page.waitForTimeout(500);
  expect(await drawn()).toBe(all);
  await stands(page, 'idle', 60_000);
  await page.getByTestId('erase').click();
  await expect.poll(drawn).toBe(0);
});

test('in MDI and by hand the tool leaves a trail, which is stopped and erased', async ({ page }) => {
  await open(page);
  const drawing = page.locator('.graphics');
  await mode(page, 'KEY_MDI', 'Manual data input');
  const run = async (block: string) => {
    await show(page, 'program/mdi');
    await page.locator('.mdi .cm-content').click();
    await page.keyboard.press('Control+a');
    await page.keyboard.type(block);
    await page.getByTestId('mdi-send').click();
    await press(page, 'KEY_START');
    await stands(page, 'idle');
    await show(page, 'graphics');
    await expect(drawing).toHaveAttribute('data-loaded', 'true');
    await look(page, 'top');
  };
  const leaves = (point: readonly [number, number, number]) => drawn(page, 'top', point, '--muted');
  await look(page, 'top');
  expect(await leaves([45, 15, 0])).toBe(false);
  await run('G90 G54 G1 Y15. F6000');
  await run('G90 G54 G1 X70. F6000');
  await expect.poll(() => leaves([45, 15, 0])).toBe(true);
  await shoot(page, 'graphics-trail');
  // Stopped: what is there stays, and nothing is added.
  await page.getByTestId('trail').click();
  await expect(page.getByTestId('trail')).toHaveAttribute('aria-pressed', 'false');
  await page.getByTestId('drawing').click();
  await page.getByTestId('erases').click();
  await page.getByRole('dialog').getByRole('button', { name: 'Close' }).last().click();
  await run('G90 G54 G1 Y25. F6000');
  expect(await leaves([70, 21, 0])).toBe(false);
  expect(await leaves([45, 15, 0])).toBe(true);
  await page.getByTestId('erase').click();
  await expect.poll(() => leaves([45, 15, 0])).toBe(false);
  // By hand, on from here.
  await page.getByTestId('trail').click();
  await mode(page, 'KEY_JOG', 'Jog');
  await page.locator('[data-signal="KEY_X-"]').hover();
  await page.mouse.down();
  await expect.poll(() => leaves([68, 25, 0]), { timeout: 30_000 }).toBe(true);
  await page.mouse.up();
});
