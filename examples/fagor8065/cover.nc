; COVER 120 X 80 X 20, CYCLES OF THE EDITOR
; ZERO: LOWER LEFT CORNER, TOP FACE; 1 MM STOCK ON THE FACE
; T1 FACE MILL 40, T2 END MILL 12, T3 END MILL 8, T4 CENTRE DRILL, T5 DRILL 8.5, T6 TAP M10, T7 THREAD MILL 10
G17 G71 G90 G94 G54
M8

N10 ; THE FACE: TWO ROUGH LEVELS LEAVE 0.2
#CYCLE G290 [X=0, Y=0, L=120, H=80, Z=1, ZS=10, P=1, strategy=bidir_x, begin=ll]
#ROUGH [step=28, E=2, I=1, FZ=400, F=1200, S=2000, T=1, D=1]
#FINISH [deltaz=0.2, step=30, F=800, S=2500, T=1, D=1]

N20 ; A POCKET TURNED BY 15 DEGREES, ITS CORNERS R8; IN UNDER 5 DEGREES
#CYCLE G287 [X=60, Y=42, start=centre, L=56, H=34, alpha=15, corner=round, r=8, Z=0, ZS=5, P=9]
#ROUGH [step=8, I=3, FZ=200, beta=5, F=700, S=2800, T=2, D=1, dir=ccw]
#FINISH [delta=0.3, deltaz=0.2, step=5, N=1, theta=5, F=400, S=3500, T=3, D=1, dir=ccw]

N30 ; FOUR CORNER HOLES: CENTRED, DRILLED, TAPPED
#CYCLE G281 [X=10, Y=10, Z=0, ZS=5, mode=angle, alpha=90, phi=9, F=120, S=2500, T=4, D=1, next=5]
#MULTI GRID [LX=100, NX=2, LY=60, NY=2]
#CYCLE G283 [X=10, Y=10, Z=0, ZS=5, P=24, I=8, B=1, F=180, S=1100, T=5, D=1, next=6]
#MULTI GRID [LX=100, NX=2, LY=60, NY=2]
#CYCLE G284 [X=10, Y=10, Z=0, ZS=5, P=20, type=rigid, feedtype=rev, F=1.5, S=300, T=6, D=1]
#MULTI GRID [LX=100, NX=2, LY=60, NY=2]

N40 ; A THREAD M24 X 1.5 IN THE FLOOR OF THE POCKET, ITS CORE BORED ON A HELIX FIRST
#CYCLE G298 [X=60, Y=42, Z=-9, ZS=5, P=11, phi=22.5, B=1.5, dir=ccw, bottom=yes, F=300, S=3000, T=2, D=1]
#CYCLE G299 [X=60, Y=42, Z=-9, ZS=5, P=9, phi=24, K=0.92, B=1.5, alpha=0, step=0.5, delta=0.1, side=internal, dir=ccw, cut=up, tool=full, F=300, S=2500, T=7, D=1]

G0 Z100 M9
M5
M30
