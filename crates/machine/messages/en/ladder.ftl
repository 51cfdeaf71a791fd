# Ladders: faults without a number of the control, and what the command line shows of them.

FC-1101 = A rule of ladders is broken
    .detail = { $word }
    .help = The number of the control says which one.

FC-1102 = The setting of the ladder's run cannot be used
    .detail = { $setting }: { $value }; allowed: { $allowed }
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
FC-1424 = the ladder that runs is not that of the machine file
    .help = It was put in its place while the machine ran, and is kept. To have the machine's own again, roll it back or exchange it.
FC-1425 = the kept ladder cannot be run: the machine's own runs
    .help = Exchange it for a corrected one; the exchange takes the place of what is kept.
    .detail = line { $line }
FC-1426 = the new ladder stopped and was taken out again
    .help = The one of before runs. Look for an endless loop or too many steps in level 1.

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
