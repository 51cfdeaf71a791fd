'Hinge plate on a router whose public.dat makes codes of its own (hinge-plate.machine.toml names it):
'M10 and M11 clamp and release by air, S waits for the spindle, G83 pecks as this shop wants it.
'Work zero: lower left corner, top face. T1: drill 5.
G90 G17 G21 G49 G40
M10
T1 M06
S3000 M03
G00 X0 Y0 Z30
G98 G83 X15 Y12 Z-20 R2 Q8 F250
X55
Y48
X15
G80
M05
G00 Z60
M11
M30
