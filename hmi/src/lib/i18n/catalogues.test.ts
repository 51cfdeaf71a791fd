import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { parse, type AST } from 'svelte/compiler';
import ts from 'typescript';
import { describe, expect, it } from 'vitest';
import { form, text } from './plural';

const root = join(import.meta.dirname, '../..');
const languages = ['en', 'zh', 'ru', 'es', 'tr'];

function files(folder: string, end: string): string[] {
  return readdirSync(folder, { recursive: true })
    .map(String)
    .filter((name) => name.endsWith(end))
    .map((name) => join(folder, name))
    .sort();
}

function catalogue(language: string): Record<string, string> {
  const all: Record<string, string> = {};
  for (const file of files(join(root, 'locales', language), '.json')) {
    const page = file.split('/').at(-1)!.slice(0, -5);
    const texts = JSON.parse(readFileSync(file, 'utf8')) as Record<string, string>;
    for (const [key, value] of Object.entries(texts)) all[`${page}.${key}`] = value;
  }
  return all;
}

const catalogues = Object.fromEntries(languages.map((language) => [language, catalogue(language)]));
const plural = /_(one|two|few|many|other)$/;
/** Keys without their plural forms. */
const bare = (keys: string[]) => [...new Set(keys.map((key) => key.replace(plural, '')))].sort();
const names = (value: string) => [...value.matchAll(/\{(\w+)\}/g)].map((found) => found[1]).sort();

describe('catalogues', () => {
  const english = catalogues.en!;
  it.each(languages)('%s has every key, and no other', (language) => {
    const mine = catalogues[language]!;
    expect(bare(Object.keys(mine))).toEqual(bare(Object.keys(english)));
    expect(Object.keys(mine).filter((key) => mine[key]!.trim() === '')).toEqual([]);
  });
  it.each(languages)('%s has the plural forms that the language needs', (language) => {
    const mine = catalogues[language]!;
    const forms = new Set(Array.from({ length: 200 }, (_, count) => form(language, count)));
    for (const key of Object.keys(mine).filter((one) => plural.test(one))) {
      const base = key.replace(plural, '');
      for (const one of forms) expect(mine, `${base}_${one}`).toHaveProperty([`${base}_${one}`]);
    }
  });
  it.each(languages)('%s names the same values as English', (language) => {
    const mine = catalogues[language]!;
    for (const [key, value] of Object.entries(mine)) {
      const other = english[key] ?? english[key.replace(plural, '_other')];
      if (other !== undefined) expect(names(value), `${language} ${key}`).toEqual(names(other));
    }
  });
  it('are not copies of English', () => {
    for (const language of ['zh', 'ru', 'es', 'tr']) {
      const mine = catalogues[language]!;
      const words = Object.keys(english).filter((key) => /[a-z]{4,} [a-z]{3,}/.test(english[key]!));
      expect(words.filter((key) => mine[key] === english[key]), language).toEqual([]);
    }
  });
});

describe('codes of the server', () => {
  it('have a text each', () => {
    const server = join(root, '../../crates/server/src');
    const codes = new Set<string>();
    for (const file of ['web/problem.rs', 'web/query.rs', 'web/tables.rs', 'web/programs.rs', 'web/socket.rs', 'hub.rs', 'lines.rs']) {
      const source = readFileSync(join(server, file), 'utf8');
      // A status with its code; errors of a line, also those of the loop; ends of a connection; a detail for programs.
      const said = /StatusCode::\w+, "(\w+)"|\berror\("(\w+)"|"(?:error|end)": "(\w+)"|break "(\w+)"|NoMachine\("(\w+)"|map_err\(\|_\| "(\w+)"\)|Unreadable\("(not_text)"/g;
      for (const found of source.matchAll(said)) codes.add(found.slice(1).find(Boolean)!);
    }
    expect([...codes]).toEqual(expect.arrayContaining(['too_slow', 'too_often', 'missing', 'other_origin', 'unknown_host', 'line_too_long', 'taken', 'no_answer', 'logged_out', 'not_text', 'no_machine']));
    // The page that is closed itself says nothing.
    codes.delete('closed');
    expect([...codes].filter((code) => !(`error.${code}` in catalogues.en!))).toEqual([]);
  });
});

describe('the source', () => {
  const components = files(root, '.svelte');
  const scripts = files(root, '.ts').filter((file) => !file.endsWith('.test.ts'));

  it('asks for no key that is missing', () => {
    const english = catalogues.en!;
    const known = new Set([...Object.keys(english), ...bare(Object.keys(english))]);
    const missing: string[] = [];
    for (const file of [...components, ...scripts]) {
      for (const [, key] of readFileSync(file, 'utf8').matchAll(/\bt\(\s*'([\w.-]+)'/g)) {
        if (!known.has(key!)) missing.push(`${file}: ${key}`);
      }
    }
    expect(missing).toEqual([]);
  });

  /** Calls of `t` with a key that stands there, and what each gives: names of values, null where they come from elsewhere. */
  function calls(code: string): { key: string; given: string[] | null }[] {
    const found: { key: string; given: string[] | null }[] = [];
    const visit = (node: ts.Node): void => {
      if (ts.isCallExpression(node) && ts.isIdentifier(node.expression) && node.expression.text === 't') {
        const [key, values] = node.arguments;
        if (key && ts.isStringLiteral(key)) {
          const own = !values ? [] : ts.isObjectLiteralExpression(values) ? values.properties.map((one) => (one.name && ts.isIdentifier(one.name) ? one.name.text : null)) : [null];
          found.push({ key: key.text, given: own.includes(null) ? null : (own as string[]) });
        }
      }
      ts.forEachChild(node, visit);
    };
    visit(ts.createSourceFile('code.ts', code, ts.ScriptTarget.Latest, true));
    return found;
  }
  /** The code of a component: its script, and the expressions of its template one by one. */
  function codeOf(source: string, file: string): string {
    const parts: string[] = [...source.matchAll(/<script[^>]*>([\s\S]*?)<\/script>/g)].map((found) => found[1]!);
    const visit = (node: unknown): void => {
      if (Array.isArray(node)) return node.forEach(visit);
      if (typeof node !== 'object' || node === null || !('type' in node)) return;
      const at = node as AST.SvelteNode & { start: number; end: number; callee?: { name?: string } };
      if ((at.type as string) === 'CallExpression' && at.callee?.name === 't') parts.push(source.slice(at.start, at.end));
      for (const value of Object.values(at)) visit(value);
    };
    visit(parse(source, { modern: true, filename: file }).fragment);
    return parts.join(';\n');
  }

  it('gives each text the values that it names, and no text shows a name in braces', () => {
    expect(calls("t('a.b', { n, m: 1 }); t('a.c'); t('a.d', all)")).toEqual([{ key: 'a.b', given: ['n', 'm'] }, { key: 'a.c', given: [] }, { key: 'a.d', given: null }]);
    const english = catalogues.en!;
    const wrong: string[] = [];
    let seen = 0;
    for (const file of [...components, ...scripts]) {
      const source = readFileSync(file, 'utf8');
      for (const { key, given } of calls(file.endsWith('.svelte') ? codeOf(source, file) : source)) {
        seen += 1;
        const value = english[key] ?? english[`${key}_other`];
        if (value === undefined || given === null) continue;
        const lacking = names(value).filter((name) => !given.includes(name!));
        if (lacking.length) wrong.push(`${file}: ${key} without ${lacking.join(', ')}`);
      }
    }
    expect(seen).toBeGreaterThan(500);
    expect(wrong).toEqual([]);
  }, 60_000);

  /** What looks like words and is none that people read: keys, names of errors, styles, shaders; what languages and
      keys of the keyboard are called everywhere. */
  const known = new Set(['English', 'Русский', 'Español', 'Türkçe', 'HttpError', 'Refused', 'Enter', 'Delete', 'Control', 'Ctrl', 'Shift', 'ArrowUp', 'ArrowDown', 'ArrowLeft', 'ArrowRight', 'Alt', 'Escape', 'Mod-s', 'DownloadURL']);
  const looks = (value: string) => (/\p{Ll}{2,} +\p{L}{2,}/u.test(value) || /^\p{Lu}\p{Ll}{2,}/u.test(value)) && !known.has(value);

  /** Texts of a template. */
  function textsIn(source: string, file = ''): string[] {
    const told = new Set(['title', 'aria-label', 'placeholder', 'alt', 'label', 'text', 'hint', 'aria-valuetext']);
    /** What is written in them is for the browser. */
    const forBrowser = new Set(['class', 'style', 'd', 'viewBox', 'transform', 'points']);
    const found: string[] = [];
    const visit = (node: unknown, isTold: boolean): void => {
      if (Array.isArray(node)) return node.forEach((one) => visit(one, isTold));
      if (typeof node !== 'object' || node === null || !('type' in node)) return;
      const at = node as AST.SvelteNode & Record<string, unknown>;
      if (at.type === 'Text') {
        if (isTold && /\p{L}{2,}/u.test(at.data)) found.push(at.data.trim());
      } else if (at.type === 'Attribute') {
        if (!forBrowser.has(at.name)) visit(at.value, told.has(at.name));
      } else if (at.type === 'Literal') {
        if (typeof at.value === 'string' && looks(at.value)) found.push(at.value);
      } else if (at.type === 'TemplateElement') {
        const { cooked } = at.value as { cooked?: string };
        if (cooked && looks(cooked)) found.push(cooked);
      } else for (const value of Object.values(at)) visit(value, isTold);
    };
    visit(parse(source, { modern: true, filename: file }).fragment, true);
    return found;
  }

  it('is looked through: what stands between tags, in attributes that are read, and in expressions', () => {
    const wrong = ["<p>Door</p>", '<p title="Door" />', "<p>{open ? 'Open door' : ''}</p>", '<p>{`the door ${n}`}</p>', "<Key label={open ? 'Open' : t('a.b')} />", "<p onclick={() => notify({ title: 'Door is open' })} />", "{#if open}{'Open door'}{/if}", "{#each ['Open', 'Close'] as one}{one}{/each}"];
    expect(wrong.filter((one) => textsIn(one).length === 0)).toEqual([]);
    const right = ["<p class={open ? 'row wrap' : 'row'}>{t('app.open')}</p>", '<p data-testid="open-door">{open}: 5</p>', "{#if kind === 'edge'}{t(`settings.${kind}`)}{/if}"];
    expect(right.flatMap((one) => textsIn(one))).toEqual([]);
  });

  it('has no text of its own in its templates', () => {
    const wrong = components.flatMap((file) => textsIn(readFileSync(file, 'utf8'), file).map((text) => `${file}: ${text}`));
    expect(wrong).toEqual([]);
  }, 60_000);

  it('has no text of its own in its scripts', () => {
    // CodeMirror's phrases are keys: what is said for each is a text of the catalogues.
    const apart = /(^|\/)(phrases|theme)\.ts$|graphics\/scene\.ts$/;
    const wrong: string[] = [];
    for (const file of [...components, ...scripts].filter((one) => !apart.test(one))) {
      const source = readFileSync(file, 'utf8');
      const text = file.endsWith('.svelte') ? [...source.matchAll(/<script[^>]*>([\s\S]*?)<\/script>/g)].map((found) => found[1]).join('\n') : source;
      const visit = (node: ts.Node): void => {
        const isText = ts.isStringLiteral(node) || ts.isTemplateLiteralToken(node);
        if (isText && looks(node.text) && !/system-ui$/.test(node.text)) wrong.push(`${file}: ${node.text}`);
        ts.forEachChild(node, visit);
      };
      visit(ts.createSourceFile(file, text, ts.ScriptTarget.Latest, true));
    }
    expect(wrong).toEqual([]);
  });
});

describe('texts', () => {
  it('take values and plural forms', () => {
    const texts = { 'a.parts_one': '{count} деталь', 'a.parts_few': '{count} детали', 'a.parts_many': '{count} деталей' };
    expect(text(texts, 'ru', 'a.parts', { count: 21 })).toBe('21 деталь');
    expect(text(texts, 'ru', 'a.parts', { count: 3 })).toBe('3 детали');
    expect(text(texts, 'ru', 'a.parts', { count: 11 })).toBe('11 деталей');
    expect(text(texts, 'ru', 'a.nothing')).toBe('a.nothing');
  });
});
