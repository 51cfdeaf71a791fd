// The cycle editor: a pocket filled in, put right, simulated and put into a program; positions, a profile from a drawing.
import type { Form } from '../src/lib/api/cycles.ts';
import { kept, read, write } from './forms';
import { expect, PASSWORDS, shoot, test, type Page } from './server';
import { say } from './walk';

const PROGRAM = 'O7101';

/** A program in the memory, stored over a connection of its own. */
const stored = (page: Page, text: string) => say(page, { do: 'take_command' }, { do: 'store', program: PROGRAM, text }, { do: 'give_command' });

async function openGroupOf(page: Page, cycle: string): Promise<void> {
  for (const group of await page.locator('nav [data-group]').all()) {
    await group.click();
    await expect(group).toHaveAttribute('aria-selected', 'true');
    if (await page.locator(`nav [data-cycle="${cycle}"]`).isVisible()) return;
  }
}

async function open(page: Page, cycle: string): Promise<void> {
  await page.goto('/#/cycles');
  const item = page.locator(`nav [data-cycle="${cycle}"]`);
  await item.waitFor({ state: 'attached' });
  // On a narrow page the cycles of one group stand there.
  if (!(await item.isVisible())) await openGroupOf(page, cycle);
  await item.click();
  await expect(page.locator(`.form[data-cycle="${cycle}"]`)).toBeVisible();
}

const state = (page: Page) => page.locator('p.state');
const written = (page: Page) => expect(state(page)).toHaveAttribute('data-ready', 'true');
const put = (page: Page, field: string, value: string) => page.locator(`[id="field-${field}"]`).fill(value);

test.beforeEach(async ({ page }) => {
  await page.addInitScript(() => {
    // The first start has a page of its own.
    localStorage.setItem('ferrocut.panel', JSON.stringify({ welcomed: true, panel: false, language: 'en', theme: 'dark' }));
  });
  // Mills of 8 mm: as delivered the table has diameters (40#7).
  await page.goto('/');
  const mills = [1, 2, 3, 4].map((number) => ({ do: 'set_offset', number, radius: 8, radius_wear: 0 }));
  await say(page, { do: 'take_command' }, ...mills, { do: 'give_command' });
  // What a test opens is a page that begins anew.
  await page.goto('about:blank');
});

test('what is written in a drawing can be read, however small the drawing is', async ({ page }) => {
  await page.setViewportSize({ width: 1024, height: 700 });
  for (const cycle of ['G281', 'G284', 'G287', 'G299']) {
    await open(page, cycle);
    const heights = () => page.locator('.section text').evaluateAll((texts) => texts.map((text) => (text as SVGGraphicsElement).getBBox().height * (text as SVGGraphicsElement).getScreenCTM()!.a));
    await expect.poll(async () => Math.min(...(await heights())), { message: cycle }).toBeGreaterThan(12);
  }
});

test('beside the machine panel a group is opened, with the cycle of it that was used last', async ({ page }) => {
  await page.addInitScript(() => localStorage.setItem('ferrocut.panel', JSON.stringify({ welcomed: true, panel: true, language: 'en', theme: 'dark' })));
  await page.goto('/#/cycles');
  const group = (name: string) => page.locator(`nav [data-group="${name}"]`);
  const cycle = (id: string) => page.locator(`nav [data-cycle="${id}"]`);
  await expect(group('pockets')).toHaveAttribute('aria-selected', 'true');
  await expect(cycle('G287')).toBeInViewport();
  await cycle('G288').click();
  await group('bosses').click();
  await expect(page.locator('.form[data-cycle="G291"]')).toBeVisible();
  await expect(cycle('G292')).toBeInViewport();
  await expect(cycle('G288')).toBeHidden();
  await group('pockets').click();
  await expect(page.locator('.form[data-cycle="G288"]')).toBeVisible();
});

test('what a measure says stands beside its line, and not on it', async ({ page }) => {
  await open(page, 'G287');
  for (const field of ['L', 'H']) {
    const apart = await page.locator(`.plan [data-field="${field}"]`).evaluate((measure) => {
      const [line, text] = ['path.line', 'text'].map((part) => measure.querySelector<SVGGraphicsElement>(part)!.getBBox());
      return { aside: text!.x - (line!.x + line!.width), above: line!.y - (text!.y + text!.height), high: text!.height };
    });
    // Arrows and what letters have below their line may meet.
    expect(field === 'H' ? apart.aside : apart.above, field).toBeGreaterThan(-0.3 * apart.high);
  }
});

test('a pocket is filled in, simulated and put into a program', async ({ page }) => {
  await page.goto('/');
  await stored(page, `${PROGRAM}\nG54 G90\nG0 Z50.\n(HERE)\nM30\n`);
  await page.goto(`/#/program/edit/${PROGRAM}`);
  await expect(page.locator('.cm-content')).toContainText('HERE');
  await page.locator('.cm-line', { hasText: 'HERE' }).click();

  await open(page, 'G287');
  await put(page, 'L', '60');
  // What the field means stands out in the drawing, with its value.
  const measure = page.locator('.plan [data-field="L"]');
  await expect(measure).toHaveClass(/focus/);
  await expect(measure).toContainText('60');
  await page.locator('[id="field-corner"]').selectOption('round');
  await put(page, 'r', '8');

  // A step wider than the tool is told at its field, and nothing can be inserted.
  await put(page, 'rough.step', '50');
  const wrong = page.locator('.field[data-name="rough.step"] .finding');
  await expect(wrong).toContainText('FC-');
  await expect(page.getByTestId('insert')).toBeDisabled();
  await put(page, 'rough.step', '5');
  await expect(wrong).toHaveCount(0);
  await written(page);
  await shoot(page, 'cycles-form');

  await page.getByTestId('simulate').click();
  const simulation = page.getByTestId('simulation');
  await expect.poll(async () => Number(await simulation.getAttribute('data-points'))).toBeGreaterThan(200);
  expect(Number(await simulation.getAttribute('data-seconds'))).toBeGreaterThan(30);
  await simulation.locator('input[type=range]').fill('0');
  await expect(simulation).toHaveAttribute('data-time', '0');
  await simulation.getByRole('button', { name: 'Run' }).click();
  await expect.poll(async () => Number(await simulation.getAttribute('data-time'))).toBeGreaterThan(3);
  await shoot(page, 'cycles-simulation', 'panel-cycles');

  await page.getByTestId('insert').click();
  const text = page.locator('.cm-content');
  await expect(text).toContainText('G287 RECTANGULAR POCKET');
  // Behind the line of the cursor, before the end.
  await expect(page.locator('.cm-activeLine, .cm-line').filter({ hasText: 'G17 G21 G90' }).first()).toBeVisible();
  // The check of the whole is through, and has found nothing.
  const checked = page.waitForResponse((response) => response.url().includes('/api/check'));
  await page.locator('.cm-content').press('End');
  await page.keyboard.press('Space');
  await checked;
  await expect(page.getByTestId('findings')).toHaveCount(0);
  await shoot(page, 'cycles-inserted');
});

test('a cycle of a program is opened again, changed, and takes its own place', async ({ page }) => {
  await page.goto('/');
  await stored(page, `${PROGRAM}\nG54 G90\nG0 Z50.\n(HERE)\nM30\n`);
  await page.goto(`/#/program/edit/${PROGRAM}`);
  await page.locator('.cm-line', { hasText: 'HERE' }).click();
  await open(page, 'G287');
  await put(page, 'L', '60');
  await page.locator('[data-figure="POINTS"]').click();
  await put(page, 'rough.step', '5');
  await written(page);
  await page.getByTestId('insert').click();
  const text = page.locator('.cm-content');
  await expect(text).toContainText('L=60');

  // Other values stand in the form meanwhile, as of another part.
  await open(page, 'G288');
  await open(page, 'G287');
  await put(page, 'L', '33');
  await page.goto(`/#/program/edit/${PROGRAM}`);
  await page.locator('.cm-line', { hasText: 'L=60' }).click();
  await page.getByTestId('to-cycle').click();
  await expect(page.locator('.form')).toContainText(`From ${PROGRAM}, lines 5 to`);
  await expect(page.locator('[id="field-L"]')).toHaveValue('60');
  await expect(page.locator('[data-figure="POINTS"]')).toHaveAttribute('aria-pressed', 'true');
  await expect(page.getByTestId('insert')).toHaveText('Replace in the program');
  await put(page, 'L', '44');
  await written(page);
  await shoot(page, 'cycles-opened');
  await page.getByTestId('insert').click();
  await expect(text).toContainText('L=44');
  await expect(text).not.toContainText('L=60');
  const lines = () => page.locator('.cm-line').allTextContents();
  await text.press('Control+Home');
  await expect.poll(async () => (await lines()).slice(0, 5)).toEqual([PROGRAM, 'G54 G90', 'G0 Z50.', '(HERE)', '(G287 RECTANGULAR POCKET)']);
  await text.press('Control+End');
  await expect.poll(async () => (await lines()).slice(-3)).toEqual(['(END G287)', 'M30', '']);
  // What is inserted next is a new one again.
  await page.goto('/#/cycles');
  await expect(page.getByTestId('insert')).toHaveText('Insert into the program');
});

test('where the machine stands is shown, and taken over by a field', async ({ page }) => {
  await open(page, 'G287');
  await expect(page.getByTestId('stands')).toContainText('X0.000');
  await expect(page.getByTestId('stands')).toBeInViewport();
  await put(page, 'X', '17');
  await page.locator('.field[data-name="X"]').getByRole('button').click();
  await expect(page.locator('[id="field-X"]')).toHaveValue('0');
});

test('only the text of what stands in the form is put into a program, which is told of codes that it loses', async ({ page }) => {
  await page.goto('/');
  await stored(page, `${PROGRAM}\nG54 G90 G20\nG91\n(HERE)\nM30\n`);
  await page.goto(`/#/program/edit/${PROGRAM}`);
  await page.locator('.cm-line', { hasText: 'HERE' }).click();
  await open(page, 'G287');
  await put(page, 'L', '60');
  await put(page, 'rough.step', '5');
  await written(page);
  const insert = page.getByTestId('insert');
  await expect(insert).toBeEnabled();
  await page.getByTestId('simulate').click();
  const simulation = page.getByTestId('simulation');
  await expect.poll(async () => Number(await simulation.getAttribute('data-points'))).toBeGreaterThan(100);
  await expect(simulation).toHaveAttribute('data-stale', 'false');

  // The answer is on its way, then it does not come at all.
  let fail = () => {};
  const failed = new Promise<void>((resolve) => (fail = resolve));
  await page.route(/\/api\/cycle\?/, async (route) => {
    await failed;
    await route.abort();
  });
  await put(page, 'L', '64');
  await expect(insert).toBeDisabled();
  await expect(page.getByRole('button', { name: 'Copy the text' })).toBeDisabled();
  await expect(state(page)).toHaveAttribute('data-ready', 'false');
  await expect(simulation).toHaveAttribute('data-stale', 'true');
  await page.waitForTimeout(500);
  fail();
  await expect(state(page)).toContainText('could not be written');
  await expect(insert).toBeDisabled();
  await page.unroute(/\/api\/cycle\?/);
  await put(page, 'L', '66');
  await written(page);
  await expect(insert).toBeEnabled();

  await insert.click();
  const lost = page.getByTestId('codes-lost');
  await expect(lost).toContainText('G20 G91 no longer holds');
  await shoot(page, 'cycles-codes-lost');
  await lost.getByRole('button', { name: 'Close' }).click();
  await expect(lost).toHaveCount(0);
});

test('holes lie on a grid and are the control\'s own cycle', async ({ page }) => {
  await open(page, 'G281');
  await page.locator('[data-figure="GRID"]').click();
  await put(page, 'positions.NX', '4');
  await written(page);
  await page.getByRole('radio', { name: 'Text' }).click();
  await expect(page.locator('pre')).toContainText('G98 G81');
  await expect(page.locator('pre')).toHaveAttribute('data-expanded', 'false');
  await expect(page.locator('pre')).toContainText('X60.0 Y20.0');
});

test('a pocket is drawn from a DXF with its island', async ({ page }) => {
  const entities = [
    ['LINE', 10, 0, 20, 0, 11, 90, 21, 0],
    ['LINE', 10, 90, 20, 0, 11, 90, 21, 60],
    ['LINE', 10, 90, 20, 60, 11, 0, 21, 60],
    ['LINE', 10, 0, 20, 60, 11, 0, 21, 0],
    ['CIRCLE', 10, 45, 20, 30, 40, 10],
  ];
  const body = entities.map(([name, ...pairs]) => `0\n${name}\n8\n0\n${pairs.join('\n')}\n`).join('');
  const dxf = `0\nSECTION\n2\nENTITIES\n${body}0\nENDSEC\n0\nEOF\n`;
  await open(page, 'P2D');
  await page.locator('.editor input[type=file]').setInputFiles({ name: 'plate.dxf', mimeType: 'image/vnd.dxf', buffer: Buffer.from(dxf) });
  await expect(page.locator('.editor .contour')).toHaveCount(2);
  await written(page);
  await page.getByTestId('simulate').click();
  await expect.poll(async () => Number(await page.getByTestId('simulation').getAttribute('data-points'))).toBeGreaterThan(200);
  await shoot(page, 'cycles-profile');
});

test('a contour is drawn of lines and arcs, with corners, by pointer and by key', async ({ page }) => {
  await open(page, 'G294');
  const elements = page.locator('.elements li');
  const drawing = page.getByRole('group', { name: 'Profile' });
  /** Touches the drawing at a place of the profile. */
  const touch = async (x: number, y: number) => {
    const at = await drawing.evaluate(
      (svg, [x, y]) => {
        const { x: left, y: top } = new DOMPoint(x, -y).matrixTransform((svg as SVGSVGElement).getScreenCTM()!);
        return [left, top] as const;
      },
      [x, y] as const,
    );
    await page.mouse.click(...at);
  };
  await expect(elements).toHaveText([/Start\s*X -40.000 Y -25.000/, /Line\s*X 40.000 Y -25.000 · R 8/, /Line\s*X 40.000 Y 25.000 · R 8/, /Line\s*X -40.000 Y 25.000/]);
  await drawing.scrollIntoViewIfNeeded();
  await page.getByRole('radio', { name: 'Line' }).click();
  await touch(-40.3, 0.2);
  // It is drawn to the grid.
  await expect(elements.nth(4)).toHaveText(/Line\s*X -40.000 Y 0.000/);
  await page.getByRole('radio', { name: 'Arc' }).click();
  await touch(-50, 0);
  await expect(elements.nth(5)).toHaveText(/Arc, counter-clockwise\s*X -50.000 Y 0.000 R 5.000/);
  await page.getByRole('button', { name: '180°' }).click();
  await expect(elements.nth(5)).toContainText('Arc, clockwise');
  await page.getByLabel('Radius', { exact: true }).fill('10');
  await page.getByLabel('Radius', { exact: true }).press('Enter');
  await expect(elements.nth(5)).toHaveText(/X -50.000 Y 0.000 R 10.000/);
  await elements.nth(3).getByRole('button').click();
  await page.getByRole('radio', { name: 'Chamfer' }).click();
  await page.getByLabel('Size of the corner').fill('3');
  await page.getByLabel('Size of the corner').press('Enter');
  await expect(elements.nth(3)).toHaveText(/Line\s*X -40.000 Y 25.000 · C 3/);
  await elements.nth(2).getByRole('button').click();
  await page.getByRole('radio', { name: 'Sharp' }).click();
  await expect(elements.nth(2)).toHaveText(/Line\s*X 40.000 Y 25.000$/);
  await page.getByRole('radio', { name: 'Choose' }).click();
  await page.getByRole('button', { name: 'Point 1', exact: true }).focus();
  await page.keyboard.press('ArrowLeft');
  await expect(elements.first()).toHaveText(/X -41.000 Y -25.000/);
  await written(page);
  await page.getByTestId('simulate').click();
  await expect.poll(async () => Number(await page.getByTestId('simulation').getAttribute('data-points'))).toBeGreaterThan(20);
  await shoot(page, 'cycles-contour');
});

test('a point of a profile is taken by a finger beside it, the nearest where points are close', async ({ page }) => {
  await open(page, 'G294');
  const elements = page.locator('.elements li');
  const drawing = page.getByRole('group', { name: 'Profile' });
  await drawing.scrollIntoViewIfNeeded();
  const point = (name: string) => page.getByRole('button', { name, exact: true });
  const middle = async (name: string) => {
    const { x, y, width, height } = (await point(name).boundingBox())!;
    expect(Math.min(width, height)).toBeGreaterThanOrEqual(43.5);
    return [x + width / 2, y + height / 2] as const;
  };
  // 18 px beside it: it is chosen, and does not move by that.
  const [x, y] = await middle('Point 3');
  await page.mouse.click(x + 12, y - 13);
  await expect(elements.nth(2)).toHaveClass(/on/);
  await expect(elements.nth(2)).toHaveText(/Line\s*X 40.000 Y 25.000/);
  await expect(point('Point 3')).toBeFocused();
  // The fourth comes within 20 px of the third: each is taken from its own side.
  await elements.nth(3).getByRole('button').click();
  const scale = 80 / ((await middle('Point 3'))[0] - (await middle('Point 4'))[0]);
  const near = 40 - 20 * scale;
  await page.getByLabel('X of the end', { exact: true }).fill(near.toFixed(3));
  await page.getByLabel('X of the end', { exact: true }).press('Enter');
  await drawing.scrollIntoViewIfNeeded();
  const [third, fourth] = [await middle('Point 3'), await middle('Point 4')];
  expect(Math.abs(third[0] - fourth[0])).toBeLessThan(30);
  await page.mouse.click(third[0] - 4, third[1]);
  await expect(elements.nth(2)).toHaveClass(/on/);
  await page.mouse.click(fourth[0] + 4, fourth[1]);
  await expect(elements.nth(3)).toHaveClass(/on/);
  // Drawing begins beside a point as anywhere.
  await page.getByRole('radio', { name: 'Line' }).click();
  const [beside, above] = await middle('Point 3');
  await page.mouse.click(beside + 16, above - 16);
  await expect(elements).toHaveCount(5);
});

test('a wall of a pocket slopes by a profile of lines and arcs, and profiles are kept by their names', async ({ page }) => {
  await page.setViewportSize({ width: 800, height: 600 });
  await open(page, 'P3D');
  const points = () => page.getByTestId('simulation').getAttribute('data-points').then(Number);
  await page.getByRole('button', { name: 'Depth profile' }).click();
  const depth = page.locator('.editor', { has: page.getByRole('group', { name: 'P.Z1' }) });
  const elements = depth.locator('.elements li');
  await expect(elements).toHaveText([/Start\s*X -40.000 Z 0.000/, /Line\s*X -35.000 Z -10.000/]);
  // Steep at the surface, then a rounded shoulder that ends upright.
  const give = async (label: string, value: string) => {
    await depth.getByLabel(label, { exact: true }).fill(value);
    await depth.getByLabel(label, { exact: true }).press('Enter');
  };
  await elements.nth(1).getByRole('button').click();
  await give('X of the end', '-39');
  await give('Z of the end', '-4');
  await depth.locator('.element').getByRole('button', { name: 'Arc', exact: true }).click();
  await give('X of the end', '-33');
  await give('Z of the end', '-10');
  await give('X of the centre', '-39');
  await give('Z of the centre', '-10');
  await depth.getByRole('button', { name: '270°' }).click();
  await expect(elements.nth(2)).toHaveText(/Arc, clockwise\s*X -33.000 Z -10.000 R 6.000/);
  await written(page);
  await depth.scrollIntoViewIfNeeded();
  await shoot(page, 'cycles-depth');
  await page.getByTestId('simulate').click();
  await expect.poll(points).toBeGreaterThan(200);

  // It is kept by its name, also when the page is opened anew, and called so by its cycle.
  const keep = async (editor: typeof depth, name: string) => {
    await editor.getByTestId('profiles').click();
    await page.getByTestId('profile-name').fill('2 NAMES');
    await expect(page.getByTestId('keep-profile')).toBeDisabled();
    await page.getByTestId('profile-name').fill(name);
    await page.getByTestId('keep-profile').click();
    await expect(page.locator(`[data-profile="${name}"]`)).toBeVisible();
    await page.getByRole('dialog').getByRole('button', { name: 'Close' }).click();
  };
  const plan = page.locator('.editor', { has: page.getByRole('group', { name: 'Profile' }) });
  await keep(depth, 'SLOPE');
  await keep(plan, 'PLATE');
  await expect(page.locator('[id="field-Z1"]')).toHaveValue('SLOPE');
  await page.reload();
  await open(page, 'P3D');
  await plan.getByTestId('profiles').click();
  await expect(page.locator('[data-profile]')).toHaveCount(1);
  await page.locator('[data-profile="PLATE"] .grow').click();
  await expect(page.locator('[id="field-profile"]')).toHaveValue('PLATE');
  await page.getByRole('button', { name: 'Depth profile' }).click();
  await depth.getByTestId('profiles').click();
  await expect(page.locator('[data-profile]')).toHaveCount(1);
  await shoot(page, 'cycles-profiles');
  await page.locator('[data-profile="SLOPE"] .grow').click();
  await expect(elements).toHaveCount(3);
  await written(page);
  await page.getByRole('radio', { name: 'Text' }).click();
  await expect(page.locator('pre')).toContainText('#PROFILE SLOPE [XZ]');
  await expect(page.locator('pre')).toContainText('G2 X-33 Z-10 I0 K-6');
  await page.getByTestId('simulate').click();
  await expect.poll(points).toBeGreaterThan(200);
  // One of depth is none in the plane; one that is thrown away is gone.
  await open(page, 'G293');
  await page.getByTestId('profiles').click();
  await expect(page.getByRole('dialog')).not.toContainText('SLOPE');
  await page.getByRole('dialog').getByRole('button', { name: 'Close' }).click();
  await open(page, 'P2D');
  await page.getByTestId('profiles').click();
  await page.locator('[data-profile="PLATE"]').getByRole('button', { name: 'Delete' }).click();
  await expect(page.getByRole('dialog')).toContainText('No profile of this kind is kept');
});

test('a tool is as the machine has it in its table, and what is typed of it alone is another', async ({ page }) => {
  const mdi = [true, false].map((down) => ({ do: 'key', key: 'KEY_MDI', down }));
  const set = async (value: number) => {
    await say(page, { do: 'take_command' }, ...mdi, { do: 'log_in', level: 2, password: PASSWORDS[2] }, { do: 'parameter_switch', on: true },
      { do: 'set_parameter', name: 'NO40.7', value }, { do: 'parameter_switch', on: false }, { do: 'give_command' });
  };
  const worn = (wear: number) => say(page, { do: 'take_command' }, { do: 'set_offset', number: 1, radius: 12, radius_wear: wear }, { do: 'give_command' });
  let tools: unknown;
  page.on('request', (request) => {
    if (/\/api\/cycle\?/.test(request.url())) tools = (request.postDataJSON() as { tools: unknown }).tools;
  });
  await open(page, 'G287');
  await worn(-0.4);
  await page.getByRole('radio', { name: 'Text' }).click();
  const tool = page.locator('[data-tool="1"]');
  const diameter = tool.getByLabel('Diameter');
  const back = tool.getByLabel('As the machine\'s table has it');
  // How far the wall of 80 mm about 0 is from the middle of the tool.
  const least = async () => Math.min(...[...(await page.locator('pre').innerText()).matchAll(/X(-?[\d.]+)/g)].map((found) => Number(found[1])));
  const from = (wall: number) => expect.poll(async () => Math.round(1000 * ((await least()) + 40)) / 1000).toBe(wall);
  await expect(diameter).toHaveValue('11.600');
  await from(5.8);
  // 40#7: the table has radii.
  await set(0);
  await expect(diameter).toHaveValue('23.200');
  await from(11.6);
  await set(1);
  await expect(diameter).toHaveValue('11.600');
  await from(5.8);
  expect(tools).toEqual([]);
  await expect(back).toBeDisabled();
  // The wear is taken as it is now.
  await worn(-0.6);
  await expect(diameter).toHaveValue('11.400');
  await from(5.7);
  await tool.getByLabel('Tip radius').fill('1');
  await tool.getByLabel('Tip radius').press('Enter');
  await expect.poll(() => tools).toEqual([{ number: 1, tip_radius: 1 }]);
  await from(5.7);
  await diameter.fill('10');
  await diameter.press('Enter');
  await expect.poll(() => tools).toEqual([{ number: 1, tip_radius: 1, diameter: 10 }]);
  await from(5);
  await shoot(page, 'cycles-tool');
  await back.click();
  await expect(diameter).toHaveValue('11.400');
  await from(5.7);
  expect(tools).toEqual([]);
});

test('a field is taught where the machine stands', async ({ page }) => {
  await open(page, 'G288');
  const at = page.locator('[id="field-XC"]');
  await at.fill('12.5');
  await expect(at).toHaveValue('12.5');
  const [status] = await say(page, { do: 'status' });
  const axis = (status as { position: { work: { X: number } } }).position.work.X;
  await at.focus();
  await page.locator('.field[data-name="XC"]').getByRole('button', { name: "Take the machine's position" }).click();
  await expect.poll(async () => Number(await at.inputValue())).toBeCloseTo(axis, 3);
});

test('the forms that drawings are tested with are those of the server', async ({ request }) => {
  const forms = (await (await request.get('/api/cycles?language=en')).json()) as Form[];
  // FORMS=write takes them over.
  if (process.env.FORMS === 'write') write(forms);
  expect(read()).toEqual(kept(forms));
});

test('forms are in the language and the shade that are chosen, and fit a small screen', async ({ page }) => {
  await page.addInitScript(() =>
    localStorage.setItem('ferrocut.panel', JSON.stringify({ welcomed: true, panel: false, language: 'zh', theme: 'light' })),
  );
  await page.setViewportSize({ width: 800, height: 600 });
  await open(page, 'G287');
  await expect(page.locator('.form h2').first()).toHaveText('矩形型腔');
  await expect(page.locator('[data-name="ZS"]')).toContainText('安全平面');
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  expect(wide).toBeLessThanOrEqual(800);
  // What is touched is large enough.
  for (const one of await page.locator('.form input:visible, .form select:visible, .form button:visible').all()) {
    expect((await one.boundingBox())?.height ?? 44).toBeGreaterThanOrEqual(43.9);
  }
  await shoot(page, 'cycles-small');
});
