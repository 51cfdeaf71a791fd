// src/locales/zh/editor.json
var editor_default = {
	"find": "查找",
	"replace": "替换为",
	"next": "下一个",
	"previous": "上一个",
	"all": "全部",
	"case": "区分大小写",
	"expression": "正则表达式",
	"word": "整词匹配",
	"replace_this": "替换",
	"replace_all": "全部替换",
	"close": "关闭",
	"match": "匹配",
	"on_line": "位于行",
	"replaced": "已替换 $ 处",
	"replaced_on_line": "已替换第 $ 行",
	"line": "转到行",
	"go": "转到",
	"findings": "检查结果",
	"no_findings": "未发现问题",
	"completions": "代码",
	"deleted": "已删除"
};
export { editor_default as default };
