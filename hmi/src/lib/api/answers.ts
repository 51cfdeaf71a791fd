// What the server answers over HTTP (docs/panel-api.md).
// Written from crates/server/src/web/ and crates/desk by `FERROCUT_WRITE=1 cargo test -p ferrocut-server types`.
import type { Refusal } from './types';

/**
 * Why a request was refused, as it is told.
 */
export type Trouble = {
/**
 * A code, for programs.
 */
error?: string,
/**
 * What of it, for programs.
 */
detail?: string,
/**
 * What the control refused it with.
 */
refused?: Refusal, };

/**
 * Something wrong in a program.
 */
export type Finding = {
/**
 * The alarm's number: `gsk990mc:0045`, `FC-0302`.
 */
id: string,
/**
 * `error` or `warning`.
 */
severity: 'error' | 'warning',
/**
 * The program that it is in, where that is not the one that was checked.
 */
program?: string,
/**
 * The line, from 1; 0 where no place is meant.
 */
line: number,
/**
 * Where the words at fault begin, in units of UTF-16 from 1.
 */
column: number,
/**
 * The line in which they end.
 */
end_line: number,
/**
 * Where they end; the last one lies before it.
 */
end_column: number,
/**
 * What is wrong.
 */
text: string,
/**
 * What to do about it.
 */
help: string | null, };

export type Findings = { findings: Array<Finding>, };

/**
 * An alarm in words.
 */
export type AlarmText = { id: string, text: string,
/**
 * What to do about it.
 */
help: string | null, };

/**
 * One thing to say.
 */
export type Fact = { label: string, text: string, };

/**
 * Rows of a name and what is to say of it, or of a name, a value and that.
 */
export type Table = { label: string, rows: Array<Array<string>>, };

/**
 * What `ferrocut explain` says of a word.
 */
export type Explanation = {
/**
 * Whether there is such a thing; else `text` says why not.
 */
found: boolean, kind: string, title: string, text: string,
/**
 * What is to say of it, each with its label.
 */
facts: Array<Fact>,
/**
 * What else bears on it, such as the parameters with their values.
 */
tables: Array<Table>,
/**
 * Where the manual has it.
 */
source: string,
/**
 * The same for programs.
 */
page?: unknown, };

/**
 * A code or keyword of the control language.
 */
export type Word = { word: string, kind: string, title: string, form: string, };

/**
 * A bit of a parameter.
 */
export type Bit = { bit: number, name: string, symbol: string, meaning: string, standard: number, level: number, used: boolean, };

/**
 * What a parameter is.
 */
export type ParameterKind = "bit" | "data";

/**
 * A parameter of the control, with its bits.
 */
export type Parameter = {
/**
 * The number, or the name of one without.
 */
number: number | string,
/**
 * What the command `parameters` calls it; of bits each has its own.
 */
name: string, kind: ParameterKind, bits: Array<Bit>, symbol: string, meaning: string, unit: string, minimum: number | null, maximum: number | null, standard: number, level: number, room: string,
/**
 * Whether this version does something with it; of bits, with one at least.
 */
used: boolean, };

/**
 * A signal of the ladder.
 */
export type Signal = { name: string, address: string, meaning: string, };

/**
 * Something that can be looked up.
 */
export type Found = { kind: string, key: string, title: string, text: string, };

/**
 * A backup of the list.
 */
export type Backup = { name: string, bytes: number,
/**
 * When it was written, ms since 1970 (UTC).
 */
changed: number, };

/**
 * A file for DNC.
 */
export type DncFile = {
/**
 * What it is called where it came from.
 */
name: string, bytes: number,
/**
 * Bytes of it that the control has.
 */
sent: number,
/**
 * Whether the control is still given the rest.
 */
sending: boolean,
/**
 * Why it is not.
 */
refused?: Refusal, };
