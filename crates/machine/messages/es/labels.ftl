# What the command line shows beside alarms.

label-machine = máquina
label-control = control
label-guessed = { $dialect } (no indicado; --dialect elige otro)
label-guessed-content = { $dialect } ({ $unread } de { $blocks } bloques no son { $other }; --dialect elige otro)
label-guessed-extension = { $dialect } (por la extensión del archivo; --dialect elige otro)
label-built-in = { $machine } (incorporada; --machine indica otra)
label-time = tiempo
label-cutting = corte
label-rapid = rápido
label-dwell = espera
label-tool-changes = cambios de herramienta
label-spindle = husillo
label-distance = recorrido
label-extents = extensión
label-moves = movimientos
label-parts = piezas
label-tool = T{ $tool }
label-by-tool = por herramienta
label-no-moves = sin movimientos
label-no-tool = sin herramienta
label-stopped = parado por { $code }; la marcha de ciclo continúa
label-press-enter = pulse Intro para la marcha de ciclo
label-ended-by-alarm = parado por una alarma; lo hecho hasta entonces:
label-written = escrito: { $file }
label-checked = { $files ->
    [one] 1 archivo comprobado
   *[other] { $files } archivos comprobados
} en { $machine }: { $findings ->
    [0] sin incidencias
    [one] 1 incidencia
   *[other] { $findings } incidencias
}
label-further = otras incidencias: { $count }
label-times = el programa llegó a ello { $count } veces

## Explanations

label-error = error: { $text }
label-near = { $text }; parecidos: { $names }
label-unknown = { $dialect } no conoce { $name }
label-no-code = { $dialect } no tiene el código { $name }
label-no-alarm = { $dialect } no tiene la alarma { $name }
label-no-variable = { $dialect } no tiene la variable #{ $name }
label-no-parameter = { $dialect } no tiene el parámetro { $name }
label-no-parameters = { $dialect } no tiene parámetros
label-no-sign = { $dialect } escribe sus parámetros aritméticos sin signo: { $name }
label-several-parameters = { $name } es el símbolo de varios parámetros: { $names }
label-whole-bits = { $name } tiene varios bits: indique uno, como { $name }.1
label-malformed-name = { $name } no es nombre de parámetro: escriba P270, NO43.1 o el símbolo
label-out-of-range = { $name } no puede ser { $value }: debe ser { $range }
label-any-number = un número
label-not-a-bit = { $name } no puede ser { $value }: es un bit, 0 o 1
label-not-whole = { $name } no puede ser { $value }: es un número entero
label-value-changed = { $value } (de fábrica { $default })
label-explain-form = formato
label-explain-group = grupo
label-explain-modal = modal
label-explain-one-block = solo en su bloque
label-explain-modal-depends = modal o no según los parámetros y el formato
label-explain-at-power-on = activo al encender
label-explain-replaces = grupo con
label-explain-does = función
label-explain-section = manual
label-explain-note = nota
label-explain-not-done = esta versión no lo ejecuta
label-explain-forms = formas
label-explain-parameters = parámetros
label-explain-alarms = alarmas
label-explain-codes = códigos
label-explain-no-meaning = el manual lo nombra sin significado; se lo da el fabricante de la máquina
label-explain-timing = cuándo
label-explain-with-motion = empieza con el movimiento de su bloque
label-explain-after-motion = después del movimiento de su bloque
label-explain-class = lo ejecuta
label-explain-program-control = el control, como orden del programa
label-explain-internal = el control
label-explain-plc = el diagrama de contactos de la máquina
label-explain-alone = bloque
label-explain-own-block = ningún otro código de esta clase en su bloque
label-explain-meaning = significado
label-explain-one = 1
label-explain-zero = 0
label-explain-value = valor
label-explain-default = de fábrica
label-explain-range = rango
label-explain-bit = 0 o 1
label-explain-no-range = el manual no da ninguno
label-explain-whole = números enteros
label-explain-axis = eje
label-explain-room = área
label-explain-other-room = { $room }; se guarda con su valor, esta versión no lo usa
label-explain-help = qué hacer
label-explain-source = origen
label-explain-raised_by = la producen
label-explain-shown_as = se muestra como
label-explain-numbers = números
label-explain-access = acceso
label-explain-read = solo lectura
label-explain-write = solo escritura
label-explain-read-write = lectura y escritura
label-explain-access-unknown = el manual no lo dice
label-explain-this_one = esta
label-explain-external = cero de pieza externo
label-explain-notes = notas
label-explain-part_of = parte de
label-explain-no-variable = el manual no la describe; los programas no pueden usarla
label-explain-place = lugar
label-explain-used_by = lo lee
label-explain-in_force = vigentes
label-explain-no-block = { $file }, línea { $line }: no hay ningún bloque
label-explain-no-word = { $file }, línea { $line }, columna { $column }: no hay ninguna palabra
label-explain-no-word-there = { $file }, línea { $line }, columna { $column }: no hay ninguna palabra; las palabras de la línea y sus columnas: { $words }
label-explain-comment = { $file }, línea { $line }, columna { $column }: un comentario
label-explain-no-line = { $file } es un archivo: nombre una línea, { $file }:12, o una línea y una columna, { $file }:12:5
label-explain-drawing = { $file } es un dibujo { $kind }, que no tiene palabras de un programa: "ferrocut import" hace de él un programa
label-room-acceleration = aceleración
label-room-bus-servo = accionamientos servo y bus
label-room-canned-cycles = ciclos fijos
label-room-compensation = compensación
label-room-coordinates = coordenadas
label-room-display = visualización
label-room-feed = avance
label-room-homing = puntos de referencia
label-room-io = entradas y salidas
label-room-limits = límites
label-room-lookahead = look-ahead
label-room-macro = macros
label-room-other = otros
label-room-plc = diagrama de contactos
label-room-program-edit = edición de programas
label-room-security = permisos
label-room-spindle = husillo
label-room-tapping = roscado con macho
label-room-tool-change = cambio de herramienta
label-room-tool-life = vida de herramienta
label-class-program = el programa de pieza
label-class-macro = una sentencia macro
label-class-operation = el manejo del panel
label-class-homing = los puntos de referencia
label-class-storage = la memoria de programas
label-class-servo = un accionamiento de avance
label-class-spindle = el husillo
label-class-overtravel = un eje fuera de sus límites
label-class-plc = el diagrama de contactos
label-class-system = el propio control

## Machine files and parameters

label-warning = aviso: { $text }
label-exists = { $file } ya existe y no se ha cambiado
label-nothing-written = no se ha escrito nada
label-no-assignment = { $text } no fija nada: escriba NOMBRE=VALOR
label-no-number = { $name } no puede ser { $value }: no es un número
label-set-twice = { $name } está fijado dos veces
label-named-twice = { $name } es el mismo parámetro que { $other }
label-lower-above-upper = { $first } debe ser menor que { $second }, del que es el otro límite
label-same-axis = { $first } y { $second } nombran el mismo eje; el control tomaría X, Y, Z, A
label-both-bits = { $first } y { $second } no pueden ser 1 a la vez
label-passed-over = { $file }: { $reason }; omitido
label-no-room = no hay ningún área { $name }; las áreas son { $names }
label-no-column = { $file } no tiene la columna { $name }
label-no-row = { $file }, línea { $line }: no es una fila de una tabla
label-row-twice = { $name } ya está en la línea { $line }
label-imported = { $changed ->
    [0] ningún valor cambiado
    [one] 1 valor cambiado
   *[other] { $changed } valores cambiados
}, { $same } como antes
label-params-name = nombre
label-params-symbol = símbolo
label-params-value = valor
label-params-default = de fábrica
label-params-range = rango
label-params-unit = unidad
label-params-room = área
label-params-use = uso
label-params-kept = guardado
label-params-used = usado
label-params-meaning = significado
label-params-unchanged = ninguno de estos parámetros difiere de su valor de fábrica
label-params-no-match = ningún parámetro de { $dialect } coincide con { $name }
label-params-checked = { $parameters ->
    [one] 1 parámetro comprobado
   *[other] { $parameters } parámetros comprobados
} de { $file }: { $findings ->
    [0] sin incidencias
    [one] 1 incidencia
   *[other] { $findings } incidencias
}
label-machine-axis = eje
label-machine-kind = tipo
label-machine-linear = lineal
label-machine-rotary = rotativo
label-machine-limits = límites
label-machine-rapid = rápido
label-machine-cutting = corte
label-machine-acceleration = aceleración
label-machine-jerk = jerk
label-machine-unlimited = sin límite
label-machine-control = control
label-machine-period = periodo servo
label-machine-spindle-name = husillo
label-machine-tool-change-name = cambio de herramienta
label-machine-tools = { $tools ->
    [one] 1 herramienta
   *[other] { $tools } herramientas
}
label-machine-tolerance-name = tolerancia
label-machine-exact-stop = parada exacta en cada unión
label-machine-parameters = parámetros
label-machine-dialect = no hay ningún lenguaje de control { $name }
label-machine-no-axis = los programas de { $dialect } no pueden nombrar el eje { $axis }
label-machine-travel = eje { $axis }: un recorrido de { $value } mm es mayor que el de cualquier máquina; ¿está max en mm?
label-machine-zero = eje { $axis }: la posición de máquina 0, donde empiezan los programas si la preparación no indica un inicio, está fuera de min y max
label-machine-fast = eje { $axis }: un rápido de { $value } mm/min supera al de cualquier máquina; ¿son mm/min?
label-machine-velocity = eje { $axis }: el corte a { $value } mm/min es más rápido que el rápido
label-machine-sluggish = eje { $axis }: tarda { $value } s en alcanzar la velocidad del rápido; ¿está acceleration en mm/s² y no en m/s²?
label-machine-abrupt = eje { $axis }: una aceleración de { $value } alcanza la velocidad del rápido en menos de { $limit } s; ¿está en mm/s²?
label-machine-jerk-low = eje { $axis }: con este jerk tarda { $value } s en llegar a la aceleración; ¿está jerk en mm/s³? 0 es sin límite
label-machine-smoothing-differs = eje { $axis }: after_cutting no es el de los demás ejes; las rectas se curvan donde cambia la velocidad
label-machine-pitch-off = eje { $axis }: pitch_errors sin start ni interval, y ningún parámetro del control dice dónde están los puntos; no se compensa nada
label-machine-spindle = los { $value } r/min del husillo superan a los de cualquier máquina
label-machine-spindle-sluggish = el husillo tarda { $value } s en alcanzar su velocidad máxima; ¿está acceleration_rpm_s en r/min por segundo?
label-machine-tolerance = una trayectoria que puede desviarse { $value } mm no corta ninguna pieza; ¿está tolerance en mm?
label-machine-tool-change = un cambio de herramienta tarda { $value } s; ¿está time_s en segundos?
label-machine-file-missing = aquí se nombra { $file }, que no se puede leer junto al archivo de máquina: { $reason }
label-public-missing = public_programs nombra { $file }, que no se puede leer ({ $reason }), y cualquier código puede ser un programa suyo: ponga ahí el archivo, nombre otro con --public o quite la línea
label-linuxcnc-file = es para programas de rs274, y el lenguaje indicado es { $dialect }: quite uno de los dos
label-quote-bits = Los nombres de parámetros de bit van entre comillas: "NO43.1" = 1

## Drawings

label-drawing-by-name = { $file }: leído como dibujo { $kind } (por su nombre)
label-drawing-by-content = { $file }: leído como dibujo { $kind } (por su contenido)
label-stage-read = leyendo el dibujo
label-stage-plan = planificando el orden
label-stage-write = escribiendo el programa
label-stage-prove = recorriendo el programa
label-drawing-made = { $file }: { $kind }, { $wide } x { $high } mm, cortes: { $curves }, { $cut } mm; bajadas: { $ways }; en vacío: { $way } mm

## Plots

label-plot-title = { $program } en { $machine }
label-plot-note = Diferencias sobre el periodo servo de { $period } ms; el jerk es una media de { $window } ms. A trazos: lo permitido.
label-plot-speed = velocidad en la trayectoria y avance programado (a trazos), mm/min
label-plot-velocity = velocidad { $axis }, { $length }/min; límites de corte y de posicionamiento
label-plot-acceleration = aceleración { $axis }, { $length }/s²
label-plot-jerk = jerk { $axis }, { $length }/s³
label-plot-error = error de trayectoria y tolerancia (a trazos), mm
label-plot-peak = máximo { $value } a los { $time } s, línea { $line }
label-plot-time = tiempo desde que empezó el movimiento, s

## Pictures of paths

label-view-top = PLANTA
label-view-isometric = ISOMÉTRICA
label-view-start = inicio
label-view-end = fin
label-view-zero = cero de pieza
label-view-rapid = rápido
label-view-cut = corte
label-view-depths = corte, de somero a profundo
label-view-nothing = sin movimientos
label-view-no-axes = sin movimientos de X, Y o Z
label-view-depth = Z mm
label-view-length = { $length } mm
label-view-work = coordenadas de pieza, mm
label-view-machine = coordenadas de máquina, mm
label-view-moves = { $count ->
    [one] { $shown } movimiento
   *[other] { $shown } movimientos
}
label-view-rapids = { $count ->
    [one] { $shown } rápido
   *[other] { $shown } rápidos
}
label-view-cuts = { $shown } de corte en { $length } mm
label-view-along = { $length } mm según X, Y, Z
label-view-memory = no hay memoria suficiente para la imagen
label-view-encoding = la imagen no se puede escribir como PNG: { $reason }

## Restart

label-restart-at = reanudado en la línea { $line }, vez que se alcanza: { $pass }
label-restart-position = el bloque empieza en
label-restart-modal = programa / máquina antes
label-restart-sent = se envía primero
label-restart-approach = los ejes van a
label-restart-nothing = nada
label-restart-group = grupo G { $group }
label-restart-feed = F
label-restart-feed-per-turn = F por vuelta
label-restart-speed = S
label-restart-spindle = husillo
label-restart-flood = refrigerante
label-restart-mist = niebla
label-restart-tool = T
label-restart-in-spindle = herramienta en el husillo
label-restart-length = H
label-restart-radius = D
label-restart-zero = cero de { $axis }
label-restart-tool-length = longitud de herramienta en { $axis }

## Machine and set-up files

label-unknown-parameter = { $name }: el control no tiene ese parámetro
label-too-many-parameters = demasiados parámetros: ningún control tiene más de { $max }
label-config-positive = { $what } es { $value }: debe ser mayor que 0
label-config-not-negative = { $what } es { $value }: debe ser 0 o más
label-config-range = { $what } es { $value }: debe ser de { $min } a { $max }
label-config-count = { $what }: hay { $value }, puede haber de { $min } a { $max }
label-config-twice = { $what } está dos veces
label-config-finite = { $what } es { $value }: debe ser un número finito
label-config-no-machine = no es un archivo de máquina: no tiene axes; "ferrocut machine new" escribe uno para empezar
label-config-order = { $what }: min { $min } debe ser menor que max { $max }
label-config-unequal = { $what }: hay { $value }, y { $count } de { $other }: debe haber los mismos
label-config-either = { $what }: necesita { $one } o bien { $other }
label-config-no-axis = { $what }: la máquina no tiene ese eje
label-config-step = { $what } es { $value }: debe ser al menos un paso, { $min }, porque el eje llega a su sitio después de la orden
label-config-lag = { $what } es { $value }: a su velocidad máxima el eje va { $min } retrasado, por lo que espera en el búfer
label-config-parameter = [parameters] { $reason }: cámbielo o elimínelo
label-config-null-variable = { $what }: #0 está siempre vacía y no se puede fijar; elimínela
label-config-variables = { $what }: no hay sitio para tantas variables; elimine algunas
label-config-work-offset = [work_offsets] { $name }: el control tiene de G54 P1 a P{ $max }; cámbielo o elimínelo
label-config-tool = [tools.{ $number }]: el control tiene números de corrector de 1 a { $max }; cámbielo o elimínelo
label-config-no-place = { $name }: no hay sitio para otro eje; elimine uno de u, v, w
label-config-var-line = línea { $line }: ahí va un número de 1 a { $max } y un valor
label-config-tool-word = línea { $line }: { $word } no es una palabra de una tabla de herramientas
label-config-no-tool = línea { $line }: ninguna palabra T dice qué herramienta es
label-config-tool-twice = línea { $line }: la herramienta T{ $tool } está dos veces; elimine una
label-config-tools = línea { $line }: más de { $max } herramientas
