// src/locales/zh/welcome.json
var welcome_default = {
	"title": "欢迎",
	"machine": "{machine}，语言 {dialect}",
	"command": "同一时间只有一个屏幕可以控制，其余的观察。用顶部的按钮移交。",
	"stop": "复位和急停在任何屏幕上随时有效。",
	"keys": "机床按键在按住期间有效。按 ? 查看键盘快捷键。",
	"watch": "仅观察",
	"start": "取得控制"
};
export { welcome_default as default };
