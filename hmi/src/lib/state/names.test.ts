import { expect, it } from 'vitest';
import { begun, numbered, programName, typedName } from './names';

it('a typed name is an O number, or letters, digits, - and _', () => {
  for (const text of ['O1', 'o0001', '1', ' 00001 ']) expect(typedName(text), text).toEqual({ name: 'O0001' });
  expect(typedName('O12345678')).toEqual({ name: 'O12345678' });
  for (const name of ['bracket', 'PLATE-2', '零件', 'a_1', 'O12A']) expect(typedName(name)).toEqual({ name });
  for (const text of ['O123456789', '999999999']) expect(typedName(text), text).toEqual({ wrong: 'digits' });
  for (const text of ['', '../x', 'O1.nc', 'a b', 'a/b', 'x'.repeat(65)]) expect(typedName(text), text).toEqual({ wrong: 'signs' });
});

it('a file has the number that stands in it, else that of its name, else its name', () => {
  expect(programName('part.nc', '%\nO12 (PART)\n')).toBe('O0012');
  expect(programName('O00012.nc', 'G0 X1\n')).toBe('O0012');
  expect(programName('12', '')).toBe('O0012');
  expect(programName('plate-2.nc', 'G0\n')).toBe('plate-2');
  // No number is made of a part of a longer one.
  expect(programName('O123456789.nc', '')).toBe('O123456789');
  expect(programName('part.nc', 'O123456789\n')).toBe('part');
});

it('a program begins with its name where that is an O number', () => {
  expect(begun('O0012')).toBe('O0012\n\nM30\n');
  expect(begun('bracket')).toBe('\nM30\n');
});

it('the O number of a text follows its name', () => {
  expect(numbered('%\nO0001 (PART)\nM30\n', 'O0002')).toBe('%\nO0002 (PART)\nM30\n');
  expect(numbered('O0001\n', 'plate')).toBe('O0001\n');
});
