// What the control knows of a program while it is written: its codes, what each means, and what is wrong.
import { autocompletion, type CompletionContext, type CompletionResult } from '@codemirror/autocomplete';
import { linter, setDiagnostics, type Diagnostic } from '@codemirror/lint';
import { hoverTooltip, type EditorView } from '@codemirror/view';
import type { Extension, Text } from '@codemirror/state';
import type { Finding } from '$lib/api/answers';
import { http } from '$lib/api/http';
import { language } from '$lib/i18n/index.svelte';
import { completions } from './completions';

/** Characters: programs longer than this are checked when they are saved, not as they are typed. */
export const LARGEST_CHECKED = 400_000;

/** Offsets of a finding; places outside the text are brought to its end. */
export function place(doc: Text, finding: Finding): { from: number; to: number } {
  const offset = (line: number, column: number) => {
    const at = doc.line(Math.max(1, Math.min(line, doc.lines)));
    return Math.min(at.from + Math.max(0, column - 1), at.to);
  };
  const from = offset(finding.line, finding.column);
  const to = offset(finding.end_line || finding.line, finding.end_column);
  if (to > from) return { from, to };
  // A finding without width: the whole line shows it.
  const line = doc.lineAt(from);
  return { from: line.from, to: Math.max(line.to, line.from) };
}

/** Findings as the editor marks them. */
function marks(doc: Text, findings: Finding[]): Diagnostic[] {
  return findings.slice(0, 500).map((finding) => ({
    ...place(doc, finding),
    severity: finding.severity,
    source: finding.id,
    message: finding.help ? `${finding.text}\n${finding.help}` : finding.text,
  }));
}

/** Checks what stands there now, however long it is, and marks what is wrong. Findings of a text that was changed
    meanwhile are marked nowhere. */
export async function checkNow(view: EditorView, dialect: string): Promise<Finding[]> {
  const { doc } = view.state;
  const { findings } = await http.check(doc.toString(), dialect, language());
  if (view.state.doc.eq(doc)) view.dispatch(setDiagnostics(view.state, marks(doc, findings)));
  return findings;
}

function checked(dialect: () => string, found: (findings: Finding[]) => void): Extension {
  let running: AbortController | undefined;
  return linter(
    async (view: EditorView): Promise<Diagnostic[]> => {
      running?.abort();
      running = new AbortController();
      if (view.state.doc.length > LARGEST_CHECKED) return [];
      const { findings } = await http.check(view.state.doc.toString(), dialect(), language(), running.signal);
      found(findings);
      return marks(view.state.doc, findings);
    },
    { delay: 300 },
  );
}

function complete(dialect: () => string) {
  return async (context: CompletionContext): Promise<CompletionResult | null> => {
    const typed = context.matchBefore(/[A-Za-z]+\d*\.?\d*/);
    // A letter alone is an address; only of G and M are there codes to choose from.
    if (!context.explicit && (!typed || (typed.text.length < 2 && !/[GM]/i.test(typed.text)))) return null;
    const words = await http.words(dialect(), language()).catch(() => []);
    const options = completions(words, typed?.text ?? '').map(({ word: label, title }) => ({ label, detail: title, type: 'keyword' }));
    return { from: typed?.from ?? context.pos, options, filter: false };
  };
}

function explained(dialect: () => string): Extension {
  return hoverTooltip(async (view, at) => {
    const line = view.state.doc.lineAt(at);
    if (line.length > 2000) return null;
    for (const match of line.text.matchAll(/#?[A-Za-z]\s?\d+(\.\d+)?|#\d+/g)) {
      const from = line.from + match.index;
      const to = from + match[0].length;
      if (at < from || at > to) continue;
      const word = match[0].replace(/\s/g, '').toUpperCase();
      const about = await http.explain(word, dialect(), language()).catch(() => null);
      if (!about?.found) return null;
      return {
        pos: from,
        end: to,
        create: () => {
          const dom = document.createElement('div');
          dom.className = 'nc-hover';
          const title = document.createElement('strong');
          title.textContent = `${word} · ${about.title}`;
          const text = document.createElement('div');
          text.textContent = about.text;
          const source = document.createElement('small');
          source.textContent = about.source;
          source.className = 'muted';
          dom.append(title, text, source);
          return { dom };
        },
      };
    }
    return null;
  });
}

/** Completion, explanations and checks of a control language. */
export function controlLanguage(dialect: () => string, found: (findings: Finding[]) => void): Extension {
  return [
    // Enter ends a line unless a code was chosen first.
    autocompletion({ override: [complete(dialect)], icons: false, selectOnOpen: false }),
    explained(dialect),
    checked(dialect, found),
  ];
}
