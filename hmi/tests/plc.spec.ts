// The ladder at the machine: exchanged while it runs, put back, its signals forced and traced.
import type { Page } from '@playwright/test';
import { expect, playDist, shoot, test } from './server';
import { enter, logIn, mode, notice, press, show, watchFaults } from './walk';

watchFaults();
// A loaded computer takes its time.
test.describe.configure({ timeout: 180_000 });

/** The lamp of the work light's key, as the panel shows it. */
const light = (page: Page) => page.locator('[data-signal="KEY_LIGHT"]');
const lit = (page: Page, on: boolean) => expect(light(page)).toHaveAttribute('aria-pressed', String(on));

async function mayChange(page: Page): Promise<void> {
  await logIn(page, 2);
  await expect(page.getByTestId('user')).toHaveText('2');
}

/** Writes something else all over the ladder's text. */
async function rewrite(page: Page, from: string, to: string): Promise<void> {
  await page.locator('[data-page="plc"]').getByRole('button', { name: 'Find and replace' }).click();
  const panel = page.locator('.cm-search');
  await panel.getByRole('textbox', { name: 'Find' }).fill(from);
  await panel.getByRole('textbox', { name: 'Replace with' }).fill(to);
  await panel.getByRole('button', { name: 'Next' }).click();
  await expect(page.locator('.cm-searchMatch-selected')).toHaveText(from);
  await panel.getByRole('button', { name: 'Replace all' }).click();
  await expect(page.locator('.cm-searchMatch')).toHaveCount(0);
  await panel.getByRole('button', { name: 'Close' }).click();
}

/** Puts what stands there in the place of the running ladder. */
async function exchange(page: Page): Promise<void> {
  await page.locator('[data-page="plc"]').getByRole('button', { name: 'Exchange' }).first().click();
  await page.getByRole('dialog').getByRole('button', { name: 'Exchange' }).click();
  await expect(page.getByRole('dialog')).toBeHidden();
}

test('the ladder is exchanged while it runs, under right, and the one before is put back', async ({ page }) => {
  await enter(page, '#/plc/edit');
  await expect(page.locator('.cm-content')).toContainText('The standard ladder');
  await lit(page, false);
  await rewrite(page, 'WRT LAMP_LIGHT', 'WRT.NOT LAMP_LIGHT');
  await exchange(page);
  await expect(notice(page)).toContainText('FC-');
  await lit(page, false);
  await mayChange(page);
  // Who logs in finds the change still there.
  await exchange(page);
  await expect(notice(page).filter({ hasText: 'The ladder is exchanged' })).toBeVisible();
  await lit(page, true);
  await press(page, 'KEY_LIGHT');
  await lit(page, false);
  await press(page, 'KEY_LIGHT');
  await lit(page, true);
  await shoot(page, 'plc-exchanged');

  // A ladder with a fault is refused, its line is shown, and the running one runs on.
  await rewrite(page, 'WRT.NOT LAMP_LIGHT', 'WRT.NOT NOBODY_KNOWS\\nRD NOR_THIS\\nWRT R400.0');
  await exchange(page);
  const fault = notice(page).filter({ hasText: 'Not exchanged: there is a fault in line' });
  await expect(fault).toContainText('gsk990mc:1012');
  await expect(fault).toContainText('The address or value is entered wrongly');
  await expect(page.locator('.cm-activeLine.cm-line')).toContainText('NOBODY_KNOWS');
  // All of its faults are listed, and lead to their lines.
  const found = page.getByTestId('findings').getByRole('button');
  await expect(found).toHaveCount(2);
  await found.nth(1).click();
  await expect(page.locator('.cm-activeLine.cm-line')).toContainText('NOR_THIS');
  await press(page, 'KEY_LIGHT');
  await lit(page, false);
  await press(page, 'KEY_LIGHT');

  await page.getByRole('button', { name: 'Put the one before back' }).click();
  await lit(page, false);
  await expect(page.locator('.cm-content')).toContainText('The standard ladder');
  await expect(found).toHaveCount(0);
  await page.getByTestId('check-ladder').click();
  await expect(notice(page).filter({ hasText: 'No fault' })).toBeVisible();
  await press(page, 'KEY_LIGHT');
  await lit(page, true);
  await press(page, 'KEY_LIGHT');
  await lit(page, false);
  // It is drawn as it runs.
  await show(page, 'plc/monitor');
  await page.getByTestId('plc-search').fill('LAMP_LIGHT');
  await expect(page.getByTestId('ladder').locator('g.output', { hasText: 'LAMP_LIGHT' })).toBeVisible();
});

test('a signal is forced under right, and released', async ({ page }) => {
  await enter(page, '#/plc');
  await page.getByTestId('plc-search').fill('LAMP_LIGHT');
  await page.getByTestId('ladder').locator('g.output', { hasText: 'LAMP_LIGHT' }).click();
  const bar = page.getByTestId('signal');
  await expect(bar).toContainText('Y21.7');
  await expect(bar).toHaveAttribute('data-value', '0');
  await bar.getByRole('button', { name: 'Force on' }).click();
  await expect(notice(page)).toContainText('FC-');
  await lit(page, false);
  await mayChange(page);
  await bar.getByRole('button', { name: 'Force on' }).click();
  await lit(page, true);
  await expect(bar).toHaveAttribute('data-value', '1');
  await shoot(page, 'plc-forced');
  // The ladder has no say while it is forced.
  await press(page, 'KEY_LIGHT');
  await lit(page, true);
  // What is forced is listed, and released there.
  const forced = page.getByTestId('forced');
  await expect(forced.locator('[data-forced]')).toHaveCount(1);
  await expect(forced.locator('[data-forced="LAMP_LIGHT"]')).toContainText('1');
  await bar.getByRole('button', { name: 'Force off' }).click();
  await lit(page, false);
  await expect(forced.locator('[data-forced="LAMP_LIGHT"]')).toContainText('0');
  await forced.getByRole('button', { name: 'Release LAMP_LIGHT' }).click();
  await expect(forced).toHaveCount(0);
  await lit(page, true);
  await press(page, 'KEY_LIGHT');
  await lit(page, false);
});

test('a message of the ladder stands on the page of alarms, also in a page that was loaded since', async ({ page }) => {
  await enter(page, '#/plc');
  await mayChange(page);
  await page.getByTestId('plc-search').fill('AIR_PRESSURE');
  await page.getByTestId('ladder').locator('g', { hasText: 'AIR_PRESSURE' }).last().click();
  const bar = page.getByTestId('signal');
  await expect(bar).toContainText('AIR_PRESSURE');
  await bar.getByRole('button', { name: 'Force off' }).click();
  const message = page.locator('[data-message="MSG_AIR"]');
  await show(page, 'alarms');
  await expect(message).toContainText('Compressed air is too low');
  await page.reload();
  await expect(message).toContainText('Compressed air is too low');
  await expect(page.locator('header .message')).toContainText('Compressed air is too low');
  await show(page, 'plc');
  await page.getByTestId('forced').getByRole('button', { name: 'Release AIR_PRESSURE' }).click();
  await show(page, 'alarms');
  await expect(message).toHaveCount(0);
});

test('a message that a ladder brought along says what the ladder remarks on it', async ({ page }) => {
  await enter(page, '#/plc/edit');
  await mayChange(page);
  await expect(page.locator('.cm-content')).toContainText('The standard ladder');
  await rewrite(page, 'MSG_AIR', 'MSG_MIST');
  await rewrite(page, 'compressed air is too low', 'no oil mist at the spindle');
  await exchange(page);
  await expect(notice(page).filter({ hasText: 'The ladder is exchanged' })).toBeVisible();
  const force = async (name: string) => {
    await show(page, 'plc/monitor');
    await page.getByTestId('plc-search').fill('AIR_PRESSURE');
    await page.getByTestId('ladder').locator('g', { hasText: 'AIR_PRESSURE' }).last().click();
    await expect(page.getByTestId('signal')).toContainText('AIR_PRESSURE');
    await page.getByTestId('signal').getByRole('button', { name }).click();
  };
  await force('Force off');
  const message = page.locator('[data-message="MSG_MIST"] h2');
  const above = page.locator('header .message');
  await show(page, 'alarms');
  await expect(message).toHaveText('no oil mist at the spindle');
  await expect(above).toContainText('no oil mist at the spindle');
  await page.reload();
  await expect(message).toHaveText('no oil mist at the spindle');
  await show(page, 'alarms/history');
  const past = page.locator('[data-page="alarms"] tbody tr', { hasText: 'FC-1446' }).first();
  await expect(past).toContainText('no oil mist at the spindle');
  // Another ladder says it otherwise.
  await show(page, 'plc/edit');
  await expect(page.locator('.cm-content')).toContainText('The standard ladder');
  await rewrite(page, 'no oil mist at the spindle', 'spindle runs dry');
  await exchange(page);
  await expect(above).toContainText('spindle runs dry');
  await show(page, 'alarms');
  await expect(message).toHaveText('spindle runs dry');
  await show(page, 'plc');
  await page.getByTestId('forced').getByRole('button', { name: 'Release AIR_PRESSURE' }).click();
  await show(page, 'alarms');
  await expect(message).toHaveCount(0);
  // The machine's own again.
  await show(page, 'plc/edit');
  await page.getByRole('button', { name: 'Put the one before back' }).click();
  await expect(page.locator('.cm-content')).toContainText('The standard ladder');
});

test('signals are traced around their trigger, and as they change', async ({ page }) => {
  await enter(page, '#/plc/trace');
  const record = page.getByTestId('trace-record');
  const samples = page.getByTestId('traced');
  await page.getByLabel('Names of signals').fill('KEY_LIGHT LAMP_LIGHT');
  await page.getByRole('radio', { name: 'On a signal' }).click();
  await page.getByLabel('Signal of the trigger').fill('KEY_LIGHT');
  await record.click();
  await expect(page.getByText('Waits for the signal')).toBeVisible();
  await press(page, 'KEY_LIGHT');
  await lit(page, true);
  // So many scans behind the trigger, and it ends by itself.
  await expect(record).toHaveText('Record', { timeout: 60_000 });
  await expect(samples).toHaveAttribute('data-samples', /^[12]\d{3}$/);
  // What stands under the pointer is told: the lamp goes on behind the trigger, from which times count.
  const over = page.locator('.u-over');
  const told = (name: string) => page.locator('.u-legend .u-series', { hasText: name }).locator('.u-value');
  const { width } = (await over.boundingBox())!;
  await over.hover({ position: { x: 0.1 * width, y: 20 } });
  await expect(told('s').first()).toContainText('-');
  await expect(told('LAMP_LIGHT')).toHaveText('0');
  await over.hover({ position: { x: 0.9 * width, y: 20 } });
  await expect(told('s').first()).not.toContainText('-');
  await expect(told('LAMP_LIGHT')).toHaveText('1');
  await expect(told('KEY_LIGHT')).toHaveText('0');
  await shoot(page, 'plc-traced');

  await press(page, 'KEY_LIGHT');
  await lit(page, false);
  await page.getByRole('radio', { name: 'At once' }).click();
  await record.click();
  for (const on of [true, false, true, false]) {
    await press(page, 'KEY_LIGHT');
    await lit(page, on);
  }
  // At least both edges of four presses.
  await expect.poll(async () => Number(await samples.getAttribute('data-samples'))).toBeGreaterThanOrEqual(8);
  await record.click();
  await expect(record).toHaveText('Record');
  // A wait for what does not come is ended by hand.
  await page.getByRole('radio', { name: 'On a signal' }).click();
  await page.getByLabel('Signal of the trigger').fill('KEY_START');
  await record.click();
  await expect(page.getByText('Waits for the signal')).toBeVisible();
  await record.click();
  await expect(record).toHaveText('Record');
  await expect(page.getByText('Waits for the signal')).toHaveCount(0);
});

test('another browser draws the ladder that was exchanged here', async ({ page, browser, baseURL }) => {
  const other = await browser.newContext(baseURL ? { baseURL } : {});
  if (process.env.PANEL === 'dist') await playDist(other);
  const watcher = await other.newPage();
  await enter(watcher, '#/plc', false);
  // A coil that is negated is drawn with a stroke.
  const drawn = watcher.getByTestId('ladder').locator('g.output', { hasText: 'LAMP_LIGHT' });
  await watcher.getByTestId('plc-search').fill('LAMP_LIGHT');
  await expect(drawn).toBeVisible();
  await expect(drawn).not.toContainText('/');
  await enter(page, '#/plc/edit');
  await mayChange(page);
  await expect(page.locator('.cm-content')).toContainText('The standard ladder');
  await rewrite(page, 'WRT LAMP_LIGHT', 'WRT.NOT LAMP_LIGHT');
  await exchange(page);
  await expect(drawn).toContainText('/');
  await page.getByRole('button', { name: 'Put the one before back' }).click();
  await expect(drawn).not.toContainText('/');
  await other.close();
});

test('the power of coils is shown to who commands and to who watches, also once the one has left', async ({ page, browser, baseURL }) => {
  const other = await browser.newContext(baseURL ? { baseURL } : {});
  if (process.env.PANEL === 'dist') await playDist(other);
  const watcher = await other.newPage();
  const coil = (of: Page) => of.getByTestId('ladder').locator('g.output', { hasText: 'LAMP_AUTO' }).first();
  await enter(watcher, '#/plc', false);
  await watcher.getByTestId('plc-search').fill('LAMP_AUTO');
  await enter(page, '#/plc');
  await page.getByTestId('plc-search').fill('LAMP_AUTO');
  await mode(page, 'KEY_AUTO', 'Automatic');
  for (const each of [page, watcher]) await expect(coil(each)).toHaveClass(/\bon\b/);
  await mode(page, 'KEY_MDI', 'Manual data input');
  for (const each of [page, watcher]) await expect(coil(each)).not.toHaveClass(/\bon\b/);
  await page.goto('/#/position');
  await mode(page, 'KEY_AUTO', 'Automatic');
  await expect(coil(watcher)).toHaveClass(/\bon\b/);
  await other.close();
});

test('what the ladder keeps is shown, and changed under right', async ({ page }) => {
  await enter(page, '#/plc/data');
  const row = (address: string) => page.locator(`[data-address="${address}"]`);
  const bit = row('K90').getByRole('switch', { name: 'K90.3' });
  await page.getByTestId('data-search').fill('K90');
  await expect(bit).toBeDisabled();
  await expect(page.getByText('Level 2 changes them')).toBeVisible();
  await mayChange(page);
  await expect(bit).toHaveAttribute('aria-checked', 'false');
  await bit.click();
  await expect(bit).toHaveAttribute('aria-checked', 'true');
  await shoot(page, 'plc-data');
  // Timers and counters are words, the first eight timers in units of 48 ms.
  await page.getByRole('radio', { name: 'T timers' }).click();
  await page.getByTestId('data-search').fill('TMR 250');
  const timer = page.getByLabel('T498 Time');
  await timer.fill('1250');
  await timer.press('Enter');
  await expect(row('T498')).toContainText('10,000 ms');
  await page.getByRole('radio', { name: 'C counters' }).click();
  await page.getByTestId('data-search').fill('CTR 100');
  const preset = page.getByLabel('C396 Preset');
  await preset.fill('777');
  await preset.press('Enter');
  await expect(preset).toHaveValue('777');
  // The data table in bytes and in numbers of four.
  await page.getByRole('radio', { name: 'D data' }).click();
  await page.getByRole('radio', { name: '4 bytes' }).click();
  await page.getByTestId('data-search').fill('D9996');
  const data = page.getByLabel('D9996 Value');
  await data.fill('70000');
  await data.press('Enter');
  await page.getByRole('radio', { name: '1 byte' }).click();
  await page.getByTestId('data-search').fill('D9997');
  await expect(page.getByLabel('D9997 Value')).toHaveValue(String((70_000 >> 8) & 255));
  // It is kept, and the log has it.
  await page.reload();
  await page.getByTestId('data-search').fill('K90');
  await expect(bit).toHaveAttribute('aria-checked', 'true');
  await show(page, 'alarms/log');
  await expect(page.getByTestId('log')).toContainText('D9996');
});

test('the ladder is told by its name, its size, its signals and its scans', async ({ page }) => {
  await enter(page, '#/plc/info');
  const fact = (name: string) => page.locator(`[data-fact="plc.info_${name}"] td`);
  await expect(fact('name')).toContainText('The standard ladder');
  await expect(fact('version')).toHaveText(/^\d+\.\d+/);
  await expect(fact('steps')).toHaveText(/^[\d,. ]{3,}$/);
  await expect(fact('scan')).toHaveText(/^[\d.]+ ms$/);
  await expect(page.locator('[data-area="X"]')).toContainText(/[1-9]\d/);
  await page.setViewportSize({ width: 800, height: 600 });
  await page.getByTestId('machine-panel').getByRole('button', { name: 'Close' }).click();
  await shoot(page, 'plc-info');
});
