# Faults of drawings, common to all controls.

FC-1001 = The drawing ends in the middle
    .help = Save or transfer the drawing once more.

FC-1002 = The drawing holds more than can be taken in
    .detail = at most { $megabytes } MB
    .detail-2 = at most { $curves } lines and arcs
    .detail-3 = at most { $points } points of curves
    .detail-4 = at most { $inserts } inserted blocks
    .help = Divide the drawing, or raise the tolerance.

FC-1003 = The drawing has nothing to cut
    .help = Check that it holds lines or curves, and on which layers they are.

FC-1004 = A place of the drawing is too far from its zero
    .detail = { $position } mm, at most { $limit }
    .help = Check the unit and the scale of the drawing.

FC-1005 = No DXF group code stands here
    .detail = { $word }
    .help = Save the drawing once more as an ASCII DXF file.

FC-1006 = A DXF value is not a number that can be used
    .detail = { $word }
    .help = Save the drawing once more as an ASCII DXF file.

FC-1007 = The DXF file is a binary one
    .help = Save the drawing as an ASCII DXF file.

FC-1008 = The entity of the drawing cannot be read
    .detail = { $word }
    .help = Remove the entity, or save the drawing once more.

FC-1009 = A block of the drawing holds itself
    .detail = { $name }
    .help = Remove the insertion of the block from the block.

FC-1010 = Degree, knots, weights and points of the spline do not fit each other
    .help = Draw the spline again, or convert it into a polyline.

FC-1011 = No PLT instruction stands here
    .detail = { $word }
    .help = Check that the file is PLT (HP-GL) text and was transferred whole.

FC-1012 = The PLT instruction has the wrong number of values
    .detail = { $word }
    .help = Check the instruction; a point of a three-dimensional file has three values (dims = 3).

FC-1013 = Entities of a kind that is not cut are left out
    .detail = { $kind }, { $count }
    .help = Turn them into lines, arcs or polylines if they are to be cut.

FC-1014 = Entities on a layer that is not shown are left out
    .detail = { $name }, { $count }
    .help = Thaw the layer or switch it on if they are to be cut.

FC-1015 = Entities in paper space, and invisible ones, are left out
    .detail = { $count }
    .help = Move them to model space if they are to be cut.

FC-1016 = An inserted block is not in the drawing
    .detail = { $name }
    .help = Save the drawing once more with all its blocks.

FC-1017 = A PLT instruction is not carried out
    .detail = { $instruction }
    .help = If it draws something, such as letters, that is missing: compare the picture with the drawing.

FC-1018 = The setting of the import cannot be used
    .detail = { $setting }: { $value }; allowed: { $allowed }
    .help = Give it as the help of the import command describes.

FC-1019 = Drawings cannot be written in this control language
    .detail = { $name }
    .help = Use gsk990mc, kaitong or weihong.

FC-1020 = The file is neither a PLT nor a DXF drawing
    .detail = { $file }
    .help = Name its kind with --from plt or --from dxf if it is one.

FC-1021 = The drawing has nothing on the layer or with the pen
    .detail = { $name }; it has: { $names }
    .help = Use a name that the drawing has. Layers go with DXF drawings, pens with PLT drawings.

FC-1022 = A PLT instruction is not known here
    .detail = { $instruction }
    .help = Take it out, or save the drawing with lines and arcs alone: PU, PD, PA, PR, AA, AR, CI, EA, ER and EW.
