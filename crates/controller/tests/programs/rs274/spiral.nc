%
(Turned squares in loops, with saved states, a moved zero, a compensated contour and holes)
#<_count> = 0
#100 = 0
#<_size> = 12
o<square> sub
  M73
  G91 G1 X#1 F[200 + #<_count>]
  Y#1
  X[-#1]
  Y[-#1]
  G90
  #<_count> = [#<_count> + 1]
o<square> endsub [#1 * 2]
G17 G21 G40 G49 G54 G64 P0.01 G80 G90 G94
T2 M6
G43 H2
S2500 M3
M7
G0 Z5
o100 while [#<_count> LT 3]
  G10 L2 P1 R[#<_count> * 20]
  G0 X[#<_count> * 3] Y0
  G1 Z-1 F100
  o<square> call [#<_size> - #<_count>]
  #100 = [#100 + #<_value>]
  G0 Z5
  #<_count> = [#<_count> + 1]
o100 endwhile
G10 L2 P1 R0
G92 X5 Y5
o200 repeat [3]
  G0 X-20 Y-20
  G41.1 D4 G1 X0 Y0 F300
  Y30
  X30
  G2 X40 Y20 J-10
  G1 Y0
  X0
  G40 X-20 Y-20
o200 endrepeat
G92.1
G55
G98 G81 X5 Y5 Z-3 R2 F120 L2
G91 X7 Y1 L4
G90 G80
G93 G1 X0 Y0 F10
G94 F100
M9
M5
M2
%
