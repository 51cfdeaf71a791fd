import { unit } from "../i18n/index.svelte.js";
// src/lib/api/http.ts
/** An answer that is no success. */
var HttpError = class extends Error {
	status;
	/** Why, for programs. */
	code = "";
	/** What of it, for programs. */
	detail = "";
	/** The alarm with which the control refused it. */
	alarm = null;
	constructor(status, message) {
		super(message);
		this.status = status;
		this.name = "HttpError";
		try {
			const { error, detail, refused } = JSON.parse(message);
			this.code = error ?? "";
			this.detail = detail ?? "";
			this.alarm = refused?.alarm ?? null;
		} catch {}
	}
};
/** Asks a path of the server. Throws an `HttpError` unless it succeeds. */
async function request(path, options = {}) {
	const response = await fetch(path, {
		...options,
		credentials: "same-origin"
	});
	if (!response.ok) throw new HttpError(response.status, (await response.text()).slice(0, 500));
	return response;
}
async function json(path, options) {
	return await (await request(path, options)).json();
}
var query = (values) => new URLSearchParams(values).toString();
/** The same of a large body, which tells how much of it went. */
function bring(path, body, signal, went) {
	return new Promise((done, fail) => {
		const sending = new XMLHttpRequest();
		sending.open("PUT", path);
		sending.upload.onprogress = (event) => went(event.loaded);
		sending.onload = () => {
			if (sending.status >= 200 && sending.status < 300) done(sending.responseText);
			else fail(new HttpError(sending.status, sending.responseText.slice(0, 500)));
		};
		sending.onerror = () => fail(/* @__PURE__ */ new TypeError());
		sending.onabort = () => fail(signal.reason);
		signal.addEventListener("abort", () => sending.abort());
		sending.send(body);
	});
}
/** Answers that stay the same while the server runs. */
var kept = /* @__PURE__ */ new Map();
function once(path) {
	let answer = kept.get(path);
	if (!answer) {
		answer = json(path);
		kept.set(path, answer);
		answer.catch(() => kept.delete(path));
	}
	return answer;
}
var http = {
	session() {
		return json("/api/session");
	},
	logIn(level, password) {
		return json("/api/session", {
			method: "POST",
			headers: { "content-type": "application/json" },
			body: JSON.stringify({
				level,
				password
			})
		});
	},
	async logOut() {
		await request("/api/session", { method: "DELETE" });
	},
	check(text, dialect, language, signal) {
		const options = {
			method: "POST",
			body: text,
			headers: { "content-type": "text/plain" }
		};
		if (signal) options.signal = signal;
		return json(`/api/check?${query({
			dialect,
			language
		})}`, options);
	},
	async path(program, signal) {
		return (await request(`/api/path?${query({ program })}`, signal ? { signal } : {})).arrayBuffer();
	},
	async pathOf(text, dialect, signal) {
		const options = {
			method: "POST",
			body: text,
			headers: { "content-type": "text/plain" }
		};
		if (signal) options.signal = signal;
		return (await request(`/api/path?${query({ dialect })}`, options)).arrayBuffer();
	},
	alarm(id, values, language) {
		return once(`/api/alarm?${query({
			id,
			values: JSON.stringify(values),
			language
		})}`);
	},
	explain(word, dialect, language) {
		return once(`/api/explain?${query({
			word,
			dialect,
			language
		})}`);
	},
	words(dialect, language) {
		return once(`/api/words?${query({
			dialect,
			language
		})}`);
	},
	/** The control's parameters, with the signs of units in the user's language. */
	async parameters(language) {
		return (await once(`/api/parameters?${query({ language })}`)).map((one) => ({
			...one,
			unit: unit(one.unit)
		}));
	},
	signals(language) {
		return once(`/api/signals?${query({ language })}`);
	},
	search(q, language) {
		return json(`/api/search?${query({
			q,
			language
		})}`);
	},
	list(kind, language) {
		return json(`/api/list?${query({
			kind,
			language
		})}`);
	},
	backups() {
		return json("/api/backups");
	},
	/** Brings a backup into the folder of the memory. */
	async bringBackup(name, body) {
		await request(this.backup(name), {
			method: "PUT",
			body
		});
	},
	/** Where a backup is taken away. */
	backup(name) {
		return `/api/backups/${encodeURIComponent(name)}`;
	},
	dnc() {
		return json("/api/dnc");
	},
	stopDnc() {
		return json("/api/dnc", { method: "DELETE" });
	},
	async bringDnc(file, signal, went) {
		return JSON.parse(await bring(`/api/dnc/${encodeURIComponent(file.name)}`, file, signal, went));
	},
	async upload(name, body) {
		await request(`/api/programs/${encodeURIComponent(name)}`, {
			method: "PUT",
			body
		});
	},
	async program(name) {
		const bytes = await (await request(this.download(name))).arrayBuffer();
		return new TextDecoder("utf-8", { ignoreBOM: true }).decode(bytes);
	},
	download(name) {
		return `/api/programs/${encodeURIComponent(name)}`;
	}
};
export { HttpError, http, request };
