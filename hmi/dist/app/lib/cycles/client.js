import { request } from "../api/http.js";
// src/lib/cycles/client.ts
var query = (values) => new URLSearchParams(values).toString();
var kept = /* @__PURE__ */ new Map();
function post(body, signal) {
	const options = {
		method: "POST",
		headers: { "content-type": "application/json" },
		body: JSON.stringify(body)
	};
	if (signal) options.signal = signal;
	return options;
}
var client = {
	/** Every cycle as a form; they stay the same while the server runs. */
	forms(language) {
		let answer = kept.get(language);
		if (!answer) {
			answer = request(`/api/cycles?${query({ language })}`).then((response) => response.json());
			kept.set(language, answer);
			answer.catch(() => kept.delete(language));
		}
		return answer;
	},
	/** The cycle as text in a control's language, and what is wrong with it. */
	async write(body, dialect, language, signal) {
		return await (await request(`/api/cycle?${query({
			dialect,
			language
		})}`, post(body, signal))).json();
	},
	/** The path of the cycle alone. */
	async path(body, signal) {
		return (await request("/api/cycle/path", post(body, signal))).arrayBuffer();
	},
	/** Contours of a DXF drawing. */
	async drawing(file, language) {
		return await (await request(`/api/profile/dxf?${query({ language })}`, {
			method: "POST",
			body: file
		})).json();
	}
};
export { client };
