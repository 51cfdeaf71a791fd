// src/locales/zh/mode.json
var mode_default = {
	"auto": "自动方式",
	"edit": "编辑方式",
	"mdi": "MDI 方式",
	"dnc": "DNC 方式",
	"home": "机械回零方式",
	"jog": "手动方式",
	"step": "手动单步方式",
	"handle": "手轮方式",
	"short_auto": "自动",
	"short_edit": "编辑",
	"short_mdi": "MDI",
	"short_dnc": "DNC",
	"short_home": "回零",
	"short_jog": "手动",
	"short_step": "单步",
	"short_handle": "手轮"
};
export { mode_default as default };
