# Ladders: faults without a number of the control, and what the command line shows of them.

FC-1101 = A rule of ladders is broken
    .detail = { $word }
    .help = The number of the control says which one.

FC-1102 = The setting of the ladder's run cannot be used
    .detail = { $setting }: { $value }
    .help = Give a signal by its name or address, such as X20.3, and its value behind =.

FC-1420 = The ladder has not finished a code
    .detail = { $word }
    .help = See on the diagnosis page which signal it waits for, put the machine right and press reset.
FC-1421 = The ladder does not take part in rigid tapping
    .help = The signal RGTAP is off: look at what the ladder does with M29.
FC-1422 = This waveform cannot be captured
    .detail = { $value }
    .help = Name axes and signals that the machine has, at least one of them, and not more than there is room for.
FC-1423 = the parameter switch is on
    .help = Turn it off once the parameters are as they should be, or accept it on the setting page.

label-ladder-checked = { $file }: { $steps } steps, { $first } of them in level 1, { $signals } named signals
label-ladder-faults = { $count ->
    [one] 1 fault
   *[other] { $count } faults
}
label-ladder-on = on
label-ladder-off = off
label-ladder-ran = { $time } ms, { $rounds } rounds of level 2, at most { $steps } steps a period
label-ladder-stopped = stopped after { $time } ms
label-ladder-legend = | contact or input on, o off, - not reached; * the line is on behind it
