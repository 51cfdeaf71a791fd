# FC-1520 to FC-1539: forms of cycles.

FC-1520 = The editor has no such cycle
    .detail = { $name }
    .help = Choose one of the list.

FC-1521 = The value is out of its range
    .detail = { $parameter }: { $min } to { $max }
    .help = Give a value between the limits; counts and numbers are whole.

FC-1522 = The choice has no such word
    .detail = { $parameter }
    .help = Choose one of the words that the field offers.

FC-1523 = The name cannot stand in a program
    .detail = { $parameter }
    .help = Begin with a letter and use letters, digits and underscores only, at most 32.

FC-1524 = The cycle cannot be repeated on these positions
    .help = Give one figure, with no more points than it takes; some cycles take none.

FC-1525 = The profile does not fit the cycle
    .help = Give the contours that the cycle needs, closed for a pocket, with corners not larger than their sides; point to point takes up to 25 points joined by lines.

FC-1526 = The cycle would be too long as blocks
    .detail = { $limit }
    .help = Use larger steps, or make it in several cycles.

FC-1527 = This control has no cycle that taps in step in this way
    .detail = { $name }
    .help = Set the withdrawal factor to 1, choose tapping with a compensating chuck, or check the tapping parameters of the control.

FC-1528 = The cycle cannot be written in this control language
    .detail = { $name }
    .help = Change the values that the control cannot follow, such as stops of the spindle at an angle, M functions or tool numbers.
