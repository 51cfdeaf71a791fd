// A walk through the panel with a true control behind it: what somebody does at the machine, page by page.
import type { Page } from '@playwright/test';
import { expect, PASSWORDS, shoot, test } from './server';
import { pages } from './pages';
import { cutOff, enter, home, load, logIn, mode, notice, PLATE, press, release, selected, show, stands, watchFaults, whole, x } from './walk';

/** A probe of 2 mm, and deep below the reference point what its middle meets of a hole of 30 mm about X0.5 Y-0.25, on the
    lines through X0 Y0. */
const wall = (min: string, max: string) => `[[plant.blocks]]\nmin = [${min}, -100.0]\nmax = [${max}, -60.0]\n`;
test.use({
  mill: '[parameters]\n"NO4.0" = 1.0\n"NO28.7" = 1.0\nP391 = 2.0\n[plant]\n'
    + wall('14.4978, -5.0', '20.0, 5.0') + wall('-20.0, -5.0', '-13.4978, 5.0')
    + wall('-5.0, 13.7411', '5.0, 20.0') + wall('-5.0, -20.0', '5.0, -14.2411'),
});

watchFaults();

test('the first start: a language, and command is taken', async ({ page }) => {
  await page.goto('/');
  const welcome = page.getByRole('dialog');
  await expect(welcome).toContainText('Demo mill');
  await welcome.locator('[data-language="es"]').click();
  await expect(page.locator('html')).toHaveAttribute('lang', 'es');
  await welcome.locator('[data-language="en"]').click();
  await expect(welcome).toContainText('Welcome');
  await shoot(page, 'welcome');
  await page.getByTestId('welcome-start').click();
  await expect(welcome).toBeHidden();
  await expect(page.getByTestId('command')).toHaveText('In command');
  await stands(page, 'idle');
  // A machine that was switched on can be used: nobody has to look for a switch that stands at 0.
  await expect(page.locator('[data-override="SWITCH_FEED"] output')).toHaveText('100%');
  await expect(page.locator('[data-override="SWITCH_SPINDLE"] output')).toHaveText('100%');
  await expect(page.locator('[data-signal="KEY_R_25"]')).toHaveAttribute('aria-pressed', 'true');
  // Who reloads the page has command again, and is not welcomed twice.
  await page.reload();
  await expect(page.getByTestId('command')).toHaveText('In command');
  await expect(page.getByRole('dialog')).toBeHidden();
});

test('log-in: a wrong password is refused, a right one gives its level until log-out', async ({ page }) => {
  await enter(page, '', false);
  await expect(page.getByTestId('user')).toHaveText('5');
  await logIn(page, 3, 'not the password');
  await expect(page.getByRole('dialog').getByRole('alert')).not.toBeEmpty();
  await shoot(page, 'log-in');
  await page.getByTestId('password').fill(PASSWORDS[3]!);
  await page.getByTestId('log-in-go').click();
  await expect(page.getByTestId('user')).toHaveText('3');
  await page.reload();
  await expect(page.getByTestId('user')).toHaveText('3');
  await page.getByTestId('user').click();
  await page.getByTestId('log-out').click();
  await expect(page.getByTestId('user')).toHaveText('5');
});

test('the axes are homed', async ({ page }) => {
  test.setTimeout(240_000);
  await enter(page, '#/position');
  await home(page);
  await expect(page.locator('[data-axis="Z"] .machine')).toHaveText(/^−?0\.000$/);
  await shoot(page, 'home');
});

test('a hole is touched by the probe, and its middle becomes a work zero', async ({ page }) => {
  test.setTimeout(240_000);
  await enter(page, '#/position');
  await home(page);
  await mode(page, 'KEY_AUTO', 'Automatic');
  await show(page, 'settings/probe');
  const field = async (label: string, value: string) => {
    const input = page.locator('.card', { hasText: 'Work zero by probe' }).getByLabel(label, { exact: true });
    await input.fill(value);
    await input.press('Enter');
  };
  await field('Diameter', '30');
  await field('Height of touch', '-70');
  await page.locator('.card', { hasText: 'Work zero by probe' }).getByLabel('System').selectOption('G57');
  await page.getByTestId('measure').click();
  await expect(page.getByTestId('probe')).toHaveAttribute('data-ready', 'true');
  // Nothing moves before cycle start.
  await stands(page, 'idle');
  await press(page, 'KEY_START');
  await stands(page, 'running');
  await shoot(page, 'probe-running');
  const measured = page.getByTestId('measured');
  await expect(measured).toContainText('Stored to G57', { timeout: 120_000 });
  await expect(measured.locator('strong')).toHaveText(['X 0.500', 'Y −0.250']);
  await expect(measured).toContainText('30.000');
  await expect(page.getByTestId('probe')).toHaveAttribute('data-ready', 'false');
  await shoot(page, 'probe-measured');
  await show(page, 'settings/zeros');
  await expect(page.locator('[data-page="settings"]')).toContainText('G57');
  // One that meets nothing where the hole should be tells so, and stores nothing.
  await show(page, 'settings/probe');
  await field('Height of touch', '-40');
  await page.getByTestId('measure').click();
  await expect(page.getByTestId('probe')).toHaveAttribute('data-ready', 'true');
  await press(page, 'KEY_START');
  await stands(page, 'alarm', 120_000);
  await expect(page.getByTestId('alarm-strip')).toContainText('FC-1472');
  await expect(measured.locator('strong')).toHaveText(['X 0.500', 'Y −0.250']);
  await page.getByTestId('reset').click();
  await stands(page, 'idle');
});

test('a program is brought as a file, and its path is drawn', async ({ page }) => {
  await enter(page);
  await load(page, 'O1234', PLATE);
  await expect(page.locator('[data-program="O1234"]')).toContainText('PLATE');
  await expect(page.locator('.preview .cm-content')).toContainText('G21 G90 G54 G17');
  await shoot(page, 'directory');
  await show(page, 'graphics');
  const drawing = page.locator('.graphics');
  await expect(drawing).toHaveAttribute('data-loaded', 'true');
  expect(Number(await drawing.getAttribute('data-points'))).toBeGreaterThan(100);
  await expect(page.locator('.facts')).toContainText('120.0');
  await page.getByTestId('time').fill('10');
  await expect(page.locator('.times')).toContainText('0:10');
  await page.locator('[data-view="top"]').click();
  await shoot(page, 'graphics');
});

test('a program runs, is held, goes on faster, and is watched while it runs', async ({ page }) => {
  test.setTimeout(180_000);
  await enter(page);
  await load(page, 'O1234', PLATE);
  await show(page, 'position');
  await whole(page);
  await press(page, 'KEY_START');
  await stands(page, 'running');
  const from = await x(page);
  await expect.poll(() => x(page)).not.toBe(from);

  await press(page, 'KEY_HOLD');
  await stands(page, 'held');
  await expect(page.getByTestId('feed')).toHaveText('0');
  let at = await x(page);
  await shoot(page, 'hold');

  // Back along the path, and forward again with cycle start.
  await show(page, 'program/run');
  await page.getByTestId('retrace').click();
  await expect(page.getByTestId('retraced')).toBeVisible();
  await show(page, 'position');
  await expect.poll(() => x(page)).not.toBe(at);
  await press(page, 'KEY_HOLD');
  await press(page, 'KEY_START');
  await stands(page, 'running');
  await press(page, 'KEY_HOLD');
  await stands(page, 'held');
  await expect(page.getByTestId('feed')).toHaveText('0');
  at = await x(page);

  // The override is turned while it is held, and holds from the next start on.
  const feed = page.locator('[data-override="SWITCH_FEED"]');
  await expect(feed.locator('output')).toHaveText('100%');
  for (const percent of [110, 120, 130]) {
    await feed.getByRole('button').last().click();
    await expect(feed.locator('output')).toHaveText(`${percent}%`);
  }
  expect(await x(page)).toBe(at);
  await press(page, 'KEY_START');
  await stands(page, 'running');
  await expect.poll(async () => Number(await page.getByTestId('feed').textContent()), { timeout: 30_000, intervals: [30] }).toBeGreaterThan(1250);

  await show(page, 'program/run');
  await expect(page.locator('.nc-active')).toBeVisible();
  await shoot(page, 'run');
  await show(page, 'graphics');
  await expect(page.locator('.graphics')).toHaveAttribute('data-loaded', 'true');
  await expect.poll(async () => Number(await page.getByTestId('time').inputValue())).toBeGreaterThan(8);
  await shoot(page, 'graphics-running', 'panel');
  await stands(page, 'idle', 90_000);
});

test('a run that was broken off is taken up behind a plan of what is done first', async ({ page }) => {
  test.setTimeout(240_000);
  await enter(page, '#/position');
  await home(page);
  await load(page, 'O1234', PLATE);
  await show(page, 'position');
  await whole(page);
  await press(page, 'KEY_START');
  await stands(page, 'running');
  await show(page, 'program/run');
  await expect(page.getByTestId('block')).toContainText('G1 X90.', { timeout: 60_000 });
  await expect(page.getByTestId('next')).toContainText('G3 X100. Y0 R10.');
  await page.getByTestId('reset').click();
  await stands(page, 'idle');
  // Whoever looks at the alarms is told too.
  await show(page, 'alarms');
  await expect(page.getByTestId('interrupted')).toContainText('O1234');
  await page.getByTestId('interrupted').getByRole('button').click();
  const plan = page.getByTestId('restart');
  await expect(plan).toHaveAttribute('data-ready', 'false');
  await plan.getByRole('checkbox').first().check();
  await page.getByTestId('restart-search').click();
  await expect(plan).toHaveAttribute('data-ready', 'true', { timeout: 30_000 });
  await expect(plan).toContainText('cycle start takes O1234 up at line');
  // The spindle stood still at reset: it is started first, and the axes go where the block begins.
  await expect(page.getByTestId('restart-differences')).toContainText('Spindle');
  await expect(plan.locator('dd').filter({ hasText: 'M03' })).toBeVisible();
  await expect(plan.locator('ol li').first()).toContainText(/[XYZ] /);
  await expect(page.getByTestId('restart-missing')).toHaveCount(0);
  // Who types what differs sees it beside what he types.
  await mode(page, 'KEY_MDI', 'Manual data input');
  await show(page, 'program/mdi');
  await expect(page.getByTestId('restart-differences')).toContainText('Spindle');
  await page.getByLabel('One block').fill('M3 S3000');
  await page.getByLabel('One block').press('Enter');
  await shoot(page, 'mdi-differences');
  await press(page, 'KEY_START');
  await expect(page.getByTestId('mdi-values')).toContainText('S3000');
  await expect(page.locator('.mdi tr', { hasText: 'Spindle' })).toHaveCount(0);
  // A cycle start before its block is done is lost.
  await stands(page, 'idle');
  await mode(page, 'KEY_AUTO', 'Automatic');
  await show(page, 'program/run');
  await shoot(page, 'restart');
  await press(page, 'KEY_START');
  await stands(page, 'running');
  await expect(plan).toHaveCount(0);
  await expect.poll(async () => page.getByTestId('block').textContent(), { timeout: 60_000 }).toContain('G3');
  await page.getByTestId('reset').click();
  await stands(page, 'idle');
});

test('a waveform is recorded whole, at once or from its trigger on', async ({ page }) => {
  await enter(page, '#/diagnosis/waveform');
  const samples = async () => Number(await page.getByTestId('samples').getAttribute('data-samples'));
  const record = page.getByTestId('record');
  // Live: feed and speed, then the axes again.
  const live = page.locator('.u-legend');
  await page.getByRole('radio', { name: 'F and S' }).click();
  await expect(live).toContainText('S');
  await page.getByRole('radio', { name: 'Speed' }).click();
  await expect(live).toContainText('X');
  await record.click();
  // 2 s of 1 ms: more than one answer may have.
  await expect.poll(samples, { timeout: 40_000 }).toBeGreaterThanOrEqual(2000);
  await expect(record).toHaveText('Record each period');
  await shoot(page, 'waveform');
  await page.getByRole('radio', { name: 'At a level' }).click();
  await page.getByLabel('Level', { exact: true }).fill('1000000');
  await page.getByLabel('Level', { exact: true }).press('Enter');
  await record.click();
  // It waits for what does not come, until somebody ends it.
  await expect(record).toHaveText('End');
  await expect(page.getByText('Recording …')).toBeVisible();
  await record.click();
  await expect(record).toHaveText('Record each period');
});

test('a work zero is found by touching four sides', async ({ page }) => {
  await enter(page, '#/settings/centring');
  await page.getByRole('radio', { name: 'Rectangle' }).click();
  await page.getByLabel('System').selectOption('G59');
  const rows = page.locator('[data-taken]');
  await expect(page.getByTestId('touch')).toHaveText('Take the point');
  for (const point of [1, 2, 3, 4]) {
    await page.getByTestId('touch').click();
    await expect(rows).toHaveCount(point);
  }
  // The axes stood still between the touches: the middle is where they stand.
  const here = (await rows.nth(3).locator('td').first().textContent())!.trim();
  await expect(page.locator('.result strong').first()).toHaveText(`X ${here}`);
  await shoot(page, 'centring');
  await page.getByTestId('set-zero').click();
  await expect(notice(page)).toContainText('The zero of G59 is set');
  await expect(rows).toHaveCount(0);
});

test('an alarm tells its place and its remedy, and is reset', async ({ page }) => {
  await enter(page);
  await load(page, 'O1300', 'O1300 (BY NOTHING)\nG21 G90 G54\n#1=0\n#2=1/#1\nM30\n');
  await press(page, 'KEY_START');
  await stands(page, 'alarm');
  await page.getByTestId('alarm-strip').click();
  const alarm = page.getByTestId('alarm').first();
  await expect(alarm).toContainText('O1300');
  await expect(alarm.getByTestId('remedy')).toContainText(/\w{3}.*\w{3}/);
  const number = (await alarm.locator('.code').first().textContent())!;
  await shoot(page, 'alarm');
  // It leads to its block.
  await alarm.getByRole('button', { name: 'To the program' }).click();
  await expect(page).toHaveURL(/#\/program\/edit\/O1300$/);
  await expect(page.locator('.cm-activeLine.cm-line')).toHaveText('#2=1/#1');
  await show(page, 'alarms');
  await alarm.getByRole('button', { name: 'Reset' }).click();
  await stands(page, 'idle');
  await expect(page.getByTestId('alarm')).toHaveCount(0);
  await show(page, 'alarms/history');
  await expect(page.locator('[data-page="alarms"] tbody tr').first()).toContainText(number);
});

test('an alarm of what was typed in MDI leads there', async ({ page }) => {
  await enter(page, '#/program/mdi');
  await mode(page, 'KEY_MDI', 'Manual data input');
  await page.locator('.mdi .cm-content').click();
  await page.keyboard.press('Control+a');
  await page.keyboard.type('#1=0');
  await page.keyboard.press('Enter');
  await page.keyboard.type('#2=1/#1');
  await page.getByTestId('mdi-send').click();
  await press(page, 'KEY_START');
  await stands(page, 'alarm');
  await page.getByTestId('alarm-strip').click();
  const alarm = page.getByTestId('alarm').first();
  await expect(alarm).toContainText('MDI');
  await alarm.getByRole('button', { name: 'To the program' }).click();
  await expect(page).toHaveURL(/#\/program\/mdi$/);
  await show(page, 'alarms');
  await alarm.getByRole('button', { name: 'Reset' }).click();
  await stands(page, 'idle');
});

test('a fault is underlined as it is typed, and gone when it is put right', async ({ page }) => {
  await enter(page);
  await load(page, 'O1400', 'O1400\nG21\nG90 G54 M3 S1000\nG1 X10. F300\nM30\n');
  await show(page, 'program/edit/O1400');
  const text = page.locator('.cm-content');
  await text.locator('.cm-line', { hasText: 'X10.' }).click();
  await page.keyboard.press('End');
  await page.keyboard.press('Enter');
  await page.keyboard.type('G1 X[1+2');
  await expect(page.locator('.cm-lintRange-error').first()).toBeVisible();
  await expect(page.getByTestId('findings').locator('.code')).not.toBeEmpty();
  await expect(page.getByTestId('findings')).toContainText('5:');
  await expect(notice(page)).toHaveCount(0);
  await shoot(page, 'edit', 'panel-edit');
  await page.keyboard.type(']');
  await expect(page.locator('.cm-lintRange-error')).toHaveCount(0);
  await expect(page.getByTestId('findings')).toHaveCount(0);
  await page.getByTestId('save').click();
  await expect(page.getByTestId('save')).toBeDisabled();
  await page.reload();
  await expect(text).toContainText('G1 X[1+2]');
});

test('a tool offset is entered and kept', async ({ page }) => {
  await enter(page, '#/offsets/tools');
  const length = page.locator('[data-offset="5"] input').first();
  await expect(length).toHaveValue('0.000');
  await length.fill('-102.35');
  await length.press('Enter');
  await expect(page.locator('[data-offset="5"] .muted')).toHaveText('−102.350');
  await page.reload();
  await expect(length).toHaveValue('-102.350');
  await shoot(page, 'offsets');
  // What is typed as no number is not taken.
  await length.fill('12..5');
  await expect(length).toHaveAttribute('aria-invalid', 'true');
  await length.press('Escape');
  await expect(length).toHaveValue('-102.350');
  await show(page, 'alarms/log');
  await expect(page.getByTestId('log')).toContainText('-102.35');
});

test('a parameter is refused without the right, and changed with it', async ({ page }) => {
  await enter(page, '#/offsets/parameters');
  await mode(page, 'KEY_MDI', 'Manual data input');
  await page.getByTestId('parameter-search').fill('P98');
  await page.locator('[data-parameter="P98"]').click();
  const field = page.getByTestId('parameter').locator('input');
  await expect(page.getByTestId('parameter')).toContainText('Needs level 3');
  await expect(page.getByTestId('parameter')).toContainText('Turn the parameter switch on first');
  await page.getByTestId('parameter-switch').click();
  await expect(page.getByTestId('parameter-switch')).toHaveAttribute('aria-pressed', 'true');
  await page.getByTestId('accept-parameter-switch').click();
  await expect(page.getByTestId('accept-parameter-switch')).toHaveCount(0);
  const before = await field.inputValue();
  const after = String(Number(before) / 2);
  await field.fill(after);
  await field.press('Enter');
  await expect(notice(page).first()).toContainText('FC-');
  await expect(field).toHaveValue(before);
  await shoot(page, 'parameter-refused');

  await logIn(page, 3);
  await expect(page.getByTestId('user')).toHaveText('3');
  await field.fill(after);
  await field.press('Enter');
  await expect(page.locator('[data-parameter="P98"]')).toHaveClass(/differs/);
  expect(Number(await field.inputValue())).toBe(Number(after));
  await page.reload();
  await page.getByTestId('parameter-search').fill('P98');
  await expect(page.locator('[data-parameter="P98"]')).toHaveClass(/differs/);
  await shoot(page, 'parameter-changed');
  // The help has the value that it has now, and says in words what the parameter is for.
  await show(page, 'help/search');
  await page.getByTestId('help-search').fill('P98');
  await expect(page.locator('[data-found="parameter P98"]')).toContainText(/\w{3} \w{3}/);
  await page.locator('[data-found="parameter P98"]').click();
  await expect(page.getByTestId('help-detail').locator('dd').filter({ hasText: new RegExp(`^${after} `) })).toBeVisible();
  await show(page, 'offsets/parameters');
  await page.getByTestId('parameter-switch').click();
  await expect(page.getByTestId('parameter-switch')).toHaveAttribute('aria-pressed', 'false');
  await show(page, 'alarms/log');
  await expect(page.getByTestId('log')).toContainText('P98');
});

test('a point of a pitch table is set and kept', async ({ page }) => {
  await enter(page, '#/offsets/pitch');
  await mode(page, 'KEY_MDI', 'Manual data input');
  const point = page.getByTestId('pitch-points').getByLabel('Y 2', { exact: true });
  await page.getByRole('radio', { name: 'Y' }).click();
  await expect(point).toHaveValue('0.0000');
  await point.fill('0.0035');
  await point.press('Enter');
  await expect(notice(page).first()).toContainText('FC-');
  await expect(point).toHaveValue('0.0000');
  await logIn(page, 3);
  await expect(page.getByTestId('user')).toHaveText('3');
  await point.fill('0.0035');
  await point.press('Enter');
  await expect(point).toHaveValue('0.0035');
  await page.reload();
  await page.getByRole('radio', { name: 'Y' }).click();
  await expect(point).toHaveValue('0.0035');
  await shoot(page, 'pitch');
});

test('the ladder shows where power flows', async ({ page }) => {
  await enter(page, '#/plc');
  await mode(page, 'KEY_AUTO', 'Automatic');
  await page.getByTestId('plc-search').fill('KEY_START');
  const start = page.getByTestId('ladder').locator('g.contact', { hasText: 'KEY_START' }).first();
  await expect(start).toBeVisible();
  await expect(start).not.toHaveClass(/conducts/);
  const key = page.locator('[data-signal="KEY_START"]');
  await key.hover();
  await page.mouse.down();
  await expect(start).toHaveClass(/conducts/);
  await shoot(page, 'plc');
  await page.mouse.up();
  await expect(start).not.toHaveClass(/conducts/);
});

test('language and theme are switched, and kept', async ({ page }) => {
  await enter(page, '#/position', false);
  await page.getByTestId('user').click();
  const titles: Record<string, string> = { zh: '位置', ru: 'Положение', es: 'Posición', tr: 'Konum', en: 'Position' };
  for (const [language, title] of Object.entries(titles)) {
    await page.getByTestId('languages').locator(`[data-language="${language}"]`).click();
    await expect(page.locator('nav a').first()).toHaveText(title);
    await expect(page.locator('html')).toHaveAttribute('lang', language);
    await shoot(page, `language-${language}`);
  }
  await page.getByTestId('languages').locator('[data-language="es"]').click();
  await page.getByRole('radio', { name: 'Claro' }).click();
  await expect(page.locator('html')).toHaveAttribute('data-theme', 'light');
  await page.reload();
  await expect(page.locator('html')).toHaveAttribute('data-theme', 'light');
  await expect(page.locator('nav a').first()).toHaveText('Posición');
  await shoot(page, 'light');
});

test('of two browsers one commands; the other watches, may stop, and is handed command', async ({ page, browser, server }) => {
  await enter(page, '#/position');
  const second = await browser.newContext({ baseURL: server.url, viewport: { width: 1366, height: 820 }, locale: 'en-GB' });
  try {
    const other = await second.newPage();
    await enter(other, '#/position', false);
    await expect(other.getByTestId('command')).toHaveText('Watching');
    await expect(other.locator('.banner')).toContainText('Somebody else is in command');
    await expect(other.locator('[data-signal="KEY_START"]')).toBeDisabled();
    await expect(other.locator('[data-signal="KEY_X+"]')).toBeDisabled();
    await press(other, 'KEY_HOLD');
    await expect(notice(other)).toHaveCount(0);
    // Command is not taken away from somebody: he is asked, and may decline; what was asked can be taken back.
    await other.getByTestId('command').click();
    await expect(other.getByTestId('command')).toHaveText('Asked for command');
    await expect(page.getByTestId('asks')).toContainText(/Connection \d+ at 127\.0\.0\.1 \(Operator\) asks for command/);
    await shoot(page, 'asked-for-command');
    await page.getByTestId('decline').click();
    await expect(page.getByTestId('asks')).toHaveCount(0);
    await expect(notice(other)).toContainText('Command was not handed over');
    await expect(other.getByTestId('command')).toHaveText('Watching');
    await expect(page.getByTestId('command')).toHaveText('In command');
    // Not again at once.
    await other.getByTestId('ask').click();
    await expect(other.getByText('You asked a moment ago')).toBeVisible();
    await expect(page.getByTestId('asks')).toHaveCount(0);
    await shoot(other, 'watching');
    // Who watches sees what is done, and stops it.
    await mode(page, 'KEY_JOG', 'Jog');
    await expect(other.getByTestId('mode')).toHaveText('Jog');
    await other.getByTestId('emergency').click();
    await stands(page, 'emergency');
    await release(page);
    await page.getByTestId('reset').click();
    await stands(other, 'idle');
    // Asked for and handed over.
    await expect(async () => {
      await other.getByTestId('ask').click();
      await expect(other.getByTestId('withdraw')).toBeVisible({ timeout: 500 });
    }).toPass();
    await page.getByTestId('hand-over').click();
    await expect(other.getByTestId('command')).toHaveText('In command');
    await expect(other.getByText('Command was handed over to you')).toBeVisible();
    await expect(page.getByTestId('command')).toHaveText('Watching');
    await expect(page.locator('[data-signal="KEY_X+"]')).toBeDisabled();
    await expect(other.locator('[data-signal="KEY_X+"]')).toBeEnabled();
  } finally {
    await second.close();
  }
  // Who goes leaves command to others.
  await expect(page.getByTestId('command')).toHaveText('Take command');
});

/** Both shades at the smallest, at a large and at the largest screen: nothing is wider than the screen or cut off. */
for (const [theme, width, height] of [
  ['light', 800, 600],
  ['dark', 1920, 1080],
  ['light', 3840, 2160],
] as const) {
  test(`pages in ${theme} at ${width} × ${height}`, async ({ page }) => {
    await enter(page);
    if ((await selected(page).filter({ hasText: 'O1234' }).count()) === 0) await load(page, 'O1234', PLATE);
    // On a small screen the machine panel is called up when it is needed.
    const panel = width > 1100;
    await page.evaluate((prefs) => localStorage.setItem('ferrocut.panel', JSON.stringify(prefs)), { welcomed: true, language: 'en', theme, panel });
    await page.setViewportSize({ width, height });
    await page.reload();
    await expect(page.locator('html')).toHaveAttribute('data-theme', theme);
    await expect(page.getByTestId('command')).toHaveText('In command');
    const shown = ['position', 'program/run', 'graphics', 'cycles', 'offsets/tools', 'settings/probe', 'diagnosis/waveform', 'plc', 'help'];
    const all = Object.entries(pages).flatMap(([name, tabs]) => (tabs.length ? tabs.map((tab) => `${name}/${tab}`) : [name]));
    for (const hash of [...shown, ...all.filter((one) => !shown.includes(one))]) {
      await show(page, hash);
      await expect(page.locator('main')).not.toContainText('Loading');
      expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth), hash).toBeLessThanOrEqual(0);
      await expect.poll(() => cutOff(page), { message: hash }).toEqual([]);
      if (shown.includes(hash)) await shoot(page, `${theme}-${width}-${hash.replace('/', '-')}`);
    }
  });
}

/** What the panel says on a page, without the programs and ladders that it shows: those are no texts of its own. */
const said = (page: Page) =>
  page.locator('main').evaluate((main) => {
    const copy = main.cloneNode(true) as HTMLElement;
    for (const shown of copy.querySelectorAll('.cm-content')) shown.remove();
    return copy.textContent ?? '';
  });

for (const [name, tabs] of Object.entries(pages)) {
  test(`the page ${name} shows itself whole`, async ({ page }) => {
    await enter(page);
    // The one before has brought it already, unless this is the first.
    if ((await selected(page).filter({ hasText: 'O1234' }).count()) === 0) await load(page, 'O1234', PLATE);
    await expect(notice(page)).toHaveCount(0);
    for (const tab of tabs.length ? tabs : ['']) {
      await show(page, tab ? `${name}/${tab}` : name);
      // All that it asks for has come, and nothing was refused.
      await expect(page.locator('main')).not.toContainText('Loading');
      await expect(page.locator('.notice.warning')).toHaveCount(0);
      // No text lacks: a key that has none shows itself.
      await expect.poll(() => said(page)).not.toMatch(new RegExp(`\\b${name}\\.[a-z_]+\\b`));
      await shoot(page, tab ? `page-${name}-${tab}` : `page-${name}`);
    }
  });
}

test('blocks of MDI that a reset has deleted are not shown any more', async ({ page }) => {
  await enter(page, '#/program/mdi');
  await mode(page, 'KEY_MDI', 'Manual data input');
  const text = page.locator('.mdi .cm-content');
  const state = page.getByTestId('mdi-state');
  await text.click();
  await page.keyboard.press('Control+A');
  await page.keyboard.type('G0 X1.');
  await page.getByTestId('mdi-send').click();
  await expect(state).toHaveText('Cycle start runs these blocks');
  await page.getByTestId('reset').click();
  await expect(state).toHaveText('The control has no blocks to run');
  await expect(text).toHaveText('');
});
