// A machine made of answers, for what needs no true one: figures, sizes, keys. The files are those of `dist`.
import type { BrowserContext, Page, WebSocketRoute } from '@playwright/test';
import { existsSync, readFileSync } from 'node:fs';
import { createServer, type ServerResponse } from 'node:http';
import type { AddressInfo } from 'node:net';
import { join } from 'node:path';

const dist = join(import.meta.dirname, '../dist');
const types: Record<string, string> = { html: 'text/html', js: 'text/javascript', css: 'text/css', svg: 'image/svg+xml' };
export type Sent = { at: number; do: string; [field: string]: unknown };
export type Mock = {
  page: Page;
  /** The address of the panel. */
  home: string;
  sent: Sent[];
  /** Cuts the connection. */
  cut(): void;
  /** Tells no more status: a browser that is told on and on has not always closed a page. */
  quiet(): void;
  /** Says something besides, such as an event. */
  say(line: object): void;
  /** Who is logged in. */
  session: { level: number };
};
export type Options = {
  program?: string;
  /** What /api/path answers. */
  path?: Buffer;
  alarm?: boolean;
  /** What the program says to the operator. */
  says?: string;
  mode?: string;
  /** Lamps that are lit besides. */
  lamps?: string[];
  isDryRun?: boolean;
  /** Letters of the axes; X Y Z A unless told. */
  axes?: string[];
  welcomed?: boolean;
  /** Whether the status moves, 50 times a second. */
  moves?: boolean;
  /** What /api/path answers in the place of a path. */
  noPath?: { status: number; body: string };
  /** What a check finds. */
  findings?: object[];
  /** Names that its ladder has besides, by area. */
  signals?: Record<string, { name: string; address: string; meaning: string; value: number }[]>;
  /** How many entries the operation log has. */
  logged?: number;
  /** Values of parameters. */
  parameters?: Record<string, number>;
  /** By how much the handwheel has shifted axes. */
  interruption?: Record<string, number>;
  /** Whether nothing is told before a log-in. */
  needsLogIn?: boolean;
};

const short = 'O0001 (PART)\nN10 G00 X0 Y0\nN20 G01 X50 F900\nN30 G03 X60 Y10 R10\nM30\n';

export async function mock(context: BrowserContext, options: Options = {}): Promise<Mock> {
  const page = await context.newPage();
  const sent: Sent[] = [];
  let socket: WebSocketRoute | null = null;
  let emergency = false;
  let quiet = (): void => undefined;
  const session = { level: 0, needs_log_in: options.needsLogIn ?? false };
  if (options.welcomed !== false) {
    await page.addInitScript(() => {
      if (!localStorage.getItem('ferrocut.panel')) localStorage.setItem('ferrocut.panel', '{"welcomed":true}');
    });
  }
  const server = createServer((request, response) => {
    const url = new URL(request.url ?? '/', 'http://localhost');
    if (url.pathname === '/api/session') {
      if (request.method === 'POST') session.level = 4;
      if (request.method === 'DELETE') session.level = 0;
      response.writeHead(200, { 'content-type': 'application/json' });
      return response.end(JSON.stringify(session));
    }
    if (url.pathname.startsWith('/api/')) return answer(response, url, options);
    const file = join(dist, url.pathname === '/' ? 'index.html' : url.pathname);
    if (!file.startsWith(dist) || !existsSync(file)) return response.writeHead(404).end();
    response.writeHead(200, { 'content-type': types[file.split('.').at(-1) ?? ''] ?? 'text/plain' });
    response.end(readFileSync(file));
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  context.on('close', () => {
    server.closeAllConnections();
    server.close();
  });
  const home = `http://127.0.0.1:${(server.address() as AddressInfo).port}/`;
  await page.routeWebSocket(/\/api\/socket$/, (ws) => {
    // A socket without a session gets no further than the guard.
    if (session.needs_log_in && session.level === 0) return void ws.close();
    socket = ws;
    let timer: ReturnType<typeof setInterval> | undefined;
    let tick = 0;
    const say = (line: object) => ws.send(JSON.stringify(line));
    say({
      hello: 'ferrocut', api: 1, connection: 1, longest_line: 4194304, dead_man_ms: 250,
      panel: { ladder: true, languages: ['en', 'zh', 'ru', 'es', 'tr'] }, session: { ...session },
    });
    say({ event: 'command', holder: 1, you: true, asking: [] });
    ws.onClose(() => clearInterval(timer));
    ws.onMessage((text) => {
      const command = JSON.parse(String(text)) as Sent & { id?: number; program?: string };
      sent.push({ ...command, at: performance.now() });
      if (command.id === undefined) return;
      if (command.do === 'emergency_stop') emergency = command.pressed === true;
      if (command.do === 'watch') {
        quiet = () => clearInterval(timer);
        timer = setInterval(() => say({ status: { ...status(options.moves === false ? 0 : tick++, options), ...(emergency ? { activity: 'emergency' } : {}) } }), 20);
      }
      say({ id: command.id, ...reply(command, options) });
    });
  });
  await page.goto(home);
  return { page, home, sent, session, cut: () => void socket?.close(), quiet: () => quiet(), say: (line) => socket?.send(JSON.stringify(line)) };
}

const lettersOf = (options: Options) => options.axes ?? ['X', 'Y', 'Z', 'A'];
/** Values of the axes, in their order. */
const placed = (options: Options, ...values: number[]): Record<string, number> => Object.fromEntries(lettersOf(options).map((axis, index) => [axis, values[index]!]));

function reply(command: Sent & { program?: string }, options: Options): object {
  switch (command.do) {
    case 'version':
      return { reply: 'version', api: 1, software: '0.1.0', dialect: 'gsk990mc', machine: 'Demo mill', axes: lettersOf(options), period_ms: 1 };
    case 'status':
      return { reply: 'status', ...status(0, options) };
    case 'programs':
      return { reply: 'programs', programs: [{ name: 'O0001', bytes: (options.program ?? short).length, comment: 'PART', changed: 1.79e12, locked: null }] };
    case 'read':
      // One that is longer than a line of the socket comes as a file.
      if ((options.program?.length ?? 0) > 1e6) return { error: 'no_answer', detail: 'too long' };
      return { reply: 'program', program: command.program, text: options.program ?? short };
    case 'mdi_text':
      return { reply: 'mdi_text', text: '', block: '' };
    case 'offsets':
      return { reply: 'offsets', offsets: { 1: { length: -102.35, radius: 5 } } };
    case 'zeros':
      return { reply: 'zeros', zeros: { G54: placed(options, 1, 2, 3, 0) } };
    case 'variables':
      return { reply: 'variables', variables: { 100: 1.5 } };
    case 'parameters':
      return { reply: 'parameters', parameters: options.parameters ?? {}, given: [], left_to_file: [] };
    case 'signals':
      return { reply: 'signals', signals: {} };
    case 'signal_table':
      return { reply: 'signal_table', signals: options.signals?.[String(command.area)] ?? [] };
    case 'ladder':
      return { reply: 'text', text: 'KEY_A = X20.0 ; key\nRD KEY_A\nWRT R1.0\nEND1\nEND2\nEND\n' };
    case 'ladder_flow':
      return { reply: 'ladder_flow', power: [true, true] };
    case 'alarm_history':
      return { reply: 'alarm_history', alarms: [] };
    case 'operation_log':
      return {
        reply: 'operation_log',
        entries: Array.from({ length: Math.min(Number(command.most), options.logged ?? 0) }, (_, index) => ({ time: 1.79e12 - index * 6e4, level: 3, who: 'Panel', item: 'parameters', name: `P${(options.logged ?? 0) - index}`, from: '1', to: '2' })),
      };
    default:
      return { reply: 'done' };
  }
}

function status(tick: number, options: Options): object {
  const angle = tick / 50;
  const work = placed(options, 50 + 30 * Math.sin(angle), 40 + 20 * Math.cos(angle), -3 + 2 * Math.sin(3 * angle), 10 * angle);
  const zero = placed(options, 0, 0, 0, 0);
  return {
    periods: tick * 20, mode: options.mode ?? 'auto', program_mode: 'auto', activity: options.alarm ? 'alarm' : 'running',
    finishing_block: false, alarms: options.alarm ? [{ id: 'FC-0302', line: 3, warning: false, values: {} }] : [],
    position: { machine: work, actual: work, work, absolute: work, relative: work, to_go: { ...zero, X: 80 - work.X! }, interruption: { ...zero, ...options.interruption }, system: 'G54' },
    feed: { actual: 890 + 10 * Math.sin(angle), programmed: 900, feed_override: 1, rapid_override: 0.5, manual_override: 1, components: {} },
    spindle: { programmed: 2400, told: 2400, actual: -2390, spindle_override: 1.1, tool: 1, called_tool: 2 },
    program: { selected: 'O0001', cursor: 1, running: 'O0001', line: 2 + (Math.floor(angle) % 3), block: 'N20 G01 X50 F900', g_codes: ['G01', 'G17', 'G21', 'G54', 'G90'], h: 1, d: 5 },
    switches: { single_block: false, block_skip: false, optional_stop: true, dry_run: options.isDryRun ?? false, machine_lock: false, auxiliary_lock: false },
    counters: { parts: 17, all_parts: 1200, run_time: 4000 + angle, cutting_time: 3200 + angle, power_on_time: 90_000 },
    referenced: ['X', 'Y', 'Z'], messages: [], program_message: options.says ?? '', dnc: null, lamps: ['LAMP_AUTO', 'LAMP_START', ...(options.lamps ?? [])], panel: { SWITCH_FEED: 10, SWITCH_SPINDLE: 6 }, level: 5,
  };
}

function answer(response: ServerResponse, url: URL, options: Options): void {
  const json = (value: unknown) => {
    response.writeHead(200, { 'content-type': 'application/json' });
    response.end(JSON.stringify(value));
  };
  switch (url.pathname) {
    case '/api/path':
      if (options.noPath) return void response.writeHead(options.noPath.status).end(options.noPath.body);
      response.writeHead(options.path ? 200 : 404);
      response.end(options.path);
      return;
    case '/api/programs/O0001':
      response.writeHead(200, { 'content-type': 'text/plain' });
      response.end(options.program ?? short);
      return;
    case '/api/check':
      return json({ findings: options.findings ?? [] });
    case '/api/alarm':
      return json({ id: 'FC-0302', text: 'An arc has no centre', help: 'Give I, J, K or R.' });
    case '/api/explain':
      return json({ found: false, kind: '', title: '', text: '', facts: [], tables: [], source: '' });
    case '/api/dnc':
      return json(null);
    case '/api/words':
    case '/api/parameters':
    case '/api/signals':
    case '/api/search':
      return json([]);
    default:
      response.writeHead(404).end();
  }
}
