# The durable memory: what can be wrong with it, who may change it, and what the command line shows of it.

FC-1201 = La memoria del control está dañada
    .detail = { $detail }. El estado bueno más reciente es la confirmación { $commits } de { $time }; recupérelo con: { $command }
    .help = No se ha cambiado nada. «ferrocut memory check» muestra lo que se encontró y los estados buenos que hay; «ferrocut memory recover» recupera el más reciente y conserva los archivos dañados. Sustituya el disco que daña archivos.
FC-1202 = Otro proceso tiene abierta la memoria
    .help = Cierre antes el control en marcha o espere a que termine.
FC-1203 = La memoria la escribió una versión posterior
    .help = Use esa versión o restaure una copia de seguridad que esa versión haya hecho para esta.
FC-1204 = La memoria es de otro control
    .detail = { $name }
    .help = Indique la carpeta de la memoria de este control, o el control al que pertenece.
FC-1205 = El disco rechaza la memoria del control
    .detail = { $reason }
    .help = Mire si el disco está lleno, es de solo lectura o está averiado. Lo que ya se había confirmado sigue ahí.
FC-1206 = La memoria no admite un valor
    .detail = { $name } = { $value }: de { $min } a { $max }
    .detail-2 = { $name } = { $value }: { $min } o más
    .detail-3 = { $name } = { $value }: { $max } o menos
    .detail-4 = { $whole } = { $value }: solo números enteros
    .detail-5 = { $unknown }: el control no tiene ese parámetro
    .detail-6 = { $name } = { $value }
    .help = Dé un valor dentro del rango de la lista del control; no se ha cambiado nada.
FC-1207 = La memoria no tiene sitio para más datos de esta clase
    .help = Elimine lo que ya no haga falta. Guarde en archivos los programas de más de 16 MB.
FC-1208 = En la carpeta no hay ninguna memoria de control
    .detail = { $file }
    .help = Indique la carpeta que contiene memory.db, no un archivo. "ferrocut memory restore" hace una de una copia de seguridad.
FC-1209 = El archivo no es una copia de seguridad que esta versión pueda leer
    .detail = { $file }, versión { $version }
    .detail-2 = { $file }
    .help = Indique un archivo hecho con «ferrocut memory backup» o por el control. La copia de una versión posterior necesita esa versión.
FC-1210 = La copia de seguridad está dañada
    .detail = { $file }, línea { $line }
    .detail-2 = línea { $line }
    .help = No se ha restaurado nada. Copie otra vez el archivo desde donde se hizo o tome otra copia de seguridad.
FC-1211 = La copia de seguridad es de otro control
    .detail = { $name }
    .help = Restáurela en la memoria de un control como aquel; los parámetros y tablas de otro significan otras cosas.
FC-1212 = La copia de seguridad no contiene lo que se quiere restaurar
    .help = «ferrocut memory check» muestra lo que contiene.
FC-1213 = Hace falta un nivel de permisos superior
    .detail = nivel { $needed }, nivel actual { $level }
    .help = Inicie sesión con ese nivel o pídaselo a quien tenga la contraseña.
FC-1214 = Un parámetro prohíbe el cambio
    .detail = { $parameter }
    .help = Quien pueda cambiar el parámetro puede levantar la prohibición.
FC-1215 = El programa está bloqueado por un nivel superior
    .detail = nivel { $level }
    .help = Pida que lo desbloqueen con ese nivel.
FC-1216 = Un programa de pieza no puede cambiar esto
    .help = Cámbielo en el panel.
FC-1217 = El nivel todavía no tiene contraseña y nadie tiene sus permisos
    .detail = nivel { $level }
    .help = Fije en la máquina la contraseña del nivel 1 y después las de los demás niveles. Hasta entonces nadie puede iniciar sesión.
FC-1218 = La contraseña no es correcta
    .help = Inténtelo de nuevo; después de tres contraseñas incorrectas hay que esperar para el siguiente intento.
FC-1219 = La contraseña es demasiado corta o demasiado larga
    .help = Use al menos 8 caracteres, por ejemplo tres palabras.
FC-1220 = Demasiadas contraseñas incorrectas
    .detail = espere { $time } s
    .help = Inténtelo de nuevo pasado ese tiempo.
FC-1221 = La posición no se restaura mientras el control está en marcha
    .help = El control sabe dónde están sus ejes; la posición de otro momento sería falsa. Apáguelo y use «ferrocut memory restore» con este elemento.

label-finding-missing = no está memory.db
label-finding-structure = estructura de memory.db: { $said }
label-finding-schema = las tablas no son las de esta memoria
label-finding-row = una fila de la tabla { $table } se ha alterado sin que nadie la cambiara
label-finding-total = en la tabla { $table } han desaparecido o reaparecido filas
label-finding-commits = hay { $found } transacciones, se confirmaron { $reported }
label-finding-mark = no se puede leer el archivo «mark», que cuenta las transacciones confirmadas
label-memory-folder = memoria
label-memory-control = control
label-memory-commits = transacciones
label-memory-whole = { $file }: íntegro, transacciones: { $commits }
label-memory-backup-whole = { $file }: íntegro, copia de seguridad de { $control } del { $time }
label-memory-rows = filas
label-memory-damaged = { $file }: dañado
label-memory-good-states = estados buenos, primero el más reciente:
label-memory-no-good-state = no queda ningún estado bueno: restaure una copia de seguridad en una carpeta nueva
label-memory-in-database = la propia base de datos
label-memory-lost = { $count ->
    [one] falta 1 transacción confirmada
   *[other] faltan { $count } transacciones confirmadas
}
label-memory-recovered = recuperado: transacción { $commits } del { $time }; los archivos dañados están en { $file }
label-memory-no-such-state = no hay ningún estado bueno con la transacción { $commits }
label-memory-restored = restaurado en { $folder }: { $items }
label-memory-passwords = niveles con contraseña
label-memory-none = ninguno
label-memory-password-set = contraseña del nivel { $level } fijada
label-memory-empty = no hay nada guardado
label-item-programs = programas de pieza
label-item-parameters = parámetros que no son los de fábrica
label-item-offsets = correctores de herramienta con desgaste
label-item-zeros = ceros de pieza
label-item-reference-points = puntos de referencia
label-item-variables = variables macro
label-item-pitch = puntos de las tablas de error de paso
label-item-plc = señales remanentes del diagrama de contactos, bloques de 64 bytes
label-item-counters = contadores
label-item-alarms = historial de alarmas
label-item-log = registro de operaciones
label-item-position = posición al apagar
label-item-interrupted = programa interrumpido
label-item-ladder = diagrama de contactos en lugar del propio de la máquina
