// src/locales/zh/message.json
var message_default = {
	"MSG_AIR": "气压过低",
	"MSG_LUBE": "润滑油不足或无压力",
	"MSG_COOLANT": "冷却液不足",
	"MSG_CONVEYOR": "排屑器过载",
	"MSG_DOOR": "运行中打开了防护门",
	"MSG_DRIVE": "主轴驱动未就绪",
	"MSG_TOOL": "换刀超时",
	"MSG_POCKET": "没有此刀位",
	"MSG_MAGAZINE": "刀库在主轴处：请先退回刀库 (M22)"
};
export { message_default as default };
