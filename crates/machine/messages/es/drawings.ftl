# Faults of drawings, common to all controls.

FC-1001 = El dibujo se corta a la mitad
    .help = Guarde o transfiera el dibujo otra vez.

FC-1002 = El dibujo contiene más de lo que se puede leer
    .detail = { $megabytes } MB como máximo
    .detail-2 = { $curves } líneas y arcos como máximo
    .detail-3 = { $points } puntos de curvas como máximo
    .detail-4 = { $inserts } bloques insertados como máximo
    .help = Divida el dibujo o aumente la tolerancia.

FC-1003 = El dibujo no tiene nada que cortar
    .help = Revise si contiene líneas o curvas y en qué capas están.

FC-1004 = Un punto del dibujo está demasiado lejos de su cero
    .detail = { $position } mm, { $limit } como máximo
    .help = Revise la unidad y la escala del dibujo.

FC-1005 = Aquí no hay ningún código de grupo DXF
    .detail = { $word }
    .help = Guarde otra vez el dibujo como archivo DXF ASCII.

FC-1006 = Un valor DXF no es un número utilizable
    .detail = { $word }
    .help = Guarde otra vez el dibujo como archivo DXF ASCII.

FC-1007 = El archivo DXF es binario
    .help = Guarde el dibujo como archivo DXF ASCII.

FC-1008 = No se puede leer la entidad del dibujo
    .detail = { $word }
    .help = Elimine la entidad o guarde otra vez el dibujo.

FC-1009 = Un bloque del dibujo se contiene a sí mismo
    .detail = { $name }
    .help = Elimine del bloque la inserción del propio bloque.

FC-1010 = El grado, los nudos, los pesos y los puntos del spline no concuerdan
    .help = Dibuje de nuevo el spline o conviértalo en polilínea.

FC-1011 = Aquí no hay ninguna instrucción PLT
    .detail = { $word }
    .help = Revise que el archivo sea texto PLT (HP-GL) y se haya transferido entero.

FC-1012 = La instrucción PLT tiene un número de valores incorrecto
    .detail = { $word }
    .help = Revise la instrucción; un punto de un archivo tridimensional tiene tres valores (dims = 3).

FC-1013 = Se omiten entidades de un tipo que no se corta
    .detail = { $kind }, { $count }
    .help = Conviértalas en líneas, arcos o polilíneas si hay que cortarlas.

FC-1014 = Se omiten entidades de una capa que no se muestra
    .detail = { $name }, { $count }
    .help = Descongele la capa o actívela si hay que cortarlas.

FC-1015 = Se omiten las entidades del espacio papel y las invisibles
    .detail = { $count }
    .help = Páselas al espacio modelo si hay que cortarlas.

FC-1016 = Un bloque insertado no está en el dibujo
    .detail = { $name }
    .help = Guarde otra vez el dibujo con todos sus bloques.

FC-1017 = No se ejecuta una instrucción PLT
    .detail = { $instruction }
    .help = Si dibuja algo, por ejemplo letras, eso falta: compare la imagen con el dibujo.

FC-1018 = El ajuste de la importación no sirve
    .detail = { $setting }: { $value }; admitido: { $allowed }
    .help = Delo como lo describe la ayuda de la orden import.

FC-1019 = En este lenguaje de control no se pueden escribir dibujos
    .detail = { $name }
    .help = Use gsk990mc, kaitong o weihong.

FC-1020 = El archivo no es un dibujo PLT ni DXF
    .detail = { $file }
    .help = Indique su tipo con --from plt o --from dxf si lo es.

FC-1021 = El dibujo no tiene nada en la capa o con la pluma
    .detail = { $name }; tiene: { $names }
    .help = Use un nombre que tenga el dibujo. Las capas son de dibujos DXF, las plumas de dibujos PLT.

FC-1022 = Instrucción PLT desconocida aquí
    .detail = { $instruction }
    .help = Quítela o guarde el dibujo solo con líneas y arcos: PU, PD, PA, PR, AA, AR, CI, EA, ER y EW.
