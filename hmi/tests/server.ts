// A control for the tests: `ferrocut serve` with a memory of its own, on a port that the system chooses.
import { test as base, type BrowserContext, type Page } from '@playwright/test';
import { spawn, spawnSync, type ChildProcess } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

/** Passwords of the levels that the tests log in with. */
export const PASSWORDS: Record<number, string> = { 1: 'maker of controls', 2: 'builder of mills', 3: 'commissioning crew', 4: 'head of the shop' };
const binary = process.env.FERROCUT ?? join(import.meta.dirname, '../../target/debug/ferrocut');

/** A picture of a page: an artefact of the tests, and with `SCREENS=write` one of the README besides. */
export async function shoot(page: Page, name: string, shown = ''): Promise<void> {
  const picture = await page.screenshot({ path: join(import.meta.dirname, `../test-results/screens/${name}.png`) });
  if (shown && process.env.SCREENS === 'write') writeFileSync(join(import.meta.dirname, `../../docs/${shown}.png`), picture);
}

export type Server = { url: string; memory: string };

/** Starts it and waits for its address. `machine` is what a machine file has besides the demo mill's, or in place of its dialect. */
async function serve(memory: string, machine: string): Promise<{ child: ChildProcess; url: string }> {
  const file = `${memory}.toml`;
  if (machine) {
    const mill = readFileSync(join(import.meta.dirname, '../../machines/demo-mill.toml'), 'utf8');
    const dialect = /^dialect = .*$/m.exec(machine)?.[0];
    const standard = mill.replace(/^public_programs.*$/m, '').replace(/^dialect.*$/m, (its) => dialect ?? its);
    writeFileSync(file, `${standard}\n${machine.replace(dialect ?? '', '')}`);
  }
  const which = machine ? ['--machine', file] : [];
  const child = spawn(binary, ['serve', '--memory', memory, '--http', '127.0.0.1:0', ...which], { stdio: ['ignore', 'pipe', 'pipe'] });
  let said = '';
  const url = await new Promise<string>((resolve, reject) => {
    const late = setTimeout(() => reject(new Error(`${binary} serve has not told its address:\n${said}`)), 60_000);
    const hear = (part: Buffer) => {
      said += part.toString();
      const found = /^panel (http:\/\/\S+)\s/m.exec(said);
      if (!found) return;
      clearTimeout(late);
      resolve(found[1]!.replace(/\/?$/, '/'));
    };
    child.stdout.on('data', hear);
    child.stderr.on('data', hear);
    child.on('error', (failed) => reject(new Error(`${binary}: ${failed.message}`)));
    child.on('exit', (code) => reject(new Error(`${binary} serve ended with ${code}:\n${said}`)));
  });
  return { child, url };
}

async function end(child: ChildProcess): Promise<void> {
  if (child.exitCode !== null || child.signalCode !== null) return;
  const ended = new Promise<void>((resolve) => child.once('exit', () => resolve()));
  child.kill('SIGINT');
  const late = setTimeout(() => child.kill('SIGKILL'), 20_000);
  await ended;
  clearTimeout(late);
}

/** Has a browser play the panel that was built last. */
export async function playDist(context: BrowserContext): Promise<void> {
  await context.route(/\/(app|vendor)\//, (route) =>
    route.fulfill({ path: join(import.meta.dirname, '../dist', new URL(route.request().url()).pathname) }),
  );
}

/** `server` is one control for all tests of a file's worker, `mill` what its machine has besides; `baseURL` is its panel. */
export const test = base.extend<object, { server: Server; mill: string }>({
  mill: ['', { option: true, scope: 'worker' }],
  server: [
    async ({ mill }, use) => {
      if (!existsSync(binary)) throw new Error(`There is no ${binary}: build it, or name another in FERROCUT`);
      const memory = mkdtempSync(join(tmpdir(), 'ferrocut-panel-'));
      // A first start makes the memory; then the passwords are set at the machine, which nobody can do from a browser
      // while there is none.
      await end((await serve(memory, mill)).child);
      for (const [level, password] of Object.entries(PASSWORDS)) {
        const done = spawnSync(binary, ['memory', 'password', memory, '--level', level], { input: `${password}\n`, encoding: 'utf8' });
        if (done.status !== 0) throw new Error(done.stderr);
      }
      const { child, url } = await serve(memory, mill);
      try {
        await use({ url, memory });
      } finally {
        await end(child);
        rmSync(memory, { recursive: true, force: true });
        rmSync(`${memory}.toml`, { force: true });
      }
    },
    { scope: 'worker', timeout: 120_000 },
  ],
  baseURL: async ({ server }, use) => use(server.url),
  // `PANEL=dist` plays the panel that was built last, in place of the one that the binary has in it.
  context: async ({ context }, use) => {
    if (process.env.PANEL === 'dist') await playDist(context);
    await use(context);
  },
});
export { expect, type Page } from '@playwright/test';
