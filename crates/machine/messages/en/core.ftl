# Faults common to all controls. What a message is made of and which arguments a detail may name

# stands in src/messages.rs.

with-detail = { $text } ({ $detail })

## Text

FC-0101 = A character that no block may hold
    .detail = { $character }
    .help = Remove the character, or put it into a comment.
FC-0102 = A number without an address before it
    .detail = { $word }
    .help = Put the address letter before the number, or remove it.
FC-0103 = An address without a value
    .detail = { $word }
    .help = Write the value behind the address letter, or remove the letter.
FC-0104 = A sign where none may stand
    .detail = { $word }
    .help = A word takes one sign, directly behind its address, and only where its value may be negative.
FC-0105 = A decimal point where none may stand, or more than one
    .detail = { $word }
    .help = Write one decimal point at most, and none in words that must be whole.
FC-0106 = The line is too long
    .detail = at most { $limit } bytes
    .help = Split the block into several lines.
FC-0107 = Brackets do not pair
    .help = Give every opening bracket its closing one in the same block.
FC-0108 = Brackets are nested too deep
    .detail = at most { $limit } levels
    .help = Calculate a part of the expression into a variable first.
FC-0109 = The expression cannot be read
    .detail = { $word }
    .help = Check operators, brackets and variables of the expression.
FC-0110 = A comment is opened and not closed
    .help = Close the comment in the same line.
FC-0111 = The macro statement cannot be read
    .detail = { $word }
    .help = Check the spelling and the form of the statement, and whether the control has it.
FC-0112 = No such function
    .detail = { $name }
    .help = Check the spelling; the control's programming manual lists its functions.
FC-0113 = The number is too large
    .detail = { $word }
    .help = Check the number for missing decimal points and doubled digits.
FC-0114 = Words and a macro statement share a block
    .detail = { $word }
    .help = Put the macro statement into a block of its own.
FC-0115 = Text that is not closed
    .detail = { $word }
    .help = End the text with the quote or bracket that it needs.

## Words

FC-0201 = The control does not have this G code
    .detail = { $word }
    .help = Check the code, and that the program is meant for this control.
FC-0202 = The control does not have this M code
    .detail = { $word }
    .help = Check the code, and that the program is meant for this control.
FC-0203 = The control does not use this address here
    .detail = { $word }
    .help = Remove the word, or check which code of the block it was meant for.
FC-0204 = An address stands more than once in the block
    .detail = { $word }
    .help = Keep one of the words, or divide the block.
FC-0205 = Two G codes of one modal group in the block
    .detail = { $first } and { $second }
    .help = Keep one of them, or put them into blocks of their own.
FC-0206 = The value is outside its range
    .detail = { $word }: { $min } to { $max }
    .detail-2 = { $word }
    .help = Program a value that the address may hold.
FC-0207 = The value must be a whole number
    .detail = { $word }
    .help = Write the word without decimals.
FC-0208 = The value must not be negative
    .detail = { $word }
    .help = Remove the sign, or check the calculation that the value comes from.
FC-0209 = The code must stand alone in its block
    .detail = { $word }
    .help = Put the code into a block of its own.
FC-0210 = M codes that control the program stand together in a block
    .detail = { $first } and { $second }
    .help = Put each of M00, M01, M02, M30, M98 and M99 into a block of its own.
FC-0211 = Too many M codes in the block
    .detail = at most { $limit }
    .help = Divide the M codes between several blocks.
FC-0212 = There is no such axis
    .detail = { $axis }
    .help = Check the axis letter; the machine file lists the axes that the machine has.

## Motion

FC-0301 = A cutting move without a feed
    .help = Program F in this block or before it.
FC-0302 = Start and end of the arc are at different distances from its centre
    .detail = radius { $start } at the start, { $end } at the end; they may differ by { $limit }
    .detail-2 = radius { $start } at the start, { $end } at the end
    .help = Check I, J and K, the end point, and the point where the block before it ends.
FC-0303 = The arc has neither a radius nor a centre
    .help = Program R, or the centre with those of I, J and K that lie in the plane.
FC-0304 = The arc's radius is too small to reach its end
    .detail = R { $radius }, at least { $least } is needed
    .help = Check R and the end point; R must be at least half the distance between start and end.
FC-0305 = The arc starts at its own centre
    .help = Check I, J and K: they are the distances from the start of the arc to its centre.
FC-0306 = The dwell is negative
    .detail = { $word }
    .help = Program the dwell without a sign.
FC-0307 = Too many axes beside the circle of the helix
    .detail = at most { $limit }
    .help = Program fewer axes outside the plane of the arc.
FC-0308 = A coordinate is beyond what the control can hold
    .detail = { $axis } { $position }
    .help = Check the coordinate, the offsets and the scale factor that are in effect.
FC-0309 = The feed is outside the control's range
    .detail = { $word }
    .help = Program a feed above zero and within the control's range.

## Offsets and coordinate systems

FC-0401 = There is no such offset number
    .detail = { $number }, the highest is { $limit }
    .detail-2 = { $number }
    .help = Check H and D against the tool offset table.
FC-0402 = There is no such work coordinate system
    .detail = { $name }
    .help = Use one of the systems of the control's work offset table.
FC-0403 = Length compensation in the block that sets the coordinate system
    .help = Put the length compensation and G92 into blocks of their own.
FC-0404 = The tool length changes in a block with an arc
    .detail = { $word }
    .help = Change the length compensation in a block with a straight move.

## Canned cycles

FC-0501 = The cycle does not work in this plane
    .detail = { $plane }
    .help = Select the cycle's plane before the cycle, for drilling cycles G17.
FC-0502 = The bottom of the hole is not below the R level
    .detail = bottom { $depth }, R { $r }
    .help = Check Z and R, and whether they are absolute or incremental.
FC-0503 = The pecking cycle has no depth of cut
    .detail = { $word }
    .help = Program a depth of cut above zero, on most controls Q.
FC-0504 = The plane changes while a cycle is active
    .help = End the cycle with G80 before the plane changes.
FC-0505 = A cycle without a spindle speed
    .help = Program S and start the spindle before the cycle.
FC-0506 = A reference-point code while a cycle is active
    .detail = { $word }
    .help = End the cycle with G80 before this block.

## Programs

FC-0601 = The call names no program
    .help = Program the number or name of the program to be called.
FC-0602 = The called program does not exist
    .detail = { $program }
    .help = Put the program into the program memory, or check its number or name. At M06 it is the tool change program that is missing (O9001, or the one that [tool_change] of the machine file names): the tool in the spindle is still the old one.
FC-0603 = Calls are nested too deep
    .detail = at most { $limit } levels
    .help = Check whether a program calls itself; otherwise join some of the subprograms.
FC-0604 = The call is repeated too often
    .detail = { $repeats } times, at most { $limit }
    .help = Check the number of repeats, or repeat the call in a loop.
FC-0605 = No program can have this number
    .detail = { $program }
    .help = Use a program number that the control allows.
FC-0606 = The program has no end
    .help = End the main program with M30 or M02, a subprogram with M99, or M17 where the control has that.
FC-0607 = The program ran into the end mark %
    .help = End the program before the mark: with M30 or M02, a subprogram with M99, or M17 where the control has that.
FC-0608 = The program does not come to its end
    .help = Check the conditions of loops and jumps.
FC-0609 = The sequence number to jump to does not exist
    .detail = N{ $number }
    .help = Number the block to jump to, or correct the jump.

## Variables and arithmetic

FC-0701 = Division by zero
    .help = Check the divisor; tan 90 counts as a division by zero too.
FC-0702 = The function is not defined for this value
    .detail = { $name } of { $value }
    .detail-2 = { $name }
    .help = Check the value: roots need zero or more, logarithms more than zero, arc sine and arc cosine -1 to 1.
FC-0703 = There is no such variable
    .detail = { $variable }
    .help = Use a variable that the control has.
FC-0704 = The variable cannot be written
    .detail = { $variable }
    .help = Assign the value to a variable that may be written.
FC-0705 = The result is beyond the numbers of the control
    .help = Check the values that the calculation starts from.

## Machine

FC-0801 = An axis would leave its software limits
    .detail = { $axis } to { $position }, limit { $limit }
    .detail-2 = { $axis }
    .help = Check the work offset, the tool length and the coordinates; the limits stand in the machine file.
FC-0802 = Cutting while the spindle stands still
    .help = Start the spindle with M03 or M04 and a speed S before the first cut.
FC-0803 = The tool is not in the magazine
    .detail = T{ $tool }
    .help = Load the tool, or correct the tool number.
FC-0804 = The spindle does not reach this speed
    .detail = S{ $speed }, at most { $limit }
    .help = Program a lower speed.
FC-0805 = The machine cannot run the move at the programmed feed
    .detail = F{ $feed }, at most { $limit }
    .help = Program a lower feed; the axis speeds stand in the machine file.
FC-0806 = The input that the program waits for does not come
    .help = Check the input and its address, or wait longer.
FC-0807 = An axis is too far from where it is commanded to be
    .detail = { $axis } is { $distance } away, limit { $limit }
    .help = Check whether the axis is blocked, its drive and the limit for the following error.
FC-0808 = An axis does not come into position after its stop
    .detail = { $axis } is { $distance } away, limit { $limit }
    .help = Check the drive, and the width and time for being in position.
FC-0809 = The axis is where no pitch compensation point exists
    .detail = { $axis } at { $position }, the points end at { $limit }
    .help = Check the number of the point at the reference position and the interval of the points.

## Files

FC-0901 = The file cannot be read
    .detail = { $file }: { $reason }
    .detail-2 = { $file }
    .detail-3 = { $reason }
    .help = Check the path and whether the file may be read.
FC-0902 = The file is no program text
    .detail = { $file }
    .help = Give a text file in UTF-8 or GB18030.
FC-0903 = The file holds no block
    .detail = { $file }
    .help = Check that it is the right file and that it was transferred whole.
FC-0904 = The set-up or machine file cannot be used
    .detail = { $file }: { $reason }
    .detail-2 = { $file }
    .detail-3 = { $reason }
    .help = Correct the file where the reason says.
FC-0905 = The control language is not known
    .detail = { $name }
    .help = Name it with --dialect: gsk990mc, weihong, kaitong, fagor8065 or rs274.
FC-0906 = This version does not carry out the code
    .detail = { $word }
    .help = Remove the code, or replace it by others with the same effect.

FC-0907 = A file cannot be written
    .help = Check the path, the free space and the rights of the folder.
    .detail = { $file }: { $reason }
FC-0910 = The output is a file that the command reads
    .help = Give the output another name. Nothing was written.
    .detail = { $file }

FC-0706 = Variable #0 is always empty and cannot be set
    .help = Use another variable.

FC-0707 = The control does not have this macro operation
    .help = Check the H code of G65.

FC-0708 = This address cannot pass an argument to a macro
    .help = Use any letter but G, L, N, O, P and H, each once.

FC-0709 = Macro calls are nested too deep
    .help = Call fewer macros within each other.

FC-0710 = The loop or condition cannot be run
    .help = Give DO and END a label from 1 to 3, a loop that counts a step other than 0, and close every loop and condition.

FC-0711 = The loops do not pair
    .help = Give every DO one END with the same label, and do not let loops cross.

FC-0712 = A jump leads into a loop
    .help = Jump to a block before the loop or behind it.

FC-0713 = The program has set an alarm
    .help = See in the program why it does.
FC-0714 = A program or sequence number cannot be a variable
    .help = Write the number itself behind O or N.

FC-0405 = Scaling is not enabled on this control
    .help = Set bit 60#5 to 1.

FC-0406 = The scale factor is out of range
    .detail = { $min } to { $max }
    .help = Use a factor that the control takes.

FC-0407 = This code is not allowed while scaling is active
    .help = Cancel scaling with G50 first.

FC-0408 = This code is not allowed while rotation is active
    .help = Cancel rotation with G69 first.

FC-0409 = This code is not allowed in polar coordinates
    .help = Cancel polar coordinates with G15 first.

FC-0410 = The plane cannot be changed while rotation is active
    .help = Cancel rotation with G69 first.

FC-0411 = In polar coordinates an arc must be given by R
    .help = Program R instead of I, J, K.

FC-0412 = Units cannot be changed while points are scaled, rotated or polar
    .help = Cancel the transformation first.

FC-0413 = The skip function does not work while points are scaled, rotated or polar
    .help = Cancel the transformation first.

FC-0414 = A reference point return without an axis
    .help = Name the axes that are to return.

FC-0415 = There is no such reference point
    .help = Use a number that the code has: P2, P3 or P4 with G30, H0 to H3 (X, Y, Z, A) with M902.

FC-0416 = The position is not the reference point
    .help = Check the position and the offsets in force.

FC-0417 = Data cannot be set while a canned cycle is active
    .help = Cancel the cycle with G80 first.

FC-0418 = This form of data setting does not exist
    .help = Use L2, L10 to L13, L20, L50 or L51.

FC-0419 = The number of the offset is missing or too large
    .help = Check P.

FC-0420 = The offset value is missing or too large
    .help = Check R.

FC-0421 = Number, bit or value of the parameter is missing or out of range
    .help = Check N, P and R.

FC-0422 = The program cannot set this parameter
    .help = Set it on the parameter page.

FC-0423 = A command while parameters are being set
    .help = End data setting with G11 first.

FC-0507 = The hole's bottom level Z does not lie above the R level
    .help = For back boring give R as the lower level.

FC-0508 = The spindle speed is missing or too high for tapping
    .detail = { $parameter }
    .help = Give S within the limit of tapping.

FC-0509 = Rigid tapping is called while a cycle is active
    .help = Cancel the cycle with G80 before M29.

FC-0310 = The chamfer or corner arc is written wrongly
    .help = Put ,L or ,R with a length at the end of a G01, G02 or G03 block.

FC-0311 = The move behind the chamfer or corner arc is missing
    .help = Let a G01, G02 or G03 move follow at once.

FC-0312 = The chamfer or corner arc is longer than the moves beside it
    .help = Make it smaller, or the moves longer.

FC-0313 = A move beside the chamfer or corner arc leaves the plane
    .help = Move only the two axes of the plane.

FC-0424 = Cutter compensation finds no crossing of two blocks
    .help = Use a smaller tool, or larger moves at this corner.

FC-0425 = Cutter compensation is started or cancelled by an arc
    .help = Start and cancel it on a G00 or G01 move.

FC-0426 = The skip function does not work in cutter compensation
    .help = Cancel compensation with G40 first.

FC-0427 = The plane cannot be changed in cutter compensation
    .help = Cancel compensation with G40 first.

FC-0428 = An arc's end falls on its centre in cutter compensation
    .help = Use a smaller tool or a larger arc.

FC-0429 = The work coordinate system cannot be changed in cutter compensation
    .help = Cancel compensation with G40 first.

FC-0430 = The tool would cut into the part
    .help = Use a smaller tool, or open the corner or the arc.

FC-0431 = Too many blocks without motion in cutter compensation
    .help = Move these blocks before G41 or behind G40.

FC-0432 = An arc about a corner stands outside cutter compensation
    .help = Use G39 only between G41 or G42 and G40.

FC-0433 = A block runs exactly back in cutter compensation
    .help = Do not reverse the path within compensation.

FC-0213 = More axes than may move together
    .help = Split the move, or set bit 9#1 for four axes.

FC-0214 = The tool number has too many digits
    .help = Check T; P206 sets its digits.

FC-0215 = The code needs a word that is missing
    .detail = { $word }
    .help = Add the word to the block.

FC-0216 = No code of the block uses this word
    .help = Remove the word, or add the code that it belongs to.

FC-0217 = Axis words, and no code that moves the axes
    .help = Add G0, G1 or another code of motion; with G80 no axis moves.

FC-0218 = The code needs words of axes
    .help = Name at least one axis.

FC-0219 = These codes cannot stand together
    .help = Put them into blocks of their own. G53 goes with G0 and G1 in G90 alone; of the codes that use the axis words, a block takes one.

FC-0220 = Limits are not taken away
    .help = The code has no effect: no axis leaves its travel. Software limits hold once the axes are homed, so that homing needs nothing taken away.

FC-0221 = There are no latches of encoders to set
    .help = The code has no effect. Homing finds markers by itself, and behind a move that an input ends the control knows where the axes stand.

FC-0314 = Feed per revolution needs a spindle with an encoder
    .help = Use G94, or fit an encoder.

FC-0315 = Scaling makes the coordinate too large
    .help = Use a smaller factor.
FC-0316 = The arc moves an axis beside its plane
    .detail = { $axis }
    .help = Move the axis in a block of its own, or choose the plane that the arc lies in.
FC-0317 = The helix climbs without turning
    .help = Give the arc an end point in the plane, or a full circle by its centre; for a straight move use G01.

FC-0318 = An arc in machine coordinates
    .help = Program G00 or G01 in the block of G53.

FC-0434 = The offset value is too large
    .help = Correct the value in the offset table.

FC-0435 = The intermediate point is too far away
    .help = Check the coordinates of the block.

FC-0436 = A block with / while points are scaled, rotated or polar
    .help = Cancel the transformation before the block.

FC-0437 = An offset is changed while points are scaled, rotated or polar
    .help = Cancel the transformation first.

FC-0438 = G12 needs a block of its own
    .help = Move the other codes to another block.

FC-0439 = The corners of the stroke check make no box
    .help = X, Y, Z must be larger than I, J, K.

FC-0440 = The move enters the area that the stored stroke check forbids
    .help = Change the move, or turn the check off with G13.

FC-0441 = There is no such axis for surface speed
    .help = Use P1 to P4 for an axis of the machine.

FC-0442 = Length compensation in the block of a code that does not allow it
    .detail = { $word }
    .help = Put the length compensation into a block of its own.

FC-0453 = The tool length stays as it is: a canned cycle is in force
    .help = End the cycle with G80 before the tool length changes, or program the length in the block that starts the cycle.

FC-0443 = Scaling is set while cutter compensation is in force
    .help = Program the scaling before G41 or G42, or cancel with G40 first.

FC-0444 = The scaling is incomplete, or has both kinds of factor
    .help = Give the centre of the axes with P, or I, J, K for each axis.

FC-0445 = The mirror names no axis
    .help = Give the coordinate at which each axis is mirrored.

FC-0446 = Too many transformations are in force together
    .help = Cancel each rotation with G69 before the next, also in repeated subprograms.
FC-0447 = The skip move ended without its signal
    .help = Check the probe and its wiring, and that the move reaches far enough; P021.3 says whether this is an alarm.
FC-0451 = The probe has its signal before the move begins
    .help = Move away from the work, or onto it for G38.4, before probing; check the probe and its wiring. G38.3 and G38.5 allow it.

FC-0452 = G29 has no intermediate point to go through
    .detail = { $axis }
    .help = Program G28 or G30 with this axis before G29, or go to the point with G00.

FC-0510 = Rigid tapping without a feed
    .help = Give F in the cycle or before it.

FC-0511 = A speed or a move stands between M29 and the tapping cycle
    .help = Give S in the block of M29, and move the axes before it.

FC-0512 = The plane is changed in rigid tapping
    .help = End rigid tapping with G80 or M28 first.

FC-0513 = The cycle needs a spindle that can stop at an angle
    .help = Use another cycle, or fit such a spindle.

FC-0610 = A macro calls a subprogram
    .help = Call a macro with G65 instead.

FC-0611 = M99 stands in the block of a macro call
    .help = Put M99 into a block of its own.

FC-0612 = The program number is too large
    .help = Use O0 to O99999.
FC-0613 = The sequence number to jump to does not exist
    .detail = { $number }
    .help = Give the block to jump to this sequence number; it must be in the same program.

FC-0908 = A picture is a .png or a .svg file
    .help = Give the output file one of these endings.
    .detail = { $file }

FC-0909 = The setting of the plot cannot be used
    .help = Name axes of the machine, each by its letter, begin before the program ends, end later than you begin, and write an .svg file.
    .detail = { $setting }: { $value }; allowed: { $allowed }

FC-0514 = A milling cycle is called while an axis is mirrored
    .help = Use positive scale factors.

FC-0515 = The step or the distance of the start is too small
    .help = Use a larger L.

FC-0516 = The step or the distance of the start is too large
    .help = Use a smaller L.

FC-0517 = The tool or its helix does not fit
    .help = Use a smaller tool, or a smaller helix factor P269.

FC-0518 = The corner radius is larger than half a side
    .help = Use a smaller corner radius.

FC-0519 = The corner radius is smaller than the tool radius
    .help = Use a larger U or a smaller tool.

FC-0520 = The gap above uncut material is missing
    .help = Give V above 0.

FC-0521 = The first depth of cut is missing
    .help = Give W above 0.

FC-0522 = The depth of cut is missing
    .help = Give Q above 0.

FC-0523 = The radius or first size is missing
    .help = Give I.

FC-0524 = The second size or the distance of the start is missing
    .help = Give J.

FC-0525 = The tool radius is missing
    .detail = { $parameter }
    .help = Give D, and enter a radius for the tool in the offset table.

FC-0526 = The cycle would take too many moves
    .detail = { $parameter }
    .help = Use a larger step or depth of cut.
FC-0527 = Rigid tapping without a spindle speed
    .help = Program S, best in the block of the code that makes tapping rigid.

FC-0528 = A tapping cycle whose pitch was never given
    .help = Program the pitch F, or the threads per inch I, with the cycle.

FC-0529 = The pitch of the thread is given twice
    .detail = { $word }
    .help = Program F or I, not both.
FC-0530 = Holes on a figure without a canned cycle
    .help = Program the canned cycle before the figure; before G34 to G37 with K0, so that it makes no hole itself.
FC-0531 = A canned cycle while Z is scaled
    .help = Cancel the scaling with G50, or leave Z out of it.
FC-0532 = A milling cycle is called while X and Y are scaled differently
    .help = Give X and Y the same factor, or cancel the scaling with G50.

FC-0533 = The feed of the tapping is above the highest cutting feed
    .detail = F{ $feed }, at most { $limit }: the spindle turns at { $speed }
    .detail-2 = F{ $feed }, at most { $limit }
    .help = Lower F and S together. A rigid tap keeps its pitch: its spindle is slowed with the feed. In a floating holder only the feed is lowered, and the thread is spoilt.
FC-0534 = The shortest dwell of a cycle is not below the longest
    .help = Set the parameter of the shortest dwell below that of the longest.
FC-0535 = The cycle makes no hole: the level R or the depth Z is missing
    .help = Program R and Z. Without one of them the tool is only positioned over the places.
FC-0536 = The tool does not move aside in the hole: Q is missing
    .help = Program Q, how far it moves aside. Without, the cutting edge leaves a groove in the bore, and in a back boring the tool goes into the hole with its whole width.
FC-0537 = The cycle makes no hole beside another code of its block
    .detail = { $word }
    .help = Program the cycle in a block of its own, behind the code.

## Canned cycles by parameters

FC-0540 = A parameter of the cycle has a value that it cannot have
    .detail = { $parameter } is { $value }, the limit is { $limit }
    .detail-2 = { $parameter }
    .help = Change the parameter; `explain` and the manual's page of the cycle say what it may hold.
FC-0541 = A parameter that the cycle needs is missing
    .detail = { $parameter }
    .help = Program the parameter behind the code of the cycle.
FC-0542 = The cycle has no depth to cut
    .detail = { $parameter }
    .help = Give the bottom another level than the surface; behind stock left on the floor something must be left to rough.
FC-0543 = The tool is too large for what it is to cut
    .detail = { $parameter }: radius { $value }, at most { $limit }
    .detail-2 = { $parameter }
    .help = Take a smaller tool, make the pocket or hole wider, or leave less stock on its wall. Check the radius in the tool table.
FC-0544 = The tool is so small that a core would stay in the bore
    .detail = { $parameter }: radius { $value }, at least { $limit }
    .detail-2 = { $parameter }
    .help = Take a larger tool, or drill the bore first and give the diameter of the hole.
FC-0545 = The passes are wider than the tool
    .detail = { $parameter } is { $value }, the diameter is { $limit }
    .detail-2 = { $parameter }
    .help = Program a width of at most the tool's diameter, or 0 for three quarters of it.
FC-0546 = A step of 0 stands for the cutting length, and the tool table has none
    .detail = { $parameter }
    .help = Program the step, or enter the cutting length of the tool.
FC-0547 = The number of wall passes is 0 and nothing says how deep one may be
    .detail = { $parameter }
    .help = Program the number of passes, enter the cutting length of the finishing tool, or finish with the roughing tool.
FC-0548 = The tool cannot enter the material at this angle
    .detail = { $parameter }
    .help = Program an angle between 0 and 90 degrees. If there is no room to go down at an angle, take a smaller tool, or program 90 for a tool that may plunge.
FC-0549 = The cycle has no feed
    .detail = { $parameter }
    .help = Program the feed of the cycle or of the stage.
FC-0550 = The number of operations is not whole
    .detail = { $parameter }
    .help = Program a whole number, or a distance that divides the length.
FC-0551 = Points to be left out are not in rising order
    .detail = { $parameter }
    .help = Program the points from the first to the last in the order of the letters. The last point of a range has three digits: 10.013 is 10 to 13.
FC-0552 = The positions are described by too few parameters, or by ones that contradict each other
    .detail = { $parameter }
    .help = Program the parameters of one of the formats, such as length and number, or distance and number.
FC-0553 = A parameter of a cycle without a cycle that has it
    .detail = { $variable }
    .help = Use the variables of a cycle while the cycle is in force, by the letters of its format.
FC-0554 = The control does not have this directive
    .detail = { $word }
    .help = Check the name behind the # sign; G281 to G299, P2D and P3D are the cycles that it describes.
FC-0555 = The cycle does not have this parameter
    .detail = { $parameter }
    .help = Check the name; small and capital letters are told apart, and Greek letters are written as words.
FC-0556 = The parameter does not take this value
    .detail = { $parameter }
    .help = Give a number where a number is wanted, one of its words where it takes words, and [x,y] for a point.
FC-0557 = A part of a cycle stands where it does not belong
    .detail = { $word }
    .help = Put the part right behind its #CYCLE block, once, and only where the cycle has such a part.
FC-0558 = The profile does not exist
    .detail = { $parameter }
    .help = Define the profile with #PROFILE before the cycle that uses it.
FC-0559 = The profile cannot be read
    .detail = { $parameter }, contour { $contour }
    .detail-2 = { $parameter }
    .help = A profile begins with G0, goes on with G1, G2, G3 and the corners G36 and G39, and ends with #ENDPROFILE.
FC-0560 = The profile is open
    .detail = { $parameter }, contour { $contour }
    .detail-2 = { $parameter }
    .help = Let every contour of a pocket end where it begins.
FC-0561 = The profile crosses itself, or contours cross each other
    .detail = { $parameter }, contour { $contour }
    .detail-2 = { $parameter }
    .help = Correct the contours; islands lie within the outer one and do not touch it or each other.
FC-0562 = There is no room for a rounding or chamfer of the profile
    .detail = { $parameter }
    .help = Make it smaller, or the elements beside it longer; it stands between two elements.
FC-0563 = There is no room for the tangential way to or from the profile
    .detail = { $parameter }
    .help = Program a smaller radius, or an entry or exit point further away; 0 is a straight way.
FC-0564 = The plane cannot have these axes
    .detail = { $axis }
    .help = Name three different axes. Arcs and milling cycles need the planes of X, Y and Z, with the tool along the third axis.
FC-0565 = A contour of the pocket has no area
    .detail = { $parameter }, contour { $contour }
    .detail-2 = { $parameter }
    .help = Give the contour elements that go round an area; one that runs back along itself has none.
FC-0566 = An island does not lie inside the pocket
    .detail = { $parameter }, contour { $contour }
    .detail-2 = { $parameter }
    .help = Define the outer contour first, then islands that lie wholly within it.
FC-0567 = The depth profile does not fit its contour
    .detail = { $parameter }
    .help = Begin it where its contour begins, at the surface for the outer contour and at the floor for an island, and let it run on without turning back.
FC-0568 = Sloping walls meet before the pocket is as deep as it should be
    .detail = { $parameter }
    .help = Make the walls of this depth profile steeper, the pocket less deep, or the contours further apart.
FC-0569 = No path beside these walls can be computed exactly enough
    .detail = { $parameter }
    .help = Take out of the profile what is much smaller than the tool, or take another tool radius or finishing stock.
FC-0575 = The tool goes straight down into solid material
    .detail = { $parameter }
    .help = Program an entry angle, enter one for the tool, or drill the pocket first. A tool that cuts over its centre may do without.

FC-0470 = The entry move of cutter compensation is not longer than the tool radius
    .help = Begin further away from the contour: the entry must be longer than the radius.
FC-0471 = The tool does not fit into the arc
    .help = Use a tool whose radius is smaller than the arc's.
FC-0472 = The first move after cutter compensation is an arc
    .help = Leave the contour on a G00 or G01 move.

FC-0319 = Feed per revolution with a spindle speed of 0
    .help = Give S before the move, or use G94.

FC-0320 = The move behind the chamfer or corner arc leaves the plane
    .help = Move only the two axes of the plane there.

FC-0321 = In cutter compensation an arc starts on its centre
    .help = Check I, J and K: they are the distances from the start of the arc to its centre.

FC-0322 = The arc ends where it begins: nothing moves
    .help = A radius gives no full circle. Program its centre by I, J or K, or check the end point.

FC-0448 = A tool change in cutter compensation
    .help = End compensation by G40 first.

FC-0449 = The coordinate systems cannot be shifted in cutter compensation
    .help = End compensation by G40 first.

FC-0450 = A reference return in cutter compensation
    .help = End compensation by G40 first.

FC-0614 = The label was given before
    .help = Give each loop, condition and subprogram a label of its own. A subprogram that was called before its definition cannot be come to from above: put the definitions behind M2, or before the calls.

FC-0615 = No loop or condition with this label is open here
    .help = Check the label. Break and continue end passes of while and do loops alone.

FC-0616 = A return outside a subprogram
    .help = A subprogram begins with sub and is run by call.

FC-0617 = A subprogram is defined within another
    .help = End the first definition by endsub before the next.

FC-0618 = The program is called in the way of the other kind
    .help = What begins with sub is run by call; what begins with its O number alone, by M98.

FC-0619 = More labels than can be meant
    .help = Do not compute labels without end.

FC-0620 = No saved state to restore
    .help = Save it by M70 or M73 in the same subprogram first.

FC-0621 = Programs write no files here
    .help = Remove the comment, or show the text by print or MSG.
FC-0330 = There are no arcs in the planes of U, V and W
    .help = Choose G17, G18 or G19.
FC-0331 = An arc has a radius as well as a centre
    .help = Give R, or the centre by two of I, J and K.
FC-0332 = A centre word does not belong to the plane
    .help = I belongs to X, J to Y, K to Z; only those of the plane's axes may stand.
FC-0333 = An arc by its radius ends where it starts
    .help = Give the centre instead: a radius does not say where a full circle lies.
FC-0334 = Splines lie in the XY plane
    .help = Choose G17.
FC-0335 = Only X and Y move along a spline
    .help = Move the other axes in a block of their own.
FC-0336 = The spline has too few control points
    .detail = { $number } control points, at least { $least } are needed
    .help = Add control points, or give a lower order by L.
FC-0337 = A NURBS ends that was not begun
    .help = Describe its control points with G5.2 first, without another motion code between.
FC-0338 = The spline is too long
    .detail = the limit is { $limit } points
    .help = Divide it into several.
FC-0339 = The probing move has no length
    .help = Start further away from the point that is probed to.
FC-0473 = Cutter compensation does not work in this plane
    .help = Choose G17, or G18.
FC-0474 = Cutter compensation is on already
    .help = Cancel it with G40 first.
FC-0475 = This code is not allowed in cutter compensation
    .help = Cancel compensation with G40 first.
FC-0476 = Cutter compensation with a lathe tool
    .help = Use a tool of orientation 0 or 9; the others are not compensated yet.
FC-0477 = Y turns: no arc, rotation, compensation or figure of holes can lie in its plane
    .help = Choose a plane without Y, or write the shape in straight moves.
FC-0570 = This axis does not move in the cycle
    .detail = { $axis }
    .help = Name the axes of the plane and the one square to it; move others in a block of their own.
FC-0571 = A canned cycle needs another feed mode
    .help = Choose G94 or G95; G93 would give a time to each of its moves.
FC-0572 = The spindle does not turn
    .help = Start it with M3 or M4 before this block.
FC-0573 = The spindle turns the wrong way for this thread
    .help = Tap right-hand threads with M3, left-hand ones with M4.
FC-0574 = The depths of the thread do not fit each other
    .help = I is not 0, J is more than 0, and K is more than J.
FC-0622 = Nothing changes the tool at M6 in this language
    .help = Where the ladder itself changes the tool, or you change it by hand, set program = 0 in [tool_change] of the machine file. The tool in the spindle is still the old one.
FC-0623 = Two programs of the file have one number or name
    .detail = { $program }
    .help = Give each program a number of its own: a call runs the first of them.

# The running control.

FC-1400 = that cannot be done in this mode
    .help = Choose the mode for it first.
    .detail = mode { $mode }
FC-1401 = that cannot be done while a program is under way
    .help = Wait for its end, or give it up with reset.
FC-1402 = a program of another mode is under way
    .help = Go back to its mode to go on with it, or give it up with reset.
    .detail = mode { $mode }
FC-1403 = there is no program to run
    .help = Select a program, or type blocks in MDI.
FC-1404 = the machine does not allow a start now
    .help = Look at the messages of the machine: a door, a pressure, or a clamp may be missing.
FC-1405 = an alarm stands
    .help = Remove its cause, then press reset.
FC-1406 = this control has no part for that
    .help = It was started without a ladder or without a durable memory.
    .detail = missing: { $name }
FC-1407 = there is nothing of this name
    .help = Check the spelling.
    .detail = { $name }
FC-1408 = the program under way cannot be changed
    .help = Wait for its end, or edit another program.
    .detail = program { $name }
FC-1409 = this value cannot be
    .help = Enter a value within the range.
    .detail = { $name }: { $min } to { $max }
    .detail-2 = { $name }
FC-1410 = emergency stop
    .help = Remove the danger, release the button, and bring the axes to their reference points again.
FC-1411 = the program has no block there
    .help = Choose a line of the program.
    .detail = line { $line }
FC-1412 = the ladder stands still
    .help = Correct the ladder and start it again; all outputs are off until then.
FC-1413 = a change was made and could not be kept
    .help = Look at the disk; the change is lost when power goes off.
    .detail = { $reason }
FC-1414 = A program is not taken up again by axes that were not homed
    .detail = axis { $axis }
    .help = Home the axes, then prepare the restart again.
FC-1415 = Another program was interrupted than the one that is selected
    .detail = interrupted: { $name }
    .help = Select the program that was interrupted, or give a line of this one.
FC-1416 = The program or the data are not those of before
    .detail = { $name }
    .help = Prepare the restart again; give the line if the program was changed.
FC-1417 = Tool or spindle are not as the program has them
    .detail = { $name }
    .help = Type the codes that the restart shows in MDI, or have the control send them. A program that has stopped goes on once the spindle turns as shown: turn it on by its key in a manual mode.
FC-1418 = there is no room for more of the program yet
    .help = Send this part again once blocks are done.
FC-1419 = the parameter switch is off
    .help = Turn the parameter switch on, on the setting page, in MDI.
FC-1427 = the program switch is off
    .help = Turn the program switch on, on the setting page, in MDI. It needs level 4.
FC-1428 = this signal is none that can be set
    .help = Data of the ladder can be set: K, T, C and D. Other signals are forced.
    .detail = { $name }
FC-1429 = the axes cannot go back along the path now
    .help = They go back while a program is held by feed hold and they stand on its path: not in a thread, in a dwell, while homing, or with the interlock of motion on. Press feed hold first.

FC-1430 = Homing does not find the home switch
    .detail = axis { $axis }
    .help = Check the home switch, its level, and the direction of homing.
FC-1431 = Homing finds no marker of the encoder
    .detail = axis { $axis }
    .help = Check the marker signal of the encoder, and whether the machine homes with markers at all.
FC-1432 = Emergency stop while homing
    .detail = axis { $axis }
    .help = Release the emergency stop and home the axis again.
FC-1433 = A program moves an axis that was not homed
    .detail = axis { $axis }
    .help = Home the axis, then start the program again.
FC-1434 = The code needs an axis that was homed
    .detail = axis { $axis }
    .help = Home the axis, then start the program again.
FC-1435 = Programs may not home an axis
    .detail = axis { $axis }
    .help = Home the axis by hand.
FC-1436 = An axis is on its travel switch
    .detail = { $axis }{ $side }
    .help = Hold the overtravel release and move the axis back by hand.

## 1460: over a connection

FC-1460 = This leads to lines of the program that are not here
    .help = A program that is sent line by line runs straight on. Store the program first, or call one that is stored.
FC-1461 = Nobody can connect there
    .detail = { $place }: { $reason }
    .help = Choose another port or path, or end what has it.
FC-1440 = There is no block on this line or below it
    .detail = line { $line }
    .help = Give a line of the program at which a block begins.

FC-1441 = The program does not reach the block as often as asked for
    .detail = line { $line } is reached { $passes } times
    .help = Give a lower pass, or a line that is run with the present variables, inputs and switches.

FC-1442 = The order of the axes on the way to a restart is wrong
    .help = Name each axis of the machine exactly once.

FC-1443 = Nothing was interrupted
    .help = Give the line at which the program is to be taken up.

FC-1444 = A program is not taken up again while the axes are under way
    .help = Press reset and wait until the axes stand.

FC-1445 = Values that the machine told the program in the first run are not known
    .detail = { $count } places; the commanded position stands for the machine's
    .help = Check what the program measured before this line, or start before the measuring.

## 1446: messages of the machine

FC-1446 = A message of the machine
    .detail = { $name }
    .help = It comes from the ladder of the machine: the page of alarms and the manual of the machine say what it means. It goes when its cause goes.

FC-1447 = A parameter was changed that holds from the next power-on
    .help = Until then the control goes on as before. Switch the control off and on again, or set the parameter back.

## 1470: measuring

FC-1470 = There is no probe or tool setter
    .detail = { $name }
    .help = Connect it to the skip input, and say so in the parameters.
FC-1471 = The probe touches where it should be free
    .help = Move it away, check its way and its signal, then start measuring anew.
FC-1472 = The probe met nothing
    .detail = { $axis } to { $position }
    .help = Check the nominal size, the centre and the height; raise the overtravel if the part may be there.
FC-1473 = These points give no shape
    .detail = { $name }
    .help = Take the points anew: three that are not in a line for a circle, two on each axis for a slot.
FC-1474 = Axes are not homed
    .detail = axis { $axis }
    .help = Home the axes before measuring.
FC-1475 = The measured size is outside its tolerance
    .detail = { $value }, nominal { $nominal }, tolerance { $limit }
    .help = Nothing was stored. Check part or tool, and measure anew.
FC-1476 = This cannot be measured with such a value
    .detail = { $name }
    .help = Enter every size and angle that this form needs.
FC-1477 = Nothing can be measured now
    .detail = { $name }
    .help = Turn off dry run and the locks, stop the spindle, then start anew.
FC-1478 = The tool setter was not met
    .detail = { $axis } to { $position }
    .help = Check the tool setter, its height and the estimated length of the tool.

## 1480: drives

FC-1480 = The drives do not answer
    .detail = { $place }
    .help = Check power and cable of the board, and the link in the machine file.
FC-1481 = Nothing is heard of the drives any more
    .detail = for { $time } ms
    .help = Check cable and power of the board. Press reset, and home the axes again.
FC-1482 = The connection to the drives is broken
    .detail = { $place }: { $reason }
    .help = Check cable and port of the board. Press reset, and home the axes again.
FC-1483 = The drives cannot do what the machine file asks for
    .detail = { $name }: { $value } asked for, { $limit } possible
    .help = Change the value in the machine file, or take another board.
FC-1484 = An axis is to move faster than it can be stepped
    .detail = axis { $axis }: { $value } steps/s needed, { $limit } possible
    .help = Lower the speeds of the axis, its steps or its pulse times in the machine file.
FC-1485 = The drives have stopped since they heard nothing
    .detail = for { $time } ms
    .help = Check the cable and the load of the computer. Press reset, and home the axes again.
FC-1486 = A setpoint came too late for the drives
    .help = Give the control's thread priority, or make the buffer longer. Press reset, and home the axes again.
FC-1487 = A setpoint was lost on the way to the drives
    .detail = { $count } frames unreadable
    .help = Check the cable, its shield and its length. Press reset, and home the axes again.
FC-1488 = A setpoint was faster than the drives can follow
    .detail = axis { $axis }
    .help = Check the speeds of the axis and its compensation. Press reset, and home the axes again.
FC-1489 = The drives are stopped by the emergency stop
    .help = Remove the danger and release the button. Press reset, and home the axes again.
FC-1490 = The amplifier of an axis reports a fault
    .detail = axis { $axis }
    .help = Read the amplifier's display and its manual. Press reset, and home the axes again.
FC-1491 = The drives have stopped
    .detail = code { $code }
    .help = Look the code up in the manual of the board. Press reset, and home the axes again.
FC-1492 = The spindle of this machine cannot be led by its angle
    .help = Tap with a floating holder. Orientation needs a ladder that asks the spindle's amplifier for it.
FC-1493 = Grbl senders drive a simulated machine alone
    .help = Serve the machine without --grbl, or take a machine file without [drives].
FC-1494 = machine lock is on
    .help = Switch machine lock off first: under it the axes are not where they seem to be.
FC-1495 = blocks were read ahead with the value as it was
    .detail = up to line { $line }
    .help = They run with the old value. To have them run with the new one enter it while the program stands at M00, or before its start.

# The panel in a browser
FC-1500 = The panel is not built
    .help = Build it in the folder hmi with "npm ci" and "npm run build", then Ferrocut again. The control runs all the same.

FC-1501 = The program was not checked to its end
    .detail = behind line { $line }
    .help = It has too many faults, or takes too long. Put right what was found and check again; "ferrocut check" has no bounds.

FC-1502 = The panel is offered to other computers over encrypted connections only
    .detail = { $place }
    .help = Give --tls-cert and --tls-key, or --tls-self-signed. Or keep it on this computer (127.0.0.1) and tunnel it.

FC-1503 = The panel is offered to other computers only where people can log in
    .detail = { $place }
    .help = Give the folder of the memory with --memory, and set a password in it with "ferrocut memory password".

FC-1504 = This certificate or key cannot be used
    .detail = { $file }: { $reason }
    .help = Give a certificate chain and its private key as PEM files, or --tls-self-signed.

FC-1505 = Nothing is kept: programs, offsets and parameters are gone when this ends
    .help = Name a folder to keep them in: --memory /var/lib/ferrocut. One that is empty or missing becomes a new memory.
