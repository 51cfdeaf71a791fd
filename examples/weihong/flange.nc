'Cover flange, 120 x 80: a circle, two arcs and a row of holes, each figure one block.
'Work zero: centre of the top face. T1 drill 6, T2 drill 4.2, T3 tap M5.
G21 G17 G90 G40 G49 G80
G54
T1 M06
S1800 M03
G00 X0 Y0 Z50 M08

'Eight holes of 6 on a circle of 60, from 12 o'clock, clockwise. Clear of the clamps: G98.
G98 G83 Z-14 R2 Q4 F180 K0
G34 X0 Y0 I30 J90 K8

'The bore in the middle, by the same cycle.
X0 Y0
G80

T2 M06
S2400 M03
'Three holes on the left, three on the right, at 10 degrees from each other.
G00 Z20
G99 G81 Z-16 R2 F150 K0
G36 X0 Y0 I52 J10 P10 K3
G36 X0 Y0 I52 J190 P10 K3
'A row along the lower edge.
G35 X-40 Y-34 I16 J0 K6
G80
G00 Z50

T3 M06
S400 M03
'The six of the two groups are tapped M5, pitch 0.8.
G00 Z20
G98 G84 Z-12 R4 P100 F=400*0.8 K0
G36 X0 Y0 I52 J10 P10 K3
G36 X0 Y0 I52 J190 P10 K3
G80
M05 M09
G00 X0 Y0 Z50
M30
