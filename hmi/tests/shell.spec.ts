// What the frame does around all pages: the log-in, the stop, what is not stored yet, a lost connection.
import { expect, test } from '@playwright/test';
import { mock, type Options } from './mock';

test('where a log-in is needed the page asks for it by itself, and again after it', async ({ context }) => {
  const { page } = await mock(context, { needsLogIn: true });
  const password = page.getByTestId('password');
  await expect(password).toBeVisible();
  await expect(page.getByTestId('gate')).toBeVisible();
  await expect(page.locator('.banner')).toHaveCount(0);
  await password.fill('head of the shop');
  await page.getByTestId('log-in-go').click();
  await expect(password).toHaveCount(0);
  await expect(page.getByTestId('mode')).toBeVisible();
  await expect(page.getByTestId('gate')).toHaveCount(0);
  await page.getByTestId('user').click();
  await page.getByTestId('log-out').click();
  await expect(password).toBeVisible();
  await expect(page.getByTestId('gate')).toBeVisible();
});

test('a session that ends with the connection is asked for again', async ({ context }) => {
  const { page, cut, session } = await mock(context, { needsLogIn: true });
  await page.getByTestId('password').fill('head of the shop');
  await page.getByTestId('log-in-go').click();
  await expect(page.getByTestId('gate')).toHaveCount(0);
  session.level = 0;
  cut();
  await expect(page.getByTestId('password')).toBeVisible();
});

test('the machine is stopped by mouse while a dialog is open', async ({ context }) => {
  const { page, sent } = await mock(context);
  await page.getByTestId('user').click();
  await page.getByTestId('log-in').click();
  await expect(page.getByTestId('password')).toBeVisible();
  const stop = page.getByTestId('dialog-emergency');
  expect((await stop.boundingBox())?.height ?? 0).toBeGreaterThanOrEqual(43.9);
  await expect(stop).not.toBeFocused();
  await stop.click();
  await expect.poll(() => sent.filter((one) => one.do === 'emergency_stop').map((one) => one.pressed)).toEqual([true]);
  await expect(page.getByTestId('password')).toBeVisible();
});

test('what is not stored stays with its program, however the next one is opened', async ({ context }) => {
  const { page } = await mock(context, { mode: 'edit' });
  const text = page.getByTestId('editor').locator('.cm-content');
  const open = async (program: string) => {
    await page.evaluate((to) => (location.hash = to), `#/program/edit/${program}`);
    await expect(page.getByTestId('editor').locator('.name')).toHaveText(program);
  };
  const write = async (what: string) => {
    await text.locator('.cm-line').first().click();
    await page.keyboard.press('End');
    await page.keyboard.type(what);
  };
  await open('O0001');
  await write('(ONE)');
  // Without leaving the tab; the mock's programs have one text.
  await open('O0002');
  await expect(text).not.toContainText('(ONE)');
  await expect(page.getByTestId('save')).toBeDisabled();
  await write('(TWO)');
  await page.evaluate(() => (location.hash = '#/position'));
  await expect(page.getByTestId('editor')).toHaveCount(0);
  await open('O0001');
  await expect(text).toContainText('(ONE)');
  await open('O0002');
  await expect(text).toContainText('(TWO)');
  await page.evaluate(() => (location.hash = '#/program/directory'));
  await expect(page.locator('[data-program="O0001"] .name i')).toHaveCount(1);
  // A page that is loaded anew asks first.
  const asked = page.waitForEvent('dialog');
  const reload = page.reload().catch(() => undefined);
  const dialog = await asked;
  expect(dialog.type()).toBe('beforeunload');
  await dialog.accept();
  await reload;
});

test('a file for DNC goes on where it was when the connection comes back', async ({ context }) => {
  const options: Options = { mode: 'dnc', isFull: true };
  let refused = 0;
  // Cut behind an answer: a part that is on its way is not said again.
  options.answered = (command) => {
    if (command.do !== 'dnc' || !options.isFull || ++refused < 3) return;
    cut();
    options.isFull = false;
  };
  const { page, sent, cut } = await mock(context, options);
  await page.evaluate(() => (location.hash = '#/program/mdi'));
  await page.evaluate(() => (location.hash = '#/program/dnc'));
  const text = Array.from({ length: 20_000 }, (_, n) => `N${n} G1 X${n}.\n`).join('');
  await page.getByTestId('dnc-file').setInputFiles({ name: 'long.nc', mimeType: 'text/plain', buffer: Buffer.from(text) });
  const parts = () => sent.filter((one) => one.do === 'dnc');
  await expect.poll(() => refused).toBe(3);
  await expect(page.getByTestId('dnc')).toHaveAttribute('data-sending', 'false');
  await expect(page.getByTestId('dnc')).toHaveAttribute('data-sent', String(text.length));
  expect(parts().slice(refused).map((one) => one.text).join('')).toBe(text);
  expect(parts().slice(refused).map((one) => [one.first, one.last])).toEqual([[true, false], [false, false], [false, true]]);
});
