import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/parts/VirtualList.svelte
var root = $.from_html(`<div class="item s-1png07a" role="listitem"><!></div>`);
var root_1 = $.from_html(`<div class="list scroll s-1png07a" role="list"><div class="all s-1png07a"></div></div>`);
function VirtualList($$anchor, $$props) {
	$.push($$props, true);
	/** rem of a row. */
	let box = $.state(void 0);
	let top = $.state(0);
	let room = $.state(600);
	let rem = $.state(16);
	$.user_effect(() => {
		if (!$.get(box)) return;
		const sized = new ResizeObserver(() => {
			$.set(rem, parseFloat(getComputedStyle(document.documentElement).fontSize), true);
			$.set(room, $.get(box).clientHeight, true);
		});
		sized.observe($.get(box));
		return () => sized.disconnect();
	});
	const size = $.derived(() => Math.max(44, $$props.height * $.get(rem)));
	const first = $.derived(() => Math.max(0, Math.floor($.get(top) / $.get(size)) - 5));
	const shown = $.derived(() => $$props.items.slice($.get(first), $.get(first) + Math.ceil($.get(room) / $.get(size)) + 10));
	var div = root_1();
	var div_1 = $.child(div);
	let styles;
	$.each(div_1, 23, () => $.get(shown), (item, index) => $.get(first) + index, ($$anchor, item, index) => {
		var div_2 = root();
		let styles_1;
		var node = $.child(div_2);
		$.snippet(node, () => $$props.row, () => $.get(item), () => $.get(first) + $.get(index));
		$.reset(div_2);
		$.template_effect(() => styles_1 = $.set_style(div_2, "", styles_1, {
			top: `${($.get(first) + $.get(index)) * $.get(size)}px`,
			height: `${$.get(size)}px`
		}));
		$.append($$anchor, div_2);
	});
	$.reset(div_1);
	$.reset(div);
	$.bind_this(div, ($$value) => $.set(box, $$value), () => $.get(box));
	$.template_effect(() => {
		$.set_attribute(div, "aria-label", $$props.label);
		styles = $.set_style(div_1, "", styles, { height: `${$$props.items.length * $.get(size)}px` });
	});
	$.event("scroll", div, (event) => $.set(top, event.currentTarget.scrollTop, true));
	$.append($$anchor, div);
	$.pop();
}
export { VirtualList as default };
