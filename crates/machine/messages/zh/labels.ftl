# 命令行中报警以外的文字。

label-machine = 机床
label-control = 系统
label-guessed = { $dialect }（未指定；可用 --dialect 选择）
label-built-in = { $machine }（内置；可用 --machine 指定）
label-time = 时间
label-cutting = 切削
label-rapid = 快移
label-dwell = 暂停
label-tool-changes = 换刀
label-spindle = 主轴
label-distance = 行程
label-extents = 范围
label-moves = 移动段数
label-parts = 件数
label-tool = T{ $tool }
label-by-tool = 各刀具
label-no-moves = 无移动
label-no-tool = 无刀具
label-stopped = { $code } 停止；按循环启动继续
label-press-enter = 按回车键作循环启动
label-ended-by-alarm = 因报警停止；此前已完成：
label-written = 已写入：{ $file }
label-checked = 在 { $machine } 上检查了 { $files } 个文件：{ $findings ->
    [0] 无问题
   *[other] { $findings } 个问题
}
label-further = 另有 { $count } 个问题
