import { language, t } from "../../lib/i18n/index.svelte.js";
import { client } from "../../lib/cycles/client.js";
import Drawing from "../../lib/cycles/Drawing.svelte.js";
import FieldInput from "../../lib/cycles/FieldInput.svelte.js";
import { axisOf, drawn, forms, request, toolsOf } from "../../lib/cycles/form.svelte.js";
import { moved } from "../../lib/cycles/geometry.js";
import { insert } from "../../lib/cycles/insert.js";
import { cycleAt } from "../../lib/cycles/read.js";
import PositionsEditor from "../../lib/cycles/PositionsEditor.svelte.js";
import ProfileEditor from "../../lib/cycles/ProfileEditor.svelte.js";
import { scene } from "../../lib/cycles/scene.js";
import Simulation from "../../lib/cycles/Simulation.svelte.js";
import { readPath } from "../../lib/graphics/path.js";
import { fixed } from "../../lib/numbers.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import Empty from "../../lib/parts/Empty.svelte.js";
import NumberField from "../../lib/parts/NumberField.svelte.js";
import Page from "../../lib/parts/Page.svelte.js";
import Segmented from "../../lib/parts/Segmented.svelte.js";
import { followParameters } from "../../lib/state/again.js";
import { editing } from "../../lib/state/editing.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { notify } from "../../lib/state/notices.svelte.js";
import { untrack } from "svelte";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/cycles/Cycles.svelte
var root = $.from_html(`<button type="button" role="tab"> </button>`);
var root_1 = $.from_html(`<button type="button"><span class="code s-1gnh3x7"> </span><span> </span></button>`);
var root_2 = $.from_html(`<h3 class="s-1gnh3x7"> </h3> <!>`, 1);
var root_3 = $.from_html(`<small class="opened s-1gnh3x7"> </small>`);
var root_4 = $.from_html(`<p role="alert"> <small class="code s-1gnh3x7"> </small><br/><span class="muted"> </span></p>`);
var root_5 = $.from_html(`<div class="row wrap"><h3 class="code grow s-1gnh3x7"></h3> <!> <!></div> <!>`, 1);
var root_6 = $.from_html(`<!> <!>`, 1);
var root_7 = $.from_html(`<div class="tools s-1gnh3x7"><b class="code s-1gnh3x7"> </b> <label class="s-1gnh3x7"><span class="muted"> </span><!></label> <label class="s-1gnh3x7"><span class="muted"> </span><!></label> <!> <label class="s-1gnh3x7"><span class="muted"> </span><!></label> <label class="s-1gnh3x7"><span class="muted"> </span><!></label></div>`);
var root_8 = $.from_html(`<!> <p class="muted s-1gnh3x7"> </p>`, 1);
var root_9 = $.from_html(`<span><small class="s-1gnh3x7"> </small> </span>`);
var root_10 = $.from_html(`<p class="stands number s-1gnh3x7" data-testid="stands"><!> <span><small class="s-1gnh3x7">F</small> </span> <span><small class="s-1gnh3x7">S</small> </span> <span><small class="s-1gnh3x7">T</small> </span></p>`);
var root_11 = $.from_html(`<div class="form scroll s-1gnh3x7"><header class="row wrap"><h2 class="grow"> <!></h2> <!> <!></header> <!> <!> <!> <!> <!> <!></div>`);
var root_12 = $.from_html(`<div class="plan s-1gnh3x7"><!></div> <div class="section s-1gnh3x7"><!></div>`, 1);
var root_13 = $.from_html(`<pre> </pre>`);
var root_14 = $.from_html(`<span class="spoken s-1gnh3x7"> </span>`);
var root_15 = $.from_html(`<div class="room s-1gnh3x7"><div class="cycles s-1gnh3x7"><nav class="list scroll s-1gnh3x7" data-pans=""><div class="groups s-1gnh3x7" role="tablist"></div> <!></nav> <!> <div class="side s-1gnh3x7"><div class="row wrap"><!></div> <div class="shown s-1gnh3x7"><!></div> <p aria-live="polite"><!></p> <div class="row wrap"><!> <!> <!></div></div></div></div>`);
function Cycles($$anchor, $$props) {
	$.push($$props, true);
	/** How long after the last change the cycle is written, ms. */
	const PAUSE = 250;
	let all = $.state([]);
	let failed = $.state(false);
	let focus = $.state("");
	let side = $.state("drawing");
	let written = $.state(null);
	/** What `written` is the answer to, and which wish was refused. */
	let writtenOf = $.state("");
	let refusedOf = $.state("");
	let path = $.state(null);
	let busy = $.state(false);
	/** What `path` is the answer to. */
	let simulated = $.state("");
	$.user_effect(() => {
		client.forms(language()).then((answer) => {
			$.set(all, answer);
			$.set(failed, false);
		}, () => $.set(failed, true));
	});
	const form = $.derived(() => $.get(all).find((one) => one.id === forms.chosen) ?? $.get(all)[0]);
	const opened = $.derived(() => editing.opened);
	let taken = null;
	$.user_pre_effect(() => {
		if ($.get(form)) forms.begin($.get(form));
		if (!$.get(opened) || $.get(opened) === taken || $.get(all).length === 0) return;
		taken = $.get(opened);
		const found = cycleAt($.get(opened).lines, 1);
		const its = $.get(all).find((one) => one.id === found?.request.cycle);
		if (found && its) untrack(() => forms.fill(its, found.request));
		else editing.open(null);
	});
	const filled = $.derived(() => $.get(form) ? forms.of($.get(form)) : void 0);
	const asked = $.derived(() => $.get(form) && $.get(filled) ? request($.get(form), $.get(filled)) : null);
	const called = $.derived(() => $.get(asked) ? toolsOf($.get(asked).values) : []);
	const picture = $.derived(() => $.get(form) && $.get(filled) && $.get(asked) ? {
		...scene($.get(form), {
			...$.get(asked),
			tools: $.get(called).map((number) => forms.tool(number))
		}),
		...drawn($.get(form), $.get(filled))
	} : null);
	const findings = $.derived(() => $.get(written)?.findings ?? []);
	const errors = $.derived(() => $.get(findings).filter((one) => one.severity === "error"));
	const general = $.derived(() => $.get(findings).filter((one) => !shown(one)));
	const dialect = $.derived(() => machine.dialect);
	const groups = $.derived(() => [...new Set($.get(all).map((one) => one.group))].map((group) => $.get(all).filter((one) => one.group === group)));
	const body = $.derived(() => $.get(asked) ? JSON.stringify($.get(asked)) : "");
	/** All that the motion depends on: the machine's tools too, and how its parameters have them entered. */
	const basis = $.derived(() => JSON.stringify([
		$.get(body),
		machine.changed("offsets"),
		machine.changed("parameters")
	]));
	/** All that the text depends on. */
	const wish = $.derived(() => JSON.stringify([
		$.get(basis),
		$.get(dialect),
		language()
	]));
	/** Whether the text is that of what stands in the form: it comes a while after each change. */
	const isCurrent = $.derived(() => $.get(written) !== null && $.get(writtenOf) === $.get(wish));
	const ready = $.derived(() => $.get(isCurrent) && $.get(written)?.text && $.get(errors).length === 0 ? $.get(written).text : "");
	/** Whether a finding stands at its field. */
	function shown(finding) {
		const name = finding.parameter;
		if (name.startsWith("positions")) return ($.get(form)?.positions.length ?? 0) > 0;
		if (name === "profile" && $.get(form)?.profile !== "none") return true;
		return $.get(form)?.parameters.some((field) => field.name === name) ?? false;
	}
	let hasDiameters = $.state(false);
	$.user_effect(() => followParameters(["NO40.7"], (values) => $.set(hasDiameters, values["NO40.7"] === 1)));
	let rows = $.state({});
	const calls = $.derived(() => $.get(called).join(" "));
	$.user_effect(() => {
		machine.changed("offsets");
		if ($.get(calls) === "" || machine.link !== "open") return;
		const numbers = $.get(calls).split(" ").map(Number);
		machine.fetch("offsets", {
			do: "offsets",
			from: Math.min(...numbers),
			to: Math.max(...numbers)
		}).then((reply) => {
			if (reply) $.set(rows, reply.offsets);
		});
	});
	$.user_pre_effect(() => {
		const share = $.get(hasDiameters) ? 1 : 2;
		const diameter = ({ radius, radius_wear }) => Math.round(((radius ?? 0) + (radius_wear ?? 0)) * share * 1e6) / 1e6;
		forms.setTable(Object.fromEntries(Object.entries($.get(rows)).map(([number, row]) => [number, diameter(row)])));
	});
	$.user_effect(() => {
		const [text, into, tongue, all] = [
			$.get(body),
			$.get(dialect),
			language(),
			$.get(wish)
		];
		if (!text) return;
		const abort = new AbortController();
		const timer = setTimeout(() => {
			client.write(JSON.parse(text), into, tongue, abort.signal).then((answer) => {
				if (abort.signal.aborted) return;
				$.set(written, answer);
				$.set(writtenOf, all);
			}, (refused) => {
				if (abort.signal.aborted) return;
				$.set(refusedOf, all);
				machine.refused(refused);
			});
		}, PAUSE);
		return () => {
			clearTimeout(timer);
			abort.abort();
		};
	});
	async function simulate() {
		$.set(side, "simulation");
		const [text, on] = [$.get(body), $.get(basis)];
		if (!text || on === $.get(simulated) && $.get(path)) return;
		$.set(busy, true);
		try {
			$.set(path, readPath(await client.path(JSON.parse(text))));
			$.set(simulated, on);
		} catch (refused) {
			$.set(path, null);
			machine.refused(refused);
		} finally {
			$.set(busy, false);
		}
	}
	/** Where the machine stands on an axis, counted from 0, in the work coordinate system; null where not known. */
	function here(axis) {
		const letter = machine.axes[axis];
		const at = letter === void 0 ? void 0 : machine.status?.position.work[letter];
		return at === void 0 ? null : Math.round(at * 1e4) / 1e4;
	}
	function teach(field) {
		const axis = axisOf(field);
		if (axis === null) return null;
		return () => {
			const at = here(axis);
			if (at !== null && $.get(filled)) $.get(filled).values[field.name] = at;
		};
	}
	/** The cycle of each group that was used last: who opens a group finds it (4.1). */
	const lastOf = {};
	function pick(id) {
		if ($.get(form)) lastOf[$.get(form).group] = $.get(form).id;
		editing.open(null);
		forms.choose(id);
		$.set(focus, "");
		$.set(path, null);
		$.set(written, null);
	}
	const nameOf = (field) => `${$.get(filled)?.values[field] ?? ""}`;
	/** A profile of depth in another plane: it begins where its contour does. */
	function turn(depth, plane, of) {
		const start = $.get(filled)?.contours[of]?.start[plane === "XZ" ? 0 : 1] ?? 0;
		depth.contour = moved(depth.contour, [start - depth.contour.start[0], 0]);
		depth.plane = plane;
	}
	function go(name) {
		$.set(focus, name, true);
		document.getElementById(`field-${name}`)?.focus();
	}
	let shape = $.state(void 0);
	/** To the first that is wrong, which may be out of sight. */
	function toError() {
		const first = $.get(shape)?.querySelector("[aria-invalid=\"true\"], .finding.error, .general.error");
		first?.scrollIntoView({ block: "center" });
		first?.focus();
	}
	async function copy() {
		if (!$.get(ready)) return;
		try {
			await navigator.clipboard.writeText($.get(ready));
			notify({
				kind: "done",
				title: t("cycles.copied")
			});
		} catch {
			$.set(side, "text");
			notify({
				kind: "warning",
				title: t("cycles.not_copied")
			});
		}
	}
	function put(value, field) {
		if (!$.get(filled)) return;
		if (value === void 0) delete $.get(filled).values[field.name];
		else $.get(filled).values[field.name] = value;
	}
	Page($$anchor, {
		page: "cycles",
		children: ($$anchor, $$slotProps) => {
			var fragment_1 = $.comment();
			var node = $.first_child(fragment_1);
			var consequent = ($$anchor) => {
				{
					let $0 = $.derived(() => t("cycles.failed"));
					let $1 = $.derived(() => t("cycles.failed_text"));
					Empty($$anchor, {
						icon: "cycles",
						get title() {
							return $.get($0);
						},
						get text() {
							return $.get($1);
						}
					});
				}
			};
			var consequent_15 = ($$anchor) => {
				var div = root_15();
				var div_1 = $.child(div);
				var nav = $.child(div_1);
				var div_2 = $.child(nav);
				$.each(div_2, 21, () => $.get(groups), (group) => group[0]?.group, ($$anchor, group) => {
					const open = $.derived(() => $.get(group).some((one) => one.id === $.get(form).id));
					var button = root();
					let classes;
					var text_1 = $.only_child(button, true);
					$.template_effect(() => {
						$.set_attribute(button, "data-group", $.get(group)[0]?.group);
						$.set_attribute(button, "aria-selected", $.get(open));
						classes = $.set_class(button, 1, "s-1gnh3x7", null, classes, { chosen: $.get(open) });
						$.set_text(text_1, $.get(group)[0]?.group_title);
					});
					$.delegated("click", button, () => !$.get(open) && pick(lastOf[$.get(group)[0].group] ?? $.get(group)[0].id));
					$.append($$anchor, button);
				});
				$.reset(div_2);
				var node_1 = $.sibling(div_2, 2);
				$.each(node_1, 17, () => $.get(groups), (group) => group[0]?.group, ($$anchor, group) => {
					var fragment_3 = root_2();
					var h3 = $.first_child(fragment_3);
					var text_2 = $.only_child(h3, true);
					var node_2 = $.sibling(h3, 2);
					$.each(node_2, 17, () => $.get(group), (one) => one.id, ($$anchor, one) => {
						var button_1 = root_1();
						let classes_1;
						var span = $.child(button_1);
						var text_3 = $.only_child(span, true);
						var span_1 = $.sibling(span);
						var text_4 = $.only_child(span_1, true);
						$.reset(button_1);
						$.template_effect(() => {
							$.set_attribute(button_1, "data-cycle", $.get(one).id);
							$.set_attribute(button_1, "aria-pressed", $.get(one).id === $.get(form).id);
							classes_1 = $.set_class(button_1, 1, "s-1gnh3x7", null, classes_1, {
								chosen: $.get(one).id === $.get(form).id,
								elsewhere: $.get(one).group !== $.get(form).group
							});
							$.set_text(text_3, $.get(one).id);
							$.set_text(text_4, $.get(one).title);
						});
						$.delegated("click", button_1, () => $.get(one).id !== $.get(form).id && pick($.get(one).id));
						$.append($$anchor, button_1);
					});
					$.template_effect(() => $.set_text(text_2, $.get(group)[0]?.group_title));
					$.append($$anchor, fragment_3);
				});
				$.reset(nav);
				var node_3 = $.sibling(nav, 2);
				$.key(node_3, () => $.get(form).id, ($$anchor) => {
					var div_3 = root_11();
					var header = $.child(div_3);
					var h2 = $.child(header);
					var text_5 = $.child(h2, true);
					var node_4 = $.sibling(text_5);
					var consequent_1 = ($$anchor) => {
						var small = root_3();
						var text_6 = $.only_child(small, true);
						$.template_effect(($0) => $.set_text(text_6, $0), [() => t("cycles.opened", {
							program: $.get(opened).program,
							from: $.get(opened).from,
							to: $.get(opened).from + $.get(opened).lines.length - 1
						})]);
						$.append($$anchor, small);
					};
					$.if(node_4, ($$render) => {
						if ($.get(opened)) $$render(consequent_1);
					});
					$.reset(h2);
					var node_5 = $.sibling(h2, 2);
					var consequent_2 = ($$anchor) => {
						{
							let $0 = $.derived(() => t("cycles.as_new"));
							let $1 = $.derived(() => t("cycles.as_new"));
							Button($$anchor, {
								kind: "quiet",
								icon: "close",
								get "aria-label"() {
									return $.get($0);
								},
								get title() {
									return $.get($1);
								},
								onclick: () => editing.open(null),
								"data-testid": "as-new"
							});
						}
					};
					$.if(node_5, ($$render) => {
						if ($.get(opened)) $$render(consequent_2);
					});
					var node_6 = $.sibling(node_5, 2);
					Button(node_6, {
						kind: "quiet",
						icon: "reset",
						onclick: () => forms.clear($.get(form)),
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text_7 = $.text();
							$.template_effect(($0) => $.set_text(text_7, $0), [() => t("cycles.clear")]);
							$.append($$anchor, text_7);
						},
						$$slots: { default: true }
					});
					$.reset(header);
					var node_7 = $.sibling(header, 2);
					$.each(node_7, 17, () => $.get(general), (finding) => finding.id + finding.text, ($$anchor, finding) => {
						var p = root_4();
						var text_8 = $.child(p);
						var small_1 = $.sibling(text_8);
						var text_9 = $.only_child(small_1, true);
						var span_2 = $.sibling(small_1, 2);
						var text_10 = $.only_child(span_2, true);
						$.reset(p);
						$.template_effect(() => {
							$.set_class(p, 1, `general ${$.get(finding).severity ?? ""}`, "s-1gnh3x7");
							$.set_text(text_8, `${$.get(finding).text ?? ""} `);
							$.set_text(text_9, $.get(finding).id);
							$.set_text(text_10, $.get(finding).help);
						});
						$.append($$anchor, p);
					});
					var node_8 = $.sibling(node_7, 2);
					var consequent_3 = ($$anchor) => {
						{
							let $0 = $.derived(() => t("cycles.profile"));
							Card($$anchor, {
								get title() {
									return $.get($0);
								},
								children: ($$anchor, $$slotProps) => {
									{
										let $0 = $.derived(() => $.get(form).profile === "depths" ? "contours" : $.get(form).profile);
										let $1 = $.derived(() => t("cycles.profile"));
										let $2 = $.derived(() => nameOf("profile"));
										ProfileEditor($$anchor, {
											get contours() {
												return $.get(filled).contours;
											},
											get use() {
												return $.get($0);
											},
											get label() {
												return $.get($1);
											},
											get name() {
												return $.get($2);
											},
											get findings() {
												return $.get(findings);
											},
											here,
											onload: (contours, name) => {
												$.get(filled).contours = contours;
												if (name && $.get(form).profile !== "points") $.get(filled).values.profile = name;
											}
										});
									}
								},
								$$slots: { default: true }
							});
						}
					};
					$.if(node_8, ($$render) => {
						if ($.get(form).profile !== "none") $$render(consequent_3);
					});
					var node_9 = $.sibling(node_8, 2);
					$.each(node_9, 17, () => $.get(form).stages, (stage) => stage.value, ($$anchor, stage) => {
						const fields = $.derived(() => $.get(form).parameters.filter((field) => field.stage === $.get(stage).value));
						var fragment_8 = $.comment();
						var node_10 = $.first_child(fragment_8);
						var consequent_6 = ($$anchor) => {
							{
								let $0 = $.derived(() => $.get(form).stages.length > 1 ? $.get(stage).title : "");
								Card($$anchor, {
									get title() {
										return $.get($0);
									},
									children: ($$anchor, $$slotProps) => {
										var fragment_10 = root_6();
										var node_11 = $.first_child(fragment_10);
										$.each(node_11, 16, () => [
											"place",
											"shape",
											"planes",
											"cutting",
											"tool"
										], (group) => group, ($$anchor, group) => {
											const own = $.derived(() => $.get(fields).filter((field) => field.group === group && !(/^Z[1-4]$/.test(field.name) && !$.get(filled).depths[Number(field.name[1]) - 1])));
											var fragment_11 = $.comment();
											var node_12 = $.first_child(fragment_11);
											var consequent_4 = ($$anchor) => {
												var fragment_12 = root_2();
												var h3_1 = $.first_child(fragment_12);
												var text_11 = $.only_child(h3_1, true);
												var node_13 = $.sibling(h3_1, 2);
												$.each(node_13, 17, () => $.get(own), (field) => field.name, ($$anchor, field) => {
													{
														let $0 = $.derived(() => $.get(findings).filter((one) => one.parameter === $.get(field).name));
														let $1 = $.derived(() => $.get(focus) === $.get(field).name);
														let $2 = $.derived(() => teach($.get(field)));
														FieldInput($$anchor, {
															get field() {
																return $.get(field);
															},
															get value() {
																return $.get(filled).values[$.get(field).name];
															},
															get findings() {
																return $.get($0);
															},
															get focused() {
																return $.get($1);
															},
															get teach() {
																return $.get($2);
															},
															onfocus: () => $.set(focus, $.get(field).name, true),
															onvalue: (value) => put(value, $.get(field))
														});
													}
												});
												$.template_effect(($0) => $.set_text(text_11, $0), [() => t(`cycles.group_${group}`)]);
												$.append($$anchor, fragment_12);
											};
											$.if(node_12, ($$render) => {
												if ($.get(own).length) $$render(consequent_4);
											});
											$.append($$anchor, fragment_11);
										});
										var node_14 = $.sibling(node_11, 2);
										var consequent_5 = ($$anchor) => {
											var fragment_14 = root_6();
											var node_15 = $.first_child(fragment_14);
											$.each(node_15, 17, () => $.get(filled).depths, $.index, ($$anchor, depth, i) => {
												var fragment_15 = root_5();
												var div_4 = $.first_child(fragment_15);
												var h3_2 = $.child(div_4);
												h3_2.textContent = `P.Z${i + 1}`;
												var node_16 = $.sibling(h3_2, 2);
												{
													let $0 = $.derived(() => t("cycles.depth_plane"));
													Segmented(node_16, {
														get value() {
															return $.get(depth).plane;
														},
														get label() {
															return $.get($0);
														},
														onchange: (plane) => turn($.get(depth), plane, i),
														options: [{
															value: "XZ",
															label: "XZ"
														}, {
															value: "YZ",
															label: "YZ"
														}]
													});
												}
												var node_17 = $.sibling(node_16, 2);
												{
													let $0 = $.derived(() => t("cycles.delete"));
													Button(node_17, {
														kind: "quiet",
														icon: "trash",
														get "aria-label"() {
															return $.get($0);
														},
														onclick: () => $.get(filled).depths.splice(i, 1)
													});
												}
												$.reset(div_4);
												var node_18 = $.sibling(div_4, 2);
												{
													let $0 = $.derived(() => [$.get(depth).contour]);
													let $1 = $.derived(() => [$.get(depth).plane[0], "Z"]);
													let $2 = $.derived(() => nameOf(`Z${i + 1}`) || `DEPTH${i + 1}`);
													ProfileEditor(node_18, {
														get contours() {
															return $.get($0);
														},
														use: "depth",
														get axes() {
															return $.get($1);
														},
														label: `P.Z${i + 1}`,
														get name() {
															return $.get($2);
														},
														findings: [],
														here,
														onload: ([contour], name) => {
															const from = $.get(depth).contour.start;
															if (contour) $.get(depth).contour = moved(contour, [from[0] - contour.start[0], from[1] - contour.start[1]]);
															if (name) $.get(filled).values[`Z${i + 1}`] = name;
														}
													});
												}
												$.append($$anchor, fragment_15);
											});
											var node_19 = $.sibling(node_15, 2);
											{
												let $0 = $.derived(() => $.get(filled).depths.length >= Math.min(4, $.get(filled).contours.length));
												Button(node_19, {
													icon: "plus",
													get disabled() {
														return $.get($0);
													},
													onclick: () => {
														const start = $.get(filled).contours[$.get(filled).depths.length]?.start ?? [0, 0];
														$.get(filled).depths.push({
															plane: "XZ",
															contour: {
																start: [start[0], 0],
																elements: [{
																	kind: "line",
																	to: [start[0] + 5, -10]
																}]
															}
														});
													},
													children: ($$anchor, $$slotProps) => {
														$.next();
														var text_12 = $.text();
														$.template_effect(($0) => $.set_text(text_12, $0), [() => t("cycles.add_depth")]);
														$.append($$anchor, text_12);
													},
													$$slots: { default: true }
												});
											}
											$.append($$anchor, fragment_14);
										};
										$.if(node_14, ($$render) => {
											if ($.get(stage).value === "cycle" && $.get(form).profile === "depths") $$render(consequent_5);
										});
										$.append($$anchor, fragment_10);
									},
									$$slots: { default: true }
								});
							}
						};
						$.if(node_10, ($$render) => {
							if ($.get(fields).length) $$render(consequent_6);
						});
						$.append($$anchor, fragment_8);
					});
					var node_20 = $.sibling(node_9, 2);
					var consequent_7 = ($$anchor) => {
						{
							let $0 = $.derived(() => t("cycles.positions"));
							Card($$anchor, {
								get title() {
									return $.get($0);
								},
								children: ($$anchor, $$slotProps) => {
									PositionsEditor($$anchor, {
										get form() {
											return $.get(form);
										},
										get filled() {
											return $.get(filled);
										},
										get findings() {
											return $.get(findings);
										},
										here,
										get focus() {
											return $.get(focus);
										},
										set focus($$value) {
											$.set(focus, $$value, true);
										}
									});
								},
								$$slots: { default: true }
							});
						}
					};
					$.if(node_20, ($$render) => {
						if ($.get(form).positions.length) $$render(consequent_7);
					});
					var node_21 = $.sibling(node_20, 2);
					var consequent_8 = ($$anchor) => {
						{
							let $0 = $.derived(() => t("cycles.tools"));
							Card($$anchor, {
								get title() {
									return $.get($0);
								},
								children: ($$anchor, $$slotProps) => {
									var fragment_20 = root_8();
									var node_22 = $.first_child(fragment_20);
									$.each(node_22, 16, () => $.get(called), (number) => number, ($$anchor, number) => {
										const tool = $.derived(() => forms.tool(number));
										var div_5 = root_7();
										var b = $.child(div_5);
										var text_13 = $.only_child(b);
										var label = $.sibling(b, 2);
										var span_3 = $.child(label);
										var text_14 = $.only_child(span_3, true);
										var node_23 = $.sibling(span_3);
										{
											let $0 = $.derived(() => t("cycles.diameter"));
											NumberField(node_23, {
												get label() {
													return $.get($0);
												},
												get value() {
													return $.get(tool).diameter;
												},
												minimum: 0,
												maximum: 1e3,
												empty: true,
												onvalue: (value) => forms.setTool(number, { diameter: value })
											});
										}
										$.reset(label);
										var label_1 = $.sibling(label, 2);
										var span_4 = $.child(label_1);
										var text_15 = $.only_child(span_4, true);
										var node_24 = $.sibling(span_4);
										{
											let $0 = $.derived(() => t("cycles.cutting_length"));
											let $1 = $.derived(() => $.get(tool).cutting_length ?? null);
											NumberField(node_24, {
												get label() {
													return $.get($0);
												},
												get value() {
													return $.get($1);
												},
												minimum: 0,
												maximum: 1e3,
												empty: true,
												onvalue: (value) => forms.setTool(number, { cutting_length: value })
											});
										}
										$.reset(label_1);
										var node_25 = $.sibling(label_1, 2);
										{
											let $0 = $.derived(() => t("cycles.as_table"));
											let $1 = $.derived(() => t("cycles.as_table"));
											let $2 = $.derived(() => !forms.ownTool(number));
											Button(node_25, {
												kind: "quiet",
												icon: "undo",
												get "aria-label"() {
													return $.get($0);
												},
												get title() {
													return $.get($1);
												},
												get disabled() {
													return $.get($2);
												},
												onclick: () => forms.dropTool(number)
											});
										}
										var label_2 = $.sibling(node_25, 2);
										var span_5 = $.child(label_2);
										var text_16 = $.only_child(span_5, true);
										var node_26 = $.sibling(span_5);
										{
											let $0 = $.derived(() => t("cycles.entry_angle"));
											let $1 = $.derived(() => $.get(tool).entry_angle ?? null);
											NumberField(node_26, {
												get label() {
													return $.get($0);
												},
												get value() {
													return $.get($1);
												},
												minimum: 0,
												maximum: 90,
												empty: true,
												onvalue: (value) => forms.setTool(number, { entry_angle: value })
											});
										}
										$.reset(label_2);
										var label_3 = $.sibling(label_2, 2);
										var span_6 = $.child(label_3);
										var text_17 = $.only_child(span_6, true);
										var node_27 = $.sibling(span_6);
										{
											let $0 = $.derived(() => t("cycles.tip_radius"));
											let $1 = $.derived(() => $.get(tool).tip_radius ?? null);
											NumberField(node_27, {
												get label() {
													return $.get($0);
												},
												get value() {
													return $.get($1);
												},
												minimum: 0,
												maximum: 1e3,
												empty: true,
												onvalue: (value) => forms.setTool(number, { tip_radius: value })
											});
										}
										$.reset(label_3);
										$.reset(div_5);
										$.template_effect(($0, $1, $2, $3) => {
											$.set_attribute(div_5, "data-tool", number);
											$.set_text(text_13, `T${number ?? ""}`);
											$.set_text(text_14, $0);
											$.set_text(text_15, $1);
											$.set_text(text_16, $2);
											$.set_text(text_17, $3);
										}, [
											() => t("cycles.diameter"),
											() => t("cycles.cutting_length"),
											() => t("cycles.entry_angle"),
											() => t("cycles.tip_radius")
										]);
										$.append($$anchor, div_5);
									});
									var p_1 = $.sibling(node_22, 2);
									var text_18 = $.only_child(p_1, true);
									$.template_effect(($0) => $.set_text(text_18, $0), [() => t("cycles.tools_hint")]);
									$.append($$anchor, fragment_20);
								},
								$$slots: { default: true }
							});
						}
					};
					$.if(node_21, ($$render) => {
						if ($.get(called).length) $$render(consequent_8);
					});
					var node_28 = $.sibling(node_21, 2);
					var consequent_9 = ($$anchor) => {
						const computed_const = $.derived(() => {
							return machine.status;
						});
						var p_2 = root_10();
						var node_29 = $.child(p_2);
						$.each(node_29, 16, () => machine.axes, (axis) => axis, ($$anchor, axis) => {
							var span_7 = root_9();
							var small_2 = $.child(span_7);
							var text_19 = $.only_child(small_2, true);
							var text_20 = $.sibling(small_2, 1, true);
							$.reset(span_7);
							$.template_effect(($0) => {
								$.set_text(text_19, axis);
								$.set_text(text_20, $0);
							}, [() => fixed($.get(computed_const).position.work[axis])]);
							$.append($$anchor, span_7);
						});
						var span_8 = $.sibling(node_29, 2);
						var text_21 = $.sibling($.child(span_8), 1, true);
						$.reset(span_8);
						var span_9 = $.sibling(span_8, 2);
						var text_22 = $.sibling($.child(span_9), 1, true);
						$.reset(span_9);
						var span_10 = $.sibling(span_9, 2);
						var text_23 = $.sibling($.child(span_10), 1, true);
						$.reset(span_10);
						$.reset(p_2);
						$.template_effect(($0, $1, $2, $3) => {
							$.set_attribute(p_2, "aria-label", $0);
							$.set_attribute(p_2, "title", $1);
							$.set_text(text_21, $2);
							$.set_text(text_22, $3);
							$.set_text(text_23, $.get(computed_const).spindle.tool);
						}, [
							() => t("cycles.stands"),
							() => t("cycles.stands"),
							() => fixed($.get(computed_const).feed.actual, 0),
							() => fixed(Math.abs($.get(computed_const).spindle.actual), 0)
						]);
						$.append($$anchor, p_2);
					};
					$.if(node_28, ($$render) => {
						if (machine.status) $$render(consequent_9);
					});
					$.reset(div_3);
					$.bind_this(div_3, ($$value) => $.set(shape, $$value), () => $.get(shape));
					$.template_effect(() => {
						$.set_attribute(div_3, "data-cycle", $.get(form).id);
						$.set_text(text_5, $.get(form).title);
					});
					$.append($$anchor, div_3);
				});
				var div_6 = $.sibling(node_3, 2);
				var div_7 = $.child(div_6);
				var node_30 = $.child(div_7);
				{
					let $0 = $.derived(() => t("cycles.show"));
					let $1 = $.derived(() => [
						{
							value: "drawing",
							label: t("cycles.drawing")
						},
						{
							value: "simulation",
							label: t("cycles.simulation")
						},
						{
							value: "text",
							label: t("cycles.text")
						}
					]);
					Segmented(node_30, {
						get label() {
							return $.get($0);
						},
						onchange: (value) => value === "simulation" && void simulate(),
						get options() {
							return $.get($1);
						},
						get value() {
							return $.get(side);
						},
						set value($$value) {
							$.set(side, $$value, true);
						}
					});
				}
				$.reset(div_7);
				var div_8 = $.sibling(div_7, 2);
				var node_31 = $.child(div_8);
				var consequent_10 = ($$anchor) => {
					var fragment_21 = root_12();
					var div_9 = $.first_child(fragment_21);
					var node_32 = $.child(div_9);
					{
						let $0 = $.derived(() => t("cycles.plan"));
						Drawing(node_32, {
							get items() {
								return $.get(picture).plan;
							},
							get values() {
								return $.get(picture).values;
							},
							get fields() {
								return $.get(picture).fields;
							},
							get focus() {
								return $.get(focus);
							},
							get label() {
								return $.get($0);
							},
							onfield: go
						});
					}
					$.reset(div_9);
					var div_10 = $.sibling(div_9, 2);
					var node_33 = $.child(div_10);
					{
						let $0 = $.derived(() => t("cycles.section"));
						Drawing(node_33, {
							get items() {
								return $.get(picture).section;
							},
							get values() {
								return $.get(picture).values;
							},
							get fields() {
								return $.get(picture).fields;
							},
							get focus() {
								return $.get(focus);
							},
							get label() {
								return $.get($0);
							},
							onfield: go
						});
					}
					$.reset(div_10);
					$.append($$anchor, fragment_21);
				};
				var consequent_11 = ($$anchor) => {
					{
						let $0 = $.derived(() => $.get(path) !== null && $.get(simulated) !== $.get(basis));
						Simulation($$anchor, {
							get path() {
								return $.get(path);
							},
							get busy() {
								return $.get(busy);
							},
							get stale() {
								return $.get($0);
							}
						});
					}
				};
				var alternate = ($$anchor) => {
					var pre = root_13();
					let classes_2;
					var text_24 = $.only_child(pre, true);
					$.template_effect(($0) => {
						classes_2 = $.set_class(pre, 1, "code scroll s-1gnh3x7", null, classes_2, { stale: !$.get(isCurrent) });
						$.set_attribute(pre, "data-expanded", $.get(written)?.expanded ?? false);
						$.set_text(text_24, $0);
					}, [() => $.get(written)?.text || t("cycles.no_text")]);
					$.append($$anchor, pre);
				};
				$.if(node_31, ($$render) => {
					if ($.get(side) === "drawing") $$render(consequent_10);
					else if ($.get(side) === "simulation") $$render(consequent_11, 1);
					else $$render(alternate, -1);
				});
				$.reset(div_8);
				var p_3 = $.sibling(div_8, 2);
				let classes_3;
				var node_34 = $.child(p_3);
				var consequent_12 = ($$anchor) => {
					Button($$anchor, {
						icon: "alarms",
						onclick: toError,
						"data-testid": "to-error",
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text_25 = $.text();
							$.template_effect(($0) => $.set_text(text_25, $0), [() => t("cycles.errors", { count: $.get(errors).length })]);
							$.append($$anchor, text_25);
						},
						$$slots: { default: true }
					});
				};
				var consequent_13 = ($$anchor) => {
					var text_26 = $.text();
					$.template_effect(($0, $1) => $.set_text(text_26, `${$0 ?? ""} · ${$1 ?? ""}`), [() => $.get(written).expanded ? t("cycles.expanded", { dialect: $.get(dialect) }) : t("cycles.as_cycle", { dialect: $.get(dialect) }), () => t("cycles.lines", { count: $.get(ready).trimEnd().split("\n").length })]);
					$.append($$anchor, text_26);
				};
				var consequent_14 = ($$anchor) => {
					var text_27 = $.text();
					$.template_effect(($0) => $.set_text(text_27, $0), [() => t("cycles.no_text")]);
					$.append($$anchor, text_27);
				};
				var alternate_1 = ($$anchor) => {
					var text_28 = $.text();
					$.template_effect(($0) => $.set_text(text_28, $0), [() => t($.get(refusedOf) === $.get(wish) ? "cycles.not_written" : "cycles.writing")]);
					$.append($$anchor, text_28);
				};
				$.if(node_34, ($$render) => {
					if ($.get(errors).length) $$render(consequent_12);
					else if ($.get(ready) && $.get(written)) $$render(consequent_13, 1);
					else if ($.get(isCurrent)) $$render(consequent_14, 2);
					else $$render(alternate_1, -1);
				});
				$.reset(p_3);
				var div_11 = $.sibling(p_3, 2);
				var node_35 = $.child(div_11);
				{
					let $0 = $.derived(() => t("cycles.simulate"));
					let $1 = $.derived(() => t("cycles.simulate"));
					let $2 = $.derived(() => $.get(errors).length > 0);
					Button(node_35, {
						icon: "play",
						"data-testid": "simulate",
						get "aria-label"() {
							return $.get($0);
						},
						get title() {
							return $.get($1);
						},
						onclick: simulate,
						get disabled() {
							return $.get($2);
						},
						children: ($$anchor, $$slotProps) => {
							var span_11 = root_14();
							var text_29 = $.only_child(span_11, true);
							$.template_effect(($0) => $.set_text(text_29, $0), [() => t("cycles.simulate")]);
							$.append($$anchor, span_11);
						},
						$$slots: { default: true }
					});
				}
				var node_36 = $.sibling(node_35, 2);
				{
					let $0 = $.derived(() => t("cycles.copy"));
					let $1 = $.derived(() => t("cycles.copy"));
					let $2 = $.derived(() => !$.get(ready));
					Button(node_36, {
						icon: "list",
						get "aria-label"() {
							return $.get($0);
						},
						get title() {
							return $.get($1);
						},
						onclick: copy,
						get disabled() {
							return $.get($2);
						},
						children: ($$anchor, $$slotProps) => {
							var span_12 = root_14();
							var text_30 = $.only_child(span_12, true);
							$.template_effect(($0) => $.set_text(text_30, $0), [() => t("cycles.copy")]);
							$.append($$anchor, span_12);
						},
						$$slots: { default: true }
					});
				}
				var node_37 = $.sibling(node_36, 2);
				{
					let $0 = $.derived(() => !$.get(ready));
					Button(node_37, {
						kind: "primary",
						icon: "plus",
						get disabled() {
							return $.get($0);
						},
						onclick: () => $.get(ready) && insert($.get(ready)),
						"data-testid": "insert",
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text_31 = $.text();
							$.template_effect(($0) => $.set_text(text_31, $0), [() => t($.get(opened) ? "cycles.replace" : "cycles.insert")]);
							$.append($$anchor, text_31);
						},
						$$slots: { default: true }
					});
				}
				$.reset(div_11);
				$.reset(div_6);
				$.reset(div_1);
				$.reset(div);
				$.template_effect(($0, $1) => {
					$.set_attribute(nav, "aria-label", $0);
					$.set_attribute(div_2, "aria-label", $1);
					classes_3 = $.set_class(p_3, 1, "state s-1gnh3x7", null, classes_3, { wrong: $.get(errors).length > 0 });
					$.set_attribute(p_3, "data-ready", !!$.get(ready));
				}, [() => t("cycles.title"), () => t("cycles.title")]);
				$.append($$anchor, div);
			};
			$.if(node, ($$render) => {
				if ($.get(failed)) $$render(consequent);
				else if ($.get(form) && $.get(filled) && $.get(picture)) $$render(consequent_15, 1);
			});
			$.append($$anchor, fragment_1);
		},
		$$slots: { default: true }
	});
	$.pop();
}
$.delegate(["click"]);
export { Cycles as default };
