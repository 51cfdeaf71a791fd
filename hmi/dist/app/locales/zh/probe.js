// src/locales/zh/probe.json
var probe_default = {
	"hint": "在自动方式下准备，按循环启动执行。",
	"ready": "就绪：循环启动开始测量",
	"work": "用测头测工件零点",
	"hole": "孔",
	"boss": "凸台",
	"slot": "槽",
	"web": "筋",
	"edge": "边",
	"diameter": "直径",
	"along": "沿 {axis} 的宽度",
	"distance": "到边的距离",
	"height": "触碰高度",
	"tolerance": "公差",
	"way": "触碰方向",
	"prepare": "准备",
	"tool": "用对刀仪测刀具",
	"tool_length": "长度",
	"tool_diameter": "直径",
	"tool_both": "两者",
	"length": "估计长度",
	"tool_hint": "空着的栏目取自刀补。对刀仪位置由 P387 至 P389 给出。",
	"last": "最近测量",
	"stored": "已存入 {what}",
	"nothing": "尚未测量。"
};
export { probe_default as default };
