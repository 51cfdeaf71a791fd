# 命令行中报警以外的文字。

label-machine = 机床
label-control = 系统
label-guessed = { $dialect }（未指定；可用 --dialect 选择）
label-guessed-content = { $dialect }（{ $blocks } 段中有 { $unread } 段不是 { $other }；可用 --dialect 选择）
label-guessed-extension = { $dialect }（根据文件扩展名；可用 --dialect 选择）
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
label-times = 程序运行到此处 { $count } 次

## 说明

label-error = 错误：{ $text }
label-near = { $text }；相近的有：{ $names }
label-unknown = { $dialect } 中没有 { $name }
label-no-code = { $dialect } 没有代码 { $name }
label-no-alarm = { $dialect } 没有报警 { $name }
label-no-variable = { $dialect } 没有变量 #{ $name }
label-no-parameter = { $dialect } 没有参数 { $name }
label-no-parameters = { $dialect } 没有参数
label-no-sign = { $dialect } 的算术参数不带符号：{ $name }
label-several-parameters = 多个参数的符号都是 { $name }：{ $names }
label-whole-bits = { $name } 有多个位：请指明一位，例如 { $name }.1
label-malformed-name = { $name } 不是参数名：请写成 P270、NO43.1 或符号
label-out-of-range = { $name } 不能为 { $value }：须为 { $range }
label-any-number = 数值
label-not-a-bit = { $name } 不能为 { $value }：它是位参数，只能为 0 或 1
label-not-whole = { $name } 不能为 { $value }：必须是整数
label-value-changed = { $value }（缺省 { $default }）
label-explain-form = 格式
label-explain-group = 组
label-explain-modal = 模态
label-explain-one-block = 仅在本段有效
label-explain-modal-depends = 是否模态取决于参数和格式
label-explain-at-power-on = 上电时有效
label-explain-replaces = 同组
label-explain-does = 功能
label-explain-section = 手册章节
label-explain-note = 注意
label-explain-not-done = 本版本不执行此代码
label-explain-forms = 形式
label-explain-parameters = 相关参数
label-explain-alarms = 相关报警
label-explain-codes = 相关代码
label-explain-no-meaning = 手册只列出而未说明；由机床厂定义
label-explain-timing = 时机
label-explain-with-motion = 与本段运动同时开始
label-explain-after-motion = 在本段运动之后
label-explain-class = 执行者
label-explain-program-control = 系统（程序控制）
label-explain-internal = 系统内部
label-explain-plc = 机床梯形图
label-explain-alone = 程序段
label-explain-own-block = 同段不得有其他此类代码
label-explain-meaning = 含义
label-explain-one = 1
label-explain-zero = 0
label-explain-value = 当前值
label-explain-default = 缺省值
label-explain-range = 范围
label-explain-bit = 0 或 1
label-explain-no-range = 手册未给出
label-explain-whole = 整数
label-explain-axis = 轴
label-explain-room = 类别
label-explain-other-room = { $room }；仅保存其值，本版本不使用
label-explain-help = 处理方法
label-explain-source = 来源
label-explain-raised_by = 由以下情况引起
label-explain-shown_as = 显示为
label-explain-numbers = 编号
label-explain-access = 读写
label-explain-read = 只读
label-explain-write = 只写
label-explain-read-write = 可读写
label-explain-access-unknown = 手册未说明
label-explain-this_one = 此变量
label-explain-external = 外部偏置
label-explain-notes = 备注
label-explain-part_of = 属于
label-explain-no-variable = 手册未说明；程序不能使用
label-explain-place = 位置
label-explain-used_by = 读取者
label-explain-in_force = 有效模态
label-explain-no-block = { $file } 第 { $line } 行没有程序段
label-explain-no-word = { $file } 第 { $line } 行第 { $column } 列没有字
label-explain-no-word-there = { $file } 第 { $line } 行第 { $column } 列没有字；该行各字及其列号：{ $words }
label-explain-comment = { $file } 第 { $line } 行第 { $column } 列是注释
label-explain-no-line = { $file } 是文件：请指定其中一行，如 { $file }:12，或行和列，如 { $file }:12:5
label-explain-drawing = { $file } 是 { $kind } 图形，其中没有程序字：用 "ferrocut import" 可由它生成程序
label-room-acceleration = 加减速
label-room-bus-servo = 伺服与总线
label-room-canned-cycles = 固定循环
label-room-compensation = 补偿
label-room-coordinates = 坐标
label-room-display = 显示
label-room-feed = 进给
label-room-homing = 参考点
label-room-io = 输入输出
label-room-limits = 行程限位
label-room-lookahead = 前瞻
label-room-macro = 宏程序
label-room-other = 其他
label-room-plc = 梯形图
label-room-program-edit = 程序编辑
label-room-security = 权限
label-room-spindle = 主轴
label-room-tapping = 攻丝
label-room-tool-change = 换刀
label-room-tool-life = 刀具寿命
label-class-program = 零件程序
label-class-macro = 宏语句
label-class-operation = 面板操作
label-class-homing = 参考点
label-class-storage = 程序存储器
label-class-servo = 进给驱动
label-class-spindle = 主轴
label-class-overtravel = 轴超程
label-class-plc = 梯形图
label-class-system = 系统本身

## 机床文件与参数

label-warning = 警告：{ $text }
label-exists = { $file } 已存在，未作更改
label-nothing-written = 未写入任何内容
label-no-assignment = { $text } 未设置任何参数：请写成 名称=值
label-no-number = { $name } 不能为 { $value }：不是数值
label-set-twice = { $name } 被设置了两次
label-named-twice = { $name } 与 { $other } 是同一参数
label-lower-above-upper = { $first } 必须小于其上限 { $second }
label-same-axis = { $first } 与 { $second } 指定了同一轴名；系统将采用 X、Y、Z、A
label-both-bits = { $first } 与 { $second } 不能同时为 1
label-passed-over = { $file }：{ $reason }；已忽略
label-no-room = 没有类别 { $name }；类别有 { $names }
label-no-column = { $file } 没有 { $name } 列
label-no-row = { $file } 第 { $line } 行不是表格的行
label-row-twice = { $name } 已在第 { $line } 行出现
label-imported = 更改 { $changed } 个值，{ $same } 个不变
label-params-name = 参数
label-params-symbol = 符号
label-params-value = 当前值
label-params-default = 缺省值
label-params-range = 范围
label-params-unit = 单位
label-params-room = 类别
label-params-use = 使用
label-params-kept = 仅保存
label-params-used = 使用
label-params-meaning = 含义
label-params-unchanged = 这些参数均与缺省值相同
label-params-no-match = { $dialect } 没有与 { $name } 匹配的参数
label-params-checked = 检查了 { $file } 的 { $parameters } 个参数：{ $findings ->
    [0] 无问题
   *[other] { $findings } 个问题
}
label-machine-axis = 轴
label-machine-kind = 类型
label-machine-linear = 直线
label-machine-rotary = 旋转
label-machine-limits = 行程
label-machine-rapid = 快移
label-machine-cutting = 切削
label-machine-acceleration = 加速度
label-machine-jerk = 加加速度
label-machine-unlimited = 不限
label-machine-control = 系统
label-machine-period = 伺服周期
label-machine-spindle-name = 主轴
label-machine-tool-change-name = 换刀
label-machine-tools = { $tools } 把刀
label-machine-tolerance-name = 轨迹公差
label-machine-exact-stop = 每段准停
label-machine-parameters = 参数
label-machine-dialect = 没有系统 { $name }
label-machine-no-axis = { $dialect } 的程序不能使用 { $axis } 轴
label-machine-travel = { $axis } 轴：行程 { $value } mm 超过任何机床；max 的单位是 mm 吗？
label-machine-zero = { $axis } 轴：机床坐标 0 在 min 与 max 之外，而未指定起点时程序从此处开始
label-machine-fast = { $axis } 轴：快移 { $value } mm/min 超过任何机床；单位是 mm/min 吗？
label-machine-velocity = { $axis } 轴：切削速度 { $value } mm/min 高于快移速度
label-machine-sluggish = { $axis } 轴：达到快移速度需 { $value } s；acceleration 的单位是 mm/s² 而不是 m/s² 吗？
label-machine-abrupt = { $axis } 轴：加速度 { $value } 在 { $limit } s 内即达到快移速度；单位是 mm/s² 吗？
label-machine-jerk-low = { $axis } 轴：按此 jerk 建立加速度需 { $value } s；单位是 mm/s³ 吗？0 为不限
label-machine-smoothing-differs = { $axis } 轴：after_cutting 与其他轴不同；变速处直线会弯曲
label-machine-pitch-off = { $axis } 轴：pitch_errors 没有 start 和 interval，控制系统参数也未给出补偿点的位置；不作补偿
label-machine-spindle = 主轴 { $value } r/min 超过任何机床
label-machine-spindle-sluggish = 主轴达到最高转速需 { $value } s；acceleration_rpm_s 的单位是每秒 r/min 吗？
label-machine-tolerance = 轨迹偏差 { $value } mm 无法加工零件；tolerance 的单位是 mm 吗？
label-machine-tool-change = 换刀需 { $value } s；time_s 的单位是秒吗？
label-machine-file-missing = 此处指定了 { $file }，但在机床文件旁无法读取：{ $reason }
label-public-missing = public_programs 指定了 { $file }，但该文件无法读取（{ $reason }），而任何代码都可能是其中的程序：请把文件放到该处，用 --public 指定另一个文件，或删去该行
label-linuxcnc-file = 它用于 rs274 程序，而指定的语言是 { $dialect }：请去掉其中之一
label-quote-bits = 位参数的名称须加引号："NO43.1" = 1

## 图纸

label-drawing-by-name = { $file }：按 { $kind } 图纸读取（依据文件名）
label-drawing-by-content = { $file }：按 { $kind } 图纸读取（依据内容）
label-stage-read = 正在读取图纸
label-stage-plan = 正在安排顺序
label-stage-write = 正在写程序
label-stage-prove = 正在试算程序
label-drawing-made = { $file }：{ $kind }，{ $wide } x { $high } mm，切削 { $curves } 段共 { $cut } mm，下刀 { $ways } 次，空行程 { $way } mm

## 曲线图

label-plot-title = { $program }，机床 { $machine }
label-plot-note = 按 { $period } ms 伺服周期作差分；加加速度为 { $window } ms 内的平均值。虚线为允许值。
label-plot-speed = 路径速度与编程进给（虚线），mm/min
label-plot-velocity = { $axis } 轴速度，{ $length }/min；切削与快移限值
label-plot-acceleration = { $axis } 轴加速度，{ $length }/s²
label-plot-jerk = { $axis } 轴加加速度，{ $length }/s³
label-plot-error = 轨迹误差与允差（虚线），mm
label-plot-peak = 最大 { $value }，{ $time } s，第 { $line } 行
label-plot-time = 开始运动后的时间，s

## Pictures of paths

label-view-top = 俯视图
label-view-isometric = 等轴测图
label-view-start = 起点
label-view-end = 终点
label-view-zero = 工件零点
label-view-rapid = 快速移动
label-view-cut = 切削
label-view-depths = 切削，由浅至深
label-view-nothing = 没有移动
label-view-no-axes = X、Y、Z 没有移动
label-view-depth = Z mm
label-view-length = { $length } mm
label-view-work = 工件坐标，mm
label-view-machine = 机床坐标，mm
label-view-moves = { $count ->
   *[other] { $shown } 次移动
}
label-view-rapids = { $count ->
   *[other] 快速 { $shown } 次
}
label-view-cuts = 切削 { $shown } 次，共 { $length } mm
label-view-along = 沿 X、Y、Z { $length } mm
label-view-memory = 图像内存不足
label-view-encoding = 图像无法写成 PNG：{ $reason }

## Restart

label-restart-at = 从第 { $line } 行继续，第 { $pass } 次到达
label-restart-position = 程序段起点
label-restart-modal = 程序 / 机床此前
label-restart-sent = 先发出
label-restart-approach = 各轴依次移动
label-restart-nothing = 无
label-restart-group = G 代码第 { $group } 组
label-restart-feed = F
label-restart-feed-per-turn = 每转 F
label-restart-speed = S
label-restart-spindle = 主轴
label-restart-flood = 冷却液
label-restart-mist = 喷雾
label-restart-tool = T
label-restart-in-spindle = 主轴上的刀具
label-restart-length = H
label-restart-radius = D
label-restart-zero = { $axis } 轴零点
label-restart-tool-length = { $axis } 轴刀具长度

## Machine and set-up files

label-unknown-parameter = { $name }：该系统没有此参数
label-too-many-parameters = 参数过多：任何系统都不超过 { $max } 个
label-config-positive = { $what } 为 { $value }：应大于 0
label-config-not-negative = { $what } 为 { $value }：应为 0 或更大
label-config-range = { $what } 为 { $value }：应为 { $min } 至 { $max }
label-config-count = { $what }：有 { $value } 个，允许 { $min } 至 { $max } 个
label-config-twice = { $what } 出现两次
label-config-finite = { $what } 为 { $value }：应为有限的数
label-config-no-machine = 这不是机床文件：其中没有 axes；"ferrocut machine new" 可写出一个起始文件
label-config-order = { $what }：min { $min } 应小于 max { $max }
label-config-unequal = { $what }：有 { $value } 个，而 { $other } 有 { $count } 个：数目应相同
label-config-either = { $what }：需要 { $one } 或 { $other } 其中之一
label-config-no-axis = { $what }：机床没有该轴
label-config-step = { $what } 为 { $value }：应不小于一步 { $min }，因为轴在指令之后才到位
label-config-lag = { $what } 为 { $value }：最高速度时，因缓冲区中等待的数据，轴滞后 { $min }
label-config-parameter = [parameters] { $reason }：请更改或删除
label-config-null-variable = { $what }：#0 始终为空，不能设置；请删除
label-config-variables = { $what }：变量过多，存放不下；请删除一些
label-config-work-offset = [work_offsets] { $name }：该系统有 G54 P1 至 P{ $max }；请更改或删除
label-config-tool = [tools.{ $number }]：该系统的偏置号为 1 至 { $max }；请更改或删除
label-config-no-place = { $name }：没有位置再容纳一个轴；请删除 u、v、w 中的一个
label-config-var-line = 第 { $line } 行：应为 1 至 { $max } 的编号和一个数值
label-config-tool-word = 第 { $line } 行：{ $word } 不是刀具表的字
label-config-no-tool = 第 { $line } 行：没有指明刀具的 T 字
label-config-tool-twice = 第 { $line } 行：刀具 T{ $tool } 出现两次；请删除一个
label-config-tools = 第 { $line } 行：刀具多于 { $max } 把
