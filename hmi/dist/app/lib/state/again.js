import { Refused } from "../api/socket.js";
import { machine } from "./machine.svelte.js";
// src/lib/state/again.ts
/** Asks until the answer is called: one question after the other, so that a slow connection is asked less often. `wanted` says
whether an answer is still of use. */
function again(pause, ask) {
	let goesOn = true;
	const wanted = () => goesOn;
	const go = async () => {
		while (goesOn) {
			if (document.visibilityState === "visible" && machine.link === "open") await ask(wanted);
			await new Promise((resolve) => setTimeout(resolve, pause));
		}
	};
	go();
	return () => {
		goesOn = false;
	};
}
/** Tells the values of signals, by name or address. */
function followSignals(names, pause, told) {
	return again(pause, async (wanted) => {
		if (!names.length) return;
		const reply = await machine.ask({
			do: "signals",
			names
		}).catch(() => null);
		if (wanted() && reply?.reply === "signals") told(reply.signals);
	});
}
/** Tells what parameters are, by name; for an effect, which asks again whenever some change. Nothing is told of those that the
control does not have, and nothing at all where the connection is lost before the answer. */
function followParameters(names, told) {
	let wanted = true;
	machine.changed("parameters");
	if (machine.link === "open") machine.ask({
		do: "parameters",
		names
	}).then((reply) => wanted && told(reply.reply === "parameters" ? reply.parameters : {}), (failed) => wanted && !(failed instanceof Refused && failed.code === "no_connection") && told({}));
	return () => {
		wanted = false;
	};
}
export { again, followParameters, followSignals };
