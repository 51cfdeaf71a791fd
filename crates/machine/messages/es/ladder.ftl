# Ladders: faults without a number of the control, and what the command line shows of them.

FC-1101 = Se incumple una regla de los diagramas de contactos
    .detail = { $word }
    .help = El número del control dice cuál.

FC-1102 = El ajuste de la ejecución del diagrama de contactos no sirve
    .detail = { $setting }: { $value }; admitido: { $allowed }
    .help = Dé una señal por su nombre o dirección, como X20.3, y su valor detrás de =.

FC-1420 = El diagrama de contactos no ha terminado un código
    .detail = { $word }
    .help = Vea en la página de diagnóstico qué señal espera, corrija la máquina y pulse reset.
FC-1421 = El diagrama de contactos no participa en el roscado rígido
    .help = La señal RGTAP está a 0: mire qué hace el diagrama con M29.
FC-1422 = Esta forma de onda no se puede registrar
    .detail = { $value }
    .help = Indique ejes y señales que la máquina tenga, al menos uno y no más de los que caben.
FC-1423 = El interruptor de parámetros está activado
    .help = Desactívelo cuando los parámetros estén como deben, o acepte la alarma en la página de ajustes.
FC-1424 = el diagrama de contactos que corre no es el del archivo de la máquina
    .help = Se puso en su lugar con la máquina en marcha y está guardado. Para volver al propio, deshaga el cambio o cámbielo de nuevo.
FC-1425 = el diagrama de contactos guardado no puede ejecutarse: corre el de la máquina
    .help = Cámbielo por uno corregido; ocupará el lugar del guardado.
    .detail = línea { $line }
FC-1426 = el nuevo diagrama de contactos se paró y se retiró
    .help = Corre el anterior. Busque un bucle sin fin o demasiados pasos en el nivel 1.

label-ladder-checked = { $file }: { $steps } pasos, { $first } de ellos en el nivel 1, { $signals } señales con nombre
label-ladder-faults = { $count ->
    [one] 1 error
   *[other] { $count } errores
}
label-ladder-on = a 1
label-ladder-off = a 0
label-ladder-ran = { $time } ms, { $rounds } vueltas del nivel 2, { $steps } pasos por periodo como máximo
label-ladder-stopped = parado tras { $time } ms
label-ladder-legend = | = contacto o entrada a 1; o = a 0; - = no alcanzado; * = la línea está a 1 tras él
