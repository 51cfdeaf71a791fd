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
import { editing } from "../../lib/state/editing.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { notify } from "../../lib/state/notices.svelte.js";
import { untrack } from "svelte";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/cycles/Cycles.svelte
var root = $.from_html(`<button type="button" role="tab"> </button>`);
var root_1 = $.from_html(`<button type="button"><span class="code s-1xabzjz"> </span><span> </span></button>`);
var root_2 = $.from_html(`<h3 class="s-1xabzjz"> </h3> <!>`, 1);
var root_3 = $.from_html(`<small class="opened s-1xabzjz"> </small>`);
var root_4 = $.from_html(`<p role="alert"> <small class="code s-1xabzjz"> </small><br/><span class="muted"> </span></p>`);
var root_5 = $.from_html(`<div class="row wrap"><h3 class="code grow s-1xabzjz"></h3> <!> <!></div> <!>`, 1);
var root_6 = $.from_html(`<!> <!>`, 1);
var root_7 = $.from_html(`<div class="tools s-1xabzjz"><b class="code"> </b> <label class="s-1xabzjz"><span class="muted"> </span><!></label> <label class="s-1xabzjz"><span class="muted"> </span><!></label> <label class="s-1xabzjz"><span class="muted"> </span><!></label></div>`);
var root_8 = $.from_html(`<span><small class="s-1xabzjz"> </small> </span>`);
var root_9 = $.from_html(`<p class="stands number s-1xabzjz" data-testid="stands"><!> <span><small class="s-1xabzjz">F</small> </span> <span><small class="s-1xabzjz">S</small> </span> <span><small class="s-1xabzjz">T</small> </span></p>`);
var root_10 = $.from_html(`<div class="form scroll s-1xabzjz"><header class="row wrap"><h2 class="grow"> <!></h2> <!> <!></header> <!> <!> <!> <!> <!> <!></div>`);
var root_11 = $.from_html(`<div class="plan s-1xabzjz"><!></div> <div class="section s-1xabzjz"><!></div>`, 1);
var root_12 = $.from_html(`<pre> </pre>`);
var root_13 = $.from_html(`<span class="spoken s-1xabzjz"> </span>`);
var root_14 = $.from_html(`<div class="room s-1xabzjz"><div class="cycles s-1xabzjz"><nav class="list scroll s-1xabzjz" data-pans=""><div class="groups s-1xabzjz" role="tablist"></div> <!></nav> <!> <div class="side s-1xabzjz"><div class="row wrap"><!></div> <div class="shown s-1xabzjz"><!></div> <p aria-live="polite"><!></p> <div class="row wrap"><!> <!> <!></div></div></div></div>`);
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
	const picture = $.derived(() => $.get(form) && $.get(filled) && $.get(asked) ? {
		...scene($.get(form), $.get(asked)),
		...drawn($.get(form), $.get(filled))
	} : null);
	const findings = $.derived(() => $.get(written)?.findings ?? []);
	const errors = $.derived(() => $.get(findings).filter((one) => one.severity === "error"));
	const general = $.derived(() => $.get(findings).filter((one) => !shown(one)));
	const dialect = $.derived(() => machine.dialect);
	const groups = $.derived(() => [...new Set($.get(all).map((one) => one.group))].map((group) => $.get(all).filter((one) => one.group === group)));
	const body = $.derived(() => $.get(asked) ? JSON.stringify($.get(asked)) : "");
	/** All that the text depends on. */
	const wish = $.derived(() => JSON.stringify([
		$.get(body),
		$.get(dialect),
		language()
	]));
	/** Whether the text is that of what stands in the form: it comes a while after each change. */
	const isCurrent = $.derived(() => $.get(written) !== null && $.get(writtenOf) === $.get(wish));
	const ready = $.derived(() => $.get(isCurrent) && $.get(written)?.text && $.get(errors).length === 0 ? $.get(written).text : "");
	const called = $.derived(() => $.get(asked) ? toolsOf($.get(asked).values) : []);
	/** Whether a finding stands at its field. */
	function shown(finding) {
		const name = finding.parameter;
		if (name.startsWith("positions")) return ($.get(form)?.positions.length ?? 0) > 0;
		if (name === "profile" && $.get(form)?.profile !== "none") return true;
		return $.get(form)?.parameters.some((field) => field.name === name) ?? false;
	}
	$.user_effect(() => {
		const unknown = $.get(called).filter((number) => !forms.knows(number));
		if (unknown.length === 0 || machine.link !== "open") return;
		const [from, to] = [Math.min(...unknown), Math.max(...unknown)];
		if (to - from > 200) return;
		machine.fetch("offsets", {
			do: "offsets",
			from,
			to
		}).then((reply) => {
			for (const number of unknown) {
				const radius = reply?.offsets[number]?.radius ?? 0;
				forms.setTool({
					...forms.tool(number),
					diameter: radius > 0 ? 2 * radius : forms.tool(number).diameter
				});
			}
		});
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
		const text = $.get(body);
		if (!text || text === $.get(simulated) && $.get(path)) return;
		$.set(busy, true);
		try {
			$.set(path, readPath(await client.path(JSON.parse(text))));
			$.set(simulated, text);
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
				var div = root_14();
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
						classes = $.set_class(button, 1, "s-1xabzjz", null, classes, { chosen: $.get(open) });
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
							classes_1 = $.set_class(button_1, 1, "s-1xabzjz", null, classes_1, {
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
					var div_3 = root_10();
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
							$.set_class(p, 1, `general ${$.get(finding).severity ?? ""}`, "s-1xabzjz");
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
									var fragment_20 = $.comment();
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
												onvalue: (value) => forms.setTool({
													...$.get(tool),
													diameter: value ?? 0
												})
											});
										}
										$.reset(label);
										var label_1 = $.sibling(label, 2);
										var span_4 = $.child(label_1);
										var text_15 = $.only_child(span_4, true);
										var node_24 = $.sibling(span_4);
										{
											let $0 = $.derived(() => t("cycles.cutting_length"));
											NumberField(node_24, {
												get label() {
													return $.get($0);
												},
												get value() {
													return $.get(tool).cutting_length;
												},
												minimum: 0,
												maximum: 1e3,
												onvalue: (value) => forms.setTool({
													...$.get(tool),
													cutting_length: value ?? 0
												})
											});
										}
										$.reset(label_1);
										var label_2 = $.sibling(label_1, 2);
										var span_5 = $.child(label_2);
										var text_16 = $.only_child(span_5, true);
										var node_25 = $.sibling(span_5);
										{
											let $0 = $.derived(() => t("cycles.entry_angle"));
											NumberField(node_25, {
												get label() {
													return $.get($0);
												},
												get value() {
													return $.get(tool).entry_angle;
												},
												minimum: 0,
												maximum: 90,
												onvalue: (value) => forms.setTool({
													...$.get(tool),
													entry_angle: value ?? 0
												})
											});
										}
										$.reset(label_2);
										$.reset(div_5);
										$.template_effect(($0, $1, $2) => {
											$.set_text(text_13, `T${number ?? ""}`);
											$.set_text(text_14, $0);
											$.set_text(text_15, $1);
											$.set_text(text_16, $2);
										}, [
											() => t("cycles.diameter"),
											() => t("cycles.cutting_length"),
											() => t("cycles.entry_angle")
										]);
										$.append($$anchor, div_5);
									});
									$.append($$anchor, fragment_20);
								},
								$$slots: { default: true }
							});
						}
					};
					$.if(node_21, ($$render) => {
						if ($.get(called).length) $$render(consequent_8);
					});
					var node_26 = $.sibling(node_21, 2);
					var consequent_9 = ($$anchor) => {
						const computed_const = $.derived(() => {
							return machine.status;
						});
						var p_1 = root_9();
						var node_27 = $.child(p_1);
						$.each(node_27, 16, () => machine.axes, (axis) => axis, ($$anchor, axis) => {
							var span_6 = root_8();
							var small_2 = $.child(span_6);
							var text_17 = $.only_child(small_2, true);
							var text_18 = $.sibling(small_2, 1, true);
							$.reset(span_6);
							$.template_effect(($0) => {
								$.set_text(text_17, axis);
								$.set_text(text_18, $0);
							}, [() => fixed($.get(computed_const).position.work[axis])]);
							$.append($$anchor, span_6);
						});
						var span_7 = $.sibling(node_27, 2);
						var text_19 = $.sibling($.child(span_7), 1, true);
						$.reset(span_7);
						var span_8 = $.sibling(span_7, 2);
						var text_20 = $.sibling($.child(span_8), 1, true);
						$.reset(span_8);
						var span_9 = $.sibling(span_8, 2);
						var text_21 = $.sibling($.child(span_9), 1, true);
						$.reset(span_9);
						$.reset(p_1);
						$.template_effect(($0, $1, $2, $3) => {
							$.set_attribute(p_1, "aria-label", $0);
							$.set_attribute(p_1, "title", $1);
							$.set_text(text_19, $2);
							$.set_text(text_20, $3);
							$.set_text(text_21, $.get(computed_const).spindle.tool);
						}, [
							() => t("cycles.stands"),
							() => t("cycles.stands"),
							() => fixed($.get(computed_const).feed.actual, 0),
							() => fixed(Math.abs($.get(computed_const).spindle.actual), 0)
						]);
						$.append($$anchor, p_1);
					};
					$.if(node_26, ($$render) => {
						if (machine.status) $$render(consequent_9);
					});
					$.reset(div_3);
					$.template_effect(() => {
						$.set_attribute(div_3, "data-cycle", $.get(form).id);
						$.set_text(text_5, $.get(form).title);
					});
					$.append($$anchor, div_3);
				});
				var div_6 = $.sibling(node_3, 2);
				var div_7 = $.child(div_6);
				var node_28 = $.child(div_7);
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
					Segmented(node_28, {
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
				var node_29 = $.child(div_8);
				var consequent_10 = ($$anchor) => {
					var fragment_21 = root_11();
					var div_9 = $.first_child(fragment_21);
					var node_30 = $.child(div_9);
					{
						let $0 = $.derived(() => t("cycles.plan"));
						Drawing(node_30, {
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
					var node_31 = $.child(div_10);
					{
						let $0 = $.derived(() => t("cycles.section"));
						Drawing(node_31, {
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
						let $0 = $.derived(() => $.get(path) !== null && $.get(simulated) !== $.get(body));
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
					var pre = root_12();
					let classes_2;
					var text_22 = $.only_child(pre, true);
					$.template_effect(($0) => {
						classes_2 = $.set_class(pre, 1, "code scroll s-1xabzjz", null, classes_2, { stale: !$.get(isCurrent) });
						$.set_attribute(pre, "data-expanded", $.get(written)?.expanded ?? false);
						$.set_text(text_22, $0);
					}, [() => $.get(written)?.text || t("cycles.no_text")]);
					$.append($$anchor, pre);
				};
				$.if(node_29, ($$render) => {
					if ($.get(side) === "drawing") $$render(consequent_10);
					else if ($.get(side) === "simulation") $$render(consequent_11, 1);
					else $$render(alternate, -1);
				});
				$.reset(div_8);
				var p_2 = $.sibling(div_8, 2);
				let classes_3;
				var node_32 = $.child(p_2);
				var consequent_12 = ($$anchor) => {
					var text_23 = $.text();
					$.template_effect(($0) => $.set_text(text_23, $0), [() => t("cycles.errors", { count: $.get(errors).length })]);
					$.append($$anchor, text_23);
				};
				var consequent_13 = ($$anchor) => {
					var text_24 = $.text();
					$.template_effect(($0, $1) => $.set_text(text_24, `${$0 ?? ""} · ${$1 ?? ""}`), [() => $.get(written).expanded ? t("cycles.expanded", { dialect: $.get(dialect) }) : t("cycles.as_cycle", { dialect: $.get(dialect) }), () => t("cycles.lines", { count: $.get(ready).trimEnd().split("\n").length })]);
					$.append($$anchor, text_24);
				};
				var consequent_14 = ($$anchor) => {
					var text_25 = $.text();
					$.template_effect(($0) => $.set_text(text_25, $0), [() => t("cycles.no_text")]);
					$.append($$anchor, text_25);
				};
				var alternate_1 = ($$anchor) => {
					var text_26 = $.text();
					$.template_effect(($0) => $.set_text(text_26, $0), [() => t($.get(refusedOf) === $.get(wish) ? "cycles.not_written" : "cycles.writing")]);
					$.append($$anchor, text_26);
				};
				$.if(node_32, ($$render) => {
					if ($.get(errors).length) $$render(consequent_12);
					else if ($.get(ready) && $.get(written)) $$render(consequent_13, 1);
					else if ($.get(isCurrent)) $$render(consequent_14, 2);
					else $$render(alternate_1, -1);
				});
				$.reset(p_2);
				var div_11 = $.sibling(p_2, 2);
				var node_33 = $.child(div_11);
				{
					let $0 = $.derived(() => t("cycles.simulate"));
					let $1 = $.derived(() => t("cycles.simulate"));
					let $2 = $.derived(() => $.get(errors).length > 0);
					Button(node_33, {
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
							var span_10 = root_13();
							var text_27 = $.only_child(span_10, true);
							$.template_effect(($0) => $.set_text(text_27, $0), [() => t("cycles.simulate")]);
							$.append($$anchor, span_10);
						},
						$$slots: { default: true }
					});
				}
				var node_34 = $.sibling(node_33, 2);
				{
					let $0 = $.derived(() => t("cycles.copy"));
					let $1 = $.derived(() => t("cycles.copy"));
					let $2 = $.derived(() => !$.get(ready));
					Button(node_34, {
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
							var span_11 = root_13();
							var text_28 = $.only_child(span_11, true);
							$.template_effect(($0) => $.set_text(text_28, $0), [() => t("cycles.copy")]);
							$.append($$anchor, span_11);
						},
						$$slots: { default: true }
					});
				}
				var node_35 = $.sibling(node_34, 2);
				{
					let $0 = $.derived(() => !$.get(ready));
					Button(node_35, {
						kind: "primary",
						icon: "plus",
						get disabled() {
							return $.get($0);
						},
						onclick: () => $.get(ready) && insert($.get(ready)),
						"data-testid": "insert",
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text_29 = $.text();
							$.template_effect(($0) => $.set_text(text_29, $0), [() => t($.get(opened) ? "cycles.replace" : "cycles.insert")]);
							$.append($$anchor, text_29);
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
					classes_3 = $.set_class(p_2, 1, "state s-1xabzjz", null, classes_3, { wrong: $.get(errors).length > 0 });
					$.set_attribute(p_2, "data-ready", !!$.get(ready));
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
