// What must be touched can be touched, on every page and in every size: 44 px at least, and nothing beside the screen.
import type { Page } from '@playwright/test';
import { pages } from './pages';
import { expect, shoot, test } from './server';
import { bring, enter, load, logIn, mode, notice, PLATE, press, selected, show, watchFaults } from './walk';

watchFaults();

/** What is smaller than a finger. A field is touched by its label too, and a segment of a segmented switch, as wide as a
    finger itself, by the height of the frame around it. */
const small = (page: Page) =>
  page.evaluate(() => {
    const least = 43.5;
    const size = (one: Element) => {
      const own = one.getBoundingClientRect();
      const label = one.closest('label')?.getBoundingClientRect();
      const group = one.closest('[role=radiogroup]')?.getBoundingClientRect();
      return { own, width: Math.max(own.width, label?.width ?? 0), height: Math.max(own.height, label?.height ?? 0, group?.height ?? 0) };
    };
    return [...document.querySelectorAll<HTMLElement>('button, input:not([type=file]), select, textarea, summary, a[href], [role=button], [role=checkbox], [role=radio], [role=tab], [role=switch]')]
      .filter((one) => one.checkVisibility({ opacityProperty: true, visibilityProperty: true }) && !one.closest('[popover]:not(:popover-open)'))
      .map((one) => ({ one, ...size(one) }))
      .filter(({ own, width, height }) => own.width > 0 && (height < least || width < least))
      .map(({ one, own }) => `${one.tagName} ${one.getAttribute('aria-label') ?? one.textContent?.trim().slice(0, 30) ?? ''} ${own.width.toFixed(0)}×${own.height.toFixed(0)}`);
  });

/** Keys of the frame that something lies over: those must be there on every page. */
const covered = (page: Page, keys = '.app > header button, .app > nav a, .app > footer button') =>
  page.evaluate((keys) =>
    [...document.querySelectorAll<HTMLElement>(keys)]
      .filter((one) => one.checkVisibility())
      .filter((one) => {
        const { left, right, top, bottom } = one.getBoundingClientRect();
        const places = [[left + 6, top + 6], [right - 6, top + 6], [left + 6, bottom - 6], [right - 6, bottom - 6], [(left + right) / 2, (top + bottom) / 2]] as const;
        const frame = one.closest('aside')?.getBoundingClientRect() ?? { top: 0, bottom: innerHeight };
        // One that is scrolled to has its place when it is there.
        return top >= Math.max(0, frame.top) && bottom <= Math.min(innerHeight, frame.bottom) && places.some(([x, y]) => !one.contains(document.elementFromPoint(x, y)));
      })
      .map((one) => one.getAttribute('aria-label') ?? one.textContent?.trim() ?? ''),
    keys,
  );

/** What runs over its edge sideways: a part that scrolls up and down alone, the tabs, and what a key or a button says. */
const over = (page: Page) =>
  page.evaluate(() => {
    const called = (one: Element) => `${one.tagName}.${[...one.classList].filter((name) => !name.startsWith('svelte-')).join('.')} ${(one.getAttribute('aria-label') ?? one.textContent ?? '').trim().slice(0, 30)}`;
    const shown = (selector: string) =>
      [...document.querySelectorAll<HTMLElement>(selector)].filter((one) => one.checkVisibility({ opacityProperty: true, visibilityProperty: true }) && !one.closest('[popover]:not(:popover-open)'));
    const told = shown('.scroll, .tabs, .card, dialog, [popover], .cm-panel, button, a[href]')
      .filter((one) => !one.closest('[data-pans]') && (!one.closest('.cm-editor') || one.closest('.cm-panels')) && one.clientWidth > 0 && one.scrollWidth > one.clientWidth + 1)
      .map((one) => `${called(one)} needs ${one.scrollWidth} of ${one.clientWidth} px`);
    // Nor is anything beside the part of the screen that it is in.
    const beside = shown(':is(main, dialog, [popover]) :is(button, input, select, textarea, a[href])')
      .filter((one) => !one.closest('[data-pans]'))
      .filter((one) => {
        const own = one.getBoundingClientRect();
        const frame = one.closest('.cm-panel, .card, .scroll, dialog, [popover], main')!.getBoundingClientRect();
        return own.width > 0 && (own.right > frame.right + 1 || own.left < frame.left - 1);
      })
      .map((one) => `${called(one)} is beside its frame`);
    return [...told, ...beside];
  });

for (const language of ['en', 'zh', 'ru', 'es', 'tr']) {
  test(`nothing runs over its edge in ${language} at 800 × 600`, async ({ page }) => {
    test.setTimeout(400_000);
    await page.addInitScript((kept) => localStorage.setItem('ferrocut.panel', kept), JSON.stringify({ welcomed: true, language, theme: 'dark', panel: false }));
    await page.setViewportSize({ width: 800, height: 600 });
    await page.goto('/');
    await expect(page.locator('html')).toHaveAttribute('lang', language);
    await expect(page.getByTestId('mode')).toBeVisible();
    const wrong = new Set<string>();
    for (const [name, tabs] of Object.entries(pages)) {
      for (const tab of tabs.length ? tabs : ['']) {
        const hash = tab ? `${name}/${tab}` : name;
        await show(page, hash);
        // What it asks for comes.
        await page.waitForTimeout(400);
        for (const one of await over(page)) wrong.add(`${hash}: ${one}`);
        if (tab === 'all' || name === 'settings') await shoot(page, `narrow-${language}-${name}-${tab}`);
      }
    }
    await page.getByTestId('panel-toggle').click();
    await expect(page.getByTestId('machine-panel')).toBeVisible();
    for (const one of await over(page)) wrong.add(`machine panel: ${one}`);
    expect([...wrong]).toEqual([]);
  });
}

for (const language of ['en', 'ru']) {
  test(`what is opened over a page can be touched in ${language} at 800 × 600`, async ({ page }) => {
    page.setDefaultTimeout(20_000);
    await page.addInitScript(
      (kept) => {
        if (!localStorage.getItem('ferrocut.panel')) localStorage.setItem('ferrocut.panel', kept);
      },
      JSON.stringify({ welcomed: false, language, theme: 'dark', panel: false }),
    );
    await page.setViewportSize({ width: 800, height: 600 });
    await page.goto('/');
    const wrong: string[] = [];
    const dialog = page.getByRole('dialog');
    const judge = async (name: string) => {
      for (const one of [...(await small(page)), ...(await over(page))]) wrong.push(`${name}: ${one}`);
      const outside = await page.evaluate(() =>
        [...document.querySelectorAll('dialog[open], [popover]:popover-open')]
          .map((one) => one.getBoundingClientRect())
          .some(({ left, top, right, bottom }) => left < 0 || top < 0 || right > innerWidth || bottom > innerHeight),
      );
      if (outside) wrong.push(`${name} is beside the screen`);
      await shoot(page, `over-${language}-${name}`);
    };
    /** Opens it, looks at it, and closes it. */
    const look = async (name: string, open: () => Promise<void>) => {
      await open();
      await expect(dialog).toBeVisible();
      await judge(name);
      await page.keyboard.press('Escape');
      await expect(dialog).toBeHidden();
    };
    const click = (id: string) => () => page.getByTestId(id).click();

    await expect(dialog).toBeVisible();
    await judge('welcome');
    await page.getByTestId('welcome-start').click();
    await expect(page.locator('.who')).toHaveClass(/you/);
    await page.getByTestId('user').click();
    await expect(page.getByTestId('log-in')).toBeVisible();
    await judge('user');
    await page.keyboard.press('Escape');
    await look('log-in', async () => {
      await click('user')();
      await click('log-in')();
    });
    await look('keyboard', click('keyboard'));
    await logIn(page, 2);
    await expect(page.getByTestId('user')).toHaveText('2');

    const bytes = Buffer.from('O0044 (TOUCH)\nG0 X1.\nM30\n');
    await bring(page, 'O0044', bytes);
    await look('new', click('new'));
    await page.locator('[data-program="O0044"]').getByRole('button').click();
    await look('copy', click('copy'));
    await look('rename', click('rename'));
    await look('delete', click('delete'));
    await look('replace', () => page.getByTestId('upload').setInputFiles({ name: 'O0044.nc', mimeType: 'text/plain', buffer: bytes }));

    // A picture needs a program.
    await press(page, 'KEY_AUTO');
    await click('select')();
    await expect(selected(page)).toContainText('O0044');
    await show(page, 'program/edit/O0044');
    await expect(page.locator('.cm-content')).toContainText('TOUCH');
    await look('renumber', click('renumber'));
    await click('find')();
    await expect(page.locator('.cm-search')).toBeVisible();
    await judge('find');
    await page.keyboard.press('Escape');
    await click('to-line')();
    await expect(page.locator('.cm-dialog')).toBeVisible();
    await judge('to-line');
    await page.keyboard.press('Escape');

    await show(page, 'graphics');
    await look('drawing', click('drawing'));

    await show(page, 'settings/data');
    await page.locator('[data-page="settings"] input.code').last().fill(`touch-${language}.backup`);
    await click('back-up')();
    await expect(page.locator(`[data-backup="touch-${language}.backup"]`)).toBeVisible();
    await look('restore', click('restore'));
    await look('bring', () => page.getByTestId('bring-backup').setInputFiles({ name: `touch-${language}.backup`, mimeType: 'application/json', buffer: bytes }));

    await show(page, 'plc/edit');
    await expect(page.locator('.cm-content')).toContainText('LAMP');
    await page.locator('.cm-content').click();
    await page.keyboard.type(' ');
    await look('exchange', click('exchange'));
    expect(wrong).toEqual([]);
  });
}

test('notices lie over no key of the frame', async ({ page }) => {
  await enter(page, '#/program/mdi');
  await mode(page, 'KEY_MDI', 'Manual data input');
  await page.getByLabel('One block').fill('G0 X1.');
  const panel = page.getByTestId('panel-toggle');
  for (const [width, height, beside] of [[600, 800, false], [800, 600, false], [800, 600, true], [1366, 820, true]] as const) {
    await page.setViewportSize({ width, height });
    if ((await panel.getAttribute('aria-pressed')) !== String(beside)) await panel.click();
    // It stays for some seconds.
    await page.keyboard.press('F10');
    await expect(notice(page)).toHaveCount(1);
    const keys = beside ? '.app > :is(header, footer, aside) button, .app > nav a' : undefined;
    expect([`${width} × ${height}`, ...(await covered(page, keys))]).toEqual([`${width} × ${height}`]);
    await expect(notice(page)).toHaveCount(1);
    await shoot(page, `notice-${width}-${beside}`);
    await notice(page).getByRole('button').click();
    await expect(notice(page)).toHaveCount(0);
  }
});

for (const [width, height] of [[800, 600], [600, 800], [1024, 768], [3840, 2160]] as const) {
  test(`every page fits and can be touched at ${width} × ${height}`, async ({ page }) => {
    test.setTimeout(400_000);
    await enter(page);
    if ((await selected(page).filter({ hasText: 'O1234' }).count()) === 0) await load(page, 'O1234', PLATE);
    await page.setViewportSize({ width, height });
    const wrong: string[] = [];
    // The machine panel lies over a narrow page: it is looked at, and closed.
    wrong.push(...(await small(page)).map((one) => `machine panel: ${one}`), ...(await covered(page)).map((one) => `${one} is covered`));
    const panel = page.getByTestId('panel-toggle');
    if (width < 1100 && (await panel.getAttribute('aria-pressed')) === 'true') await panel.click();
    for (const [name, tabs] of Object.entries(pages)) {
      for (const tab of tabs.length ? tabs : ['']) {
        const hash = tab ? `${name}/${tab}` : name;
        await show(page, hash);
        await expect(page.locator('main')).not.toContainText('Loading');
        const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        if (wide > 0) wrong.push(`${hash}: ${wide} px beside the screen`);
        wrong.push(...(await small(page)).map((one) => `${hash}: ${one}`), ...(await covered(page)).map((one) => `${hash}: ${one} is covered`));
        if (width === 600) await shoot(page, `portrait-${name}-${tab}`);
      }
    }
    // Points of profiles are touched too.
    for (const cycle of ['P2D', 'P3D', 'G293', 'G294']) {
      await show(page, 'cycles');
      const item = page.locator(`nav [data-cycle="${cycle}"]`);
      await item.waitFor({ state: 'attached' });
      // On a narrow page the cycles of one group stand there.
      for (const group of await page.locator('nav [data-group]').all()) {
        if (await item.isVisible()) break;
        await group.click();
        await expect(group).toHaveAttribute('aria-selected', 'true');
      }
      await item.click();
      await expect(page.locator(`.form[data-cycle="${cycle}"]`)).toBeVisible();
      await expect(page.locator('.editor [data-point]').first()).toBeVisible();
      wrong.push(...(await small(page)).map((one) => `${cycle}: ${one}`));
    }
    expect(wrong).toEqual([]);
  });
}

test.describe('by a finger alone', () => {
  test.use({ hasTouch: true, viewport: { width: 800, height: 600 } });

  test('a program is written, and a piece of it copied, moved and brought back, by the keypad', async ({ page }) => {
    await enter(page);
    await bring(page, 'O0046', Buffer.from('O0046\nG0 X1.\nM30\n'));
    await show(page, 'program/edit/O0046');
    const text = page.getByTestId('editor').locator('.cm-content');
    await expect(text).toContainText('O0046');
    // Whoever has a finger alone has the keypad, and no keyboard of the device over it.
    const pad = page.getByTestId('keypad');
    await expect(pad).toBeVisible();
    await expect(text).toHaveAttribute('inputmode', 'none');
    const keys = async (...names: string[]) => {
      for (const name of names) await pad.locator(`[data-pad="${name}"]`).tap();
    };
    const lines = () => text.locator('.cm-line').allTextContents();
    await text.locator('.cm-line', { hasText: 'G0 X1.' }).tap();
    await keys('end', 'eob', 'G', '1', 'space', 'X', '-', '2', '.', '5', 'space', 'F', '9', 'erase', '3', '0', '0');
    await expect.poll(lines).toEqual(['O0046', 'G0 X1.', 'G1 X-2.5 F300', 'M30', '']);
    await shoot(page, 'keypad');
    // Letters and signs that are met less.
    await keys('space', 'layer', 'P', '#', 'layer', 'layer', '1');
    await expect.poll(lines).toContain('G1 X-2.5 F300 P#1');
    await keys('undo');
    await expect.poll(lines).not.toContain('G1 X-2.5 F300 P#1');
    await keys('redo');
    await expect.poll(lines).toContain('G1 X-2.5 F300 P#1');
    // A piece that is selected is copied and put where the cursor is.
    await keys('select', 'left', 'left', 'left', 'copy', 'up', 'end', 'space', 'paste');
    await expect.poll(lines).toEqual(['O0046', 'G0 X1. P#1', 'G1 X-2.5 F300 P#1', 'M30', '']);
    // Without one the line is taken, and goes before that of the cursor.
    await keys('cut', 'down', 'paste');
    await expect.poll(lines).toEqual(['O0046', 'G1 X-2.5 F300 P#1', 'G0 X1. P#1', 'M30', '']);
    await keys('home', 'select', 'end', 'cut', 'G', '4', 'X');
    // A key of it that a keyboard presses acts once, though it gives the text the focus.
    await pad.locator('[data-pad="erase"]').focus();
    await page.keyboard.press('Enter');
    await page.waitForTimeout(1000);
    await expect.poll(lines).toContain('G4');
    await page.getByTestId('save').tap();
    await expect(page.getByTestId('save')).toBeDisabled();
    expect((await (await page.request.get('/api/programs/O0046')).body()).toString()).toBe('O0046\nG1 X-2.5 F300 P#1\nG0 X1. P#1\nG4\n');
  });

  test('the keypad stands under each text that is written, and all of it can be touched', async ({ page }) => {
    await enter(page);
    await bring(page, 'O0047', Buffer.from('O0047\nG0 X1.\nM30\n'));
    const pad = page.getByTestId('keypad');
    const wrong: string[] = [];
    for (const hash of ['program/edit/O0047', 'program/mdi', 'plc/edit']) {
      await show(page, hash);
      await expect(pad).toBeVisible();
      await expect(page.locator('main .cm-line').first()).toBeVisible();
      wrong.push(...[...(await small(page)), ...(await over(page))].map((one) => `${hash}: ${one}`));
      // Some lines are seen above it.
      const room = (await page.locator('.cm-scroller').boundingBox())!;
      if (room.height < 100) wrong.push(`${hash}: ${room.height} px of text`);
      const keys = (await pad.boundingBox())!;
      if (keys.y + keys.height > 600) wrong.push(`${hash}: the keypad ends at ${keys.y + keys.height}`);
      await shoot(page, `keypad-${hash.split('/').slice(0, 2).join('-')}`);
    }
    expect(wrong).toEqual([]);
    // MDI is typed by it too.
    await show(page, 'program/mdi');
    await page.locator('main .cm-content').tap();
    for (const name of ['M', '3']) await pad.locator(`[data-pad="${name}"]`).tap();
    // Behind what was typed there before.
    await expect(page.locator('main .cm-content')).toHaveText(/M3$/);
    await page.getByTestId('keypad-toggle').tap();
    await expect(pad).toHaveCount(0);
    await expect(page.locator('main .cm-content')).toHaveAttribute('inputmode', 'text');
  });
});
