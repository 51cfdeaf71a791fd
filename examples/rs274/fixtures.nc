(Two clips in two fixtures, the second one turned; the same program for each.)
G17 G21 G40 G49 G80 G90 G91.1 G94 G61
G10 L2 P1 X-60 Y-20 Z0 R0
G10 L2 P2 X60 Y-20 Z0 R35

o100 sub (one clip: outline and two pockets)
  M73 G91.1
  G0 X-3 Y-3
  G0 Z2
  G1 Z-4 F150
  #<side> = 0
  o110 while [#<side> LT 4]
    o120 if [[#<side> MOD 2] EQ 0]
      #<length> = 36
    o120 else
      #<length> = 26
    o120 endif
    G91 G1 X[#<length> * COS[90 - 90 * #<side>]] Y[#<length> * SIN[90 - 90 * #<side>]] F500
    #<side> = [#<side> + 1]
  o110 endwhile
  G90 G0 Z5
  M98 P200
  G52 X10 Y15
  M98 P200
  G52 X0 Y0
o100 endsub

T2 M6 G43
S5000 M3
G0 Z20
#1 = 1
o300 repeat [2]
  o310 if [#1 EQ 1]
    G54
  o310 else
    G55
  o310 endif
  o100 call
  #1 = [#1 + 1]
o300 endrepeat
G0 Z30
G49
G53 G0 Z100
M5
M30

O200 (a round pocket by a helix)
G0 X8 Y5
G0 Z1
G3 X8 Y5 Z-2 I-3 J0 P3 F200
G3 X8 Y5 I-3 J0
G0 Z5
M99
