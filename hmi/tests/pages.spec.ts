// Pages beside the great walk: MDI, background editing, the directory, relative positions, offsets, variables, help.
import type { Page } from '@playwright/test';
import { expect, shoot, test } from './server';
import { bring, enter, home, load, mode, notice, press, show, stands, watchFaults, x } from './walk';

watchFaults();
// A loaded computer takes its time.
test.describe.configure({ timeout: 240_000 });

const kept = async (page: Page, name: string) => (await (await page.request.get(`/api/programs/${name}`)).body()).toString();
const small = (page: Page, axis: string) => page.locator(`[data-axis="${axis}"] .machine`);

test('blocks that are typed in MDI are run, one alone before the others', async ({ page }) => {
  await enter(page, '#/position');
  await home(page);
  await mode(page, 'KEY_MDI', 'Manual data input');
  await show(page, 'program/mdi');
  await page.locator('.mdi .cm-content').click();
  // What another has typed before is still there.
  await page.keyboard.press('Control+a');
  await page.keyboard.type('G90 G54 G0 X5.');
  await page.keyboard.press('Enter');
  await page.keyboard.type('#500=2.5*2');
  await page.getByTestId('mdi-send').click();
  await expect(page.locator('.past').first()).toContainText('#500=2.5*2');
  // What is in force stands beside it.
  await expect(page.locator('.mdi')).toContainText('G90');
  await expect(page.getByTestId('mdi-values')).toHaveText(/^F\d+ S\d+ T\d+ H\d+ D\d+$/);
  await shoot(page, 'mdi');
  await press(page, 'KEY_START');
  await show(page, 'position/absolute');
  await expect.poll(() => x(page)).toBe(5);
  await stands(page, 'idle');
  // One block, once; then the blocks are still there.
  await show(page, 'program/mdi');
  await page.getByLabel('One block').fill('G0 X7.5');
  await page.getByLabel('One block').press('Enter');
  await expect(page.locator('.past').first()).toHaveText('G0 X7.5');
  await press(page, 'KEY_START');
  await show(page, 'position/absolute');
  await expect.poll(() => x(page)).toBe(7.5);
  await stands(page, 'idle');
  await show(page, 'offsets/variables');
  await page.getByRole('radio', { name: '#500–#999' }).click();
  await expect(page.getByLabel('#500', { exact: true })).toHaveValue('5.0000');
});

test('MDI shows what cycle start runs, and starts nothing else', async ({ page }) => {
  await enter(page, '#/position');
  await home(page);
  await mode(page, 'KEY_MDI', 'Manual data input');
  await show(page, 'program/mdi');
  const text = page.locator('.mdi .cm-content');
  const state = page.getByTestId('mdi-state');
  const start = page.locator('.mdi [data-signal="KEY_START"]');
  const write = async (blocks: string) => {
    await text.click();
    await page.keyboard.press('Control+A');
    await page.keyboard.type(blocks);
  };
  await write('G90 G54 G0 X6.');
  await expect(state).toContainText('Not sent');
  await expect(start).toBeDisabled();
  // What is not sent is still there behind another page.
  await show(page, 'position/absolute');
  await show(page, 'program/mdi');
  await expect(text).toHaveText('G90 G54 G0 X6.');
  await expect(state).toContainText('Not sent');
  await page.getByTestId('mdi-send').click();
  await expect(state).toHaveText('Cycle start runs these blocks');
  await expect(start).toBeEnabled();
  // What was sent is the control's, whoever looks at it.
  await page.reload();
  await expect(page.getByTestId('command')).toHaveText('In command');
  await expect(text).toHaveText('G90 G54 G0 X6.');
  await expect(start).toBeEnabled();
  await write('G0 X8.');
  await expect(start).toBeDisabled();
  await shoot(page, 'mdi-unsent');
  // So it is behind each page, by the key of the bar and by F10, and after a reload.
  const bar = page.locator('.app > footer [data-signal="KEY_START"]');
  for (const reloaded of [false, true]) {
    if (reloaded) {
      await page.reload();
      await expect(page.getByTestId('command')).toHaveText('In command');
      await expect(text).toHaveText('G0 X8.');
      await expect(state).toContainText('Not sent');
      await expect(start).toBeDisabled();
    }
    await show(page, 'position/absolute');
    await expect(bar).toBeDisabled();
    await expect(bar).toHaveText('Not sent');
    await page.keyboard.press('F10');
    await expect(notice(page).filter({ hasText: 'what was typed in MDI is not sent' })).toBeVisible();
    await stands(page, 'idle');
    // Other modes run other things.
    await mode(page, 'KEY_AUTO', 'Automatic');
    await expect(bar).toBeEnabled();
    await expect(bar).toHaveText('Start');
    await mode(page, 'KEY_MDI', 'Manual data input');
    await show(page, 'program/mdi');
  }
  await page.getByTestId('mdi-take-back').click();
  await expect(text).toHaveText('G90 G54 G0 X6.');
  await expect(start).toBeEnabled();
  await expect(bar).toBeEnabled();
  // The block that waits is told, and can be taken back.
  await page.getByLabel('One block').fill('G0 X8.');
  await expect(start).toBeDisabled();
  await page.reload();
  await expect(page.getByTestId('command')).toHaveText('In command');
  await expect(page.getByLabel('One block')).toHaveValue('G0 X8.');
  await expect(bar).toBeDisabled();
  await page.getByLabel('One block').press('Enter');
  await expect(state).toHaveText('Cycle start runs G0 X8. first');
  await page.reload();
  await expect(page.getByTestId('command')).toHaveText('In command');
  await expect(state).toHaveText('Cycle start runs G0 X8. first');
  await page.getByLabel('Do not run this block').click();
  await expect(state).toHaveText('Cycle start runs these blocks');
  await start.hover();
  await page.mouse.down();
  await expect(start).toHaveAttribute('data-held');
  await page.mouse.up();
  await show(page, 'position/absolute');
  await expect.poll(() => x(page)).toBe(6);
  await stands(page, 'idle');
});

test('a program of DNC runs while the server gives it', async ({ page }) => {
  test.setTimeout(480_000);
  await enter(page, '#/position');
  await home(page);
  await mode(page, 'KEY_DNC', 'DNC');
  await show(page, 'program/dnc');
  // Longer than what the control keeps: it comes to its end only while it runs.
  const remark = `(${'SOME WORDS THAT MAKE THE PROGRAM LONG '.repeat(22)})`;
  const pass = `G0 X1. ${remark}\nX1.01 ${remark}\n`;
  const text = `G90 G54\n${pass.repeat(Math.ceil(1_250_000 / pass.length))}G0 X3.25\nM30\n`;
  await page.getByTestId('dnc-file').setInputFiles({ name: 'long.nc', mimeType: 'text/plain', buffer: Buffer.from(text) });
  const told = page.getByTestId('dnc');
  await expect.poll(async () => Number(await told.getAttribute('data-sent'))).toBeGreaterThan(900_000);
  await expect(told).toHaveAttribute('data-sending', 'true');
  await press(page, 'KEY_START');
  await stands(page, 'running');
  await shoot(page, 'dnc');
  // Whoever looks at another page meanwhile does not stop it.
  await show(page, 'position/absolute');
  await expect.poll(() => x(page), { timeout: 240_000 }).toBe(3.25);
  await stands(page, 'idle', 60_000);
  await show(page, 'program/dnc');
  await expect(told).toHaveAttribute('data-sent', String(text.length));
  await expect(told).toHaveAttribute('data-sending', 'false');
  // A short one is whole before the start, and runs again.
  await page.getByTestId('dnc-file').setInputFiles({ name: 'short.nc', mimeType: 'text/plain', buffer: Buffer.from('G91 G0 X1.\nM30\n') });
  await expect(told).toHaveAttribute('data-sending', 'false');
  await expect(told).toContainText('short.nc');
  for (const place of [4.25, 5.25]) {
    await press(page, 'KEY_START');
    await show(page, 'position/absolute');
    await expect.poll(() => x(page)).toBe(place);
    await stands(page, 'idle');
  }
});

test('relative coordinates are set to zero, to half and to a value, and nothing moves', async ({ page }) => {
  await enter(page, '#/position/relative');
  const machine = await small(page, 'X').textContent();
  const field = page.getByLabel('Relative coordinate X');
  await field.fill('25');
  await field.press('Enter');
  await expect.poll(() => x(page)).toBe(25);
  await page.getByRole('button', { name: 'X / 2' }).click();
  await expect.poll(() => x(page)).toBe(12.5);
  await page.getByTestId('zero-X').click();
  await expect.poll(() => x(page)).toBe(0);
  expect(await small(page, 'X').textContent()).toBe(machine);
  // By the same keys beside all coordinates.
  await show(page, 'position/all');
  const cell = (kind: string) => page.locator('[data-axis="X"]').getByRole('cell').nth(kind === 'relative' ? 1 : 2);
  await field.fill('-9');
  await field.press('Enter');
  await expect(cell('relative')).toHaveText('−9.000');
  await page.getByRole('button', { name: 'X / 2' }).click();
  await expect(cell('relative')).toHaveText('−4.500');
  await page.getByTestId('zero-X').click();
  await expect(cell('relative')).toHaveText('0.000');
  await expect(cell('machine')).toHaveText(machine!);
  await shoot(page, 'position-all-relative');
});

test('a long position is drawn with its sign and all its digits, on a small screen too', async ({ page }) => {
  await enter(page, '#/position/relative');
  // Beside the page, not over it.
  await page.setViewportSize({ width: 800, height: 600 });
  const panel = page.getByTestId('panel-toggle');
  if ((await panel.getAttribute('aria-pressed')) === 'true') await panel.click();
  const field = page.getByLabel('Relative coordinate X');
  await field.fill('123456');
  await expect(field).toHaveAccessibleDescription('−99999.999 … 99999.999');
  await field.fill('-12345.678');
  await field.press('Enter');
  await expect.poll(() => x(page)).toBe(-12345.678);
  await page.waitForTimeout(500);
  await shoot(page, 'position-long');
  // What is drawn at the very left is the sign: flat, and not cut off.
  const first = await page.locator('[data-axis="X"] canvas').evaluate((drawn) => {
    const canvas = drawn as HTMLCanvasElement;
    const { width, height } = canvas;
    const copy = Object.assign(document.createElement('canvas'), { width, height }).getContext('2d')!;
    copy.drawImage(canvas, 0, 0);
    const { data } = copy.getImageData(0, 0, width, height);
    const inked = (column: number) => Array.from({ length: height }, (_, row) => row).filter((row) => data[(row * width + column) * 4 + 3]! > 100);
    const columns = Array.from({ length: width }, (_, column) => inked(column));
    const left = columns.findIndex((rows) => rows.length > 0);
    return { left, high: columns[left + 2]!.length / height };
  });
  expect(first.left).toBeGreaterThan(0);
  expect(first.high).toBeGreaterThan(0);
  expect(first.high).toBeLessThan(0.25);
  await page.getByTestId('zero-X').click();
  await expect.poll(() => x(page)).toBe(0);
});

test('a program is edited beside the one that runs, which is kept from change', async ({ page }) => {
  await enter(page, '#/position');
  const long = 'O1801 (LONG)\nG21 G90 G54\nG4 X600.\nM30\n';
  await bring(page, 'O1802', Buffer.from('O1802 (BESIDE)\nG0 X1.\nM30\n'));
  await load(page, 'O1801', long);
  await press(page, 'KEY_START');
  await stands(page, 'running');
  await show(page, 'program/edit/O1802');
  await expect(page.getByText('Background edit')).toBeVisible();
  await page.locator('.cm-line', { hasText: 'G0 X1.' }).click();
  await page.keyboard.press('End');
  await page.keyboard.type(' Y2.');
  await page.getByTestId('save').click();
  await expect(page.getByTestId('save')).toBeDisabled();
  expect(await kept(page, 'O1802')).toBe('O1802 (BESIDE)\nG0 X1. Y2.\nM30\n');
  await stands(page, 'running');
  await show(page, 'program/edit/O1801');
  await expect(page.getByText('Under way: cannot be stored now')).toBeVisible();
  await page.locator('.cm-line', { hasText: 'G4 X600.' }).click();
  await page.keyboard.press('End');
  await page.keyboard.type(' (WAIT)');
  await page.getByTestId('save').click();
  await expect(notice(page).filter({ hasText: 'FC-' })).toBeVisible();
  expect(await kept(page, 'O1801')).toBe(long);
  await shoot(page, 'edit-background');
  // What was written is there when the run has ended.
  await page.getByTestId('reset').click();
  await stands(page, 'idle');
  await page.getByTestId('save').click();
  await expect(page.getByTestId('save')).toBeDisabled();
  expect(await kept(page, 'O1801')).toContain('(WAIT)');
});

test('programs are dropped, replaced only when asked, copied, renamed, downloaded and deleted', async ({ page }) => {
  await enter(page);
  const text = 'O1810 (DROPPED)\r\nG0 X1.\r\nM30\r\n';
  await show(page, 'program/directory');
  const row = (name: string) => page.locator(`[data-program="${name}"]`);
  const drop = (content: string) =>
    page.getByTestId('directory').evaluate((onto, content) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([content], 'dropped.nc'));
      for (const type of ['dragover', 'drop']) onto.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
    }, content);
  await drop(text);
  await expect(row('O1810')).toContainText('DROPPED');
  expect(await kept(page, 'O1810')).toBe(text);
  await drop(text.replace('X1.', 'X9.'));
  await expect(page.getByRole('dialog')).toContainText('O1810');
  await page.getByRole('dialog').getByRole('button', { name: 'Cancel' }).click();
  expect(await kept(page, 'O1810')).toBe(text);
  await drop(text.replace('X1.', 'X9.'));
  await page.getByTestId('replace').click();
  await expect.poll(() => kept(page, 'O1810')).toBe(text.replace('X1.', 'X9.'));
  await expect(page.locator('.preview .cm-content')).toContainText('X9.');

  // Dragged out of the list, a row is a file for whoever takes it, such as the desktop.
  await page.evaluate(() => {
    addEventListener('dragover', (event) => event.preventDefault());
    const told = document.body.dataset;
    // Where it is dropped a page is not told what browsers make a file of.
    addEventListener('dragstart', ({ dataTransfer }) => (told.file = dataTransfer?.getData('DownloadURL')));
    addEventListener('drop', ({ dataTransfer }) => (told.link = dataTransfer?.getData('text/uri-list')));
  });
  await row('O1810').dragTo(page.locator('.app > header'));
  const told = (name: string) => page.locator('body').getAttribute(`data-${name}`);
  await expect.poll(() => told('link')).toBeTruthy();
  const [file, link] = [await told('file'), await told('link')];
  const [type, called, ...address] = file!.split(':');
  expect([type, called, address.join(':')]).toEqual(['text/plain', 'O1810.nc', link]);
  const given = await page.request.get(link!);
  expect([(await given.body()).toString(), given.headers()['content-disposition']]).toEqual([text.replace('X1.', 'X9.'), expect.stringContaining('attachment')]);

  const name = page.getByTestId('new-name');
  await row('O1810').getByRole('button').click();
  await page.getByTestId('copy').click();
  // A name that is taken is not taken from its program.
  await expect(page.getByTestId('name-go')).toBeDisabled();
  await name.fill('O1811');
  await page.getByTestId('name-go').click();
  await expect(row('O1811')).toBeVisible();
  expect(await kept(page, 'O1811')).toBe(text.replace('X1.', 'X9.').replace('O1810', 'O1811'));
  await page.getByTestId('rename').click();
  await name.fill('O1812');
  await page.getByTestId('name-go').click();
  await expect(row('O1812')).toBeVisible();
  await expect(row('O1811')).toHaveCount(0);
  await expect(row('O1810')).toBeVisible();
  await page.getByRole('button', { name: 'New' }).click();
  await name.fill('O1812');
  await expect(page.getByRole('dialog')).toContainText('This name is taken');
  await expect(page.getByTestId('name-go')).toBeDisabled();
  await page.getByRole('dialog').getByRole('button', { name: 'Cancel' }).click();

  await row('O1812').getByRole('button').click();
  const download = page.waitForEvent('download');
  await page.locator('a.download').click();
  const stream = await (await download).createReadStream();
  const parts: Buffer[] = [];
  for await (const part of stream) parts.push(part as Buffer);
  expect(Buffer.concat(parts).toString()).toBe(await kept(page, 'O1812'));
  await shoot(page, 'directory');

  await page.locator('.preview').getByRole('button', { name: 'Delete' }).click();
  await page.getByTestId('delete-go').click();
  await expect(row('O1812')).toHaveCount(0);
  await expect(row('O1810')).toBeVisible();
  // All of them only behind a question.
  await page.getByTestId('delete-all').click();
  await expect(page.getByTestId('delete-all-go')).toBeVisible();
  await page.getByRole('button', { name: 'Cancel' }).click();
  await expect(page.getByTestId('delete-all-go')).toBeHidden();
  await expect(row('O1810')).toBeVisible();
});

test('a new program begins without an error whatever it is called, and what is no name is refused', async ({ page }) => {
  await enter(page, '#/program/directory');
  await expect(page.getByTestId('directory')).toHaveAttribute('data-loaded', 'true');
  await page.getByTestId('new').click();
  const name = page.getByTestId('new-name');
  for (const [text, why] of [['O123456789', 'at most eight digits'], ['../x', 'letters, digits, - and _ alone'], ['a b', 'letters, digits, - and _ alone']] as const) {
    await name.fill(text);
    await expect(page.getByRole('dialog')).toContainText(why);
    await expect(page.getByTestId('name-go')).toBeDisabled();
  }
  await name.fill('bracket-9');
  await page.getByTestId('name-go').click();
  await expect(page.getByTestId('editor').locator('.name')).toHaveText('bracket-9');
  await expect(page.locator('.cm-content')).toContainText('M30');
  expect(await kept(page, 'bracket-9')).toBe('\nM30\n');
  await page.waitForTimeout(1500);
  await expect(page.locator('.cm-lintRange, .cm-lint-marker')).toHaveCount(0);
  await show(page, 'program/directory');
  await page.locator('[data-program="bracket-9"]').getByRole('button').click();
  await page.locator('.preview').getByRole('button', { name: 'Delete' }).click();
  await page.getByTestId('delete-go').click();
  await expect(page.locator('[data-program="bracket-9"]')).toHaveCount(0);
});

test('wear is added to, and a length is measured from relative Z', async ({ page }) => {
  await enter(page, '#/offsets/tools');
  const wear = page.getByLabel('9 Wear H', { exact: true });
  await page.getByRole('button', { name: 'Add to what is there' }).click();
  for (const sum of ['-0.050', '-0.100']) {
    await wear.fill('-0.05');
    await wear.press('Enter');
    await expect(wear).toHaveValue(sum);
  }
  await page.getByRole('button', { name: 'Add to what is there' }).click();
  await show(page, 'position/relative');
  await page.getByLabel('Relative coordinate Z').fill('-33.5');
  await page.getByLabel('Relative coordinate Z').press('Enter');
  await expect(page.locator('[data-axis="Z"] .large')).toHaveText('−33.500');
  await show(page, 'offsets/tools');
  await page.getByRole('button', { name: 'Length 9 from relative Z' }).click();
  await expect(page.getByLabel('9 Length H', { exact: true })).toHaveValue('-33.500');
  // A tool that is measured has no wear.
  await expect(wear).toHaveValue('0.000');
  await expect(page.locator('[data-offset="9"] .muted')).toHaveText('−33.500');
  // What is typed behind its letter is added to it.
  const length = page.getByLabel('8 Length H', { exact: true });
  await length.fill('Z10');
  await length.press('Enter');
  await expect(length).toHaveValue('-23.500');
});

test('a work zero is set by value and where the axes stand', async ({ page }) => {
  await enter(page, '#/settings/zeros');
  const zero = (axis: string) => page.getByLabel(`G58 ${axis}`, { exact: true });
  await zero('Y').fill('-12.5');
  await zero('Y').press('Enter');
  await page.getByRole('button', { name: 'G58 X: zero here' }).click();
  await show(page, 'position/absolute');
  const machine = Number((await small(page, 'X').textContent())!.replace('−', '-'));
  await show(page, 'settings/zeros');
  await expect(zero('Y')).toHaveValue('-12.500');
  await expect(zero('X')).toHaveValue(machine.toFixed(3));
  await page.reload();
  await expect(zero('Y')).toHaveValue('-12.500');
  await expect(zero('X')).toHaveValue(machine.toFixed(3));
});

test('a work zero is typed by the letter of its axis, added to, and searched', async ({ page }) => {
  await enter(page, '#/settings/zeros');
  const zero = (name: string) => page.getByLabel(name, { exact: true });
  await show(page, 'position/absolute');
  const machine = Number((await small(page, 'X').textContent())!.replace('−', '-'));
  await show(page, 'settings/zeros');
  await zero('G59 X').fill('X10');
  await zero('G59 X').press('Enter');
  await expect(zero('G59 X')).toHaveValue((machine + 10).toFixed(3));
  // Another axis' letter is no value of this one.
  await zero('G59 X').fill('Y10');
  await expect(zero('G59 X')).toHaveAttribute('aria-invalid', 'true');
  await zero('G59 X').press('Escape');
  await page.getByRole('button', { name: 'Add to what is there' }).click();
  await zero('G59 X').fill('-2.5');
  await zero('G59 X').press('Enter');
  await expect(zero('G59 X')).toHaveValue((machine + 7.5).toFixed(3));
  await zero('G59 X').fill('-2.5');
  await zero('G59 X').press('Enter');
  await expect(zero('G59 X')).toHaveValue((machine + 5).toFixed(3));
  const find = page.getByTestId('find-zero');
  await find.fill('P06');
  await find.press('Enter');
  await expect(zero('G54 P6 X')).toBeFocused();
  await find.fill('G56');
  await find.press('Enter');
  await expect(zero('G56 X')).toBeFocused();
});

test('an edge that was touched becomes a zero beside the external one; Z knows no radius, and old points are not mixed in', async ({ page }) => {
  await enter(page, '#/settings/zeros');
  const zero = (name: string) => page.getByLabel(name, { exact: true });
  for (const [name, value] of [['external X', '3.5'], ['external Z', '-2']] as const) {
    await zero(name).fill(value);
    await zero(name).press('Enter');
  }
  await show(page, 'settings/centring');
  const rows = page.locator('[data-taken]');
  const now = async (column: number) => Number((await page.locator('[data-page="settings"] tbody tr').first().locator('td').nth(column).textContent())!.replace(/^[XYZ]\s*/, '').replace('−', '-'));
  const [x, z] = [await now(0), await now(2)];
  const kind = (name: string) => page.getByRole('radio', { name, exact: true });
  // A measurement that is left in its midst.
  await kind('Rectangle').click();
  await page.getByTestId('touch').click();
  await expect(rows).toHaveCount(1);
  await page.getByTestId('touch').click();
  await expect(rows).toHaveCount(2);
  await page.reload();
  await expect(page.getByTestId('command')).toHaveText('In command');
  await expect(kind('Z')).toHaveCount(0);
  await page.getByTestId('touch').click();
  await expect(rows).toHaveCount(1);
  await expect(page.locator('.result')).toHaveCount(0);

  await kind('Edge').click();
  await expect(rows).toHaveCount(0);
  await page.getByLabel('System').selectOption('G57');
  await zero('Coordinate there').fill('10');
  await zero('Coordinate there').press('Enter');
  for (const [axis, place] of [['X', x + 5], ['Z', z]] as const) {
    await kind(axis).click();
    await expect(zero('Radius of the tool')).toHaveCount(axis === 'Z' ? 0 : 1);
    await expect(kind('From −')).toHaveCount(axis === 'Z' ? 0 : 1);
    await page.getByTestId('touch').click();
    await expect(page.locator('.result strong')).toHaveText(`${axis} ${place.toFixed(3).replace('-', '−')}`);
    await page.getByTestId('set-zero').click();
    await expect(rows).toHaveCount(0);
  }
  await show(page, 'settings/zeros');
  // With the external zero the axis stands at the coordinate that was told.
  await expect(zero('G57 X')).toHaveValue((x + 5 - 10 - 3.5).toFixed(3));
  await expect(zero('G57 Z')).toHaveValue((z - 10 + 2).toFixed(3));
  for (const name of ['external X', 'external Z']) {
    await zero(name).fill('0');
    await zero(name).press('Enter');
  }
});

test('points of a centring are taken in any order, one of them anew, and are there after a look at another page', async ({ page }) => {
  await enter(page, '#/settings/centring');
  const rows = page.locator('[data-taken]');
  const point = (number: number) => page.getByRole('button', { name: `Point ${number}`, exact: true });
  const title = (text: string) => expect(page.getByRole('heading', { name: text, exact: true })).toBeVisible();
  await page.getByRole('radio', { name: 'Rectangle' }).click();
  await point(3).click();
  await page.getByTestId('touch').click();
  await title('Points: 1 of 4');
  await expect(rows).toHaveAttribute('data-taken', '3');
  // The first that is missing comes next.
  await expect(point(1)).toHaveAttribute('aria-pressed', 'true');
  await show(page, 'position/absolute');
  await show(page, 'settings/centring');
  await title('Points: 1 of 4');
  await page.getByTestId('touch').click();
  await title('Points: 2 of 4');
  await point(3).click();
  await page.getByTestId('touch').click();
  await expect(point(2)).toHaveAttribute('aria-pressed', 'true');
  await title('Points: 2 of 4');
  for (const count of [3, 4]) {
    await page.getByTestId('touch').click();
    await title(`Points: ${count} of 4`);
  }
  await expect(page.locator('.result strong')).toHaveCount(2);
  await shoot(page, 'centring-points');
  // A circle may have more than it needs.
  await page.getByRole('radio', { name: 'Circle' }).click();
  await title('Points: 0 of 3');
  await expect(point(4)).toHaveCount(0);
  for (const count of [1, 2, 3]) {
    await page.getByTestId('touch').click();
    await title(`Points: ${count} of 3`);
  }
  await expect(point(4)).toHaveAttribute('aria-pressed', 'true');
  await page.getByRole('button', { name: 'Again' }).click();
  await title('Points: 0 of 3');
});

test('a macro variable is set in MDI, and emptied', async ({ page }) => {
  await enter(page, '#/offsets/variables');
  await mode(page, 'KEY_MDI', 'Manual data input');
  await page.getByRole('radio', { name: '#500–#999' }).click();
  const variable = page.getByLabel('#501', { exact: true });
  await expect(variable).toHaveValue('');
  await variable.fill('12.25');
  await variable.press('Enter');
  await expect(variable).toHaveValue('12.2500');
  await page.reload();
  await page.getByRole('radio', { name: '#500–#999' }).click();
  await expect(variable).toHaveValue('12.2500');
  await variable.fill('');
  await variable.press('Enter');
  await page.getByRole('button', { name: 'Read again' }).click();
  await expect(variable).toHaveValue('');
});

test('offsets, variables and points of a pitch table are found by their numbers', async ({ page }) => {
  await enter(page, '#/offsets/tools');
  const find = async (box: string, text: string) => {
    await page.getByTestId(box).fill(text);
    await page.getByTestId(box).press('Enter');
  };
  await find('find-offset', 'H200');
  await expect(page.getByLabel('200 Length H', { exact: true })).toBeFocused();
  await find('find-offset', '257');
  await expect(page.getByTestId('find-offset')).toHaveClass(/wrong/);
  await show(page, 'offsets/variables');
  await find('find-variable', '#730');
  await expect(page.getByLabel('#730', { exact: true })).toBeFocused();
  await find('find-variable', '5001');
  await expect(page.locator('[data-variable="5001"]')).toBeFocused();
  await shoot(page, 'find-variable');
  await show(page, 'offsets/pitch');
  await find('find-point', '1234');
  await expect(page.getByLabel('X 1234', { exact: true })).toBeFocused();
  await shoot(page, 'find-point');
});

test('one box finds codes, parameters, alarms, variables and signals', async ({ page }) => {
  await enter(page, '#/help/search', false);
  const box = page.getByTestId('help-search');
  const results = page.getByTestId('help-results');
  for (const [sought, kind, key] of [
    ['G81', 'Code', 'G81'],
    ['P98', 'Parameter', 'P98'],
    ['#5021', 'Variable', '#50'],
    ['FC-1417', 'Alarm', 'FC-1417'],
    ['KEY_START', 'Signal', 'KEY_START'],
  ] as const) {
    await box.fill(sought);
    const found = results.locator('li', { hasText: kind }).filter({ hasText: key }).first();
    await expect(found).toBeVisible();
    await found.getByRole('button').click();
    await expect(page.locator('.detail h2')).toContainText(key);
    await expect(page.locator('.detail')).toContainText(/\p{L}{3,}.*\p{L}{3,}/u);
  }
  await shoot(page, 'help-search');
  // How something is done, with the way there; a sum, which the calculator goes on with.
  await box.fill('work zeros');
  await results.locator('[data-found="operation zero"]').click();
  await expect(page.getByTestId('help-local')).toContainText('G54');
  await page.getByTestId('help-go').click();
  await expect(page.getByTestId('zeros')).toBeVisible();
  await show(page, 'help/search');
  await box.fill('7/2+1');
  await expect(page.getByTestId('help-local')).toContainText('7/2+1 = 4.5');
  await shoot(page, 'help-sum');
  await page.getByTestId('help-go').click();
  await expect(page.getByTestId('sum')).toHaveValue('7/2+1');
  await show(page, 'help/search');
  await box.fill('calculator');
  await results.locator('[data-found="calculator calculator"]').click();
  await page.getByTestId('help-go').click();
  await page.getByTestId('sum').fill('2+3*(4-1)^2');
  await expect(page.locator('.calculator output')).toHaveText('29');
});

test('a signal is found by its name, and shows that its key is held', async ({ page }) => {
  await enter(page, '#/diagnosis/signals');
  await page.locator('[data-page="diagnosis"]').getByRole('searchbox').fill('KEY_LUBE');
  const signal = page.getByTestId('signals').locator('> div', { hasText: 'KEY_LUBE' }).first();
  await expect(signal.locator('b')).toHaveText('0');
  await page.locator('[data-signal="KEY_LUBE"]').hover();
  await page.mouse.down();
  await expect(signal.locator('b')).toHaveText('1');
  await page.mouse.up();
  await expect(signal.locator('b')).toHaveText('0');
});

test('any signal is found by its address, with a name or without', async ({ page }) => {
  await enter(page, '#/diagnosis/bytes');
  const find = page.getByTestId('find-address');
  const about = page.getByTestId('address');
  await find.fill('KEY_LUBE');
  await find.press('Enter');
  await expect(about).toContainText('KEY_LUBE');
  const place = (await about.locator('strong').textContent())!;
  expect(place).toMatch(/^X\d+\.\d$/);
  const bit = page.locator(`[data-address="${place}"]`);
  await expect(bit).toBeFocused();
  await expect(bit.locator('b')).toHaveText('0');
  await page.locator('[data-signal="KEY_LUBE"]').hover();
  await page.mouse.down();
  await expect(bit.locator('b')).toHaveText('1');
  await shoot(page, 'bytes');
  await page.mouse.up();
  await expect(bit.locator('b')).toHaveText('0');
  await find.fill('r7999');
  await find.press('Enter');
  await expect(page.locator('[data-address="R7999"]')).toBeFocused();
  await expect(about).toContainText('Nobody has given');
  await page.setViewportSize({ width: 800, height: 600 });
  await page.getByTestId('machine-panel').getByRole('button', { name: 'Close' }).click();
  await shoot(page, 'bytes-small');
});

test('the times of the control are shown and taken anew, and the spindle as it turns', async ({ page }) => {
  await enter(page, '#/diagnosis/timing');
  const timing = page.getByTestId('timing');
  const periods = async () => Number(await timing.getAttribute('data-periods'));
  const worst = async (name: string) => Number((await page.locator(`[data-timing="${name}"] td`).first().textContent())!.replace(/[^\d.]/g, ''));
  await expect.poll(periods).toBeGreaterThan(1000);
  // A period is a millisecond, and the longest is no shorter than its work.
  expect(await worst('worst_period')).toBeGreaterThanOrEqual(900);
  expect(await worst('worst_work')).toBeGreaterThan(await worst('level_1'));
  expect(await worst('level_2')).toBeGreaterThan(0);
  // Taken anew they are fewer than before for as long as they were taken: long enough to be seen.
  await expect.poll(periods).toBeGreaterThan(5000);
  const before = await periods();
  await page.getByTestId('forget-timing').click();
  await expect.poll(periods).toBeLessThan(before);
  await shoot(page, 'timing');
  await mode(page, 'KEY_MDI', 'Manual data input');
  await show(page, 'program/mdi');
  await page.getByLabel('One block').fill('M3 S1200');
  await page.getByLabel('One block').press('Enter');
  await press(page, 'KEY_START');
  await show(page, 'position/absolute');
  await expect(page.getByTestId('speed')).toHaveText('1200');
  await expect(page.getByTestId('speed-programmed')).toHaveText('1200');
  await page.keyboard.press('F8');
  await expect(page.getByTestId('speed')).toHaveText('0');
});

test('S is set on the page of positions at once, in any mode, and not while a program runs', async ({ page }) => {
  await enter(page, '#/position/absolute');
  const field = page.getByLabel('Set S');
  const programmed = page.getByTestId('speed-programmed');
  await mode(page, 'KEY_JOG', 'Jog');
  // P258 is the highest.
  await field.fill('99999');
  await field.press('Enter');
  await expect(field).toHaveAttribute('aria-invalid', 'true');
  await field.fill('1234');
  await field.press('Enter');
  await expect(programmed).toHaveText('1234');
  await press(page, 'KEY_SP_CW');
  await expect(page.getByTestId('speed')).toHaveText('1234');
  // One that turns follows.
  await field.fill('800');
  await field.press('Enter');
  await expect(page.getByTestId('speed')).toHaveText('800');
  await press(page, 'KEY_SP_STOP');
  await expect(page.getByTestId('speed')).toHaveText('0');
  await mode(page, 'KEY_MDI', 'Manual data input');
  await show(page, 'program/mdi');
  await page.getByLabel('One block').fill('G4 X3');
  await page.getByLabel('One block').press('Enter');
  await press(page, 'KEY_START');
  await show(page, 'position/absolute');
  await expect(field).toBeDisabled();
  await expect(page.getByText('The program under way sets S')).toBeVisible();
  await stands(page, 'idle');
  await expect(field).toBeEnabled();
});

test('the page of all positions has the speed of each axis', async ({ page }) => {
  await enter(page);
  await load(page, 'O1820', 'O1820\nG21 G90 G54\nG91 G1 X-90. Y-120. F600\nX90. Y120. F3000\nM30\n');
  await show(page, 'position/all');
  await expect(page.locator('[data-kind="speed"]')).toContainText('mm/min');
  await press(page, 'KEY_START');
  await expect(page.locator('[data-speed="X"]')).toHaveText('−360', { timeout: 20_000 });
  await expect(page.locator('[data-speed="Y"]')).toHaveText('−480');
  await expect(page.locator('[data-speed="Z"]')).toHaveText('0');
  await press(page, 'KEY_HOLD');
  await expect(page.locator('[data-speed="X"]')).toHaveText('0', { timeout: 20_000 });
  await page.getByRole('button', { name: 'Reset' }).first().click();
  await stands(page, 'idle');
});

test('the directory tells how many programs there are, how many there may be, and what is free', async ({ page }) => {
  await enter(page, '#/program/directory');
  const told = page.getByTestId('capacity');
  await expect(told).toContainText(/\d+ programs?, [\d.]+ (B|KiB|MiB)/);
  await expect(told).toContainText('of at most 10,000');
  await expect(told).toContainText(/[\d.]+ (MiB|GiB) free/);
});

test('tables of help are browsed without a search, and operations lead to their pages', async ({ page }) => {
  await enter(page, '#/help/alarms');
  const count = page.getByTestId('browse-count');
  await expect.poll(async () => Number(await count.getAttribute('data-count'))).toBeGreaterThan(300);
  await page.getByTestId('browse-filter').fill('FC-0302');
  await page.locator('[data-key="FC-0302"]').click();
  await expect(page.getByTestId('help-detail')).toContainText('FC-0302');
  await expect(page.getByTestId('help-detail')).toContainText(/\w+ \w+ \w+/);
  for (const [tab, key] of [['parameters', 'P88'], ['variables', '#3000'], ['addresses', 'KEY_START']] as const) {
    await show(page, `help/${tab}`);
    await page.getByTestId('browse-filter').fill(key);
    await page.locator(`[data-key="${key}"]`).click();
    await expect(page.getByTestId('help-detail')).toContainText(key);
    await shoot(page, `help-${tab}`);
  }
  await page.getByTestId('browse-filter').fill('');
  await page.getByRole('radio', { name: 'Address' }).click();
  await expect(page.locator('[data-key="F"]')).toBeVisible();
  // A letter of a program is no signal.
  await page.locator('[data-key="F"]').click();
  await expect(page.getByTestId('help-detail').locator('h2')).toContainText('F');
  await expect(page.getByTestId('help-detail').getByRole('button', { name: 'Signals' })).toHaveCount(0);
  // A code that there is not.
  await show(page, 'help/codes/G999');
  await expect(page.locator('.codes .detail')).toContainText('G999');
  await expect(page.locator('.codes .detail p')).not.toHaveText('Loading…');
  // However short a name is, a finger finds it.
  await show(page, 'help/codes/G84');
  const link = await page.locator('.codes .detail a', { hasText: /^M29$/ }).boundingBox();
  expect(Math.min(link?.width ?? 0, link?.height ?? 0)).toBeGreaterThanOrEqual(43.9);
  await show(page, 'help/operations');
  await shoot(page, 'help-operations');
  await expect(page.locator('[data-operation]')).toHaveCount(30);
  await expect(page.locator('[data-not-here="bus"]')).toContainText('0#0 changes nothing');
  for (const id of ['power', 'system']) await expect(page.locator(`[data-not-here="${id}"]`)).toBeVisible();
  await page.locator('[data-operation="data"] a').click();
  await expect(page.getByTestId('backups')).toBeVisible();
});

test('a page that is closed disturbs no program of DNC', async ({ page, context }) => {
  test.setTimeout(480_000);
  await enter(page, '#/position');
  await home(page);
  await mode(page, 'KEY_DNC', 'DNC');
  await show(page, 'program/dnc');
  const remark = `(${'SOME WORDS THAT MAKE THE PROGRAM LONG 中文 '.repeat(22)})`;
  const pass = `G91 G1 X0.01 F60 ${remark}\nX0.01 ${remark}\n`;
  const passes = Math.ceil(1_250_000 / Buffer.byteLength(pass));
  const buffer = Buffer.from(`G90 G54 G0 X0\n${pass.repeat(passes)}M30\n`);
  await page.getByTestId('dnc-file').setInputFiles({ name: 'long.nc', mimeType: 'text/plain', buffer });
  const told = page.getByTestId('dnc');
  await expect.poll(async () => Number(await told.getAttribute('data-sent'))).toBeGreaterThan(900_000);
  // What is no program does not take its place.
  await page.getByTestId('dnc-file').setInputFiles({ name: 'picture.nc', mimeType: 'image/png', buffer: Buffer.from([0x89, 0x50, 1, 2, 3, 0, 0, 0, 9]) });
  await expect(notice(page)).toBeVisible();
  await expect(told).toContainText('long.nc');
  await expect(told).toHaveAttribute('data-sending', 'true');
  await press(page, 'KEY_START');
  await stands(page, 'running');
  await page.close();
  // Nobody is connected while most of it runs.
  await new Promise((resolve) => setTimeout(resolve, 5_000));
  const next = await context.newPage();
  await enter(next, '#/position/absolute');
  // Not a block is lost, and none is run twice.
  await expect.poll(() => x(next), { timeout: 300_000 }).toBe(Number((2 * passes * 0.01).toFixed(3)));
  await stands(next, 'idle', 60_000);
  await show(next, 'program/dnc');
  await expect(next.getByTestId('dnc')).toHaveAttribute('data-sent', String(buffer.length));
  await expect(next.getByTestId('dnc')).toHaveAttribute('data-sending', 'false');
});
