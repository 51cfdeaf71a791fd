// The setting page of the GSK990MC (part 2, 3.4.1), and what its switches do elsewhere.
import type { Page } from '@playwright/test';
import { expect, shoot, test } from './server';
import { activity, bring, enter, load, logIn, mode, notice, press, show, stands, watchFaults } from './walk';

watchFaults();
// A loaded computer takes its time.
test.describe.configure({ timeout: 180_000 });

const setting = (page: Page, name: string) => page.locator(`[data-setting="${name}"]`);
const kept = async (page: Page, name: string) => (await (await page.request.get(`/api/programs/${name}`)).body()).toString();

async function inMdi(page: Page): Promise<void> {
  await mode(page, 'KEY_MDI', 'Manual data input');
  await show(page, 'settings/general');
}

test('the program switch closes all programs, and opens them again', async ({ page }) => {
  await enter(page);
  const text = 'O1800 (CLOSED)\nG0 X1.\nM30\n';
  await bring(page, 'O1800', Buffer.from(text));
  await mode(page, 'KEY_AUTO', 'Automatic');
  await show(page, 'settings/general');
  await expect(setting(page, 'NO54.6').getByRole('radio', { name: 'On' })).toBeDisabled();
  await inMdi(page);
  // An operator may not turn it.
  await setting(page, 'NO54.6').getByRole('radio', { name: 'Off' }).click();
  await expect(notice(page).filter({ hasText: 'FC-1213' })).toBeVisible();
  await expect(setting(page, 'NO54.6')).toHaveAttribute('data-value', '1');
  await logIn(page, 4);
  await expect(page.getByTestId('user')).toHaveText('4');
  await setting(page, 'NO54.6').getByRole('radio', { name: 'Off' }).click();
  await expect(setting(page, 'NO54.6')).toHaveAttribute('data-value', '0');
  await shoot(page, 'settings');
  await show(page, 'position/absolute');
  await expect(page.getByText('Programs locked')).toBeVisible();
  // The editor says so, the directory too, and the control refuses what comes all the same.
  await show(page, 'program/edit/O1800');
  await expect(page.getByTestId('closed')).toHaveText('Programs are locked');
  await page.locator('.cm-line', { hasText: 'G0 X1.' }).click();
  await page.keyboard.press('End');
  await page.keyboard.type('5');
  await expect(page.getByTestId('save')).toBeDisabled();
  await page.keyboard.press('Control+s');
  await expect(notice(page).filter({ hasText: 'FC-1427' })).toBeVisible();
  expect(await kept(page, 'O1800')).toBe(text);
  const put = await page.request.put('/api/programs/O1800', { data: 'M30\n' });
  expect([put.status(), (await put.json()).refused.alarm.id]).toEqual([409, 'FC-1427']);
  await show(page, 'program/directory');
  await page.locator('[data-program="O1800"]').getByRole('button').click();
  await page.getByRole('button', { name: 'Delete', exact: true }).click();
  await page.getByTestId('delete-go').click();
  await expect(page.locator('[data-program="O1800"]')).toBeVisible();
  expect(await kept(page, 'O1800')).toBe(text);
  // The key of the directory opens them.
  const all = page.getByTestId('lock-all');
  await expect(all).toHaveAttribute('aria-pressed', 'true');
  await all.click();
  await expect(all).toHaveAttribute('aria-pressed', 'false');
  await show(page, 'program/edit/O1800');
  await expect(page.getByTestId('closed')).toHaveCount(0);
  await page.getByTestId('save').click();
  await expect.poll(() => kept(page, 'O1800')).toBe(text.replace('X1.', 'X1.5'));
});

test('one program is locked against those of lower right', async ({ page }) => {
  await enter(page);
  await bring(page, 'O1801', Buffer.from('O1801 (LOCKED)\nM30\n'));
  await page.locator('[data-program="O1801"]').getByRole('button').click();
  const lock = page.getByTestId('lock');
  await lock.click();
  await expect(notice(page).filter({ hasText: 'FC-1213' })).toBeVisible();
  await logIn(page, 4);
  await expect(page.getByTestId('user')).toHaveText('4');
  await lock.click();
  await expect(lock).toHaveAttribute('aria-pressed', 'true');
  await expect(lock).toHaveText('Unlock');
  await shoot(page, 'directory-locked');
  await page.getByTestId('user').click();
  await page.getByTestId('log-out').click();
  await expect(page.getByTestId('user')).not.toHaveText('4');
  // The browser that logs out connects anew.
  await expect(async () => {
    const command = page.getByTestId('command');
    if ((await command.textContent())?.includes('Take')) await command.click();
    await expect(command).toHaveText('In command', { timeout: 2000 });
  }).toPass();
  const put = await page.request.put('/api/programs/O1801', { data: 'M30\n' });
  expect(put.status()).toBe(409);
  expect(await kept(page, 'O1801')).toContain('LOCKED');
});

test('the input unit, the channel, sequence numbers and the clock are set and shown', async ({ page }) => {
  await enter(page);
  await inMdi(page);
  // The computer of the control is this one.
  await expect(page.getByTestId('clock')).toHaveAttribute('datetime', /^\d{4}-/);
  const clock = await page.getByTestId('clock').getAttribute('datetime');
  expect(Math.abs(Date.parse(clock!) - Date.now())).toBeLessThan(10_000);
  await logIn(page, 3);
  await expect(page.getByTestId('user')).toHaveText('3');
  await expect(setting(page, 'NO0.2')).toHaveAttribute('data-value', '0');
  await setting(page, 'NO0.2').getByRole('radio', { name: 'Inch' }).click();
  await expect(setting(page, 'NO0.2')).toHaveAttribute('data-value', '1');
  await show(page, 'position/absolute');
  await expect(page.getByText('G20', { exact: true })).toBeVisible();
  // Places and what is typed remain millimetres.
  await expect(page.locator('.axes h2')).toContainText('mm');
  await show(page, 'settings/general');
  await expect(page.getByTestId('switches')).toContainText('in mm all the same');
  await setting(page, 'NO0.2').getByRole('radio', { name: 'Metric' }).click();
  await expect(setting(page, 'NO0.2')).toHaveAttribute('data-value', '0');
  await setting(page, 'P0').getByRole('radio', { name: 'RS232 XModem' }).click();
  await expect(setting(page, 'P0')).toHaveAttribute('data-value', '1');
  await expect(page.getByTestId('switches')).toContainText('files come over the network');
  // Numbers are inserted as blocks are typed.
  await setting(page, 'NO0.5').getByRole('radio', { name: 'On' }).click();
  await expect(setting(page, 'NO0.5')).toHaveAttribute('data-value', '1');
  const step = setting(page, 'P210').locator('input');
  await step.fill('5');
  await step.press('Enter');
  await expect(step).toHaveValue('5');
  await bring(page, 'O1802', Buffer.from('O1802\nN10 G21 G90'));
  await show(page, 'program/edit/O1802');
  await page.locator('.cm-line', { hasText: 'N10' }).click();
  await page.keyboard.press('Control+End');
  await page.keyboard.press('Enter');
  await page.keyboard.type('G0 X1.');
  await page.keyboard.press('Enter');
  await page.keyboard.type('M30');
  await page.getByTestId('save').click();
  await expect.poll(() => kept(page, 'O1802')).toBe('O1802\nN10 G21 G90\nN15 G0 X1.\nN20 M30');
  await show(page, 'settings/general');
  await setting(page, 'NO0.5').getByRole('radio', { name: 'Off' }).click();
  await expect(setting(page, 'NO0.5')).toHaveAttribute('data-value', '0');
});

test('a program stops once behind a sequence number, and what comes next is told across a call', async ({ page }) => {
  await enter(page);
  await bring(page, 'O1804', Buffer.from('O1804\nN1 G4 P1.\nM99\n'));
  await load(page, 'O1803', 'O1803\nN10 G4 P0.2\nM98 P1804\nN30 G4 P0.2\nM30\n');
  await show(page, 'settings/general');
  await page.getByTestId('stop-program').fill('O1803');
  await page.getByLabel('Stop behind program and N').fill('10');
  await page.getByLabel('Stop behind program and N').press('Enter');
  await expect(page.getByTestId('stop')).toHaveText('O1803 N10');
  await press(page, 'KEY_START');
  await stands(page, 'block_end');
  await expect(page.getByTestId('stop')).toHaveText('–');
  await show(page, 'program/run');
  await expect(page.getByTestId('block')).toContainText('N10 G4 P0.2');
  await expect(page.getByTestId('next')).toContainText('M98 P1804');
  await expect(page.getByTestId('behind')).toContainText('O1804:2');
  await expect(page.getByTestId('behind')).toContainText('N1 G4 P1.');
  await shoot(page, 'program-next');
  await press(page, 'KEY_START');
  await expect(activity(page)).toHaveAttribute('data-activity', 'idle', { timeout: 20_000 });
});

test('machine zero is set where axes stand, by those who may and after a question', async ({ page }) => {
  await enter(page);
  await mode(page, 'KEY_JOG', 'Jog');
  await show(page, 'settings/machine_zero');
  const set = page.getByTestId('set-machine-zero');
  const row = (axis: string) => page.getByTestId('machine-zero').locator(`[data-axis="${axis}"]`);
  await row('X').getByRole('button').click();
  await row('Y').getByRole('button').click();
  await expect(page.locator('[data-need]')).toHaveCount(3);
  await expect(set).toBeDisabled();
  await mode(page, 'KEY_MDI', 'Manual data input');
  await logIn(page, 3);
  await expect(page.getByTestId('user')).toHaveText('3');
  await page.getByTestId('parameter-switch').click();
  await page.getByTestId('accept-parameter-switch').click();
  await expect(page.locator('[data-need]')).toHaveCount(0);
  await page.setViewportSize({ width: 800, height: 600 });
  await shoot(page, 'machine-zero');
  await set.click();
  await expect(page.getByRole('dialog')).toContainText('X Y');
  await page.getByTestId('set-machine-zero-go').click();
  await expect(notice(page).filter({ hasText: 'Machine zero is set: X Y' })).toBeVisible();
  // It stands on its reference point, wherever it was.
  await expect(row('X')).toContainText(/0\.000\s*0\.000\s*Yes/);
  await show(page, 'alarms/log');
  await expect(page.getByTestId('log')).toContainText('Machine zero set, X');
  await page.getByTestId('user').click();
  await page.getByTestId('log-out').click();
});
