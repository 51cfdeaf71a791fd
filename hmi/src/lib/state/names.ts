// Names of programs: `O` and a number, or one of letters, digits, - and _.

/** Digits that an O number has at most. */
const DIGITS = 8;
/** Characters that any other name has at most. */
const LONGEST = 64;

const numberedName = (digits: string) => `O${digits.replace(/^0+(?=\d{4})/, '').padStart(4, '0')}`;

/** The name that was typed, or why it is none. */
export function typedName(text: string): { name: string } | { wrong: 'digits' | 'signs' } {
  const clean = text.trim();
  const digits = /^O?(\d+)$/i.exec(clean)?.[1];
  if (digits !== undefined) {
    const name = numberedName(digits);
    return name.length <= DIGITS + 1 ? { name } : { wrong: 'digits' };
  }
  return /^[\p{L}\p{N}_-]+$/u.test(clean) && clean.length <= LONGEST ? { name: clean } : { wrong: 'signs' };
}

/** The name under which a file is stored: `O` and a number where it has one, such as `O12.nc`. */
export function programName(file: string, text: string): string {
  const inside = /^\s*%?\s*[O:](\d{1,8})(?!\d)/i.exec(text)?.[1];
  const outside = /^O?(\d{1,8})(\.\w+)?$/i.exec(file)?.[1];
  const number = inside ?? outside;
  return number ? numberedName(number) : file.replace(/\.[^.]*$/, '');
}

/** What a new program begins with. A name that is no O number is no word of a program. */
export function begun(name: string): string {
  return `${/^O\d+$/.test(name) ? `${name}\n` : ''}\nM30\n`;
}

/** The text of a program under another name: an O number at its start follows. */
export function numbered(text: string, name: string): string {
  const number = /^O(\d+)$/.exec(name)?.[1];
  return number === undefined ? text : text.replace(/^(\ufeff?\s*%?\s*[O:])\d{1,8}/i, (_, head: string) => head + number);
}
