import { defineConfig } from '@playwright/test';

// The tests of a file one after the other: there is one machine. `tests/server.ts` starts it. Several files at a time
// (`--workers`) have one each; figures are taken alone.
// What keeps a machine safe (a key that is held, a connection that is lost, the emergency stop) is right at once, but for what
// two browsers do and the stop in a dialog, which stand in the walk: `RETRIES` are those of all else.
const SAFETY = /(keys|hand)\.spec\.ts$/;

const retries = Number(process.env.RETRIES ?? 0);
// It takes a sixth of the time: what is tried again is traced then.
const trace = retries > 0 ? 'on-first-retry' : 'retain-on-failure';

export default defineConfig({
  testDir: 'tests',
  projects: [
    { name: 'safety', testMatch: SAFETY, retries: 0, use: { trace: 'retain-on-failure' } },
    { name: 'panel', testMatch: '*.spec.ts', testIgnore: SAFETY, retries, use: { trace } },
  ],
  workers: 1,
  fullyParallel: false,
  timeout: 180_000,
  expect: { timeout: 30_000 },
  // Emptied at the begin of each run; pictures and figures stand beside it.
  outputDir: 'test-results/runs',
  reporter: [['list']],
  use: {
    viewport: { width: 1366, height: 820 },
    locale: 'en-GB',
    launchOptions: {
      executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
      args: ['--no-sandbox', '--enable-unsafe-swiftshader'],
    },
  },
});
