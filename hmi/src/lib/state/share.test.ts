import { expect, it } from 'vitest';
import { share } from './share';

it('keeps what is as it was, and no more', () => {
  const before = { lamps: ['A', 'B'], position: { X: 1, Y: 2 }, program: { line: 3, codes: ['G1'] }, next: null };
  const now = share(before, { lamps: ['A', 'B'], position: { X: 1.5, Y: 2 }, program: { line: 4, codes: ['G1'] }, next: null });
  expect(now).toEqual({ lamps: ['A', 'B'], position: { X: 1.5, Y: 2 }, program: { line: 4, codes: ['G1'] }, next: null });
  expect(now).not.toBe(before);
  expect(now.lamps).toBe(before.lamps);
  expect(now.position).not.toBe(before.position);
  expect(now.program.codes).toBe(before.program.codes);
  expect(share(now, structuredClone(now))).toBe(now);
});

it('sees what came, what went and what became another kind', () => {
  expect(share({ a: [1, 2] }, { a: [1] })).toEqual({ a: [1] });
  expect(share({ a: [1] }, { a: [1, 2] })).toEqual({ a: [1, 2] });
  expect(share({ a: 1, b: 2 }, { a: 1 })).toEqual({ a: 1 });
  expect(share({ a: 1 }, { b: 1 })).toEqual({ b: 1 });
  expect(share({ a: {} }, { a: [] })).toEqual({ a: [] });
  expect(share({ a: null }, { a: { x: 1 } })).toEqual({ a: { x: 1 } });
  expect(share({ a: { x: 1 } }, { a: null })).toEqual({ a: null });
  expect(share(null, { a: 1 })).toEqual({ a: 1 });
});
