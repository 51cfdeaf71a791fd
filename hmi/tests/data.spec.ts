// What the control keeps: backed up, changed, and restored as it was.
import type { Page } from '@playwright/test';
import { readFileSync } from 'node:fs';
import { expect, shoot, test } from './server';
import { enter, load, logIn, mode, notice, show, watchFaults } from './walk';

watchFaults();
// A loaded computer takes its time.
test.describe.configure({ timeout: 180_000 });

async function offset(page: Page, number: number, value: string): Promise<void> {
  await show(page, 'offsets/tools');
  const length = page.locator(`[data-offset="${number}"] input`).first();
  await length.fill(value);
  await length.press('Enter');
  await expect(length).toHaveValue(value);
}

/** Chooses these items and no others. */
async function choose(page: Page, file: string, ...names: string[]): Promise<void> {
  await show(page, 'settings/data');
  await page.getByRole('button', { name: 'None' }).click();
  for (const name of names) await page.getByRole('checkbox', { name }).click();
  await expect(page.getByRole('checkbox', { checked: true })).toHaveCount(names.length);
  await page.getByLabel('File').fill(file);
}

async function restore(page: Page): Promise<void> {
  await page.getByTestId('restore').click();
  await page.getByTestId('restore-go').click();
  await expect(page.getByRole('dialog')).toBeHidden();
}

const kept = async (page: Page, name: string) => (await (await page.request.get(`/api/programs/${name}`)).body()).toString();

test('offsets and programs are as before once they are restored', async ({ page }) => {
  await enter(page);
  const before = 'O1700 (BEFORE)\r\nG21 G90\r\nG0 X1.\r\nM30\r\n';
  await load(page, 'O1700', before);
  await offset(page, 7, '-50.125');
  await show(page, 'settings/data');
  // Where the axes stood is restored by nobody who does not ask for it.
  await expect(page.getByRole('checkbox', { checked: true })).toHaveCount(12);
  await expect(page.getByRole('checkbox', { name: 'Position' })).not.toBeChecked();
  await page.getByLabel('File').fill('played.backup');
  await page.getByTestId('back-up').click();
  await expect(notice(page).filter({ hasText: 'Written: played.backup' })).toBeVisible();
  // It is listed at once; an operator does not take it away.
  const listed = page.locator('[data-backup="played.backup"]');
  await expect(listed).toBeVisible();
  await expect(listed.getByRole('link')).toHaveCount(0);
  expect((await page.request.get('/api/backups/played.backup')).status()).toBe(409);
  await shoot(page, 'backup');

  await offset(page, 7, '-60.000');
  await offset(page, 8, '12.000');
  await load(page, 'O1700', before.replace('X1.', 'X2.'));
  expect(await kept(page, 'O1700')).toContain('X2.');

  // An operator may restore offsets, and no programs: then nothing of both.
  await choose(page, 'played.backup', 'Tool offsets', 'Programs');
  await restore(page);
  await expect(notice(page).filter({ hasText: 'FC-' })).toBeVisible();
  await show(page, 'offsets/tools');
  await expect(page.locator('[data-offset="7"] input').first()).toHaveValue('-60.000');
  expect(await kept(page, 'O1700')).toContain('X2.');
  await choose(page, 'played.backup', 'Tool offsets');
  await restore(page);
  await expect(notice(page).filter({ hasText: 'Restored from played.backup' })).toBeVisible();
  await show(page, 'offsets/tools');
  await expect(page.locator('[data-offset="7"] input').first()).toHaveValue('-50.125');
  await expect(page.locator('[data-offset="8"] input').first()).toHaveValue('0.000');
  await logIn(page, 3);
  await expect(page.getByTestId('user')).toHaveText('3');
  await choose(page, 'played.backup', 'Programs');
  await restore(page);
  await expect.poll(() => kept(page, 'O1700')).toBe(before);
  await show(page, 'settings/data');
  const coming = page.waitForEvent('download');
  await listed.getByRole('link', { name: 'Download played.backup' }).click();
  const file = await coming;
  expect(file.suggestedFilename()).toBe('played.backup');
  expect(readFileSync(await file.path(), 'utf8')).toContain('{"ferrocut-backup":1,"control":"gsk990mc"');
  // A backup that comes from elsewhere is restored as the others: brought by the button, or dropped onto the list.
  await mode(page, 'KEY_MDI', 'Manual data input');
  await offset(page, 7, '-61.000');
  await show(page, 'settings/data');
  const bytes = readFileSync(await file.path());
  await page.getByTestId('bring-backup').setInputFiles({ name: 'from elsewhere (1).backup', mimeType: 'application/octet-stream', buffer: bytes });
  await expect(notice(page).filter({ hasText: 'Uploaded: from_elsewhere__1_.backup' })).toBeVisible();
  await expect(page.locator('[data-backup="from_elsewhere__1_.backup"]')).toBeVisible();
  await choose(page, 'from_elsewhere__1_.backup', 'Tool offsets');
  await restore(page);
  await show(page, 'offsets/tools');
  await expect(page.locator('[data-offset="7"] input').first()).toHaveValue('-50.125');
  await show(page, 'settings/data');
  const drop = async (name: string, text: string) => {
    const files = await page.evaluateHandle(([name, text]) => {
      const files = new DataTransfer();
      files.items.add(new File([text!], name!));
      return files;
    }, [name, text]);
    await page.getByTestId('backup-drop').dispatchEvent('drop', { dataTransfer: files });
  };
  await drop('dropped.backup', bytes.toString());
  await expect(page.locator('[data-backup="dropped.backup"]')).toBeVisible();
  // What is none is refused in words, and leaves what has its name.
  await drop('dropped.backup', 'nothing');
  await page.getByTestId('bring-replace').click();
  await expect(notice(page).filter({ hasText: 'FC-1209' })).toBeVisible();
  expect((await (await page.request.get('/api/backups/dropped.backup')).body()).equals(bytes)).toBe(true);
  // While programs are closed none is restored (3.4.1).
  const turn = (on: boolean) => page.getByTestId('lock-all').click().then(() => expect(page.getByTestId('lock-all')).toHaveAttribute('aria-pressed', String(!on)));
  await show(page, 'program/directory');
  await turn(false);
  await choose(page, 'dropped.backup', 'Programs');
  await restore(page);
  await expect(notice(page).filter({ hasText: 'FC-1427' })).toBeVisible();
  await show(page, 'program/directory');
  await turn(true);
  await show(page, 'settings/data');
  // One of the list is chosen to be restored.
  await page.getByLabel('File').fill('');
  await listed.getByRole('button', { name: 'played.backup' }).click();
  await expect(page.getByLabel('File')).toHaveValue('played.backup');
  await show(page, 'alarms/log');
  await expect(page.getByTestId('log')).toContainText('played.backup');
  await expect(page.getByTestId('log')).toContainText('Restored');
  await expect(page.getByTestId('log')).toContainText('at 127.0.0.1');
});

test('a parameter is as before once it is restored, and a file that is none changes nothing', async ({ page }) => {
  await enter(page, '#/offsets/parameters');
  await mode(page, 'KEY_MDI', 'Manual data input');
  await logIn(page, 3);
  await expect(page.getByTestId('user')).toHaveText('3');
  await choose(page, 'delivered.backup', 'Parameters');
  await page.getByTestId('back-up').click();
  await expect(notice(page).filter({ hasText: 'Written: delivered.backup' })).toBeVisible();
  await show(page, 'offsets/parameters');
  await page.getByTestId('parameter-search').fill('P98');
  await page.locator('[data-parameter="P98"]').click();
  await page.getByTestId('parameter-switch').click();
  await page.getByTestId('accept-parameter-switch').click();
  const field = page.getByTestId('parameter').locator('input');
  const before = Number(await field.inputValue());
  await field.fill(String(before / 2));
  await field.press('Enter');
  await expect(page.locator('[data-parameter="P98"]')).toHaveClass(/differs/);
  await page.getByTestId('parameter-switch').click();
  await expect(page.getByTestId('parameter-switch')).toHaveAttribute('aria-pressed', 'false');
  const parameter = async () => {
    await show(page, 'offsets/parameters');
    await page.getByTestId('parameter-search').fill('P98');
    return page.locator('[data-parameter="P98"]');
  };
  await choose(page, 'nothing.backup', 'Parameters');
  await restore(page);
  await expect(notice(page).filter({ hasText: 'FC-' })).toBeVisible();
  await expect(await parameter()).toHaveClass(/differs/);
  await choose(page, 'delivered.backup', 'Parameters');
  await restore(page);
  await expect(notice(page).filter({ hasText: 'Restored from delivered.backup' })).toBeVisible();
  await expect(await parameter()).not.toHaveClass(/differs/);
});
