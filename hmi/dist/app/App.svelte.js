import { load, t } from "./lib/i18n/index.svelte.js";
import Button from "./lib/parts/Button.svelte.js";
import Empty from "./lib/parts/Empty.svelte.js";
import Notices from "./lib/parts/Notices.svelte.js";
import { go, route } from "./lib/routing.svelte.js";
import { display } from "./lib/state/display.svelte.js";
import { dnc } from "./lib/state/dnc.svelte.js";
import { editing } from "./lib/state/editing.svelte.js";
import { machine } from "./lib/state/machine.svelte.js";
import { prefs } from "./lib/state/prefs.svelte.js";
import { trail } from "./lib/state/trail.svelte.js";
import { ui } from "./lib/state/ui.svelte.js";
import { pages } from "./pages/index.js";
import Banner from "./shell/Banner.svelte.js";
import BottomBar from "./shell/BottomBar.svelte.js";
import KeyMap from "./shell/KeyMap.svelte.js";
import MachinePanel from "./shell/MachinePanel.svelte.js";
import Navigation from "./shell/Navigation.svelte.js";
import TopBar from "./shell/TopBar.svelte.js";
import Welcome from "./shell/Welcome.svelte.js";
import { untrack } from "svelte";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/App.svelte
var root = $.from_html(`<div><!> <!> <main class="s-4kp6f8"><!> <div class="page s-4kp6f8"><!></div></main> <!> <!> <!></div> <!> <!>`, 1);
function App($$anchor, $$props) {
	$.push($$props, true);
	const page = $.derived(() => pages.find((one) => one.id === route.page) ?? pages[0]);
	let shown = $.state(null);
	let failed = $.state(false);
	$.user_effect(() => {
		const wanted = $.get(page);
		$.set(failed, false);
		wanted.load().then(({ default: component }) => {
			if ($.get(page).id === wanted.id) $.set(shown, {
				id: wanted.id,
				component
			});
		}, () => $.set(failed, true));
	});
	/** What is not stored, and the rest of a file that is on its way, are in this page alone. */
	function ask(event) {
		if (dnc.coming || editing.unsaved.length) event.preventDefault();
	}
	$.user_effect(display.follow);
	$.user_effect(trail.follow);
	$.user_effect(() => machine.hear((event) => {
		if (display.alarmOpens && event.event === "alarm" && !event.alarm.warning) go("alarms");
	}));
	const writes = () => ["program/edit", "plc/edit"].includes(`${route.page}/${route.tab}`);
	let before = null;
	$.user_effect(() => {
		const mode = machine.mode;
		if (untrack(() => before && machine.inCommand && display.editOpens && !writes()) && mode === "edit" && before !== "edit") go("program", "edit");
		before = mode;
	});
	$.user_effect(() => {
		load(prefs.language);
	});
	$.user_effect(() => {
		document.title = `${t(`${$.get(page).id}.title`)} · ${machine.version?.machine ?? t("app.name")}`;
	});
	var fragment = root();
	$.event("beforeunload", $.window, ask);
	var div = $.first_child(fragment);
	let classes;
	var node = $.child(div);
	TopBar(node, {});
	var node_1 = $.sibling(node, 2);
	Navigation(node_1, { get current() {
		return $.get(page).id;
	} });
	var main = $.sibling(node_1, 2);
	var node_2 = $.child(main);
	Banner(node_2, {});
	var div_1 = $.sibling(node_2, 2);
	var node_3 = $.child(div_1);
	var consequent = ($$anchor) => {
		{
			let $0 = $.derived(() => t("rights.gate"));
			let $1 = $.derived(() => t("rights.gate_text"));
			Empty($$anchor, {
				icon: "user",
				get title() {
					return $.get($0);
				},
				get text() {
					return $.get($1);
				},
				children: ($$anchor, $$slotProps) => {
					Button($$anchor, {
						kind: "primary",
						onclick: () => ui.logIn = true,
						"data-testid": "gate",
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text = $.text();
							$.template_effect(($0) => $.set_text(text, $0), [() => t("rights.log_in")]);
							$.append($$anchor, text);
						},
						$$slots: { default: true }
					});
				},
				$$slots: { default: true }
			});
		}
	};
	var consequent_1 = ($$anchor) => {
		{
			let $0 = $.derived(() => t("app.page_failed"));
			let $1 = $.derived(() => t("app.page_failed_text"));
			Empty($$anchor, {
				icon: "alarms",
				get title() {
					return $.get($0);
				},
				get text() {
					return $.get($1);
				}
			});
		}
	};
	var consequent_2 = ($$anchor) => {
		const Shown = $.derived(() => $.get(shown).component);
		var fragment_5 = $.comment();
		var node_4 = $.first_child(fragment_5);
		$.component(node_4, () => $.get(Shown), ($$anchor, Shown_1) => {
			Shown_1($$anchor, {});
		});
		$.append($$anchor, fragment_5);
	};
	$.if(node_3, ($$render) => {
		if (machine.gate) $$render(consequent);
		else if ($.get(failed)) $$render(consequent_1, 1);
		else if ($.get(shown) && machine.gate === false) $$render(consequent_2, 2);
	});
	$.reset(div_1);
	$.reset(main);
	var node_5 = $.sibling(main, 2);
	var consequent_3 = ($$anchor) => {
		MachinePanel($$anchor, {});
	};
	$.if(node_5, ($$render) => {
		if (prefs.panel) $$render(consequent_3);
	});
	var node_6 = $.sibling(node_5, 2);
	BottomBar(node_6, {});
	var node_7 = $.sibling(node_6, 2);
	Notices(node_7, {});
	$.reset(div);
	var node_8 = $.sibling(div, 2);
	KeyMap(node_8, {});
	var node_9 = $.sibling(node_8, 2);
	Welcome(node_9, {});
	$.template_effect(() => classes = $.set_class(div, 1, "app s-4kp6f8", null, classes, { panel: prefs.panel }));
	$.append($$anchor, fragment);
	$.pop();
}
export { App as default };
