import { t } from "../../lib/i18n/index.svelte.js";
import Editor from "../../lib/editor/Editor.svelte.js";
import { leadsAway, nextBlock } from "../../lib/editor/next.js";
import { fixed } from "../../lib/numbers.js";
import Button from "../../lib/parts/Button.svelte.js";
import Empty from "../../lib/parts/Empty.svelte.js";
import NumberField from "../../lib/parts/NumberField.svelte.js";
import { go } from "../../lib/routing.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { programs } from "../../lib/state/programs.svelte.js";
import { restart } from "../../lib/state/restart.svelte.js";
import Restart from "./Restart.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/program/RunView.svelte
var root = $.from_html(`<span class="behind s-1fv2bn7" data-testid="behind">→ <small class="s-1fv2bn7"> </small> </span>`);
var root_1 = $.from_html(`<span class="blocks grow code s-1fv2bn7"><span class="block s-1fv2bn7" data-testid="block"> </span> <span class="next s-1fv2bn7" data-testid="next"><small class="s-1fv2bn7"> </small> <!></span></span>`);
var root_2 = $.from_html(`<span><small class="s-1fv2bn7"> </small> </span>`);
var root_3 = $.from_html(`<span class="number go s-1fv2bn7"></span>`);
var root_4 = $.from_html(`<div class="head row wrap s-1fv2bn7"><strong class="code s-1fv2bn7"> </strong> <!> <!></div>`);
var root_5 = $.from_html(`<div class="interrupted row wrap s-1fv2bn7" data-testid="interrupted"><span class="grow"> </span> <!></div>`);
var root_6 = $.from_html(`<p class="retraced s-1fv2bn7" role="status" data-testid="retraced"> </p>`);
var root_7 = $.from_html(`<div class="row wrap"><!> <!> <!> <span class="stop s-1fv2bn7"><!></span> <span class="muted"> </span> <span class="grow"></span> <!> <!></div>`);
var root_8 = $.from_html(`<div data-testid="run-view"><!> <!> <!> <div class="text s-1fv2bn7"><!></div> <!></div>`);
function RunView($$anchor, $$props) {
	$.push($$props, true);
	let compact = $.prop($$props, "compact", 3, false);
	const program = $.derived(() => machine.status?.program);
	const name = $.derived(() => $.get(program)?.running ?? $.get(program)?.selected ?? null);
	const changed = $.derived(() => machine.changed("programs"));
	let text = $.state("");
	let shown = $.state(null);
	let chosen = $.state(0);
	const stopAt = $.derived(() => $.get(program)?.stop_at?.sequence ?? null);
	$.user_effect(() => {
		const wanted = $.get(name);
		$.get(changed);
		if (!wanted) {
			$.set(shown, null);
			return;
		}
		programs.read(wanted).then((now) => {
			if (wanted !== $.get(name)) return;
			$.set(text, now, true);
			$.set(shown, wanted, true);
		}, () => {
			if (wanted === $.get(name)) (($$value) => {
				var $$array = $.to_array($$value, 2);
				$.set(text, $$array[0], true);
				$.set(shown, $$array[1], true);
			})(["", null]);
		});
	});
	const active = $.derived(() => $.get(shown) === $.get(program)?.running ? $.get(program)?.line ?? 0 : 0);
	let editor = $.state(void 0);
	let next = $.state(null);
	$.user_effect(() => {
		const [from, at] = [$.get(editor), $.get(active)];
		$.get(text);
		$.set(next, from ? nextBlock((line) => from.line(line), at) : null, true);
	});
	/** Where the program leads behind a jump, a call or an end of a program: the control has read it already. */
	const behind = $.derived(() => {
		const ahead = $.get(program)?.next;
		if (!ahead || !$.get(active)) return null;
		const leads = $.get(next) === null || leadsAway($.get(next));
		const isNext = ahead.file === $.get(program)?.running && $.get(next) !== null && ahead.text.trim() === $.get(next);
		return leads && !isNext ? ahead : null;
	});
	var fragment = $.comment();
	var node = $.first_child(fragment);
	var consequent = ($$anchor) => {
		{
			let $0 = $.derived(() => t("program.none"));
			let $1 = $.derived(() => t("program.none_text"));
			Empty($$anchor, {
				icon: "program",
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
	var alternate_1 = ($$anchor) => {
		var div = root_8();
		let classes;
		{
			const blocks = ($$anchor) => {
				var span = root_1();
				var span_1 = $.child(span);
				var text_2 = $.only_child(span_1, true);
				var span_2 = $.sibling(span_1, 2);
				var small = $.child(span_2);
				var text_3 = $.only_child(small, true);
				var text_4 = $.sibling(small, 1, true);
				var node_1 = $.sibling(text_4);
				var consequent_1 = ($$anchor) => {
					var span_3 = root();
					var small_1 = $.sibling($.child(span_3));
					var text_5 = $.only_child(small_1);
					var text_6 = $.sibling(small_1, 1, true);
					$.reset(span_3);
					$.template_effect(($0) => {
						$.set_text(text_5, `${$.get(behind).file ?? ""}:${$.get(behind).line ?? ""}`);
						$.set_text(text_6, $0);
					}, [() => $.get(behind).text.trim()]);
					$.append($$anchor, span_3);
				};
				$.if(node_1, ($$render) => {
					if ($.get(behind)) $$render(consequent_1);
				});
				$.reset(span_2);
				$.reset(span);
				$.template_effect(($0) => {
					$.set_text(text_2, $.get(program)?.block);
					$.set_text(text_3, $0);
					$.set_text(text_4, $.get(next));
				}, [() => t("program.next")]);
				$.append($$anchor, span);
			};
			var node_2 = $.child(div);
			var consequent_2 = ($$anchor) => {
				blocks($$anchor);
			};
			var alternate = ($$anchor) => {
				var div_1 = root_4();
				var strong = $.child(div_1);
				var text_7 = $.only_child(strong, true);
				var node_3 = $.sibling(strong, 2);
				blocks(node_3);
				var node_4 = $.sibling(node_3, 2);
				var consequent_3 = ($$anchor) => {
					var span_4 = root_3();
					$.each(span_4, 20, () => machine.axes, (axis) => axis, ($$anchor, axis) => {
						var span_5 = root_2();
						var small_2 = $.child(span_5);
						var text_8 = $.only_child(small_2, true);
						var text_9 = $.sibling(small_2, 1, true);
						$.reset(span_5);
						$.template_effect(($0) => {
							$.set_text(text_8, axis);
							$.set_text(text_9, $0);
						}, [() => fixed(machine.status.position.absolute[axis])]);
						$.append($$anchor, span_5);
					});
					$.reset(span_4);
					$.append($$anchor, span_4);
				};
				$.if(node_4, ($$render) => {
					if (machine.status) $$render(consequent_3);
				});
				$.reset(div_1);
				$.template_effect(() => $.set_text(text_7, $.get(name)));
				$.append($$anchor, div_1);
			};
			$.if(node_2, ($$render) => {
				if (compact()) $$render(consequent_2);
				else $$render(alternate, -1);
			});
			var node_5 = $.sibling(node_2, 2);
			var consequent_4 = ($$anchor) => {
				Restart($$anchor, {});
			};
			var consequent_5 = ($$anchor) => {
				var div_2 = root_5();
				var span_6 = $.child(div_2);
				var text_10 = $.only_child(span_6, true);
				var node_6 = $.sibling(span_6, 2);
				Button(node_6, {
					icon: "undo",
					onclick: () => restart.ask(null),
					"data-testid": "take-up",
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text_11 = $.text();
						$.template_effect(($0) => $.set_text(text_11, $0), [() => t("restart.take_up")]);
						$.append($$anchor, text_11);
					},
					$$slots: { default: true }
				});
				$.reset(div_2);
				$.template_effect(($0) => $.set_text(text_10, $0), [() => t("restart.interrupted", {
					program: machine.status.interrupted.file,
					line: machine.status.interrupted.line
				})]);
				$.append($$anchor, div_2);
			};
			$.if(node_5, ($$render) => {
				if (!compact() && (restart.asked || machine.status?.restart_ready)) $$render(consequent_4);
				else if (!compact() && machine.status?.interrupted) $$render(consequent_5, 1);
			});
			var node_7 = $.sibling(node_5, 2);
			var consequent_6 = ($$anchor) => {
				var p = root_6();
				var text_12 = $.only_child(p, true);
				$.template_effect(($0) => $.set_text(text_12, $0), [() => t("program.retraced")]);
				$.append($$anchor, p);
			};
			$.if(node_7, ($$render) => {
				if ($.get(program)?.retraced) $$render(consequent_6);
			});
			var div_3 = $.sibling(node_7, 2);
			var node_8 = $.child(div_3);
			{
				let $0 = $.derived(() => $.get(program)?.cursor ?? 0);
				let $1 = $.derived(() => t("program.run"));
				$.bind_this(Editor(node_8, {
					get text() {
						return $.get(text);
					},
					readonly: true,
					get active() {
						return $.get(active);
					},
					get cursor() {
						return $.get($0);
					},
					get label() {
						return $.get($1);
					},
					online: (line) => $.set(chosen, line, true)
				}), ($$value) => $.set(editor, $$value, true), () => $.get(editor));
			}
			$.reset(div_3);
			var node_9 = $.sibling(div_3, 2);
			var consequent_8 = ($$anchor) => {
				var div_4 = root_7();
				var node_10 = $.child(div_4);
				{
					let $0 = $.derived(() => $.get(chosen) === 0);
					Button(node_10, {
						icon: "target",
						get disabled() {
							return $.get($0);
						},
						onclick: () => void machine.tell({
							do: "cursor",
							line: $.get(chosen)
						}),
						"data-testid": "cursor",
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text_13 = $.text();
							$.template_effect(($0) => $.set_text(text_13, $0), [() => t("program.start_here", { line: $.get(chosen) || "–" })]);
							$.append($$anchor, text_13);
						},
						$$slots: { default: true }
					});
				}
				var node_11 = $.sibling(node_10, 2);
				{
					let $0 = $.derived(() => $.get(chosen) === 0);
					Button(node_11, {
						icon: "undo",
						get disabled() {
							return $.get($0);
						},
						onclick: () => restart.ask($.get(chosen)),
						"data-testid": "restart-here",
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text_14 = $.text();
							$.template_effect(($0) => $.set_text(text_14, $0), [() => t("program.restart_here", { line: $.get(chosen) || "–" })]);
							$.append($$anchor, text_14);
						},
						$$slots: { default: true }
					});
				}
				var node_12 = $.sibling(node_11, 2);
				var consequent_7 = ($$anchor) => {
					Button($$anchor, {
						icon: "undo",
						onclick: () => void machine.tell({ do: "retrace" }),
						"data-testid": "retrace",
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text_15 = $.text();
							$.template_effect(($0) => $.set_text(text_15, $0), [() => t("program.retrace")]);
							$.append($$anchor, text_15);
						},
						$$slots: { default: true }
					});
				};
				$.if(node_12, ($$render) => {
					if (machine.status?.activity === "held" || $.get(program)?.retraced) $$render(consequent_7);
				});
				var span_7 = $.sibling(node_12, 2);
				var node_13 = $.child(span_7);
				{
					let $0 = $.derived(() => t("program.stop_at"));
					NumberField(node_13, {
						get value() {
							return $.get(stopAt);
						},
						whole: true,
						minimum: 0,
						maximum: 99999,
						empty: true,
						get label() {
							return $.get($0);
						},
						unit: "N",
						onvalue: (value) => void machine.tell({
							do: "stop_at",
							sequence: value
						})
					});
				}
				$.reset(span_7);
				var span_8 = $.sibling(span_7, 2);
				var text_16 = $.only_child(span_8, true);
				var node_14 = $.sibling(span_8, 4);
				Button(node_14, {
					icon: "graphics",
					onclick: () => go("graphics"),
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text_17 = $.text();
						$.template_effect(($0) => $.set_text(text_17, $0), [() => t("graphics.title")]);
						$.append($$anchor, text_17);
					},
					$$slots: { default: true }
				});
				var node_15 = $.sibling(node_14, 2);
				Button(node_15, {
					icon: "edit",
					onclick: () => go("program", "edit", $.get(name)),
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text_18 = $.text();
						$.template_effect(($0) => $.set_text(text_18, $0), [() => t("program.edit")]);
						$.append($$anchor, text_18);
					},
					$$slots: { default: true }
				});
				$.reset(div_4);
				$.template_effect(($0) => $.set_text(text_16, $0), [() => t("program.stop_at")]);
				$.append($$anchor, div_4);
			};
			$.if(node_9, ($$render) => {
				if (!compact()) $$render(consequent_8);
			});
			$.reset(div);
		}
		$.template_effect(() => classes = $.set_class(div, 1, "run s-1fv2bn7", null, classes, { compact: compact() }));
		$.append($$anchor, div);
	};
	$.if(node, ($$render) => {
		if (!$.get(name)) $$render(consequent);
		else $$render(alternate_1, -1);
	});
	$.append($$anchor, fragment);
	$.pop();
}
export { RunView as default };
