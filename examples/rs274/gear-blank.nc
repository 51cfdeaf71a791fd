%
(Gear blank: rim in three levels, six windows, bore. Tool 1: end mill 6.)
; Sizes are named once; everything else follows from them.
#<rim>      = 40      ; radius of the rim
#<bore>     = 8       ; radius of the bore
#<windows>  = 6
#<tool>     = 3       ; radius of the tool
#<thick>    = 6
#<levels>   = 3
#<_safe>    = 5

o<ring> sub (radius, depth, levels, direction: 1 is counter-clockwise)
  #<level> = 0
  G0 X#1 Y0
  G0 Z1
  o110 while [#<level> LT #3]
    #<level> = [#<level> + 1]
    G1 Z[-#2 * #<level> / #3] F120
    o120 if [#4 EQ 1]
      G3 X#1 Y0 I-#1 F400
    o120 else
      G2 X#1 Y0 I-#1 F400
    o120 endif
  o110 endwhile
  G0 Z#<_safe>
o<ring> endsub [#<level>]

o<slot> sub (angle, inner radius, outer radius, depth)
  #<z> = 0
  o210 do
    #<z> = [#<z> - 1.5]
    o220 if [#<z> LT -#4]
      #<z> = -#4
    o220 endif
    G0 X[#2 * COS[#1]] Y[#2 * SIN[#1]]
    G1 Z#<z> F100
    G1 X[#3 * COS[#1]] Y[#3 * SIN[#1]] F300
    G3 X[#3 * COS[#1 + 20]] Y[#3 * SIN[#1 + 20]] R#3
    G1 X[#2 * COS[#1 + 20]] Y[#2 * SIN[#1 + 20]]
    G2 X[#2 * COS[#1]] Y[#2 * SIN[#1]] R#2
  o210 while [#<z> GT -#4]
  G0 Z#<_safe>
o<slot> endsub

G17 G21 G40 G49 G54 G64 P0.02 G80 G90 G91.1 G94
T1 M6
S6000 M3
M8
G0 Z#<_safe>

(print, bore and rim)
o<ring> call [#<bore> - #<tool>] [#<thick>] [#<levels>] [1]
#<angle> = 0
o300 repeat [#<windows>]
  o<slot> call [#<angle>] [16] [30] [#<thick>]
  #<angle> = [#<angle> + 360 / #<windows>]
o300 endrepeat
o<ring> call [#<rim> + #<tool>] [#<thick>] [#<levels>] [0]
(print, levels of the rim: %d#<_value>)

M9
G53 G0 Z100
M5
M2
%
