// The program editor: what it leaves as it was, what it knows of codes, and its tools.
import type { Page } from '@playwright/test';
import { expect, shoot, test } from './server';
import { bring, enter, notice, show, watchFaults } from './walk';

watchFaults();
// A loaded computer takes its time.
test.describe.configure({ timeout: 180_000 });

const text = (page: Page) => page.getByTestId('editor').locator('.cm-content');
const line = (page: Page, what: string) => text(page).locator('.cm-line', { hasText: what });

/** Brings a file, and opens it in the editor. */
async function edit(page: Page, name: string, bytes: Buffer): Promise<void> {
  await bring(page, name, bytes);
  await show(page, `program/edit/${name}`);
  await expect(text(page)).toContainText(name);
}

/** Stores what stands there. */
async function save(page: Page): Promise<void> {
  await page.getByTestId('save').click();
  await expect(page.getByTestId('save')).toBeDisabled();
}

/** A program of the memory, byte for byte. */
const kept = async (page: Page, name: string) => (await page.request.get(`/api/programs/${name}`)).body();

/** Lines as they stand, those behind the end of the screen left out. */
const lines = (page: Page) => text(page).locator('.cm-line').allTextContents();

test('a program keeps its line ends, its mark and its end; what is edited alone is other', async ({ page }) => {
  await enter(page);
  const before = '\ufeffO1500 (PART)\r\nG21 G90 G54\r\nG1 X10. F300\nG1 Y20.\r\n\r\nM30';
  await edit(page, 'O1500', Buffer.from(before));
  expect((await kept(page, 'O1500')).toString()).toBe(before);
  await line(page, 'G1 Y20.').click();
  await page.keyboard.press('End');
  await page.keyboard.type(' F200');
  await page.keyboard.press('Enter');
  await page.keyboard.type('G1 X30.');
  await save(page);
  const after = before.replace('G1 Y20.', 'G1 Y20. F200\r\nG1 X30.');
  expect((await kept(page, 'O1500')).toString()).toBe(after);
  // What is left unsaved while another page is shown keeps them too.
  await line(page, 'G1 X30.').click();
  await page.keyboard.press('End');
  await page.keyboard.type('5');
  await show(page, 'help/codes');
  await show(page, 'program/edit/O1500');
  await expect(line(page, 'G1 X30.5')).toBeVisible();
  await save(page);
  expect((await kept(page, 'O1500')).toString()).toBe(after.replace('X30.', 'X30.5'));
  // One that has line feeds alone, the last line too, gets no others.
  await edit(page, 'O1501', Buffer.from('O1501\nG0 X1.\nM30\n'));
  await line(page, 'G0 X1.').click();
  await page.keyboard.press('End');
  await page.keyboard.press('Enter');
  await page.keyboard.type('G0 X2.');
  await save(page);
  expect((await kept(page, 'O1501')).toString()).toBe('O1501\nG0 X1.\nG0 X2.\nM30\n');
});

test('a file in the encoding of Chinese shops is read with its comments', async ({ page }) => {
  await enter(page);
  // (零件加工程序) in GBK.
  const remark = Buffer.from('c1e3bcfebcd3b9a4b3ccd0f2', 'hex');
  await edit(page, 'O1502', Buffer.concat([Buffer.from('O1502 ('), remark, Buffer.from(')\r\nG0 X1.\r\nM30\r\n')]));
  await expect(text(page)).toContainText('零件加工程序');
  await show(page, 'program/directory');
  await expect(page.locator('[data-program="O1502"]')).toContainText('零件加工程序');
  // What is no text is refused, and told.
  await page.getByTestId('upload').setInputFiles({ name: 'O1503.nc', mimeType: 'application/octet-stream', buffer: Buffer.from([0x4f, 0, 1, 2, 0, 0xff, 0, 0, 7, 0]) });
  await expect(notice(page).filter({ hasText: 'The file is no text' })).toBeVisible();
  await expect(page.locator('[data-program="O1503"]')).toHaveCount(0);
});

test('codes are completed when they are chosen, and explained under the pointer', async ({ page }) => {
  await enter(page);
  await edit(page, 'O1510', Buffer.from('O1510\nG21 G90 G54\nM30\n'));
  await line(page, 'G54').click();
  await page.keyboard.press('End');
  await page.keyboard.press('Enter');
  const list = page.locator('.cm-tooltip-autocomplete');
  await page.keyboard.type('M3');
  await expect(list.locator('li').first()).toContainText('M03');
  await expect(list.locator('li').nth(1)).toContainText('M30');
  await shoot(page, 'edit-completion');
  // Enter ends the line: nothing is put in the place of what was typed.
  await page.keyboard.press('Enter');
  await expect(list).toHaveCount(0);
  await page.keyboard.type('G8');
  await expect(list.locator('li', { hasText: 'G81' })).toBeVisible();
  await list.locator('li', { hasText: 'G81' }).click();
  await expect.poll(() => lines(page)).toEqual(['O1510', 'G21 G90 G54', 'M3', 'G81', 'M30', '']);
  await page.keyboard.press('Control+z');
  await expect.poll(() => lines(page)).toEqual(['O1510', 'G21 G90 G54', 'M3', 'G8', 'M30', '']);
  await page.keyboard.press('Control+y');
  await page.keyboard.type(' Z-5. R2. F100');
  // The words of the control's own tables, in the language of the panel.
  const hover = page.locator('.nc-hover');
  await line(page, 'G81').locator('.nc-g').hover();
  await expect(hover).toContainText('G81');
  await expect(hover).toContainText(/[Dd]rill/);
  await shoot(page, 'edit-hover');
});

test('jumps of macro A follow the numbers, and those that are computed are told', async ({ page }) => {
  await enter(page);
  await edit(page, 'O1521', Buffer.from(['O1521', 'N1 G65 H01 P#100 Q0', 'G65 H84 P1 Q#100 R5', 'GOTO #100', 'M30'].join('\n')));
  await page.getByTestId('editor').getByRole('button', { name: 'Renumber' }).click();
  await page.getByRole('dialog').getByRole('button', { name: 'Renumber' }).click();
  await expect.poll(() => lines(page)).toEqual(['O1521', 'N10 G65 H01 P#100 Q0', 'N20 G65 H84 P10 Q#100 R5', 'N30 GOTO #100', 'N40 M30']);
  await expect(notice(page).filter({ hasText: '1 jump with a computed target stays as it is' })).toBeVisible();
});

test('words are found and replaced, lines are gone to and numbered, and each is undone', async ({ page }) => {
  await enter(page);
  const program = ['O1520 (LOOP)', 'N1 #1=0', 'N2 G1 X10. F300', 'G1 X10. Y5.', '(G1 X10.)', 'N7 #1=#1+1', 'IF [#1 LT 3] GOTO 2', '/ G0 Z5.', 'M30'];
  await edit(page, 'O1520', Buffer.from(program.join('\r\n')));
  const editor = page.getByTestId('editor');
  await editor.getByRole('button', { name: 'Find and replace' }).click();
  const panel = page.locator('.cm-search');
  await panel.getByRole('textbox', { name: 'Find' }).fill('X10.');
  await panel.getByRole('textbox', { name: 'Replace with' }).fill('X12.5');
  await expect(page.locator('.cm-searchMatch')).toHaveCount(3);
  await shoot(page, 'edit-find');
  for (const button of await panel.getByRole('button').all()) expect((await button.boundingBox())?.height ?? 0).toBeGreaterThanOrEqual(43.9);
  await panel.getByRole('button', { name: 'Replace all' }).click();
  const replaced = program.map((line) => line.replace('X10.', 'X12.5'));
  await expect.poll(() => lines(page)).toEqual(replaced);
  await panel.getByRole('button', { name: 'Close' }).click();
  await expect(panel).toHaveCount(0);

  await editor.getByRole('button', { name: 'Go to line' }).click();
  await page.locator('.cm-dialog input').fill('7');
  await page.locator('.cm-dialog').getByRole('button', { name: 'Go', exact: true }).click();
  await expect(page.locator('.cm-activeLine.cm-line')).toContainText('GOTO 2');

  await editor.getByRole('button', { name: 'Renumber' }).click();
  const dialog = page.getByRole('dialog');
  await dialog.getByLabel('First number').last().fill('100');
  await dialog.getByLabel('Step').last().fill('5');
  await dialog.getByRole('button', { name: 'Renumber' }).click();
  const numbered = ['O1520 (LOOP)', 'N100 #1=0', 'N105 G1 X12.5 F300', 'N110 G1 X12.5 Y5.', '(G1 X12.5)', 'N115 #1=#1+1', 'N120 IF [#1 LT 3] GOTO 105', '/ N125 G0 Z5.', 'N130 M30'];
  await expect.poll(() => lines(page)).toEqual(numbered);
  // The cursor stays where it was.
  await expect(page.locator('.cm-activeLine.cm-line')).toContainText('GOTO 105');
  await save(page);
  expect((await kept(page, 'O1520')).toString()).toBe(numbered.join('\r\n'));

  await editor.getByRole('button', { name: 'Undo' }).click();
  await expect.poll(() => lines(page)).toEqual(replaced);
  await editor.getByRole('button', { name: 'Undo' }).click();
  await expect.poll(() => lines(page)).toEqual(program);
  await editor.getByRole('button', { name: 'Redo' }).click();
  await expect.poll(() => lines(page)).toEqual(replaced);
  await editor.getByRole('button', { name: 'Undo' }).click();
  await save(page);
  expect((await kept(page, 'O1520')).toString()).toBe(program.join('\r\n'));
});

test('the tools of the editor speak the language that is chosen', async ({ page }) => {
  await enter(page);
  await edit(page, 'O1530', Buffer.from('O1530\nM30\n'));
  await page.getByTestId('user').click();
  await page.getByTestId('languages').locator('[data-language="es"]').click();
  await expect(page.locator('html')).toHaveAttribute('lang', 'es');
  await page.keyboard.press('Escape');
  await text(page).click();
  await page.keyboard.press('Control+f');
  await expect(page.locator('.cm-search').getByRole('button', { name: 'Reemplazar todo' })).toBeVisible();
  await expect(page.locator('.cm-search')).not.toContainText(/[Rr]eplace/);
});

test('what was stored elsewhere meanwhile is shown, and never replaced unasked', async ({ page }) => {
  await enter(page, '#/position');
  const text = (what: string) => `O1850\n(${what})\nM30\n`;
  await bring(page, 'O1850', Buffer.from(text('FIRST')));
  await bring(page, 'O1851', Buffer.from('O1851\nM30\n'));
  await show(page, 'program/edit/O1850');
  const shown = page.locator('.cm-content');
  const save = page.getByTestId('save');
  const newer = page.getByTestId('newer');
  await expect(shown).toContainText('FIRST');
  const elsewhere = async (what: string) => {
    // Stamps count milliseconds.
    await page.waitForTimeout(20);
    const answer = await page.request.put('/api/programs/O1850', { data: Buffer.from(text(what)) });
    expect(answer.status()).toBe(200);
  };
  const type = async (what: string) => {
    await shown.locator('.cm-line', { hasText: 'M30' }).click();
    await page.keyboard.press('End');
    await page.keyboard.type(` (${what})`);
  };
  const stored = async () => (await (await page.request.get('/api/programs/O1850')).body()).toString();

  // Nothing is changed here: what is there now is shown.
  await elsewhere('SECOND');
  await expect(shown).toContainText('SECOND');
  await expect(save).toBeDisabled();
  // What is stored here is nobody else's.
  for (const what of ['ONE', 'TWO']) {
    await type(what);
    await save.click();
    await expect(save).toBeDisabled();
  }
  await expect(newer).toHaveCount(0);
  expect(await stored()).toBe('O1850\n(SECOND)\nM30 (ONE) (TWO)\n');

  await type('THREE');
  await elsewhere('THIRD');
  await expect(newer).toBeVisible();
  await save.click();
  await expect(page.getByTestId('replace-newer')).toBeVisible();
  await page.getByRole('dialog').getByRole('button', { name: 'Cancel' }).click();
  expect(await stored()).toBe(text('THIRD'));
  // Also after another program was open here.
  for (const other of ['O1851', 'O1850']) {
    await show(page, `program/edit/${other}`);
    await expect(page.getByTestId('editor').locator('.name')).toHaveText(other);
  }
  await expect(shown).toContainText('THREE');
  await expect(newer).toBeVisible();
  await shoot(page, 'edit-newer');
  await page.getByTestId('take-newer').click();
  await expect(newer).toHaveCount(0);
  await expect(shown).toContainText('THIRD');
  await expect(shown).not.toContainText('THREE');
  await expect(save).toBeDisabled();

  // While another page is shown.
  await type('FOUR');
  await show(page, 'position');
  await elsewhere('FOURTH');
  await show(page, 'program/edit/O1850');
  await expect(newer).toBeVisible();
  await save.click();
  await page.getByTestId('replace-newer').click();
  await expect(save).toBeDisabled();
  await expect(newer).toHaveCount(0);
  expect(await stored()).toBe('O1850\n(THIRD)\nM30 (FOUR)\n');
});
