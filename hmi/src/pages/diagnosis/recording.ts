// A recording of the control: waited for, then read in as many answers as it takes (`docs/api.md`, waveforms).

/** What `captured` answers. */
export type Part = { done: boolean; samples: number; csv: string };
/** Times in s since the trigger or the beginning, and the values of each quantity. */
export type Recording = { names: string[]; times: number[]; lines: number[][] };

/** Rows that one answer may have: the server gives fewer where they would be too long. */
const MOST = 4000;

/** Rows of an answer; the line of the names is not one of them. */
function rowsOf(csv: string): string[] {
  return csv.split('\n').filter((row) => row !== '');
}

/** Waits until all samples are there, then reads them. Nothing where `wait` says that nobody wants it any more. */
export async function recorded(ask: (from: number, most: number) => Promise<Part>, wait: () => Promise<boolean>): Promise<Recording | null> {
  // Before the end the oldest rows make room for new ones, so that their numbers would not stay.
  while (!(await ask(0, 0)).done) if (!(await wait())) return null;
  const first = await ask(0, MOST);
  const [head = 't', ...rows] = rowsOf(first.csv);
  while (rows.length < first.samples) {
    const more = rowsOf((await ask(rows.length, MOST)).csv);
    // Another recording was begun meanwhile.
    if (more.length === 0) return null;
    rows.push(...more);
  }
  const names = head.split(',').slice(1);
  const times: number[] = [];
  const lines: number[][] = names.map(() => []);
  for (const row of rows) {
    const cells = row.split(',');
    times.push(Number(cells[0]));
    for (let index = 0; index < names.length; index++) lines[index]!.push(Number(cells[index + 1]));
  }
  return { names, times, lines };
}
