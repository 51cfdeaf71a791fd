import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';

const root = join(import.meta.dirname, '../../..');
const files = readdirSync(join(root, 'src'), { recursive: true, encoding: 'utf8' })
  .filter((file) => /\.(ts|svelte)$/.test(file) && !file.endsWith('.test.ts'))
  .map((file) => join('src', file));
const names = (file: string) =>
  [...readFileSync(join(root, file), 'utf8').matchAll(/(?:import|export) (?!type)\{([^}]*)\} from 'three'/g)].flatMap((found) => found[1]!.split(',').map((name) => name.trim()).filter(Boolean));

it('three.js is bundled with what the panel imports of it, and no more', () => {
  const used = new Set(files.flatMap(names));
  expect(names('build/three.ts').toSorted()).toEqual([...used].toSorted());
  expect(used.size).toBeGreaterThan(5);
});
