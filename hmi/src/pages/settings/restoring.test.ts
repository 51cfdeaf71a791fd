import { expect, it } from 'vitest';
import { restorable } from './restoring';

const backups = [{ name: 'all.backup', bytes: 1, changed: 1 }];

it('nothing is restored from a backup that is not there', () => {
  expect(restorable('all.backup', ['offsets'], backups)).toEqual(['offsets']);
  expect(restorable('nosuch.backup', ['offsets'], backups)).toEqual([]);
});

it('the position is backed up, and not restored', () => {
  expect(restorable('all.backup', ['offsets', 'position'], backups)).toEqual(['offsets']);
  expect(restorable('all.backup', ['position'], backups)).toEqual([]);
});
