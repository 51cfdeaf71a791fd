import { http } from "../../lib/api/http.js";
import { moment, number, t } from "../../lib/i18n/index.svelte.js";
import Editor from "../../lib/editor/Editor.svelte.js";
import { bytes } from "../../lib/numbers.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import Dialog from "../../lib/parts/Dialog.svelte.js";
import Empty from "../../lib/parts/Empty.svelte.js";
import Icon from "../../lib/parts/Icon.svelte.js";
import Labelled from "../../lib/parts/Labelled.svelte.js";
import { go } from "../../lib/routing.svelte.js";
import { editing } from "../../lib/state/editing.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { notify } from "../../lib/state/notices.svelte.js";
import { begun, numbered, programName, typedName } from "../../lib/state/names.js";
import { programs } from "../../lib/state/programs.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/program/Directory.svelte
var root = $.from_html(`<input class="filter s-qvxyhd" type="search"/> <!> <!> <!> <input type="file" multiple="" hidden="" data-testid="upload"/>`, 1);
var root_1 = $.from_html(`<i class="s-qvxyhd"></i>`);
var root_2 = $.from_html(`<tr draggable="true"><td><button type="button" class="name code s-qvxyhd"> <!><!><!></button></td><td class="comment s-qvxyhd"> </td><td class="right"> </td><td class="muted"> </td></tr>`);
var root_3 = $.from_html(`<span> </span>`);
var root_4 = $.from_html(`<table class="table"><thead><tr><th> </th><th> </th><th class="right"> </th><th> </th></tr></thead><tbody></tbody></table> <p class="muted total s-qvxyhd" data-testid="capacity"> <!> <!> <!></p>`, 1);
var root_5 = $.from_html(`<div class="preview s-qvxyhd"><div class="row wrap"><strong class="code"> </strong> <span class="grow muted comment s-qvxyhd"> </span> <!> <!></div> <div class="text s-qvxyhd"><!></div> <div class="row wrap"><a class="download s-qvxyhd"><!> </a> <!> <!> <!> <span class="grow"></span> <!></div></div>`);
var root_6 = $.from_html(`<!> <!>`, 1);
var root_7 = $.from_html(`<input class="code" autocapitalize="characters" placeholder="O0001" data-testid="new-name"/>`);
var root_8 = $.from_html(`<form id="new-program"><!></form>`);
var root_9 = $.from_html(`<p> </p>`);
var root_10 = $.from_html(`<div data-testid="directory" role="region"><!> <!></div> <!> <!> <!> <!>`, 1);
function Directory($$anchor, $$props) {
	$.push($$props, true);
	/** Of a program as much is previewed. */
	const PREVIEW = 2e4;
	let wanted = $.state("");
	let filter = $.state("");
	let preview = $.state("");
	let over = $.state(false);
	let making = $.state(false);
	let fresh = $.state("");
	/** What the name is for: a program that is new, or another name or a copy of the one that is chosen. */
	let naming = $.state("new");
	const typed = $.derived(() => typedName($.get(fresh)));
	/** The name that was typed; empty where it is none. */
	const name = $.derived(() => "name" in $.get(typed) ? $.get(typed).name : "");
	const taken = $.derived(() => {
		const standing = programs.named($.get(name));
		return standing !== void 0 && !($.get(naming) === "rename" && standing === $.get(chosen) && standing.name !== $.get(name));
	});
	/** Why there can be no such program. */
	const why = $.derived(() => {
		if ($.get(taken)) return t("program.taken");
		if ("name" in $.get(typed) || $.get(fresh).trim() === "") return "";
		return t($.get(typed).wrong === "digits" ? "program.name_digits" : "program.name_signs");
	});
	/** Files whose programs are there already. */
	let doubles = $.state([]);
	let replacing = $.state(false);
	let doomed = $.state("");
	let deleting = $.state(false);
	let clearing = $.state(false);
	let picker = $.state(void 0);
	const selected = $.derived(() => machine.status?.program.selected ?? null);
	const list = $.derived(() => (programs.list ?? []).filter((one) => `${one.name} ${one.comment}`.toLowerCase().includes($.get(filter).toLowerCase())));
	const chosen = $.derived(() => $.get(list).find((one) => one.name === $.get(wanted)) ?? $.get(list).find((one) => one.name === $.get(selected)) ?? $.get(list)[0]);
	/** The program switch (GSK990MC part 2, 10.2.5); null on controls without one. */
	const open = $.derived(() => machine.status?.switches.programs ?? null);
	const total = $.derived(() => (programs.list ?? []).reduce((sum, one) => sum + one.bytes, 0));
	$.user_effect(() => {
		machine.changed("programs");
		if (machine.link === "open") programs.refresh();
	});
	$.user_effect(() => {
		const name = $.get(chosen)?.name;
		$.get(chosen)?.changed;
		$.set(preview, "");
		if (name) programs.read(name).then((text) => name === $.get(chosen)?.name ? $.set(preview, text.slice(0, PREVIEW), true) : null, () => void 0);
	});
	async function take(files) {
		await programs.refresh();
		const there = [];
		for (const file of files) {
			const name = programName(file.name, await file.slice(0, 500).text());
			const standing = programs.named(name);
			if (standing) there.push({
				name: standing.name,
				file
			});
			else await bring(name, file);
		}
		$.set(doubles, there);
		$.set(replacing, there.length > 0);
		programs.refresh();
	}
	async function bring(name, file) {
		if (!await programs.bring(name, file)) return;
		notify({
			kind: "done",
			title: t("program.stored", { program: name })
		});
		$.set(wanted, name, true);
	}
	async function replace() {
		$.set(replacing, false);
		for (const { name, file } of $.get(doubles)) await bring(name, file);
		programs.refresh();
	}
	function ask(what) {
		$.set(naming, what, true);
		$.set(fresh, what === "new" ? "" : $.get(chosen)?.name ?? "", true);
		$.set(making, true);
	}
	async function make(event) {
		event.preventDefault();
		const to = $.get(name);
		const from = $.get(chosen)?.name ?? "";
		if (!to || $.get(taken) || !await made(to, from)) return;
		$.set(making, false);
		if ($.get(naming) === "new") go("program", "edit", to);
		else {
			$.set(wanted, to, true);
			programs.refresh();
		}
	}
	async function made(name, from) {
		if ($.get(naming) === "new") return machine.tell({
			do: "store",
			program: name,
			text: begun(name)
		});
		if ($.get(naming) === "rename") {
			if (!await machine.tell({
				do: "rename",
				program: from,
				to: name
			})) return false;
			editing.moved(from, name);
			return true;
		}
		try {
			return await programs.store(name, numbered(await programs.read(from), name));
		} catch (refused) {
			machine.refused(refused);
			return false;
		}
	}
	async function remove() {
		if (await machine.tell({
			do: "delete",
			program: $.get(doomed)
		})) {
			editing.moved($.get(doomed), null);
			programs.refresh();
		}
		$.set(deleting, false);
	}
	async function removeAll() {
		const open = (programs.list ?? []).filter(({ locked }) => locked === null);
		if (await machine.tell({ do: "delete_all" })) {
			open.forEach(({ name }) => editing.moved(name, null));
			programs.refresh();
		}
		$.set(clearing, false);
	}
	var fragment = root_10();
	var div = $.first_child(fragment);
	let classes;
	var node = $.child(div);
	{
		const actions = ($$anchor) => {
			var fragment_1 = root();
			var input = $.first_child(fragment_1);
			$.remove_input_defaults(input);
			var node_1 = $.sibling(input, 2);
			var consequent = ($$anchor) => {
				{
					let $0 = $.derived(() => !$.get(open));
					let $1 = $.derived(() => machine.status?.mode !== "mdi");
					let $2 = $.derived(() => t("program.lock_all_text"));
					Button($$anchor, {
						icon: "lock",
						get pressed() {
							return $.get($0);
						},
						get disabled() {
							return $.get($1);
						},
						get title() {
							return $.get($2);
						},
						onclick: () => void machine.tell({
							do: "set_parameter",
							name: "NO54.6",
							value: $.get(open) ? 0 : 1
						}),
						"data-testid": "lock-all",
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text_1 = $.text();
							$.template_effect(($0) => $.set_text(text_1, $0), [() => $.get(open) ? t("program.lock_all") : t("program.closed")]);
							$.append($$anchor, text_1);
						},
						$$slots: { default: true }
					});
				}
			};
			$.if(node_1, ($$render) => {
				if ($.get(open) !== null) $$render(consequent);
			});
			var node_2 = $.sibling(node_1, 2);
			{
				let $0 = $.derived(() => t("program.upload"));
				let $1 = $.derived(() => t("program.upload"));
				Button(node_2, {
					icon: "upload",
					get "aria-label"() {
						return $.get($0);
					},
					get title() {
						return $.get($1);
					},
					onclick: () => $.get(picker)?.click()
				});
			}
			var node_3 = $.sibling(node_2, 2);
			Button(node_3, {
				icon: "plus",
				onclick: () => ask("new"),
				"data-testid": "new",
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_2 = $.text();
					$.template_effect(($0) => $.set_text(text_2, $0), [() => t("program.new")]);
					$.append($$anchor, text_2);
				},
				$$slots: { default: true }
			});
			var input_1 = $.sibling(node_3, 2);
			$.bind_this(input_1, ($$value) => $.set(picker, $$value), () => $.get(picker));
			$.template_effect(($0, $1) => {
				$.set_attribute(input, "placeholder", $0);
				$.set_attribute(input, "aria-label", $1);
			}, [() => t("app.search"), () => t("app.search")]);
			$.bind_value(input, () => $.get(filter), ($$value) => $.set(filter, $$value));
			$.delegated("change", input_1, (event) => {
				const files = [...event.currentTarget.files ?? []];
				event.currentTarget.value = "";
				take(files);
			});
			$.append($$anchor, fragment_1);
		};
		let $0 = $.derived(() => t("program.directory"));
		Card(node, {
			fill: true,
			flush: true,
			get title() {
				return $.get($0);
			},
			actions,
			children: ($$anchor, $$slotProps) => {
				var fragment_5 = $.comment();
				var node_4 = $.first_child(fragment_5);
				var consequent_1 = ($$anchor) => {
					{
						let $0 = $.derived(() => t("program.empty"));
						let $1 = $.derived(() => t("program.empty_text"));
						Empty($$anchor, {
							icon: "program",
							get title() {
								return $.get($0);
							},
							get text() {
								return $.get($1);
							}
						});
					}
				};
				var alternate = ($$anchor) => {
					var fragment_7 = root_4();
					var table = $.first_child(fragment_7);
					var thead = $.child(table);
					var tr = $.child(thead);
					var th = $.child(tr);
					var text_3 = $.only_child(th, true);
					var th_1 = $.sibling(th);
					var text_4 = $.only_child(th_1, true);
					var th_2 = $.sibling(th_1);
					var text_5 = $.only_child(th_2, true);
					var th_3 = $.sibling(th_2);
					var text_6 = $.only_child(th_3, true);
					$.reset(tr);
					$.reset(thead);
					var tbody = $.sibling(thead);
					$.each(tbody, 21, () => $.get(list), (one) => one.name, ($$anchor, one) => {
						var tr_1 = root_2();
						let classes_1;
						var td = $.child(tr_1);
						var button = $.child(td);
						var text_7 = $.child(button, true);
						var node_5 = $.sibling(text_7);
						var consequent_2 = ($$anchor) => {
							Icon($$anchor, {
								name: "play",
								size: "0.9rem",
								fill: true
							});
						};
						$.if(node_5, ($$render) => {
							if ($.get(one).name === $.get(selected)) $$render(consequent_2);
						});
						var node_6 = $.sibling(node_5);
						var consequent_3 = ($$anchor) => {
							Icon($$anchor, {
								name: "lock",
								size: "0.9rem"
							});
						};
						$.if(node_6, ($$render) => {
							if ($.get(one).locked !== null) $$render(consequent_3);
						});
						var node_7 = $.sibling(node_6);
						var consequent_4 = ($$anchor) => {
							var i = root_1();
							$.template_effect(($0) => $.set_attribute(i, "title", $0), [() => t("program.unsaved")]);
							$.append($$anchor, i);
						};
						var d = $.derived(() => editing.draft($.get(one).name) !== null);
						$.if(node_7, ($$render) => {
							if ($.get(d)) $$render(consequent_4);
						});
						$.reset(button);
						$.reset(td);
						var td_1 = $.sibling(td);
						var text_8 = $.only_child(td_1, true);
						var td_2 = $.sibling(td_1);
						var text_9 = $.only_child(td_2, true);
						var td_3 = $.sibling(td_2);
						var text_10 = $.only_child(td_3, true);
						$.reset(tr_1);
						$.template_effect(($0, $1) => {
							$.set_attribute(tr_1, "data-program", $.get(one).name);
							classes_1 = $.set_class(tr_1, 1, "s-qvxyhd", null, classes_1, { chosen: $.get(one).name === $.get(chosen)?.name });
							$.set_text(text_7, $.get(one).name);
							$.set_text(text_8, $.get(one).comment);
							$.set_text(text_9, $0);
							$.set_text(text_10, $1);
						}, [() => bytes($.get(one).bytes), () => moment($.get(one).changed)]);
						$.event("dragstart", tr_1, (event) => {
							const url = new URL(http.download($.get(one).name), location.href).href;
							event.dataTransfer?.setData("DownloadURL", `text/plain:${$.get(one).name}.nc:${url}`);
							event.dataTransfer?.setData("text/uri-list", url);
						});
						$.delegated("click", tr_1, () => $.set(wanted, $.get(one).name, true));
						$.delegated("dblclick", tr_1, () => go("program", "edit", $.get(one).name));
						$.delegated("click", button, () => $.set(wanted, $.get(one).name, true));
						$.append($$anchor, tr_1);
					});
					$.reset(tbody);
					$.reset(table);
					var p = $.sibling(table, 2);
					var text_11 = $.child(p);
					var node_8 = $.sibling(text_11);
					var consequent_5 = ($$anchor) => {
						var span = root_3();
						var text_12 = $.only_child(span, true);
						$.template_effect(($0) => $.set_text(text_12, $0), [() => t("program.most", { most: number(programs.most) })]);
						$.append($$anchor, span);
					};
					$.if(node_8, ($$render) => {
						if (programs.most !== null) $$render(consequent_5);
					});
					var node_9 = $.sibling(node_8, 2);
					var consequent_6 = ($$anchor) => {
						var span_1 = root_3();
						var text_13 = $.only_child(span_1, true);
						$.template_effect(($0) => $.set_text(text_13, $0), [() => t("program.room", { room: bytes(programs.room) })]);
						$.append($$anchor, span_1);
					};
					$.if(node_9, ($$render) => {
						if (programs.room !== null) $$render(consequent_6);
					});
					var node_10 = $.sibling(node_9, 2);
					Button(node_10, {
						kind: "quiet",
						icon: "trash",
						onclick: () => $.set(clearing, true),
						"data-testid": "delete-all",
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text_14 = $.text();
							$.template_effect(($0) => $.set_text(text_14, $0), [() => t("program.delete_all")]);
							$.append($$anchor, text_14);
						},
						$$slots: { default: true }
					});
					$.reset(p);
					$.template_effect(($0, $1, $2, $3, $4) => {
						$.set_text(text_3, $0);
						$.set_text(text_4, $1);
						$.set_text(text_5, $2);
						$.set_text(text_6, $3);
						$.set_text(text_11, `${$4 ?? ""} `);
					}, [
						() => t("program.name"),
						() => t("program.comment"),
						() => t("program.size"),
						() => t("program.changed"),
						() => t("program.total", {
							count: programs.list?.length ?? 0,
							n: number(programs.list?.length ?? 0),
							bytes: bytes($.get(total))
						})
					]);
					$.append($$anchor, fragment_7);
				};
				$.if(node_4, ($$render) => {
					if (programs.list && $.get(list).length === 0) $$render(consequent_1);
					else $$render(alternate, -1);
				});
				$.append($$anchor, fragment_5);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	var node_11 = $.sibling(node, 2);
	var consequent_7 = ($$anchor) => {
		var div_1 = root_5();
		var div_2 = $.child(div_1);
		var strong = $.child(div_2);
		var text_15 = $.only_child(strong, true);
		var span_2 = $.sibling(strong, 2);
		var text_16 = $.only_child(span_2, true);
		var node_12 = $.sibling(span_2, 2);
		Button(node_12, {
			kind: "primary",
			icon: "play",
			onclick: () => void machine.tell({
				do: "select",
				program: $.get(chosen).name
			}),
			"data-testid": "select",
			children: ($$anchor, $$slotProps) => {
				$.next();
				var text_17 = $.text();
				$.template_effect(($0) => $.set_text(text_17, $0), [() => t("program.select")]);
				$.append($$anchor, text_17);
			},
			$$slots: { default: true }
		});
		var node_13 = $.sibling(node_12, 2);
		Button(node_13, {
			icon: "edit",
			onclick: () => go("program", "edit", $.get(chosen).name),
			"data-testid": "edit",
			children: ($$anchor, $$slotProps) => {
				$.next();
				var text_18 = $.text();
				$.template_effect(($0) => $.set_text(text_18, $0), [() => t("program.edit")]);
				$.append($$anchor, text_18);
			},
			$$slots: { default: true }
		});
		$.reset(div_2);
		var div_3 = $.sibling(div_2, 2);
		var node_14 = $.child(div_3);
		{
			let $0 = $.derived(() => t("program.preview"));
			Editor(node_14, {
				get text() {
					return $.get(preview);
				},
				readonly: true,
				get label() {
					return $.get($0);
				}
			});
		}
		$.reset(div_3);
		var div_4 = $.sibling(div_3, 2);
		var a = $.child(div_4);
		var node_15 = $.child(a);
		Icon(node_15, { name: "download" });
		var text_19 = $.sibling(node_15, 1, true);
		$.reset(a);
		var node_16 = $.sibling(a, 2);
		{
			let $0 = $.derived(() => $.get(chosen).locked !== null);
			Button(node_16, {
				icon: "lock",
				get pressed() {
					return $.get($0);
				},
				"data-testid": "lock",
				onclick: () => void machine.tell({
					do: "lock",
					program: $.get(chosen).name,
					locked: $.get(chosen).locked === null
				}),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_20 = $.text();
					$.template_effect(($0) => $.set_text(text_20, $0), [() => $.get(chosen).locked === null ? t("program.lock") : t("program.unlock")]);
					$.append($$anchor, text_20);
				},
				$$slots: { default: true }
			});
		}
		var node_17 = $.sibling(node_16, 2);
		Button(node_17, {
			onclick: () => ask("copy"),
			"data-testid": "copy",
			children: ($$anchor, $$slotProps) => {
				$.next();
				var text_21 = $.text();
				$.template_effect(($0) => $.set_text(text_21, $0), [() => t("program.copy")]);
				$.append($$anchor, text_21);
			},
			$$slots: { default: true }
		});
		var node_18 = $.sibling(node_17, 2);
		Button(node_18, {
			onclick: () => ask("rename"),
			"data-testid": "rename",
			children: ($$anchor, $$slotProps) => {
				$.next();
				var text_22 = $.text();
				$.template_effect(($0) => $.set_text(text_22, $0), [() => t("program.rename")]);
				$.append($$anchor, text_22);
			},
			$$slots: { default: true }
		});
		var node_19 = $.sibling(node_18, 4);
		{
			let $0 = $.derived(() => t("app.delete"));
			Button(node_19, {
				kind: "danger",
				icon: "trash",
				get "aria-label"() {
					return $.get($0);
				},
				onclick: () => {
					$.set(doomed, $.get(chosen).name, true);
					$.set(deleting, true);
				},
				"data-testid": "delete"
			});
		}
		$.reset(div_4);
		$.reset(div_1);
		$.template_effect(($0, $1) => {
			$.set_text(text_15, $.get(chosen).name);
			$.set_text(text_16, $.get(chosen).comment);
			$.set_attribute(a, "href", $0);
			$.set_attribute(a, "download", `${$.get(chosen).name}.nc`);
			$.set_text(text_19, $1);
		}, [() => http.download($.get(chosen).name), () => t("program.download")]);
		$.append($$anchor, div_1);
	};
	$.if(node_11, ($$render) => {
		if ($.get(chosen)) $$render(consequent_7);
	});
	$.reset(div);
	var node_20 = $.sibling(div, 2);
	{
		const actions = ($$anchor) => {
			var fragment_16 = root_6();
			var node_21 = $.first_child(fragment_16);
			Button(node_21, {
				onclick: () => $.set(making, false),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_23 = $.text();
					$.template_effect(($0) => $.set_text(text_23, $0), [() => t("app.cancel")]);
					$.append($$anchor, text_23);
				},
				$$slots: { default: true }
			});
			var node_22 = $.sibling(node_21, 2);
			{
				let $0 = $.derived(() => !$.get(name) || $.get(taken));
				Button(node_22, {
					kind: "primary",
					type: "submit",
					form: "new-program",
					get disabled() {
						return $.get($0);
					},
					"data-testid": "name-go",
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text_24 = $.text();
						$.template_effect(($0) => $.set_text(text_24, $0), [() => t(`program.${$.get(naming)}`)]);
						$.append($$anchor, text_24);
					},
					$$slots: { default: true }
				});
			}
			$.append($$anchor, fragment_16);
		};
		let $0 = $.derived(() => $.get(naming) === "new" ? t("program.new") : `${t(`program.${$.get(naming)}`)}: ${$.get(chosen)?.name ?? ""}`);
		Dialog(node_20, {
			get title() {
				return $.get($0);
			},
			get open() {
				return $.get(making);
			},
			set open($$value) {
				$.set(making, $$value, true);
			},
			actions,
			children: ($$anchor, $$slotProps) => {
				var form = root_8();
				var node_23 = $.child(form);
				{
					let $0 = $.derived(() => t("program.name"));
					let $1 = $.derived(() => $.get(why) || t("program.name_hint"));
					Labelled(node_23, {
						get label() {
							return $.get($0);
						},
						get hint() {
							return $.get($1);
						},
						children: ($$anchor, $$slotProps) => {
							var input_2 = root_7();
							$.remove_input_defaults(input_2);
							$.bind_value(input_2, () => $.get(fresh), ($$value) => $.set(fresh, $$value));
							$.append($$anchor, input_2);
						},
						$$slots: { default: true }
					});
				}
				$.reset(form);
				$.event("submit", form, make);
				$.append($$anchor, form);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	var node_24 = $.sibling(node_20, 2);
	{
		const actions = ($$anchor) => {
			var fragment_19 = root_6();
			var node_25 = $.first_child(fragment_19);
			Button(node_25, {
				onclick: () => $.set(replacing, false),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_25 = $.text();
					$.template_effect(($0) => $.set_text(text_25, $0), [() => t("app.cancel")]);
					$.append($$anchor, text_25);
				},
				$$slots: { default: true }
			});
			var node_26 = $.sibling(node_25, 2);
			Button(node_26, {
				kind: "danger",
				onclick: () => void replace(),
				"data-testid": "replace",
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_26 = $.text();
					$.template_effect(($0) => $.set_text(text_26, $0), [() => t("program.replace")]);
					$.append($$anchor, text_26);
				},
				$$slots: { default: true }
			});
			$.append($$anchor, fragment_19);
		};
		let $0 = $.derived(() => t("program.replace_ask"));
		Dialog(node_24, {
			get title() {
				return $.get($0);
			},
			get open() {
				return $.get(replacing);
			},
			set open($$value) {
				$.set(replacing, $$value, true);
			},
			actions,
			children: ($$anchor, $$slotProps) => {
				var p_1 = root_9();
				var text_27 = $.only_child(p_1, true);
				$.template_effect(($0) => $.set_text(text_27, $0), [() => t("program.replace_text", { programs: $.get(doubles).map(({ name }) => name).join(", ") })]);
				$.append($$anchor, p_1);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	var node_27 = $.sibling(node_24, 2);
	{
		const actions = ($$anchor) => {
			var fragment_22 = root_6();
			var node_28 = $.first_child(fragment_22);
			Button(node_28, {
				onclick: () => $.set(clearing, false),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_28 = $.text();
					$.template_effect(($0) => $.set_text(text_28, $0), [() => t("app.cancel")]);
					$.append($$anchor, text_28);
				},
				$$slots: { default: true }
			});
			var node_29 = $.sibling(node_28, 2);
			Button(node_29, {
				kind: "danger",
				icon: "trash",
				onclick: () => void removeAll(),
				"data-testid": "delete-all-go",
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_29 = $.text();
					$.template_effect(($0) => $.set_text(text_29, $0), [() => t("program.delete_all")]);
					$.append($$anchor, text_29);
				},
				$$slots: { default: true }
			});
			$.append($$anchor, fragment_22);
		};
		let $0 = $.derived(() => t("program.delete_all_ask"));
		Dialog(node_27, {
			get title() {
				return $.get($0);
			},
			get open() {
				return $.get(clearing);
			},
			set open($$value) {
				$.set(clearing, $$value, true);
			},
			actions,
			children: ($$anchor, $$slotProps) => {
				var p_2 = root_9();
				var text_30 = $.only_child(p_2, true);
				$.template_effect(($0) => $.set_text(text_30, $0), [() => t("program.delete_all_text")]);
				$.append($$anchor, p_2);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	var node_30 = $.sibling(node_27, 2);
	{
		const actions = ($$anchor) => {
			var fragment_25 = root_6();
			var node_31 = $.first_child(fragment_25);
			Button(node_31, {
				onclick: () => $.set(deleting, false),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_31 = $.text();
					$.template_effect(($0) => $.set_text(text_31, $0), [() => t("app.cancel")]);
					$.append($$anchor, text_31);
				},
				$$slots: { default: true }
			});
			var node_32 = $.sibling(node_31, 2);
			Button(node_32, {
				kind: "danger",
				icon: "trash",
				onclick: () => void remove(),
				"data-testid": "delete-go",
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_32 = $.text();
					$.template_effect(($0) => $.set_text(text_32, $0), [() => t("app.delete")]);
					$.append($$anchor, text_32);
				},
				$$slots: { default: true }
			});
			$.append($$anchor, fragment_25);
		};
		let $0 = $.derived(() => t("program.delete", { program: $.get(doomed) }));
		Dialog(node_30, {
			get title() {
				return $.get($0);
			},
			get open() {
				return $.get(deleting);
			},
			set open($$value) {
				$.set(deleting, $$value, true);
			},
			actions,
			children: ($$anchor, $$slotProps) => {
				var p_3 = root_9();
				var text_33 = $.only_child(p_3, true);
				$.template_effect(($0) => $.set_text(text_33, $0), [() => t("program.delete_text")]);
				$.append($$anchor, p_3);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	$.template_effect(($0) => {
		classes = $.set_class(div, 1, "directory s-qvxyhd", null, classes, { over: $.get(over) });
		$.set_attribute(div, "data-loaded", programs.list !== null);
		$.set_attribute(div, "aria-label", $0);
	}, [() => t("program.directory")]);
	$.event("dragover", div, (event) => {
		event.preventDefault();
		$.set(over, true);
	});
	$.event("dragleave", div, () => $.set(over, false));
	$.event("drop", div, (event) => {
		event.preventDefault();
		$.set(over, false);
		take([...event.dataTransfer?.files ?? []]);
	});
	$.append($$anchor, fragment);
	$.pop();
}
$.delegate([
	"change",
	"click",
	"dblclick"
]);
export { Directory as default };
