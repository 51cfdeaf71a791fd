'Rosette of twelve petals by rotation that nests: every call turns the petal by 30 degrees more.
'Work zero: centre, top face. Each level is deeper, as long as the depth asks for it.
#10=0         'level reached
#11=2.4       'depth
#12=0.8       'a level
G90 G17 G21
S6000 M03
G00 X0 Y0 Z5
G65 P"LEVEL" L=int(#11/#12+0.5)
G00 Z20
M05
M30

O"LEVEL"
#10=#10+#12
IF(#10>#11)#10=#11
G65 P"PETAL" L12
'Twelve turns taken back.
G65 P"BACK" L12
M17

O"PETAL"
G00 X8 Y0
G01 Z=-#10 F150
G02 X40 Y0 R18 F1200
G02 X8 Y0 R18
G00 Z2
G68 X0 Y0 R30
M17

O"BACK"
G69
M17
