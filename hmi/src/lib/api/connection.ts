// What connections tell and are told besides the control's own (docs/serve.md).
// Written from crates/server/src/told.rs by `FERROCUT_WRITE=1 cargo test -p ferrocut-server types`.

/**
 * The session as it is told.
 */
export type SessionInfo = {
/**
 * 1 to 4; 0 for the operator, and before a log-in where that is needed.
 */
level: number,
/**
 * Whether nothing is told before somebody logs in.
 */
needs_log_in: boolean, };

/**
 * What the panel must know of the machine before it draws.
 */
export type PanelInfo = {
/**
 * Whether a ladder runs.
 */
ladder: boolean,
/**
 * Languages of texts, by their tags.
 */
languages: Array<string>, };

/**
 * The first line of a connection.
 */
export type Hello = {
/**
 * `ferrocut`.
 */
hello: string,
/**
 * Version of the service's commands.
 */
api: number,
/**
 * The connection's number.
 */
connection: number,
/**
 * Bytes of a line that is taken.
 */
longest_line: number,
/**
 * How long a connection that holds a key may be silent, ms.
 */
dead_man_ms: number,
/**
 * Of a browser's connection alone.
 */
panel?: PanelInfo,
/**
 * Of a browser's connection alone.
 */
session?: SessionInfo, };

/**
 * Who asks for command.
 */
export type Asking = {
/**
 * The number of his connection.
 */
connection: number,
/**
 * Where from, an address; empty on the machine's own sockets.
 */
from: string,
/**
 * The level of his session, 1 to 5, of which 5 is the operator.
 */
level: number, };

/**
 * Events of connections, told to those who watch events.
 */
export type ConnectionEvent = { "event": "command",
/**
 * The number of a connection.
 */
holder: number | null,
/**
 * Whether it is the one that is told.
 */
you: boolean,
/**
 * Those who ask for command, first come first.
 */
asking: Array<Asking>, } | { "event": "declined",
/**
 * The connection in command.
 */
by: number, };

/**
 * Commands of the connection itself.
 */
export type ConnectionCommand = { "do": "take_command" } | { "do": "give_command" } | { "do": "ask_for_command" } | { "do": "withdraw_request" } | { "do": "hand_over",
/**
 * The number of his connection.
 */
to: number, } | { "do": "decline",
/**
 * The number of his connection.
 */
to: number, } | { "do": "watch",
/**
 * Events.
 */
events: boolean,
/**
 * The status, every 20 ms.
 */
status: boolean, } | { "do": "alive" };
