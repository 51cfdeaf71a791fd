// src/lib/parts/held.ts
/** Makes an element a held key. */
function held(key) {
	return (element) => {
		let pointer = null;
		let byKeyboard = false;
		let current = null;
		const press = (at) => {
			if (current) return;
			current = key();
			element.dataset.held = "";
			current.down(at);
		};
		const letGo = () => {
			pointer = null;
			byKeyboard = false;
			if (!current) return;
			const was = current;
			current = null;
			delete element.dataset.held;
			was.up();
		};
		const on = {
			pointerdown(event) {
				if (event.button !== 0 || element.hasAttribute("disabled")) return;
				if (pointer !== null && element.hasPointerCapture(pointer)) return;
				letGo();
				pointer = event.pointerId;
				try {
					element.setPointerCapture(event.pointerId);
				} catch {}
				press(event.timeStamp);
			},
			pointerup(event) {
				if (event.pointerId === pointer) letGo();
			},
			pointercancel: letGo,
			lostpointercapture(event) {
				if (event.pointerId === pointer) letGo();
			},
			keydown(event) {
				if (event.key !== " " && event.key !== "Enter" || event.repeat || element.hasAttribute("disabled")) return;
				event.preventDefault();
				byKeyboard = true;
				press(event.timeStamp);
			},
			keyup(event) {
				if (!byKeyboard || event.key !== " " && event.key !== "Enter") return;
				event.preventDefault();
				letGo();
			},
			blur() {
				if (byKeyboard) letGo();
			},
			contextmenu(event) {
				event.preventDefault();
			}
		};
		const away = () => {
			if (document.visibilityState === "hidden") letGo();
		};
		for (const [name, handler] of Object.entries(on)) element.addEventListener(name, handler);
		window.addEventListener("blur", letGo);
		document.addEventListener("visibilitychange", away);
		return () => {
			letGo();
			for (const [name, handler] of Object.entries(on)) element.removeEventListener(name, handler);
			window.removeEventListener("blur", letGo);
			document.removeEventListener("visibilitychange", away);
		};
	};
}
export { held };
