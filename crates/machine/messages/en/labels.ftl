# What the command line shows beside alarms.

label-machine = machine
label-control = control
label-guessed = { $dialect } (not named; --dialect chooses another)
label-guessed-content = { $dialect } ({ $unread } of { $blocks } blocks are not { $other }; --dialect chooses another)
label-guessed-extension = { $dialect } (by the extension of the file; --dialect chooses another)
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
label-times = the program came to it { $count } times

## Explanations

label-error = error: { $text }
label-near = { $text }; near it: { $names }
label-unknown = { $name } is nothing that { $dialect } knows
label-no-code = { $dialect } has no code { $name }
label-no-alarm = { $dialect } has no alarm { $name }
label-no-variable = { $dialect } has no variable #{ $name }
label-no-parameter = { $dialect } has no parameter { $name }
label-no-parameters = { $dialect } has no parameters
label-no-sign = { $dialect } writes its arithmetic parameters without a sign: { $name }
label-several-parameters = { $name } is the symbol of several parameters: { $names }
label-whole-bits = { $name } has several bits: name one, as in { $name }.1
label-malformed-name = { $name } names no parameter: write P270, NO43.1 or the symbol
label-out-of-range = { $name } cannot be { $value }: it must be { $range }
label-any-number = a number
label-not-a-bit = { $name } cannot be { $value }: it is a bit, 0 or 1
label-not-whole = { $name } cannot be { $value }: it is a whole number
label-value-changed = { $value } (default { $default })
label-explain-form = form
label-explain-group = group
label-explain-modal = modal
label-explain-one-block = in its block only
label-explain-modal-depends = modal or not as parameters and form say
label-explain-at-power-on = in force at power-on
label-explain-replaces = group with
label-explain-does = does
label-explain-section = manual
label-explain-note = note
label-explain-not-done = this version does not carry it out
label-explain-forms = forms
label-explain-parameters = parameters
label-explain-alarms = alarms
label-explain-codes = codes
label-explain-no-meaning = the manual names it without a meaning; the builder of the machine gives it one
label-explain-timing = when
label-explain-with-motion = starts with the motion of its block
label-explain-after-motion = after the motion of its block
label-explain-class = done by
label-explain-program-control = the control, as order of the program
label-explain-internal = the control
label-explain-plc = the ladder of the machine
label-explain-alone = block
label-explain-own-block = no other code of this kind in its block
label-explain-meaning = meaning
label-explain-one = 1
label-explain-zero = 0
label-explain-value = value
label-explain-default = default
label-explain-range = range
label-explain-bit = 0 or 1
label-explain-no-range = the manual prints none
label-explain-whole = whole numbers
label-explain-axis = axis
label-explain-room = part
label-explain-other-room = { $room }; kept with its value, this version does nothing with it
label-explain-help = what to do
label-explain-source = from
label-explain-raised_by = raised by
label-explain-shown_as = shown as
label-explain-numbers = numbers
label-explain-access = access
label-explain-read = read only
label-explain-write = write only
label-explain-read-write = read and write
label-explain-access-unknown = the manual does not say
label-explain-this_one = this one
label-explain-external = external offset
label-explain-notes = notes
label-explain-part_of = part of
label-explain-no-variable = not described by the manual; programs cannot use it
label-explain-place = place
label-explain-used_by = read by
label-explain-in_force = in force
label-explain-no-block = { $file }, line { $line }: there is no block
label-explain-no-word = { $file }, line { $line }, column { $column }: there is no word
label-explain-no-word-there = { $file }, line { $line }, column { $column }: there is no word; the words of the line and their columns: { $words }
label-explain-comment = { $file }, line { $line }, column { $column }: a comment
label-explain-no-line = { $file } is a file: name a line of it, { $file }:12, or a line and a column, { $file }:12:5
label-explain-drawing = { $file } is a { $kind } drawing, which has no words of a program: "ferrocut import" makes a program of it
label-room-acceleration = acceleration
label-room-bus-servo = servo drives and bus
label-room-canned-cycles = canned cycles
label-room-compensation = compensation
label-room-coordinates = coordinates
label-room-display = display
label-room-feed = feed
label-room-homing = reference points
label-room-io = inputs and outputs
label-room-limits = limits
label-room-lookahead = look-ahead
label-room-macro = macros
label-room-other = other
label-room-plc = ladder
label-room-program-edit = program editing
label-room-security = rights
label-room-spindle = spindle
label-room-tapping = tapping
label-room-tool-change = tool change
label-room-tool-life = tool life
label-class-program = the part program
label-class-macro = a macro statement
label-class-operation = the operation of the panel
label-class-homing = the reference points
label-class-storage = the program memory
label-class-servo = a feed drive
label-class-spindle = the spindle
label-class-overtravel = an axis beyond its limits
label-class-plc = the ladder
label-class-system = the control itself

## Machine files and parameters

label-warning = warning: { $text }
label-exists = { $file } exists already and was not changed
label-nothing-written = nothing was written
label-no-assignment = { $text } sets nothing: write NAME=VALUE
label-no-number = { $name } cannot be { $value }: that is no number
label-set-twice = { $name } is set twice
label-named-twice = { $name } is the same parameter as { $other }
label-lower-above-upper = { $first } must be below { $second }, of which it is the other limit
label-same-axis = { $first } and { $second } name the same axis; the control would take X, Y, Z, A
label-both-bits = { $first } and { $second } cannot both be 1
label-passed-over = { $file }: { $reason }; passed over
label-no-room = there is no room { $name }; the rooms are { $names }
label-no-column = { $file } has no column { $name }
label-no-row = { $file }, line { $line }: no row of a table
label-row-twice = { $name } stands in line { $line } already
label-imported = { $changed ->
    [0] no value
    [one] 1 value
   *[other] { $changed } values
} changed, { $same } as before
label-params-name = name
label-params-symbol = symbol
label-params-value = value
label-params-default = default
label-params-range = range
label-params-unit = unit
label-params-room = room
label-params-use = use
label-params-kept = kept
label-params-used = used
label-params-meaning = meaning
label-params-unchanged = none of these parameters differs from its default
label-params-no-match = no parameter of { $dialect } matches { $name }
label-params-checked = { $parameters ->
    [one] 1 parameter
   *[other] { $parameters } parameters
} of { $file } checked: { $findings ->
    [0] no findings
    [one] 1 finding
   *[other] { $findings } findings
}
label-machine-axis = axis
label-machine-kind = kind
label-machine-linear = linear
label-machine-rotary = rotary
label-machine-limits = limits
label-machine-rapid = rapid
label-machine-cutting = cutting
label-machine-acceleration = acceleration
label-machine-jerk = jerk
label-machine-unlimited = not limited
label-machine-control = control
label-machine-period = servo period
label-machine-spindle-name = spindle
label-machine-tool-change-name = tool change
label-machine-tools = { $tools ->
    [one] 1 tool
   *[other] { $tools } tools
}
label-machine-tolerance-name = tolerance
label-machine-exact-stop = exact stop at every joint
label-machine-parameters = parameters
label-machine-dialect = there is no control language { $name }
label-machine-no-axis = programs of { $dialect } cannot name axis { $axis }
label-machine-travel = axis { $axis }: a travel of { $value } mm is longer than any machine's; is max in mm?
label-machine-zero = axis { $axis }: machine position 0 lies outside min and max, where programs start if the set-up names no start
label-machine-fast = axis { $axis }: a rapid of { $value } mm/min is beyond any machine; are these mm/min?
label-machine-velocity = axis { $axis }: cutting at { $value } mm/min is faster than rapid
label-machine-sluggish = axis { $axis }: it takes { $value } s to reach rapid speed; is acceleration in mm/s², not m/s²?
label-machine-abrupt = axis { $axis }: an acceleration of { $value } reaches rapid speed within { $limit } s; is it in mm/s²?
label-machine-jerk-low = axis { $axis }: with this jerk it takes { $value } s to build up the acceleration; is jerk in mm/s³? 0 is not limited
label-machine-smoothing-differs = axis { $axis }: after_cutting is not that of the other axes; lines are bent where speed changes
label-machine-pitch-off = axis { $axis }: pitch_errors without start and interval, and no parameter of the control that says where the points lie; nothing is compensated
label-machine-spindle = the spindle's { $value } r/min are beyond any machine
label-machine-spindle-sluggish = the spindle takes { $value } s to reach its highest speed; is acceleration_rpm_s in r/min per second?
label-machine-tolerance = a path that may be { $value } mm off cuts no part; is tolerance in mm?
label-machine-tool-change = a tool change takes { $value } s; is time_s in seconds?
label-machine-file-missing = { $file } is named here and cannot be read beside the machine file: { $reason }
label-public-missing = public_programs names { $file }, which cannot be read ({ $reason }), and any code may be a program in it: put the file there, name another with --public, or take the line out
label-linuxcnc-file = it is for programs of rs274, and { $dialect } is the language that is named: leave one of the two out
label-quote-bits = Names of bit parameters stand in quotation marks: "NO43.1" = 1

## Drawings

label-drawing-by-name = { $file }: read as a { $kind } drawing (by its name)
label-drawing-by-content = { $file }: read as a { $kind } drawing (by its content)
label-stage-read = reading the drawing
label-stage-plan = planning the order
label-stage-write = writing the program
label-stage-prove = running through the program
label-drawing-made = { $file }: { $kind }, { $wide } x { $high } mm, { $curves } cuts over { $cut } mm, { $ways } times lowered, { $way } mm in the air

## Plots

label-plot-title = { $program } on { $machine }
label-plot-note = Differences over the servo period of { $period } ms; jerk is a mean over { $window } ms. Dashed: what is allowed.
label-plot-speed = speed along the path and programmed feed (dashed), mm/min
label-plot-velocity = velocity { $axis }, { $length }/min; limits of cutting and positioning
label-plot-acceleration = acceleration { $axis }, { $length }/s²
label-plot-jerk = jerk { $axis }, { $length }/s³
label-plot-error = path error and tolerance (dashed), mm
label-plot-peak = highest { $value } at { $time } s, line { $line }
label-plot-time = time since motion began, s

## Pictures of paths

label-view-top = TOP
label-view-isometric = ISOMETRIC
label-view-start = start
label-view-end = end
label-view-zero = work zero
label-view-rapid = rapid
label-view-cut = cut
label-view-depths = cut, shallow to deep
label-view-nothing = no moves
label-view-no-axes = no moves of X, Y or Z
label-view-depth = Z mm
label-view-length = { $length } mm
label-view-work = work coordinates, mm
label-view-machine = machine coordinates, mm
label-view-moves = { $count ->
    [one] { $shown } move
   *[other] { $shown } moves
}
label-view-rapids = { $count ->
   *[other] { $shown } rapid
}
label-view-cuts = { $shown } cut over { $length } mm
label-view-along = { $length } mm along X, Y, Z
label-view-memory = not enough memory for the picture
label-view-encoding = the picture cannot be written as PNG: { $reason }

## Restart

label-restart-at = taken up at line { $line }, reached for time { $pass }
label-restart-position = block begins at
label-restart-modal = program / machine before
label-restart-sent = sent first
label-restart-approach = the axes go there
label-restart-nothing = nothing
label-restart-group = G group { $group }
label-restart-feed = F
label-restart-feed-per-turn = F of a turn
label-restart-speed = S
label-restart-spindle = spindle
label-restart-flood = coolant
label-restart-mist = mist
label-restart-tool = T
label-restart-in-spindle = tool in the spindle
label-restart-length = H
label-restart-radius = D
label-restart-zero = zero of { $axis }
label-restart-tool-length = tool length on { $axis }

## Machine and set-up files

label-unknown-parameter = { $name }: the control has no such parameter
label-too-many-parameters = too many parameters: no control has more than { $max }
label-config-positive = { $what } is { $value }: it must be above 0
label-config-not-negative = { $what } is { $value }: it must be 0 or more
label-config-range = { $what } is { $value }: it must be { $min } to { $max }
label-config-count = { $what }: there are { $value }, there may be { $min } to { $max }
label-config-twice = { $what } stands twice
label-config-finite = { $what } is { $value }: it must be a finite number
label-config-no-machine = this is no machine file: it has no axes; "ferrocut machine new" writes one to start from
label-config-order = { $what }: min { $min } must be below max { $max }
label-config-unequal = { $what }: there are { $value }, and { $count } of { $other }: there must be as many
label-config-either = { $what }: it needs either { $one } or { $other }
label-config-no-axis = { $what }: the machine has no such axis
label-config-step = { $what } is { $value }: it must be a step, { $min }, or more, since the axis comes to its place after the command
label-config-lag = { $what } is { $value }: at its highest speed the axis is { $min } behind, by what waits in the buffer
label-config-parameter = [parameters] { $reason }: change or remove it
label-config-null-variable = { $what }: #0 is always empty and cannot be set; remove it
label-config-variables = { $what }: there is no room for so many variables; remove some
label-config-work-offset = [work_offsets] { $name }: the control has G54 P1 to P{ $max }; change or remove it
label-config-tool = [tools.{ $number }]: the control has offset numbers 1 to { $max }; change or remove it
label-config-no-place = { $name }: no place for another axis; remove one of u, v, w
label-config-var-line = line { $line }: a number from 1 to { $max } and a value belong there
label-config-tool-word = line { $line }: { $word } is no word of a tool table
label-config-no-tool = line { $line }: no T word says which tool it is
label-config-tool-twice = line { $line }: tool T{ $tool } stands twice; remove one
label-config-tools = line { $line }: more than { $max } tools
