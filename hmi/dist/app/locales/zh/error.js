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
	"unreadable": "该文件不是文本",
	"too_large": "文件过大",
	"log_in": "请先登录",
	"busy": "机床忙，请稍后再试"
};
export { error_default as default };
