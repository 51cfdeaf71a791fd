// Axes moved by hand with the handwheel on the screen: by drag, by wheel and by key.
import type { Page } from '@playwright/test';
import { expect, shoot, test } from './server';
import { enter, home, load, mode, press, stands, watchFaults, whole } from './walk';

watchFaults();
// A loaded computer takes its time.
test.describe.configure({ timeout: 180_000 });

const at = async (page: Page, axis: string) => Number((await page.locator(`[data-axis="${axis}"] .large`).textContent())?.replace('−', '-'));
const reaches = (page: Page, axis: string, place: number) => expect.poll(() => at(page, axis)).toBeCloseTo(place, 6);
/** Where an axis stands once nothing moves any more. */
async function rests(page: Page, axis: string): Promise<number> {
  let here = Number.NaN;
  await expect(async () => {
    const before = here;
    here = await at(page, axis);
    expect(here).toBeCloseTo(before, 6);
  }).toPass({ intervals: [1500] });
  return here;
}
const dial = (page: Page) => page.getByTestId('handwheel');

/** Where the dial is touched at an angle, clockwise from the right. */
async function rim(page: Page, degrees: number): Promise<[number, number]> {
  const box = (await dial(page).boundingBox())!;
  const angle = (degrees / 180) * Math.PI;
  const radius = 0.35 * box.width;
  return [box.x + box.width / 2 + radius * Math.cos(angle), box.y + box.height / 2 + radius * Math.sin(angle)];
}

/** Drags it from an angle to another, and lets it go. */
async function drag(page: Page, from: number, to: number): Promise<void> {
  await page.mouse.move(...(await rim(page, from)));
  await page.mouse.down();
  const steps = Math.ceil(Math.abs(to - from) / 6);
  for (let step = 1; step <= steps; step++) await page.mouse.move(...(await rim(page, from + ((to - from) * step) / steps)));
  await page.mouse.up();
}

/** Chooses what the wheel moves, and by how much a count. */
async function choose(page: Page, axis: string, step: string): Promise<void> {
  for (const key of [`KEY_W${axis}`, step]) {
    await press(page, key);
    await expect(page.locator(`[data-signal="${key}"]`)).toHaveClass(/chosen/);
  }
}

test('the position follows the handwheel, and nothing moves when it is let go', async ({ page }) => {
  await enter(page, '#/position');
  await stands(page, 'idle');
  await mode(page, 'KEY_MPG', 'Handwheel');
  await choose(page, 'X', 'KEY_S1');
  const [x, y] = [await at(page, 'X'), await at(page, 'Y')];
  // 3.6° are a count: 25 of them, and half of one.
  await drag(page, -90, 1.8);
  await reaches(page, 'X', x + 0.25);
  await shoot(page, 'handwheel');
  // The pointer goes on over the dial without being held: the next count shows that none came between.
  await page.mouse.move(...(await rim(page, 45)));
  await page.mouse.move(...(await rim(page, 90)));
  await dial(page).focus();
  await page.keyboard.press('ArrowUp');
  await reaches(page, 'X', x + 0.26);
  // Back over the left, where angles jump: 60 counts.
  await drag(page, -150, -367.8);
  await reaches(page, 'X', x + 0.26 - 0.6);
  await page.keyboard.press('PageUp');
  await reaches(page, 'X', x + 0.26 - 0.5);
  await page.keyboard.press('ArrowLeft');
  await reaches(page, 'X', x + 0.26 - 0.51);
  await page.mouse.move(...(await rim(page, 0)));
  await page.mouse.wheel(0, -100);
  await reaches(page, 'X', x + 0.26 - 0.5);
  await page.mouse.wheel(0, 100);
  await reaches(page, 'X', x + 0.26 - 0.51);
  await stands(page, 'idle');

  await choose(page, 'Y', 'KEY_S2');
  await dial(page).focus();
  await page.keyboard.press('ArrowDown');
  await reaches(page, 'Y', y - 0.1);
  expect(await at(page, 'X')).toBeCloseTo(x + 0.26 - 0.51, 6);

  // In another mode it is of no effect, and what was turned there is not made up for.
  await mode(page, 'KEY_JOG', 'Jog');
  await expect(dial(page)).toHaveAttribute('aria-disabled', 'true');
  await drag(page, 0, 90);
  await dial(page).focus();
  await page.keyboard.press('PageUp');
  await mode(page, 'KEY_MPG', 'Handwheel');
  await dial(page).focus();
  await page.keyboard.press('ArrowDown');
  await reaches(page, 'Y', y - 0.2);
  await stands(page, 'idle');
});

test('an axis moves by hand while its key is held, by pointer and by keyboard', async ({ page }) => {
  await enter(page, '#/position');
  await mode(page, 'KEY_JOG', 'Jog');
  const from = await at(page, 'X');
  const key = page.locator('[data-signal="KEY_X+"]');
  await key.hover();
  await page.mouse.down();
  await expect.poll(() => at(page, 'X')).toBeGreaterThan(from + 1);
  await page.mouse.up();
  await stands(page, 'idle');
  const rest = await at(page, 'X');
  await page.getByTestId('axes').click();
  await page.keyboard.down('Control');
  await page.keyboard.down('ArrowLeft');
  await expect.poll(() => at(page, 'X')).toBeLessThan(rest - 1);
  await page.keyboard.up('ArrowLeft');
  await page.keyboard.up('Control');
  await stands(page, 'idle');
  // A step is one step, however long the key is held.
  await mode(page, 'KEY_STEP', 'Step');
  await press(page, 'KEY_S3');
  await expect(page.locator('[data-signal="KEY_S3"]')).toHaveClass(/chosen/);
  const here = await at(page, 'X');
  await press(page, 'KEY_X+');
  await reaches(page, 'X', here + 1);
  await stands(page, 'idle');
  expect(await at(page, 'X')).toBeCloseTo(here + 1, 6);
  // The handwheel has no such step (GSK990MC part 2, 6.1.1): it turns by its largest.
  const fourth = page.locator('[data-signal="KEY_S3"]');
  await mode(page, 'KEY_MPG', 'Handwheel');
  await expect(page.locator('[data-signal="KEY_S2"]')).toHaveClass(/chosen/);
  await expect(fourth).not.toHaveClass(/chosen/);
  await expect(fourth).toBeDisabled();
  await mode(page, 'KEY_STEP', 'Step');
  await expect(fourth).toHaveClass(/chosen/);
  await expect(fourth).toBeEnabled();
});

test('a program runs as fast as the handwheel is turned, and stands with it', async ({ page }) => {
  await enter(page, '#/position');
  await home(page);
  await load(page, 'O0029', 'G91 G1 X-200. F1200\nM30\n');
  await page.evaluate(() => (location.hash = '#/position'));
  await whole(page);
  await press(page, 'KEY_HDRV');
  await expect(page.locator('[data-signal="KEY_HDRV"]')).toHaveAttribute('aria-pressed', 'true');
  // Without dry run the wheel drives nothing.
  await expect(dial(page)).toHaveAttribute('aria-disabled', 'true');
  await press(page, 'KEY_DRY');
  await expect(dial(page)).toHaveAttribute('aria-disabled', 'false');
  const from = await at(page, 'X');
  await press(page, 'KEY_START');
  await stands(page, 'running');
  await page.waitForTimeout(1500);
  expect(await at(page, 'X')).toBeCloseTo(from, 6);
  await dial(page).focus();
  await expect(async () => {
    await page.keyboard.press('PageUp');
    expect(await at(page, 'X')).toBeLessThan(from - 2);
  }).toPass({ intervals: [20], timeout: 60_000 });
  // What was turned is run yet; then nothing more.
  const rest = await rests(page, 'X');
  await page.waitForTimeout(1500);
  expect(await at(page, 'X')).toBeCloseTo(rest, 6);
  await stands(page, 'running');
  await page.getByTestId('reset').click();
  await stands(page, 'idle');
  await press(page, 'KEY_HDRV');
  await press(page, 'KEY_DRY');
  await expect(dial(page)).toHaveAttribute('aria-disabled', 'true');
});
