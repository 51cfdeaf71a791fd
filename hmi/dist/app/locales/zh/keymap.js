// src/locales/zh/keymap.json
var keymap_default = {
	"title": "键盘",
	"jog": "按住时移动 {axes}（手动方式）",
	"wheel": "手轮（获得焦点时）",
	"save": "保存程序",
	"find": "查找和替换",
	"space": "空格",
	"complete": "补全代码",
	"held": "移动键仅在按住时有效，窗口失去焦点时停止。",
	"feed": "进给倍率，一档",
	"spindle": "主轴倍率，一档",
	"rapid": "快速倍率，一档"
};
export { keymap_default as default };
