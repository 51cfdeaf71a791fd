(function() {
	// src/lib/digits/worker.ts
	const sheets = /* @__PURE__ */ new Map();
	/** Widths of characters, by font. */
	const widths = /* @__PURE__ */ new Map();
	/** px. All digits are as wide as the widest, so that they stand still while they change. */
	function widthOf(context, character) {
		let known = widths.get(context.font);
		if (!known) {
			const wide = Math.max(...[..."0123456789"].map((digit) => context.measureText(digit).width));
			known = new Map([..."0123456789"].map((digit) => [digit, wide]));
			widths.set(context.font, known);
		}
		let width = known.get(character);
		if (width === void 0) known.set(character, width = context.measureText(character).width);
		return width;
	}
	function draw({ context, places, shown }) {
		context.clearRect(0, 0, context.canvas.width, context.canvas.height);
		context.textAlign = "center";
		shown.forEach(({ text, tone }, index) => {
			const place = places[index];
			if (!place) return;
			context.font = place.font;
			context.fillStyle = place.colours[tone] ?? place.colours[0] ?? "";
			const base = place.middle + context.measureText("0").actualBoundingBoxAscent / 2;
			const steps = [...text].map((character) => widthOf(context, character) + place.spacing);
			let at = place.edge;
			if (place.align === "right") at -= steps.reduce((sum, step) => sum + step, -place.spacing);
			[...text].forEach((character, turn) => {
				const step = steps[turn];
				context.fillText(character, at + (step - place.spacing) / 2, base);
				at += step;
			});
		});
	}
	addEventListener("message", ({ data }) => {
		switch (data.do) {
			case "new": {
				const context = data.canvas.getContext("2d");
				if (!context) throw new Error();
				sheets.set(data.sheet, {
					context,
					places: [],
					shown: []
				});
				return;
			}
			case "look": {
				const sheet = sheets.get(data.sheet);
				if (!sheet) return;
				[sheet.context.canvas.width, sheet.context.canvas.height] = [data.width, data.height];
				sheet.places = data.places;
				draw(sheet);
				return;
			}
			case "show":
				for (const [number, shown] of data.numbers) {
					const sheet = sheets.get(number);
					if (!sheet) continue;
					sheet.shown = shown;
					draw(sheet);
				}
				return;
			case "drop": sheets.delete(data.sheet);
		}
	});
})();
