// The pictures of the pages, of which the walk of `machine.spec.ts` makes one each: run it before.
import { expect, test } from '@playwright/test';
import { existsSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { pages } from './pages';

test('there is a picture of each page and of each of its tabs', () => {
  const names = Object.entries(pages).flatMap(([page, tabs]) => (tabs.length ? tabs.map((tab) => `page-${page}-${tab}`) : [`page-${page}`]));
  const missing = names.filter((name) => {
    const file = join(import.meta.dirname, `../test-results/screens/${name}.png`);
    return !existsSync(file) || statSync(file).size === 0;
  });
  expect(missing).toEqual([]);
});
