import { expect, it } from 'vitest';
import { pieces } from './highlight';
import { renumber } from './renumber';

it('numbers blocks and follows jumps', () => {
  const text = '%\nO0001 (PART)\nN5 G0 X1\n/ G1 Y2\n(note)\n\nN7 IF [#1 EQ 2] GOTO 5\nM30\n%';
  expect(renumber(text.split('\n'), 10, 10).join('\n')).toBe(
    '%\nO0001 (PART)\nN10 G0 X1\n/ N20 G1 Y2\n(note)\n\nN30 IF [#1 EQ 2] GOTO 10\nN40 M30\n%',
  );
});

it('a jump to a number that is not there stays as it is', () => {
  expect(renumber(['GOTO 99'], 1, 1)).toEqual(['N1 GOTO 99']);
});

it('tells the pieces of a block apart', () => {
  const line = 'N10 G01 X-1.5 F100 M8 #100=SIN[30] (X1)';
  expect(pieces(line).map((piece) => [piece.kind, line.slice(piece.from, piece.to)])).toEqual([
    ['n', 'N10'],
    ['g', 'G01'],
    ['axis', 'X-1.5'],
    ['word', 'F100'],
    ['m', 'M8'],
    ['macro', '#100'],
    ['macro', 'SIN'],
    ['comment', '(X1)'],
  ]);
});
