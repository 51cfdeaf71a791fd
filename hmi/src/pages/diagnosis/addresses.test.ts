import { expect, it } from 'vitest';
import { addressOf, bytesOf } from './addresses';

it('an address is a byte or a bit that there is', () => {
  expect(['x0020.3', ' K5 ', 'R9117', 'D9999', 'F0'].map(addressOf)).toEqual(['X20.3', 'K5', 'R9117', 'D9999', 'F0']);
  for (const text of ['', 'X128', 'X1.8', 'R8000', 'B1', 'X', '20.3', 'X20.']) expect(addressOf(text)).toBeNull();
});

it('an area has each of its bytes', () => {
  expect(bytesOf('X')).toHaveLength(128);
  expect([bytesOf('R')[7999], bytesOf('R')[8000], bytesOf('R').at(-1)]).toEqual(['R7999', 'R9000', 'R9117']);
});
