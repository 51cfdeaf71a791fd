// A ladder as a list (`docs/plc.md`), read into rungs for the drawing. Instructions keep their number, by which the
// control tells where power flows.

export type Contact = { kind: 'contact'; name: string; not: boolean; index: number; meaning: string };
export type Node =
  | Contact
  | { kind: 'series'; parts: Node[] }
  | { kind: 'parallel'; parts: Node[]; /** The instruction that joins them. */ index: number };
export type Output = { kind: 'coil' | 'function'; text: string; name: string; not: boolean; index: number; meaning: string };
export type Rung = { conditions: Node[]; outputs: Output[]; comment: string; line: number };
export type Symbols = Map<string, { address: string; meaning: string }>;
export type Ladder = { rungs: Rung[]; symbols: Symbols; instructions: number };

const BASIC = new Set([
  'RD', 'RD.NOT', 'AND', 'AND.NOT', 'OR', 'OR.NOT', 'RD.STK', 'RD.NOT.STK', 'AND.STK', 'OR.STK', 'WRT', 'WRT.NOT', 'SET', 'RST',
]);
const FUNCTIONS = new Set(
  ('END1 END2 TMR DEC CTR ROT COD MOVE COM JMP PARI DCNV COMP COIN DSCH XMOV ADD SUB MUL DIV NUME TMRB DECB ROTB CODB COME JMPE ' +
    'DCNVB COMPB SFT DSCHB XMOVB ADDB SUBB MULB DIVB NUMEB MOVB MOVW MOVN MOVD TMRC CTRC DIFU DIFD EOR AND OR NOT END CALL CALLU JMPB ' +
    'LBL NOP SP SPE JMPC').split(' '),
);

type Line = { words: string[]; comment: string; number: number };

function linesOf(text: string): Line[] {
  return text.split('\n').map((whole, index) => {
    const at = whole.indexOf(';');
    const code = at < 0 ? whole : whole.slice(0, at);
    return { words: code.trim().split(/\s+/).filter(Boolean), comment: at < 0 ? '' : whole.slice(at + 1).trim(), number: index + 1 };
  });
}

function join(kind: 'series', a: Node, b: Node): Node {
  const parts = (node: Node) => (node.kind === kind ? node.parts : [node]);
  return { kind, parts: [...parts(a), ...parts(b)] };
}

/** What a ladder says of itself: the first words of the remark that it begins with; empty where there is none. */
export function headOf(text: string): string {
  for (const { words, comment } of linesOf(text)) {
    if (words.length) return '';
    if (comment) return comment;
  }
  return '';
}

/** Reads a ladder; `meanings` of signals take the place of its own remarks. What it cannot make sense of it leaves out: the control checks ladders, not the drawing. */
export function readLadder(text: string, meanings: ReadonlyMap<string, string> = new Map()): Ladder {
  const symbols: Symbols = new Map();
  const rungs: Rung[] = [];
  let stack: Node[] = [];
  let rung: Rung | null = null;
  let index = 0;
  let comment = '';
  const lines = linesOf(text);
  for (const { words, comment: remark } of lines) {
    if (words[1] === '=' && words[0] && words[2]) symbols.set(words[0], { address: words[2], meaning: meanings.get(words[0]) || remark });
  }
  const meaning = (name: string) => symbols.get(name)?.meaning ?? '';
  const contact = (name: string, not: boolean): Contact => ({ kind: 'contact', name, not, index, meaning: meaning(name) });
  const finish = () => {
    if (rung && rung.outputs.length) rungs.push({ ...rung, conditions: rung.conditions.length ? rung.conditions : stack });
    rung = null;
    stack = [];
  };
  const current = (line: number): Rung => {
    rung ??= { conditions: [], outputs: [], comment, line };
    comment = '';
    return rung;
  };
  for (const { words, comment: remark, number } of lines) {
    const [first = '', operand = ''] = words;
    if (!first) {
      // Rules that part sections are for the eye of who reads the text.
      const words = remark.replace(/[-=*]{4,}/g, '').trim();
      if (words) comment = comment ? `${comment} ${words}` : words;
      else if (!remark) comment = '';
      continue;
    }
    if (words[1] === '=') {
      comment = '';
      continue;
    }
    const code = first.toUpperCase();
    const isFunction = (FUNCTIONS.has(code) && !(BASIC.has(code) && !/^\d/.test(operand))) || (code === 'SUB' && /^\d/.test(operand));
    if (!BASIC.has(code) && !isFunction) {
      // A parameter of the function above, in a line of its own.
      const last: Output | undefined = (rung as Rung | null)?.outputs.at(-1);
      if (last?.kind === 'function') last.text += ` ${words.filter((word) => word.toUpperCase() !== 'PRM').join(' ')}`;
      continue;
    }
    if (isFunction) {
      const into = current(number);
      into.conditions = [...stack];
      into.outputs.push({ kind: 'function', text: words.join(' '), name: code, not: false, index, meaning: remark });
    } else if (code === 'RD' || code === 'RD.NOT') {
      finish();
      const into = current(number);
      if (remark) into.comment ||= remark;
      stack = [contact(operand, code === 'RD.NOT')];
    } else if (code === 'RD.STK' || code === 'RD.NOT.STK') {
      stack.push(contact(operand, code === 'RD.NOT.STK'));
    } else if (code.startsWith('WRT') || code === 'SET' || code === 'RST') {
      const into = current(number);
      if (!into.conditions.length) into.conditions = [...stack];
      const text = code === 'SET' ? 'S' : code === 'RST' ? 'R' : '';
      into.outputs.push({ kind: 'coil', text, name: operand, not: code === 'WRT.NOT', index, meaning: meaning(operand) });
    } else {
      const top = stack.pop();
      if (code === 'AND.STK' || code === 'OR.STK') {
        const below = stack.pop();
        if (top && below) stack.push(code === 'AND.STK' ? join('series', below, top) : { kind: 'parallel', parts: [below, top], index });
        else if (top) stack.push(top);
      } else {
        const one = contact(operand, code.endsWith('.NOT'));
        if (!top) stack.push(one);
        else if (code.startsWith('AND')) stack.push(join('series', top, one));
        else if (top.kind === 'parallel' && top.parts.every((part) => part.kind === 'contact')) {
          stack.push({ kind: 'parallel', parts: [...top.parts, one], index });
        } else stack.push({ kind: 'parallel', parts: [top, one], index });
      }
    }
    index++;
  }
  finish();
  return { rungs, symbols, instructions: index };
}

/** All signals that a rung names. */
export function signalsOf(rung: Rung): string[] {
  const names = new Set<string>();
  const visit = (node: Node): void => {
    if (node.kind === 'contact') names.add(node.name);
    else node.parts.forEach(visit);
  };
  rung.conditions.forEach(visit);
  for (const output of rung.outputs) if (output.kind === 'coil') names.add(output.name);
  return [...names];
}
