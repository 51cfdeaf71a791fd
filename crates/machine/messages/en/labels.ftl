# What the command line shows beside alarms.

label-machine = machine
label-control = control
label-guessed = { $dialect } (not named; --dialect chooses another)
label-built-in = { $machine } (built in; --machine names another)
label-time = time
label-cutting = cutting
label-rapid = rapid
label-dwell = dwell
label-tool-changes = tool changes
label-spindle = spindle
label-distance = distance
label-extents = extents
label-moves = moves
label-parts = parts
label-tool = T{ $tool }
label-by-tool = by tool
label-no-moves = no moves
label-no-tool = no tool
label-stopped = stopped by { $code }; cycle start goes on
label-press-enter = press Enter for cycle start
label-ended-by-alarm = stopped by an alarm; what was done until then:
label-written = written: { $file }
label-checked = { $files ->
    [one] 1 file
   *[other] { $files } files
} checked on { $machine }: { $findings ->
    [0] no findings
    [one] 1 finding
   *[other] { $findings } findings
}
label-further = { $count } further findings
