# The durable memory: what can be wrong with it, who may change it, and what the command line shows of it.

FC-1201 = The memory of the control is damaged
    .detail = { $detail }. The newest good state is commit { $commits } of { $time }; take it up with: { $command }
    .help = Nothing was changed. "ferrocut memory check" shows what was found and the good states that there are; "ferrocut memory recover" takes the newest one up and keeps the damaged files. Replace a disk that damages files.
FC-1202 = Another process has the memory open
    .help = End the running control first, or wait until it has ended.
FC-1203 = The memory was written by a later version
    .help = Use that version, or restore a backup that it made for this one.
FC-1204 = The memory is that of another control
    .detail = { $name }
    .help = Name the folder of the control's own memory, or the control that it belongs to.
FC-1205 = The disk refuses the memory of the control
    .detail = { $reason }
    .help = See whether the disk is full, read-only or broken. What was confirmed before is still there.
FC-1206 = The memory does not take a value
    .detail = { $name } = { $value }: { $min } to { $max }
    .detail-2 = { $name } = { $value }: { $min } or more
    .detail-3 = { $name } = { $value }: { $max } or less
    .detail-4 = { $whole } = { $value }: only whole numbers
    .detail-5 = { $unknown }: the control has no such parameter
    .detail-6 = { $name } = { $value }
    .help = Give a value within the range of the control's list; nothing was changed.
FC-1207 = The memory has no room for more of this kind
    .help = Delete what is no longer needed. Keep programs above 16 MB in files.
FC-1208 = There is no memory of a control in the folder
    .detail = { $file }
    .help = Name the folder that holds memory.db, not a file. "ferrocut memory restore" makes one of a backup.
FC-1209 = The file is no backup that this version reads
    .detail = { $file }, version { $version }
    .detail-2 = { $file }
    .help = Name a file that "ferrocut memory backup" or the control has made. A backup of a later version needs that version.
FC-1210 = The backup is damaged
    .detail = { $file }, line { $line }
    .detail-2 = line { $line }
    .help = Nothing was restored. Copy the file again from where it was made, or take another backup.
FC-1211 = The backup is that of another control
    .detail = { $name }
    .help = Restore it into the memory of such a control; parameters and tables of another mean other things.
FC-1212 = The backup does not hold what is to be restored
    .help = "ferrocut memory check" shows what it holds.
FC-1213 = A higher level of rights is needed
    .detail = level { $needed }, present level { $level }
    .help = Log in with that level, or have someone do it who has the password.
FC-1214 = A parameter forbids the change
    .detail = { $parameter }
    .help = Whoever may change the parameter can lift it.
FC-1215 = The program is locked by a higher level
    .detail = level { $level }
    .help = Have it unlocked by that level.
FC-1216 = A part program may not change this
    .help = Change it at the panel.
FC-1217 = The level has no password yet, and nobody has its rights
    .detail = level { $level }
    .help = Set the password of level 1 at the machine, then those of the other levels. Until then nobody can log in.
FC-1218 = The password is wrong
    .help = Try again; after three wrong passwords the next try has to wait.
FC-1219 = The password is too short or too long
    .help = Take at least 8 characters, for instance three words.
FC-1220 = Too many wrong passwords
    .detail = wait { $time } s
    .help = Try again after this time.
FC-1221 = The position is not restored while the control runs
    .help = The control knows where its axes stand; another moment's position would be wrong. Switch it off and use "ferrocut memory restore" with this item.

label-finding-missing = memory.db is not there
label-finding-structure = structure of memory.db: { $said }
label-finding-schema = the tables are not those of this memory
label-finding-row = a row of the table { $table } was changed by no one
label-finding-total = rows of the table { $table } have vanished or come back
label-finding-commits = { $found } commits are there, { $reported } were confirmed
label-finding-mark = the file "mark", which counts the confirmed commits, cannot be read
label-memory-folder = memory
label-memory-control = control
label-memory-commits = commits
label-memory-whole = { $file }: whole, { $commits } commits
label-memory-backup-whole = { $file }: whole, a backup of { $control } at { $time }
label-memory-rows = rows
label-memory-damaged = { $file }: damaged
label-memory-good-states = good states, the newest first:
label-memory-no-good-state = no good state is left: restore a backup into a new folder
label-memory-in-database = the database itself
label-memory-lost = { $count ->
    [one] 1 confirmed commit is missing
   *[other] { $count } confirmed commits are missing
}
label-memory-recovered = recovered: commit { $commits } of { $time }; the damaged files are in { $file }
label-memory-no-such-state = there is no good state with commit { $commits }
label-memory-restored = restored into { $folder }: { $items }
label-memory-passwords = levels with a password
label-memory-none = none
label-memory-password-set = password of level { $level } set
label-memory-empty = nothing stored
label-item-programs = part programs
label-item-parameters = parameters that are not as delivered
label-item-offsets = tool offsets with wear
label-item-zeros = work zeros
label-item-reference-points = reference points
label-item-variables = macro variables
label-item-pitch = points of the pitch tables
label-item-plc = kept signals of the ladder, blocks of 64 bytes
label-item-counters = counters
label-item-alarms = alarm history
label-item-log = operation log
label-item-position = position at power-off
label-item-interrupted = interrupted program
label-item-ladder = ladder in the place of the machine's own
