// src/locales/zh/help.json
var help_default = {
	"title": "帮助",
	"search": "搜索",
	"codes": "代码表",
	"calculator": "计算器",
	"placeholder": "代码、参数、报警、变量、信号、地址",
	"nothing": "未找到",
	"empty": "查询",
	"empty_text": "输入代码（如 G84）、报警号、参数号或关键词。",
	"kind_code": "代码",
	"kind_parameter": "参数",
	"kind_alarm": "报警",
	"kind_variable": "变量",
	"kind_signal": "信号",
	"kind_address": "地址",
	"choose": "请在左侧选择代码。",
	"sum": "算式",
	"operations": "操作表",
	"parameters": "参数表",
	"alarms": "报警表",
	"variables": "宏变量",
	"addresses": "地址表",
	"choose_row": "请在左侧选择一行。",
	"not_here": "GSK990MC 中本机不适用的页面"
};
export { help_default as default };
