// src/locales/zh/diagnosis.json
var diagnosis_default = {
	"title": "诊断",
	"signals": "信号",
	"waveform": "波形",
	"timing": "时序",
	"area": "区域",
	"more": "还有 {n} 个，请搜索。",
	"velocity": "速度",
	"position": "位置",
	"error": "跟随误差",
	"path": "F 和 S",
	"duration": "时长",
	"record": "按周期记录",
	"waveform_text": "实时值每秒 50 次，记录包含每个伺服周期。拖动可缩放，双击显示全部。",
	"periods": "启动以来的周期数",
	"drift": "相对本机时钟超前",
	"gap": "更新间隔：中位、99 %",
	"gaps": "更新间隔",
	"round": "往返时间"
};
export { diagnosis_default as default };
