# 梯形图：控制系统没有编号的故障，以及命令行显示的内容。

FC-1101 = 违反了梯形图的一条规则
    .detail = { $word }
    .help = 控制系统的报警号说明是哪一条。

FC-1102 = 运行梯形图的设置不可用
    .detail = { $setting }：{ $value }；允许：{ $allowed }
    .help = 请用名称或地址（如 X20.3）给出信号，并在 = 后面给出它的值。

FC-1420 = 梯形图未完成辅助功能代码
    .detail = { $word }
    .help = 在诊断页面查看所等待的信号，排除机床故障后按复位。
FC-1421 = 梯形图未进入刚性攻丝状态
    .help = 信号 RGTAP 为 0：检查梯形图对 M29 的处理。
FC-1422 = 无法采集该波形
    .detail = { $value }
    .help = 请指定机床具有的轴和信号，至少一个，且不超过允许的数量。
FC-1423 = 参数开关已打开
    .help = 参数设定结束后关闭参数开关，或在设置页面取消报警。
FC-1424 = 运行的梯形图不是机床文件中的梯形图
    .help = 运行中换入的梯形图已保存。要恢复机床自带的梯形图，请撤回或再次更换。
FC-1425 = 保存的梯形图无法运行，现运行机床自带的梯形图
    .help = 请换入改正后的梯形图；更换后将替代已保存的梯形图。
    .detail = 第 { $line } 行
FC-1426 = 新梯形图停止，已撤回
    .help = 现运行更换前的梯形图。请检查第一级是否有死循环或步数过多。

label-ladder-checked = { $file }：{ $steps } 步，其中第一级 { $first } 步，{ $signals } 个命名信号
label-ladder-faults = { $count } 个故障
label-ladder-on = 通
label-ladder-off = 断
label-ladder-ran = { $time } 毫秒，第二级 { $rounds } 轮，每周期最多 { $steps } 步
label-ladder-stopped = { $time } 毫秒后停止
label-ladder-legend = | 触点或输入接通，o 断开，- 未执行；* 其后的线路接通
