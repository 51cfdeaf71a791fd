import { calculate } from "./calculate.js";
import { notHere, operations } from "./operations.js";
// src/pages/help/local.ts
var bare = /^[-+−]?[\d.,\s]*$/;
/** What is found, in the language in which `t` gives texts. */
function findLocal(sought, t) {
	const words = sought.toLowerCase().split(/\s+/).filter(Boolean);
	if (words.length === 0) return [];
	const has = (...texts) => words.every((word) => texts.join(" ").toLowerCase().includes(word));
	const found = [
		...operations.map(([id, page]) => ({
			kind: "operation",
			id,
			title: t(`operations.${id}`),
			text: t(`operations.${id}_how`),
			page: page.split("/")
		})),
		...notHere.map(([id]) => ({
			kind: "not_here",
			id,
			title: t(`operations.not_${id}`),
			text: t(`operations.not_${id}_why`),
			page: ["help", "operations"]
		})),
		{
			kind: "calculator",
			id: "calculator",
			title: t("help.calculator"),
			text: "",
			page: ["help", "calculator"]
		}
	].filter(({ title, text }) => has(title, text)).map((one) => ({
		...one,
		isNear: has(one.title)
	}));
	const sum = sought.trim();
	const value = bare.test(sum) ? null : calculate(sum);
	if (value !== null) {
		const title = `${sum} = ${Number(value.toPrecision(12))}`;
		found.unshift({
			kind: "calculator",
			id: "sum",
			title,
			text: "",
			page: [
				"help",
				"calculator",
				sum
			],
			isNear: true
		});
	}
	return found;
}
export { findLocal };
