import { number, t } from "../../lib/i18n/index.svelte.js";
import { fixed } from "../../lib/numbers.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import NumberField from "../../lib/parts/NumberField.svelte.js";
import { alarmText } from "../../lib/state/alarm-texts.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { called, restart } from "../../lib/state/restart.svelte.js";
import Differences from "./Differences.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/program/Restart.svelte
var root = $.from_html(`<p class="missing s-c5cfhv" role="alert" data-testid="restart-missing"> </p>`);
var root_1 = $.from_html(`<span> </span>`);
var root_2 = $.from_html(`<dt class="s-c5cfhv"> </dt><dd class="number s-c5cfhv"> </dd>`, 1);
var root_3 = $.from_html(`<li class="number"><strong> </strong> <span class="muted"> </span></li>`);
var root_4 = $.from_html(`<li class="none s-c5cfhv">–</li>`);
var root_5 = $.from_html(`<p class="muted"> </p>`);
var root_6 = $.from_html(`<p class="missing s-c5cfhv"> </p>`);
var root_7 = $.from_html(`<p class="go s-c5cfhv" role="status"> </p> <p class="code text s-c5cfhv"> </p> <!> <dl class="s-c5cfhv"><dt class="s-c5cfhv"> </dt> <dd class="number s-c5cfhv"></dd> <!> <dt class="s-c5cfhv"> </dt> <dd class="code s-c5cfhv"></dd> <dt class="s-c5cfhv"> </dt> <dd class="s-c5cfhv"><ol class="s-c5cfhv"></ol></dd> <!></dl> <!> <!> <!>`, 1);
var root_8 = $.from_html(`<p> </p>`);
var root_9 = $.from_html(`<p> </p> <p class="code text s-c5cfhv"> </p>`, 1);
var root_10 = $.from_html(`<span class="muted"> </span> <span class="pass s-c5cfhv"><!></span>`, 1);
var root_11 = $.from_html(`<!> <div class="row wrap"><!> <label class="row s-c5cfhv"><input type="checkbox" class="s-c5cfhv"/> </label> <label class="row s-c5cfhv"><input type="checkbox" class="s-c5cfhv"/> </label> <!></div> <p class="muted"> </p>`, 1);
var root_12 = $.from_html(`<div class="restart s-c5cfhv" data-testid="restart"><!></div>`);
function Restart($$anchor, $$props) {
	$.push($$props, true);
	let pass = $.state(1);
	let sends = $.state(false);
	let each = $.state(false);
	let now = $.state(null);
	const ready = $.derived(() => machine.status?.restart_ready ?? false);
	const plan = $.derived(() => $.get(ready) ? $.get(now)?.ready ?? null : null);
	const interrupted = $.derived(() => machine.status?.interrupted ?? null);
	const searching = $.derived(() => !$.get(ready) && ($.get(now)?.searching ?? false));
	let wasReady = false;
	$.user_effect(() => {
		if (wasReady && !$.get(ready)) restart.close();
		wasReady = $.get(ready);
	});
	$.user_effect(() => {
		if (!restart.asked && !$.get(ready)) {
			$.set(now, null);
			return;
		}
		return restart.follow((reply) => $.set(now, reply));
	});
	const places = (of) => machine.axes.filter((axis) => axis in of).map((axis) => `${axis} ${fixed(of[axis])}`);
	var div = root_12();
	var node = $.child(div);
	{
		const actions = ($$anchor) => {
			var fragment = $.comment();
			var node_1 = $.first_child(fragment);
			var consequent = ($$anchor) => {
				Button($$anchor, {
					icon: "close",
					onclick: () => void restart.forget(),
					"data-testid": "restart-forget",
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text = $.text();
						$.template_effect(($0) => $.set_text(text, $0), [() => t("restart.forget")]);
						$.append($$anchor, text);
					},
					$$slots: { default: true }
				});
			};
			var alternate = ($$anchor) => {
				{
					let $0 = $.derived(() => t("app.close"));
					Button($$anchor, {
						kind: "quiet",
						icon: "close",
						get "aria-label"() {
							return $.get($0);
						},
						onclick: () => restart.close()
					});
				}
			};
			$.if(node_1, ($$render) => {
				if ($.get(ready) || $.get(searching)) $$render(consequent);
				else $$render(alternate, -1);
			});
			$.append($$anchor, fragment);
		};
		let $0 = $.derived(() => t("restart.title"));
		Card(node, {
			get title() {
				return $.get($0);
			},
			actions,
			children: ($$anchor, $$slotProps) => {
				var fragment_4 = $.comment();
				var node_2 = $.first_child(fragment_4);
				var consequent_7 = ($$anchor) => {
					var fragment_5 = root_7();
					var p = $.first_child(fragment_5);
					var text_1 = $.only_child(p, true);
					var p_1 = $.sibling(p, 2);
					var text_2 = $.only_child(p_1, true);
					var node_3 = $.sibling(p_1, 2);
					var consequent_1 = ($$anchor) => {
						var p_2 = root();
						var text_3 = $.only_child(p_2, true);
						$.template_effect(($0) => $.set_text(text_3, $0), [() => t("restart.missing", { list: $.get(plan).missing.map(called).join(", ") })]);
						$.append($$anchor, p_2);
					};
					$.if(node_3, ($$render) => {
						if ($.get(plan).missing.length) $$render(consequent_1);
					});
					var dl = $.sibling(node_3, 2);
					var dt = $.child(dl);
					var text_4 = $.only_child(dt, true);
					var dd = $.sibling(dt, 2);
					$.each(dd, 20, () => places($.get(plan).position), (place) => place, ($$anchor, place) => {
						var span = root_1();
						var text_5 = $.only_child(span, true);
						$.template_effect(() => $.set_text(text_5, place));
						$.append($$anchor, span);
					});
					$.reset(dd);
					var node_4 = $.sibling(dd, 2);
					var consequent_2 = ($$anchor) => {
						var fragment_6 = root_2();
						var dt_1 = $.first_child(fragment_6);
						var text_6 = $.only_child(dt_1, true);
						var dd_1 = $.sibling(dt_1);
						var text_7 = $.only_child(dd_1, true);
						$.template_effect(($0, $1) => {
							$.set_text(text_6, $0);
							$.set_text(text_7, $1);
						}, [() => t("restart.hole"), () => number($.get(plan).hole)]);
						$.append($$anchor, fragment_6);
					};
					$.if(node_4, ($$render) => {
						if ($.get(plan).hole > 1) $$render(consequent_2);
					});
					var dt_2 = $.sibling(node_4, 2);
					var text_8 = $.only_child(dt_2, true);
					var dd_2 = $.sibling(dt_2, 2);
					$.each(dd_2, 21, () => $.get(plan).functions, $.index, ($$anchor, one) => {
						var span_1 = root_1();
						var text_9 = $.only_child(span_1, true);
						$.template_effect(() => $.set_text(text_9, $.get(one)));
						$.append($$anchor, span_1);
					}, ($$anchor) => {
						$.next();
						var text_10 = $.text("–");
						$.append($$anchor, text_10);
					});
					$.reset(dd_2);
					var dt_3 = $.sibling(dd_2, 2);
					var text_11 = $.only_child(dt_3, true);
					var dd_3 = $.sibling(dt_3, 2);
					var ol = $.child(dd_3);
					$.each(ol, 21, () => $.get(plan).approach, $.index, ($$anchor, move) => {
						var li = root_3();
						var strong = $.child(li);
						var text_12 = $.only_child(strong);
						var span_2 = $.sibling(strong, 2);
						var text_13 = $.only_child(span_2);
						$.reset(li);
						$.template_effect(($0, $1, $2) => {
							$.set_text(text_12, `${$.get(move).axis ?? ""} ${$0 ?? ""}`);
							$.set_text(text_13, `${$1 ?? ""} ${$2 ?? ""}`);
						}, [
							() => fixed($.get(move).to),
							() => $.get(move).rapid ? t("restart.rapid") : "",
							() => $.get(move).speed === null ? "" : `F ${number($.get(move).speed)}`
						]);
						$.append($$anchor, li);
					}, ($$anchor) => {
						var li_1 = root_4();
						$.append($$anchor, li_1);
					});
					$.reset(ol);
					$.reset(dd_3);
					var node_5 = $.sibling(dd_3, 2);
					var consequent_3 = ($$anchor) => {
						var fragment_7 = root_2();
						var dt_4 = $.first_child(fragment_7);
						var text_14 = $.only_child(dt_4, true);
						var dd_4 = $.sibling(dt_4);
						var text_15 = $.only_child(dd_4, true);
						$.template_effect(($0, $1) => {
							$.set_text(text_14, $0);
							$.set_text(text_15, $1);
						}, [() => t("restart.changes"), () => number($.get(plan).changes)]);
						$.append($$anchor, fragment_7);
					};
					$.if(node_5, ($$render) => {
						if ($.get(plan).changes > 0) $$render(consequent_3);
					});
					$.reset(dl);
					var node_6 = $.sibling(dl, 2);
					var consequent_4 = ($$anchor) => {
						Differences($$anchor, { get plan() {
							return $.get(plan);
						} });
					};
					$.if(node_6, ($$render) => {
						if ($.get(plan).differences.length) $$render(consequent_4);
					});
					var node_7 = $.sibling(node_6, 2);
					var consequent_5 = ($$anchor) => {
						var p_3 = root_5();
						var text_16 = $.only_child(p_3, true);
						$.template_effect(($0) => $.set_text(text_16, $0), [() => t("restart.present")]);
						$.append($$anchor, p_3);
					};
					$.if(node_7, ($$render) => {
						if ($.get(plan).origin === "present") $$render(consequent_5);
					});
					var node_8 = $.sibling(node_7, 2);
					var consequent_6 = ($$anchor) => {
						var p_4 = root_6();
						var text_17 = $.only_child(p_4, true);
						$.template_effect(($0) => $.set_text(text_17, $0), [() => alarmText($.get(plan).warning).text]);
						$.append($$anchor, p_4);
					};
					$.if(node_8, ($$render) => {
						if ($.get(plan).warning) $$render(consequent_6);
					});
					$.template_effect(($0, $1, $2, $3) => {
						$.set_text(text_1, $0);
						$.set_text(text_2, $.get(plan).text);
						$.set_text(text_4, $1);
						$.set_text(text_8, $2);
						$.set_text(text_11, $3);
					}, [
						() => t("restart.ready", {
							program: $.get(plan).file,
							line: $.get(plan).line
						}),
						() => t("restart.begins"),
						() => t($.get(plan).sends ? "restart.sent" : "restart.yours"),
						() => t("restart.approach")
					]);
					$.append($$anchor, fragment_5);
				};
				var alternate_1 = ($$anchor) => {
					var fragment_9 = root_11();
					var node_9 = $.first_child(fragment_9);
					var consequent_8 = ($$anchor) => {
						var p_5 = root_8();
						var text_18 = $.only_child(p_5, true);
						$.template_effect(($0) => $.set_text(text_18, $0), [() => t("program.restart_here", { line: restart.line })]);
						$.append($$anchor, p_5);
					};
					var consequent_9 = ($$anchor) => {
						var fragment_10 = root_9();
						var p_6 = $.first_child(fragment_10);
						var text_19 = $.only_child(p_6, true);
						var p_7 = $.sibling(p_6, 2);
						var text_20 = $.only_child(p_7, true);
						$.template_effect(($0) => {
							$.set_text(text_19, $0);
							$.set_text(text_20, $.get(interrupted).text);
						}, [() => t("restart.interrupted", {
							program: $.get(interrupted).file,
							line: $.get(interrupted).line
						})]);
						$.append($$anchor, fragment_10);
					};
					$.if(node_9, ($$render) => {
						if (restart.line !== null) $$render(consequent_8);
						else if ($.get(interrupted)) $$render(consequent_9, 1);
					});
					var div_1 = $.sibling(node_9, 2);
					var node_10 = $.child(div_1);
					var consequent_10 = ($$anchor) => {
						var fragment_11 = root_10();
						var span_3 = $.first_child(fragment_11);
						var text_21 = $.only_child(span_3, true);
						var span_4 = $.sibling(span_3, 2);
						var node_11 = $.child(span_4);
						{
							let $0 = $.derived(() => t("restart.pass"));
							NumberField(node_11, {
								get value() {
									return $.get(pass);
								},
								whole: true,
								minimum: 1,
								get label() {
									return $.get($0);
								},
								onvalue: (now) => $.set(pass, now ?? 1, true)
							});
						}
						$.reset(span_4);
						$.template_effect(($0) => $.set_text(text_21, $0), [() => t("restart.pass")]);
						$.append($$anchor, fragment_11);
					};
					$.if(node_10, ($$render) => {
						if (restart.line !== null) $$render(consequent_10);
					});
					var label = $.sibling(node_10, 2);
					var input = $.child(label);
					$.remove_input_defaults(input);
					var text_22 = $.sibling(input, 1, true);
					$.reset(label);
					var label_1 = $.sibling(label, 2);
					var input_1 = $.child(label_1);
					$.remove_input_defaults(input_1);
					var text_23 = $.sibling(input_1, 1, true);
					$.reset(label_1);
					var node_12 = $.sibling(label_1, 2);
					Button(node_12, {
						kind: "primary",
						icon: "search",
						get busy() {
							return $.get(searching);
						},
						onclick: () => void restart.search({
							pass: $.get(pass),
							sends: $.get(sends),
							axis_by_axis: $.get(each)
						}),
						"data-testid": "restart-search",
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text_24 = $.text();
							$.template_effect(($0) => $.set_text(text_24, $0), [() => t("restart.search")]);
							$.append($$anchor, text_24);
						},
						$$slots: { default: true }
					});
					$.reset(div_1);
					var p_8 = $.sibling(div_1, 2);
					var text_25 = $.only_child(p_8, true);
					$.template_effect(($0, $1, $2) => {
						$.set_text(text_22, $0);
						$.set_text(text_23, $1);
						$.set_text(text_25, $2);
					}, [
						() => t("restart.sends"),
						() => t("restart.each"),
						() => t("restart.hint")
					]);
					$.bind_checked(input, () => $.get(sends), ($$value) => $.set(sends, $$value));
					$.bind_checked(input_1, () => $.get(each), ($$value) => $.set(each, $$value));
					$.append($$anchor, fragment_9);
				};
				$.if(node_2, ($$render) => {
					if ($.get(plan)) $$render(consequent_7);
					else $$render(alternate_1, -1);
				});
				$.append($$anchor, fragment_4);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	$.reset(div);
	$.template_effect(() => $.set_attribute(div, "data-ready", $.get(ready)));
	$.append($$anchor, div);
	$.pop();
}
export { Restart as default };
