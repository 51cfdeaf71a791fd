import { t } from "../../lib/i18n/index.svelte.js";
import Page from "../../lib/parts/Page.svelte.js";
import { route } from "../../lib/routing.svelte.js";
import { display } from "../../lib/state/display.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { prefs } from "../../lib/state/prefs.svelte.js";
import All from "./All.svelte.js";
import Large from "./Large.svelte.js";
import Modal from "./Modal.svelte.js";
import Relative from "./Relative.svelte.js";
import Speeds from "./Speeds.svelte.js";
import Times from "./Times.svelte.js";
import { __vitePreload } from "../../_virtual/_vite/preload-helper.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/position/Position.svelte
var root = $.from_html(`<div class="program s-1x7e8xk"><!></div>`);
var root_1 = $.from_html(`<div><div class="main s-1x7e8xk"><!></div> <div class="side s-1x7e8xk"><!> <!> <!></div> <!></div>`);
var root_2 = $.from_html(`<p class="muted"> </p>`);
function Position($$anchor, $$props) {
	$.push($$props, true);
	const tabs = $.derived(() => [
		"relative",
		"absolute",
		"all",
		"program"
	].map((id) => ({
		id,
		label: t(`position.${id}`)
	})));
	const active = $.derived(() => $.get(tabs).some((tab) => tab.id === route.tab) ? route.tab : prefs.coordinates);
	Page($$anchor, {
		page: "position",
		get tabs() {
			return $.get(tabs);
		},
		get active() {
			return $.get(active);
		},
		children: ($$anchor, $$slotProps) => {
			var fragment_1 = $.comment();
			var node = $.first_child(fragment_1);
			var consequent_4 = ($$anchor) => {
				var div = root_1();
				let classes;
				var div_1 = $.child(div);
				var node_1 = $.child(div_1);
				var consequent = ($$anchor) => {
					All($$anchor, {});
				};
				var alternate = ($$anchor) => {
					{
						const tools = ($$anchor, axis = $.noop) => {
							var fragment_4 = $.comment();
							var node_2 = $.first_child(fragment_4);
							var consequent_1 = ($$anchor) => {
								Relative($$anchor, { get axis() {
									return axis();
								} });
							};
							$.if(node_2, ($$render) => {
								if ($.get(active) === "relative") $$render(consequent_1);
							});
							$.append($$anchor, fragment_4);
						};
						let $0 = $.derived(() => $.get(active) === "relative" ? "relative" : "absolute");
						let $1 = $.derived(() => $.get(active) === "program");
						Large($$anchor, {
							get what() {
								return $.get($0);
							},
							get small() {
								return $.get($1);
							},
							tools,
							$$slots: { tools: true }
						});
					}
				};
				$.if(node_1, ($$render) => {
					if ($.get(active) === "all") $$render(consequent);
					else $$render(alternate, -1);
				});
				$.reset(div_1);
				var div_2 = $.sibling(div_1, 2);
				var node_3 = $.child(div_2);
				{
					let $0 = $.derived(() => $.get(active) === "relative" || $.get(active) === "absolute");
					Speeds(node_3, { get settable() {
						return $.get($0);
					} });
				}
				var node_4 = $.sibling(node_3, 2);
				var consequent_2 = ($$anchor) => {
					Modal($$anchor, {});
				};
				$.if(node_4, ($$render) => {
					if ($.get(active) !== "program" || display.showsModal) $$render(consequent_2);
				});
				var node_5 = $.sibling(node_4, 2);
				Times(node_5, {});
				$.reset(div_2);
				var node_6 = $.sibling(div_2, 2);
				var consequent_3 = ($$anchor) => {
					var div_3 = root();
					var node_7 = $.child(div_3);
					$.await(node_7, () => __vitePreload(() => import("./Running.svelte.js"), []), null, ($$anchor, $$source) => {
						var $$value = $.derived(() => {
							var { default: Running } = $.get($$source);
							return { Running };
						});
						var Running = $.derived(() => $.get($$value).Running);
						var fragment_7 = $.comment();
						var node_8 = $.first_child(fragment_7);
						$.component(node_8, () => $.get(Running), ($$anchor, Running_1) => {
							Running_1($$anchor, {});
						});
						$.append($$anchor, fragment_7);
					});
					$.reset(div_3);
					$.append($$anchor, div_3);
				};
				$.if(node_6, ($$render) => {
					if ($.get(active) === "program") $$render(consequent_3);
				});
				$.reset(div);
				$.template_effect(() => classes = $.set_class(div, 1, "grid s-1x7e8xk", null, classes, {
					"with-program": $.get(active) === "program",
					whole: $.get(active) === "all"
				}));
				$.append($$anchor, div);
			};
			var alternate_1 = ($$anchor) => {
				var p = root_2();
				var text = $.only_child(p, true);
				$.template_effect(($0) => $.set_text(text, $0), [() => t("app.loading")]);
				$.append($$anchor, p);
			};
			$.if(node, ($$render) => {
				if (machine.status) $$render(consequent_4);
				else $$render(alternate_1, -1);
			});
			$.append($$anchor, fragment_1);
		},
		$$slots: { default: true }
	});
	$.pop();
}
export { Position as default };
