# What the command line shows beside alarms, in Russian.

label-machine = станок
label-control = ЧПУ
label-guessed = { $dialect } (не указан; выбор ключом --dialect)
label-guessed-content = { $dialect } ({ $unread } из { $blocks } кадров не подходят к { $other }; выбор ключом --dialect)
label-guessed-extension = { $dialect } (по расширению файла; выбор ключом --dialect)
label-built-in = { $machine } (встроенный; другой задаёт --machine)
label-time = время
label-cutting = резание
label-rapid = быстрый ход
label-dwell = паузы
label-tool-changes = смены инструмента
label-spindle = шпиндель
label-distance = путь
label-extents = габариты
label-moves = перемещения
label-parts = детали
label-tool = T{ $tool }
label-by-tool = по инструментам
label-no-moves = перемещений нет
label-no-tool = без инструмента
label-stopped = остановлено кодом { $code }; продолжение пуском цикла
label-press-enter = для пуска цикла нажмите Enter
label-ended-by-alarm = остановлено аварией; до неё сделано:
label-written = записан файл { $file }
label-checked = { $files ->
    [one] проверен { $files } файл
    [few] проверены { $files } файла
    [many] проверено { $files } файлов
   *[other] проверено { $files } файла
}, станок { $machine }: { $findings ->
    [0] замечаний нет
    [one] { $findings } замечание
    [few] { $findings } замечания
    [many] { $findings } замечаний
   *[other] { $findings } замечания
}
label-further = ещё замечаний: { $count }
label-times = программа дошла до этого места { $count } { $count ->
    [one] раз
    [few] раза
   *[other] раз
}

## Explanations

label-error = ошибка: { $text }
label-near = { $text }; похожие: { $names }
label-unknown = для { $dialect } имя { $name } ничего не значит
label-no-code = в { $dialect } нет кода { $name }
label-no-alarm = в { $dialect } нет аварии { $name }
label-no-variable = в { $dialect } нет переменной #{ $name }
label-no-parameter = в { $dialect } нет параметра { $name }
label-no-parameters = в { $dialect } нет параметров
label-no-sign = { $dialect } пишет свои арифметические параметры без знака: { $name }
label-several-parameters = символ { $name } есть у нескольких параметров: { $names }
label-whole-bits = у { $name } несколько битов: назовите один, например { $name }.1
label-malformed-name = { $name } не имя параметра: напишите P270, NO43.1 или символ
label-out-of-range = { $name } не может быть { $value }: допустимо { $range }
label-any-number = число
label-not-a-bit = { $name } не может быть { $value }: это бит, 0 или 1
label-not-whole = { $name } не может быть { $value }: это целое число
label-value-changed = { $value } (по умолчанию { $default })
label-explain-form = формат
label-explain-group = группа
label-explain-modal = модальный
label-explain-one-block = только в своём кадре
label-explain-modal-depends = модальный или нет в зависимости от параметров и формата
label-explain-at-power-on = действует при включении
label-explain-replaces = в группе с
label-explain-does = действие
label-explain-section = руководство
label-explain-note = примечание
label-explain-not-done = эта версия его не выполняет
label-explain-forms = формы
label-explain-parameters = параметры
label-explain-alarms = аварии
label-explain-codes = коды
label-explain-no-meaning = в руководстве назван без значения; значение задаёт изготовитель станка
label-explain-timing = когда
label-explain-with-motion = начинается вместе с перемещением своего кадра
label-explain-after-motion = после перемещения своего кадра
label-explain-class = выполняет
label-explain-program-control = ЧПУ, как команду программы
label-explain-internal = ЧПУ
label-explain-plc = программа ПЛК станка
label-explain-alone = кадр
label-explain-own-block = в его кадре не должно быть других таких кодов
label-explain-meaning = назначение
label-explain-one = 1
label-explain-zero = 0
label-explain-value = величина
label-explain-default = по умолчанию
label-explain-range = диапазон
label-explain-bit = 0 или 1
label-explain-no-range = в руководстве не указан
label-explain-whole = целые числа
label-explain-axis = ось
label-explain-room = раздел
label-explain-other-room = { $room }; только хранится, эта версия его не использует
label-explain-help = что делать
label-explain-source = источник
label-explain-raised_by = причины
label-explain-shown_as = показывается как
label-explain-numbers = номера
label-explain-access = доступ
label-explain-read = только чтение
label-explain-write = только запись
label-explain-read-write = чтение и запись
label-explain-access-unknown = в руководстве не указан
label-explain-this_one = эта
label-explain-external = внешнее смещение
label-explain-notes = примечания
label-explain-part_of = часть от
label-explain-no-variable = в руководстве не описана; в программах недоступна
label-explain-place = место
label-explain-used_by = читают
label-explain-in_force = действуют
label-explain-no-block = { $file }, строка { $line }: здесь нет кадра
label-explain-no-word = { $file }, строка { $line }, столбец { $column }: здесь нет слова
label-explain-no-word-there = { $file }, строка { $line }, столбец { $column }: здесь нет слова; слова строки и их столбцы: { $words }
label-explain-comment = { $file }, строка { $line }, столбец { $column }: комментарий
label-explain-no-line = { $file } — файл: назовите его строку, { $file }:12, или строку и столбец, { $file }:12:5
label-explain-drawing = { $file } — чертёж { $kind }, слов программы в нём нет: программу из него делает "ferrocut import"
label-room-acceleration = ускорение
label-room-bus-servo = сервоприводы и шина
label-room-canned-cycles = постоянные циклы
label-room-compensation = компенсация
label-room-coordinates = координаты
label-room-display = индикация
label-room-feed = подача
label-room-homing = референтные точки
label-room-io = входы и выходы
label-room-limits = пределы
label-room-lookahead = предпросмотр кадров
label-room-macro = макропрограммы
label-room-other = прочее
label-room-plc = программа ПЛК
label-room-program-edit = правка программ
label-room-security = права
label-room-spindle = шпиндель
label-room-tapping = нарезание резьбы
label-room-tool-change = смена инструмента
label-room-tool-life = стойкость инструмента
label-class-program = управляющая программа
label-class-macro = макрооператор
label-class-operation = работа с панелью
label-class-homing = референтные точки
label-class-storage = память программ
label-class-servo = привод подачи
label-class-spindle = шпиндель
label-class-overtravel = ось за пределами хода
label-class-plc = программа ПЛК
label-class-system = сама ЧПУ

## Machine files and parameters

label-warning = предупреждение: { $text }
label-exists = { $file } уже есть и не изменён
label-nothing-written = ничего не записано
label-no-assignment = { $text } ничего не задаёт: напишите ИМЯ=ЗНАЧЕНИЕ
label-no-number = { $name } не может быть { $value }: это не число
label-set-twice = { $name } задан дважды
label-named-twice = { $name } тот же параметр, что и { $other }
label-lower-above-upper = { $first } должен быть меньше { $second }: это нижний и верхний пределы
label-same-axis = { $first } и { $second } называют одну и ту же ось; ЧПУ взяла бы X, Y, Z, A
label-both-bits = { $first } и { $second } не могут быть равны 1 одновременно
label-passed-over = { $file }: { $reason }; пропущено
label-no-room = нет раздела { $name }; есть разделы: { $names }
label-no-column = в { $file } нет столбца { $name }
label-no-row = { $file }, строка { $line }: это не строка таблицы
label-row-twice = { $name } уже есть в строке { $line }
label-imported = { $changed ->
    [0] ни одно значение не изменено
    [one] изменено { $changed } значение
    [few] изменены { $changed } значения
    [many] изменено { $changed } значений
   *[other] изменено { $changed } значения
}, без изменений { $same }
label-params-name = имя
label-params-symbol = символ
label-params-value = величина
label-params-default = по умолчанию
label-params-range = диапазон
label-params-unit = единица
label-params-room = раздел
label-params-use = использование
label-params-kept = хранится
label-params-used = используется
label-params-meaning = назначение
label-params-unchanged = ни один из этих параметров не отличается от значения по умолчанию
label-params-no-match = в { $dialect } ни один параметр не подходит под { $name }
label-params-checked = { $parameters ->
    [one] проверен { $parameters } параметр
    [few] проверены { $parameters } параметра
    [many] проверено { $parameters } параметров
   *[other] проверено { $parameters } параметра
} из { $file }: { $findings ->
    [0] замечаний нет
    [one] { $findings } замечание
    [few] { $findings } замечания
    [many] { $findings } замечаний
   *[other] { $findings } замечания
}
label-machine-axis = ось
label-machine-kind = вид
label-machine-linear = линейная
label-machine-rotary = поворотная
label-machine-limits = пределы
label-machine-rapid = быстрый ход
label-machine-cutting = резание
label-machine-acceleration = ускорение
label-machine-jerk = рывок
label-machine-unlimited = без ограничения
label-machine-control = ЧПУ
label-machine-period = период сервопривода
label-machine-spindle-name = шпиндель
label-machine-tool-change-name = смена инструмента
label-machine-tools = { $tools ->
    [one] { $tools } инструмент
    [few] { $tools } инструмента
    [many] { $tools } инструментов
   *[other] { $tools } инструмента
}
label-machine-tolerance-name = допуск
label-machine-exact-stop = точный останов в каждом стыке
label-machine-parameters = параметры
label-machine-dialect = нет языка ЧПУ { $name }
label-machine-no-axis = программы { $dialect } не могут назвать ось { $axis }
label-machine-travel = ось { $axis }: хода { $value } мм нет ни у одного станка; max указан в мм?
label-machine-zero = ось { $axis }: положение станка 0 лежит вне min и max, а программы начинаются там, если в наладке не указано начало
label-machine-fast = ось { $axis }: быстрого хода { $value } мм/мин нет ни у одного станка; это мм/мин?
label-machine-velocity = ось { $axis }: резание на { $value } мм/мин быстрее быстрого хода
label-machine-sluggish = ось { $axis }: разгон до скорости быстрого хода занимает { $value } с; acceleration указано в мм/с², а не в м/с²?
label-machine-abrupt = ось { $axis }: с ускорением { $value } скорость быстрого хода достигается за { $limit } с; оно указано в мм/с²?
label-machine-jerk-low = ось { $axis }: с таким рывком ускорение нарастает { $value } с; jerk указан в мм/с³? 0 значит без ограничения
label-machine-smoothing-differs = ось { $axis }: after_cutting не такое, как у других осей; при изменении скорости прямые искривляются
label-machine-pitch-off = ось { $axis }: pitch_errors без start и interval, и ни один параметр ЧПУ не говорит, где лежат точки; компенсации нет
label-machine-spindle = у шпинделя { $value } об/мин, чего нет ни у одного станка
label-machine-spindle-sluggish = разгон шпинделя до наибольшей частоты вращения занимает { $value } с; acceleration_rpm_s указано в об/мин за секунду?
label-machine-tolerance = с отклонением траектории до { $value } мм детали не обработать; tolerance указан в мм?
label-machine-tool-change = смена инструмента занимает { $value } с; time_s указано в секундах?
label-machine-file-missing = здесь назван { $file }, но рядом с файлом станка его не прочитать: { $reason }
label-public-missing = public_programs называет { $file }, который не прочитать ({ $reason }), а любой код может быть программой из него: положите файл туда, назовите другой через --public или уберите строку
label-linuxcnc-file = он для программ rs274, а назван язык { $dialect }: уберите одно из двух
label-quote-bits = Имена битовых параметров пишутся в кавычках: "NO43.1" = 1

## Drawings

label-drawing-by-name = { $file }: прочитан как чертёж { $kind } (по имени)
label-drawing-by-content = { $file }: прочитан как чертёж { $kind } (по содержанию)
label-stage-read = чтение чертежа
label-stage-plan = выбор порядка
label-stage-write = запись программы
label-stage-prove = прогон программы
label-drawing-made = { $file }: { $kind }, { $wide } x { $high } мм, резов { $curves } общей длиной { $cut } мм, опусканий { $ways }, по воздуху { $way } мм

## Plots

label-plot-title = { $program }, станок { $machine }
label-plot-note = Разности за период сервопривода { $period } мс; рывок усреднён за { $window } мс. Штриховая линия: допустимое.
label-plot-speed = скорость по траектории и заданная подача (штриховая), мм/мин
label-plot-velocity = скорость { $axis }, { $length ->
    [mm] мм
   *[other] { $length }
}/мин; пределы резания и быстрого хода
label-plot-acceleration = ускорение { $axis }, { $length ->
    [mm] мм
   *[other] { $length }
}/с²
label-plot-jerk = рывок { $axis }, { $length ->
    [mm] мм
   *[other] { $length }
}/с³
label-plot-error = ошибка траектории и допуск (штриховая), мм
label-plot-peak = наибольшее { $value } в { $time } с, строка { $line }
label-plot-time = время от начала движения, с

## Pictures of paths

label-view-top = СВЕРХУ
label-view-isometric = ИЗОМЕТРИЯ
label-view-start = начало
label-view-end = конец
label-view-zero = ноль детали
label-view-rapid = ускоренный ход
label-view-cut = резание
label-view-depths = резание, от мелкого к глубокому
label-view-nothing = нет перемещений
label-view-no-axes = нет перемещений X, Y или Z
label-view-depth = Z, мм
label-view-length = { $length } мм
label-view-work = координаты детали, мм
label-view-machine = координаты станка, мм
label-view-moves = { $count ->
    [one] { $shown } перемещение
    [few] { $shown } перемещения
   *[other] { $shown } перемещений
}
label-view-rapids = { $count ->
   *[other] { $shown } ускоренно
}
label-view-cuts = { $shown } с резанием на { $length } мм
label-view-along = { $length } мм вдоль X, Y, Z
label-view-memory = не хватает памяти для картинки
label-view-encoding = картинку нельзя записать как PNG: { $reason }

## Restart

label-restart-at = возобновление со строки { $line }, проход { $pass }
label-restart-position = кадр начинается в
label-restart-modal = программа / станок до этого
label-restart-sent = сначала подаётся
label-restart-approach = оси идут в
label-restart-nothing = ничего
label-restart-group = группа G { $group }
label-restart-feed = F
label-restart-feed-per-turn = F на оборот
label-restart-speed = S
label-restart-spindle = шпиндель
label-restart-flood = СОЖ
label-restart-mist = туман
label-restart-tool = T
label-restart-in-spindle = инструмент в шпинделе
label-restart-length = H
label-restart-radius = D
label-restart-zero = ноль детали { $axis }
label-restart-tool-length = длина инструмента { $axis }

## Machine and set-up files

label-unknown-parameter = { $name }: в этой системе ЧПУ нет такого параметра
label-too-many-parameters = слишком много параметров: ни в одной системе ЧПУ их не больше { $max }
label-config-positive = { $what } равно { $value }: должно быть больше 0
label-config-not-negative = { $what } равно { $value }: должно быть 0 или больше
label-config-range = { $what } равно { $value }: должно быть от { $min } до { $max }
label-config-count = { $what }: их { $value }, а может быть от { $min } до { $max }
label-config-twice = { $what } указано дважды
label-config-finite = { $what } равно { $value }: должно быть конечным числом
label-config-no-machine = это не файл станка: в нём нет axes; файл для начала пишет "ferrocut machine new"
label-config-order = { $what }: min { $min } должно быть меньше max { $max }
label-config-unequal = { $what }: их { $value }, а { $other } — { $count }: должно быть поровну
label-config-either = { $what }: нужно либо { $one }, либо { $other }
label-config-no-axis = { $what }: у станка нет такой оси
label-config-step = { $what } равно { $value }: должно быть не меньше шага, { $min }, поскольку ось приходит на место после команды
label-config-lag = { $what } равно { $value }: на наибольшей скорости ось отстаёт на { $min } из-за того, что ждёт в буфере
label-config-parameter = [parameters] { $reason }: измените или удалите
label-config-null-variable = { $what }: #0 всегда пуста и не задаётся; удалите её
label-config-variables = { $what }: для стольких переменных нет места; удалите часть
label-config-work-offset = [work_offsets] { $name }: в этой системе ЧПУ есть G54 P1–P{ $max }; измените или удалите
label-config-tool = [tools.{ $number }]: в этой системе ЧПУ номера коррекций от 1 до { $max }; измените или удалите
label-config-no-place = { $name }: для ещё одной оси нет места; удалите одну из u, v, w
label-config-var-line = строка { $line }: здесь нужны номер от 1 до { $max } и значение
label-config-tool-word = строка { $line }: { $word } не является словом таблицы инструментов
label-config-no-tool = строка { $line }: нет слова T, указывающего инструмент
label-config-tool-twice = строка { $line }: инструмент T{ $tool } указан дважды; удалите один
label-config-tools = строка { $line }: инструментов больше { $max }
