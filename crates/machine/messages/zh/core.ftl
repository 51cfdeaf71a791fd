# 各数控系统共有的故障。消息的组成与 detail 可用的参数见 src/messages.rs。

with-detail = { $text }（{ $detail }）

## 程序文本

FC-0101 = 程序段中有不允许的字符
    .detail = { $character }
    .help = 删除该字符，或把它放入注释。
FC-0102 = 数值前缺少地址
    .detail = { $word }
    .help = 在数值前补上地址字母，或删除该数值。
FC-0103 = 地址后缺少数值
    .detail = { $word }
    .help = 在地址字母后补上数值，或删除该字母。
FC-0104 = 正负号位置不对
    .detail = { $word }
    .help = 一个字只能带一个符号，紧跟在地址之后，且该地址须允许负值。
FC-0105 = 小数点位置不对或重复
    .detail = { $word }
    .help = 小数点最多一个；只能取整数的字不得带小数点。
FC-0106 = 程序行太长
    .detail = 最多 { $limit } 字节
    .help = 把该段分成几行。
FC-0107 = 括号不成对
    .help = 在同一程序段内为每个左括号补上右括号。
FC-0108 = 括号嵌套层数过多
    .detail = 最多 { $limit } 层
    .help = 先把部分表达式算入变量。
FC-0109 = 表达式无法识别
    .detail = { $word }
    .help = 检查表达式的运算符、括号和变量。
FC-0110 = 注释没有结束
    .help = 在同一行内结束注释。
FC-0111 = 宏语句无法识别
    .detail = { $word }
    .help = 检查语句的拼写和格式。
FC-0112 = 没有这个函数
    .detail = { $name }
    .help = 检查拼写；可用函数见数控系统的编程手册。
FC-0113 = 数值过大
    .detail = { $word }
    .help = 检查是否漏了小数点或多打了数字。
FC-0114 = 指令字与宏语句同段
    .detail = { $word }
    .help = 把宏语句放入单独的程序段。

## 指令字

FC-0201 = 数控系统没有这个 G 代码
    .detail = { $word }
    .help = 检查代码，并确认程序是为本系统编写的。
FC-0202 = 数控系统没有这个 M 代码
    .detail = { $word }
    .help = 检查代码，并确认程序是为本系统编写的。
FC-0203 = 此处不使用该地址
    .detail = { $word }
    .help = 删除该字，或检查它属于段中哪个代码。
FC-0204 = 同一段中地址重复
    .detail = { $word }
    .help = 只保留其中一个，或分成两段。
FC-0205 = 同一段中有两个同组 G 代码
    .detail = { $first } 与 { $second }
    .help = 只保留其中一个，或各占一段。
FC-0206 = 数值超出范围
    .detail = { $word }：{ $min } 至 { $max }
    .detail-2 = { $word }
    .help = 编入该地址允许的数值。
FC-0207 = 数值必须是整数
    .detail = { $word }
    .help = 去掉小数部分。
FC-0208 = 数值不得为负
    .detail = { $word }
    .help = 去掉负号，或检查得出该值的计算。
FC-0209 = 该代码必须单独成段
    .detail = { $word }
    .help = 把该代码放入单独的程序段。
FC-0210 = 同一段中有多个控制程序走向的 M 代码
    .detail = { $first } 与 { $second }
    .help = M00、M01、M02、M30、M98、M99 各占一段。
FC-0211 = 同一段中 M 代码过多
    .detail = 最多 { $limit } 个
    .help = 把 M 代码分到几段中。
FC-0212 = 没有这个轴
    .detail = { $axis }
    .help = 检查轴名；机床文件中列出了机床的各轴。

## 运动

FC-0301 = 切削移动没有进给速度
    .help = 在本段或之前编入 F。
FC-0302 = 圆弧起点和终点到圆心的距离不等
    .detail = 起点半径 { $start }，终点半径 { $end }，允许差 { $limit }
    .detail-2 = 起点半径 { $start }，终点半径 { $end }
    .help = 检查 I、J、K、终点以及上一段的终点。
FC-0303 = 圆弧既无半径也无圆心
    .help = 编入 R，或用平面内的 I、J、K 给出圆心。
FC-0304 = 圆弧半径太小，到不了终点
    .detail = R { $radius }，至少需要 { $least }
    .help = 检查 R 和终点；R 至少为起点到终点距离的一半。
FC-0305 = 圆弧起点就在圆心上
    .help = 检查 I、J、K：它们是圆弧起点到圆心的距离。
FC-0306 = 暂停时间为负
    .detail = { $word }
    .help = 暂停时间不带负号。
FC-0307 = 螺旋线圆弧平面之外的轴过多
    .detail = 最多 { $limit } 个
    .help = 减少圆弧平面之外的轴。
FC-0308 = 坐标超出系统能表示的范围
    .detail = { $axis } { $position }
    .help = 检查坐标值、当前偏置和缩放倍率。
FC-0309 = 进给速度超出系统范围
    .detail = { $word }
    .help = 编入大于零且在系统范围内的进给速度。

## 偏置与坐标系

FC-0401 = 没有这个补偿号
    .detail = { $number }，最大为 { $limit }
    .detail-2 = { $number }
    .help = 对照刀具补偿表检查 H 和 D。
FC-0402 = 没有这个工件坐标系
    .detail = { $name }
    .help = 使用系统工件坐标系表中的坐标系。
FC-0403 = 长度补偿与设定坐标系同段
    .help = 长度补偿和 G92 各占一段。
FC-0404 = 圆弧段中改变了刀具长度补偿
    .detail = { $word }
    .help = 在直线移动的程序段中改变长度补偿。

## 固定循环

FC-0501 = 固定循环不能在该平面执行
    .detail = { $plane }
    .help = 循环之前先选择它的平面，钻孔循环用 G17。
FC-0502 = 孔底不低于 R 平面
    .detail = 孔底 { $depth }，R { $r }
    .help = 检查 Z 和 R，以及是绝对值还是增量值。
FC-0503 = 深孔循环没有每次切深
    .detail = { $word }
    .help = 编入大于零的每次切深，多数系统用 Q。
FC-0504 = 固定循环有效时切换平面
    .help = 先用 G80 取消循环再切换平面。
FC-0505 = 固定循环没有主轴转速
    .help = 循环之前编入 S 并启动主轴。
FC-0506 = 固定循环有效时指令了参考点代码
    .detail = { $word }
    .help = 在本段之前用 G80 取消循环。

## 程序

FC-0601 = 调用时没有指定程序
    .help = 编入被调用程序的程序号或名称。
FC-0602 = 被调用的程序不存在
    .detail = { $program }
    .help = 把该程序放入程序存储器，或检查程序号、名称。
FC-0603 = 程序调用嵌套过深
    .detail = 最多 { $limit } 层
    .help = 检查程序是否调用了自身；否则合并部分子程序。
FC-0604 = 调用重复次数过多
    .detail = { $repeats } 次，最多 { $limit } 次
    .help = 检查重复次数，或改用循环。
FC-0605 = 程序号无效
    .detail = { $program }
    .help = 使用系统允许的程序号。
FC-0606 = 程序没有结束指令
    .help = 主程序以 M30 或 M02 结束，子程序以 M99 结束。
FC-0607 = 程序执行到了结束符 %
    .help = 在结束符之前用 M30、M02 或 M99 结束程序。
FC-0608 = 程序无休止运行且没有移动
    .detail = { $blocks } 段
    .help = 检查循环和跳转的条件。
FC-0609 = 跳转的顺序号不存在
    .detail = N{ $number }
    .help = 给目标段加上顺序号，或改正跳转。

## 变量与运算

FC-0701 = 除数为零
    .help = 检查除数；tan 90 也算除以零。
FC-0702 = 函数对该值无定义
    .detail = { $name }，值 { $value }
    .detail-2 = { $name }
    .help = 检查该值：开方须不小于零，对数须大于零，反正弦和反余弦须在 -1 到 1 之间。
FC-0703 = 没有这个变量
    .detail = { $variable }
    .help = 使用系统具有的变量。
FC-0704 = 变量不能写入
    .detail = { $variable }
    .help = 把值赋给允许写入的变量。
FC-0705 = 结果超出系统的数值范围
    .help = 检查参与运算的数值。

## 机床

FC-0801 = 轴将超出软限位
    .detail = { $axis } 至 { $position }，限位 { $limit }
    .detail-2 = { $axis }
    .help = 检查工件坐标系、刀具长度和坐标值；限位见机床文件。
FC-0802 = 主轴停止时切削
    .help = 首次切削之前用 M03 或 M04 和转速 S 启动主轴。
FC-0803 = 刀库中没有这把刀
    .detail = T{ $tool }
    .help = 装入该刀具，或改正刀号。
FC-0804 = 主轴达不到该转速
    .detail = S{ $speed }，最高 { $limit }
    .help = 降低转速。
FC-0805 = 机床达不到编程的进给速度
    .detail = F{ $feed }，最高 { $limit }
    .help = 降低进给速度；各轴速度见机床文件。

## 文件

FC-0901 = 文件无法读取
    .detail = { $file }：{ $reason }
    .detail-2 = { $file }
    .detail-3 = { $reason }
    .help = 检查路径以及文件是否允许读取。
FC-0902 = 文件不是程序文本
    .detail = { $file }
    .help = 请提供 UTF-8 或 GB18030 编码的文本文件。
FC-0903 = 文件中没有程序段
    .detail = { $file }
    .help = 检查文件是否正确、传输是否完整。
FC-0904 = 设置文件或机床文件不能使用
    .detail = { $file }：{ $reason }
    .detail-2 = { $file }
    .detail-3 = { $reason }
    .help = 按所示原因改正文件。
FC-0905 = 不认识的数控语言
    .detail = { $name }
    .help = 用 --dialect 指定：gsk990mc、weihong、kaitong、fagor8065 或 rs274。
FC-0906 = 本版本不执行该代码
    .detail = { $word }
    .help = 删除该代码，或改用效果相同的其他代码。

FC-0907 = 文件无法写入
    .help = 检查路径、剩余空间和文件夹权限。
    .detail = { $file }: { $reason }

FC-0706 = 空变量 #0 不能赋值
    .help = 改用其他变量。

FC-0707 = 未定义的宏运算
    .help = 检查 G65 的 H 代码。

FC-0708 = 该地址不能作为宏程序自变量
    .help = 使用 G、L、N、O、P、H 以外的字母，每个一次。

FC-0709 = 宏程序调用嵌套过深
    .help = 减少宏程序的嵌套层数。

FC-0710 = 循环语句无效
    .help = DO 和 END 的标号应为 1 至 3。

FC-0711 = 循环语句不配对
    .help = 每个 DO 配一个同标号的 END，循环不得交叉。

FC-0712 = 跳转进入了循环体
    .help = 跳转到循环之前或之后的程序段。

FC-0713 = 程序设置了报警
    .help = 在程序中查看原因。

FC-0405 = 缩放功能未启用
    .help = 将位参 60#5 设为 1。

FC-0406 = 缩放倍率超出范围
    .help = 倍率应为 0.0001 至 9999.9999。

FC-0407 = 缩放方式中不允许该代码
    .help = 先用 G50 取消缩放。

FC-0408 = 旋转方式中不允许该代码
    .help = 先用 G69 取消旋转。

FC-0409 = 极坐标方式中不允许该代码
    .help = 先用 G15 取消极坐标。

FC-0410 = 旋转方式中不能改变平面
    .help = 先用 G69 取消旋转。

FC-0411 = 极坐标方式中圆弧须用 R 编程
    .help = 用 R 代替 I、J、K。

FC-0412 = 坐标变换中不能切换公英制
    .help = 先取消坐标变换。

FC-0413 = 坐标变换中不能使用跳转功能
    .help = 先取消坐标变换。

FC-0414 = 返回参考点未指定轴
    .help = 指定要返回的轴。

FC-0415 = 参考点号错误
    .help = 使用 P2、P3 或 P4。

FC-0416 = 所到位置不是参考点
    .help = 检查位置和有效的偏置。

FC-0417 = 固定循环中不能设定数据
    .help = 先用 G80 取消固定循环。

FC-0418 = 不支持的数据设定格式
    .help = 使用 L2、L10 至 L13、L20、L50 或 L51。

FC-0419 = 偏置号缺失或过大
    .help = 检查 P。

FC-0420 = 偏置量缺失或过大
    .help = 检查 R。

FC-0421 = 参数号、位或数值缺失或超出范围
    .help = 检查 N、P 和 R。

FC-0422 = 程序不能设定该参数
    .help = 在参数页面设定。

FC-0423 = 参数设定方式中不允许该指令
    .help = 先用 G11 结束设定。

FC-0507 = Z 平面不高于 R 平面
    .help = 背镗时 R 应为较低平面。

FC-0508 = 攻丝主轴转速缺失或过高
    .help = 在攻丝上限内给出 S。

FC-0509 = 固定循环中指定了刚性攻丝
    .help = 在 M29 之前用 G80 取消循环。
