import { language, t } from "../lib/i18n/index.svelte.js";
import Icon from "../lib/parts/Icon.svelte.js";
import Key from "../lib/parts/Key.svelte.js";
import { machine } from "../lib/state/machine.svelte.js";
import { prefs } from "../lib/state/prefs.svelte.js";
import { share } from "../lib/state/share.js";
import { auxiliaries, axisKeysOf, ownKeysOf, spindle, switches } from "./keys.js";
import AxisKeys from "./panel/AxisKeys.svelte.js";
import Handwheel from "./panel/Handwheel.svelte.js";
import Overrides from "./panel/Overrides.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/shell/MachinePanel.svelte
var root = $.from_html(`<p class="muted note s-gdbind"> </p>`);
var root_1 = $.from_html(`<!><span> </span>`, 1);
var root_2 = $.from_html(`<span><i class="s-gdbind"></i> </span>`);
var root_3 = $.from_html(`<section data-testid="own-keys" class="s-gdbind"><h3> </h3> <div class="keys s-gdbind"></div></section>`);
var root_4 = $.from_html(`<section class="s-gdbind"><h3 class="s-gdbind"> </h3> <!></section> <!> <section class="s-gdbind"><h3> </h3> <!></section> <section class="s-gdbind"><h3> </h3> <div class="keys s-gdbind"></div></section> <section class="s-gdbind"><h3> </h3> <div class="keys three s-gdbind"></div></section> <section class="s-gdbind"><h3> </h3> <div class="keys three s-gdbind"></div></section> <!>`, 1);
var root_5 = $.from_html(`<aside class="scroll s-gdbind" data-testid="machine-panel"><button type="button" class="close s-gdbind"><!></button> <!></aside>`);
function MachinePanel($$anchor, $$props) {
	$.push($$props, true);
	const asked = [
		"HS1A",
		"HS1B",
		"HS1C",
		"MP1",
		"MP2"
	];
	let signals = $.state({});
	const bits = (...names) => names[0] in $.get(signals) ? names.reduce((sum, name, bit) => sum + ($.get(signals)[name] ?? 0) * 2 ** bit, 0) : null;
	/** What the ladder has names for; it may have keys and lamps of its own. */
	let named = $.state({
		inputs: [],
		outputs: []
	});
	const own = $.derived(() => ownKeysOf($.get(named).inputs, $.get(named).outputs));
	const has = (...keys) => keys.every((key) => $.get(named).inputs.some(({ name }) => name === key));
	const axes = $.derived(() => axisKeysOf(machine.axes).filter(({ plus, minus, isStandard }) => isStandard || has(plus, minus)));
	const wheeled = $.derived(() => axisKeysOf(machine.axes).filter(({ wheel, isStandard }) => isStandard || has(wheel)));
	$.user_effect(() => {
		machine.changed("ladder");
		const spoken = language();
		if (machine.link !== "open" || machine.hello?.panel?.ladder === false) return;
		const table = async (area) => {
			const reply = await machine.ask({
				do: "signal_table",
				area,
				language: spoken
			}).catch(() => null);
			return reply?.reply === "signal_table" ? reply.signals : [];
		};
		let wanted = true;
		Promise.all([table("X"), table("Y")]).then(([inputs, outputs]) => wanted && $.set(named, {
			inputs,
			outputs
		}));
		return () => {
			wanted = false;
		};
	});
	$.user_effect(() => {
		const read = async () => {
			if (machine.link !== "open" || document.visibilityState === "hidden") return;
			const reply = await machine.ask({
				do: "signals",
				names: asked
			}).catch(() => null);
			if (reply?.reply === "signals") $.set(signals, share($.get(signals), reply.signals));
		};
		read();
		const timer = setInterval(() => void read(), 400);
		return () => clearInterval(timer);
	});
	var aside = root_5();
	var button = $.child(aside);
	var node = $.child(button);
	Icon(node, { name: "close" });
	$.reset(button);
	var node_1 = $.sibling(button, 2);
	var consequent = ($$anchor) => {
		var p = root();
		var text = $.only_child(p, true);
		$.template_effect(($0) => $.set_text(text, $0), [() => t("panel.no_ladder")]);
		$.append($$anchor, p);
	};
	var alternate_1 = ($$anchor) => {
		var fragment = root_4();
		var section = $.first_child(fragment);
		var h3 = $.child(section);
		var text_1 = $.only_child(h3, true);
		var node_2 = $.sibling(h3, 2);
		{
			let $0 = $.derived(() => bits("MP1", "MP2"));
			AxisKeys(node_2, {
				get step() {
					return $.get($0);
				},
				get axes() {
					return $.get(axes);
				}
			});
		}
		$.reset(section);
		var node_3 = $.sibling(section, 2);
		{
			let $0 = $.derived(() => bits("HS1A", "HS1B", "HS1C"));
			Handwheel(node_3, {
				get axis() {
					return $.get($0);
				},
				get axes() {
					return $.get(wheeled);
				}
			});
		}
		var section_1 = $.sibling(node_3, 2);
		var h3_1 = $.child(section_1);
		var text_2 = $.only_child(h3_1, true);
		var node_4 = $.sibling(h3_1, 2);
		Overrides(node_4, {});
		$.reset(section_1);
		var section_2 = $.sibling(section_1, 2);
		var h3_2 = $.child(section_2);
		var text_3 = $.only_child(h3_2, true);
		var div = $.sibling(h3_2, 2);
		$.each(div, 21, () => switches, (key) => key.signal, ($$anchor, key) => {
			{
				let $0 = $.derived(() => t($.get(key).text));
				Key($$anchor, {
					get signal() {
						return $.get(key).signal;
					},
					get lamp() {
						return $.get(key).lamp;
					},
					get label() {
						return $.get($0);
					}
				});
			}
		});
		$.reset(div);
		$.reset(section_2);
		var section_3 = $.sibling(section_2, 2);
		var h3_3 = $.child(section_3);
		var text_4 = $.only_child(h3_3, true);
		var div_1 = $.sibling(h3_3, 2);
		$.each(div_1, 21, () => spindle, (key) => key.signal, ($$anchor, key) => {
			{
				let $0 = $.derived(() => t($.get(key).text));
				Key($$anchor, {
					get signal() {
						return $.get(key).signal;
					},
					get lamp() {
						return $.get(key).lamp;
					},
					get label() {
						return $.get($0);
					},
					children: ($$anchor, $$slotProps) => {
						var fragment_3 = root_1();
						var node_5 = $.first_child(fragment_3);
						var consequent_1 = ($$anchor) => {
							Icon($$anchor, { get name() {
								return $.get(key).icon;
							} });
						};
						$.if(node_5, ($$render) => {
							if ($.get(key).icon) $$render(consequent_1);
						});
						var span = $.sibling(node_5);
						var text_5 = $.only_child(span, true);
						$.template_effect(($0) => $.set_text(text_5, $0), [() => t($.get(key).text)]);
						$.append($$anchor, fragment_3);
					},
					$$slots: { default: true }
				});
			}
		});
		$.reset(div_1);
		$.reset(section_3);
		var section_4 = $.sibling(section_3, 2);
		var h3_4 = $.child(section_4);
		var text_6 = $.only_child(h3_4, true);
		var div_2 = $.sibling(h3_4, 2);
		$.each(div_2, 21, () => auxiliaries, (key) => key.signal, ($$anchor, key) => {
			{
				let $0 = $.derived(() => t($.get(key).text));
				Key($$anchor, {
					get signal() {
						return $.get(key).signal;
					},
					get lamp() {
						return $.get(key).lamp;
					},
					get label() {
						return $.get($0);
					},
					children: ($$anchor, $$slotProps) => {
						var fragment_6 = root_1();
						var node_6 = $.first_child(fragment_6);
						var consequent_2 = ($$anchor) => {
							Icon($$anchor, { get name() {
								return $.get(key).icon;
							} });
						};
						$.if(node_6, ($$render) => {
							if ($.get(key).icon) $$render(consequent_2);
						});
						var span_1 = $.sibling(node_6);
						var text_7 = $.only_child(span_1, true);
						$.template_effect(($0) => $.set_text(text_7, $0), [() => t($.get(key).text)]);
						$.append($$anchor, fragment_6);
					},
					$$slots: { default: true }
				});
			}
		});
		$.reset(div_2);
		$.reset(section_4);
		var node_7 = $.sibling(section_4, 2);
		var consequent_4 = ($$anchor) => {
			var section_5 = root_3();
			var h3_5 = $.child(section_5);
			var text_8 = $.only_child(h3_5, true);
			var div_3 = $.sibling(h3_5, 2);
			$.each(div_3, 21, () => $.get(own), (key) => key.signal || key.lamp, ($$anchor, key) => {
				var fragment_8 = $.comment();
				var node_8 = $.first_child(fragment_8);
				var consequent_3 = ($$anchor) => {
					Key($$anchor, {
						get signal() {
							return $.get(key).signal;
						},
						get lamp() {
							return $.get(key).lamp;
						},
						get label() {
							return $.get(key).text;
						}
					});
				};
				var alternate = ($$anchor) => {
					var span_2 = root_2();
					let classes;
					var text_9 = $.sibling($.child(span_2), 1, true);
					$.reset(span_2);
					$.template_effect(($0) => {
						classes = $.set_class(span_2, 1, "lamp s-gdbind", null, classes, { lit: $0 });
						$.set_attribute(span_2, "data-lamp", $.get(key).lamp);
						$.set_text(text_9, $.get(key).text);
					}, [() => machine.lamps.has($.get(key).lamp)]);
					$.append($$anchor, span_2);
				};
				$.if(node_8, ($$render) => {
					if ($.get(key).signal) $$render(consequent_3);
					else $$render(alternate, -1);
				});
				$.append($$anchor, fragment_8);
			});
			$.reset(div_3);
			$.reset(section_5);
			$.template_effect(($0) => $.set_text(text_8, $0), [() => t("panel.own")]);
			$.append($$anchor, section_5);
		};
		$.if(node_7, ($$render) => {
			if ($.get(own).length) $$render(consequent_4);
		});
		$.template_effect(($0, $1, $2, $3, $4) => {
			$.set_text(text_1, $0);
			$.set_text(text_2, $1);
			$.set_text(text_3, $2);
			$.set_text(text_4, $3);
			$.set_text(text_6, $4);
		}, [
			() => t("panel.axes"),
			() => t("panel.overrides"),
			() => t("panel.switches"),
			() => t("panel.spindle"),
			() => t("panel.auxiliaries")
		]);
		$.append($$anchor, fragment);
	};
	$.if(node_1, ($$render) => {
		if (machine.hello?.panel?.ladder === false) $$render(consequent);
		else $$render(alternate_1, -1);
	});
	$.reset(aside);
	$.template_effect(($0, $1) => {
		$.set_attribute(aside, "aria-label", $0);
		$.set_attribute(button, "aria-label", $1);
	}, [() => t("panel.title"), () => t("app.close")]);
	$.delegated("click", button, () => prefs.panel = false);
	$.append($$anchor, aside);
	$.pop();
}
$.delegate(["click"]);
export { MachinePanel as default };
