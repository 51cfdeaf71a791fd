// src/locales/zh/graphics.json
var graphics_default = {
	"title": "图形",
	"none": "未选择程序",
	"none_text": "此处绘制所选程序的轨迹。",
	"iso": "XYZ",
	"top": "XY",
	"front": "XZ",
	"side": "YZ",
	"fit": "显示全部",
	"rapids": "快速移动",
	"section": "截面",
	"measure": "测量",
	"height": "截面高度",
	"live": "实时",
	"time": "时间",
	"rest": "剩余 {time}",
	"line": "第 {line} 行",
	"distance": "距离 {distance} mm",
	"second": "选择第二个点。",
	"facts": "{n} 个点，{x} × {y} × {z} mm",
	"failed": "无法计算轨迹",
	"cut_by_alarm": "轨迹在程序报警处中止",
	"cut_by_size": "程序比显示的更长",
	"turned": "ZY",
	"around": "ZXY",
	"next": "切换视图"
};
export { graphics_default as default };
