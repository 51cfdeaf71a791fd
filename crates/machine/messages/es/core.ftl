# Faults common to all controls. What a message is made of and which arguments a detail may name

# stands in src/messages.rs.

with-detail = { $text } ({ $detail })

## Text

FC-0101 = Carácter que ningún bloque puede contener
    .detail = { $character }
    .help = Elimine el carácter o póngalo en un comentario.
FC-0102 = Número sin dirección delante
    .detail = { $word }
    .help = Ponga la letra de dirección delante del número o elimínelo.
FC-0103 = Dirección sin valor
    .detail = { $word }
    .help = Escriba el valor detrás de la letra de dirección o elimine la letra.
FC-0104 = Signo donde no puede haberlo
    .detail = { $word }
    .help = Una palabra admite un solo signo, justo detrás de su dirección, y solo donde su valor puede ser negativo.
FC-0105 = Punto decimal donde no puede haberlo, o más de uno
    .detail = { $word }
    .help = Escriba un punto decimal como máximo, y ninguno en las palabras que deben ser enteras.
FC-0106 = La línea es demasiado larga
    .detail = { $limit } bytes como máximo
    .help = Divida el bloque en varias líneas.
FC-0107 = Hay corchetes o paréntesis sin pareja
    .help = Cierre en el mismo bloque cada corchete o paréntesis que abra.
FC-0108 = Demasiados niveles de corchetes o paréntesis
    .detail = { $limit } niveles como máximo
    .help = Calcule antes una parte de la expresión en una variable.
FC-0109 = No se puede leer la expresión
    .detail = { $word }
    .help = Revise los operadores, los corchetes o paréntesis y las variables de la expresión.
FC-0110 = Comentario abierto y sin cerrar
    .help = Cierre el comentario en la misma línea.
FC-0111 = No se puede leer la sentencia macro
    .detail = { $word }
    .help = Revise cómo está escrita y la forma de la sentencia, y si el control la tiene.
FC-0112 = Esa función no existe
    .detail = { $name }
    .help = Revise cómo está escrita; el manual de programación del control da la lista de funciones.
FC-0113 = El número es demasiado grande
    .detail = { $word }
    .help = Revise si falta un punto decimal o hay cifras repetidas.
FC-0114 = Palabras y sentencia macro en el mismo bloque
    .detail = { $word }
    .help = Ponga la sentencia macro en un bloque propio.
FC-0115 = Texto sin cerrar
    .detail = { $word }
    .help = Termine el texto con las comillas o el corchete que necesite.

## Words

FC-0201 = El control no tiene este código G
    .detail = { $word }
    .help = Revise el código y si el programa está hecho para este control.
FC-0202 = El control no tiene este código M
    .detail = { $word }
    .help = Revise el código y si el programa está hecho para este control.
FC-0203 = El control no usa esta dirección aquí
    .detail = { $word }
    .help = Elimine la palabra o revise a qué código del bloque correspondía.
FC-0204 = Dirección repetida en el bloque
    .detail = { $word }
    .help = Deje una sola de las palabras o divida el bloque.
FC-0205 = Dos códigos G del mismo grupo modal en el bloque
    .detail = { $first } y { $second }
    .help = Deje uno de ellos o póngalos en bloques distintos.
FC-0206 = El valor está fuera de su rango
    .detail = { $word }: de { $min } a { $max }
    .detail-2 = { $word }
    .help = Programe un valor que la dirección admita.
FC-0207 = El valor debe ser entero
    .detail = { $word }
    .help = Escriba la palabra sin decimales.
FC-0208 = El valor no puede ser negativo
    .detail = { $word }
    .help = Elimine el signo o revise el cálculo del que sale el valor.
FC-0209 = El código debe ir solo en su bloque
    .detail = { $word }
    .help = Ponga el código en un bloque propio.
FC-0210 = Varios códigos M que controlan el programa en un bloque
    .detail = { $first } y { $second }
    .help = Ponga cada uno de M00, M01, M02, M30, M98 y M99 en un bloque propio.
FC-0211 = Demasiados códigos M en el bloque
    .detail = { $limit } como máximo
    .help = Reparta los códigos M entre varios bloques.
FC-0212 = Ese eje no existe
    .detail = { $axis }
    .help = Revise la letra del eje; los ejes de la máquina están en el archivo de la máquina.

## Motion

FC-0301 = Movimiento de corte sin avance
    .help = Programe F en este bloque o antes.
FC-0302 = El inicio y el final del arco no están a la misma distancia de su centro
    .detail = radio { $start } en el inicio, { $end } en el final; pueden diferir en { $limit }
    .detail-2 = radio { $start } en el inicio, { $end } en el final
    .help = Revise I, J y K, el punto final y el punto donde acaba el bloque anterior.
FC-0303 = El arco no tiene ni radio ni centro
    .help = Programe R, o el centro con las letras I, J y K que correspondan al plano.
FC-0304 = El radio del arco es demasiado pequeño para llegar a su final
    .detail = R { $radius }, hace falta al menos { $least }
    .help = Revise R y el punto final; R debe ser al menos la mitad de la distancia entre inicio y final.
FC-0305 = El arco empieza en su propio centro
    .help = Revise I, J y K: son las distancias del inicio del arco a su centro.
FC-0306 = El tiempo de espera es negativo
    .detail = { $word }
    .help = Programe el tiempo de espera sin signo.
FC-0307 = Demasiados ejes además de los del círculo de la hélice
    .detail = { $limit } como máximo
    .help = Programe menos ejes fuera del plano del arco.
FC-0308 = Una coordenada excede lo que admite el control
    .detail = { $axis } { $position }
    .help = Revise la coordenada, los correctores, los ceros de pieza y el factor de escala activos.
FC-0309 = El avance está fuera del rango del control
    .detail = { $word }
    .help = Programe un avance mayor que cero y dentro del rango del control.

## Offsets and coordinate systems

FC-0401 = Ese número de corrector no existe
    .detail = { $number }, el mayor es { $limit }
    .detail-2 = { $number }
    .help = Compare H y D con la tabla de correctores.
FC-0402 = Ese sistema de coordenadas de pieza no existe
    .detail = { $name }
    .help = Use uno de los sistemas de la tabla de ceros de pieza del control.
FC-0403 = Compensación de longitud en el bloque que fija el sistema de coordenadas
    .help = Ponga la compensación de longitud y G92 en bloques distintos.
FC-0404 = La longitud de herramienta cambia en un bloque con arco
    .detail = { $word }
    .help = Cambie la compensación de longitud en un bloque con movimiento recto.

## Canned cycles

FC-0501 = El ciclo no funciona en este plano
    .detail = { $plane }
    .help = Seleccione antes el plano del ciclo; para los ciclos de taladrado, G17.
FC-0502 = El fondo del agujero no está por debajo del plano R
    .detail = fondo { $depth }, R { $r }
    .help = Revise Z y R y si son absolutas o incrementales.
FC-0503 = El taladrado profundo no tiene penetración
    .detail = { $word }
    .help = Programe una penetración mayor que cero; en la mayoría de los controles, Q.
FC-0504 = El plano cambia con un ciclo activo
    .help = Termine el ciclo con G80 antes de cambiar de plano.
FC-0505 = Ciclo sin velocidad del husillo
    .help = Programe S y arranque el husillo antes del ciclo.
FC-0506 = Código de punto de referencia con un ciclo activo
    .detail = { $word }
    .help = Termine el ciclo con G80 antes de este bloque.

## Programs

FC-0601 = La llamada no indica ningún programa
    .help = Programe el número o el nombre del programa al que se llama.
FC-0602 = El programa llamado no existe
    .detail = { $program }
    .help = Ponga el programa en la memoria de programas o revise su número o nombre. En M06 falta el programa de cambio de herramienta (O9001, o el que indica [tool_change] del archivo de la máquina): en el husillo sigue la herramienta anterior.
FC-0603 = Demasiados niveles de llamada
    .detail = { $limit } niveles como máximo
    .help = Revise si un programa se llama a sí mismo; si no, junte algunos subprogramas.
FC-0604 = La llamada se repite demasiadas veces
    .detail = { $repeats } veces, { $limit } como máximo
    .help = Revise el número de repeticiones o repita la llamada en un bucle.
FC-0605 = Ningún programa puede tener este número
    .detail = { $program }
    .help = Use un número de programa que el control admita.
FC-0606 = El programa no tiene final
    .help = Termine el programa principal con M30 o M02, un subprograma con M99, o con M17 donde el control lo tenga.
FC-0607 = El programa llegó a la marca de fin %
    .help = Termine el programa antes de la marca: con M30 o M02, un subprograma con M99, o con M17 donde el control lo tenga.
FC-0608 = El programa no llega a su fin
    .help = Revise las condiciones de los bucles y los saltos.
FC-0609 = El número de secuencia de destino del salto no existe
    .detail = N{ $number }
    .help = Numere el bloque al que se salta o corrija el salto.

## Variables and arithmetic

FC-0701 = División por cero
    .help = Revise el divisor; tan 90 también cuenta como división por cero.
FC-0702 = La función no está definida para este valor
    .detail = { $name } de { $value }
    .detail-2 = { $name }
    .help = Revise el valor: las raíces necesitan cero o más, los logaritmos más de cero, el arco seno y el arco coseno de -1 a 1.
FC-0703 = Esa variable no existe
    .detail = { $variable }
    .help = Use una variable que el control tenga.
FC-0704 = En esa variable no se puede escribir
    .detail = { $variable }
    .help = Asigne el valor a una variable en la que se pueda escribir.
FC-0705 = El resultado se sale del rango numérico del control
    .help = Revise los valores de los que parte el cálculo.

## Machine

FC-0801 = Un eje saldría de sus límites de software
    .detail = { $axis } a { $position }, límite { $limit }
    .detail-2 = { $axis }
    .help = Revise el cero de pieza, la longitud de herramienta y las coordenadas; los límites están en el archivo de la máquina.
FC-0802 = Corte con el husillo parado
    .help = Arranque el husillo con M03 o M04 y una velocidad S antes del primer corte.
FC-0803 = La herramienta no está en el almacén
    .detail = T{ $tool }
    .help = Cargue la herramienta o corrija su número.
FC-0804 = El husillo no alcanza esta velocidad
    .detail = S{ $speed }, { $limit } como máximo
    .help = Programe una velocidad menor.
FC-0805 = La máquina no puede hacer el movimiento con el avance programado
    .detail = F{ $feed }, { $limit } como máximo
    .help = Programe un avance menor; las velocidades de los ejes están en el archivo de la máquina.
FC-0806 = La entrada que espera el programa no llega
    .help = Revise la entrada y su dirección o alargue la espera.
FC-0807 = Un eje está demasiado lejos de su posición de consigna
    .detail = { $axis } está a { $distance }, límite { $limit }
    .help = Revise si el eje está bloqueado, su accionamiento y el límite del error de seguimiento.
FC-0808 = Un eje no llega a estar en posición después de parar
    .detail = { $axis } está a { $distance }, límite { $limit }
    .help = Revise el accionamiento y la ventana y el tiempo de «en posición».
FC-0809 = El eje está donde no hay punto de compensación del error de paso
    .detail = { $axis } en { $position }, los puntos acaban en { $limit }
    .help = Revise el número del punto en la posición de referencia y el intervalo entre los puntos.

## Files

FC-0901 = No se puede leer el archivo
    .detail = { $file }: { $reason }
    .detail-2 = { $file }
    .detail-3 = { $reason }
    .help = Revise la ruta y si el archivo se puede leer.
FC-0902 = El archivo no es un texto de programa
    .detail = { $file }
    .help = Dé un archivo de texto en UTF-8 o GB18030.
FC-0903 = El archivo no contiene ningún bloque
    .detail = { $file }
    .help = Revise que sea el archivo correcto y que se haya transferido entero.
FC-0904 = El archivo de preparación o de la máquina no sirve
    .detail = { $file }: { $reason }
    .detail-2 = { $file }
    .detail-3 = { $reason }
    .help = Corrija el archivo donde dice el motivo.
FC-0905 = Lenguaje de control desconocido
    .detail = { $name }
    .help = Indíquelo con --dialect: gsk990mc, weihong, kaitong, fagor8065 o rs274.
FC-0906 = Esta versión no ejecuta el código
    .detail = { $word }
    .help = Elimine el código o sustitúyalo por otros con el mismo efecto.

FC-0907 = No se puede escribir un archivo
    .help = Revise la ruta, el espacio libre y los permisos de la carpeta.
    .detail = { $file }: { $reason }
FC-0910 = La salida es un archivo que la orden lee
    .help = Dé otro nombre a la salida. No se ha escrito nada.
    .detail = { $file }

FC-0706 = La variable #0 está siempre vacía y no se le puede dar valor
    .help = Use otra variable.

FC-0707 = El control no tiene esta operación macro
    .help = Revise el código H de G65.

FC-0708 = Esta dirección no puede pasar un argumento a una macro
    .help = Use cualquier letra menos G, L, N, O, P y H, cada una solo una vez.

FC-0709 = Demasiados niveles de llamada a macro
    .help = Llame a menos macros unas dentro de otras.

FC-0710 = No se puede ejecutar el bucle o la condición
    .help = Dé a DO y END una etiqueta de 1 a 3, a un bucle que cuenta un paso distinto de 0, y cierre cada bucle y cada condición.

FC-0711 = Hay bucles sin pareja
    .help = Dé a cada DO un END con la misma etiqueta y no deje que los bucles se crucen.

FC-0712 = Un salto lleva al interior de un bucle
    .help = Salte a un bloque anterior o posterior al bucle.

FC-0713 = El programa ha generado una alarma
    .help = Vea en el programa por qué lo hace.
FC-0714 = Un número de programa o de secuencia no puede ser una variable
    .help = Escriba el propio número detrás de O o N.

FC-0405 = El escalado no está habilitado en este control
    .help = Ponga a 1 el bit 60#5.

FC-0406 = El factor de escala está fuera de rango
    .detail = de { $min } a { $max }
    .help = Use un factor que el control admita.

FC-0407 = Este código no se admite con el escalado activo
    .help = Anule antes el escalado con G50.

FC-0408 = Este código no se admite con el giro activo
    .help = Anule antes el giro con G69.

FC-0409 = Este código no se admite en coordenadas polares
    .help = Anule antes las coordenadas polares con G15.

FC-0410 = No se puede cambiar de plano con el giro activo
    .help = Anule antes el giro con G69.

FC-0411 = En coordenadas polares un arco se debe dar con R
    .help = Programe R en lugar de I, J, K.

FC-0412 = No se puede cambiar de unidades con escalado, giro o coordenadas polares
    .help = Anule antes la transformación.

FC-0413 = La función SKIP no actúa con escalado, giro o coordenadas polares
    .help = Anule antes la transformación.

FC-0414 = Retorno al punto de referencia sin eje
    .help = Indique los ejes que deben retornar.

FC-0415 = Ese punto de referencia no existe
    .help = Use un número que el código tenga: P2, P3 o P4 con G30, de H0 a H3 (X, Y, Z, A) con M902.

FC-0416 = La posición no es el punto de referencia
    .help = Revise la posición, los correctores y los ceros activos.

FC-0417 = No se pueden fijar datos con un ciclo fijo activo
    .help = Anule antes el ciclo con G80.

FC-0418 = Esta forma de fijar datos no existe
    .help = Use L2, L10 a L13, L20, L50 o L51.

FC-0419 = El número de corrector falta o es demasiado grande
    .help = Revise P.

FC-0420 = El valor del corrector falta o es demasiado grande
    .help = Revise R.

FC-0421 = El número, el bit o el valor del parámetro falta o está fuera de rango
    .help = Revise N, P y R.

FC-0422 = El programa no puede cambiar este parámetro
    .help = Cámbielo en la página de parámetros.

FC-0423 = Orden mientras se fijan parámetros
    .help = Termine antes la entrada de datos con G11.

FC-0507 = El fondo Z del agujero no está por encima del plano R
    .help = Para el mandrinado inverso, R debe ser el plano inferior.

FC-0508 = La velocidad del husillo falta o es demasiado alta para roscar
    .detail = { $parameter }
    .help = Dé S dentro del límite del roscado.

FC-0509 = Se pide roscado rígido con un ciclo activo
    .help = Anule el ciclo con G80 antes de M29.

FC-0310 = El chaflán o redondeo está mal escrito
    .help = Ponga ,L o ,R con una longitud al final de un bloque G01, G02 o G03.

FC-0311 = Falta el movimiento posterior al chaflán o redondeo
    .help = Haga que siga enseguida un movimiento G01, G02 o G03.

FC-0312 = El chaflán o redondeo es más largo que los movimientos contiguos
    .help = Hágalo más pequeño, o más largos los movimientos.

FC-0313 = Un movimiento contiguo al chaflán o redondeo sale del plano
    .help = Mueva solo los dos ejes del plano.

FC-0424 = La compensación de radio no encuentra la intersección de dos bloques
    .help = Use una herramienta menor o movimientos más largos en esta esquina.

FC-0425 = La compensación de radio se activa o se anula en un arco
    .help = Actívela y anúlela en un movimiento G00 o G01.

FC-0426 = La función SKIP no actúa con compensación de radio
    .help = Anule antes la compensación con G40.

FC-0427 = No se puede cambiar de plano con compensación de radio
    .help = Anule antes la compensación con G40.

FC-0428 = El extremo de un arco cae en su centro con compensación de radio
    .help = Use una herramienta menor o un arco mayor.

FC-0429 = No se puede cambiar el sistema de coordenadas de pieza con compensación de radio
    .help = Anule antes la compensación con G40.

FC-0430 = La herramienta invadiría la pieza
    .help = Use una herramienta menor o abra la esquina o el arco.

FC-0431 = Demasiados bloques sin movimiento con compensación de radio
    .help = Ponga estos bloques antes de G41 o después de G40.

FC-0432 = Arco de esquina fuera de la compensación de radio
    .help = Use G39 solo entre G41 o G42 y G40.

FC-0433 = Un bloque retrocede exactamente sobre el anterior con compensación de radio
    .help = No invierta la trayectoria dentro de la compensación.

FC-0213 = Más ejes de los que pueden moverse juntos
    .help = Divida el movimiento o ponga a 1 el bit 9#1 para cuatro ejes.

FC-0214 = El número de herramienta tiene demasiadas cifras
    .help = Revise T; P206 fija sus cifras.

FC-0215 = El código necesita una palabra que falta
    .detail = { $word }
    .help = Añada la palabra al bloque.

FC-0216 = Ningún código del bloque usa esta palabra
    .help = Elimine la palabra o añada el código al que pertenece.

FC-0217 = Palabras de eje sin ningún código que mueva los ejes
    .help = Añada G0, G1 u otro código de movimiento; con G80 no se mueve ningún eje.

FC-0218 = El código necesita palabras de eje
    .help = Indique al menos un eje.

FC-0219 = Estos códigos no pueden ir juntos
    .help = Póngalos en bloques distintos. G53 solo admite G0 y G1, y en G90; de los códigos que usan las palabras de eje, un bloque admite uno.

FC-0220 = Los límites no se anulan
    .help = El código no tiene efecto: ningún eje sale de su recorrido. Los límites de software rigen una vez referenciados los ejes, así que para referenciarlos no hay nada que anular.

FC-0221 = No hay retención de encoders que ajustar
    .help = El código no tiene efecto. La búsqueda de referencia encuentra las marcas por sí misma, y tras un movimiento que termina una entrada el control sabe dónde están los ejes.

FC-0314 = El avance por vuelta necesita un husillo con encoder
    .help = Use G94 o monte un encoder.

FC-0315 = El escalado hace la coordenada demasiado grande
    .help = Use un factor menor.
FC-0316 = El arco mueve un eje ajeno a su plano
    .detail = { $axis }
    .help = Mueva el eje en un bloque propio o elija el plano en que está el arco.
FC-0317 = La hélice sube sin girar
    .help = Dé al arco un punto final en el plano o un círculo completo por su centro; para un movimiento recto use G01.

FC-0318 = Arco en coordenadas de máquina
    .help = Programe G00 o G01 en el bloque de G53.

FC-0434 = El valor del corrector es demasiado grande
    .help = Corrija el valor en la tabla de correctores.

FC-0435 = El punto intermedio está demasiado lejos
    .help = Revise las coordenadas del bloque.

FC-0436 = Bloque con barra / y escalado, giro o coordenadas polares activos
    .help = Anule la transformación antes del bloque.

FC-0437 = Se cambia un corrector o un cero con escalado, giro o coordenadas polares
    .help = Anule antes la transformación.

FC-0438 = G12 necesita un bloque propio
    .help = Pase los demás códigos a otro bloque.

FC-0439 = Las esquinas del límite de recorrido almacenado no forman una zona
    .help = X, Y, Z deben ser mayores que I, J, K.

FC-0440 = El movimiento entra en la zona que prohíbe el límite de recorrido almacenado
    .help = Cambie el movimiento o desactive la comprobación con G13.

FC-0441 = Ese eje no existe para la velocidad de corte constante
    .help = Use P1 a P4 para un eje de la máquina.

FC-0442 = Compensación de longitud en el bloque de un código que no la admite
    .detail = { $word }
    .help = Ponga la compensación de longitud en un bloque propio.

FC-0453 = La longitud de herramienta no cambia: hay un ciclo fijo activo
    .help = Termine el ciclo con G80 antes de cambiar la longitud de herramienta o prográmela en el bloque que inicia el ciclo.

FC-0443 = Se activa el escalado con compensación de radio activa
    .help = Programe el escalado antes de G41 o G42, o anule antes con G40.

FC-0444 = El escalado está incompleto o tiene las dos clases de factor
    .help = Dé el centro de los ejes con P, o I, J, K para cada eje.

FC-0445 = La imagen espejo no indica ningún eje
    .help = Dé la coordenada respecto a la que se refleja cada eje.

FC-0446 = Demasiadas transformaciones activas a la vez
    .help = Anule cada giro con G69 antes del siguiente, también en los subprogramas repetidos.
FC-0447 = El movimiento SKIP acabó sin su señal
    .help = Revise el palpador y su cableado y si el movimiento llega lo bastante lejos; P021.3 dice si esto es una alarma.
FC-0451 = El palpador ya tiene su señal antes de empezar el movimiento
    .help = Aléjese de la pieza antes de palpar, o tóquela para G38.4; revise el palpador y su cableado. G38.3 y G38.5 lo permiten.

FC-0452 = G29 no tiene punto intermedio por el que pasar
    .detail = { $axis }
    .help = Programe antes de G29 un G28 o G30 con este eje, o vaya al punto con G00.

FC-0510 = Roscado rígido sin avance
    .help = Dé F en el ciclo o antes.

FC-0511 = Hay una velocidad o un movimiento entre M29 y el ciclo de roscado
    .help = Dé S en el bloque de M29 y mueva los ejes antes.

FC-0512 = Se cambia de plano en el roscado rígido
    .help = Termine antes el roscado rígido con G80 o M28.

FC-0513 = El ciclo necesita un husillo que pueda parar en un ángulo
    .help = Use otro ciclo o monte un husillo así.

FC-0610 = Una macro llama a un subprograma
    .help = Llame en su lugar a una macro con G65.

FC-0611 = M99 está en el bloque de una llamada a macro
    .help = Ponga M99 en un bloque propio.

FC-0612 = El número de programa es demasiado grande
    .help = Use de O0 a O99999.
FC-0613 = El número de secuencia de destino del salto no existe
    .detail = { $number }
    .help = Dé este número de secuencia al bloque al que se salta; debe estar en el mismo programa.

FC-0908 = La imagen tiene que ser un archivo .png o .svg
    .help = Dé al archivo de salida una de estas extensiones.
    .detail = { $file }

FC-0909 = El ajuste de la gráfica no sirve
    .help = Indique ejes de la máquina, cada uno por su letra, empiece antes de que acabe el programa, acabe más tarde de lo que empieza y escriba un archivo .svg.
    .detail = { $setting }: { $value }; admitido: { $allowed }

FC-0514 = Ciclo de fresado con un eje en imagen espejo
    .help = Use factores de escala positivos.

FC-0515 = El paso o la distancia de inicio es demasiado pequeño
    .help = Use una L mayor.

FC-0516 = El paso o la distancia de inicio es demasiado grande
    .help = Use una L menor.

FC-0517 = La herramienta o su hélice no cabe
    .help = Use una herramienta menor o un factor de hélice P269 menor.

FC-0518 = El radio de la esquina es mayor que medio lado
    .help = Use un radio de esquina menor.

FC-0519 = El radio de la esquina es menor que el radio de la herramienta
    .help = Use una U mayor o una herramienta menor.

FC-0520 = Falta la distancia sobre el material sin cortar
    .help = Dé V mayor que 0.

FC-0521 = Falta la profundidad de la primera pasada
    .help = Dé W mayor que 0.

FC-0522 = Falta la profundidad de pasada
    .help = Dé Q mayor que 0.

FC-0523 = Falta el radio o la primera medida
    .help = Dé I.

FC-0524 = Falta la segunda medida o la distancia de inicio
    .help = Dé J.

FC-0525 = Falta el radio de la herramienta
    .detail = { $parameter }
    .help = Dé D e introduzca un radio para la herramienta en la tabla de correctores.

FC-0526 = El ciclo necesitaría demasiados movimientos
    .detail = { $parameter }
    .help = Use un paso o una profundidad de pasada mayor.
FC-0527 = Roscado rígido sin velocidad del husillo
    .help = Programe S, mejor en el bloque del código que hace rígido el roscado.

FC-0528 = Ciclo de roscado cuyo paso no se dio nunca
    .help = Programe con el ciclo el paso F o los hilos por pulgada I.

FC-0529 = El paso de la rosca está dado dos veces
    .detail = { $word }
    .help = Programe F o I, no los dos.
FC-0530 = Agujeros en una figura sin ciclo fijo
    .help = Programe el ciclo fijo antes de la figura; antes de G34 a G37 con K0, para que no haga él mismo un agujero.
FC-0531 = Ciclo fijo con Z escalado
    .help = Anule el escalado con G50 o deje Z fuera de él.
FC-0532 = Ciclo de fresado con X e Y a escalas distintas
    .help = Dé a X e Y el mismo factor, o cancele la escala con G50.

FC-0533 = El avance del roscado supera el mayor avance de corte
    .detail = F{ $feed }, { $limit } como máximo: el husillo gira a { $speed }
    .detail-2 = F{ $feed }, { $limit } como máximo
    .help = Reduzca F y S a la vez. El roscado rígido mantiene el paso: el husillo se frena con el avance. En un portamachos flotante solo baja el avance y la rosca se estropea.
FC-0534 = La espera más corta de un ciclo no es menor que la más larga
    .help = Ponga el parámetro de la espera más corta por debajo del de la más larga.
FC-0535 = El ciclo no hace ningún agujero: falta el nivel R o la profundidad Z
    .help = Programe R y Z. Si falta uno de ellos, la herramienta solo se posiciona sobre los puntos.
FC-0536 = La herramienta no se aparta en el agujero: falta Q
    .help = Programe Q, la distancia que se aparta. Sin ella, el filo deja un surco en el mandrinado, y en el mandrinado inverso la herramienta entra en el agujero con todo su ancho.
FC-0537 = El ciclo no hace ningún agujero junto a otro código de su bloque
    .detail = { $word }
    .help = Programe el ciclo en un bloque propio, detrás del código.

## Canned cycles by parameters

FC-0540 = Un parámetro del ciclo tiene un valor que no puede tener
    .detail = { $parameter } es { $value }, el límite es { $limit }
    .detail-2 = { $parameter }
    .help = Cambie el parámetro; `explain` y la página del ciclo en el manual dicen qué valores admite.
FC-0541 = Falta un parámetro que el ciclo necesita
    .detail = { $parameter }
    .help = Programe el parámetro detrás del código del ciclo.
FC-0542 = El ciclo no tiene profundidad que cortar
    .detail = { $parameter }
    .help = Dé al fondo otro nivel que a la superficie; descontada la demasía del fondo, debe quedar algo que desbastar.
FC-0543 = La herramienta es demasiado grande para lo que debe cortar
    .detail = { $parameter }: radio { $value }, { $limit } como máximo
    .detail-2 = { $parameter }
    .help = Tome una herramienta menor, ensanche la cajera o el agujero, o deje menos demasía en la pared. Revise el radio en la tabla de herramientas.
FC-0544 = La herramienta es tan pequeña que quedaría un núcleo en el agujero
    .detail = { $parameter }: radio { $value }, { $limit } como mínimo
    .detail-2 = { $parameter }
    .help = Tome una herramienta mayor, o taladre antes y dé el diámetro pretaladrado.
FC-0545 = Las pasadas son más anchas que la herramienta
    .detail = { $parameter } es { $value }, el diámetro es { $limit }
    .detail-2 = { $parameter }
    .help = Programe una anchura no mayor que el diámetro de la herramienta, o 0 para tres cuartos de él.
FC-0546 = El paso 0 significa la longitud de corte, y la tabla de herramientas no la tiene
    .detail = { $parameter }
    .help = Programe el paso o introduzca la longitud de corte de la herramienta.
FC-0547 = El número de pasadas de pared es 0 y nada dice qué profundidad puede tener cada una
    .detail = { $parameter }
    .help = Programe el número de pasadas, introduzca la longitud de corte de la herramienta de acabado o haga el acabado con la de desbaste.
FC-0548 = La herramienta no puede entrar en el material con este ángulo
    .detail = { $parameter }
    .help = Programe un ángulo entre 0 y 90 grados. Si no hay sitio para bajar en ángulo, tome una herramienta menor, o programe 90 para una herramienta que pueda penetrar en vertical.
FC-0549 = El ciclo no tiene avance
    .detail = { $parameter }
    .help = Programe el avance del ciclo o de la etapa.
FC-0550 = El número de operaciones no es entero
    .detail = { $parameter }
    .help = Programe un número entero, o una distancia que divida la longitud.
FC-0551 = Los puntos que se omiten no están en orden creciente
    .detail = { $parameter }
    .help = Programe los puntos del primero al último en el orden de las letras. El último punto de un intervalo tiene tres cifras: 10.013 es de 10 a 13.
FC-0552 = Las posiciones están descritas con parámetros insuficientes o que se contradicen
    .detail = { $parameter }
    .help = Programe los parámetros de uno de los formatos, como longitud y número, o distancia y número.
FC-0553 = Parámetro de ciclo sin un ciclo que lo tenga
    .detail = { $variable }
    .help = Use las variables de un ciclo mientras el ciclo está activo, según las letras de su formato.
FC-0554 = El control no tiene esta directiva
    .detail = { $word }
    .help = Revise el nombre detrás del signo #; los ciclos que describe son de G281 a G299, P2D y P3D.
FC-0555 = El ciclo no tiene este parámetro
    .detail = { $parameter }
    .help = Revise el nombre; se distinguen mayúsculas y minúsculas, y las letras griegas se escriben como palabras.
FC-0556 = El parámetro no admite este valor
    .detail = { $parameter }
    .help = Dé un número donde se pide un número, una de sus palabras donde admite palabras, y [x,y] para un punto.
FC-0557 = Una parte de un ciclo está donde no corresponde
    .detail = { $word }
    .help = Ponga la parte justo detrás de su bloque #CYCLE, una vez, y solo donde el ciclo tenga esa parte.
FC-0558 = El perfil no existe
    .detail = { $parameter }
    .help = Defina el perfil con #PROFILE antes del ciclo que lo usa.
FC-0559 = No se puede leer el perfil
    .detail = { $parameter }, contorno { $contour }
    .detail-2 = { $parameter }
    .help = Un perfil empieza con G0, sigue con G1, G2, G3 y las esquinas G36 y G39, y acaba con #ENDPROFILE.
FC-0560 = El perfil está abierto
    .detail = { $parameter }, contorno { $contour }
    .detail-2 = { $parameter }
    .help = Haga que cada contorno de una cajera acabe donde empieza.
FC-0561 = El perfil se cruza consigo mismo o hay contornos que se cruzan
    .detail = { $parameter }, contorno { $contour }
    .detail-2 = { $parameter }
    .help = Corrija los contornos; las islas están dentro del exterior y no lo tocan ni se tocan entre sí.
FC-0562 = No hay sitio para un redondeo o chaflán del perfil
    .detail = { $parameter }
    .help = Hágalo más pequeño, o más largos los elementos contiguos; va entre dos elementos.
FC-0563 = No hay sitio para la entrada o salida tangencial del perfil
    .detail = { $parameter }
    .help = Programe un radio menor o un punto de entrada o salida más alejado; 0 es un camino recto.
FC-0564 = El plano no puede tener estos ejes
    .detail = { $axis }
    .help = Indique tres ejes distintos. Los arcos y los ciclos de fresado necesitan los planos de X, Y y Z, con la herramienta según el tercer eje.
FC-0565 = Un contorno de la cajera no tiene área
    .detail = { $parameter }, contorno { $contour }
    .detail-2 = { $parameter }
    .help = Dé al contorno elementos que rodeen un área; uno que vuelve sobre sí mismo no tiene ninguna.
FC-0566 = Una isla no está dentro de la cajera
    .detail = { $parameter }, contorno { $contour }
    .detail-2 = { $parameter }
    .help = Defina primero el contorno exterior y después islas que estén por completo dentro de él.
FC-0567 = El perfil de profundidad no concuerda con su contorno
    .detail = { $parameter }
    .help = Empiécelo donde empieza su contorno, en la superficie para el contorno exterior y en el fondo para una isla, y hágalo seguir sin volver atrás.
FC-0568 = Las paredes inclinadas se juntan antes de que la cajera tenga la profundidad debida
    .detail = { $parameter }
    .help = Haga más verticales las paredes de este perfil de profundidad, menos profunda la cajera, o separe más los contornos.
FC-0569 = Junto a estas paredes no se puede calcular una trayectoria lo bastante exacta
    .detail = { $parameter }
    .help = Quite del perfil lo que sea mucho menor que la herramienta, o tome otro radio de herramienta u otra demasía de acabado.
FC-0575 = La herramienta baja en vertical en material macizo
    .detail = { $parameter }
    .help = Programe un ángulo de entrada, introduzca uno para la herramienta o taladre antes la cajera. Una herramienta con corte al centro no lo necesita.

FC-0470 = El movimiento de entrada de la compensación de radio no es más largo que el radio de la herramienta
    .help = Empiece más lejos del contorno: la entrada debe ser más larga que el radio.
FC-0471 = La herramienta no cabe en el arco
    .help = Use una herramienta cuyo radio sea menor que el del arco.
FC-0472 = El primer movimiento después de la compensación de radio es un arco
    .help = Salga del contorno con un movimiento G00 o G01.

FC-0319 = Avance por vuelta con velocidad de husillo 0
    .help = Dé S antes del movimiento o use G94.

FC-0320 = El movimiento tras el chaflán o redondeo sale del plano
    .help = Mueva allí solo los dos ejes del plano.

FC-0321 = Con compensación de radio un arco empieza en su centro
    .help = Revise I, J y K: son las distancias del inicio del arco a su centro.

FC-0322 = El arco termina donde empieza: nada se mueve
    .help = Un radio no define un círculo completo. Programe su centro con I, J o K, o revise el punto final.

FC-0448 = Cambio de herramienta con compensación de radio
    .help = Anule antes la compensación con G40.

FC-0449 = No se pueden desplazar los sistemas de coordenadas con compensación de radio
    .help = Anule antes la compensación con G40.

FC-0450 = Retorno al punto de referencia con compensación de radio
    .help = Anule antes la compensación con G40.

FC-0614 = La etiqueta ya se había dado
    .help = Dé a cada bucle, condición y subprograma una etiqueta propia. A la definición de un subprograma que ya se ha llamado no se puede llegar desde arriba: ponga las definiciones después de M2 o antes de las llamadas.

FC-0615 = Aquí no hay abierto ningún bucle ni condición con esta etiqueta
    .help = Revise la etiqueta. Break y continue solo terminan pasadas de bucles while y do.

FC-0616 = Retorno fuera de un subprograma
    .help = Un subprograma empieza con sub y se ejecuta con call.

FC-0617 = Se define un subprograma dentro de otro
    .help = Termine la primera definición con endsub antes de la siguiente.

FC-0618 = Al programa no se le llama de la manera que le corresponde
    .help = Lo que empieza con sub se ejecuta con call; lo que empieza solo con su número O, con M98.

FC-0619 = Más etiquetas de las que tienen sentido
    .help = No calcule etiquetas sin fin.

FC-0620 = No hay ningún estado guardado que restaurar
    .help = Guárdelo antes con M70 o M73 en el mismo subprograma.

FC-0621 = Aquí los programas no escriben archivos
    .help = Elimine el comentario o muestre el texto con print o MSG.
FC-0330 = No hay arcos en los planos de U, V y W
    .help = Elija G17, G18 o G19.
FC-0331 = Un arco tiene a la vez radio y centro
    .help = Dé R, o el centro con dos de I, J y K.
FC-0332 = Una palabra del centro no corresponde al plano
    .help = I corresponde a X, J a Y, K a Z; solo puede haber las de los ejes del plano.
FC-0333 = Un arco dado por su radio acaba donde empieza
    .help = Dé en su lugar el centro: un radio no dice dónde está un círculo completo.
FC-0334 = Los splines están en el plano XY
    .help = Elija G17.
FC-0335 = A lo largo de un spline solo se mueven X e Y
    .help = Mueva los demás ejes en un bloque propio.
FC-0336 = Al spline le faltan puntos de control
    .detail = { $number } puntos de control, hacen falta al menos { $least }
    .help = Añada puntos de control o dé un orden menor con L.
FC-0337 = Acaba una NURBS que no se empezó
    .help = Describa antes sus puntos de control con G5.2, sin otro código de movimiento en medio.
FC-0338 = El spline es demasiado largo
    .detail = el límite es de { $limit } puntos
    .help = Divídalo en varios.
FC-0339 = El movimiento de palpado no tiene longitud
    .help = Empiece más lejos del punto hasta el que se palpa.
FC-0473 = La compensación de radio no funciona en este plano
    .help = Elija G17 o G18.
FC-0474 = La compensación de radio ya está activa
    .help = Anúlela antes con G40.
FC-0475 = Este código no se admite con compensación de radio
    .help = Anule antes la compensación con G40.
FC-0476 = Compensación de radio con una herramienta de torno
    .help = Use una herramienta de orientación 0 o 9; las demás todavía no se compensan.
FC-0477 = Y es un eje giratorio: en su plano no caben arcos, giros, compensación de radio ni figuras de taladros
    .help = Elija un plano sin Y, o escriba la forma con movimientos rectos.
FC-0570 = Este eje no se mueve en el ciclo
    .detail = { $axis }
    .help = Indique los ejes del plano y el perpendicular a él; mueva los demás en un bloque propio.
FC-0571 = Un ciclo fijo necesita otro modo de avance
    .help = Elija G94 o G95; G93 daría un tiempo a cada uno de sus movimientos.
FC-0572 = El husillo no gira
    .help = Arránquelo con M3 o M4 antes de este bloque.
FC-0573 = El husillo gira en el sentido contrario al de esta rosca
    .help = Haga las roscas a derechas con M3 y las roscas a izquierdas con M4.
FC-0574 = Las profundidades de la rosca no concuerdan entre sí
    .help = I no es 0, J es mayor que 0 y K es mayor que J.
FC-0622 = Con este lenguaje nadie cambia la herramienta en M6
    .help = Si el propio programa de contactos cambia la herramienta, o se cambia a mano, ponga program = 0 en [tool_change] del archivo de la máquina. En el husillo sigue la herramienta anterior.
FC-0623 = Dos programas del archivo tienen el mismo número o nombre
    .detail = { $program }
    .help = Dé a cada programa un número propio: una llamada ejecuta el primero de ellos.

# The running control.

FC-1400 = Eso no es posible en este modo
    .help = Elija antes el modo adecuado.
    .detail = modo { $mode }
FC-1401 = Eso no es posible mientras hay un programa en curso
    .help = Espere a que termine o abandónelo con reset.
FC-1402 = Hay en curso un programa de otro modo
    .help = Vuelva a su modo para continuarlo o abandónelo con reset.
    .detail = modo { $mode }
FC-1403 = No hay programa que ejecutar
    .help = Seleccione un programa o escriba bloques en MDI.
FC-1404 = La máquina no permite arrancar ahora
    .help = Mire los mensajes de la máquina: puede faltar una puerta, una presión o una sujeción.
FC-1405 = Hay una alarma activa
    .help = Elimine la causa y después pulse reset.
FC-1406 = Este control no tiene lo necesario para eso
    .help = Se arrancó sin diagrama de contactos o sin memoria permanente.
    .detail = falta: { $name }
FC-1407 = No hay nada con ese nombre
    .help = Revise cómo está escrito.
    .detail = { $name }
FC-1408 = No se puede cambiar el programa en curso
    .help = Espere a que termine o edite otro programa.
    .detail = programa { $name }
FC-1409 = Ese valor no es posible
    .help = Introduzca un valor dentro del rango.
    .detail = { $name }: de { $min } a { $max }
    .detail-2 = { $name }
FC-1410 = Parada de emergencia
    .help = Elimine el peligro, suelte el pulsador y lleve de nuevo los ejes a sus puntos de referencia.
FC-1411 = El programa no tiene ningún bloque ahí
    .help = Elija una línea del programa.
    .detail = línea { $line }
FC-1412 = El diagrama de contactos está parado
    .help = Corríjalo y arránquelo de nuevo; hasta entonces todas las salidas están desactivadas.
FC-1413 = Se hizo un cambio y no se pudo guardar
    .help = Revise el disco; el cambio se pierde al apagar.
    .detail = { $reason }
FC-1414 = No se reanuda un programa con ejes sin referenciar
    .detail = eje { $axis }
    .help = Referencie los ejes y prepare de nuevo la reanudación.
FC-1415 = El programa interrumpido no es el seleccionado
    .detail = interrumpido: { $name }
    .help = Seleccione el programa que se interrumpió o dé una línea de este.
FC-1416 = El programa o los datos no son los de antes
    .detail = { $name }
    .help = Prepare de nuevo la reanudación; dé la línea si se cambió el programa.
FC-1417 = La herramienta o el husillo no están como los tiene el programa
    .detail = { $name }
    .help = Escriba en MDI los códigos que muestra la página de reanudación o haga que los envíe el control. Un programa detenido continúa cuando el husillo gira como se indica: enciéndalo con su tecla en un modo manual.
FC-1418 = Todavía no hay sitio para más programa
    .help = Envíe otra vez esta parte cuando se hayan ejecutado bloques.
FC-1419 = El interruptor de parámetros está desactivado
    .help = Actívelo en la página de ajustes, en MDI.
FC-1427 = El interruptor de programas está desactivado
    .help = Actívelo en la página de ajustes, en MDI. Requiere el nivel 4.
FC-1428 = Esta señal no se puede fijar
    .help = Se pueden fijar los datos del programa de contactos: K, T, C y D. Las demás señales se fuerzan.
    .detail = { $name }
FC-1429 = Ahora los ejes no pueden retroceder por la trayectoria
    .help = Retroceden mientras un programa está parado con la parada de avance y los ejes están en su trayectoria: no en una rosca, ni en una temporización, ni durante la búsqueda de referencia, ni con el enclavamiento del movimiento. Pulse antes la parada de avance.

FC-1430 = La búsqueda de cero no encuentra el interruptor de referencia
    .detail = eje { $axis }
    .help = Revise el interruptor de referencia, su nivel y el sentido de la búsqueda.
FC-1431 = La búsqueda de cero no encuentra la marca del encoder
    .detail = eje { $axis }
    .help = Revise la señal de la marca del encoder y si la máquina usa marcas en la búsqueda de cero.
FC-1432 = Parada de emergencia durante la búsqueda de cero
    .detail = eje { $axis }
    .help = Suelte la parada de emergencia y referencie otra vez el eje.
FC-1433 = Un programa mueve un eje sin referenciar
    .detail = eje { $axis }
    .help = Referencie el eje y arranque de nuevo el programa.
FC-1434 = El código necesita un eje referenciado
    .detail = eje { $axis }
    .help = Referencie el eje y arranque de nuevo el programa.
FC-1435 = Los programas no pueden referenciar un eje
    .detail = eje { $axis }
    .help = Referencie el eje a mano.
FC-1436 = Un eje está sobre su final de carrera
    .detail = { $axis }{ $side }
    .help = Mantenga pulsada la liberación de límite y retire el eje a mano.

## 1460: over a connection

FC-1460 = Eso lleva a líneas del programa que no están aquí
    .help = Un programa enviado línea a línea solo avanza. Guárdelo antes o llame a uno guardado.
FC-1461 = Ahí no se puede conectar nadie
    .detail = { $place }: { $reason }
    .help = Elija otro puerto o ruta o cierre lo que lo ocupa.
FC-1440 = No hay ningún bloque en esta línea ni debajo
    .detail = línea { $line }
    .help = Dé una línea del programa en la que empiece un bloque.

FC-1441 = El programa no llega al bloque tantas veces como se pide
    .detail = veces que se alcanza la línea { $line }: { $passes }
    .help = Pida menos veces, o dé una línea que se ejecute con las variables, entradas e interruptores actuales.

FC-1442 = El orden de los ejes en el camino a la reanudación es incorrecto
    .help = Indique cada eje de la máquina exactamente una vez.

FC-1443 = No se interrumpió nada
    .help = Dé la línea en la que reanudar el programa.

FC-1444 = No se reanuda un programa con los ejes en marcha
    .help = Pulse reset y espere a que los ejes se detengan.

FC-1445 = No se conocen los valores que la máquina dio al programa la primera vez
    .detail = lugares: { $count }; se toma la posición de consigna en lugar de la de la máquina
    .help = Revise lo que el programa midió antes de esta línea o empiece antes de medir.

## 1446: mensajes de la máquina

FC-1446 = Mensaje de la máquina
    .detail = { $name }
    .help = Viene del ladder de la máquina: la página de alarmas y el manual de la máquina dicen qué significa. Desaparece con su causa.

FC-1447 = Se ha cambiado un parámetro que vale a partir del próximo encendido
    .help = Hasta entonces el control sigue como antes. Apague el control y enciéndalo de nuevo, o devuelva el parámetro a su valor.

## 1470: measuring

FC-1470 = No hay palpador ni medidor de herramienta
    .detail = { $name }
    .help = Conéctelo a la entrada SKIP e indíquelo en los parámetros.
FC-1471 = El palpador toca donde debería estar libre
    .help = Sepárelo, revise su camino y su señal y empiece de nuevo la medición.
FC-1472 = El palpador no encontró nada
    .detail = { $axis } hasta { $position }
    .help = Revise la medida nominal, el centro y la altura; aumente el sobrerrecorrido si la pieza puede estar ahí.
FC-1473 = Esos puntos no dan ninguna forma
    .detail = { $name }
    .help = Tome de nuevo los puntos: tres no alineados para un círculo, dos por eje para una ranura.
FC-1474 = Hay ejes sin referenciar
    .detail = eje { $axis }
    .help = Referencie los ejes antes de medir.
FC-1475 = La medida está fuera de tolerancia
    .detail = { $value }, nominal { $nominal }, tolerancia { $limit }
    .help = No se guardó nada. Revise la pieza o la herramienta y mida de nuevo.
FC-1476 = Con ese valor no se puede medir
    .detail = { $name }
    .help = Introduzca todas las medidas y ángulos que necesita esta forma.
FC-1477 = Ahora no se puede medir
    .detail = { $name }
    .help = Quite la prueba en vacío y los bloqueos, pare el husillo y empiece de nuevo.
FC-1478 = No se encontró el medidor de herramienta
    .detail = { $axis } hasta { $position }
    .help = Revise el medidor, su altura y la longitud estimada de la herramienta.

## 1480: drives

FC-1480 = Los accionamientos no responden
    .detail = { $place }
    .help = Revise la alimentación y el cable de la tarjeta, y el enlace en el archivo de la máquina.
FC-1481 = Ya no se recibe nada de los accionamientos
    .detail = durante { $time } ms
    .help = Revise el cable y la alimentación de la tarjeta. Pulse reset y referencie de nuevo los ejes.
FC-1482 = La conexión con los accionamientos se ha cortado
    .detail = { $place }: { $reason }
    .help = Revise el cable y el puerto de la tarjeta. Pulse reset y referencie de nuevo los ejes.
FC-1483 = Los accionamientos no pueden hacer lo que pide el archivo de la máquina
    .detail = { $name }: se pide { $value }, es posible { $limit }
    .help = Cambie el valor en el archivo de la máquina o use otra tarjeta.
FC-1484 = Un eje debe moverse más rápido de lo que admiten sus pasos
    .detail = eje { $axis }: hacen falta { $value } pasos/s, son posibles { $limit }
    .help = Reduzca las velocidades del eje, sus pasos o sus tiempos de impulso en el archivo de la máquina.
FC-1485 = Los accionamientos se han parado porque no recibían nada
    .detail = durante { $time } ms
    .help = Revise el cable y la carga del ordenador. Pulse reset y referencie de nuevo los ejes.
FC-1486 = Una consigna llegó demasiado tarde a los accionamientos
    .help = Dé prioridad al hilo del control o alargue el búfer. Pulse reset y referencie de nuevo los ejes.
FC-1487 = Una consigna se perdió camino de los accionamientos
    .detail = tramas ilegibles: { $count }
    .help = Revise el cable, su pantalla y su longitud. Pulse reset y referencie de nuevo los ejes.
FC-1488 = Una consigna fue más rápida de lo que pueden seguir los accionamientos
    .detail = eje { $axis }
    .help = Revise las velocidades del eje y su compensación. Pulse reset y referencie de nuevo los ejes.
FC-1489 = La parada de emergencia ha parado los accionamientos
    .help = Elimine el peligro y suelte el pulsador. Pulse reset y referencie de nuevo los ejes.
FC-1490 = El amplificador de un eje avisa de un fallo
    .detail = eje { $axis }
    .help = Lea la indicación del amplificador y su manual. Pulse reset y referencie de nuevo los ejes.
FC-1491 = Los accionamientos se han parado
    .detail = código { $code }
    .help = Busque el código en el manual de la tarjeta. Pulse reset y referencie de nuevo los ejes.
FC-1492 = El husillo de esta máquina no se puede guiar por su ángulo
    .help = Rosque con un portamachos con compensador. La orientación necesita un diagrama de contactos que la pida al amplificador del husillo.
FC-1493 = Los emisores Grbl solo mueven una máquina simulada
    .help = Arranque la máquina sin --grbl o use un archivo de máquina sin [drives].
FC-1494 = el bloqueo de máquina está activado
    .help = Desactive antes el bloqueo de máquina: con él los ejes no están donde parecen.
FC-1495 = hay bloques leídos con el valor anterior
    .detail = hasta la línea { $line }
    .help = Se ejecutan con el valor anterior. Para que se ejecuten con el nuevo, introdúzcalo con el programa parado en M00 o antes del inicio.

# The panel in a browser
FC-1500 = El panel no está construido
    .help = Constrúyalo en la carpeta hmi con «npm ci» y «npm run build», y después Ferrocut de nuevo. El control funciona igualmente.

FC-1501 = El programa no se ha comprobado hasta el final
    .detail = a partir de la línea { $line }
    .help = Tiene demasiados errores o tarda demasiado. Corrija lo encontrado y compruébelo de nuevo; «ferrocut check» no tiene límites.

FC-1502 = El panel solo se ofrece a otros ordenadores por conexiones cifradas
    .detail = { $place }
    .help = Indique --tls-cert y --tls-key, o --tls-self-signed. O déjelo en este ordenador (127.0.0.1) y use un túnel.

FC-1503 = El panel solo se ofrece a otros ordenadores donde se pueda iniciar sesión
    .detail = { $place }
    .help = Indique la carpeta de la memoria con --memory y ponga en ella una contraseña con «ferrocut memory password».

FC-1504 = Este certificado o esta clave no sirve
    .detail = { $file }: { $reason }
    .help = Indique una cadena de certificados y su clave privada como archivos PEM, o --tls-self-signed.

FC-1505 = No se guarda nada: los programas, correctores y parámetros se pierden al terminar
    .help = Indique una carpeta donde guardarlos: --memory /var/lib/ferrocut. Una carpeta vacía o que aún no existe se convierte en una memoria nueva.
