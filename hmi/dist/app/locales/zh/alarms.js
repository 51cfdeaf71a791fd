// src/locales/zh/alarms.json
var alarms_default = {
	"title": "报警",
	"active": "报警",
	"history": "历史",
	"log": "履历",
	"none": "没有报警",
	"none_text": "机床正常。以往的报警在历史中。",
	"remedy": "处理方法：",
	"to_program": "打开程序",
	"time": "时间",
	"number": "编号",
	"text": "报警",
	"program": "程序",
	"who": "操作者",
	"what": "内容",
	"change": "变更",
	"clear": "清除",
	"clear_right": "需要 3 级权限",
	"none_past": "尚无报警",
	"none_past_text": "发生过的报警会连同时间、程序和处理方法列在这里。",
	"entries_other": "共 {n} 条",
	"older": "更早的记录"
};
export { alarms_default as default };
