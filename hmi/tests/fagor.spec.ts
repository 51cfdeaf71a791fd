// A Fagor 8065 behind the panel: what its tools have besides those of the other controls.
import type { Page } from '@playwright/test';
import { expect, shoot, test } from './server';
import { enter, notice, show, watchFaults } from './walk';

watchFaults();
test.use({ mill: 'dialect = "fagor8065"' });

const field = (page: Page, name: string) => page.getByLabel(name, { exact: true });
async function set(page: Page, name: string, value: string): Promise<void> {
  await field(page, name).fill(value);
  await field(page, name).press('Enter');
}

test('cutting length, entry angle and tip of a tool are entered within their ranges', async ({ page }) => {
  await enter(page, '#/offsets/tools');
  await set(page, '3 Radius D', '5');
  await set(page, '3 Cutting length', '22.5');
  await set(page, '3 Entry angle', '4');
  await set(page, '3 Tip radius', '0.5');
  await page.reload();
  await expect(field(page, '3 Cutting length')).toHaveValue('22.500');
  await expect(field(page, '3 Entry angle')).toHaveValue('4.000');
  await expect(field(page, '3 Tip radius')).toHaveValue('0.500');
  await expect(field(page, '3 Radius D')).toHaveValue('5.000');
  // No tool enters more steeply than straight down, and none has a length below nothing.
  await set(page, '3 Entry angle', '91');
  await expect(field(page, '3 Entry angle')).toHaveAttribute('aria-invalid', 'true');
  await field(page, '3 Entry angle').press('Escape');
  await expect(field(page, '3 Entry angle')).toHaveValue('4.000');
  // What is added may be less than nothing, as long as the sum is not.
  await page.getByRole('button', { name: 'Add to what is there' }).click();
  await set(page, '3 Tip radius', '-0.25');
  await expect(field(page, '3 Tip radius')).toHaveValue('0.250');
  await set(page, '3 Tip radius', '-1');
  await expect(notice(page)).toContainText('FC-1409');
  await expect(field(page, '3 Tip radius')).toHaveValue('0.250');
  await shoot(page, 'fagor-tools');
});

test('pages of a control without parameters say so, and wait for nothing', async ({ page }) => {
  await enter(page, '#/offsets/parameters', false);
  await expect(page.locator('.parameters')).toContainText('This control has no parameters.');
  await shoot(page, 'fagor-parameters');
  await show(page, 'settings/machine_zero');
  await expect(page.locator('[data-need]')).toHaveText(['This control sets no machine zero by hand.']);
  await expect(page.getByTestId('set-machine-zero')).toBeDisabled();
  await show(page, 'settings/general');
  await expect(page.locator('.card').first()).toContainText('fagor8065');
  await expect(page.getByRole('heading', { name: 'Often set' })).toHaveCount(0);
  await show(page, 'offsets/pitch');
  await expect(page.getByTestId('pitch-points')).toBeVisible();
  await expect(page.getByRole('heading', { name: 'Pitch error' })).toHaveCount(0);
});
