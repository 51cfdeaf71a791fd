import { number, t } from "../../lib/i18n/index.svelte.js";
import Editor from "../../lib/editor/Editor.svelte.js";
import Findings from "../../lib/editor/Findings.svelte.js";
import KeypadSwitch from "../../lib/editor/KeypadSwitch.svelte.js";
import { cycleAt } from "../../lib/cycles/read.js";
import { renumber } from "../../lib/editor/renumber.js";
import Button from "../../lib/parts/Button.svelte.js";
import Dialog from "../../lib/parts/Dialog.svelte.js";
import Empty from "../../lib/parts/Empty.svelte.js";
import Icon from "../../lib/parts/Icon.svelte.js";
import Labelled from "../../lib/parts/Labelled.svelte.js";
import NumberField from "../../lib/parts/NumberField.svelte.js";
import { go, route } from "../../lib/routing.svelte.js";
import { codesLost, editing, lineFor, placeOf } from "../../lib/state/editing.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { notify } from "../../lib/state/notices.svelte.js";
import { programs } from "../../lib/state/programs.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/program/Edit.svelte
var root = $.from_html(`<i class="s-n0epk1"></i>`);
var root_1 = $.from_html(`<span class="background s-n0epk1"> </span>`);
var root_2 = $.from_html(`<span class="muted" data-testid="checked-on-save" role="status"> </span>`);
var root_3 = $.from_html(`<span class="background s-n0epk1" data-testid="closed"> </span>`);
var root_4 = $.from_html(`<div class="newer row wrap s-n0epk1" role="alert" data-testid="newer"><!><span class="grow"> </span> <!></div>`);
var root_5 = $.from_html(`<div class="newer row s-n0epk1" role="alert" data-testid="codes-lost"><!><span class="grow"> </span> <!></div>`);
var root_6 = $.from_html(`<p class="muted"> </p>`);
var root_7 = $.from_html(`<div class="edit s-n0epk1" data-testid="editor"><div class="row wrap"><strong class="code name s-n0epk1"> <!></strong> <!> <!> <!> <!> <span class="grow"></span> <!> <!> <!> <!> <!> <!> <!> <!> <!></div> <!> <!> <div class="text s-n0epk1"><!></div> <!></div>`);
var root_8 = $.from_html(`<!> <!>`, 1);
var root_9 = $.from_html(`<div class="row"><!> <!></div>`);
var root_10 = $.from_html(`<p> </p>`);
var root_11 = $.from_html(`<!> <!> <!>`, 1);
function Edit($$anchor, $$props) {
	$.push($$props, true);
	const name = $.derived(() => route.item || machine.status?.program.selected || "");
	const running = $.derived(() => machine.status?.program.running ?? null);
	let editor = $.state(void 0);
	let text = $.state("");
	let shown = $.state("");
	let changed = $.state(false);
	let findings = $.state([]);
	let numbering = $.state(false);
	let first = $.state(10);
	let step = $.state(10);
	let opening = $.state(false);
	let checking = $.state(false);
	/** Too long to be checked as it is typed. */
	let isLong = $.state(false);
	$.user_effect(() => {
		$.get(shown);
		$.set(isLong, $.get(editor)?.isLong() ?? false, true);
	});
	/** What the memory had when it was read or stored last, and when that was changed. */
	let base = "";
	let stamp = null;
	/** Whether the memory has what was not seen here, while something is changed here. */
	let isNewer = $.state(false);
	let replaces = $.state(false);
	/** What reads and what stores goes one after the other, so that what is stored here is not taken for somebody else's. */
	let last = Promise.resolve();
	function queue(work) {
		const done = last.then(work, work);
		last = done.catch(() => void 0);
		return done;
	}
	$.user_effect(() => {
		const wanted = $.get(name);
		if (!wanted || wanted === $.get(shown) || machine.link !== "open") return;
		$.set(opening, true);
		open(wanted).catch((refused) => {
			if (wanted !== $.get(name)) return;
			$.set(opening, false);
			machine.refused(refused);
			go("program", "directory");
		});
	});
	async function open(wanted) {
		const at = await programs.changedAt(wanted);
		const now = await programs.read(wanted);
		if (wanted !== $.get(name)) return;
		$.get(editor)?.leave();
		const draft = editing.draft(wanted);
		$.set(text, draft?.text ?? now, true);
		$.set(shown, wanted, true);
		$.set(changed, draft !== null && draft.text !== now, true);
		$.set(isNewer, $.get(changed) && draft?.base !== now, true);
		[base, stamp] = [$.get(isNewer) ? draft?.base ?? now : now, at];
		$.set(findings, []);
		$.set(opening, false);
	}
	$.user_effect(() => {
		machine.changed("programs");
		if ($.get(shown) && machine.link === "open") queue(follow);
	});
	async function follow() {
		const program = $.get(shown);
		const at = await programs.changedAt(program);
		if (at === null ? programs.list?.every((one) => one.name !== program) : at === stamp) return;
		const now = await programs.read(program).catch(() => null);
		if (now === null || program !== $.get(shown)) return;
		stamp = at;
		if (now === base) $.set(isNewer, false);
		else if ($.get(changed) && now !== $.get(editor)?.value()) $.set(isNewer, true);
		else take(now);
	}
	/** Shows what the memory has now. */
	function take(now) {
		$.get(editor)?.reopen(now);
		$.set(text, now, true);
		base = now;
		$.set(changed, false);
		$.set(isNewer, false);
		$.set(isLong, $.get(editor)?.isLong() ?? false, true);
	}
	function takeNewer() {
		const program = $.get(shown);
		queue(() => programs.read(program)).then((now) => program === $.get(shown) && take(now), machine.refused);
	}
	let increment = $.state(0);
	const isClosed = $.derived(() => machine.status?.switches.programs === false);
	const hasSettings = $.derived(() => typeof machine.status?.switches.programs === "boolean");
	$.user_effect(() => {
		machine.changed("parameters");
		if (!$.get(hasSettings) || machine.link !== "open") return;
		machine.fetch("parameters", {
			do: "parameters",
			names: ["NO0.5", "P210"]
		}).then((reply) => {
			if (reply) $.set(increment, reply.parameters["NO0.5"] ? reply.parameters.P210 ?? 0 : 0, true);
		});
	});
	/** What is not in force any more behind the text that was put in last. */
	let lost = $.state({
		program: "",
		codes: []
	});
	$.user_effect(() => {
		const name = $.get(shown);
		if (!$.get(editor) || !name || !editing.waits(name)) return;
		const at = editing.program === name ? editing.line : 0;
		const into = $.get(editor);
		queueMicrotask(() => {
			const { instead, opened } = editing;
			const [now, piece] = [into.value(), editing.take()];
			const stands = placeOf(into.all(), instead, opened?.from ?? 0);
			if (instead.length) editing.open(null);
			if (stands > 0) {
				const above = into.all().slice(0, stands - 1).join("\n");
				const before = codesLost(above, instead.join("\n"));
				$.set(lost, {
					program: name,
					codes: codesLost(above, piece).filter((code) => !before.includes(code))
				});
				return into.replaceLines(stands, instead.length, piece);
			}
			if (instead.length) notify({
				kind: "warning",
				title: t("program.no_cycle_now")
			});
			const line = lineFor(now, at);
			$.set(lost, {
				program: name,
				codes: codesLost(now.split(/\r?\n/).slice(0, line).join("\n"), piece)
			});
			into.insertBehind(line, piece);
		});
	});
	$.user_effect(() => {
		if (!$.get(editor) || !$.get(shown) || $.get(shown) !== $.get(name)) return;
		const [into, line] = [$.get(editor), editing.takeLine($.get(shown))];
		if (line > 0) queueMicrotask(() => into.show(line));
	});
	$.user_effect(() => {
		const ask = (event) => {
			if ($.get(changed)) event.preventDefault();
		};
		addEventListener("beforeunload", ask);
		return () => removeEventListener("beforeunload", ask);
	});
	/** The cycle at the cursor is filled in anew; where there is none, a new one goes there. */
	function cycle() {
		if (!$.get(editor)) return;
		const lines = $.get(editor).all();
		const found = cycleAt(lines, $.get(editor).at());
		editing.open(found && {
			program: $.get(shown),
			from: found.from,
			lines: lines.slice(found.from - 1, found.to)
		});
		if (found) go("cycles", found.request.cycle);
		else go("cycles");
	}
	async function save() {
		if (!$.get(editor)) return;
		const before = $.get(shown);
		await queue(follow);
		if (before !== $.get(shown)) return;
		if ($.get(isNewer)) $.set(replaces, true);
		else await store();
	}
	async function store() {
		$.set(replaces, false);
		if (!$.get(editor) || !await queue(put)) return;
		notify({
			kind: "done",
			title: t("program.saved", { program: $.get(shown) })
		});
		if (!$.get(editor).isLong()) return;
		$.set(checking, true);
		const program = $.get(shown);
		try {
			const now = await $.get(editor).check();
			if (program === $.get(shown)) $.set(findings, now);
		} catch (refused) {
			machine.refused(refused);
		}
		$.set(checking, false);
	}
	/** Stores what stands here; whether it was. */
	async function put() {
		const [program, now] = [$.get(shown), $.get(editor)?.value() ?? ""];
		if (!await programs.store(program, now) || program !== $.get(shown)) return false;
		base = now;
		$.set(changed, $.get(editor)?.value() !== now);
		$.set(isNewer, false);
		return true;
	}
	async function select() {
		if ($.get(changed)) await save();
		if (!$.get(changed) && await machine.tell({
			do: "select",
			program: $.get(shown)
		})) go("program", "run");
	}
	function numberAnew() {
		let count = 0;
		$.get(editor)?.rewrite((before) => {
			const { lines, computed } = renumber(before, $.get(first), $.get(step));
			count = computed;
			return lines;
		});
		$.set(numbering, false);
		if (count > 0) notify({
			kind: "warning",
			title: t("program.jumps_computed", {
				count,
				n: number(count)
			})
		});
	}
	var fragment = root_11();
	var node = $.first_child(fragment);
	var consequent = ($$anchor) => {
		{
			let $0 = $.derived(() => t("program.none"));
			let $1 = $.derived(() => t("program.edit_none"));
			Empty($$anchor, {
				icon: "edit",
				get title() {
					return $.get($0);
				},
				get text() {
					return $.get($1);
				},
				children: ($$anchor, $$slotProps) => {
					Button($$anchor, {
						kind: "primary",
						icon: "list",
						onclick: () => go("program", "directory"),
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text_1 = $.text();
							$.template_effect(($0) => $.set_text(text_1, $0), [() => t("program.directory")]);
							$.append($$anchor, text_1);
						},
						$$slots: { default: true }
					});
				},
				$$slots: { default: true }
			});
		}
	};
	var alternate = ($$anchor) => {
		var div = root_7();
		var div_1 = $.child(div);
		var strong = $.child(div_1);
		var text_2 = $.child(strong, true);
		var node_1 = $.sibling(text_2);
		var consequent_1 = ($$anchor) => {
			var i = root();
			$.template_effect(($0) => $.set_attribute(i, "title", $0), [() => t("program.unsaved")]);
			$.append($$anchor, i);
		};
		$.if(node_1, ($$render) => {
			if ($.get(changed)) $$render(consequent_1);
		});
		$.reset(strong);
		var node_2 = $.sibling(strong, 2);
		var consequent_2 = ($$anchor) => {
			var span = root_1();
			var text_3 = $.only_child(span, true);
			$.template_effect(($0) => $.set_text(text_3, $0), [() => t("program.background")]);
			$.append($$anchor, span);
		};
		$.if(node_2, ($$render) => {
			if ($.get(running) && $.get(running) !== $.get(shown)) $$render(consequent_2);
		});
		var node_3 = $.sibling(node_2, 2);
		var consequent_3 = ($$anchor) => {
			var span_1 = root_1();
			var text_4 = $.only_child(span_1, true);
			$.template_effect(($0) => $.set_text(text_4, $0), [() => t("program.under_way")]);
			$.append($$anchor, span_1);
		};
		$.if(node_3, ($$render) => {
			if ($.get(running) === $.get(shown) && $.get(shown)) $$render(consequent_3);
		});
		var node_4 = $.sibling(node_3, 2);
		var consequent_4 = ($$anchor) => {
			var span_2 = root_2();
			var text_5 = $.only_child(span_2, true);
			$.template_effect(($0) => $.set_text(text_5, $0), [() => $.get(checking) ? t("program.checking") : t("program.checked_on_save")]);
			$.append($$anchor, span_2);
		};
		$.if(node_4, ($$render) => {
			if ($.get(isLong)) $$render(consequent_4);
		});
		var node_5 = $.sibling(node_4, 2);
		var consequent_5 = ($$anchor) => {
			var span_3 = root_3();
			var text_6 = $.only_child(span_3, true);
			$.template_effect(($0) => $.set_text(text_6, $0), [() => t("program.closed")]);
			$.append($$anchor, span_3);
		};
		$.if(node_5, ($$render) => {
			if ($.get(isClosed)) $$render(consequent_5);
		});
		var node_6 = $.sibling(node_5, 4);
		{
			let $0 = $.derived(() => t("program.undo"));
			let $1 = $.derived(() => t("program.undo"));
			Button(node_6, {
				icon: "undo",
				get "aria-label"() {
					return $.get($0);
				},
				get title() {
					return $.get($1);
				},
				onclick: () => $.get(editor)?.back()
			});
		}
		var node_7 = $.sibling(node_6, 2);
		{
			let $0 = $.derived(() => t("program.redo"));
			let $1 = $.derived(() => t("program.redo"));
			Button(node_7, {
				icon: "cw",
				get "aria-label"() {
					return $.get($0);
				},
				get title() {
					return $.get($1);
				},
				onclick: () => $.get(editor)?.again()
			});
		}
		var node_8 = $.sibling(node_7, 2);
		KeypadSwitch(node_8, {});
		var node_9 = $.sibling(node_8, 2);
		{
			let $0 = $.derived(() => t("program.find"));
			let $1 = $.derived(() => t("program.find"));
			Button(node_9, {
				icon: "search",
				get "aria-label"() {
					return $.get($0);
				},
				get title() {
					return $.get($1);
				},
				onclick: () => $.get(editor)?.find(),
				"data-testid": "find"
			});
		}
		var node_10 = $.sibling(node_9, 2);
		{
			let $0 = $.derived(() => t("editor.line"));
			let $1 = $.derived(() => t("editor.line"));
			Button(node_10, {
				icon: "target",
				get "aria-label"() {
					return $.get($0);
				},
				get title() {
					return $.get($1);
				},
				onclick: () => $.get(editor)?.toLine(),
				"data-testid": "to-line"
			});
		}
		var node_11 = $.sibling(node_10, 2);
		{
			let $0 = $.derived(() => t("program.cycle"));
			let $1 = $.derived(() => t("program.cycle"));
			let $2 = $.derived(() => !$.get(shown));
			Button(node_11, {
				icon: "cycles",
				get "aria-label"() {
					return $.get($0);
				},
				get title() {
					return $.get($1);
				},
				get disabled() {
					return $.get($2);
				},
				onclick: cycle,
				"data-testid": "to-cycle"
			});
		}
		var node_12 = $.sibling(node_11, 2);
		Button(node_12, {
			icon: "list",
			onclick: () => $.set(numbering, true),
			"data-testid": "renumber",
			children: ($$anchor, $$slotProps) => {
				$.next();
				var text_7 = $.text();
				$.template_effect(($0) => $.set_text(text_7, $0), [() => t("program.renumber")]);
				$.append($$anchor, text_7);
			},
			$$slots: { default: true }
		});
		var node_13 = $.sibling(node_12, 2);
		Button(node_13, {
			icon: "play",
			onclick: () => void select(),
			children: ($$anchor, $$slotProps) => {
				$.next();
				var text_8 = $.text();
				$.template_effect(($0) => $.set_text(text_8, $0), [() => t("program.select")]);
				$.append($$anchor, text_8);
			},
			$$slots: { default: true }
		});
		var node_14 = $.sibling(node_13, 2);
		{
			let $0 = $.derived(() => !$.get(changed) || $.get(isClosed));
			Button(node_14, {
				kind: "primary",
				icon: "save",
				get disabled() {
					return $.get($0);
				},
				onclick: () => void save(),
				"data-testid": "save",
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_9 = $.text();
					$.template_effect(($0) => $.set_text(text_9, $0), [() => t("app.save")]);
					$.append($$anchor, text_9);
				},
				$$slots: { default: true }
			});
		}
		$.reset(div_1);
		var node_15 = $.sibling(div_1, 2);
		var consequent_6 = ($$anchor) => {
			var div_2 = root_4();
			var node_16 = $.child(div_2);
			Icon(node_16, { name: "alarms" });
			var span_4 = $.sibling(node_16);
			var text_10 = $.only_child(span_4, true);
			var node_17 = $.sibling(span_4, 2);
			Button(node_17, {
				onclick: takeNewer,
				"data-testid": "take-newer",
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_11 = $.text();
					$.template_effect(($0) => $.set_text(text_11, $0), [() => t("program.take_newer")]);
					$.append($$anchor, text_11);
				},
				$$slots: { default: true }
			});
			$.reset(div_2);
			$.template_effect(($0) => $.set_text(text_10, $0), [() => t("program.newer")]);
			$.append($$anchor, div_2);
		};
		$.if(node_15, ($$render) => {
			if ($.get(isNewer)) $$render(consequent_6);
		});
		var node_18 = $.sibling(node_15, 2);
		var consequent_7 = ($$anchor) => {
			var div_3 = root_5();
			var node_19 = $.child(div_3);
			Icon(node_19, { name: "alarms" });
			var span_5 = $.sibling(node_19);
			var text_12 = $.only_child(span_5, true);
			var node_20 = $.sibling(span_5, 2);
			{
				let $0 = $.derived(() => t("app.close"));
				Button(node_20, {
					kind: "quiet",
					icon: "close",
					get "aria-label"() {
						return $.get($0);
					},
					onclick: () => $.set(lost, {
						program: "",
						codes: []
					})
				});
			}
			$.reset(div_3);
			$.template_effect(($0) => $.set_text(text_12, $0), [() => t("program.codes_lost", { codes: $.get(lost).codes.join(" ") })]);
			$.append($$anchor, div_3);
		};
		$.if(node_18, ($$render) => {
			if ($.get(lost).program === $.get(shown) && $.get(lost).codes.length) $$render(consequent_7);
		});
		var div_4 = $.sibling(node_18, 2);
		var node_21 = $.child(div_4);
		var consequent_8 = ($$anchor) => {
			var fragment_8 = $.comment();
			var node_22 = $.first_child(fragment_8);
			$.key(node_22, () => $.get(shown), ($$anchor) => {
				{
					let $0 = $.derived(() => t("program.edit"));
					$.bind_this(Editor($$anchor, {
						get text() {
							return $.get(text);
						},
						get step() {
							return $.get(increment);
						},
						get label() {
							return $.get($0);
						},
						onchange: () => {
							$.set(changed, true);
							$.set(isLong, $.get(editor)?.isLong() ?? false, true);
						},
						onsave: () => void save(),
						onfindings: (now) => $.set(findings, now),
						onleave: (now, line) => editing.leave($.get(shown), line, $.get(changed) ? {
							text: now(),
							base
						} : null)
					}), ($$value) => $.set(editor, $$value, true), () => $.get(editor));
				}
			});
			$.append($$anchor, fragment_8);
		};
		var consequent_9 = ($$anchor) => {
			var p = root_6();
			var text_13 = $.only_child(p, true);
			$.template_effect(($0) => $.set_text(text_13, $0), [() => t("app.loading")]);
			$.append($$anchor, p);
		};
		$.if(node_21, ($$render) => {
			if ($.get(shown)) $$render(consequent_8);
			else if ($.get(opening)) $$render(consequent_9, 1);
		});
		$.reset(div_4);
		var node_23 = $.sibling(div_4, 2);
		Findings(node_23, {
			get findings() {
				return $.get(findings);
			},
			onshow: (line) => $.get(editor)?.show(line)
		});
		$.reset(div);
		$.template_effect(() => $.set_text(text_2, $.get(shown) || $.get(name)));
		$.append($$anchor, div);
	};
	$.if(node, ($$render) => {
		if (!$.get(name)) $$render(consequent);
		else $$render(alternate, -1);
	});
	var node_24 = $.sibling(node, 2);
	{
		const actions = ($$anchor) => {
			var fragment_10 = root_8();
			var node_25 = $.first_child(fragment_10);
			Button(node_25, {
				onclick: () => $.set(numbering, false),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_14 = $.text();
					$.template_effect(($0) => $.set_text(text_14, $0), [() => t("app.cancel")]);
					$.append($$anchor, text_14);
				},
				$$slots: { default: true }
			});
			var node_26 = $.sibling(node_25, 2);
			Button(node_26, {
				kind: "primary",
				onclick: numberAnew,
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_15 = $.text();
					$.template_effect(($0) => $.set_text(text_15, $0), [() => t("program.renumber")]);
					$.append($$anchor, text_15);
				},
				$$slots: { default: true }
			});
			$.append($$anchor, fragment_10);
		};
		let $0 = $.derived(() => t("program.renumber"));
		Dialog(node_24, {
			get title() {
				return $.get($0);
			},
			get open() {
				return $.get(numbering);
			},
			set open($$value) {
				$.set(numbering, $$value, true);
			},
			actions,
			children: ($$anchor, $$slotProps) => {
				var div_5 = root_9();
				var node_27 = $.child(div_5);
				{
					let $0 = $.derived(() => t("program.first"));
					Labelled(node_27, {
						get label() {
							return $.get($0);
						},
						children: ($$anchor, $$slotProps) => {
							{
								let $0 = $.derived(() => t("program.first"));
								NumberField($$anchor, {
									get value() {
										return $.get(first);
									},
									whole: true,
									minimum: 0,
									maximum: 99999,
									get label() {
										return $.get($0);
									},
									onvalue: (value) => $.set(first, value ?? 10, true)
								});
							}
						},
						$$slots: { default: true }
					});
				}
				var node_28 = $.sibling(node_27, 2);
				{
					let $0 = $.derived(() => t("program.step"));
					Labelled(node_28, {
						get label() {
							return $.get($0);
						},
						children: ($$anchor, $$slotProps) => {
							{
								let $0 = $.derived(() => t("program.step"));
								NumberField($$anchor, {
									get value() {
										return $.get(step);
									},
									whole: true,
									minimum: 1,
									maximum: 1e3,
									get label() {
										return $.get($0);
									},
									onvalue: (value) => $.set(step, value ?? 10, true)
								});
							}
						},
						$$slots: { default: true }
					});
				}
				$.reset(div_5);
				$.append($$anchor, div_5);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	var node_29 = $.sibling(node_24, 2);
	{
		const actions = ($$anchor) => {
			var fragment_15 = root_8();
			var node_30 = $.first_child(fragment_15);
			Button(node_30, {
				onclick: () => $.set(replaces, false),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_16 = $.text();
					$.template_effect(($0) => $.set_text(text_16, $0), [() => t("app.cancel")]);
					$.append($$anchor, text_16);
				},
				$$slots: { default: true }
			});
			var node_31 = $.sibling(node_30, 2);
			Button(node_31, {
				kind: "danger",
				onclick: () => void store(),
				"data-testid": "replace-newer",
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_17 = $.text();
					$.template_effect(($0) => $.set_text(text_17, $0), [() => t("program.replace")]);
					$.append($$anchor, text_17);
				},
				$$slots: { default: true }
			});
			$.append($$anchor, fragment_15);
		};
		let $0 = $.derived(() => t("program.replace_newer"));
		Dialog(node_29, {
			get title() {
				return $.get($0);
			},
			get open() {
				return $.get(replaces);
			},
			set open($$value) {
				$.set(replaces, $$value, true);
			},
			actions,
			children: ($$anchor, $$slotProps) => {
				var p_1 = root_10();
				var text_18 = $.only_child(p_1, true);
				$.template_effect(($0) => $.set_text(text_18, $0), [() => t("program.replace_newer_text")]);
				$.append($$anchor, p_1);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	$.append($$anchor, fragment);
	$.pop();
}
export { Edit as default };
