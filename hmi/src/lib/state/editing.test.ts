import { describe, expect, it } from 'vitest';
import { codesLost, editing, lineFor, placeOf } from './editing.svelte';

const program = 'O0001\nG0 X0\nM3 S300 (M30 COMES LATER)\nM30\n';

describe('text for a program', () => {
  it('goes behind the cursor, but never behind the end', () => {
    expect(lineFor(program, 2)).toBe(2);
    expect(lineFor(program, 9)).toBe(3);
  });
  it('goes before the end where there is no cursor', () => {
    expect(lineFor(program, 0)).toBe(3);
    expect(lineFor('G0\r\nM02', 0)).toBe(1);
    expect(lineFor('G0 X1\nG0 X2\n', 0)).toBe(2);
    expect(lineFor("G0 ' M30\nG1", 0)).toBe(2);
  });
  it('waits until its program is shown, once', () => {
    editing.put('O0001', 'G81');
    expect([editing.waits('O0002'), editing.waits('O0001'), editing.take(), editing.waits('O0001')]).toEqual([false, true, 'G81', false]);
  });
  it('a line that is to be shown waits for its program, once', () => {
    editing.goTo('O0001', 7);
    expect([editing.takeLine('O0001'), editing.takeLine('O0001')]).toEqual([7, 0]);
    editing.goTo('O0001', 7);
    expect([editing.takeLine('O0002'), editing.takeLine('O0001')]).toEqual([0, 0]);
  });
  it('keeps what is not saved, of its program alone', () => {
    const one = { text: 'G1', base: 'G0' };
    editing.leave('O0001', 3, one);
    expect([editing.draft('O0001'), editing.draft('O0002'), editing.line]).toEqual([one, null, 3]);
    const two = { text: 'G2', base: 'G0' };
    editing.leave('O0002', 1, two);
    editing.leave('O0003', 1, null);
    expect([editing.draft('O0001'), editing.draft('O0002'), editing.program]).toEqual([one, two, 'O0003']);
    editing.moved('O0002', 'O0004');
    editing.leave('O0001', 3, null);
    expect(editing.unsaved).toEqual(['O0004']);
    editing.moved('O0004', null);
    expect(editing.unsaved).toEqual([]);
  });
});

describe('codes that a cycle takes out of force', () => {
  const cycle = '(G287)\nG17 G21 G90 G94 G40 G80\nG0 X1.\n';
  it('are those that stand last above it', () => {
    expect(codesLost('O1\nG20 G91\nG0G19 F1\nG95 S1\nG1 G42 D1 X1.', cycle)).toEqual(['G19', 'G20', 'G91', 'G95', 'G42']);
    expect(codesLost('G70 G018', cycle)).toEqual(['G18', 'G70']);
  });
  it('are none where the same are in force, or stand in a remark', () => {
    expect(codesLost('G91\nG90 G71 G17\n(G20)\nG28.1 X0 ; G95', cycle)).toEqual([]);
    expect(codesLost('', cycle)).toEqual([]);
    expect(codesLost('G91 G18', 'G81 X1. R2. Z-3.')).toEqual([]);
  });
});

describe('text in place of lines', () => {
  it('goes where they stand, the nearest of several', () => {
    const text = ['A', 'B', 'C', 'A', 'B', 'D'];
    expect([placeOf(text, ['A', 'B'], 1), placeOf(text, ['A', 'B'], 5), placeOf(text, ['B', 'C'], 9)]).toEqual([1, 4, 2]);
  });
  it('goes nowhere where they do not', () => {
    expect([placeOf(['A', 'B'], ['B', 'C'], 1), placeOf(['A'], [], 1)]).toEqual([0, 0]);
  });
  it('waits with them', () => {
    editing.put('O0001', 'G81', ['G80']);
    expect(editing.instead).toEqual(['G80']);
    editing.take();
    expect(editing.instead).toEqual([]);
  });
});
