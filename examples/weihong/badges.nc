'Name badges, 3 columns by 2 rows, out of one sheet: the badge is written once, G992 moves its zero.
'Work zero: lower left corner of the sheet, top face. T1: engraver.
#1=46         'pitch in X, mm
#2=31         'pitch in Y
#3=3          'columns
#4=2          'rows
#5=0.3        'depth of the engraving
G90 G17 G21
T1 M06
S6000 M03
G00 Z5
G65 P"ROW" L=#4
G992 J=-#2*#4
G00 X0 Y0 Z30
M05
M30

O"ROW"
G65 P"BADGE" L=#3
G992 I=-#1*#3
G992 J=#2
M17

O"BADGE"
'Rounded frame of 40 x 25.
G00 X6 Y3
G01 Z=-#5 F200
G01 X40 F900
G03 X43 Y6 R3
G01 Y25
G03 X40 Y28 R3
G01 X6
G03 X3 Y25 R3
G01 Y6
G03 X6 Y3 R3
G00 Z2
'A wave of two halves; the second is the first one mirrored.
G65 P"HALF"
G51.1 X23
G65 P"HALF"
G50.1
G992 I=#1
M17

O"HALF"
G00 X9 Y15
G01 Z=-#5 F200
G02 X16 Y15 I3.5 J0 F900
G03 X23 Y15 I3.5 J0
G00 Z2
M17
