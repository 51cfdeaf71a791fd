// src/locales/zh/rights.json
var rights_default = {
	"title": "权限",
	"level": "{level} 级",
	"level_label": "级别",
	"level_0": "未登录",
	"level_1": "系统厂家",
	"level_2": "机床厂家",
	"level_3": "系统调试",
	"level_4": "终端用户",
	"level_5": "操作者",
	"log_in": "登录",
	"log_out": "注销",
	"logged_in": "已登录：{level}",
	"password": "密码",
	"wrong": "密码与此级别不符。",
	"too_often": "尝试次数过多，请稍候一分钟。",
	"gate": "请先登录",
	"gate_text": "从这台计算机查看和操作机床前必须先登录。"
};
export { rights_default as default };
