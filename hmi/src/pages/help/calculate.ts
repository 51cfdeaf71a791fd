// The calculator: a sum is read as it is written, angles are degrees. No code of the browser is run.

type Token = { kind: 'number'; value: number } | { kind: 'name' | 'sign'; text: string };

function tokens(text: string): Token[] | null {
  const found: Token[] = [];
  const pattern = /\s*(?:(\d+(?:[.,]\d*)?|[.,]\d+)|([a-zπ√]+)|([-+*/^()×÷−]))/giy;
  let at = 0;
  while (at < text.trimEnd().length) {
    pattern.lastIndex = at;
    const match = pattern.exec(text);
    if (!match) return null;
    at = pattern.lastIndex;
    if (match[1] !== undefined) found.push({ kind: 'number', value: Number(match[1].replace(',', '.')) });
    else if (match[2] !== undefined) found.push({ kind: 'name', text: match[2].toLowerCase() });
    else found.push({ kind: 'sign', text: match[3]!.replace('×', '*').replace('÷', '/').replace('−', '-') });
  }
  return found;
}

const rad = Math.PI / 180;
const functions: Record<string, (value: number) => number> = {
  sin: (value) => Math.sin(value * rad),
  cos: (value) => Math.cos(value * rad),
  tan: (value) => Math.tan(value * rad),
  asin: (value) => Math.asin(value) / rad,
  acos: (value) => Math.acos(value) / rad,
  atan: (value) => Math.atan(value) / rad,
  sqrt: Math.sqrt,
  '√': Math.sqrt,
  abs: Math.abs,
};

/** Brackets and signs within each other, at most. */
const DEEPEST = 64;

/** The value of a sum; null where it has none. */
export function calculate(text: string): number | null {
  const all = tokens(text);
  if (!all || all.length === 0) return null;
  let at = 0;
  let deep = 0;
  const sign = () => {
    const token = all[at];
    return token?.kind === 'sign' ? token.text : '';
  };
  const sum = (): number => {
    let value = product();
    for (let next = sign(); next === '+' || next === '-'; next = sign()) {
      at++;
      value = next === '+' ? value + product() : value - product();
    }
    return value;
  };
  const product = (): number => {
    let value = power();
    for (let next = sign(); next === '*' || next === '/'; next = sign()) {
      at++;
      value = next === '*' ? value * power() : value / power();
    }
    return value;
  };
  const power = (): number => {
    if (++deep > DEEPEST) return NaN;
    let value: number;
    if (sign() === '-' || sign() === '+') {
      const minus = sign() === '-';
      at++;
      value = power();
      if (minus) value = -value;
    } else {
      value = one();
      if (sign() === '^') {
        at++;
        value **= power();
      }
    }
    deep--;
    return value;
  };
  const one = (): number => {
    const token = all[at++];
    if (token?.kind === 'number') return token.value;
    if (token?.kind === 'name') {
      if (token.text === 'pi' || token.text === 'π') return Math.PI;
      const call = functions[token.text];
      return call ? call(one()) : NaN;
    }
    if (token?.text === '(') {
      if (++deep > DEEPEST) return NaN;
      const value = sum();
      deep--;
      if (sign() !== ')') return NaN;
      at++;
      return value;
    }
    return NaN;
  };
  const value = sum();
  return at === all.length && Number.isFinite(value) ? value : null;
}
