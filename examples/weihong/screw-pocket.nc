'Round pocket of 60, 9 deep, entered by a helix of three turns (K is its pitch), finished by compensation.
'Work zero: centre, top face. T1: end mill 10, its radius in offset 1.
G90 G17 G21 G40
T1 M06
S6000 M03
G00 X10 Y0 Z5 M08
G01 Z0 F600
G03 X10 Y0 I-10 J0 Z-9 K3 F800
G03 X10 Y0 I-10 J0
G04 P300      'coolant washes the chips out
'Rings outwards by 7 mm, the last leaves 0.5 for finishing.
#20=17
G65 P"RING" L2
G01 X24.5 Y0
G03 X24.5 Y0 I-24.5 J0
'The wall: tool left of the path, in and out along half circles.
G00 Z2
X10 Y0
G04 P300
G01 Z-9 F600
G01 G41 X20 Y-10 D01 F500
G03 X30 Y0 R10
G03 X30 Y0 I-30 J0
G03 X20 Y10 R10
G01 G40 X10 Y0
G00 Z50 M09
M05
M30

O"RING"
IF(#20<24) G01 X=#20 Y0
IF(#20<24) G03 X=#20 Y0 I=-#20 J0
#20=#20+7
M17
