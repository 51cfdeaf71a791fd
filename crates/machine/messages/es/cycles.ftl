# FC-1520 to FC-1539: forms of cycles.

FC-1520 = El editor no tiene ese ciclo
    .detail = { $name }
    .help = Elija uno de la lista.

FC-1521 = El valor está fuera de sus límites
    .detail = { $parameter }: de { $min } a { $max }
    .help = Dé un valor entre los límites; las cantidades y los números son enteros.

FC-1522 = La opción no tiene esa palabra
    .detail = { $parameter }
    .help = Elija una de las palabras que ofrece el campo.

FC-1523 = El nombre no puede figurar en un programa
    .detail = { $parameter }
    .help = Empiece por una letra y use solo letras, cifras y guiones bajos, 32 como máximo.

FC-1524 = El ciclo no puede repetirse en estas posiciones
    .help = Dé una sola figura, sin más puntos de los que admite; algunos ciclos no admiten ninguna.

FC-1525 = El perfil no conviene al ciclo
    .help = Dé los contornos que el ciclo necesita, cerrados para una cajera, con esquinas no mayores que sus lados; punto a punto admite hasta 25 puntos unidos por rectas.

FC-1526 = El ciclo sería demasiado largo en bloques
    .detail = { $limit }
    .help = Use pasos mayores o divídalo en varios ciclos.

FC-1527 = Este control no tiene un ciclo de roscado sincronizado así
    .detail = { $name }
    .help = Ponga el factor de salida a 1, elija el roscado con compensador o revise los parámetros de roscado del control.

FC-1528 = El ciclo no puede escribirse en el lenguaje de este control
    .detail = { $name }
    .help = Cambie lo que el control no puede seguir, como paradas orientadas del husillo, funciones M o números de herramienta.
