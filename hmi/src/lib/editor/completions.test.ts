import { expect, it } from 'vitest';
import { completions } from './completions';

const words = ['G00', 'G01', 'G10', 'G81', 'M03', 'M30', 'SIN', 'SQRT', 'IF'].map((word) => ({ word, kind: '', title: '', form: '' }));
const found = (typed: string) => completions(words, typed).map(({ word }) => word);

it('completes codes with and without their zeros, the one that is typed whole first', () => {
  expect(found('G')).toEqual(['G00', 'G01', 'G10', 'G81']);
  expect(found('g0')).toEqual(['G00', 'G01']);
  expect(found('G1')).toEqual(['G01', 'G10']);
  expect(found('M3')).toEqual(['M03', 'M30']);
  expect(found('si')).toEqual(['SIN']);
  expect(found('X1')).toEqual([]);
});
