// src/lib/api/socket.ts
/** Why a command came to nothing: the control refused it, or the connection did. */
var Refused = class extends Error {
	code;
	alarm;
	detail;
	open;
	constructor(code, alarm, detail = "", open = false) {
		super(alarm ? alarm.id : `${code} ${detail}`.trim());
		this.code = code;
		this.alarm = alarm;
		this.detail = detail;
		this.open = open;
		this.name = "Refused";
	}
};
/** ms between signs of life while a key is held: a third of the dead man's 250 ms. */
var ALIVE_MS = 80;
/** ms between signs of life else: the server closes a socket of which nothing comes for 35 s. */
var QUIET_MS = 1e4;
/** ms before the first and the longest attempt to connect anew. */
var RETRY_MS = [250, 3e3];
/** One connection, which comes back by itself. */
var Connection = class {
	url;
	listener;
	#socket = null;
	#next = 1;
	#waiting = /* @__PURE__ */ new Map();
	#held = /* @__PURE__ */ new Set();
	#alive;
	#quiet;
	#retry;
	#attempts = 0;
	#closed = false;
	#greeted = false;
	constructor(url, listener) {
		this.url = url;
		this.listener = listener;
	}
	/** Connects, and again whenever the connection is lost. */
	open() {
		this.#closed = false;
		clearTimeout(this.#retry);
		this.listener.state("connecting");
		const socket = new WebSocket(this.url);
		this.#socket = socket;
		this.#greeted = false;
		socket.onmessage = (message) => this.#hear(String(message.data));
		socket.onclose = () => {
			if (this.#socket === socket) this.#lost();
		};
	}
	/** Ends the connection for good. Keys that it holds are let go by the machine. */
	close() {
		this.#closed = true;
		clearTimeout(this.#retry);
		this.releaseAll();
		const socket = this.#socket;
		if (socket) this.#lost();
		socket?.close();
	}
	/** Says a command and waits for the answer. */
	ask(wish) {
		return new Promise((resolve, reject) => {
			const socket = this.#socket;
			if (!socket || socket.readyState !== WebSocket.OPEN || !this.#greeted) {
				reject(new Refused("no_connection", null));
				return;
			}
			const id = this.#next++;
			this.#waiting.set(id, {
				resolve,
				reject
			});
			socket.send(JSON.stringify({
				id,
				...wish
			}));
		});
	}
	/** Presses a key and keeps it alive until `release`. */
	hold(key) {
		this.#held.add(key);
		this.#alive ??= setInterval(() => {
			this.#tell({ do: "alive" });
		}, ALIVE_MS);
		return this.ask({
			do: "key",
			key,
			down: true
		});
	}
	/** Lets a key go. */
	release(key) {
		if (!this.#held.delete(key)) return null;
		if (this.#held.size === 0) {
			clearInterval(this.#alive);
			this.#alive = void 0;
		}
		return this.ask({
			do: "key",
			key,
			down: false
		});
	}
	/** Lets all keys go: the page is left, or lost the focus. */
	releaseAll() {
		for (const key of [...this.#held]) this.release(key)?.catch(() => void 0);
	}
	#tell(wish) {
		if (this.#socket?.readyState === WebSocket.OPEN) this.#socket.send(JSON.stringify(wish));
	}
	#hear(text) {
		const line = JSON.parse(text);
		if (line.status !== void 0 && line.id === void 0) this.listener.status(line.status);
		else if (line.id !== void 0) {
			const waiting = this.#waiting.get(line.id);
			this.#waiting.delete(line.id);
			if (!waiting) return;
			if (line.reply !== void 0) waiting.resolve(line);
			else if (line.refused !== void 0) waiting.reject(new Refused("refused", line.refused.alarm ?? line.refused));
			else waiting.reject(new Refused(String(line.error), null, String(line.detail ?? "")));
		} else if (line.event !== void 0) this.listener.event(line);
		else if (line.hello !== void 0) {
			this.#attempts = 0;
			this.#greeted = true;
			this.listener.hello(line);
			this.listener.state("open");
			this.#quiet = setInterval(() => this.#tell({ do: "alive" }), QUIET_MS);
			this.ask({
				do: "watch",
				events: true,
				status: true
			}).catch(() => void 0);
		} else if (line.end !== void 0) this.listener.end(String(line.end));
	}
	#lost() {
		this.#socket = null;
		this.#greeted = false;
		clearInterval(this.#quiet);
		this.#held.clear();
		clearInterval(this.#alive);
		this.#alive = void 0;
		const waiting = [...this.#waiting.values()];
		this.#waiting.clear();
		for (const one of waiting) one.reject(new Refused("no_connection", null, "", true));
		this.listener.state("lost");
		if (this.#closed) return;
		const [first, longest] = RETRY_MS;
		this.#retry = setTimeout(() => this.open(), Math.min(first * 2 ** this.#attempts++, longest));
	}
};
export { Connection, Refused };
