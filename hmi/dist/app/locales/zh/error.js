// src/locales/zh/error.json
var error_default = {
	"failed": "操作失败",
	"not_in_command": "请先取得控制",
	"taken": "其他人正在控制",
	"no_connection": "未连接到机床",
	"no_machine": "机床没有响应",
	"no_answer": "机床未及时响应",
	"no_command": "机床不认识此命令",
	"no_object": "机床无法读取此内容",
	"bad_id": "机床无法读取此内容",
	"refused": "机床拒绝了此操作",
	"unreadable": "机床无法读取此内容",
	"too_large": "文件过大",
	"log_in": "请先登录",
	"busy": "机床忙，请稍后再试",
	"not_text": "该文件不是文本",
	"too_slow": "连接速度太慢",
	"too_often": "尝试次数过多，请稍等一分钟",
	"missing": "机床中没有此项",
	"other_origin": "机床只接受来自其自身页面的请求",
	"unknown_host": "机床不认识这个地址",
	"line_too_long": "一次发送的内容过长",
	"too_many_connections": "连接数已达上限",
	"logged_out": "您已退出登录",
	"dnc_over": "不再等待文件的后续内容",
	"dnc_foreign": "这不是正在发送的那个文件"
};
export { error_default as default };
