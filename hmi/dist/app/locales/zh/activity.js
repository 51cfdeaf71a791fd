// src/locales/zh/activity.json
var activity_default = {
	"idle": "就绪",
	"running": "运行中",
	"held": "进给保持",
	"block_end": "程序段结束",
	"stopped": "程序停止",
	"returning": "返回中",
	"by_hand": "手动移动",
	"resetting": "复位中",
	"alarm": "报警",
	"emergency": "急停"
};
export { activity_default as default };
