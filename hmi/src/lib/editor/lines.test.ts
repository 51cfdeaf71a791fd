import { expect, it } from 'vitest';
import { linesOf, textOf } from './lines';

const TEXTS = ['', 'G0', 'G0\n', 'G0\r\n', '%\nG0\n\n%', '%\r\nG0\r\n\r\n%', 'G0\rG1', 'G0\r\nG1\n', 'G0\r\r\nG1', 'G0\n\rG1', 'G0\r', '\n', '\r\n\n\r'];

it('splits at every kind of line end as the editor does, and puts together what was', () => {
  for (const text of TEXTS.flatMap((text) => [text, `\ufeff${text}`])) {
    const found = linesOf(text);
    expect(found.lines, JSON.stringify(text)).toEqual(text.replace('\ufeff', '').split(/\r\n?|\n/));
    expect(textOf(found), JSON.stringify(text)).toBe(text);
  }
});

it('ends new lines as most are ended', () => {
  expect(['G0', 'G0\r\nG1\r\nG2\n', 'G0\r\nG1\nG2\n', 'G0\rG1'].map((text) => linesOf(text).end)).toEqual(['\n', '\r\n', '\n', '\r']);
  const text = linesOf('G0\r\nG1\nG2\r\n');
  expect([...text.others]).toEqual([[1, '\n']]);
});
