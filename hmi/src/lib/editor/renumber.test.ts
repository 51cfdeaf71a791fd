import { expect, it } from 'vitest';
import { pieces } from './highlight';
import { renumber } from './renumber';

it('numbers blocks and follows jumps', () => {
  const text = '%\nO0001 (PART)\nN5 G0 X1\n/ G1 Y2\n(note)\n\nN7 IF [#1 EQ 2] GOTO 5\nM30\n%';
  expect(renumber(text.split('\n'), 10, 10).lines.join('\n')).toBe(
    '%\nO0001 (PART)\nN10 G0 X1\n/ N20 G1 Y2\n(note)\n\nN30 IF [#1 EQ 2] GOTO 10\nN40 M30\n%',
  );
});

it('a jump to a number that is not there stays as it is', () => {
  expect(renumber(['GOTO 99', 'G65 H80 P98'], 1, 1)).toEqual({ lines: ['N1 GOTO 99', 'N2 G65 H80 P98'], computed: 0 });
});

it('follows the jumps of macro A', () => {
  const text = ['N1 G65 H01 P#100 Q0', 'N2 G65 H84 P1 Q#100 R5', 'P2 G65 H080', 'G65 Q#1 P2 R#2 H86 (P1)', 'G65H81P1Q#1R2', 'G65 P2 H87', 'G65 P2 A1', 'M98 P1 H80'];
  expect(renumber(text, 10, 10)).toEqual({
    lines: [
      'N10 G65 H01 P#100 Q0',
      'N20 G65 H84 P10 Q#100 R5',
      'N30 P20 G65 H080',
      'N40 G65 Q#1 P20 R#2 H86 (P1)',
      'N50 G65H81P10Q#1R2',
      'N60 G65 P2 H87',
      'N70 G65 P2 A1',
      'N80 M98 P1 H80',
    ],
    computed: 0,
  });
});

it('follows jumps to an N', () => {
  const text = ['N5 $IF P1 == 2', '$GOTO N7', '$ENDIF', 'GOTO N 5 ; GOTO 7', 'N7 goto n005 (GOTO N5)', 'N8 G1 X1'];
  expect(renumber(text, 1, 1)).toEqual({
    lines: ['N1 $IF P1 == 2', 'N2 $GOTO N5', 'N3 $ENDIF', 'N4 GOTO N 1 ; GOTO 7', 'N5 goto n1 (GOTO N5)', 'N6 G1 X1'],
    computed: 0,
  });
});

it('jumps whose target is computed stay as they are, and are counted', () => {
  const text = ['GOTO #1', 'GOTO[#1+1]', 'IF [#1 EQ 2] GOTO#3', 'G65 H80 P#100', '$GOTO NP1', 'GOTO 1 (GOTO #1)', 'G65 H02 P#1 Q#2 R1'];
  expect(renumber(text, 1, 1)).toEqual({ lines: text.map((line, at) => `N${at + 1} ${line}`), computed: 5 });
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
