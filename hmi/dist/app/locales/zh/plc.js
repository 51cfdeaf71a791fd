// src/locales/zh/plc.json
var plc_default = {
	"title": "程控",
	"monitor": "梯形图",
	"edit": "修改",
	"trace": "跟踪",
	"none": "此机床没有梯形图",
	"none_text": "请用 --ladder FILE 启动。",
	"nothing": "没有匹配的梯级",
	"rung": "第 {line} 行的梯级",
	"force_on": "强制接通",
	"force_off": "强制断开",
	"force_release": "解除强制",
	"facts": "{rungs} 个梯级，{instructions} 条指令",
	"roll_back": "恢复前一版本",
	"start": "启动",
	"exchange": "更换",
	"exchange_text": "梯形图在机床运行中于两次扫描之间更换，信号、定时器和计数器保持不变。",
	"exchanged": "梯形图已更换",
	"signals": "信号名称，最多 32 个",
	"record": "记录",
	"stop": "停止",
	"trace_text": "由控制器在每次梯形图扫描时采样；没有变化的不保存。",
	"at_signal": "按信号",
	"changes": "变化",
	"trigger": "触发信号",
	"waits": "等待信号…"
};
export { plc_default as default };
