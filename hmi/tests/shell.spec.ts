// What the frame does around all pages: the log-in, the stop, what is not stored yet, a lost connection.
import { expect, test } from '@playwright/test';
import { mock, type Options } from './mock';
import { shoot } from './server';

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

test('a program too long to be checked as it is typed is checked when it is saved', async ({ context }) => {
  const program = `O0001\n${'G1 X1.\n'.repeat(60_000)}M30\n`;
  const { page } = await mock(context, {
    program,
    mode: 'edit',
    findings: [{ id: 'FC-0302', severity: 'error', line: 3, column: 1, end_line: 3, end_column: 3, text: 'An arc has no centre', help: '' }],
  });
  await page.evaluate(() => (location.hash = '#/program/edit/O0001'));
  await expect(page.getByTestId('checked-on-save')).toHaveText('Long: checked when it is saved');
  await expect(page.getByTestId('findings')).toHaveCount(0);
  await page.getByTestId('editor').locator('.cm-line').nth(1).click();
  await page.keyboard.type('(A)');
  await page.getByTestId('save').click();
  await expect(page.getByTestId('findings')).toContainText('An arc has no centre');
});

test('what cannot be drawn is told in words, not as the server said it', async ({ context }) => {
  const { page } = await mock(context, { noPath: { status: 408, body: '{"error":"too_slow"}' } });
  await page.evaluate(() => (location.hash = '#/graphics'));
  await expect(page.locator('.over.bad')).toContainText('The connection was too slow');
  await expect(page.locator('.over.bad')).not.toContainText('{');
});

test('modes and overrides are chosen by keys, but not while something is typed', async ({ context }) => {
  const { page, sent } = await mock(context, { mode: 'mdi' });
  const done = () => sent.filter((one) => ['key', 'switch'].includes(one.do)).map((one) => `${String(one.key ?? one.switch)} ${String(one.down ?? one.position)}`);
  await expect(page.getByTestId('mode')).toBeVisible();
  await page.keyboard.press('Alt+Shift+Digit6');
  await expect.poll(done).toEqual(['KEY_JOG true', 'KEY_JOG false']);
  await page.keyboard.press('Alt+Shift+ArrowUp');
  await page.keyboard.press('Alt+Shift+ArrowLeft');
  await expect.poll(done).toEqual(['KEY_JOG true', 'KEY_JOG false', 'SWITCH_FEED 11', 'SWITCH_SPINDLE 5']);
  await page.keyboard.press('Alt+Shift+PageUp');
  await expect.poll(done).toHaveLength(6);
  expect(done()[4]).toBe('KEY_R_F0 true');
  await page.evaluate(() => (location.hash = '#/offsets/parameters'));
  await page.getByTestId('parameter-search').click();
  await page.keyboard.press('Alt+Shift+Digit1');
  await page.waitForTimeout(200);
  expect(done()).toHaveLength(6);
});

test('every kind of measuring is prepared with its own values', async ({ context }) => {
  const { page, sent } = await mock(context, { moves: false });
  await page.evaluate(() => (location.hash = '#/settings/probe'));
  const work = page.locator('.card').filter({ has: page.getByTestId('measure') });
  const tool = page.locator('.card').filter({ has: page.getByTestId('measure-tool') });
  const fill = async (card: typeof work, label: string, value: string) => {
    await card.getByLabel(label, { exact: true }).last().fill(value);
    await card.getByLabel(label, { exact: true }).last().press('Enter');
  };
  const last = (what: string) => sent.filter((one) => one.do === what).at(-1);
  await work.getByRole('radio', { name: 'Hole, three angles' }).click();
  await fill(work, 'Angle 2', '100');
  await page.getByTestId('more-work').click();
  await fill(work, 'Clearance', '6');
  await fill(work, 'Speed of the search', '200');
  await work.locator('select').selectOption('G54 P12');
  await page.getByTestId('measure').click();
  await expect.poll(() => last('measure')).toMatchObject({
    form: 'vector_hole', diameter: 40, angles: [0, 100, 240], system: 'G54 P12', clearance: 6, pace: { search: 200, way: null }, values: {},
  });
  // Places behind their letter are counted from where the probe stands.
  const stands = { X: 50, Y: 60, Z: -3 };
  for (const [label, text, place] of [['Height of touch', 'z-5', stands.Z - 5], ['Rough centre X', 'X', stands.X], ['Rough centre Y', 'Y2,5', stands.Y + 2.5]] as const) {
    await fill(work, label, text);
    await expect(work.getByLabel(label, { exact: true })).toHaveValue(place.toFixed(3));
  }
  // Another letter says nothing of it, and no tolerance is below nothing.
  await work.getByLabel('Height of touch', { exact: true }).fill('X5');
  await expect(work.getByLabel('Height of touch', { exact: true })).toHaveAttribute('aria-invalid', 'true');
  await work.getByLabel('Height of touch', { exact: true }).press('Escape');
  await work.getByLabel('Tolerance', { exact: true }).fill('-1');
  await expect(work.getByLabel('Tolerance', { exact: true })).toHaveAccessibleDescription('≥ 0');
  await work.getByLabel('Tolerance', { exact: true }).press('Escape');
  await page.getByTestId('measure').click();
  await expect.poll(() => last('measure')).toMatchObject({ x: 50, y: 62.5, z: -8, tolerance: null });
  await work.getByRole('radio', { name: 'Slot at an angle' }).click();
  await fill(work, 'Angle', '30');
  await page.getByTestId('measure').click();
  await expect.poll(() => last('measure')).toMatchObject({ form: 'vector_slot', width: 40, angle: 30 });
  await tool.getByRole('radio', { name: 'Calibrate place' }).click();
  await fill(tool, 'Known length', '80');
  await page.getByTestId('measure-tool').click();
  await expect.poll(() => last('measure_tool')).toMatchObject({ mode: 'calibrate_length', length: 80, h: 0, d: 0 });
  await tool.getByRole('radio', { name: 'Both' }).click();
  await page.getByTestId('more-tool').click();
  await fill(tool, 'Offset that marks breakage', '99');
  await fill(tool, 'Tolerance', '0.1');
  await page.getByTestId('measure-tool').click();
  await expect.poll(() => last('measure_tool')).toMatchObject({ mode: 'both', h: 1, d: 1, mark: 99, tolerance: 0.1, rpm: null });
});

test('what may be typed stands under a value that is out of range, or no whole number', async ({ context }) => {
  const { page, sent } = await mock(context);
  await page.evaluate(() => (location.hash = '#/offsets/tools'));
  const length = page.getByLabel('1 Length H', { exact: true });
  await length.fill('20000');
  await length.press('Enter');
  await expect(length).toHaveAccessibleDescription('−9999.999 … 9999.999');
  await shoot(page, 'range-told');
  await length.press('Escape');
  await expect(length).toHaveAccessibleDescription('');
  await expect(length).toHaveValue('-102.350');
  await page.evaluate(() => (location.hash = '#/settings/tool'));
  const number = page.getByLabel('Offset', { exact: true });
  await number.fill('2.5');
  await number.press('Enter');
  await expect(number).toHaveAccessibleDescription('Whole number, 1 … 256');
  await number.press('Escape');
  await number.fill('3');
  await number.press('Enter');
  await expect(page.getByRole('button', { name: 'Set H 3' })).toBeVisible();
  expect(sent.filter((one) => one.do === 'set_offset')).toEqual([]);
});

for (const [value, name] of [[0, 'Radius D'], [1, 'Diameter D']] as const) {
  test(`D of a tool is called ${name} with 40#7 = ${value}`, async ({ context }) => {
    const { page } = await mock(context, { parameters: { 'NO40.7': value } });
    await page.evaluate(() => (location.hash = '#/offsets/tools'));
    await expect(page.getByLabel(`1 ${name}`, { exact: true })).toHaveValue('5.000');
    await expect(page.getByRole('columnheader', { name: `${name} mm`, exact: true })).toBeVisible();
  });
}

test('places and offsets have their unit', async ({ context }) => {
  for (const [axes, unit] of [[['X', 'Y', 'Z'], 'mm'], [['X', 'Y', 'Z', 'A'], 'mm, °']] as const) {
    const { page } = await mock(context, { axes: [...axes] });
    for (const [hash, head, text] of [['position/absolute', '.axes h2', `G54 ${unit}`], ['position/all', 'th >> nth=0', unit], ['settings/zeros', 'thead th >> nth=-1', axes.length > 3 ? 'A °' : 'Z mm']] as const) {
      await page.evaluate((to) => (location.hash = to), `#/${hash}`);
      await expect(page.locator('main').locator(head)).toHaveText(text);
    }
    await page.close();
  }
});

test('the shift of the handwheel is cleared by axis', async ({ context }) => {
  const { page, sent } = await mock(context, { interruption: { X: 1.5, Z: -0.2 } });
  await page.evaluate(() => (location.hash = '#/position/all'));
  const clear = (axis: string) => page.getByTestId(`clear-interruption-${axis}`);
  await expect(clear('X')).toBeVisible();
  await expect(clear('Y')).toHaveCount(0);
  await clear('Z').click();
  await expect.poll(() => sent.filter((one) => one.do === 'clear_interruption').map((one) => one.axis)).toEqual(['Z']);
});

test('parts are entered on the position page, and codes are large enough for a finger', async ({ context }) => {
  const { page, sent } = await mock(context);
  const parts = page.getByTestId('parts').locator('input').last();
  await parts.fill('250');
  await parts.press('Enter');
  await expect.poll(() => sent.filter((one) => one.do === 'set_counter').map((one) => [one.counter, one.value])).toEqual([['parts', 250]]);
  const box = await page.locator('a[href="#/help/codes/G54"]').boundingBox();
  expect(Math.min(box?.width ?? 0, box?.height ?? 0)).toBeGreaterThanOrEqual(43.9);
});

for (const opens of [true, false]) {
  test(`an alarm ${opens ? 'shows' : 'leaves'} the page with 24#6 = ${Number(opens)} (GSK990MC part 2, 3.7)`, async ({ context }) => {
    const { page, say } = await mock(context, { parameters: opens ? { 'NO24.6': 1 } : { 'NO24.6': 0 } });
    await expect(page.locator('[data-page="position"]')).toBeVisible();
    // A warning stops nothing, and takes no page away.
    say({ event: 'alarm', alarm: { id: 'FC-1424', line: 0, warning: true, values: {} } });
    await page.waitForTimeout(300);
    await expect(page.locator('[data-page="position"]')).toBeVisible();
    say({ event: 'alarm', alarm: { id: 'FC-0302', line: 3, warning: false, values: {} } });
    if (opens) await expect(page.locator('[data-page="alarms"]')).toBeVisible();
    else {
      await page.waitForTimeout(500);
      await expect(page.locator('[data-page="position"]')).toBeVisible();
    }
  });
}

for (const steps of [true, false]) {
  test(`the key of a page ${steps ? 'steps' : 'does not step'} through its parts with 25#0 = ${Number(steps)} (GSK990MC part 2, 1.2.3)`, async ({ context }) => {
    const { page } = await mock(context, { parameters: { 'NO25.0': Number(steps), 'NO26.7': 1, 'NO23.6': Number(steps) } });
    const part = page.locator('.tabs [aria-current="page"]');
    const key = page.getByRole('navigation', { name: 'Pages' }).getByRole('link', { name: 'Position' });
    await expect(part).toHaveText('Absolute');
    await key.click();
    await expect(part).toHaveText(steps ? 'All' : 'Absolute');
    await page.keyboard.press('Alt+Digit1');
    await expect(part).toHaveText(steps ? 'With program' : 'Absolute');
    // 23#6: codes in force beside the program.
    await page.evaluate(() => (location.hash = '#/position/program'));
    await expect(part).toHaveText('With program');
    await expect(page.getByRole('heading', { name: 'In force' })).toHaveCount(Number(steps));
    if (!steps) {
      // What is shown stays.
      await page.evaluate(() => (location.hash = '#/program/edit/O0001'));
      await expect(part).toHaveText('Edit');
      await page.getByRole('navigation', { name: 'Pages' }).getByRole('link', { name: 'Program' }).click();
      await expect(page).toHaveURL(/#\/program\/edit\/O0001$/);
      return;
    }
    // From the last to the first.
    await key.click();
    await expect(part).toHaveText('Relative');
    await page.keyboard.press('Alt+Digit0');
    await expect(part).toHaveText('Search');
    await page.keyboard.press('Alt+Digit0');
    await expect(part).not.toHaveText('Search');
  });
}

test('the mode EDIT shows the program with 26#0, and the key of programs what its mode needs with 26#1 and 26#2', async ({ context }) => {
  const options: Options = { parameters: { 'NO26.0': 1, 'NO26.1': 1, 'NO26.2': 1 }, mode: 'jog' };
  const { page } = await mock(context, options);
  await expect(page.getByTestId('mode')).toHaveText('Jog');
  const part = page.locator('.tabs [aria-current="page"]');
  const programs = page.getByRole('navigation', { name: 'Pages' }).getByRole('link', { name: 'Program' });
  options.mode = 'edit';
  await expect(part).toHaveText('Edit');
  await page.evaluate(() => (location.hash = '#/position'));
  await expect(part).toHaveText('Absolute');
  await programs.click();
  await expect(part).toHaveText('Edit');
  await page.evaluate(() => (location.hash = '#/position'));
  options.mode = 'mdi';
  await expect(page.getByTestId('mode')).toHaveText('Manual data input');
  await expect(part).toHaveText('Absolute');
  await programs.click();
  await expect(part).toHaveText('MDI');
  // A ladder that is being changed stays.
  await page.evaluate(() => (location.hash = '#/plc/edit'));
  await expect(part).toHaveText('Change');
  options.mode = 'edit';
  await expect(page.getByTestId('mode')).not.toHaveText('Manual data input');
  await expect(part).toHaveText('Change');
});

test('beside the program stands the relative coordinate in modes by hand, the distance to go in others', async ({ context }) => {
  const options = { mode: 'auto' };
  const { page } = await mock(context, options);
  await page.evaluate(() => (location.hash = '#/position/program'));
  const legend = page.getByTestId('axes').locator('.legend span').first();
  const axis = page.locator('[data-axis="X"]');
  for (const mode of ['auto', 'jog', 'mdi', 'home', 'dnc', 'step', 'auto', 'handle']) {
    options.mode = mode;
    const isByHand = ['jog', 'home', 'step', 'handle'].includes(mode);
    await expect(legend, mode).toHaveText(isByHand ? 'Relative' : 'To go');
    await expect(axis.locator('.relative'), mode).toHaveCount(Number(isByHand));
    await expect(axis.locator('.to-go'), mode).toHaveCount(Number(!isByHand));
  }
  // Other pages have the distance to go in each mode.
  await page.evaluate(() => (location.hash = '#/position/absolute'));
  await expect(legend).toHaveText('To go');
});

test('older entries of the operation log are loaded as they are asked for', async ({ context }) => {
  const { page } = await mock(context, { logged: 1200 });
  await page.evaluate(() => (location.hash = '#/alarms/log'));
  const rows = page.getByTestId('log').locator('tbody tr');
  await expect(rows).toHaveCount(500);
  const older = page.getByTestId('older');
  await older.click();
  await expect(rows).toHaveCount(1000);
  await older.click();
  await expect(rows).toHaveCount(1200);
  await expect(rows.last()).toContainText('P1');
  await expect(older).toHaveCount(0);
  await expect(page.getByText('1,200 entries')).toBeVisible();
});

test('the page of positions opens with relative ones where somebody wants them', async ({ context }) => {
  const { page, home } = await mock(context);
  const part = page.locator('.tabs [aria-current="page"]');
  await expect(part).toHaveText('Absolute');
  await page.getByTestId('user').click();
  await page.getByRole('radio', { name: 'Relative' }).click();
  await expect(part).toHaveText('Relative');
  await shoot(page, 'user-menu');
  await page.goto('about:blank');
  await page.goto(home);
  await expect(part).toHaveText('Relative');
});

test('what a program says stands above a page that is loaded later, until the status has it no more', async ({ context }) => {
  const options: Options = { says: 'TURN THE PART' };
  const { page } = await mock(context, options);
  const said = page.locator('header .message');
  await expect(said).toHaveText('TURN THE PART');
  await page.reload();
  await expect(said).toHaveText('TURN THE PART');
  options.says = '';
  await expect(said).toHaveCount(0);
});

test('positions are written by the page itself where no thread draws them', async ({ context }) => {
  await context.addInitScript(() => {
    delete (HTMLCanvasElement.prototype as { transferControlToOffscreen?: unknown }).transferControlToOffscreen;
  });
  const { page } = await mock(context);
  await page.evaluate(() => (location.hash = '#/position/absolute'));
  const x = page.locator('[data-axis="X"] output.large');
  await expect(x).toBeVisible();
  await expect(x).toHaveText(/^-?\d+\.\d{3}$/);
});

test('positions are written by the page itself once the thread that draws them has failed', async ({ context }) => {
  await context.route(/worker[^/]*\.js$/, (route) => route.abort());
  const { page } = await mock(context);
  await page.evaluate(() => (location.hash = '#/position/absolute'));
  await expect(page.locator('[data-axis="X"] .plain output.large')).toBeVisible();
});
