import { t } from "../i18n/index.svelte.js";
import Button from "../parts/Button.svelte.js";
import Dialog from "../parts/Dialog.svelte.js";
import Labelled from "../parts/Labelled.svelte.js";
import { notify } from "../state/notices.svelte.js";
import { box, outline, svgPath } from "./geometry.js";
import { fits, isName, profiles } from "./profiles.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/cycles/Profiles.svelte
var root = $.from_html(`<input class="code" maxlength="32" autocapitalize="characters" spellcheck="false" data-testid="profile-name"/>`);
var root_1 = $.from_html(`<div class="row kept s-1qi0map"><button type="button" class="grow s-1qi0map"><svg aria-hidden="true" class="s-1qi0map"><path class="s-1qi0map"></path></svg> <span class="code"> </span></button> <!></div>`);
var root_2 = $.from_html(`<p class="muted"> </p>`);
var root_3 = $.from_html(`<div class="row wrap"><!> <!></div> <!>`, 1);
var root_4 = $.from_html(`<!> <!>`, 1);
function Profiles($$anchor, $$props) {
	$.push($$props, true);
	let open = $.state(false);
	let wanted = $.state("");
	const listed = $.derived(() => profiles.of($$props.use));
	const isProfile = $.derived(() => $$props.contours.length > 0 && fits($$props.contours, $$props.use === "depth", $$props.use));
	function keep() {
		const isKept = profiles.keep($.get(wanted), $$props.contours, $$props.use === "depth");
		notify({
			kind: isKept ? "done" : "warning",
			title: t(isKept ? "cycles.kept_profile" : "cycles.profile_not_kept", { name: $.get(wanted) })
		});
		$$props.ontake($$props.contours, $.get(wanted));
	}
	function take(called) {
		$$props.ontake(profiles.get(called, $$props.use), called);
		$.set(open, false);
	}
	var fragment = root_4();
	var node = $.first_child(fragment);
	Button(node, {
		icon: "list",
		onclick: () => {
			$.set(wanted, $$props.name, true);
			$.set(open, true);
		},
		"data-testid": "profiles",
		children: ($$anchor, $$slotProps) => {
			$.next();
			var text = $.text();
			$.template_effect(($0) => $.set_text(text, $0), [() => t("cycles.profiles")]);
			$.append($$anchor, text);
		},
		$$slots: { default: true }
	});
	var node_1 = $.sibling(node, 2);
	{
		let $0 = $.derived(() => t("cycles.profiles"));
		Dialog(node_1, {
			get title() {
				return $.get($0);
			},
			get open() {
				return $.get(open);
			},
			set open($$value) {
				$.set(open, $$value, true);
			},
			children: ($$anchor, $$slotProps) => {
				var fragment_2 = root_3();
				var div = $.first_child(fragment_2);
				var node_2 = $.child(div);
				{
					let $0 = $.derived(() => t("cycles.profile_name"));
					Labelled(node_2, {
						get label() {
							return $.get($0);
						},
						children: ($$anchor, $$slotProps) => {
							var input = root();
							$.remove_input_defaults(input);
							$.bind_value(input, () => $.get(wanted), ($$value) => $.set(wanted, $$value));
							$.append($$anchor, input);
						},
						$$slots: { default: true }
					});
				}
				var node_3 = $.sibling(node_2, 2);
				{
					let $0 = $.derived(() => !isName($.get(wanted)) || !$.get(isProfile));
					Button(node_3, {
						icon: "save",
						get disabled() {
							return $.get($0);
						},
						onclick: keep,
						"data-testid": "keep-profile",
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text_1 = $.text();
							$.template_effect(($0) => $.set_text(text_1, $0), [() => t(profiles.has($.get(wanted)) ? "cycles.replace_profile" : "cycles.keep_profile")]);
							$.append($$anchor, text_1);
						},
						$$slots: { default: true }
					});
				}
				$.reset(div);
				var node_4 = $.sibling(div, 2);
				$.each(node_4, 17, () => $.get(listed), ([called, kept]) => called, ($$anchor, $$item) => {
					var $$array = $.derived(() => $.to_array($.get($$item), 2));
					let called = () => $.get($$array)[0];
					let kept = () => $.get($$array)[1];
					const lines = $.derived(() => kept().contours.map(outline));
					const frame = $.derived(() => box($.get(lines).flat(), .1));
					var div_1 = root_1();
					var button = $.child(div_1);
					var svg = $.child(button);
					var path = $.only_child(svg);
					var span = $.sibling(svg, 2);
					var text_2 = $.only_child(span, true);
					$.reset(button);
					var node_5 = $.sibling(button, 2);
					{
						let $0 = $.derived(() => t("cycles.delete"));
						Button(node_5, {
							kind: "quiet",
							icon: "trash",
							get "aria-label"() {
								return $.get($0);
							},
							onclick: () => profiles.remove(called())
						});
					}
					$.reset(div_1);
					$.template_effect(($0) => {
						$.set_attribute(div_1, "data-profile", called());
						$.set_attribute(svg, "viewBox", `${$.get(frame).x ?? ""} ${-$.get(frame).y - $.get(frame).h} ${$.get(frame).w ?? ""} ${$.get(frame).h ?? ""}`);
						$.set_attribute(path, "d", $0);
						$.set_text(text_2, called());
					}, [() => $.get(lines).map(svgPath).join("")]);
					$.delegated("click", button, () => take(called()));
					$.append($$anchor, div_1);
				}, ($$anchor) => {
					var p = root_2();
					var text_3 = $.only_child(p, true);
					$.template_effect(($0) => $.set_text(text_3, $0), [() => t("cycles.profiles_none")]);
					$.append($$anchor, p);
				});
				$.append($$anchor, fragment_2);
			},
			$$slots: { default: true }
		});
	}
	$.append($$anchor, fragment);
	$.pop();
}
$.delegate(["click"]);
export { Profiles as default };
