import { describe, expect, it } from 'vitest';
import { cycleAt, readBlock } from './read';

const POCKET = ['#CYCLE G287 [X=0, Y=12.5, L=80, H=-50, type=round, P=10]', '#ROUGH [I=5, T=1]', '#FINISH [delta=0.2, T=2]', '#MULTI POINTS [P2=[10, 20], P3=[-30.5, 0], N=3]'];

describe('a block that is read again', () => {
  it('has the values of its stages and its figure', () => {
    const form = readBlock(POCKET)!;
    expect(form.cycle).toBe('G287');
    expect(form.values).toEqual({ X: 0, Y: 12.5, L: 80, H: -50, type: 'round', P: 10, 'rough.I': 5, 'rough.T': 1, 'finish.delta': 0.2, 'finish.T': 2 });
    expect(form.positions).toEqual([{ kind: 'POINTS', values: { N: 3 }, points: [[10, 20], [-30.5, 0]] }]);
  });
  it('has its profiles, flat ones and those of depth', () => {
    const form = readBlock([
      '#PROFILE SHAPE [XY]', 'G0 X-40 Y0', 'G37 I2', 'G1 X-40 Y-25', 'G36 I8', 'G3 X0 Y-25 I20 J0', 'G39 I1.5', 'G38 I3', 'G0 X5 Y5', 'G2 X5 Y5 I-5 J0', '#ENDPROFILE',
      '#PROFILE DEPTH1 [XZ]', 'G0 X-40 Z0', 'G1 X-35 Z-10', 'G2 X-30 Z-15 I0 K-5', '#ENDPROFILE', '#CYCLE P3D [profile=SHAPE, Z1=DEPTH1, P=10]',
    ])!;
    expect(form.profile!.contours).toEqual([
      { start: [-40, 0], entry: 2, exit: 3, elements: [
        { kind: 'line', to: [-40, -25], corner: { kind: 'round', size: 8 } },
        { kind: 'arc', to: [0, -25], center: [-20, -25], clockwise: false, corner: { kind: 'chamfer', size: 1.5 } },
      ] },
      { start: [5, 5], entry: 0, exit: 0, elements: [{ kind: 'arc', to: [5, 5], center: [0, 5], clockwise: true, corner: null }] },
    ]);
    expect(form.depths).toEqual([{ plane: 'XZ', contour: { start: [-40, 0], entry: 0, exit: 0, elements: [
      { kind: 'line', to: [-35, -10], corner: null }, { kind: 'arc', to: [-30, -15], center: [-35, -15], clockwise: true, corner: null },
    ] } }]);
    expect(form.values).toMatchObject({ profile: 'SHAPE', Z1: 'DEPTH1', P: 10 });
  });
  it('has the points of a profile from point to point', () => {
    const form = readBlock(['#CYCLE G293 [Z=0, P1=[0, 0], P2=[10, 0, round, 2], P3=[10, 10]]'])!;
    expect(form.profile!.contours).toEqual([
      { start: [0, 0], entry: 0, exit: 0, elements: [{ kind: 'line', to: [10, 0], corner: { kind: 'round', size: 2 } }, { kind: 'line', to: [10, 10], corner: null }] },
    ]);
  });
  it('is none without a cycle, or with a line that no profile has', () => {
    expect(readBlock(['#ROUGH [I=5]'])).toBe(null);
    expect(readBlock(['#PROFILE A [XY]', 'G5 X1 Y2', '#CYCLE P2D [P=1]'])).toBe(null);
  });
});

describe('a cycle of a program', () => {
  it('is found as the control has it', () => {
    const lines = ['%A', 'G0 X0', ...POCKET, 'M30'];
    expect([2, 3, 6, 7].map((line) => cycleAt(lines, line)?.from ?? 0)).toEqual([0, 3, 3, 0]);
    expect(cycleAt(lines, 4)).toMatchObject({ from: 3, to: 6 });
    // With the plane and the unit that it was written for, which its next text brings along.
    expect(cycleAt(['%A', 'G17 G71 G90', ...POCKET], 3)).toMatchObject({ from: 2, to: 6 });
    expect(cycleAt(['G17 G71 G90', 'G0 X0', ...POCKET], 1)).toBe(null);
  });
  it('is found by its remarks, to its end', () => {
    const moves = ['G17 G21', 'G0 Z5', '(NOT ITS END)', 'G1 Z-1'];
    const lines = ['O1', '(G287 RECTANGULAR POCKET)', ...POCKET.map((line) => `(${line})`), ...moves, '(END G287)', 'M30'];
    expect(cycleAt(lines, 9)).toMatchObject({ from: 2, to: 11, request: { cycle: 'G287' } });
    expect(cycleAt(lines, 1)).toBe(null);
    expect(cycleAt(lines, 12)).toBe(null);
    // Of another control, and one whose end is gone.
    expect(cycleAt(lines.map((line) => line.replace(/^\((.*)\)$/, "'$1")), 9)).toMatchObject({ from: 2, to: 11 });
    expect(cycleAt(lines.filter((line) => line !== '(END G287)'), 9)).toBe(null);
    expect(cycleAt(['(G287 IS DONE BY HAND)', 'G0 X0', '(END G287)'], 2)).toBe(null);
  });
});
