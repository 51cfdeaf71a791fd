(function() {
	// src/lib/digits/fit.ts
	/** The share of its size at which a number of this width ends inside the sheet. */
	function shareOf(width, place) {
		return place.align === "right" && width > place.edge && place.edge > 0 ? place.edge / width : 1;
	}
	/** The font of a place at a share of its size. */
	function smaller(font, share) {
		return font.replace(/[\d.]+(?=px)/, (size) => String(Number(size) * share));
	}
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
			context.fillStyle = place.colours[tone] ?? place.colours[0] ?? "";
			const characters = [...text];
			const widthAt = (share) => {
				context.font = share === 1 ? place.font : smaller(place.font, share);
				return characters.reduce((sum, character) => sum + widthOf(context, character), (characters.length - 1) * place.spacing * share);
			};
			let width = widthAt(1);
			const share = shareOf(width, place);
			if (share < 1) width = widthAt(share);
			const spacing = place.spacing * share;
			const base = place.middle + context.measureText("0").actualBoundingBoxAscent / 2;
			let at = place.align === "right" ? place.edge - width : place.edge;
			for (const character of characters) {
				const own = widthOf(context, character);
				context.fillText(character, at + own / 2, base);
				at += own + spacing;
			}
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
