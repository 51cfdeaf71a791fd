// What keeps a machine safe in a browser: a key acts while it is held, and what must be touched can be touched.
import { expect, test } from '@playwright/test';
import { mock, type Sent } from './mock';
import { shoot } from './server';
import { release, stands } from './walk';

const keys = (sent: Sent[]) => sent.filter((one) => one.do === 'key').map((one) => `${String(one.key)} ${one.down ? 'down' : 'up'}`);

test('an axis key is down while it is held, with signs of life, and up when it is let go', async ({ context }) => {
  const { page, sent } = await mock(context, { mode: 'jog' });
  const key = page.locator('[data-signal="KEY_X+"]');
  await expect(key).toBeEnabled();
  await key.hover();
  await page.mouse.down();
  await page.waitForTimeout(600);
  await page.mouse.up();
  await expect.poll(() => keys(sent)).toEqual(['KEY_X+ down', 'KEY_X+ up']);
  const [down, up] = sent.filter((one) => one.do === 'key');
  const alive = sent.filter((one) => one.do === 'alive' && one.at > down!.at && one.at < up!.at);
  expect(alive.length).toBeGreaterThanOrEqual(3);
  const after = sent.length;
  await page.waitForTimeout(400);
  expect(sent.slice(after).filter((one) => one.do === 'alive')).toEqual([]);
});

for (const [name, end] of [
  ['the window loses the focus', () => window.dispatchEvent(new Event('blur'))],
  ['the page is hidden', () => {
    Object.defineProperty(document, 'visibilityState', { value: 'hidden', configurable: true });
    document.dispatchEvent(new Event('visibilitychange'));
  }],
  ['the pointer is taken away', () => document.querySelector('[data-signal="KEY_Z-"]')!.dispatchEvent(new PointerEvent('pointercancel', { pointerId: 1 }))],
  ['the page is left', () => window.dispatchEvent(new Event('pagehide'))],
] as const) {
  test(`a held key is let go when ${name}`, async ({ context }) => {
    const { page, sent } = await mock(context, { mode: 'jog' });
    await page.locator('[data-signal="KEY_Z-"]').hover();
    await page.mouse.down();
    await expect.poll(() => keys(sent)).toEqual(['KEY_Z- down']);
    await page.evaluate(end as () => void);
    await expect.poll(() => keys(sent)).toEqual(['KEY_Z- down', 'KEY_Z- up']);
    await page.mouse.up();
  });
}

test('the pointer may leave a held key; the key stays down until the pointer is up', async ({ context }) => {
  const { page, sent } = await mock(context, { mode: 'jog' });
  await page.locator('[data-signal="KEY_Y+"]').hover();
  await page.mouse.down();
  await page.mouse.move(200, 300);
  await page.waitForTimeout(200);
  expect(keys(sent)).toEqual(['KEY_Y+ down']);
  await page.mouse.up();
  await expect.poll(() => keys(sent)).toEqual(['KEY_Y+ down', 'KEY_Y+ up']);
});

test('fingers hold keys: each its own, until it is lifted', async ({ browser }) => {
  const context = await browser.newContext({ hasTouch: true, viewport: { width: 1366, height: 820 } });
  const { page, sent, quiet } = await mock(context, { mode: 'jog' });
  const cdp = await context.newCDPSession(page);
  const finger = async (key: string, id: number) => {
    const box = (await page.locator(`[data-signal="${key}"]`).boundingBox())!;
    return { x: box.x + box.width / 2, y: box.y + box.height / 2, id };
  };
  const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', ...touchPoints: { x: number; y: number; id: number }[]) =>
    cdp.send('Input.dispatchTouchEvent', { type, touchPoints });
  const [first, second] = [await finger('KEY_X+', 1), await finger('KEY_Z-', 2)];
  await touch('touchStart', first);
  await expect.poll(() => keys(sent)).toEqual(['KEY_X+ down']);
  await touch('touchStart', first, second);
  await expect.poll(() => keys(sent)).toEqual(['KEY_X+ down', 'KEY_Z- down']);
  // A finger that slips off its key holds it on; the first one is lifted.
  await touch('touchMove', first, { ...second, y: second.y + 150 });
  await touch('touchEnd', first);
  await expect.poll(() => keys(sent)).toEqual(['KEY_X+ down', 'KEY_Z- down', 'KEY_X+ up']);
  await touch('touchEnd', { ...second, y: second.y + 150 });
  await expect.poll(() => keys(sent)).toEqual(['KEY_X+ down', 'KEY_Z- down', 'KEY_X+ up', 'KEY_Z- up']);
  quiet();
  await context.close();
});

test('keys of the keyboard: emergency stop from any page, jog only with Ctrl and in jog', async ({ context }) => {
  const { page, home, sent } = await mock(context, { mode: 'jog' });
  await expect(page.getByTestId('activity')).toHaveText('Running');
  await page.goto(`${home}#/help/search`);
  await page.keyboard.press('F1');
  await expect.poll(() => sent.filter((one) => one.do === 'emergency_stop').map((one) => one.pressed)).toEqual([true]);
  await page.goto(`${home}#/position`);
  await page.locator('[data-testid="axes"]').click();
  await page.keyboard.press('ArrowRight');
  expect(keys(sent)).toEqual([]);
  await page.keyboard.down('Control');
  await page.keyboard.down('ArrowRight');
  await expect.poll(() => keys(sent)).toEqual(['KEY_X+ down']);
  await page.keyboard.up('ArrowRight');
  await page.keyboard.up('Control');
  await expect.poll(() => keys(sent)).toEqual(['KEY_X+ down', 'KEY_X+ up']);
  await page.keyboard.press('?');
  await expect(page.getByRole('dialog')).toContainText('F10');
});

test('a cycle starts with F10 alone, and Alt with a digit changes no page while something is typed', async ({ context }) => {
  const { page, home, sent } = await mock(context);
  await page.goto(`${home}#/position`);
  await expect(page.locator('[data-page="position"]')).toBeVisible();
  for (const chord of ['Shift+F10', 'Control+F10', 'Alt+F10']) await page.keyboard.press(chord);
  await page.keyboard.press('F10');
  await expect.poll(() => keys(sent)).toEqual(['KEY_START down', 'KEY_START up']);
  await page.keyboard.press('Alt+Digit3');
  await expect(page.locator('[data-page="offsets"]')).toBeVisible();
  await page.evaluate(() => (location.hash = '#/help/search'));
  await page.getByTestId('help-search').focus();
  await page.keyboard.press('Alt+Digit3');
  await page.waitForTimeout(200);
  await expect(page.locator('[data-page="help"]')).toBeVisible();
});

test('the handwheel turns by the first button alone, and by nothing once the page is left', async ({ context }) => {
  const { page, home, sent } = await mock(context, { mode: 'handle' });
  await page.goto(`${home}#/position`);
  const dial = page.getByTestId('handwheel');
  await expect(dial).toHaveAttribute('aria-disabled', 'false');
  const counts = () => sent.filter((one) => one.do === 'handwheel').reduce((sum, one) => sum + Number(one.counts), 0);
  const box = (await dial.boundingBox())!;
  const rim = (turn: number): [number, number] => [box.x + box.width / 2 + 40 * Math.cos(2 * Math.PI * turn), box.y + box.height / 2 + 40 * Math.sin(2 * Math.PI * turn)];
  const drag = async (button: 'left' | 'right' | 'middle') => {
    await page.mouse.move(...rim(0));
    await page.mouse.down({ button });
    // Half a count is left over.
    await page.mouse.move(...rim(0.105));
    await page.mouse.up({ button });
  };
  await drag('right');
  await drag('middle');
  // What is no turn: rolled to the side, or for the browser.
  await dial.evaluate((dial) => {
    const roll = (with_: WheelEventInit) => dial.dispatchEvent(new WheelEvent('wheel', { bubbles: true, cancelable: true, ...with_ }));
    roll({ deltaX: 100, deltaY: 0 });
    roll({ deltaY: -100, ctrlKey: true });
    roll({ deltaY: -100, shiftKey: true });
    const menu = new MouseEvent('contextmenu', { bubbles: true, cancelable: true });
    dial.dispatchEvent(menu);
    dial.toggleAttribute('data-no-menu', menu.defaultPrevented);
    // Turned in the frame in which the window loses the keyboard.
    roll({ deltaY: -100 });
    window.dispatchEvent(new Event('blur'));
  });
  await expect(dial).toHaveAttribute('data-no-menu', '');
  // Let go where the page does not hear of it.
  await page.mouse.move(...rim(0));
  await page.mouse.down();
  await dial.evaluate((dial, [clientX, clientY]) => {
    const [pointerId, bubbles] = [1, true];
    dial.dispatchEvent(new PointerEvent('pointermove', { clientX: clientX!, clientY: clientY!, pointerId, bubbles, buttons: 0 }));
  }, rim(0.1));
  await page.mouse.move(...rim(0.2));
  await page.mouse.up();
  await page.waitForTimeout(200);
  expect(counts()).toBe(0);
  await drag('left');
  await expect.poll(counts).toBe(10);
});

test('with Shift the keyboard moves the axes behind the first two, and the modifier let go first ends it', async ({ context }) => {
  const { page, sent } = await mock(context, { mode: 'jog' });
  await stands(page, 'running');
  await page.locator('[data-testid="axes"]').click();
  for (const modifier of ['Shift', 'Control']) {
    sent.length = 0;
    await page.keyboard.down('Control');
    await page.keyboard.down('Shift');
    await page.keyboard.down('ArrowUp');
    await expect.poll(() => keys(sent)).toEqual(['KEY_Z+ down']);
    await page.keyboard.up(modifier);
    await expect.poll(() => keys(sent)).toEqual(['KEY_Z+ down', 'KEY_Z+ up']);
    // The arrow goes on being held, with what is left of the modifiers, and says so; it moves no other axis.
    await page.keyboard.down('ArrowUp');
    await page.evaluate(() => dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowUp', code: 'ArrowUp', ctrlKey: true })));
    await page.waitForTimeout(200);
    expect(keys(sent)).toEqual(['KEY_Z+ down', 'KEY_Z+ up']);
    for (const key of ['ArrowUp', 'Shift', 'Control']) await page.keyboard.up(key);
  }
  sent.length = 0;
  await page.keyboard.press('Control+ArrowUp');
  await page.keyboard.press('Control+Shift+ArrowLeft');
  await expect.poll(() => keys(sent)).toEqual(['KEY_Y+ down', 'KEY_Y+ up', 'KEY_A- down', 'KEY_A- up']);
});

test('the fourth axis has its keys whatever its letter is', async ({ context }) => {
  const { page, sent } = await mock(context, { mode: 'jog', axes: ['X', 'Y', 'Z', 'C'] });
  await stands(page, 'running');
  await page.getByRole('button', { name: 'Move C−' }).click();
  await expect.poll(() => keys(sent)).toEqual(['KEY_A- down', 'KEY_A- up']);
  await page.getByRole('button', { name: 'Handwheel moves C' }).click();
  await page.keyboard.press('Control+Shift+ArrowRight');
  await expect.poll(() => keys(sent).filter((one) => one.endsWith('down'))).toEqual(['KEY_A- down', 'KEY_WA down', 'KEY_A+ down']);
  await page.keyboard.press('?');
  await expect(page.getByRole('dialog')).toContainText('Move C while held');
});

test('keys of axes that a machine lacks are not there', async ({ context }) => {
  const { page } = await mock(context, { mode: 'jog', axes: ['X', 'Z'] });
  await stands(page, 'running');
  await expect(page.locator('[data-signal="KEY_Y+"]')).toHaveText('Z+');
  await expect(page.locator('[data-signal^="KEY_Z"], [data-signal^="KEY_A+"], [data-signal="KEY_WZ"], [data-signal="KEY_WA"]')).toHaveCount(0);
});

const stops = (sent: Sent[]) => sent.filter((one) => one.do === 'emergency_stop').map((one) => one.pressed);

for (const apart of [80, 150, 250, 700]) {
  test(`an emergency stop that is hit twice within ${apart} ms stands`, async ({ browser }) => {
    const context = await browser.newContext({ hasTouch: true, viewport: { width: 1366, height: 820 } });
    const { page, sent, quiet } = await mock(context);
    await stands(page, 'running');
    const box = (await page.getByTestId('emergency').boundingBox())!;
    const cdp = await context.newCDPSession(page);
    const touchPoints = [{ x: box.x + box.width / 2, y: box.y + box.height / 2 }];
    const start = Date.now();
    const touch = (down: boolean, after: number) =>
      cdp.send('Input.dispatchTouchEvent', { type: down ? 'touchStart' : 'touchEnd', touchPoints: down ? touchPoints : [], timestamp: (start + after) / 1000 });
    await touch(true, 0);
    // As soon as the finger is down.
    await expect.poll(() => stops(sent)).toEqual([true]);
    await stands(page, 'emergency');
    await touch(false, 40);
    // So long after the first, however late a loaded computer brings it.
    await touch(true, apart);
    // Nor does the second one release it, however long it lasts.
    await page.waitForTimeout(1500);
    await expect.poll(() => stops(sent)).toEqual([true, true]);
    await touch(false, apart + 1500);
    await stands(page, 'emergency');
    expect(stops(sent)).not.toContain(false);
    // Later a tap is too short.
    await page.touchscreen.tap(touchPoints[0]!.x, touchPoints[0]!.y);
    await page.waitForTimeout(1200);
    expect(stops(sent)).not.toContain(false);
    quiet();
    await context.close();
  });
}

for (const by of ['pointer', 'Enter', ' '] as const) {
  test(`the emergency stop is pressed at once and released by ${by === ' ' ? 'Space' : by} held down`, async ({ context }) => {
    const { page, sent } = await mock(context);
    await stands(page, 'running');
    const stop = page.getByTestId('emergency');
    if (by === 'pointer') await stop.hover();
    else await stop.focus();
    // The press itself, held on, does not release it.
    await (by === 'pointer' ? page.mouse.down() : page.keyboard.down(by));
    await stands(page, 'emergency');
    await page.waitForTimeout(2500);
    await (by === 'pointer' ? page.mouse.up() : page.keyboard.up(by));
    expect(stops(sent)).toEqual([true]);
    await release(page, by);
    await stands(page, 'running');
    expect(stops(sent)).toEqual([true, true, false]);
  });
}

test('a connection that is lost is told, and comes back', async ({ context }) => {
  const { page, cut } = await mock(context);
  await expect(page.getByTestId('activity')).toHaveText('Running');
  cut();
  await expect(page.getByTestId('activity')).toHaveText('No connection');
  await expect(page.getByTestId('activity')).toHaveText('Running');
});

test('a ladder brings keys and lamps of its own to the panel, and those of a fifth axis', async ({ context }) => {
  const signal = (name: string, address: string, meaning: string) => ({ name, address, meaning, value: 0 });
  const { page, sent } = await mock(context, {
    mode: 'jog',
    axes: ['X', 'Y', 'Z', 'A', 'B'],
    lamps: ['LAMP_DOOR', 'LAMP_ZERO_X'],
    signals: {
      X: [signal('KEY_5+', 'X30.0', 'key +B'), signal('KEY_5-', 'X30.1', 'key -B'), signal('KEY_W5', 'X30.2', ''), signal('KEY_DOOR', 'X31.0', 'door')],
      Y: [signal('LAMP_DOOR', 'Y31.0', ''), signal('LAMP_WARM', 'Y31.1', 'warming up')],
    },
  });
  const door = page.locator('[data-signal="KEY_DOOR"]');
  await expect(door).toHaveText('door');
  await expect(door).toHaveAttribute('aria-pressed', 'true');
  await expect(page.locator('[data-lamp="LAMP_WARM"]')).toHaveText('warming up');
  await expect(page.locator('[data-lamp="LAMP_ZERO_X"]')).toHaveClass(/on/);
  await expect(page.locator('[data-lamp="LAMP_ZERO_Y"]')).not.toHaveClass(/on/);
  await expect(page.locator('[data-signal="KEY_W5"]')).toHaveText('B');
  for (const key of ['KEY_5+', 'KEY_DOOR']) {
    await page.locator(`[data-signal="${key}"]`).hover();
    await page.mouse.down();
    await expect.poll(() => keys(sent)).toContain(`${key} down`);
    await page.mouse.up();
    await expect.poll(() => keys(sent)).toContain(`${key} up`);
  }
  await shoot(page, 'own-keys');
});

test('keys of a fifth axis that the ladder does not have are not on the panel', async ({ context }) => {
  const { page } = await mock(context, { axes: ['X', 'Y', 'Z', 'A', 'B'] });
  await expect(page.locator('[data-signal="KEY_A+"]')).toBeVisible();
  await expect(page.locator('[data-signal="KEY_5+"]')).toHaveCount(0);
});
