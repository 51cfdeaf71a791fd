// src/locales/zh/item.json
var item_default = {
	"programs": "程序",
	"parameters": "参数",
	"offsets": "刀具偏置",
	"zeros": "工件坐标系",
	"reference-points": "参考点",
	"variables": "宏变量",
	"pitch": "螺补",
	"plc": "PLC 数据",
	"counters": "计数器",
	"alarms": "报警历史",
	"log": "操作履历",
	"position": "位置",
	"ladder": "梯形图",
	"interrupted": "中断的运行",
	"rights": "权限",
	"memory": "存储器"
};
export { item_default as default };
