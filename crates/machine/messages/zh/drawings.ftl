# 图纸的报警，各控制系统通用。

FC-1001 = 图纸文件不完整
    .help = 请重新保存或重新传输图纸。

FC-1002 = 图纸内容超出可处理的数量
    .detail = 最多 { $megabytes } MB
    .detail-2 = 最多 { $curves } 条直线和圆弧
    .detail-3 = 最多 { $points } 个曲线点
    .detail-4 = 最多 { $inserts } 次块插入
    .help = 请拆分图纸，或放宽公差。

FC-1003 = 图纸中没有可加工的线条
    .help = 检查图纸中是否有直线或曲线，以及它们所在的图层。

FC-1004 = 图纸中的位置离零点太远
    .detail = { $position } mm，最大 { $limit }
    .help = 检查图纸的单位和比例。

FC-1005 = 此处不是 DXF 组码
    .detail = { $word }
    .help = 请将图纸重新保存为 ASCII DXF 文件。

FC-1006 = DXF 数值不是可用的数
    .detail = { $word }
    .help = 请将图纸重新保存为 ASCII DXF 文件。

FC-1007 = DXF 文件是二进制格式
    .help = 请将图纸保存为 ASCII DXF 文件。

FC-1008 = 无法读取图纸中的实体
    .detail = { $word }
    .help = 删除该实体，或重新保存图纸。

FC-1009 = 图块包含自身
    .detail = { $name }
    .help = 从该块中删除对它自身的插入。

FC-1010 = 样条的次数、节点、权值和点互不相符
    .help = 重新绘制样条，或将其转换为多段线。

FC-1011 = 此处不是 PLT 指令
    .detail = { $word }
    .help = 检查文件是否为 PLT（HP-GL）文本，传输是否完整。

FC-1012 = PLT 指令的数值个数不对
    .detail = { $word }
    .help = 检查该指令；三维文件的点有三个数值（dims = 3）。

FC-1013 = 不能加工的实体已略去
    .detail = { $kind }，{ $count } 个
    .help = 如需加工，请先转换为直线、圆弧或多段线。

FC-1014 = 未显示图层上的实体已略去
    .detail = { $name }，{ $count } 个
    .help = 如需加工，请解冻或打开该图层。

FC-1015 = 图纸空间中的实体和不可见的实体已略去
    .detail = { $count } 个
    .help = 如需加工，请移到模型空间。

FC-1016 = 插入的块不在图纸中
    .detail = { $name }
    .help = 请连同所有块重新保存图纸。

FC-1017 = 有 PLT 指令未执行
    .detail = { $instruction }
    .help = 如果该指令绘制内容（例如文字），则该内容缺失：请将路径图与原图比较。

FC-1018 = 导入设置不可用
    .detail = { $setting }：{ $value }；允许：{ $allowed }
    .help = 请按导入命令的帮助给出。

FC-1019 = 不能用这种控制语言写出图纸
    .detail = { $name }
    .help = 请使用 gsk990mc、kaitong 或 weihong。

FC-1020 = 文件既不是 PLT 也不是 DXF 图纸
    .detail = { $file }
    .help = 如果确实是图纸，请用 --from plt 或 --from dxf 指明种类。

FC-1021 = 图纸的该图层或笔号上没有内容
    .detail = { $name }；图纸中有：{ $names }
    .help = 请使用图纸中有的名称。图层用于 DXF 图纸，笔号用于 PLT 图纸。

FC-1022 = 此处无法识别该 PLT 指令
    .detail = { $instruction }
    .help = 请删除该指令，或仅以直线和圆弧保存图纸：PU、PD、PA、PR、AA、AR、CI、EA、ER 和 EW。
