import { expect, it } from 'vitest';
import { linesOf } from './lines';

it('splits at every kind of line end as the editor does', () => {
  for (const text of ['', 'G0', 'G0\n', 'G0\r\n', '%\nG0\n\n%', '%\r\nG0\r\n\r\n%', 'G0\rG1', 'G0\r\nG1\n', 'G0\r\r\nG1', 'G0\n\rG1', 'G0\r']) {
    expect(linesOf(text), JSON.stringify(text)).toEqual(text.split(/\r\n?|\n/));
  }
});
