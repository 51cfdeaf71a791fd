import Icon from "../parts/Icon.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/editor/Findings.svelte
var MOST = 200;
var root = $.from_html(`<li><button type="button"><!><span class="number"> </span><span class="code muted"> </span><span> </span></button></li>`);
var root_1 = $.from_html(`<ul class="findings scroll s-1l9l1zb" data-testid="findings"></ul>`);
function Findings($$anchor, $$props) {
	$.push($$props, true);
	var fragment = $.comment();
	var node = $.first_child(fragment);
	var consequent = ($$anchor) => {
		var ul = root_1();
		$.each(ul, 21, () => $$props.findings.slice(0, MOST), $.index, ($$anchor, $$item) => {
			let line = () => $.get($$item).line;
			let column = () => $.get($$item).column;
			let id = () => $.get($$item).id;
			let text = () => $.get($$item).text;
			let severity = () => $.get($$item).severity;
			var li = root();
			var button = $.child(li);
			var node_1 = $.child(button);
			Icon(node_1, { name: "alarms" });
			var span = $.sibling(node_1);
			var text_1 = $.only_child(span, true);
			var span_1 = $.sibling(span);
			var text_2 = $.only_child(span_1, true);
			var span_2 = $.sibling(span_1);
			var text_3 = $.only_child(span_2, true);
			$.reset(button);
			$.reset(li);
			$.template_effect(() => {
				$.set_class(button, 1, $.clsx(severity()), "s-1l9l1zb");
				$.set_text(text_1, column() === void 0 ? line() : `${line()}:${column()}`);
				$.set_text(text_2, id());
				$.set_text(text_3, text());
			});
			$.delegated("click", button, () => $$props.onshow(line()));
			$.append($$anchor, li);
		});
		$.reset(ul);
		$.append($$anchor, ul);
	};
	$.if(node, ($$render) => {
		if ($$props.findings.length) $$render(consequent);
	});
	$.append($$anchor, fragment);
	$.pop();
}
$.delegate(["click"]);
export { Findings as default };
