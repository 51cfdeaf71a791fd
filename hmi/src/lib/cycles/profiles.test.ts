import { expect, it } from 'vitest';
import type { Contour, Element } from '$lib/api/cycles';
import { fits, isName, profiles } from './profiles.svelte';

const line = (...to: [number, number]): Element => ({ kind: 'line', to, corner: null });
const closed: Contour = { start: [0, 0], elements: [line(10, 0), line(10, 10), line(0, 0)], entry: 2, exit: 1 };
const open: Contour = { start: [0, 0], elements: [line(5, -10)], entry: 0, exit: 0 };
const round: Contour = { start: [5, 0], elements: [{ kind: 'arc', to: [5, 0], center: [0, 0], clockwise: false, corner: null }], entry: 0, exit: 0 };

it('a profile fits where its cycle can have it', () => {
  expect(fits([closed, round], false, 'contours')).toBe(true);
  expect(fits([closed, open], false, 'contours')).toBe(false);
  expect(fits([closed, round], false, 'path')).toBe(false);
  expect(fits([round], false, 'path')).toBe(true);
  expect(fits([round], false, 'points')).toBe(false);
  expect(fits([open], false, 'points')).toBe(true);
  expect(fits([{ ...open, elements: Array.from({ length: 25 }, (_, i) => line(i + 1, 0)) }], false, 'points')).toBe(false);
  // One of depth stands upright, and is open.
  expect(fits([open], true, 'depth')).toBe(true);
  expect(fits([open], false, 'depth')).toBe(false);
  expect(fits([open], true, 'path')).toBe(false);
  expect(fits([closed], true, 'depth')).toBe(false);
});

it('a profile that is taken is a copy, with ways in and out where it is followed', () => {
  profiles.keep('PLATE', [closed], false);
  profiles.get('PLATE', 'path')[0]!.start[0] = 99;
  expect(profiles.get('PLATE', 'path')).toEqual([closed]);
  expect(profiles.get('PLATE', 'contours')).toEqual([{ ...closed, entry: 0, exit: 0 }]);
  expect(profiles.of('depth')).toEqual([]);
  profiles.remove('PLATE');
  expect(profiles.has('PLATE')).toBe(false);
});

it('a name stands in a block as it is', () => {
  expect(['A', 'FAGOR_110', 'a1', '1A', 'A B', '', 'A'.repeat(33)].map(isName)).toEqual([true, true, true, false, false, false, false]);
});
