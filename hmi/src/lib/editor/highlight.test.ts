import { ChangeSet, Text } from '@codemirror/state';
import { describe, expect, it } from 'vitest';
import { follow, marksIn } from './highlight';

const whole = (doc: Text) => marksIn(doc, [{ from: 0, to: doc.length }]);
/** Marks as text: where, and how each looks. */
function read(marks: ReturnType<typeof whole>): string[] {
  const found: string[] = [];
  for (const at = marks.iter(); at.value; at.next()) found.push(`${at.from}-${at.to} ${at.value.spec.class}`);
  return found;
}

describe('marks of a part program', () => {
  it('are those of each kind', () => {
    expect(read(whole(Text.of(['N1 G1 X2 F3', '(a) M5'])))).toEqual(['0-2 nc-n', '3-5 nc-g', '9-11 nc-word', '12-15 nc-comment', '16-18 nc-m']);
  });

  it('are the same behind changes as of the text that came of them', () => {
    let seed = 1;
    const random = (below: number) => (seed = (seed * 48271) % 2147483647) % below;
    const typed = ['G1', ' ', '\n', '(', ')', 'X1', 'M3', '', 'N5 G0\n(x)\nF2', '#1'];
    let doc = Text.of(Array.from({ length: 20 }, (_, index) => `N${index} G1 X${index} F100 (pass)`));
    let marks = whole(doc);
    for (let turn = 0; turn < 500; turn++) {
      const changes = Array.from({ length: 1 + random(2) }, () => {
        const from = random(doc.length + 1);
        return { from, to: Math.min(doc.length, from + random(turn % 10 ? 4 : 40)), insert: Text.of(typed[random(typed.length)]!.split('\n')) };
      });
      let set: ChangeSet;
      try {
        set = ChangeSet.of(changes, doc.length);
      } catch {
        // Two that touch each other.
        continue;
      }
      doc = set.apply(doc);
      marks = follow(marks, doc, set);
      expect(read(marks)).toEqual(read(whole(doc)));
    }
    expect(doc.lines).toBeGreaterThan(1);
  });
});
