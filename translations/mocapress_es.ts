<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es">
<context>
    <name>mocapress::Actions</name>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Abrir…</translation>
    </message>
    <message>
        <source>Open a motion or a compressed clip (.mcpr)</source>
        <translation>Abrir un movimiento o un clip comprimido (.mcpr)</translation>
    </message>
    <message>
        <source>Open Sample &amp;Walk</source>
        <translation>Abrir la &amp;marcha de ejemplo</translation>
    </message>
    <message>
        <source>Choose Skeleton…</source>
        <translation>Elegir esqueleto…</translation>
    </message>
    <message>
        <source>&amp;Compare with Original…</source>
        <translation>&amp;Comparar con el original…</translation>
    </message>
    <message>
        <source>Save the compressed clip as .mcpr</source>
        <translation>Guardar el clip comprimido como .mcpr</translation>
    </message>
    <message>
        <source>A&amp;dd Clips to Library…</source>
        <translation>Aña&amp;dir clips a la biblioteca…</translation>
    </message>
    <message>
        <source>&amp;New Project</source>
        <translation>&amp;Nuevo proyecto</translation>
    </message>
    <message>
        <source>Open Pro&amp;ject…</source>
        <translation>Abrir pro&amp;yecto…</translation>
    </message>
    <message>
        <source>Sa&amp;ve Project As…</source>
        <translation>G&amp;uardar proyecto como…</translation>
    </message>
    <message>
        <source>Switch between &amp;A and B</source>
        <translation>Alternar entre &amp;A y B</translation>
    </message>
    <message>
        <source>&amp;Copy Settings to the Other</source>
        <translation>&amp;Copiar los ajustes al otro</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>Next &amp;Worst Frame</source>
        <translation>Siguiente &amp;peor fotograma</translation>
    </message>
    <message>
        <source>Go to the frame with the largest error, then to the next largest (N)</source>
        <translation>Ir al fotograma con el mayor error y luego al siguiente en tamaño (N)</translation>
    </message>
    <message>
        <source>P&amp;revious Worst Frame</source>
        <translation>Pe&amp;or fotograma anterior</translation>
    </message>
    <message>
        <source>&amp;Hold Feet</source>
        <translation>Su&amp;jetar los pies</translation>
    </message>
    <message>
        <source>Compress with or without inverse kinematics (I)</source>
        <translation>Comprimir con o sin cinemática inversa (I)</translation>
    </message>
    <message>
        <source>Without I&amp;K</source>
        <translation>Sin I&amp;K</translation>
    </message>
    <message>
        <source>Show the compressed figure without the IK correction of its feet (B)</source>
        <translation>Mostrar la figura comprimida sin la corrección IK de los pies (B)</translation>
    </message>
    <message>
        <source>Reset La&amp;yout</source>
        <translation>Restablecer la disposició&amp;n</translation>
    </message>
    <message>
        <source>&amp;Study…</source>
        <translation>&amp;Estudio…</translation>
    </message>
    <message>
        <source>Compare the file sizes and errors of methods on many clips</source>
        <translation>Comparar tamaños y errores de los métodos en muchos clips</translation>
    </message>
    <message>
        <source>&amp;Guide</source>
        <translation>&amp;Guía</translation>
    </message>
    <message>
        <source>&amp;Keyboard Shortcuts</source>
        <translation>&amp;Atajos de teclado</translation>
    </message>
    <message>
        <source>Like the &amp;System</source>
        <translation>Como el &amp;sistema</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Claro</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Oscuro</translation>
    </message>
    <message>
        <source>&amp;About Mocapress</source>
        <translation>Acerca &amp;de Mocapress</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Abrir &amp;reciente</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Edición</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Reproducir</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>The&amp;me</source>
        <translation>Te&amp;ma</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>&amp;Idioma</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Herramientas</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>&amp;Batch Export…</source>
        <translation>Exportación por &amp;lotes…</translation>
    </message>
    <message>
        <source>Compress many clips, verify each of them and write a report</source>
        <translation>Comprimir muchos clips, verificar cada uno y escribir un informe</translation>
    </message>
    <message>
        <source>Batch Export of the &amp;Library…</source>
        <translation>Exportación por lotes de la &amp;biblioteca…</translation>
    </message>
    <message>
        <source>Export all clips of the library, each with its own settings</source>
        <translation>Exportar todos los clips de la biblioteca, cada uno con sus ajustes</translation>
    </message>
    <message>
        <source>Add &amp;Folder to Library…</source>
        <translation>A&amp;ñadir carpeta a la biblioteca…</translation>
    </message>
    <message>
        <source>&amp;Pin This Result</source>
        <translation>&amp;Fijar este resultado</translation>
    </message>
    <message>
        <source>Keep this result in the view beside results of other settings (D)</source>
        <translation>Mantener este resultado en la vista junto a los de otros ajustes (D)</translation>
    </message>
    <message>
        <source>Error S&amp;cale</source>
        <translation>Escala de &amp;error</translation>
    </message>
    <message>
        <source>Recent Projec&amp;ts</source>
        <translation>Proyec&amp;tos recientes</translation>
    </message>
    <message>
        <source>Save as .mcpr, .bvh, .fbx, .glb, .amc with its .asf, or .csv</source>
        <translation>Guardar como .mcpr, .bvh, .fbx, .glb, .amc con su .asf, o .csv</translation>
    </message>
    <message>
        <source>E&amp;xport Motion…</source>
        <translation>E&amp;xportar movimiento…</translation>
    </message>
    <message>
        <source>Write the decompressed motion with the unit, axes and rate of its source</source>
        <translation>Escribir el movimiento descomprimido con la unidad, los ejes y la cadencia de su fuente</translation>
    </message>
    <message>
        <source>Export Review Pa&amp;ge…</source>
        <translation>Exportar página de re&amp;visión…</translation>
    </message>
    <message>
        <source>Write a web page that shows original and compressed clip</source>
        <translation>Escribir una página web que muestra el clip original y el comprimido</translation>
    </message>
    <message>
        <source>&amp;Import Options…</source>
        <translation>Opciones de &amp;importación…</translation>
    </message>
    <message>
        <source>Read the open motion again with another length unit, up axis, frame rate or root convention</source>
        <translation>Leer de nuevo el movimiento abierto con otra unidad de longitud, eje vertical, cadencia o convención de la raíz</translation>
    </message>
    <message>
        <source>Put a C&amp;haracter on It…</source>
        <translation>Ponerle un &amp;personaje…</translation>
    </message>
    <message>
        <source>Show the clip, and all clips with the same rig, on the mesh of an FBX or glTF whose joints have the same names</source>
        <translation>Mostrar el clip, y todos los que tienen el mismo rig, sobre la malla de un FBX o glTF cuyas articulaciones tienen los mismos nombres</translation>
    </message>
    <message>
        <source>Ta&amp;ke Its Character Off</source>
        <translation>&amp;Quitarle el personaje</translation>
    </message>
    <message>
        <source>Show the clip, and all clips with the same rig, as in their files</source>
        <translation>Mostrar el clip, y todos los que tienen el mismo rig, como en sus archivos</translation>
    </message>
    <message>
        <source>Angle Scale</source>
        <translation>Escala de ángulos</translation>
    </message>
    <message>
        <source>Colours and S&amp;cales</source>
        <translation>Colores &amp;y escalas</translation>
    </message>
    <message>
        <source>Pane&amp;ls</source>
        <translation>Pa&amp;neles</translation>
    </message>
    <message>
        <source>&amp;Save Compressed Clip</source>
        <translation>&amp;Guardar clip comprimido</translation>
    </message>
    <message>
        <source>Save Compressed Clip &amp;As…</source>
        <translation>Guardar clip comprimido c&amp;omo…</translation>
    </message>
    <message>
        <source>Next to &amp;Review</source>
        <translation>Siguiente por &amp;revisar</translation>
    </message>
    <message>
        <source>Open the next clip that waits for a verdict (Q)</source>
        <translation>Abrir el siguiente clip que espera un veredicto (Q)</translation>
    </message>
    <message>
        <source>&amp;Approve, and Next</source>
        <translation>&amp;Aprobar y siguiente</translation>
    </message>
    <message>
        <source>Re&amp;ject, and Next</source>
        <translation>Rec&amp;hazar y siguiente</translation>
    </message>
    <message>
        <source>&amp;Note on This Frame…</source>
        <translation>&amp;Nota en este fotograma…</translation>
    </message>
    <message>
        <source>Next No&amp;te</source>
        <translation>Siguien&amp;te nota</translation>
    </message>
    <message>
        <source>&amp;Review</source>
        <translation>Revisió&amp;n</translation>
    </message>
    <message>
        <source>Ex&amp;port Sign-off…</source>
        <translation>Exportar &amp;hoja de visto bueno…</translation>
    </message>
    <message>
        <source>Write verdicts, worst frames and notes of the library as HTML, PDF or CSV</source>
        <translation>Escribir veredictos, peores fotogramas y notas de la biblioteca como HTML, PDF o CSV</translation>
    </message>
    <message>
        <source>Write a note on the frame that is shown and the joint that is chosen. A click with Ctrl in the picture writes one on a place there.</source>
        <translation>Escribir una nota en el fotograma que se muestra y la articulación elegida. Un clic con Ctrl en la imagen la escribe en ese lugar.</translation>
    </message>
    <message>
        <source>&amp;Write Notes beside the Clips</source>
        <translation>&amp;Escribir las notas junto a los clips</translation>
    </message>
    <message>
        <source>Write the notes of each clip to NAME.notes.json in its folder</source>
        <translation>Escribir las notas de cada clip en NAME.notes.json, en su carpeta</translation>
    </message>
    <message>
        <source>Rea&amp;d Notes beside the Clips</source>
        <translation>&amp;Leer las notas junto a los clips</translation>
    </message>
    <message>
        <source>Add notes from the files NAME.notes.json beside the clips</source>
        <translation>Añadir las notas de los archivos NAME.notes.json que están junto a los clips</translation>
    </message>
    <message>
        <source>Copy &amp;Link to This Frame</source>
        <translation>Cop&amp;iar enlace a este fotograma</translation>
    </message>
    <message>
        <source>Copy a link that opens this clip, frame, joint and view</source>
        <translation>Copiar un enlace que abre este clip, fotograma, articulación y vista</translation>
    </message>
    <message>
        <source>&amp;Blind Test…</source>
        <translation>Prueba &amp;ciega…</translation>
    </message>
    <message>
        <source>Find out from which error on you tell the compressed clip from the original</source>
        <translation>Averiguar a partir de qué error se distingue el clip comprimido del original</translation>
    </message>
    <message>
        <source>Copy Pict&amp;ure of the View</source>
        <translation>Copiar &amp;imagen de la vista</translation>
    </message>
    <message>
        <source>Save Picture of the &amp;View…</source>
        <translation>Guardar imagen de la &amp;vista…</translation>
    </message>
    <message>
        <source>&amp;Film of the Range…</source>
        <translation>&amp;Película del intervalo…</translation>
    </message>
    <message>
        <source>Write the chosen range, or the clip, as a video or as numbered pictures</source>
        <translation>Escribir el intervalo elegido, o el clip, como vídeo o como imágenes numeradas</translation>
    </message>
    <message>
        <source>&amp;Turntable…</source>
        <translation>Vuelta comple&amp;ta…</translation>
    </message>
    <message>
        <source>Write this frame from all sides as a video or as numbered pictures</source>
        <translation>Escribir este fotograma desde todos los lados como vídeo o como imágenes numeradas</translation>
    </message>
    <message>
        <source>&amp;Find a Command…</source>
        <translation>&amp;Buscar una orden…</translation>
    </message>
    <message>
        <source>Keyboard &amp;Map…</source>
        <translation>&amp;Mapa del teclado…</translation>
    </message>
    <message>
        <source>Choose the keys of all commands</source>
        <translation>Elegir las teclas de todas las órdenes</translation>
    </message>
    <message>
        <source>Pict&amp;ures and Films</source>
        <translation>Imágenes y &amp;filmes</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Línea de tiempo</translation>
    </message>
    <message>
        <source>Pin What an &amp;Engine Would Do</source>
        <translation>Fijar lo que haría un &amp;motor</translation>
    </message>
    <message>
        <source>Compress the clip track by track, with key frames, to the same number of bytes, and show it beside this result</source>
        <translation>Comprimir el clip pista por pista, con fotogramas clave, al mismo número de bytes y mostrarlo junto a este resultado</translation>
    </message>
    <message>
        <source>Compare in the Ran&amp;ge</source>
        <translation>Comparar en el inter&amp;valo</translation>
    </message>
    <message>
        <source>Loop the chosen range with both figures side by side, and show its errors alone</source>
        <translation>Reproducir el intervalo elegido en bucle, con las dos figuras lado a lado, y mostrar solo sus errores</translation>
    </message>
    <message>
        <source>Fold Panels Below</source>
        <translation>Plegar los paneles de abajo</translation>
    </message>
    <message>
        <source>Fold the panels below the timeline to their tabs, or unfold them</source>
        <translation>Plegar en sus pestañas los paneles bajo la línea de tiempo, o desplegarlos</translation>
    </message>
    <message>
        <source>Co&amp;mpare Library with a Batch…</source>
        <translation>Comparar la bibliot&amp;eca con un lote…</translation>
    </message>
    <message>
        <source>Show what got larger, worse or newly visible since an earlier batch or project</source>
        <translation>Mostrar lo que es mayor, peor o ahora visible desde un lote o proyecto anterior</translation>
    </message>
    <message>
        <source>Note on the Ran&amp;ge…</source>
        <translation>Nota en el inter&amp;valo…</translation>
    </message>
    <message>
        <source>Write a note on the chosen range and the joint that is chosen</source>
        <translation>Escribe una nota sobre el intervalo y la articulación elegidos</translation>
    </message>
</context>
<context>
    <name>mocapress::AnnealingPanel</name>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Progress of the refinement</source>
        <translation>Avance del refinamiento</translation>
    </message>
    <message>
        <source>Stop refining. The best result so far is kept if it is better than the draft.</source>
        <translation>Dejar de refinar. Se conserva el mejor resultado hasta ahora si es mejor que el borrador.</translation>
    </message>
    <message>
        <source>%L1 s left</source>
        <translation>quedan %L1 s</translation>
    </message>
    <message>
        <source>%L1 min left</source>
        <translation>quedan %L1 min</translation>
    </message>
    <message>
        <source>Progress of refining the draft. Annealing moves fewer and fewer coefficients at a time; the closed loop sweeps over all coefficients until no change helps. Most targets need several passes, whose number is an estimate.</source>
        <translation>Avance del refinamiento del borrador. El recocido mueve cada vez menos coeficientes; el bucle cerrado recorre todos los coeficientes hasta que ningún cambio ayuda. La mayoría de los objetivos necesita varias pasadas, cuyo número es una estimación.</translation>
    </message>
    <message>
        <source>Time left</source>
        <translation>Tiempo restante</translation>
    </message>
</context>
<context>
    <name>mocapress::BatchOutput</name>
    <message>
        <source>Replace existing files</source>
        <translation>Reemplazar los archivos existentes</translation>
    </message>
    <message>
        <source>Pattern of file names</source>
        <translation>Patrón de los nombres de archivo</translation>
    </message>
    <message>
        <source>If this is off, a clip fails when its file exists and is not from this batch. A file is replaced only after the new one was read back and measured.</source>
        <translation>Si está desactivado, un clip falla cuando su archivo existe y no es de este lote. Un archivo se reemplaza solo después de releer y medir el nuevo.</translation>
    </message>
    <message>
        <source>Compressed (.mcpr)</source>
        <translation>Comprimido (.mcpr)</translation>
    </message>
    <message>
        <source>The compressed file, to be shipped.</source>
        <translation>El archivo comprimido, el que se distribuye.</translation>
    </message>
    <message>
        <source>BVH</source>
        <translation>BVH</translation>
    </message>
    <message>
        <source>The decompressed motion.</source>
        <translation>El movimiento descomprimido.</translation>
    </message>
    <message>
        <source>ASF/AMC</source>
        <translation>ASF/AMC</translation>
    </message>
    <message>
        <source>The decompressed motion and its skeleton.</source>
        <translation>El movimiento descomprimido y su esqueleto.</translation>
    </message>
    <message>
        <source>CSV</source>
        <translation>CSV</translation>
    </message>
    <message>
        <source>The decompressed channels as a table.</source>
        <translation>Los canales descomprimidos como tabla.</translation>
    </message>
    <message>
        <source>FBX</source>
        <translation>FBX</translation>
    </message>
    <message>
        <source>The decompressed motion on its skeleton, for Maya, MotionBuilder and engines.</source>
        <translation>El movimiento descomprimido sobre su esqueleto, para Maya, MotionBuilder y motores.</translation>
    </message>
    <message>
        <source>glTF (.glb)</source>
        <translation>glTF (.glb)</translation>
    </message>
    <message>
        <source>The decompressed motion on its skeleton, for Blender and engines.</source>
        <translation>El movimiento descomprimido sobre su esqueleto, para Blender y motores.</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Carpeta</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Nombres</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Archivos</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>Folder of the batch: %1</source>
        <translation>Carpeta del lote: %1</translation>
    </message>
    <message>
        <source>Folder for files and report. If it holds a batch, that batch is resumed.</source>
        <translation>Carpeta para los archivos y el informe. Si contiene un lote, ese lote se reanuda.</translation>
    </message>
    <message>
        <source>&lt;p&gt;{folder}: the folder that was added, and its subfolders down to the clip&lt;br&gt;{stem}: the clip&apos;s name&lt;br&gt;{type}: the source&apos;s format, such as bvh&lt;br&gt;{preset}, {method}: the preset and method of the clip&lt;/p&gt;</source>
        <translation>&lt;p&gt;{folder}: la carpeta que se añadió y sus subcarpetas hasta el clip&lt;br&gt;{stem}: el nombre del clip&lt;br&gt;{type}: el formato de la fuente, como bvh&lt;br&gt;{preset}, {method}: el preajuste y el método del clip&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Bank of all clips</source>
        <translation>Banco de todos los clips</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>Packed</source>
        <translation>Compacto</translation>
    </message>
    <message>
        <source>Cooked</source>
        <translation>Preparado</translation>
    </message>
    <message>
        <source>&lt;p&gt;One more file, bank.mcpk, with all compressed clips.&lt;br&gt;Packed: the smallest, for shipping.&lt;br&gt;Cooked: engines sample its clips without unpacking them.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Un archivo más, bank.mcpk, con todos los clips comprimidos.&lt;br&gt;Compacto: el más pequeño, para distribuir.&lt;br&gt;Preparado: los motores muestrean sus clips sin desempaquetarlos.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Bank</source>
        <translation>Banco</translation>
    </message>
    <message>
        <source>Fit the coder to the clips</source>
        <translation>Adaptar el codificador a los clips</translation>
    </message>
    <message>
        <source>Fits the statistics of the coder to the clips of a packed bank. This takes up to a minute and saves 1 to 2 % of the bytes of some hundred clips. A bank of a few clips is not changed.</source>
        <translation>Adapta las estadísticas del codificador a los clips de un banco compacto. Tarda hasta un minuto y ahorra del 1 al 2 % de los bytes de unos cien clips. Un banco de pocos clips no cambia.</translation>
    </message>
</context>
<context>
    <name>mocapress::BatchQueueModel</name>
    <message>
        <source>Reading</source>
        <translation>Leyendo</translation>
    </message>
    <message>
        <source>Compressing</source>
        <translation>Comprimiendo</translation>
    </message>
    <message>
        <source>Verifying</source>
        <translation>Verificando</translation>
    </message>
    <message>
        <source>%1:1</source>
        <translation>%1:1</translation>
    </message>
    <message>
        <source>r = %1</source>
        <translation>r = %1</translation>
    </message>
    <message>
        <source>eps_x %1 cm</source>
        <translation>eps_x %1 cm</translation>
    </message>
    <message>
        <source>at most %1 cm</source>
        <translation>como máximo %1 cm</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>En espera</translation>
    </message>
    <message>
        <source>%1, %L2 %</source>
        <translation>%1, %L2 %</translation>
    </message>
    <message>
        <source>✓ Verified</source>
        <translation>✓ Verificado</translation>
    </message>
    <message>
        <source>✗ %1</source>
        <translation>✗ %1</translation>
    </message>
    <message>
        <source>Locked: the clip keeps its own settings. Click to give it the settings shared by all clips.</source>
        <translation>Bloqueado: el clip conserva sus propios ajustes. Haga clic para darle los ajustes comunes a todos los clips.</translation>
    </message>
    <message>
        <source>Click to lock the clip&apos;s settings, so that changes for all clips do not apply to it.</source>
        <translation>Haga clic para bloquear los ajustes del clip, de modo que los cambios para todos los clips no se le apliquen.</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>bloqueado</translation>
    </message>
    <message>
        <source>not locked</source>
        <translation>no bloqueado</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Clip</translation>
    </message>
    <message>
        <source>Locked clips keep their own settings.</source>
        <translation>Los clips bloqueados conservan sus propios ajustes.</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Ajustes</translation>
    </message>
    <message>
        <source>The preset and its target.</source>
        <translation>El preajuste y su objetivo.</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Verified: the file was read back, decoded and measured.</source>
        <translation>Verificado: el archivo se releyó, descodificó y midió.</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Tasa</translation>
    </message>
    <message>
        <source>Bytes of the channels as 32-bit floats, divided by compressed bytes.</source>
        <translation>Bytes de los canales como flotantes de 32 bits, divididos por los bytes comprimidos.</translation>
    </message>
    <message>
        <source>eps_x cm</source>
        <translation>eps_x cm</translation>
    </message>
    <message>
        <source>Weighted root mean square error.</source>
        <translation>Error cuadrático medio ponderado.</translation>
    </message>
    <message>
        <source>Max cm</source>
        <translation>Máx. cm</translation>
    </message>
    <message>
        <source>Largest error of any point at any frame.</source>
        <translation>Mayor error de cualquier punto en cualquier fotograma.</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Excluido</translation>
    </message>
    <message numerus="yes">
        <source>✓ Verified, %Ln warning(s)</source>
        <translation>
            <numerusform>✓ Verificado, %Ln aviso</numerusform>
            <numerusform>✓ Verificado, %Ln avisos</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The clip is not exported. Tick it to export it too.</source>
        <translation>El clip no se exporta. Márquelo para exportarlo también.</translation>
    </message>
    <message>
        <source>Only ticked clips are exported.</source>
        <translation>Solo se exportan los clips marcados.</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
    <message>
        <source>not visible</source>
        <translation>no visible</translation>
    </message>
    <message>
        <source>%1 times the noticeable error</source>
        <translation>%1 veces el error perceptible</translation>
    </message>
    <message>
        <source>The clip&apos;s verdict in the library. Rejected clips are exported only if they are ticked. A verdict is stale if files or settings have changed since.</source>
        <translation>El veredicto del clip en la biblioteca. Los clips rechazados se exportan solo si están marcados. Un veredicto ha caducado si los archivos o los ajustes han cambiado desde entonces.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln care range(s)</source>
        <translation>
            <numerusform>%Ln intervalo cuidado</numerusform>
            <numerusform>%Ln intervalos cuidados</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mocapress::BatchQueueView</name>
    <message>
        <source>Clips of the batch</source>
        <translation>Clips del lote</translation>
    </message>
    <message>
        <source>Remove from Queue</source>
        <translation>Quitar de la cola</translation>
    </message>
    <message>
        <source>Drop clips or folders of clips here</source>
        <translation>Suelte aquí clips o carpetas de clips</translation>
    </message>
    <message>
        <source>The .asf beside an .amc is found</source>
        <translation>El .asf que está junto a un .amc se encuentra solo</translation>
    </message>
    <message>
        <source>Leave Out</source>
        <translation>Excluir</translation>
    </message>
    <message>
        <source>Export Too</source>
        <translation>Exportar también</translation>
    </message>
</context>
<context>
    <name>mocapress::BatchSession</name>
    <message>
        <source>Add clips to begin.</source>
        <translation>Añada clips para empezar.</translation>
    </message>
    <message>
        <source>Choose a folder for the files.</source>
        <translation>Elija una carpeta para los archivos.</translation>
    </message>
    <message>
        <source>Choose at least one file format.</source>
        <translation>Elija al menos un formato de archivo.</translation>
    </message>
    <message>
        <source>Wrote %1: submit it with sbatch.</source>
        <translation>%1 escrito: envíelo con sbatch.</translation>
    </message>
    <message>
        <source>Clips can be added after the batch has ended.</source>
        <translation>Se pueden añadir clips cuando el lote haya terminado.</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Salida</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Ajustes</translation>
    </message>
    <message>
        <source>Remove Clips</source>
        <translation>Quitar clips</translation>
    </message>
    <message>
        <source>Add Clips</source>
        <translation>Añadir clips</translation>
    </message>
    <message>
        <source>Leave Out Clips</source>
        <translation>Excluir clips</translation>
    </message>
    <message>
        <source>Export Clips Too</source>
        <translation>Exportar también los clips</translation>
    </message>
    <message>
        <source>Every clip is left out. Tick the clips to export.</source>
        <translation>Todos los clips están excluidos. Marque los que se deban exportar.</translation>
    </message>
    <message>
        <source>A bank needs compressed files: choose Compressed (.mcpr) too.</source>
        <translation>Un banco necesita archivos comprimidos: elija también Comprimido (.mcpr).</translation>
    </message>
    <message>
        <source>A cluster&apos;s tasks cannot make a bank, since none has all clips: set Bank to None to write a script.</source>
        <translation>Las tareas de un clúster no pueden hacer un banco, pues ninguna tiene todos los clips: ponga Banco en Ninguno para escribir un script.</translation>
    </message>
    <message>
        <source>Character</source>
        <translation>Personaje</translation>
    </message>
</context>
<context>
    <name>mocapress::BatchStatus</name>
    <message numerus="yes">
        <source>, %Ln failed</source>
        <translation>
            <numerusform>, %Ln fallido</numerusform>
            <numerusform>, %Ln fallidos</numerusform>
        </translation>
    </message>
    <message>
        <source>%L1 of %L2</source>
        <translation>%L1 de %L2</translation>
    </message>
    <message>
        <source>%1, about %2 left</source>
        <translation>%1, quedan unos %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln clip(s) to export</source>
        <translation>
            <numerusform>%Ln clip por exportar</numerusform>
            <numerusform>%Ln clips por exportar</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln clip(s) exported and verified</source>
        <translation>
            <numerusform>%Ln clip exportado y verificado</numerusform>
            <numerusform>%Ln clips exportados y verificados</numerusform>
        </translation>
    </message>
    <message>
        <source>Paused at %1</source>
        <translation>En pausa en %1</translation>
    </message>
    <message>
        <source>Stopping after the current clips: %1</source>
        <translation>Se detiene tras los clips en curso: %1</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>Cancelando…</translation>
    </message>
    <message>
        <source>Stopped at %1; the next start continues from there</source>
        <translation>Detenido en %1; el próximo inicio continúa desde ahí</translation>
    </message>
    <message>
        <source>&amp;Go On</source>
        <translation>C&amp;ontinuar</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pausa</translation>
    </message>
    <message numerus="yes">
        <source>&amp;Retry %Ln Failed</source>
        <translation>
            <numerusform>&amp;Reintentar %Ln fallido</numerusform>
            <numerusform>&amp;Reintentar %Ln fallidos</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportar</translation>
    </message>
    <message numerus="yes">
        <source>, %Ln left out</source>
        <translation>
            <numerusform>, %Ln excluido</numerusform>
            <numerusform>, %Ln excluidos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %Ln with warnings</source>
        <translation>
            <numerusform>, %Ln con avisos</numerusform>
            <numerusform>, %Ln con avisos</numerusform>
        </translation>
    </message>
    <message>
        <source>Waiting for another program that is changing the bank…</source>
        <translation>Esperando a otro programa que está cambiando el banco…</translation>
    </message>
    <message>
        <source>Fitting the coder to the clips of the bank…</source>
        <translation>Adaptando el codificador a los clips del banco…</translation>
    </message>
    <message>
        <source>Making the bank: %L1 of %L2</source>
        <translation>Creando el banco: %L1 de %L2</translation>
    </message>
    <message numerus="yes">
        <source>, %Ln with a stale verdict</source>
        <translation>
            <numerusform>, %Ln con veredicto caducado</numerusform>
            <numerusform>, %Ln con veredicto caducado</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mocapress::BatchWindow</name>
    <message>
        <source>Use Shared Settings for Selection</source>
        <translation>Usar los ajustes comunes en la selección</translation>
    </message>
    <message>
        <source>&amp;Stop after Current</source>
        <translation>De&amp;tener tras el actual</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Cancelar</translation>
    </message>
    <message>
        <source>Slurm Script…</source>
        <translation>Script de Slurm…</translation>
    </message>
    <message>
        <source>Batch Export</source>
        <translation>Exportación por lotes</translation>
    </message>
    <message>
        <source>Add &amp;Files…</source>
        <translation>Añadir &amp;archivos…</translation>
    </message>
    <message>
        <source>Add motions</source>
        <translation>Añadir movimientos</translation>
    </message>
    <message>
        <source>Add Fol&amp;der…</source>
        <translation>Aña&amp;dir carpeta…</translation>
    </message>
    <message>
        <source>Add every motion below a folder</source>
        <translation>Añadir todos los movimientos de una carpeta y sus subcarpetas</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Salida</translation>
    </message>
    <message>
        <source>Progress of the batch</source>
        <translation>Avance del lote</translation>
    </message>
    <message>
        <source>Compress each clip, read the file back, measure it and put it in place. Finished clips that have not changed are kept.</source>
        <translation>Comprimir cada clip, releer el archivo, medirlo y ponerlo en su sitio. Se conservan los clips terminados que no han cambiado.</translation>
    </message>
    <message>
        <source>Finish the clips in progress and start no others</source>
        <translation>Terminar los clips en curso y no empezar otros</translation>
    </message>
    <message>
        <source>Stop the clips in progress and put them back in the queue</source>
        <translation>Detener los clips en curso y devolverlos a la cola</translation>
    </message>
    <message>
        <source>Open a page with the measurements of every clip and pictures of the worst frames</source>
        <translation>Abrir una página con las medidas de cada clip e imágenes de los peores fotogramas</translation>
    </message>
    <message>
        <source>Write a script for Slurm&apos;s sbatch that compresses this queue on a cluster</source>
        <translation>Escribir un script para sbatch de Slurm que comprime esta cola en un clúster</translation>
    </message>
    <message>
        <source>Add Clips</source>
        <translation>Añadir clips</translation>
    </message>
    <message>
        <source>Motion (%1)</source>
        <translation>Movimiento (%1)</translation>
    </message>
    <message>
        <source>Add All Clips below</source>
        <translation>Añadir todos los clips de la carpeta</translation>
    </message>
    <message>
        <source>Folder of the Batch</source>
        <translation>Carpeta del lote</translation>
    </message>
    <message>
        <source>Slurm Script</source>
        <translation>Script de Slurm</translation>
    </message>
    <message>
        <source>Tasks of the job array</source>
        <translation>Tareas del array de trabajos</translation>
    </message>
    <message>
        <source>Shell scripts (*.sh)</source>
        <translation>Scripts de shell (*.sh)</translation>
    </message>
    <message>
        <source>Settings of all clips</source>
        <translation>Ajustes de todos los clips</translation>
    </message>
    <message numerus="yes">
        <source>Settings of %Ln selected clip(s)</source>
        <translation>
            <numerusform>Ajustes de %Ln clip seleccionado</numerusform>
            <numerusform>Ajustes de %Ln clips seleccionados</numerusform>
        </translation>
    </message>
    <message>
        <source>Changes made while clips are selected apply to these clips only, and lock them.</source>
        <translation>Los cambios hechos con clips seleccionados se aplican solo a ellos, y los bloquean.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rehacer</translation>
    </message>
    <message>
        <source>Open Rep&amp;ort</source>
        <translation>Abrir &amp;informe</translation>
    </message>
    <message>
        <source>Character on all clips</source>
        <translation>Personaje en todos los clips</translation>
    </message>
    <message>
        <source>Character on All Clips</source>
        <translation>Personaje en todos los clips</translation>
    </message>
    <message>
        <source>Report: %1</source>
        <translation>Informe: %1</translation>
    </message>
</context>
<context>
    <name>mocapress::BlindTestWindow</name>
    <message>
        <source>Blind Test</source>
        <translation>Prueba ciega</translation>
    </message>
    <message>
        <source>Viewer</source>
        <translation>Observador</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Viewing distance</source>
        <translation>Distancia de observación</translation>
    </message>
    <message>
        <source>Distance at which a person would look as tall as the figure does on your screen</source>
        <translation>Distancia a la que una persona parecería tan alta como la figura en la pantalla</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Preguntas</translation>
    </message>
    <message>
        <source>Show A, X and B side by side</source>
        <translation>Mostrar A, X y B lado a lado</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Empezar</translation>
    </message>
    <message>
        <source>Compressing the clip at %m levels: %v</source>
        <translation>Comprimiendo el clip en %m niveles: %v</translation>
    </message>
    <message>
        <source>1: A, the original    2: X    3: B, compressed        ←: X is A    →: X is B        Esc: stop</source>
        <translation>1: A, el original    2: X    3: B, comprimido        ←: X es A    →: X es B        Esc: parar</translation>
    </message>
    <message>
        <source>Use as Limits</source>
        <translation>Usar como límites</translation>
    </message>
    <message>
        <source>Judge visibility by your own threshold from now on; other cues keep their limits</source>
        <translation>Juzgar la visibilidad desde ahora con su propio umbral; los demás indicios conservan sus límites</translation>
    </message>
    <message>
        <source>Another Test</source>
        <translation>Otra prueba</translation>
    </message>
    <message>
        <source>In Use</source>
        <translation>En uso</translation>
    </message>
    <message>
        <source>A is the original of %1, B the same clip compressed, more or less visibly. X is one of the two: say which. The test finds the smallest error that you notice, in about five minutes. Nobody is told whether an answer was right.</source>
        <translation>A es el original de %1; B, el mismo clip comprimido, de forma más o menos visible. X es uno de los dos: diga cuál. La prueba busca el menor error que se nota, en unos cinco minutos. A nadie se le dice si una respuesta era correcta.</translation>
    </message>
    <message>
        <source>Open a motion and compress it by the closed loop: the test takes the open clip.</source>
        <translation>Abra un movimiento y comprímalo con el bucle cerrado: la prueba toma el clip abierto.</translation>
    </message>
    <message>
        <source>This clip cannot be compressed at enough levels for a test.</source>
        <translation>Este clip no se puede comprimir en niveles suficientes para una prueba.</translation>
    </message>
    <message>
        <source>Question %L1 of %L2: is X the original or the compressed one?</source>
        <translation>Pregunta %L1 de %L2: ¿X es el original o el comprimido?</translation>
    </message>
    <message>
        <source>%L1 of %L2 answers were right. Somebody who guesses has as many with a probability of %L3.</source>
        <translation>%L1 de %L2 respuestas fueron correctas. Quien adivina acierta otras tantas con una probabilidad de %L3.</translation>
    </message>
    <message>
        <source>You notice errors from %L1 times what the limits say (95 % interval: %L2 to %L3). Most were seen as: %4, from %L5 m.</source>
        <translation>Usted nota errores a partir de %L1 veces lo que dicen los límites (intervalo del 95 %: de %L2 a %L3). La mayoría se vio como: %4, a %L5 m.</translation>
    </message>
    <message>
        <source>The answers do not tell a threshold: they are too few, or it lies outside of the levels.</source>
        <translation>Las respuestas no indican un umbral: son demasiado pocas, o está fuera de los niveles.</translation>
    </message>
    <message>
        <source>Kept in %1.</source>
        <translation>Guardado en %1.</translation>
    </message>
    <message>
        <source>Use Built-in Limits</source>
        <translation>Usar los límites incorporados</translation>
    </message>
    <message>
        <source>Judge visibility as before any test</source>
        <translation>Juzga la visibilidad como antes de toda prueba</translation>
    </message>
    <message>
        <source>Visibility is judged by %1.</source>
        <translation>La visibilidad se juzga por %1.</translation>
    </message>
</context>
<context>
    <name>mocapress::ByteCostModel</name>
    <message>
        <source>Skeleton</source>
        <translation>Esqueleto</translation>
    </message>
    <message>
        <source>Description of the clip</source>
        <translation>Descripción del clip</translation>
    </message>
    <message>
        <source>Table of segments</source>
        <translation>Tabla de segmentos</translation>
    </message>
    <message>
        <source>Chains of the IK correction</source>
        <translation>Cadenas de la corrección IK</translation>
    </message>
    <message>
        <source>First and last pose</source>
        <translation>Primera y última pose</translation>
    </message>
    <message>
        <source>Turned axes</source>
        <translation>Ejes girados</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>Pistas</translation>
    </message>
    <message>
        <source>Rounding of the coder</source>
        <translation>Redondeo del codificador</translation>
    </message>
    <message>
        <source>Motion (cannot be divided)</source>
        <translation>Movimiento (indivisible)</translation>
    </message>
    <message>
        <source>Frame of the file</source>
        <translation>Armazón del archivo</translation>
    </message>
    <message>
        <source>%L1 %</source>
        <translation>%L1 %</translation>
    </message>
    <message>
        <source>Bytes of the file that code this joint, as the decoder counts them. Rows in italics belong to no joint.</source>
        <translation>Bytes del archivo que codifican esta articulación, como los cuenta el descodificador. Las filas en cursiva no son de ninguna articulación.</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Articulación</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Parte</translation>
    </message>
</context>
<context>
    <name>mocapress::ByteStrip</name>
    <message>
        <source>Bytes over time</source>
        <translation>Bytes en el tiempo</translation>
    </message>
    <message>
        <source>Compressed bytes over time. The table of bytes has them by joint.</source>
        <translation>Bytes comprimidos en el tiempo. La tabla de bytes los da por articulación.</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>Compressed bytes over time, on a scale of the dearest moment.</source>
        <translation>Bytes comprimidos en el tiempo, en la escala del momento más caro.</translation>
    </message>
    <message>
        <source>Frames from %L1: %L2 bytes, most of them for %3 (%L4)</source>
        <translation>Fotogramas desde %L1: %L2 bytes, la mayoría para %3 (%L4)</translation>
    </message>
</context>
<context>
    <name>mocapress::ByteView</name>
    <message>
        <source>10 % more bytes</source>
        <translation>10 % más de bytes</translation>
    </message>
    <message>
        <source>10 % fewer bytes</source>
        <translation>10 % menos de bytes</translation>
    </message>
    <message>
        <source>%1: error × 2</source>
        <translation>%1: error × 2</translation>
    </message>
</context>
<context>
    <name>mocapress::BytesPanel</name>
    <message>
        <source>Bytes by joint</source>
        <translation>Bytes por articulación</translation>
    </message>
    <message>
        <source>Other settings, tried</source>
        <translation>Otros ajustes, probados</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Cambio</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>Its error</source>
        <translation>Su error</translation>
    </message>
    <message>
        <source>See what it saves to be less exact in one place, or what more bytes bring. Each line is a real encode.</source>
        <translation>Vea qué ahorra ser menos exacto en un lugar, o qué aportan más bytes. Cada línea es una codificación real.</translation>
    </message>
    <message>
        <source>Try Other Settings</source>
        <translation>Probar otros ajustes</translation>
    </message>
    <message>
        <source>Use These</source>
        <translation>Usar estos</translation>
    </message>
    <message>
        <source>Compress with the settings of the chosen line; can be undone</source>
        <translation>Comprimir con los ajustes de la línea elegida; se puede deshacer</translation>
    </message>
    <message>
        <source>%L1 → %L2 mm</source>
        <translation>%L1 → %L2 mm</translation>
    </message>
    <message>
        <source>Trying…</source>
        <translation>Probando…</translation>
    </message>
</context>
<context>
    <name>mocapress::ChannelGraph</name>
    <message>
        <source>Channel</source>
        <translation>Canal</translation>
    </message>
    <message>
        <source>One degree of freedom of the selected joint.</source>
        <translation>Un grado de libertad de la articulación seleccionada.</translation>
    </message>
    <message>
        <source>Channel over time</source>
        <translation>Canal en el tiempo</translation>
    </message>
    <message>
        <source>The recorded and the compressed channel; below, their difference. Click to go to a frame.</source>
        <translation>El canal grabado y el comprimido; debajo, su diferencia. Haga clic para ir a un fotograma.</translation>
    </message>
    <message>
        <source>Kept coefficients by scale</source>
        <translation>Coeficientes conservados por escala</translation>
    </message>
    <message>
        <source>Share of this channel&apos;s wavelet coefficients that are kept, from the coarsest scale to the finest.</source>
        <translation>Parte de los coeficientes de ondículas de este canal que se conserva, de la escala más gruesa a la más fina.</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Tiempo (s)</translation>
    </message>
    <message>
        <source>Scale (finer →)</source>
        <translation>Escala (más fina →)</translation>
    </message>
    <message>
        <source>Kept (%)</source>
        <translation>Conservados (%)</translation>
    </message>
    <message>
        <source>The selected joint has no motion of its own.</source>
        <translation>La articulación seleccionada no tiene movimiento propio.</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
</context>
<context>
    <name>mocapress::CharacterChoice</name>
    <message>
        <source>Take the character off</source>
        <translation>Quitar el personaje</translation>
    </message>
    <message>
        <source>Remove the character; clips with a mesh of their own use that</source>
        <translation>Quitar el personaje; los clips con malla propia usan la suya</translation>
    </message>
    <message>
        <source>Own mesh of each clip</source>
        <translation>La malla de cada clip</translation>
    </message>
    <message>
        <source>Character on all clips: %1</source>
        <translation>Personaje en todos los clips: %1</translation>
    </message>
    <message>
        <source>Character (FBX or glTF) for every clip whose joints it fits. Errors are measured on its mesh, and the weighting Skin uses it. Other clips are unchanged, and the report lists them.</source>
        <translation>Personaje (FBX o glTF) para cada clip a cuyas articulaciones se ajusta. Los errores se miden sobre su malla, y la ponderación Piel la usa. Los demás clips no cambian, y el informe los enumera.</translation>
    </message>
</context>
<context>
    <name>mocapress::ClipFiles</name>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Motion and compressed clips (%1 *.mcpr);;All files (*)</source>
        <translation>Movimientos y clips comprimidos (%1 *.mcpr);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Skeleton of %1</source>
        <translation>Esqueleto de %1</translation>
    </message>
    <message>
        <source>Skeletons (*.asf)</source>
        <translation>Esqueletos (*.asf)</translation>
    </message>
    <message>
        <source>Put a Character on the Clip</source>
        <translation>Poner un personaje al clip</translation>
    </message>
    <message>
        <source>Characters (*.fbx *.glb *.gltf *.vrm)</source>
        <translation>Personajes (*.fbx *.glb *.gltf *.vrm)</translation>
    </message>
    <message>
        <source>Compare with Original</source>
        <translation>Comparar con el original</translation>
    </message>
    <message>
        <source>Motion (%1)</source>
        <translation>Movimiento (%1)</translation>
    </message>
    <message>
        <source>Compressed clips (*.mcpr)</source>
        <translation>Clips comprimidos (*.mcpr)</translation>
    </message>
    <message>
        <source>Unsaved Changes</source>
        <translation>Cambios sin guardar</translation>
    </message>
    <message>
        <source>Save the compressed clip of %1?</source>
        <translation>¿Guardar el clip comprimido de %1?</translation>
    </message>
    <message>
        <source>The project keeps the clip&apos;s settings either way.</source>
        <translation>El proyecto conserva los ajustes del clip en cualquier caso.</translation>
    </message>
    <message>
        <source>Biovision motion (*.bvh)</source>
        <translation>Movimiento Biovision (*.bvh)</translation>
    </message>
    <message>
        <source>Acclaim motion with its skeleton (*.amc)</source>
        <translation>Movimiento Acclaim con su esqueleto (*.amc)</translation>
    </message>
    <message>
        <source>FBX on its skeleton (*.fbx)</source>
        <translation>FBX sobre su esqueleto (*.fbx)</translation>
    </message>
    <message>
        <source>%1 with this motion (*.%2)</source>
        <translation>%1 con este movimiento (*.%2)</translation>
    </message>
    <message>
        <source>%1 is the file of the character. Replace it with a file that also has this motion?</source>
        <translation>%1 es el archivo del personaje. ¿Reemplazarlo por un archivo que tiene además este movimiento?</translation>
    </message>
    <message>
        <source>glTF on its skeleton (*.glb)</source>
        <translation>glTF sobre su esqueleto (*.glb)</translation>
    </message>
    <message>
        <source>Table of channels (*.csv)</source>
        <translation>Tabla de canales (*.csv)</translation>
    </message>
    <message>
        <source>Review pages (*.html)</source>
        <translation>Páginas de revisión (*.html)</translation>
    </message>
    <message>
        <source>Save Clip</source>
        <translation>Guardar clip</translation>
    </message>
    <message>
        <source>Export Motion</source>
        <translation>Exportar movimiento</translation>
    </message>
    <message>
        <source>Export Review Page</source>
        <translation>Exportar página de revisión</translation>
    </message>
    <message>
        <source>The skeleton is written to %1, which exists already. Replace it?</source>
        <translation>El esqueleto se escribe en %1, que ya existe. ¿Reemplazarlo?</translation>
    </message>
    <message>
        <source>%1 is the original that is open. Replace it with the compressed motion?</source>
        <translation>%1 es el original que está abierto. ¿Reemplazarlo por el movimiento comprimido?</translation>
    </message>
</context>
<context>
    <name>mocapress::ClipLinks</name>
    <message>
        <source>%1 is not on this computer, and the library has no clip of that name.</source>
        <translation>%1 no está en este ordenador, y la biblioteca no tiene ningún clip con ese nombre.</translation>
    </message>
    <message>
        <source>Copied the link to this frame and view.</source>
        <translation>Enlace a este fotograma y vista copiado.</translation>
    </message>
</context>
<context>
    <name>mocapress::CommandPalette</name>
    <message>
        <source>No command has these words.</source>
        <translation>Ninguna orden tiene estas palabras.</translation>
    </message>
    <message>
        <source>Find a Command</source>
        <translation>Buscar una orden</translation>
    </message>
    <message>
        <source>Words of a command, such as: next note</source>
        <translation>Palabras de una orden, como: siguiente nota</translation>
    </message>
    <message>
        <source>Words of a command</source>
        <translation>Palabras de una orden</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Órdenes</translation>
    </message>
</context>
<context>
    <name>mocapress::CompressionPanel</name>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>Weighting</source>
        <translation>Ponderación</translation>
    </message>
    <message>
        <source>Coding</source>
        <translation>Codificación</translation>
    </message>
    <message>
        <source>Effort</source>
        <translation>Esfuerzo</translation>
    </message>
    <message>
        <source>Importance</source>
        <translation>Importancia</translation>
    </message>
    <message>
        <source>Closed loop gives by far the smallest files: it rounds every coefficient by its effect on world-space error. The others are the paper&apos;s methods, which choose the coefficients to keep. Annealed searches for the channels where coefficients lower the error most, Standard keeps the largest of all channels, Per channel keeps as many in each.</source>
        <translation>El bucle cerrado da con diferencia los archivos más pequeños: redondea cada coeficiente según su efecto en el error en el espacio. Los demás son los métodos del artículo, que eligen qué coeficientes se conservan. Recocidas busca los canales donde los coeficientes reducen más el error, Estándar conserva los mayores de todos los canales, Por canal conserva el mismo número en cada uno.</translation>
    </message>
    <message>
        <source>Best searches longer for a smaller result: it saves about 1 % and takes some three times as long.</source>
        <translation>Mejor busca más tiempo un resultado más pequeño: ahorra alrededor del 1 % y tarda unas tres veces más.</translation>
    </message>
    <message>
        <source>Effort applies only to the closed loop; the paper&apos;s methods have one result.</source>
        <translation>El esfuerzo solo afecta al bucle cerrado; los métodos del artículo tienen un único resultado.</translation>
    </message>
    <message>
        <source>The closed loop always uses adaptive coding, whose bytes it counts while it searches.</source>
        <translation>El bucle cerrado usa siempre la codificación adaptativa, cuyos bytes cuenta mientras busca.</translation>
    </message>
    <message>
        <source>Coding of kept coefficients as bytes: 16-bit words with runs of zeros, with or without DEFLATE on top, or an adaptive range coder.</source>
        <translation>Codificación de los coeficientes conservados en bytes: palabras de 16 bits con series de ceros, con o sin DEFLATE encima, o un codificador de rango adaptativo.</translation>
    </message>
    <message>
        <source>Not used</source>
        <translation>Sin uso</translation>
    </message>
    <message>
        <source>All equal</source>
        <translation>Todas iguales</translation>
    </message>
    <message>
        <source>Give errors of feet, hands, the head, contacts or any joint more weight.</source>
        <translation>Dar más peso a los errores de pies, manos, cabeza, contactos o cualquier articulación.</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Más</translation>
    </message>
    <message>
        <source>This method ignores importance: choose %1 or %2.</source>
        <translation>Este método ignora la importancia: elija %1 o %2.</translation>
    </message>
    <message>
        <source>Rarely changed settings: error weighting, ends of the clip, and coding.</source>
        <translation>Ajustes que rara vez se cambian: ponderación del error, extremos del clip y codificación.</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Extremos</translation>
    </message>
    <message>
        <source>Only the closed loop corrects the first and last pose.</source>
        <translation>Solo el bucle cerrado corrige la primera y la última pose.</translation>
    </message>
    <message>
        <source>Errors of the first and last pose, where clips are blended and looped. Even: no larger than the target, and equal at both ends of a loop. Exact: at most a tenth of the target, for some 4 % more bytes. Free: no bound.</source>
        <translation>Errores de la primera y la última pose, donde los clips se mezclan y se repiten. Parejos: no mayores que el objetivo, e iguales en ambos extremos de un bucle. Exactos: como máximo un décimo del objetivo, por un 4 % más de bytes. Libres: sin límite.</translation>
    </message>
    <message>
        <source>Tracks within</source>
        <translation>Pistas dentro de</translation>
    </message>
    <message>
        <source>Largest error allowed for values of morph weights and scales, independent of the target of the motion. Weights range from 0 to 1; switches and constants are kept exactly.</source>
        <translation>Mayor error permitido en los valores de pesos de morph y escalas, independiente del objetivo del movimiento. Los pesos van de 0 a 1; interruptores y constantes se conservan exactos.</translation>
    </message>
    <message>
        <source>Points on which the error eps_x is measured. Surface: a body modelled around the bones, so that turned heads and hands count. Skin: the mesh of the clip or of the character put on it. Shell: three points 3 cm from every joint, as in ACL. Bone ends and joint origins: points on the bones, weighted by bone length; joint origins are the paper&apos;s.</source>
        <translation>Puntos en los que se mide el error eps_x. Superficie: un cuerpo modelado alrededor de los huesos, para que cuenten las cabezas y manos giradas. Piel: la malla del clip o del personaje que lleva puesto. Envoltura: tres puntos a 3 cm de cada articulación, como en ACL. Extremos de huesos y orígenes de articulaciones: puntos en los huesos, ponderados por su longitud; los orígenes de articulaciones son los del artículo.</translation>
    </message>
    <message>
        <source>Viewing distance</source>
        <translation>Distancia de observación</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Distance from which the figure is watched. The nearer, the smaller an error that is noticed.</source>
        <translation>Distancia desde la que se observa la figura. Cuanto más cerca, menor es el error que se nota.</translation>
    </message>
</context>
<context>
    <name>mocapress::ContactStrip</name>
    <message>
        <source>Contacts</source>
        <translation>Contactos</translation>
    </message>
    <message>
        <source>Remove Contact</source>
        <translation>Quitar contacto</translation>
    </message>
    <message>
        <source>Add Contact Here</source>
        <translation>Añadir contacto aquí</translation>
    </message>
    <message>
        <source>%1 stands in frames %L2–%L3 and drifts by %4 from the original. Drag an end to move it.</source>
        <translation>%1 se apoya en los fotogramas %L2–%L3 y deriva %4 respecto al original. Arrastre un extremo para moverlo.</translation>
    </message>
</context>
<context>
    <name>mocapress::ConvergencePlot</name>
    <message>
        <source>Iteration</source>
        <translation>Iteración</translation>
    </message>
    <message>
        <source>eps_x (cm)</source>
        <translation>eps_x (cm)</translation>
    </message>
    <message>
        <source>Error while refining</source>
        <translation>Error durante el refinamiento</translation>
    </message>
    <message>
        <source>Error after each iteration of the refinement.</source>
        <translation>Error tras cada iteración del refinamiento.</translation>
    </message>
</context>
<context>
    <name>mocapress::CorrectionControl</name>
    <message>
        <source>Auto</source>
        <translation>Auto</translation>
    </message>
    <message>
        <source>Stores the places of the feet and moves the feet there by inverse kinematics, so that planted feet do not slide. The bytes of this correction count in the compression ratio.</source>
        <translation>Guarda las posiciones de los pies y los lleva a ellas por cinemática inversa, para que los pies apoyados no se deslicen. Los bytes de esta corrección cuentan en la tasa de compresión.</translation>
    </message>
    <message>
        <source>Searches for the smallest correction that removes at least nine tenths of the sliding, or leaves no foot sliding more than a millimetre.</source>
        <translation>Busca la corrección más pequeña que elimina al menos nueve décimos del deslizamiento, o que no deja deslizarse ningún pie más de un milímetro.</translation>
    </message>
    <message>
        <source>IK ratio</source>
        <translation>Tasa IK</translation>
    </message>
    <message>
        <source>Coefficients of the correction over those kept (r_IK in the paper). Lower values hold the feet better and take more bytes.</source>
        <translation>Coeficientes de la corrección frente a los conservados (r_IK en el artículo). Los valores menores sujetan mejor los pies y ocupan más bytes.</translation>
    </message>
    <message>
        <source> : 1</source>
        <translation> : 1</translation>
    </message>
    <message>
        <source>IK ratio on a slider</source>
        <translation>Tasa IK con un deslizador</translation>
    </message>
    <message>
        <source>When feet are held</source>
        <translation>Cuándo se sujetan los pies</translation>
    </message>
    <message>
        <source>Hold the feet at every frame, as in the paper, or only while they stand on the ground, blended in and out.</source>
        <translation>Sujetar los pies en cada fotograma, como en el artículo, o solo mientras se apoyan en el suelo, con transiciones suaves.</translation>
    </message>
    <message>
        <source>Held joints</source>
        <translation>Articulaciones sujetas</translation>
    </message>
    <message>
        <source>Joints to hold; the feet by default.</source>
        <translation>Articulaciones que se sujetan; por defecto, los pies.</translation>
    </message>
    <message>
        <source>Hold at</source>
        <translation>Sujetar en</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Articulaciones</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Pies</translation>
    </message>
    <message numerus="yes">
        <source>%Ln joint(s)</source>
        <translation>
            <numerusform>%Ln articulación</numerusform>
            <numerusform>%Ln articulaciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Hold feet (IK)</source>
        <translation>Sujetar los pies (IK)</translation>
    </message>
</context>
<context>
    <name>mocapress::EncodingBar</name>
    <message>
        <source>Clips that are compressed</source>
        <translation>Clips comprimidos</translation>
    </message>
    <message>
        <source>Pause compressing clips in the background</source>
        <translation>Pausar la compresión de clips en segundo plano</translation>
    </message>
    <message>
        <source>Compress all clips in the background with their own settings, the open clip first.</source>
        <translation>Comprimir en segundo plano todos los clips con sus propios ajustes, el clip abierto primero.</translation>
    </message>
    <message>
        <source>%L1 of %L2 compressed</source>
        <translation>%L1 de %L2 comprimidos</translation>
    </message>
    <message>
        <source>%1, %L2 failed</source>
        <translation>%1, %L2 fallidos</translation>
    </message>
</context>
<context>
    <name>mocapress::ErrorDisplay</name>
    <message>
        <source>Errors in &amp;Degrees</source>
        <translation>Errores en &amp;grados</translation>
    </message>
    <message>
        <source>Degrees</source>
        <translation>Grados</translation>
    </message>
    <message>
        <source>Show rotation errors of joints (in degrees, world space) instead of distances in heat map and error graph (%1)</source>
        <translation>Mostrar los errores de rotación de las articulaciones (en grados, en el espacio) en vez de distancias en el mapa de calor y el gráfico de error (%1)</translation>
    </message>
    <message>
        <source>Visible Errors</source>
        <translation>Errores visibles</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Visto</translation>
    </message>
    <message>
        <source>Show visible errors of joints instead of distances in the heat map (%1)</source>
        <translation>Mostrar los errores visibles de las articulaciones en vez de distancias en el mapa de calor (%1)</translation>
    </message>
</context>
<context>
    <name>mocapress::ErrorGraph</name>
    <message>
        <source>Error over time</source>
        <translation>Error en el tiempo</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Tiempo (s)</translation>
    </message>
    <message>
        <source>Error (cm)</source>
        <translation>Error (cm)</translation>
    </message>
    <message>
        <source>worst of all joints</source>
        <translation>la peor articulación</translation>
    </message>
    <message>
        <source>World-space distance or angle between joints and the original. Click to go to a frame, turn the wheel to zoom, double-click to show all.</source>
        <translation>Distancia o ángulo en el espacio entre las articulaciones y el original. Clic: ir a un fotograma; rueda: ampliar; doble clic: mostrar todo.</translation>
    </message>
    <message>
        <source>Angle (°)</source>
        <translation>Ángulo (°)</translation>
    </message>
    <message>
        <source>Frame %L1</source>
        <translation>Fotograma %L1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>mocapress::ErrorScaleChoice</name>
    <message>
        <source>&amp;Automatic</source>
        <translation>&amp;Automático</translation>
    </message>
</context>
<context>
    <name>mocapress::ErrorStrip</name>
    <message>
        <source>Error strip</source>
        <translation>Franja de error</translation>
    </message>
    <message>
        <source>Largest and mean error at every frame. The table of joints has the numbers.</source>
        <translation>Error mayor y medio en cada fotograma. La tabla de articulaciones tiene los números.</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Error</translation>
    </message>
    <message>
        <source>Errors of this size or more have full height and the lightest colour. Click to choose another scale.</source>
        <translation>Los errores de este tamaño o más tienen toda la altura y el color más claro. Haga clic para elegir otra escala.</translation>
    </message>
    <message>
        <source>Largest error at every frame as a column, mean error as a line. Turn the wheel to zoom, with Shift to scroll; drag with Shift to choose the range to play.</source>
        <translation>Error mayor en cada fotograma como columna, error medio como línea. Rueda: ampliar, con Mayús desplazar; arrastre con Mayús para elegir el intervalo que se reproduce.</translation>
    </message>
    <message>
        <source>A jump of one frame: %1 at frame %L2, %3</source>
        <translation>Un salto de un fotograma: %1 en el fotograma %L2, %3</translation>
    </message>
</context>
<context>
    <name>mocapress::FactorControl</name>
    <message>
        <source>%1 on a slider</source>
        <translation>%1 con un deslizador</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
</context>
<context>
    <name>mocapress::Figures</name>
    <message>
        <source>Nothing open</source>
        <translation>Nada abierto</translation>
    </message>
    <message>
        <source>Not compressed</source>
        <translation>Sin comprimir</translation>
    </message>
    <message>
        <source>Compressing…</source>
        <translation>Comprimiendo…</translation>
    </message>
    <message>
        <source>As recorded in the file</source>
        <translation>Como está grabado en el archivo</translation>
    </message>
    <message>
        <source>%1, with the settings of the study</source>
        <translation>%1, con los ajustes del estudio</translation>
    </message>
    <message>
        <source>%1, read from the file and measured against the original</source>
        <translation>%1, leído del archivo y medido frente al original</translation>
    </message>
    <message>
        <source>%1, %L2 s</source>
        <translation>%1, %L2 s</translation>
    </message>
    <message>
        <source>Footskate is measured against the original.</source>
        <translation>El deslizamiento de pies se mide frente al original.</translation>
    </message>
    <message>
        <source>No foot stands on the ground in this clip.</source>
        <translation>En este clip ningún pie se apoya en el suelo.</translation>
    </message>
    <message>
        <source>%1, without IK</source>
        <translation>%1, sin IK</translation>
    </message>
    <message>
        <source>Draft; the refined result follows</source>
        <translation>Borrador; sigue el resultado refinado</translation>
    </message>
    <message>
        <source>Refinement cancelled; the best so far is kept</source>
        <translation>Refinamiento cancelado; se conserva el mejor hasta ahora</translation>
    </message>
    <message>
        <source>Refinement cancelled; the draft is kept</source>
        <translation>Refinamiento cancelado; se conserva el borrador</translation>
    </message>
    <message>
        <source>No result for these settings; the draft is kept</source>
        <translation>Sin resultado para estos ajustes; se conserva el borrador</translation>
    </message>
    <message>
        <source>No result for these settings; the last one is kept</source>
        <translation>Sin resultado para estos ajustes; se conserva el último</translation>
    </message>
    <message numerus="yes">
        <source>%1, %Ln iteration(s), %L2 s</source>
        <translation>
            <numerusform>%1, %Ln iteración, %L2 s</numerusform>
            <numerusform>%1, %Ln iteraciones, %L2 s</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln contact(s): mean drift of the feet %1, worst %2; their path is %3 longer than the original&apos;s</source>
        <translation>
            <numerusform>%Ln contacto: deriva media de los pies %1, peor %2; su recorrido es %3 más largo que el del original</numerusform>
            <numerusform>%Ln contactos: deriva media de los pies %1, peor %2; su recorrido es %3 más largo que el del original</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %L2 s, as a loop</source>
        <translation>%1, %L2 s, como bucle</translation>
    </message>
</context>
<context>
    <name>mocapress::FiguresBar</name>
    <message>
        <source>eps_x</source>
        <translation>eps_x</translation>
    </message>
    <message>
        <source>Root mean square distance between original and compressed, weighted by bone length: the paper&apos;s distortion.</source>
        <translation>Distancia cuadrática media entre original y comprimido, ponderada por la longitud de los huesos: la distorsión del artículo.</translation>
    </message>
    <message>
        <source>p95</source>
        <translation>p95</translation>
    </message>
    <message>
        <source>95 % of all points at all frames have a smaller error.</source>
        <translation>El 95 % de los puntos en todos los fotogramas tiene un error menor.</translation>
    </message>
    <message>
        <source>p99</source>
        <translation>p99</translation>
    </message>
    <message>
        <source>99 % of all points at all frames have a smaller error.</source>
        <translation>El 99 % de los puntos en todos los fotogramas tiene un error menor.</translation>
    </message>
    <message>
        <source>max</source>
        <translation>máx.</translation>
    </message>
    <message>
        <source>Largest error of any point at any frame.</source>
        <translation>Mayor error de cualquier punto en cualquier fotograma.</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>tasa</translation>
    </message>
    <message>
        <source>Bytes of the channels as 32-bit floats, divided by the compressed motion bytes, as in the paper.</source>
        <translation>Bytes de los canales como flotantes de 32 bits, divididos por los bytes comprimidos del movimiento, como en el artículo.</translation>
    </message>
    <message>
        <source>bits per joint-sample</source>
        <translation>bits por muestra de articulación</translation>
    </message>
    <message>
        <source>Motion bits for one joint at one frame; unlike a ratio it needs no baseline.</source>
        <translation>Bits de movimiento para una articulación en un fotograma; a diferencia de una tasa, no necesita referencia.</translation>
    </message>
    <message>
        <source>eps_x, %1</source>
        <translation>eps_x, %1</translation>
    </message>
    <message>
        <source>≈ %1</source>
        <translation>≈ %1</translation>
    </message>
    <message>
        <source>foot drift</source>
        <translation>deriva del pie</translation>
    </message>
    <message>
        <source>Largest distance between a standing foot and its place in the original.</source>
        <translation>Mayor distancia entre un pie apoyado y su lugar en el original.</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>movimiento</translation>
    </message>
    <message>
        <source>Compressed motion bytes; the skeleton in the file takes more.</source>
        <translation>Bytes comprimidos del movimiento; el esqueleto ocupa otros en el archivo.</translation>
    </message>
    <message>
        <source>Errors in the range</source>
        <translation>Errores en el intervalo</translation>
    </message>
    <message>
        <source>Errors of all joints in the frames of the chosen range: root mean square, 95th percentile and largest. A double click on the ruler chooses the whole clip again.</source>
        <translation>Errores de todas las articulaciones en los fotogramas del intervalo elegido: valor cuadrático medio, percentil 95 y mayor. Un doble clic en la regla vuelve a elegir todo el clip.</translation>
    </message>
</context>
<context>
    <name>mocapress::FilmRecorder</name>
    <message>
        <source>%1: ffmpeg could not write the video (%2)</source>
        <translation>%1: ffmpeg no pudo escribir el vídeo (%2)</translation>
    </message>
    <message>
        <source>A video needs the program ffmpeg, which is not installed here. Numbered pictures (.png) need nothing.</source>
        <translation>Un vídeo necesita el programa ffmpeg, que no está instalado aquí. Las imágenes numeradas (.png) no necesitan nada.</translation>
    </message>
    <message>
        <source>%1: there is such a folder already</source>
        <translation>%1: ya hay una carpeta así</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2)</source>
        <translation>%1: no se puede escribir (%2)</translation>
    </message>
    <message>
        <source>The 3D view gave no picture.</source>
        <translation>La vista 3D no dio ninguna imagen.</translation>
    </message>
</context>
<context>
    <name>mocapress::FolderSearch</name>
    <message>
        <source>There are no clips in %1.</source>
        <translation>No hay clips en %1.</translation>
    </message>
</context>
<context>
    <name>mocapress::FootskatePanel</name>
    <message>
        <source>Findings of footskate</source>
        <translation>Deslizamientos encontrados</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Contacto</translation>
    </message>
    <message>
        <source>begins below</source>
        <translation>empieza por debajo de</translation>
    </message>
    <message>
        <source>ends above</source>
        <translation>acaba por encima de</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source>Height below which a contact begins</source>
        <translation>Altura por debajo de la cual empieza un contacto</translation>
    </message>
    <message>
        <source>Height above which a contact ends</source>
        <translation>Altura por encima de la cual acaba un contacto</translation>
    </message>
    <message>
        <source> cm/s</source>
        <translation> cm/s</translation>
    </message>
    <message>
        <source>Speed below which a contact begins</source>
        <translation>Velocidad por debajo de la cual empieza un contacto</translation>
    </message>
    <message>
        <source>Speed above which a contact ends</source>
        <translation>Velocidad por encima de la cual acaba un contacto</translation>
    </message>
    <message>
        <source>%1, measured in the original.</source>
        <translation>%1, medido en el original.</translation>
    </message>
</context>
<context>
    <name>mocapress::ForeignLock</name>
    <message>
        <source>%1 was opened by another Mocapress meanwhile, so it was not taken over.</source>
        <translation>Otro Mocapress abrió %1 entretanto, así que no se ha tomado el control.</translation>
    </message>
    <message>
        <source>The project cannot be taken over: its lock %1 is still held, or you may not change it.</source>
        <translation>No se puede tomar el control del proyecto: su bloqueo %1 sigue en uso, o usted no puede cambiarlo.</translation>
    </message>
    <message>
        <source>%1 is open in another window of Mocapress</source>
        <translation>%1 está abierto en otra ventana de Mocapress</translation>
    </message>
    <message>
        <source>%1 is open on the computer %2, since %3</source>
        <translation>%1 está abierto en el ordenador %2, desde %3</translation>
    </message>
    <message>
        <source>%1 is open on the computer %2, by %3, since %4</source>
        <translation>%1 está abierto en el ordenador %2, por %3, desde %4</translation>
    </message>
</context>
<context>
    <name>mocapress::FrameNotes</name>
    <message>
        <source>Frame %L1</source>
        <translation>Fotograma %L1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Stale: the clip&apos;s file or settings have changed since.</source>
        <translation>Caducada: el archivo del clip o los ajustes han cambiado desde entonces.</translation>
    </message>
    <message>
        <source>Frames %L1–%L2</source>
        <translation>Fotogramas %L1–%L2</translation>
    </message>
</context>
<context>
    <name>mocapress::HeatMap</name>
    <message>
        <source>Heat map of errors</source>
        <translation>Mapa de calor de los errores</translation>
    </message>
    <message>
        <source>Error of every joint at every frame. Arrow keys move to the next joint or frame.</source>
        <translation>Error de cada articulación en cada fotograma. Las flechas llevan a la articulación o al fotograma siguiente.</translation>
    </message>
    <message>
        <source>Errors are measured against the original.</source>
        <translation>Los errores se miden frente al original.</translation>
    </message>
    <message>
        <source>%1, frame %L2: %3</source>
        <translation>%1, fotograma %L2: %3</translation>
    </message>
</context>
<context>
    <name>mocapress::Help</name>
    <message>
        <source>Guide</source>
        <translation>Guía</translation>
    </message>
    <message>
        <source>Keyboard Shortcuts</source>
        <translation>Atajos de teclado</translation>
    </message>
    <message>
        <source>About Mocapress</source>
        <translation>Acerca de Mocapress</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Mocapress %1&lt;/h3&gt;&lt;p&gt;Compresses human motion capture clips with wavelets, after Philippe Beaudoin, Pierre Poulin and Michiel van de Panne, &lt;i&gt;Adapting Wavelet Compression to Human Motion Capture Clips&lt;/i&gt;, Graphics Interface 2007.&lt;/p&gt;&lt;p&gt;The studio is free software under the GNU General Public License, version 3 or later; the compression library is under the MIT licence.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Mocapress %1&lt;/h3&gt;&lt;p&gt;Comprime con ondículas clips de captura de movimiento humano, según Philippe Beaudoin, Pierre Poulin y Michiel van de Panne, &lt;i&gt;Adapting Wavelet Compression to Human Motion Capture Clips&lt;/i&gt;, Graphics Interface 2007.&lt;/p&gt;&lt;p&gt;Mocapress Studio es software libre bajo la Licencia Pública General GNU, versión 3 o posterior; la biblioteca de compresión está bajo la licencia MIT.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Right or middle drag: move</source>
        <translation>Arrastrar con el botón derecho o central: desplazar</translation>
    </message>
    <message>
        <source>Wheel: nearer or further</source>
        <translation>Rueda: más cerca o más lejos</translation>
    </message>
    <message>
        <source>Click on a joint: select it</source>
        <translation>Clic en una articulación: seleccionarla</translation>
    </message>
    <message>
        <source>Drag an end of a contact: move it; right button: add or remove</source>
        <translation>Arrastrar un extremo de un contacto: moverlo; botón derecho: añadir o quitar</translation>
    </message>
    <message>
        <source>Shift and drag on the error strip: choose the range that is played</source>
        <translation>Mayús y arrastrar en la franja de error: elegir el intervalo que se reproduce</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Ratón</translation>
    </message>
    <message>
        <source>Wheel over the timeline: zoom; with Shift: move along</source>
        <translation>Rueda sobre la línea de tiempo: ampliar; con Mayús: desplazarse</translation>
    </message>
    <message>
        <source>Click on the scale of the error strip: choose another</source>
        <translation>Clic en la escala de la franja de error: elegir otra</translation>
    </message>
    <message>
        <source>Drag on the ruler: choose a range; right button: what to do with it</source>
        <translation>Arrastrar en la regla: elegir un intervalo; botón derecho: qué hacer con él</translation>
    </message>
    <message>
        <source>Left drag in the 3D view: turn; in a view along an axis: move</source>
        <translation>Arrastrar con el izquierdo en la vista 3D: girar; en una vista a lo largo de un eje: desplazar</translation>
    </message>
</context>
<context>
    <name>mocapress::ImportOptionsDialog</name>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source> Hz</source>
        <translation> Hz</translation>
    </message>
    <message>
        <source>Import Options – %1</source>
        <translation>Opciones de importación – %1</translation>
    </message>
    <message>
        <source>Guessed by the figure&apos;s height</source>
        <translation>Estimada por la altura de la figura</translation>
    </message>
    <message>
        <source>As in the skeleton file</source>
        <translation>Como en el archivo del esqueleto</translation>
    </message>
    <message>
        <source>Centimetre</source>
        <translation>Centímetro</translation>
    </message>
    <message>
        <source>Metre</source>
        <translation>Metro</translation>
    </message>
    <message>
        <source>Millimetre</source>
        <translation>Milímetro</translation>
    </message>
    <message>
        <source>Inch</source>
        <translation>Pulgada</translation>
    </message>
    <message>
        <source>CMU&apos;s unit (0.45 to the inch)</source>
        <translation>Unidad de CMU (0,45 por pulgada)</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Otra</translation>
    </message>
    <message>
        <source>Y, as usual</source>
        <translation>Y, como es habitual</translation>
    </message>
    <message>
        <source>Guessed by the root&apos;s values</source>
        <translation>Estimada por los valores de la raíz</translation>
    </message>
    <message>
        <source>Adds to its OFFSET</source>
        <translation>Se suma a su OFFSET</translation>
    </message>
    <message>
        <source>Replaces its OFFSET</source>
        <translation>Reemplaza su OFFSET</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>Como en el archivo</translation>
    </message>
    <message>
        <source>%L1 Hz</source>
        <translation>%L1 Hz</translation>
    </message>
    <message>
        <source>&amp;Length unit</source>
        <translation>Unidad de &amp;longitud</translation>
    </message>
    <message>
        <source>&amp;Up axis</source>
        <translation>Eje &amp;vertical</translation>
    </message>
    <message>
        <source>Frame &amp;rate</source>
        <translation>&amp;Cadencia</translation>
    </message>
    <message>
        <source>BVH r&amp;oot</source>
        <translation>&amp;Raíz del BVH</translation>
    </message>
    <message>
        <source>Length unit</source>
        <translation>Unidad de longitud</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>Cadencia</translation>
    </message>
    <message>
        <source>Centimetres in one unit</source>
        <translation>Centímetros por unidad</translation>
    </message>
    <message>
        <source>Frames per second</source>
        <translation>Fotogramas por segundo</translation>
    </message>
    <message>
        <source>Now read with %L1 cm to the unit, %2 up, %L3 Hz</source>
        <translation>Ahora se lee con %L1 cm por unidad, %2 hacia arriba, %L3 Hz</translation>
    </message>
    <message>
        <source>, the root adds to its OFFSET</source>
        <translation>, la raíz se suma a su OFFSET</translation>
    </message>
    <message>
        <source>, the root replaces its OFFSET</source>
        <translation>, la raíz reemplaza su OFFSET</translation>
    </message>
    <message>
        <source>%L1 Hz, CMU&apos;s: the file does not say</source>
        <translation>%L1 Hz, los de CMU: el archivo no lo dice</translation>
    </message>
</context>
<context>
    <name>mocapress::ImportancePanel</name>
    <message>
        <source>Contacts</source>
        <translation>Contactos</translation>
    </message>
    <message>
        <source>Factor on the weight of a foot while it stands. About 20 keeps feet planted without inverse kinematics, for some more bytes at the same error.</source>
        <translation>Factor sobre el peso de un pie mientras se apoya. Con unos 20, los pies quedan apoyados sin cinemática inversa, por algunos bytes más con el mismo error.</translation>
    </message>
    <message>
        <source>All Equal</source>
        <translation>Todas iguales</translation>
    </message>
    <message>
        <source>Factor on the weight of these joints. Other joints get less accurate in return: the size or error that was asked for stays the same.</source>
        <translation>Factor sobre el peso de estas articulaciones. A cambio, las demás salen menos exactas: el tamaño o el error pedido no cambia.</translation>
    </message>
    <message>
        <source>Give all joints the same weight again.</source>
        <translation>Devolver el mismo peso a todas las articulaciones.</translation>
    </message>
    <message>
        <source>Any joint</source>
        <translation>Cualquier articulación</translation>
    </message>
    <message>
        <source>Set factors of single joints.</source>
        <translation>Fijar factores de articulaciones sueltas.</translation>
    </message>
    <message>
        <source>Find a joint</source>
        <translation>Buscar una articulación</translation>
    </message>
    <message>
        <source>Importance of every joint</source>
        <translation>Importancia de cada articulación</translation>
    </message>
    <message>
        <source>Double-click a factor to change it.</source>
        <translation>Haga doble clic en un factor para cambiarlo.</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Articulación</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Factor</translation>
    </message>
    <message>
        <source>No joint of this skeleton has the name of this part of the body.</source>
        <translation>Ninguna articulación de este esqueleto tiene el nombre de esta parte del cuerpo.</translation>
    </message>
    <message>
        <source>Weights of errors by part of the body. Parts with more weight get more accurate, the rest less.</source>
        <translation>Pesos de los errores por parte del cuerpo. Las partes con más peso salen más exactas; el resto, menos.</translation>
    </message>
    <message>
        <source>This method ignores importance: choose %1 or %2.</source>
        <translation>Este método ignora la importancia: elija %1 o %2.</translation>
    </message>
</context>
<context>
    <name>mocapress::IncomingFiles</name>
    <message>
        <source>Left out; the library takes only motions: %1</source>
        <translation>Excluidos; la biblioteca solo admite movimientos: %1</translation>
    </message>
    <message>
        <source>Left out; only one project is open at a time: %1</source>
        <translation>Excluidos; solo hay un proyecto abierto a la vez: %1</translation>
    </message>
</context>
<context>
    <name>mocapress::Inspector</name>
    <message>
        <source>The curve of this clip appears after it is compressed.</source>
        <translation>La curva de este clip aparece cuando está comprimido.</translation>
    </message>
    <message>
        <source>Frames %L1–%L2: RMS %3, p95 %4, max %5 (%6, frame %L7)</source>
        <translation>Fotogramas %L1–%L2: RMS %3, p95 %4, máx. %5 (%6, fotograma %L7)</translation>
    </message>
</context>
<context>
    <name>mocapress::JobRunner</name>
    <message>
        <source>An unknown error occurred.</source>
        <translation>Ocurrió un error desconocido.</translation>
    </message>
</context>
<context>
    <name>mocapress::JointErrorModel</name>
    <message>
        <source>Joint</source>
        <translation>Articulación</translation>
    </message>
    <message>
        <source>Joint origins and bone ends, in the skeleton&apos;s order.</source>
        <translation>Orígenes de articulaciones y extremos de huesos, en el orden del esqueleto.</translation>
    </message>
    <message>
        <source>World-space distance from the original, mean over the clip.</source>
        <translation>Distancia al original en el espacio, media de todo el clip.</translation>
    </message>
    <message>
        <source>Largest world-space distance from the original at any frame.</source>
        <translation>Mayor distancia al original en el espacio en cualquier fotograma.</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Máx.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>Angle between the joint&apos;s world-space rotation and the original&apos;s, RMS over the clip. Bone ends turn with their joint.</source>
        <translation>Ángulo entre la rotación de la articulación en el espacio y la del original, RMS de todo el clip. Los extremos de huesos giran con su articulación.</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Visto</translation>
    </message>
    <message>
        <source>The joint&apos;s most visible error, as a multiple of the noticeable error: up to 1 is not visible, up to 2 borderline.</source>
        <translation>El error más visible de la articulación, como múltiplo del error perceptible: hasta 1 no es visible, hasta 2 está en el límite.</translation>
    </message>
    <message>
        <source>RMS %1</source>
        <translation>RMS %1</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Piel</translation>
    </message>
    <message>
        <source>Largest error at any frame of the part of the mesh that mainly follows this joint.</source>
        <translation>Mayor error, en cualquier fotograma, de la parte de la malla que sigue sobre todo a esta articulación.</translation>
    </message>
</context>
<context>
    <name>mocapress::JointsPanel</name>
    <message>
        <source>Joints</source>
        <translation>Articulaciones</translation>
    </message>
</context>
<context>
    <name>mocapress::KeptProject</name>
    <message>
        <source>The last project</source>
        <translation>El último proyecto</translation>
    </message>
    <message>
        <source>%1 is read-only. This is a copy without a name.</source>
        <translation>%1 es de solo lectura. Esta es una copia sin nombre.</translation>
    </message>
    <message>
        <source>The project was not saved: %1</source>
        <translation>El proyecto no se guardó: %1</translation>
    </message>
    <message>
        <source>its lock was replaced or removed by someone else; use Save Project As to keep the changes in another file</source>
        <translation>otra persona reemplazó o quitó su bloqueo; use Guardar proyecto como para conservar los cambios en otro archivo</translation>
    </message>
    <message>
        <source>it was taken over on the computer %1; use Save Project As to keep the changes in another file</source>
        <translation>se tomó el control en el ordenador %1; use Guardar proyecto como para conservar los cambios en otro archivo</translation>
    </message>
    <message>
        <source>%1. This is a new project.</source>
        <translation>%1. Este es un proyecto nuevo.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
</context>
<context>
    <name>mocapress::KeyboardMap</name>
    <message>
        <source>Assign</source>
        <translation>Asignar</translation>
    </message>
    <message>
        <source>No Key</source>
        <translation>Sin tecla</translation>
    </message>
    <message>
        <source>Usual Key</source>
        <translation>Tecla habitual</translation>
    </message>
    <message>
        <source>Keyboard Map</source>
        <translation>Mapa del teclado</translation>
    </message>
    <message>
        <source>Words of a command, or a key</source>
        <translation>Palabras de una orden, o una tecla</translation>
    </message>
    <message>
        <source>Words of a command</source>
        <translation>Palabras de una orden</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Órdenes</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Orden</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menú</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Tecla</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>Nueva tecla</translation>
    </message>
    <message>
        <source>Usual Keys for All</source>
        <translation>Teclas habituales para todas</translation>
    </message>
    <message>
        <source>%1 belongs to “%2”, which loses it when you assign it.</source>
        <translation>%1 pertenece a «%2», que la pierde si usted la asigna.</translation>
    </message>
</context>
<context>
    <name>mocapress::LaunchOptions</name>
    <message>
        <source>Compress human motion capture clips with wavelets, and look at the result.</source>
        <translation>Comprimir con ondículas clips de captura de movimiento humano y ver el resultado.</translation>
    </message>
    <message>
        <source>Skeleton (.asf) of an .amc.</source>
        <translation>Esqueleto (.asf) de un .amc.</translation>
    </message>
    <message>
        <source>Compression ratio at the start.</source>
        <translation>Tasa de compresión al empezar.</translation>
    </message>
    <message>
        <source>Hold the feet, with this IK ratio at the start.</source>
        <translation>Sujetar los pies, con esta tasa IK al empezar.</translation>
    </message>
    <message>
        <source>Write timings to standard error.</source>
        <translation>Escribir los tiempos en la salida de error estándar.</translation>
    </message>
    <message>
        <source>After the clip is compressed, write a picture of the window and quit.</source>
        <translation>Cuando el clip esté comprimido, escribir una imagen de la ventana y salir.</translation>
    </message>
    <message>
        <source>A project (.mocapress), a motion or a .mcpr file. Several files, and folders, are added to the library. Or a link (mocapress://...).</source>
        <translation>Un proyecto (.mocapress), un movimiento o un archivo .mcpr. Si son varios archivos, o carpetas, se añaden a la biblioteca. O un enlace (mocapress://...).</translation>
    </message>
</context>
<context>
    <name>mocapress::Lengths</name>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>&lt; %1 mm</source>
        <translation>&lt; %1 mm</translation>
    </message>
    <message>
        <source>%1 : 1</source>
        <translation>%1 : 1</translation>
    </message>
</context>
<context>
    <name>mocapress::Library</name>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
    <message>
        <source>Add Clips</source>
        <translation>Añadir clips</translation>
    </message>
    <message>
        <source>Remove Clip</source>
        <translation>Quitar clip</translation>
    </message>
    <message numerus="yes">
        <source>%Ln clip(s) were taken out of the library; Redo brings them back.</source>
        <translation>
            <numerusform>Se quitó %Ln clip de la biblioteca; Rehacer lo devuelve.</numerusform>
            <numerusform>Se quitaron %Ln clips de la biblioteca; Rehacer los devuelve.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>No verdict for %Ln clip(s): the file is missing.</source>
        <translation>
            <numerusform>Sin veredicto para %Ln clip: falta el archivo.</numerusform>
            <numerusform>Sin veredicto para %Ln clips: falta el archivo.</numerusform>
        </translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Preajuste</translation>
    </message>
    <message numerus="yes">
        <source>The files of %Ln clip(s) have changed.</source>
        <translation>
            <numerusform>Han cambiado los archivos de %Ln clip.</numerusform>
            <numerusform>Han cambiado los archivos de %Ln clips.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The files of %Ln clip(s) are missing. The library&apos;s context menu finds them in another folder.</source>
        <translation>
            <numerusform>Faltan los archivos de %Ln clip. El menú contextual de la biblioteca lo encuentra en otra carpeta.</numerusform>
            <numerusform>Faltan los archivos de %Ln clips. El menú contextual de la biblioteca los encuentra en otra carpeta.</numerusform>
        </translation>
    </message>
    <message>
        <source>Find Clips</source>
        <translation>Encontrar clips</translation>
    </message>
    <message numerus="yes">
        <source>Found %Ln clip(s)</source>
        <translation>
            <numerusform>Se encontró %Ln clip</numerusform>
            <numerusform>Se encontraron %Ln clips</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %Ln still missing</source>
        <translation>
            <numerusform>, aún falta %Ln</numerusform>
            <numerusform>, aún faltan %Ln</numerusform>
        </translation>
    </message>
    <message>
        <source>Paste Settings</source>
        <translation>Pegar ajustes</translation>
    </message>
    <message>
        <source>Paste Importance</source>
        <translation>Pegar importancia</translation>
    </message>
    <message numerus="yes">
        <source>%1, %Ln Clip(s)</source>
        <translation>
            <numerusform>%1, %Ln clip</numerusform>
            <numerusform>%1, %Ln clips</numerusform>
        </translation>
    </message>
    <message>
        <source>Character</source>
        <translation>Personaje</translation>
    </message>
    <message>
        <source>The clip&apos;s files changed while it was compressed.</source>
        <translation>Los archivos del clip cambiaron mientras se comprimía.</translation>
    </message>
    <message>
        <source>No clip has notes on its frames.</source>
        <translation>Ningún clip tiene notas en sus fotogramas.</translation>
    </message>
    <message numerus="yes">
        <source>Wrote the notes of %Ln file(s) beside them.</source>
        <translation>
            <numerusform>Se escribieron las notas de %Ln archivo junto a él.</numerusform>
            <numerusform>Se escribieron las notas de %Ln archivos junto a ellos.</numerusform>
        </translation>
    </message>
    <message>
        <source>Read Notes</source>
        <translation>Leer notas</translation>
    </message>
    <message numerus="yes">
        <source>Read %Ln note(s).</source>
        <translation>
            <numerusform>Se leyó %Ln nota.</numerusform>
            <numerusform>Se leyeron %Ln notas.</numerusform>
        </translation>
    </message>
    <message>
        <source>The files beside the clips have no other notes.</source>
        <translation>Los archivos junto a los clips no tienen otras notas.</translation>
    </message>
    <message>
        <source>nothing changed by more than 1 %</source>
        <translation>nada cambió más de un 1 %</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>%L1 %2</source>
        <comment>number of clips, change</comment>
        <translation>%L1 %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln clip(s) compared with %1: %2 bytes then, %3 now; %4.</source>
        <translation>
            <numerusform>%Ln clip comparado con %1: antes %2 bytes, ahora %3; %4.</numerusform>
            <numerusform>%Ln clips comparados con %1: antes %2 bytes, ahora %3; %4.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mocapress::LibraryColumns</name>
    <message>
        <source>loop, last pose repeats the first</source>
        <translation>bucle, la última pose repite la primera</translation>
    </message>
    <message>
        <source>loop</source>
        <translation>bucle</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Clip</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Tasa</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Error</translation>
    </message>
    <message>
        <source>Worst</source>
        <translation>Peor</translation>
    </message>
    <message>
        <source>Slide</source>
        <translation>Desliz.</translation>
    </message>
    <message>
        <source>Eye</source>
        <translation>Ojo</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Avisos</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Bucle</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Duración</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Preajuste</translation>
    </message>
    <message>
        <source>Clip, with its result and verdict</source>
        <translation>El clip, con su resultado y su veredicto</translation>
    </message>
    <message>
        <source>Compression ratio of the motion</source>
        <translation>Tasa de compresión del movimiento</translation>
    </message>
    <message>
        <source>Bytes of the compressed motion</source>
        <translation>Bytes del movimiento comprimido</translation>
    </message>
    <message>
        <source>Error of the whole clip, eps_x</source>
        <translation>Error de todo el clip, eps_x</translation>
    </message>
    <message>
        <source>The largest error of any point at any frame</source>
        <translation>El mayor error de cualquier punto en cualquier fotograma</translation>
    </message>
    <message>
        <source>Path of feet that stand in the original, summed over all contacts</source>
        <translation>Recorrido de los pies que se apoyan en el original, sumado en todos los contactos</translation>
    </message>
    <message>
        <source>Visibility of errors</source>
        <translation>Visibilidad de los errores</translation>
    </message>
    <message>
        <source>Verdict of the review</source>
        <translation>Veredicto de la revisión</translation>
    </message>
    <message>
        <source>Places that were repaired or guessed when the clip was read</source>
        <translation>Lugares que se repararon o supusieron al leer el clip</translation>
    </message>
    <message>
        <source>Kind of loop, if the clip is one</source>
        <translation>Tipo de bucle, si el clip lo es</translation>
    </message>
    <message>
        <source>Length of the clip in seconds</source>
        <translation>Duración del clip en segundos</translation>
    </message>
    <message>
        <source>Preset of the clip&apos;s settings</source>
        <translation>Preajuste de los ajustes del clip</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Bytes since</source>
        <translation>Bytes desde</translation>
    </message>
    <message>
        <source>Error since</source>
        <translation>Error desde</translation>
    </message>
    <message>
        <source>Changes since</source>
        <translation>Cambios desde</translation>
    </message>
    <message>
        <source>Bytes that it has more than in the batch that is compared</source>
        <translation>Bytes que tiene de más respecto al lote comparado</translation>
    </message>
    <message>
        <source>Error that it has more than in the batch that is compared</source>
        <translation>Error que tiene de más respecto al lote comparado</translation>
    </message>
    <message>
        <source>Changes since the batch that is compared, the gravest first</source>
        <translation>Cambios desde el lote comparado, los más graves primero</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fallido</translation>
    </message>
    <message>
        <source>newly visible</source>
        <translation>ahora visible</translation>
    </message>
    <message>
        <source>worse</source>
        <translation>peor</translation>
    </message>
    <message>
        <source>larger</source>
        <translation>mayor</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>ya no está</translation>
    </message>
    <message>
        <source>added</source>
        <translation>añadido</translation>
    </message>
    <message>
        <source>no longer failed</source>
        <translation>ya no falla</translation>
    </message>
    <message>
        <source>no longer visible</source>
        <translation>ya no visible</translation>
    </message>
    <message>
        <source>better</source>
        <translation>mejor</translation>
    </message>
    <message>
        <source>smaller</source>
        <translation>menor</translation>
    </message>
</context>
<context>
    <name>mocapress::LibraryFilter</name>
    <message>
        <source>All clips</source>
        <translation>Todos</translation>
    </message>
    <message>
        <source>Not reviewed</source>
        <translation>Sin revisar</translation>
    </message>
    <message>
        <source>Approved</source>
        <translation>Aprobados</translation>
    </message>
    <message>
        <source>Rejected</source>
        <translation>Rechazados</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Caducados</translation>
    </message>
    <message>
        <source>With warnings</source>
        <translation>Con avisos</translation>
    </message>
    <message>
        <source>With visible errors</source>
        <translation>Con errores visibles</translation>
    </message>
    <message>
        <source>Not compressed yet</source>
        <translation>Aún sin comprimir</translation>
    </message>
    <message>
        <source>Missed or failed</source>
        <translation>Objetivo fallado o con error</translation>
    </message>
    <message>
        <source>To review</source>
        <translation>Por revisar</translation>
    </message>
    <message>
        <source>With notes</source>
        <translation>Con notas</translation>
    </message>
</context>
<context>
    <name>mocapress::LibraryGroups</name>
    <message>
        <source>By folder</source>
        <translation>Por carpeta</translation>
    </message>
    <message>
        <source>By verdict</source>
        <translation>Por veredicto</translation>
    </message>
    <message>
        <source>By visibility</source>
        <translation>Por visibilidad</translation>
    </message>
    <message>
        <source>As a list</source>
        <translation>Como lista</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>By %1</source>
        <comment>title of a column</comment>
        <translation>Por %1</translation>
    </message>
    <message>
        <source>Without warnings</source>
        <translation>Sin avisos</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>menos de %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>de %1 a %2</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>By slide</source>
        <translation>Por deslizamiento</translation>
    </message>
    <message>
        <source>By worst error</source>
        <translation>Por peor error</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
</context>
<context>
    <name>mocapress::LibraryModel</name>
    <message>
        <source>Cannot be read</source>
        <translation>No se puede leer</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Leyendo…</translation>
    </message>
    <message numerus="yes">
        <source>%Ln frame(s)</source>
        <translation>
            <numerusform>%Ln fotograma</numerusform>
            <numerusform>%Ln fotogramas</numerusform>
        </translation>
    </message>
    <message>
        <source>✓ approved</source>
        <translation>✓ aprobado</translation>
    </message>
    <message>
        <source>✕ rejected</source>
        <translation>✕ rechazado</translation>
    </message>
    <message>
        <source>target met</source>
        <translation>objetivo cumplido</translation>
    </message>
    <message>
        <source>! target missed</source>
        <translation>! objetivo fallado</translation>
    </message>
    <message>
        <source>! file missing</source>
        <translation>! falta el archivo</translation>
    </message>
    <message>
        <source>! %1</source>
        <translation>! %1</translation>
    </message>
    <message>
        <source>file missing</source>
        <translation>falta el archivo</translation>
    </message>
    <message>
        <source>file changed</source>
        <translation>el archivo cambió</translation>
    </message>
    <message>
        <source>settings changed</source>
        <translation>los ajustes cambiaron</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>files not known</source>
        <translation>archivos desconocidos</translation>
    </message>
    <message>
        <source>✓ stale: %1</source>
        <translation>✓ caducado: %1</translation>
    </message>
    <message>
        <source>✕ stale: %1</source>
        <translation>✕ caducado: %1</translation>
    </message>
    <message numerus="yes">
        <source>%Ln note(s)</source>
        <translation>
            <numerusform>%Ln nota</numerusform>
            <numerusform>%Ln notas</numerusform>
        </translation>
    </message>
    <message>
        <source>! cannot be compressed</source>
        <translation>! no se puede comprimir</translation>
    </message>
    <message numerus="yes">
        <source>%Ln clip(s)</source>
        <comment>selected</comment>
        <translation>
            <numerusform>%Ln clip</numerusform>
            <numerusform>%Ln clips</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 bytes, %3 before</source>
        <translation>%1: %2 bytes, antes %3</translation>
    </message>
    <message>
        <source>%1: %2 bytes</source>
        <translation>%1: %2 bytes</translation>
    </message>
    <message>
        <source>%L1 not compressed yet</source>
        <translation>%L1 aún sin comprimir</translation>
    </message>
    <message>
        <source>%1: %2 bytes before, %3</source>
        <translation>%1: %2 bytes antes, %3</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>take of a file</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>mocapress::LibraryPanel</name>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Clips of the project</source>
        <translation>Clips del proyecto</translation>
    </message>
    <message>
        <source>Add motion files to the project. Each keeps its own settings.</source>
        <translation>Añadir archivos de movimiento al proyecto. Cada uno conserva sus propios ajustes.</translation>
    </message>
    <message>
        <source>Remove the selected clips from the project; their files stay.</source>
        <translation>Quitar del proyecto los clips seleccionados; sus archivos se quedan.</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
    <message>
        <source>Not reviewed</source>
        <translation>Sin revisar</translation>
    </message>
    <message>
        <source>Approved</source>
        <translation>Aprobados</translation>
    </message>
    <message>
        <source>Rejected</source>
        <translation>Rechazados</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>Note about this clip</source>
        <translation>Nota sobre este clip</translation>
    </message>
    <message>
        <source>The project keeps this note with the verdict.</source>
        <translation>El proyecto conserva esta nota con el veredicto.</translation>
    </message>
    <message>
        <source>Export Selected, Each with Its Own Settings…</source>
        <translation>Exportar los seleccionados, cada uno con sus ajustes…</translation>
    </message>
    <message>
        <source>Export All, Each with Its Own Settings…</source>
        <translation>Exportar todos, cada uno con sus ajustes…</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>Filter of the clips</source>
        <translation>Filtro de los clips</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtrar</translation>
    </message>
    <message>
        <source>&amp;Clips…</source>
        <translation>&amp;Clips…</translation>
    </message>
    <message>
        <source>&amp;Folder…</source>
        <translation>Car&amp;peta…</translation>
    </message>
    <message>
        <source>Verdict on the selected clips, with their present files and settings.</source>
        <translation>Veredicto sobre los clips seleccionados, con sus archivos y ajustes actuales.</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Preajuste</translation>
    </message>
    <message>
        <source>Find Missing Clips in a Folder…</source>
        <translation>Encontrar clips que faltan en una carpeta…</translation>
    </message>
    <message>
        <source>Clips that are shown</source>
        <translation>Clips que se muestran</translation>
    </message>
    <message>
        <source>Filter of shown clips</source>
        <translation>Filtro de los clips mostrados</translation>
    </message>
    <message>
        <source>Groups of the clips</source>
        <translation>Grupos de los clips</translation>
    </message>
    <message>
        <source>Grouping of clips</source>
        <translation>Agrupación de los clips</translation>
    </message>
    <message>
        <source>Copy Settings</source>
        <translation>Copiar ajustes</translation>
    </message>
    <message>
        <source>Paste Settings</source>
        <translation>Pegar ajustes</translation>
    </message>
    <message>
        <source>Paste Importance Only</source>
        <translation>Pegar solo la importancia</translation>
    </message>
    <message>
        <source>Put a Character On…</source>
        <translation>Poner un personaje…</translation>
    </message>
    <message>
        <source>Take the Character Off</source>
        <translation>Quitar el personaje</translation>
    </message>
    <message>
        <source>Order and columns</source>
        <translation>Orden y columnas</translation>
    </message>
    <message>
        <source>What clips are sorted by, and the columns beside them</source>
        <translation>Por qué se ordenan los clips, y las columnas a su lado</translation>
    </message>
    <message>
        <source>Sort By</source>
        <translation>Ordenar por</translation>
    </message>
    <message>
        <source>Order of the Library</source>
        <translation>Orden de la biblioteca</translation>
    </message>
    <message>
        <source>Notes on Reading</source>
        <translation>Notas de lectura</translation>
    </message>
    <message>
        <source>Words in a clip&apos;s name, folder or state, such as “walks missed”, and bounds on columns, such as “error&gt;=5mm ratio&lt;20”: lengths without a unit are in cm.</source>
        <translation>Palabras del nombre, la carpeta o el estado de un clip, como «marchas fallado», y límites de columnas, como «error&gt;=5mm tasa&lt;20»: las longitudes sin unidad son cm.</translation>
    </message>
</context>
<context>
    <name>mocapress::LibraryPlot</name>
    <message>
        <source>Clips of the library, error over ratio</source>
        <translation>Clips de la biblioteca, error frente a tasa</translation>
    </message>
    <message>
        <source>The columns of the library show all measurements.</source>
        <translation>Las columnas de la biblioteca muestran todas las medidas.</translation>
    </message>
    <message>
        <source>Compression ratio (smaller files →)</source>
        <translation>Tasa de compresión (archivos más pequeños →)</translation>
    </message>
    <message>
        <source>eps_x (cm)</source>
        <translation>eps_x (cm)</translation>
    </message>
    <message>
        <source>Clips appear here after they are compressed</source>
        <translation>Los clips aparecen aquí cuando están comprimidos</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>desconocido</translation>
    </message>
</context>
<context>
    <name>mocapress::LibraryTree</name>
    <message numerus="yes">
        <source>%Ln clip(s)</source>
        <translation>
            <numerusform>%Ln clip</numerusform>
            <numerusform>%Ln clips</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %L2 missed</source>
        <translation>%1, %L2 con objetivo fallado</translation>
    </message>
</context>
<context>
    <name>mocapress::LibraryViews</name>
    <message>
        <source>Add Clips</source>
        <translation>Añadir clips</translation>
    </message>
    <message>
        <source>Motion (%1)</source>
        <translation>Movimiento (%1)</translation>
    </message>
    <message>
        <source>Add Folder</source>
        <translation>Añadir carpeta</translation>
    </message>
    <message>
        <source>Find Missing Clips</source>
        <translation>Encontrar clips que faltan</translation>
    </message>
    <message>
        <source>Put a Character On</source>
        <translation>Poner un personaje</translation>
    </message>
    <message>
        <source>Characters (*.fbx *.glb *.gltf *.vrm)</source>
        <translation>Personajes (*.fbx *.glb *.gltf *.vrm)</translation>
    </message>
    <message>
        <source>This is the last clip that waits for a verdict.</source>
        <translation>Este es el último clip que espera un veredicto.</translation>
    </message>
    <message>
        <source>No clip that is shown waits for a verdict.</source>
        <translation>Ninguno de los clips mostrados espera un veredicto.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Compare Library with a Batch</source>
        <translation>Comparar la biblioteca con un lote</translation>
    </message>
    <message>
        <source>Batches and projects (batch*.jsonl report*.json report*.html *.mocapress)</source>
        <translation>Lotes y proyectos (batch*.jsonl report*.json report*.html *.mocapress)</translation>
    </message>
</context>
<context>
    <name>mocapress::MainWindow</name>
    <message>
        <source>The language changes when Mocapress is started again.</source>
        <translation>El idioma cambia cuando Mocapress se inicia de nuevo.</translation>
    </message>
    <message>
        <source>%1[*] – %2</source>
        <translation>%1[*] – %2</translation>
    </message>
    <message>
        <source>Your own limits of visibility are not used: %1</source>
        <translation>Sus propios límites de visibilidad no se usan: %1</translation>
    </message>
</context>
<context>
    <name>mocapress::MessageBar</name>
    <message>
        <source>Message</source>
        <translation>Mensaje</translation>
    </message>
    <message>
        <source>Close message</source>
        <translation>Cerrar mensaje</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Possible solution</source>
        <translation>Posible solución</translation>
    </message>
    <message>
        <source>Work in progress</source>
        <translation>Trabajo en curso</translation>
    </message>
</context>
<context>
    <name>mocapress::Methods</name>
    <message>
        <source>Closed-loop wavelets</source>
        <translation>Ondículas en bucle cerrado</translation>
    </message>
    <message>
        <source>Annealed wavelets</source>
        <translation>Ondículas recocidas</translation>
    </message>
    <message>
        <source>Standard wavelets</source>
        <translation>Ondículas estándar</translation>
    </message>
    <message>
        <source>Per-channel wavelets</source>
        <translation>Ondículas por canal</translation>
    </message>
    <message>
        <source>Haar wavelets</source>
        <translation>Ondículas de Haar</translation>
    </message>
    <message>
        <source>Linear wavelets</source>
        <translation>Ondículas lineales</translation>
    </message>
    <message>
        <source>PCA</source>
        <translation>PCA</translation>
    </message>
    <message>
        <source>Frame subsampling</source>
        <translation>Submuestreo de fotogramas</translation>
    </message>
    <message>
        <source>Quaternion wavelets</source>
        <translation>Ondículas de cuaterniones</translation>
    </message>
    <message>
        <source>Segment PCA, after Liu &amp; McMillan</source>
        <translation>PCA por segmentos, según Liu y McMillan</translation>
    </message>
    <message>
        <source>Clustered PCA, after Arikan</source>
        <translation>PCA por grupos, según Arikan</translation>
    </message>
    <message>
        <source>%1 + IK %L2:1</source>
        <translation>%1 + IK %L2:1</translation>
    </message>
    <message>
        <source>Key frames per track</source>
        <translation>Fotogramas clave por pista</translation>
    </message>
</context>
<context>
    <name>mocapress::Names</name>
    <message>
        <source>16-bit runs</source>
        <translation>Series de 16 bits</translation>
    </message>
    <message>
        <source>16-bit runs + DEFLATE</source>
        <translation>Series de 16 bits + DEFLATE</translation>
    </message>
    <message>
        <source>Adaptive</source>
        <translation>Adaptativa</translation>
    </message>
    <message>
        <source>Bone ends</source>
        <translation>Extremos de huesos</translation>
    </message>
    <message>
        <source>Joint origins</source>
        <translation>Orígenes de articulaciones</translation>
    </message>
    <message>
        <source>Every frame</source>
        <translation>Cada fotograma</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Contactos</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Superficie</translation>
    </message>
    <message>
        <source>Shell</source>
        <translation>Envoltura</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Piel</translation>
    </message>
</context>
<context>
    <name>mocapress::NoteStrip</name>
    <message>
        <source>Notes on frames</source>
        <translation>Notas en fotogramas</translation>
    </message>
    <message>
        <source>The menu Review adds a note and goes from one to the next.</source>
        <translation>El menú Revisión añade una nota y va de una a la siguiente.</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notas</translation>
    </message>
    <message>
        <source>A click on a mark goes to its frame and joint; the right button edits or removes the note.</source>
        <translation>Un clic en una marca va a su fotograma y articulación; el botón derecho edita o quita la nota.</translation>
    </message>
    <message>
        <source>Edit Note…</source>
        <translation>Editar nota…</translation>
    </message>
    <message>
        <source>Remove Note</source>
        <translation>Quitar nota</translation>
    </message>
</context>
<context>
    <name>mocapress::Notices</name>
    <message numerus="yes">
        <source>The last session ended unexpectedly. Its project was restored: %Ln clip(s).</source>
        <translation>
            <numerusform>La última sesión terminó de forma inesperada. Su proyecto se restauró: %Ln clip.</numerusform>
            <numerusform>La última sesión terminó de forma inesperada. Su proyecto se restauró: %Ln clips.</numerusform>
        </translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 guardado.</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>Abriendo %1…</translation>
    </message>
    <message>
        <source>Exported %1.</source>
        <translation>%1 exportado.</translation>
    </message>
</context>
<context>
    <name>mocapress::OpenClip</name>
    <message>
        <source>%1 is not the original of the compressed clip: joints, frames or sample rate differ.</source>
        <translation>%1 no es el original del clip comprimido: difieren las articulaciones, los fotogramas o la cadencia.</translation>
    </message>
</context>
<context>
    <name>mocapress::Overlay</name>
    <message>
        <source>Original</source>
        <translation>Original</translation>
    </message>
    <message>
        <source>Compressed</source>
        <translation>Comprimido</translation>
    </message>
    <message>
        <source>Difference × %L1</source>
        <translation>Diferencia × %L1</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Frente</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Lado</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Arriba</translation>
    </message>
</context>
<context>
    <name>mocapress::Panels</name>
    <message>
        <source>Library</source>
        <translation>Biblioteca</translation>
    </message>
    <message>
        <source>Compression</source>
        <translation>Compresión</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Articulaciones</translation>
    </message>
    <message>
        <source>Footskate</source>
        <translation>Deslizamiento</translation>
    </message>
    <message>
        <source>Error over time</source>
        <translation>Error en el tiempo</translation>
    </message>
    <message>
        <source>Heat map</source>
        <translation>Mapa de calor</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Canal</translation>
    </message>
    <message>
        <source>Rate-distortion</source>
        <translation>Tasa-distorsión</translation>
    </message>
    <message>
        <source>Importance</source>
        <translation>Importancia</translation>
    </message>
    <message>
        <source>Pinned</source>
        <translation>Fijados</translation>
    </message>
    <message>
        <source>All clips</source>
        <translation>Todos</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Bytes</translation>
    </message>
</context>
<context>
    <name>mocapress::PartNames</name>
    <message>
        <source>Clear</source>
        <translation>Borrar</translation>
    </message>
    <message>
        <source>More tools</source>
        <translation>Más herramientas</translation>
    </message>
</context>
<context>
    <name>mocapress::PinnedModel</name>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Double click to give it another name.</source>
        <translation>Haga doble clic para darle otro nombre.</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Tasa</translation>
    </message>
    <message>
        <source>Compression ratio</source>
        <translation>Tasa de compresión</translation>
    </message>
    <message>
        <source>Weighted root mean square distance from the original.</source>
        <translation>Distancia cuadrática media ponderada al original.</translation>
    </message>
    <message>
        <source>95 % of all points at all frames have at most this error.</source>
        <translation>El 95 % de los puntos en todos los fotogramas tiene como máximo este error.</translation>
    </message>
    <message>
        <source>Largest error of any point at any frame.</source>
        <translation>Mayor error de cualquier punto en cualquier fotograma.</translation>
    </message>
    <message>
        <source>eps_x</source>
        <translation>eps_x</translation>
    </message>
    <message>
        <source>p95</source>
        <translation>p95</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Máx.</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Deriva</translation>
    </message>
    <message>
        <source>Largest distance between a standing foot and its place in the original.</source>
        <translation>Mayor distancia entre un pie apoyado y su lugar en el original.</translation>
    </message>
</context>
<context>
    <name>mocapress::PinnedPanel</name>
    <message>
        <source>Pin This</source>
        <translation>Fijar este</translation>
    </message>
    <message>
        <source>Make Current</source>
        <translation>Hacer actual</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>Soltar</translation>
    </message>
    <message>
        <source>Pinned results</source>
        <translation>Resultados fijados</translation>
    </message>
    <message>
        <source>Keep the current result in the view, as a figure with its own colour, while you try other settings.</source>
        <translation>Mantener el resultado actual en la vista, como figura de color propio, mientras se prueban otros ajustes.</translation>
    </message>
    <message>
        <source>Use the settings of the selected result. This can be undone.</source>
        <translation>Usar los ajustes del resultado seleccionado. Se puede deshacer.</translation>
    </message>
    <message>
        <source>Remove the selected result from the view.</source>
        <translation>Quitar de la vista el resultado seleccionado.</translation>
    </message>
</context>
<context>
    <name>mocapress::PinnedResults</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Fijar</translation>
    </message>
    <message>
        <source>Take Off a Pin</source>
        <translation>Soltar un resultado fijado</translation>
    </message>
    <message>
        <source>Name of a Pin</source>
        <translation>Nombre de un resultado fijado</translation>
    </message>
    <message>
        <source>%1 (%L2)</source>
        <translation>%1 (%L2)</translation>
    </message>
    <message>
        <source>The result is not final yet, or four are pinned.</source>
        <translation>El resultado aún no es definitivo, o ya hay cuatro fijados.</translation>
    </message>
    <message>
        <source>Four results are pinned already.</source>
        <translation>Ya hay cuatro resultados fijados.</translation>
    </message>
</context>
<context>
    <name>mocapress::Plots</name>
    <message>
        <source>Copy Image</source>
        <translation>Copiar imagen</translation>
    </message>
</context>
<context>
    <name>mocapress::PoseStrip</name>
    <message>
        <source>Poses over time</source>
        <translation>Poses en el tiempo</translation>
    </message>
    <message>
        <source>Poses of the clip along the time; a click goes there.</source>
        <translation>Poses del clip a lo largo del tiempo; un clic va a ese momento.</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>Poses</translation>
    </message>
</context>
<context>
    <name>mocapress::Presenter</name>
    <message>
        <source>This method cannot reach the target for this clip.</source>
        <translation>Este método no alcanza el objetivo en este clip.</translation>
    </message>
</context>
<context>
    <name>mocapress::PresetChooser</name>
    <message>
        <source>Preset</source>
        <translation>Preajuste</translation>
    </message>
    <message>
        <source>A preset sets target, method, importance, effort and IK. Your own presets are kept in the settings of this program.</source>
        <translation>Un preajuste fija objetivo, método, importancia, esfuerzo e IK. Los preajustes propios se guardan en la configuración de este programa.</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Preajustes</translation>
    </message>
    <message>
        <source>Keep, share and remove presets of your own</source>
        <translation>Guardar, compartir y quitar preajustes propios</translation>
    </message>
    <message>
        <source>Save as Preset…</source>
        <translation>Guardar como preajuste…</translation>
    </message>
    <message>
        <source>Rename Preset…</source>
        <translation>Renombrar preajuste…</translation>
    </message>
    <message>
        <source>Remove Preset</source>
        <translation>Quitar preajuste</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importar…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>Custom settings</source>
        <translation>Ajustes propios</translation>
    </message>
    <message>
        <source>%1, modified</source>
        <translation>%1, modificado</translation>
    </message>
</context>
<context>
    <name>mocapress::PresetEditor</name>
    <message>
        <source>Hold feet by inverse kinematics</source>
        <translation>Sujetar los pies por cinemática inversa</translation>
    </message>
    <message>
        <source>Kind of target</source>
        <translation>Tipo de objetivo</translation>
    </message>
    <message>
        <source>Error, eps_x</source>
        <translation>Error, eps_x</translation>
    </message>
    <message>
        <source>Hard maximum</source>
        <translation>Máximo absoluto</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Tasa</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>Coefficient ratio</source>
        <translation>Tasa de coeficientes</translation>
    </message>
    <message>
        <source>Value of the target</source>
        <translation>Valor del objetivo</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>Keeps standing feet in place, for some more bytes.</source>
        <translation>Mantiene en su sitio los pies apoyados, por algunos bytes más.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Objetivo</translation>
    </message>
    <message>
        <source>:1</source>
        <translation>:1</translation>
    </message>
    <message>
        <source> bytes</source>
        <translation> bytes</translation>
    </message>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source>Visibility</source>
        <translation>Visibilidad</translation>
    </message>
    <message>
        <source>Error, eps_x: the weighted root mean square error; single frames may exceed it. Hard maximum: largest error of any point of the body at any frame. Visibility: largest error as a multiple of what people notice; at 1, no error is visible. Quality targets suit all kinds of clips; ratio and bytes ignore how hard a clip is to compress.</source>
        <translation>Error, eps_x: el error cuadrático medio ponderado; algunos fotogramas pueden superarlo. Máximo absoluto: mayor error de cualquier punto del cuerpo en cualquier fotograma. Visibilidad: mayor error como múltiplo de lo que la gente nota; con 1, ningún error es visible. Los objetivos de calidad sirven para todo tipo de clips; la tasa y los bytes ignoran lo difícil que es comprimir un clip.</translation>
    </message>
    <message>
        <source> times</source>
        <translation> veces</translation>
    </message>
    <message>
        <source>Weighting</source>
        <translation>Ponderación</translation>
    </message>
    <message>
        <source>Points on which the error eps_x is measured. Surface: a body modelled around the bones, so that turned heads and hands count. Skin: the mesh of the clip or of the batch&apos;s character; clips without a mesh are refused. Shell: three points 3 cm from every joint, as in ACL. Bone ends and joint origins: points on the bones, weighted by bone length; joint origins are the paper&apos;s.</source>
        <translation>Puntos en los que se mide el error eps_x. Superficie: un cuerpo modelado alrededor de los huesos, para que cuenten las cabezas y manos giradas. Piel: la malla del clip o del personaje del lote; los clips sin malla se rechazan. Envoltura: tres puntos a 3 cm de cada articulación, como en ACL. Extremos de huesos y orígenes de articulaciones: puntos en los huesos, ponderados por su longitud; los orígenes de articulaciones son los del artículo.</translation>
    </message>
</context>
<context>
    <name>mocapress::PresetShelf</name>
    <message>
        <source>This is the name of a built-in preset. Choose another name.</source>
        <translation>Este es el nombre de un preajuste incorporado. Elija otro.</translation>
    </message>
    <message>
        <source>Save Preset</source>
        <translation>Guardar preajuste</translation>
    </message>
    <message>
        <source>There is a preset %1 already.</source>
        <translation>Ya hay un preajuste %1.</translation>
    </message>
    <message>
        <source>Rename Preset</source>
        <translation>Renombrar preajuste</translation>
    </message>
    <message>
        <source>Remove Preset</source>
        <translation>Quitar preajuste</translation>
    </message>
    <message>
        <source>Import Presets</source>
        <translation>Importar preajustes</translation>
    </message>
    <message>
        <source>Wrote %1.</source>
        <translation>%1 escrito.</translation>
    </message>
    <message>
        <source>Presets could not be kept: %1</source>
        <translation>No se pudieron guardar los preajustes: %1</translation>
    </message>
    <message>
        <source>The presets could not be read; their file was renamed to %1.</source>
        <translation>No se pudieron leer los preajustes; su archivo se renombró a %1.</translation>
    </message>
</context>
<context>
    <name>mocapress::PresetViews</name>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Rename Preset</source>
        <translation>Renombrar preajuste</translation>
    </message>
    <message>
        <source>Import Presets</source>
        <translation>Importar preajustes</translation>
    </message>
    <message>
        <source>Presets (*.json)</source>
        <translation>Preajustes (*.json)</translation>
    </message>
    <message>
        <source>Export Preset</source>
        <translation>Exportar preajuste</translation>
    </message>
    <message>
        <source>Save as Preset</source>
        <translation>Guardar como preajuste</translation>
    </message>
    <message>
        <source>Save Preset</source>
        <translation>Guardar preajuste</translation>
    </message>
</context>
<context>
    <name>mocapress::Presets</name>
    <message>
        <source>Hero close-up</source>
        <translation>Primer plano del héroe</translation>
    </message>
    <message>
        <source>Gameplay</source>
        <translation>Juego</translation>
    </message>
    <message>
        <source>Crowd</source>
        <translation>Multitud</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archivado</translation>
    </message>
    <message>
        <source>For archives that replace the source: no point of the body&apos;s surface has an error above 1 mm at any frame.</source>
        <translation>Para archivos que sustituyen a la fuente: ningún punto de la superficie del cuerpo tiene un error mayor de 1 mm en ningún fotograma.</translation>
    </message>
    <message>
        <source>Planted feet</source>
        <translation>Pies plantados</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Pies</translation>
    </message>
    <message>
        <source>Hands</source>
        <translation>Manos</translation>
    </message>
    <message>
        <source>Fingers</source>
        <translation>Dedos</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Cabeza</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Borrador</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Mejor</translation>
    </message>
    <message>
        <source>%1 × %L2</source>
        <translation>%1 × %L2</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Contactos</translation>
    </message>
    <message>
        <source>Importance: %1.</source>
        <translation>Importancia: %1.</translation>
    </message>
    <message>
        <source>Effort: %1.</source>
        <translation>Esfuerzo: %1.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln contact(s) of its own.</source>
        <translation>
            <numerusform>%Ln contacto propio.</numerusform>
            <numerusform>%Ln contactos propios.</numerusform>
        </translation>
    </message>
    <message>
        <source>Characters in play: an error of 2.5 mm on the body&apos;s surface, at most 2.5 degrees of heads and 4 of hands.</source>
        <translation>Personajes en juego: un error de 2,5 mm en la superficie del cuerpo, como máximo 2,5 grados en cabezas y 4 en manos.</translation>
    </message>
    <message>
        <source>Characters near the camera: an error of 0.65 mm on the body&apos;s surface, about a degree of heads and hands.</source>
        <translation>Personajes cerca de la cámara: un error de 0,65 mm en la superficie del cuerpo, alrededor de un grado en cabezas y manos.</translation>
    </message>
    <message>
        <source>Figures in the background: an error of 6 mm on the body&apos;s surface, at most 7.5 degrees of heads and 12 of hands.</source>
        <translation>Figuras al fondo: un error de 6 mm en la superficie del cuerpo, como máximo 7,5 grados en cabezas y 12 en manos.</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Libres</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Parejos</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Exactos</translation>
    </message>
    <message>
        <source>Ends: %1.</source>
        <translation>Extremos: %1.</translation>
    </message>
    <message>
        <source>Like Gameplay, with much less sliding of feet, for 5 to 13 % more bytes.</source>
        <translation>Como Juego, con mucho menos deslizamiento de pies, por un 5 a 13 % más de bytes.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln range(s) with more care.</source>
        <translation>
            <numerusform>%Ln intervalo con más cuidado.</numerusform>
            <numerusform>%Ln intervalos con más cuidado.</numerusform>
        </translation>
    </message>
    <message>
        <source>Watched from %L1 m.</source>
        <translation>Se observa desde %L1 m.</translation>
    </message>
</context>
<context>
    <name>mocapress::ProjectFiles</name>
    <message>
        <source>Mocapress projects (*.mocapress)</source>
        <translation>Proyectos de Mocapress (*.mocapress)</translation>
    </message>
    <message>
        <source>Unnamed Project</source>
        <translation>Proyecto sin nombre</translation>
    </message>
    <message>
        <source>Open Project</source>
        <translation>Abrir proyecto</translation>
    </message>
    <message>
        <source>Save Project</source>
        <translation>Guardar proyecto</translation>
    </message>
    <message numerus="yes">
        <source>Save the project of %Ln clip(s) under a name?</source>
        <translation>
            <numerusform>¿Guardar con un nombre el proyecto de %Ln clip?</numerusform>
            <numerusform>¿Guardar con un nombre el proyecto de %Ln clips?</numerusform>
        </translation>
    </message>
    <message>
        <source>A project without a name stays in File &gt; Recent Projects, under its date.</source>
        <translation>Un proyecto sin nombre queda en Archivo &gt; Proyectos recientes, con su fecha.</translation>
    </message>
    <message>
        <source>&amp;Keep It Unnamed</source>
        <translation>&amp;Dejarlo sin nombre</translation>
    </message>
    <message>
        <source>Project Not Written</source>
        <translation>Proyecto no escrito</translation>
    </message>
    <message>
        <source>The last changes of the project cannot be written. Quit without them?</source>
        <translation>No se pueden escribir los últimos cambios del proyecto. ¿Salir sin ellos?</translation>
    </message>
    <message>
        <source>Use Save Project As to save them to another file.</source>
        <translation>Use Guardar proyecto como para guardarlos en otro archivo.</translation>
    </message>
    <message>
        <source>Project in Use</source>
        <translation>Proyecto en uso</translation>
    </message>
    <message>
        <source>If Mocapress has ended there, the project can be taken over. If not, each would overwrite the other&apos;s work.</source>
        <translation>Si Mocapress ha terminado allí, se puede tomar el control del proyecto. Si no, cada uno sobrescribiría el trabajo del otro.</translation>
    </message>
    <message>
        <source>Take Over</source>
        <translation>Tomar el control</translation>
    </message>
    <message>
        <source>Unnamed, %1</source>
        <translation>Sin nombre, %1</translation>
    </message>
    <message numerus="yes">
        <source>%1, %Ln clip(s)</source>
        <translation>
            <numerusform>%1, %Ln clip</numerusform>
            <numerusform>%1, %Ln clips</numerusform>
        </translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>%1. Open a copy of it?</source>
        <translation>%1. ¿Abrir una copia?</translation>
    </message>
</context>
<context>
    <name>mocapress::RangeActions</name>
    <message>
        <source>More &amp;Care in the Range</source>
        <translation>Más &amp;cuidado en el intervalo</translation>
    </message>
    <message>
        <source>C&amp;ontacts in the Range</source>
        <translation>Contac&amp;tos en el intervalo</translation>
    </message>
    <message>
        <source>The Clip as a Loo&amp;p</source>
        <translation>El clip como &amp;bucle</translation>
    </message>
    <message>
        <source>As &amp;elsewhere</source>
        <translation>Como en lo &amp;demás</translation>
    </message>
    <message>
        <source>The target is a size: the other frames get worse</source>
        <translation>El objetivo es un tamaño: los demás fotogramas empeoran</translation>
    </message>
    <message>
        <source>%1 times stricter</source>
        <translation>%1 veces más estricto</translation>
    </message>
    <message>
        <source>%1 stands</source>
        <translation>%1 se apoya</translation>
    </message>
    <message>
        <source>%1 is in the air</source>
        <translation>%1 está en el aire</translation>
    </message>
    <message>
        <source>No foot stands in this clip</source>
        <translation>Ningún pie se apoya en este clip</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation>&amp;Automático</translation>
    </message>
    <message>
        <source>&amp;Not a loop</source>
        <translation>&amp;No es un bucle</translation>
    </message>
    <message>
        <source>The last frame &amp;repeats the first</source>
        <translation>El último fotograma &amp;repite el primero</translation>
    </message>
    <message>
        <source>The first frame follo&amp;ws the last</source>
        <translation>El primer fotograma &amp;sigue al último</translation>
    </message>
    <message>
        <source>First choose a range: drag along the ruler of the timeline</source>
        <translation>Elija primero un intervalo: arrastre sobre la regla de la línea de tiempo</translation>
    </message>
    <message>
        <source>First open a clip</source>
        <translation>Abra primero un clip</translation>
    </message>
</context>
<context>
    <name>mocapress::RatePlot</name>
    <message>
        <source>Rate-distortion plot</source>
        <translation>Gráfico tasa-distorsión</translation>
    </message>
    <message>
        <source>Error over compression ratio, one curve for each method. The table below lists every point.</source>
        <translation>Error frente a tasa de compresión, una curva por método. La tabla de abajo enumera cada punto.</translation>
    </message>
    <message>
        <source>Compression ratio (smaller files →)</source>
        <translation>Tasa de compresión (archivos más pequeños →)</translation>
    </message>
    <message>
        <source>current result</source>
        <translation>resultado actual</translation>
    </message>
    <message>
        <source>eps_x (cm), %1</source>
        <translation>eps_x (cm), %1</translation>
    </message>
</context>
<context>
    <name>mocapress::Report</name>
    <message>
        <source>approved</source>
        <translation>aprobado</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>rechazado</translation>
    </message>
    <message>
        <source>the clip&apos;s file changed</source>
        <translation>el archivo del clip cambió</translation>
    </message>
    <message>
        <source>the settings changed</source>
        <translation>los ajustes cambiaron</translation>
    </message>
    <message>
        <source>the clip&apos;s file and the settings changed</source>
        <translation>el archivo del clip y los ajustes cambiaron</translation>
    </message>
    <message>
        <source>it does not say which file and settings were reviewed</source>
        <translation>no dice qué archivo y qué ajustes se revisaron</translation>
    </message>
    <message>
        <source>the file is missing</source>
        <translation>falta el archivo</translation>
    </message>
    <message>
        <source>not visible</source>
        <translation>no visible</translation>
    </message>
    <message>
        <source>borderline</source>
        <translation>en el límite</translation>
    </message>
    <message>
        <source>visible</source>
        <translation>visible</translation>
    </message>
    <message>
        <source>Sign-off</source>
        <translation>Visto bueno</translation>
    </message>
    <message>
        <source>Sign-off: %1</source>
        <translation>Visto bueno: %1</translation>
    </message>
    <message>
        <source>%1 of %2 reviewed: %3 approved, %4 rejected</source>
        <translation>%1 de %2 revisados: %3 aprobados, %4 rechazados</translation>
    </message>
    <message>
        <source>; %1 verdicts stale</source>
        <translation>; %1 veredictos caducados</translation>
    </message>
    <message>
        <source>; %1 without a verdict</source>
        <translation>; %1 sin veredicto</translation>
    </message>
    <message>
        <source>Worst frames</source>
        <translation>Peores fotogramas</translation>
    </message>
    <message>
        <source>Every clip</source>
        <translation>Todos los clips</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notas</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Clip</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>fotograma</translation>
    </message>
    <message>
        <source>error, cm</source>
        <translation>error, cm</translation>
    </message>
    <message>
        <source>largest, cm</source>
        <translation>máximo, cm</translation>
    </message>
    <message>
        <source>point</source>
        <translation>punto</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>articulación</translation>
    </message>
    <message>
        <source>note</source>
        <translation>nota</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>veredicto</translation>
    </message>
    <message>
        <source>by</source>
        <translation>por</translation>
    </message>
    <message>
        <source>when</source>
        <translation>cuándo</translation>
    </message>
    <message>
        <source>stale</source>
        <translation>caducado</translation>
    </message>
    <message>
        <source>eye</source>
        <translation>ojo</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>tasa</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>bytes</translation>
    </message>
    <message>
        <source>A verdict or note is stale if the clip&apos;s file or its settings have changed since; stale verdicts do not count as reviewed. Links open the clip in Mocapress on this computer.</source>
        <translation>Un veredicto o una nota ha caducado si el archivo del clip o sus ajustes han cambiado desde entonces; los veredictos caducados no cuentan como revisados. Los enlaces abren el clip en Mocapress en este ordenador.</translation>
    </message>
    <message>
        <source>%1 from %2 m</source>
        <translation>%1 a %2 m</translation>
    </message>
    <message>
        <source>built-in limits</source>
        <translation>los límites incorporados</translation>
    </message>
    <message>
        <source>The eye judges from the viewing distance that is named, by %1.</source>
        <translation>El ojo juzga desde la distancia de observación que se indica, por %1.</translation>
    </message>
    <message>
        <source>own limits: %1</source>
        <translation>límites propios: %1</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 o %2</translation>
    </message>
    <message>
        <source>The frame with the largest error of each clip, the largest first.</source>
        <translation>El fotograma con el mayor error de cada clip, el mayor primero.</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>fotograma %1</translation>
    </message>
    <message>
        <source>frames %1</source>
        <translation>fotogramas %1</translation>
    </message>
    <message>
        <source>stale: %1</source>
        <translation>caducado: %1</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <translation>%1 por %2</translation>
    </message>
    <message>
        <source>largest error %1 cm</source>
        <translation>error máximo %1 cm</translation>
    </message>
    <message>
        <source>errors %1, by %2</source>
        <translation>errores: %1, por %2</translation>
    </message>
    <message>
        <source>%1 of %2 at frame %3: %4, noticed from %5</source>
        <translation>%1, %2, fotograma %3: %4, se nota desde %5</translation>
    </message>
    <message>
        <source>The viewer needs JavaScript.</source>
        <translation>El visor necesita JavaScript.</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ver</translation>
    </message>
    <message>
        <source>%1 cannot be shown: %2</source>
        <translation>%1 no se puede mostrar: %2</translation>
    </message>
    <message>
        <source>%1 cannot be loaded</source>
        <translation>%1 no se puede cargar</translation>
    </message>
    <message>
        <source>Previous clip</source>
        <translation>Clip anterior</translation>
    </message>
    <message>
        <source>Next clip</source>
        <translation>Clip siguiente</translation>
    </message>
    <message>
        <source>Loading</source>
        <translation>Cargando</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Fotograma</translation>
    </message>
    <message>
        <source>Key: %1</source>
        <translation>Tecla: %1</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Superponer</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Lado a lado</translation>
    </message>
    <message>
        <source>Wipe</source>
        <translation>Cortinilla</translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>Intercambiar</translation>
    </message>
    <message>
        <source>Original</source>
        <translation>Original</translation>
    </message>
    <message>
        <source>Compressed</source>
        <translation>Comprimido</translation>
    </message>
    <message>
        <source>Colour by error</source>
        <translation>Color según el error</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Seguir</translation>
    </message>
    <message>
        <source>Worst frame before</source>
        <translation>Peor fotograma anterior</translation>
    </message>
    <message>
        <source>Next worst frame</source>
        <translation>Siguiente peor fotograma</translation>
    </message>
    <message>
        <source>Reset camera</source>
        <translation>Restablecer la cámara</translation>
    </message>
    <message>
        <source>Frame %1 of %2, %3 s.</source>
        <translation>Fotograma %1 de %2, %3 s.</translation>
    </message>
    <message>
        <source>On the bones, %1 is %2 cm off.</source>
        <translation>En los huesos, desvío de %1: %2 cm.</translation>
    </message>
    <message>
        <source>The lightest colour is %1 cm.</source>
        <translation>El color más claro es %1 cm.</translation>
    </message>
    <message>
        <source>%1 to %2 s: %3</source>
        <translation>%1 a %2 s: %3</translation>
    </message>
    <message>
        <source>any</source>
        <translation>todas</translation>
    </message>
    <message>
        <source>Rows are joints, the first row is any joint. A full bar marks times with visible errors, half a bar borderline ones, no bar errors that nobody sees.</source>
        <translation>Cada fila es una articulación; la primera, cualquiera de ellas. Una barra entera marca los momentos con errores visibles, media barra los que están en el límite; sin barra, nadie ve errores.</translation>
    </message>
    <message>
        <source>compression ratio %1 smaller</source>
        <translation>tasa de compresión %1 más pequeño</translation>
    </message>
    <message>
        <source>%1: %2 cm at %3</source>
        <translation>%1: %2 cm a %3</translation>
    </message>
    <message>
        <source>Batch export</source>
        <translation>Exportación por lotes</translation>
    </message>
    <message>
        <source>Errors from 1 to 2 times the noticeable size are borderline, larger ones visible. Each clip is judged from the viewing distance that its verdict names, by %1. report.csv lists distance and own limits of each clip.</source>
        <translation>Un error de 1 a 2 veces el tamaño perceptible está en el límite; uno mayor es visible. Cada clip se juzga desde la distancia de observación que indica su veredicto, por %1. report.csv da la distancia y los límites propios de cada clip.</translation>
    </message>
    <message>
        <source>clips with visible errors</source>
        <translation>clips con errores visibles</translation>
    </message>
    <message>
        <source>clips with borderline errors</source>
        <translation>clips con errores en el límite</translation>
    </message>
    <message>
        <source>without visible errors</source>
        <translation>sin errores visibles</translation>
    </message>
    <message>
        <source>clips done, each read back and measured</source>
        <translation>clips terminados, cada uno leído de nuevo y medido</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fallidos</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>reviewed: %1 approved, %2 rejected</source>
        <translation>revisados: %1 aprobados, %2 rechazados</translation>
    </message>
    <message>
        <source>stale verdicts</source>
        <translation>veredictos caducados</translation>
    </message>
    <message>
        <source>still waiting</source>
        <translation>aún en espera</translation>
    </message>
    <message>
        <source>compression ratio of all clips together: %1 KB to %2 KB</source>
        <translation>tasa de compresión de todos los clips juntos: de %1 KB a %2 KB</translation>
    </message>
    <message>
        <source>largest error of any point at any frame; largest %1 %2 cm</source>
        <translation>mayor error de cualquier punto en cualquier fotograma; mayor %1: %2 cm</translation>
    </message>
    <message>
        <source>%1 over its original at its worst frame</source>
        <translation>%1 sobre su original en su peor fotograma</translation>
    </message>
    <message>
        <source>%1, %2 s: error of %3 cm at the %4.</source>
        <translation>%1, %2 s: error de %3 cm, %4.</translation>
    </message>
    <message>
        <source>The frame with the largest error of each of the clips whose errors are most visible: original in grey, compressed in red.</source>
        <translation>El fotograma con el mayor error de los clips cuyos errores más se ven: el original en gris, el comprimido en rojo.</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Fallidos</translation>
    </message>
    <message>
        <source>No file was written for these clips; older files of theirs are unchanged.</source>
        <translation>No se escribió ningún archivo de estos clips; sus archivos anteriores no cambian.</translation>
    </message>
    <message>
        <source>preset</source>
        <translation>preajuste</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>motivo</translation>
    </message>
    <message>
        <source>feet held</source>
        <translation>pies sujetos</translation>
    </message>
    <message>
        <source>Errors of the file as read back from the disk, against the original: distances in centimetres, rotation errors of joints, head and hands in degrees.</source>
        <translation>Errores del archivo leído de nuevo del disco frente al original: distancias en centímetros, errores de rotación de articulaciones, cabeza y manos en grados.</translation>
    </message>
    <message>
        <source>visibility</source>
        <translation>visibilidad</translation>
    </message>
    <message>
        <source>warnings</source>
        <translation>avisos</translation>
    </message>
    <message>
        <source>max</source>
        <translation>máx.</translation>
    </message>
    <message>
        <source>at frame</source>
        <translation>en el fotograma</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>articulaciones</translation>
    </message>
    <message>
        <source>head</source>
        <translation>cabeza</translation>
    </message>
    <message>
        <source>hands</source>
        <translation>manos</translation>
    </message>
    <message>
        <source>foot drift</source>
        <translation>deriva de los pies</translation>
    </message>
    <message>
        <source>worst drift</source>
        <translation>peor deriva</translation>
    </message>
    <message>
        <source>foot path</source>
        <translation>recorrido de los pies</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>fotogramas</translation>
    </message>
    <message>
        <source>asked</source>
        <translation>pedido</translation>
    </message>
    <message>
        <source>method</source>
        <translation>método</translation>
    </message>
    <message>
        <source>The charts show the %1 clips with the most visible errors, out of %2.</source>
        <translation>Los gráficos muestran los %1 clips con los errores más visibles, de %2.</translation>
    </message>
    <message>
        <source>Visible errors over time</source>
        <translation>Errores visibles a lo largo del tiempo</translation>
    </message>
    <message>
        <source>%1: visible errors over time</source>
        <translation>%1: errores visibles a lo largo del tiempo</translation>
    </message>
    <message>
        <source>Repaired or guessed on reading</source>
        <translation>Reparado o supuesto al leer</translation>
    </message>
    <message>
        <source>report.csv lists each warning with its file and line.</source>
        <translation>report.csv da cada aviso con su archivo y su línea.</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>aviso</translation>
    </message>
    <message>
        <source>count</source>
        <translation>cantidad</translation>
    </message>
    <message>
        <source>clips</source>
        <translation>clips</translation>
    </message>
    <message>
        <source>Verified</source>
        <translation>Verificado</translation>
    </message>
    <message>
        <source>Each file was read back and decoded as an engine would, by the runtime decoder within its default limits; errors are those of the decoded motion. Engines cannot play files in the paper&apos;s codings and of comparison methods: the library decodes these. The column verified_by of report.csv names the decoder of each clip.</source>
        <translation>Cada archivo se leyó de nuevo y se decodificó como lo haría un motor, con el decodificador de ejecución y sus límites por defecto; los errores son los del movimiento decodificado. Los motores no reproducen las codificaciones del artículo ni los métodos de comparación: esos archivos los decodifica la biblioteca. La columna verified_by de report.csv nombra el decodificador de cada clip.</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Tasa</translation>
    </message>
    <message>
        <source>Bytes of the channels as 32-bit floats, divided by the bytes of the coded motion. The skeleton counts on neither side. 1 KB = 1024 bytes.</source>
        <translation>Bytes de los canales como flotantes de 32 bits, divididos por los bytes del movimiento codificado. El esqueleto no cuenta en ningún lado. 1 KB = 1024 bytes.</translation>
    </message>
    <message>
        <source>Weighted root mean square distance between points of the body and the same points of the original. report.csv has it in two more weightings.</source>
        <translation>Distancia cuadrática media ponderada entre los puntos del cuerpo y los mismos puntos del original. report.csv la da en otras dos ponderaciones.</translation>
    </message>
    <message>
        <source>p95, p99, max</source>
        <translation>p95, p99, máx.</translation>
    </message>
    <message>
        <source>Percentiles and maximum of these distances over all points and frames, unweighted.</source>
        <translation>Percentiles y máximo de esas distancias en todos los puntos y fotogramas, sin ponderar.</translation>
    </message>
    <message>
        <source>Visibility</source>
        <translation>Visibilidad</translation>
    </message>
    <message>
        <source>Joints, head, hands</source>
        <translation>Articulaciones, cabeza, manos</translation>
    </message>
    <message>
        <source>Angle between a joint&apos;s world-space rotation and the original&apos;s, root mean square over frames and joints. Head and hands are recognised by their names.</source>
        <translation>Ángulo entre la rotación de una articulación en el mundo y la del original, media cuadrática de fotogramas y articulaciones. La cabeza y las manos se reconocen por sus nombres.</translation>
    </message>
    <message>
        <source>Foot drift, foot path</source>
        <translation>Deriva y recorrido de los pies</translation>
    </message>
    <message>
        <source>Both are measured while a foot stands in the original. Drift is the distance between a foot and its place in the original, as the mean over contacts and in the worst contact. Path is the length of the foot&apos;s path beyond the original&apos;s, summed over all contacts; a foot that trembles in place has a long path.</source>
        <translation>Ambos se miden mientras un pie está apoyado en el original. La deriva es la distancia entre un pie y su sitio en el original, en media de los contactos y en el peor contacto. El recorrido es lo que el pie se mueve más que el original, sumado en todos los contactos; un pie que tiembla en su sitio tiene un recorrido largo.</translation>
    </message>
    <message>
        <source>Verdict, note</source>
        <translation>Veredicto, nota</translation>
    </message>
    <message>
        <source>The reviewer&apos;s verdict and note, with name and date. A verdict is stale, and does not count, if the clip&apos;s file or its settings have changed since.</source>
        <translation>El veredicto y la nota de quien revisa, con nombre y fecha. Un veredicto ha caducado y no cuenta si el archivo del clip o sus ajustes han cambiado desde entonces.</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Avisos</translation>
    </message>
    <message>
        <source>Number of places that were repaired or guessed when the clip was read; they are listed above.</source>
        <translation>Número de lugares reparados o supuestos al leer el clip; figuran más arriba.</translation>
    </message>
    <message>
        <source>How clips were measured</source>
        <translation>Cómo se midieron los clips</translation>
    </message>
    <message>
        <source>any visibility</source>
        <translation>cualquier visibilidad</translation>
    </message>
    <message>
        <source>any verdict</source>
        <translation>cualquier veredicto</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>with warnings or without</source>
        <translation>con avisos o sin ellos</translation>
    </message>
    <message>
        <source>with warnings</source>
        <translation>con avisos</translation>
    </message>
    <message>
        <source>without warnings</source>
        <translation>sin avisos</translation>
    </message>
    <message>
        <source>max over, cm</source>
        <translation>máx. por encima de, cm</translation>
    </message>
    <message>
        <source>ratio below</source>
        <translation>tasa por debajo de</translation>
    </message>
    <message>
        <source>name, preset, reason ...</source>
        <translation>nombre, preajuste, motivo ...</translation>
    </message>
    <message>
        <source>show all</source>
        <translation>mostrar todos</translation>
    </message>
    <message>
        <source>%1 of %2 clips</source>
        <translation>%1 de %2 clips</translation>
    </message>
    <message>
        <source>%1 of %2 clips, the first %3 of them below</source>
        <translation>%1 de %2 clips, los primeros %3 a continuación</translation>
    </message>
    <message>
        <source>Compression study</source>
        <translation>Estudio de compresión</translation>
    </message>
    <message>
        <source>Clips: %1, methods: %2, compressions: %3. Error weighting: %4.</source>
        <translation>Clips: %1, métodos: %2, compresiones: %3. Ponderación del error: %4.</translation>
    </message>
    <message>
        <source>Error against compression ratio, averaged over the clips</source>
        <translation>Error según la tasa de compresión, en media de los clips</translation>
    </message>
    <message>
        <source>Error against compression ratio</source>
        <translation>Error según la tasa de compresión</translation>
    </message>
    <message>
        <source>%1: error against compression ratio</source>
        <translation>%1: error según la tasa de compresión</translation>
    </message>
    <message>
        <source>The paper</source>
        <translation>El artículo</translation>
    </message>
    <message>
        <source>The paper: %1</source>
        <translation>El artículo: %1</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 fotogramas</translation>
    </message>
    <message>
        <source>one clip</source>
        <translation>un clip</translation>
    </message>
    <message>
        <source>geometric mean of %1 clips</source>
        <translation>media geométrica de %1 clips</translation>
    </message>
    <message>
        <source>%1 at %2 = %3 cm, %4</source>
        <translation>%1 con %2 = %3 cm, %4</translation>
    </message>
    <message>
        <source> (the paper: about %1:1)</source>
        <translation> (el artículo: unos %1:1)</translation>
    </message>
    <message>
        <source>smaller than %1 at equal error</source>
        <translation>más pequeño que %1 con igual error</translation>
    </message>
    <message>
        <source>to compress a frame by %1, including the search for the target</source>
        <translation>para comprimir un fotograma con %1, incluida la búsqueda del objetivo</translation>
    </message>
    <message>
        <source>Use %1: it has the smallest files at %2 = %3 cm over all clips.</source>
        <translation>Use %1: sus archivos son los más pequeños con %2 = %3 cm en todos los clips.</translation>
    </message>
    <message>
        <source>Recommended method</source>
        <translation>Método recomendado</translation>
    </message>
    <message>
        <source>The presets use %1. The table shows the ratio at the error of each preset. Presets also bound the errors of heads, hands and roots, which costs some more bytes.</source>
        <translation>Los preajustes usan %1. La tabla da la tasa con el error de cada preajuste. Los preajustes también limitan los errores de cabezas, manos y raíces, lo que cuesta algunos bytes más.</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Preajuste</translation>
    </message>
    <message>
        <source>mean ratio</source>
        <translation>tasa media</translation>
    </message>
    <message>
        <source>wavelets by %1</source>
        <translation>ondículas por %1</translation>
    </message>
    <message>
        <source>no wavelets</source>
        <translation>sin ondículas</translation>
    </message>
    <message>
        <source>Bytes of the channels as 32-bit floats, divided by the bytes of the coded motion. The skeleton counts on neither side, as in the paper. 1 KB = 1024 bytes.</source>
        <translation>Bytes de los canales como flotantes de 32 bits, divididos por los bytes del movimiento codificado. El esqueleto no cuenta en ningún lado, como en el artículo. 1 KB = 1024 bytes.</translation>
    </message>
    <message>
        <source>The paper&apos;s positional distortion (section 3.1), weighted by %1: the weighted root mean square distance between points of the body and the same points of the original. The paper&apos;s own figures use the weighting %2.</source>
        <translation>La distorsión de posición del artículo (sección 3.1), ponderada por «%1»: la distancia cuadrática media ponderada entre los puntos del cuerpo y los mismos puntos del original. Las cifras del artículo usan la ponderación «%2».</translation>
    </message>
    <message>
        <source>Judged from %1 m, by %2.</source>
        <translation>Se juzga desde %1 m, por %2.</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>Geometric mean over the clips of the ratio at equal %1, at errors within the measured range of every clip. Ratios between measured points are interpolated, linearly in the logarithms of ratio and error, and marked %2.</source>
        <translation>Media geométrica de los clips de la tasa con igual %1, en errores dentro del rango medido de todos los clips. Entre los puntos medidos las tasas se interpolan, linealmente en los logaritmos de tasa y error, y se marcan con %2.</translation>
    </message>
    <message>
        <source>Coding</source>
        <translation>Codificación</translation>
    </message>
    <message>
        <source>%1, seed %2</source>
        <translation>%1, semilla %2</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Wall time of a compression, including the search for the target; compressions at the same time: up to %1. Work that the compressions of a clip share counts in the first of them. The paper used a 2 GHz Athlon 64.</source>
        <translation>Tiempo real de una compresión, incluida la búsqueda del objetivo; compresiones a la vez: hasta %1. El trabajo común a las compresiones de un clip cuenta en la primera. El artículo usó un Athlon 64 de 2 GHz.</translation>
    </message>
    <message>
        <source>Figures marked as the paper&apos;s are from Tables 1 and 2 of %1.</source>
        <translation>Las cifras del artículo son de las tablas 1 y 2 de %1.</translation>
    </message>
    <message>
        <source>These methods have no mean, since no error is within the range of all clips: %1.</source>
        <translation>Estos métodos no tienen media, porque ningún error está en el rango de todos los clips: %1.</translation>
    </message>
    <message>
        <source>Files are smaller to the right, errors smaller to the bottom. Curves are geometric means of the ratio at equal error. The dotted line is 0.5 cm: the paper saw no artifacts below it.</source>
        <translation>Los archivos son más pequeños hacia la derecha y los errores hacia abajo. Las curvas son medias geométricas de la tasa con igual error. La línea de puntos está en 0.5 cm: por debajo, el artículo no vio defectos.</translation>
    </message>
    <message>
        <source>Hollow marks are the paper&apos;s Table 1.</source>
        <translation>Las marcas huecas son de la tabla 1 del artículo.</translation>
    </message>
    <message>
        <source>frame %1, %2 s</source>
        <translation>fotograma %1, %2 s</translation>
    </message>
    <message>
        <source>%1 at %2: %3 %4 cm over the clip, largest error %5 cm; at this frame: %6.</source>
        <translation>%1 a %2: %3 %4 cm en el clip, error máximo %5 cm; en este fotograma: %6.</translation>
    </message>
    <message>
        <source>%1, %2 to %3</source>
        <translation>%1, %2 a %3</translation>
    </message>
    <message>
        <source>%1: foot that slides most</source>
        <translation>%1: pie que más se desliza</translation>
    </message>
    <message>
        <source>%1: %2 slides %3 cm while planted.</source>
        <translation>%1: %2 se desliza %3 cm estando apoyado.</translation>
    </message>
    <message>
        <source>%1 at %2:1</source>
        <translation>%1 a %2:1</translation>
    </message>
    <message>
        <source>Compressed motion in red over the original in grey, all at the same ratio. The first pictures show the frame with the largest error of %1: %2. Lines on the floor are half a metre apart.</source>
        <translation>El movimiento comprimido en rojo sobre el original en gris, todos con la misma tasa. Las primeras imágenes muestran el fotograma con el mayor error de %1: %2. Las líneas del suelo están a medio metro.</translation>
    </message>
    <message>
        <source>The foot that slides most</source>
        <translation>El pie que más se desliza</translation>
    </message>
    <message>
        <source>Path of the foot over the floor during one contact: original in grey, compressed dark.</source>
        <translation>Recorrido del pie por el suelo durante un contacto: original en gris, comprimido en oscuro.</translation>
    </message>
    <message>
        <source>Size at equal error</source>
        <translation>Tamaño con igual error</translation>
    </message>
    <message>
        <source>Time of the annealing</source>
        <translation>Tiempo del recocido</translation>
    </message>
    <message>
        <source>Feet held by inverse kinematics</source>
        <translation>Pies sujetos por cinemática inversa</translation>
    </message>
    <message>
        <source>Sliding feet</source>
        <translation>Pies que se deslizan</translation>
    </message>
    <message>
        <source>Rotation errors</source>
        <translation>Errores de rotación</translation>
    </message>
    <message>
        <source>Missed targets</source>
        <translation>Objetivos no alcanzados</translation>
    </message>
    <message>
        <source>drift %1</source>
        <translation>deriva %1</translation>
    </message>
    <message>
        <source>contacts</source>
        <translation>contactos</translation>
    </message>
    <message>
        <source>mean of a contact</source>
        <translation>media por contacto</translation>
    </message>
    <message>
        <source>At the paper&apos;s coefficient ratio r = %1</source>
        <translation>Con la razón de coeficientes del artículo r = %1</translation>
    </message>
    <message>
        <source>At the compression ratio %1:1</source>
        <translation>Con la tasa de compresión %1:1</translation>
    </message>
    <message>
        <source>KB (ratio)</source>
        <translation>KB (tasa)</translation>
    </message>
    <message>
        <source>paper</source>
        <translation>artículo</translation>
    </message>
    <message>
        <source>ms a frame</source>
        <translation>ms por fotograma</translation>
    </message>
    <message>
        <source>iterations</source>
        <translation>iteraciones</translation>
    </message>
    <message>
        <source>paper: ms</source>
        <translation>artículo: ms</translation>
    </message>
    <message>
        <source>Horizontal path of the feet during contacts, beyond the original&apos;s; in brackets the mean contact and the worst contact. Contacts are detected in the original; clips without contacts are not listed.</source>
        <translation>Recorrido horizontal de los pies durante los contactos, más allá del original; entre paréntesis, el contacto medio y el peor. Los contactos se detectan en el original; no figuran los clips sin contactos.</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>segundos</translation>
    </message>
    <message>
        <source>Compression ratio at %1.</source>
        <translation>Tasa de compresión con %1.</translation>
    </message>
    <message>
        <source>Angle between a joint&apos;s world-space rotation and the original&apos;s, root mean square over frames and joints; in brackets that of the head and of the worse hand, if they are recognised by their names. Measured at %1.</source>
        <translation>Ángulo entre la rotación de una articulación en el mundo y la del original, media cuadrática de fotogramas y articulaciones; entre paréntesis, el de la cabeza y el de la peor mano, si se reconocen por sus nombres. Medido con %1.</translation>
    </message>
    <message>
        <source>%1 (cm) without, with IK</source>
        <translation>%1 (cm) sin IK, con IK</translation>
    </message>
    <message>
        <source>footskate (cm) without, with IK</source>
        <translation>deslizamiento (cm) sin IK, con IK</translation>
    </message>
    <message>
        <source>without</source>
        <translation>sin</translation>
    </message>
    <message>
        <source>with</source>
        <translation>con</translation>
    </message>
    <message>
        <source>knee</source>
        <translation>rodilla</translation>
    </message>
    <message>
        <source>Clips with and without IK have the same compression ratio, so bytes of the correction are missing elsewhere. Knee: its highest speed, divided by that of the original.</source>
        <translation>Los clips con IK y sin IK tienen la misma tasa de compresión, así que los bytes de la corrección faltan en otra parte. Rodilla: su mayor velocidad, dividida por la del original.</translation>
    </message>
    <message>
        <source>every method</source>
        <translation>todos los métodos</translation>
    </message>
    <message>
        <source>%1 gave %2</source>
        <translation>%1 dio %2</translation>
    </message>
    <message>
        <source>%1 combinations of clip and method missed a target</source>
        <translation>%1 combinaciones de clip y método no alcanzaron un objetivo</translation>
    </message>
    <message>
        <source>missed target</source>
        <translation>objetivo no alcanzado</translation>
    </message>
    <message>
        <source>first reason</source>
        <translation>primer motivo</translation>
    </message>
    <message>
        <source>nearest result</source>
        <translation>resultado más cercano</translation>
    </message>
    <message>
        <source>Cubic wavelets, coefficients moved between channels by annealing: the paper&apos;s Algorithm 1, candidates compared by a quadratic error model.</source>
        <translation>Ondículas cúbicas, coeficientes movidos entre canales por recocido: el algoritmo 1 del artículo, con candidatos comparados por un modelo cuadrático del error.</translation>
    </message>
    <message>
        <source>Cubic wavelets, the largest coefficients of all channels, angles scaled by the length of the bone: the paper&apos;s section 4.</source>
        <translation>Ondículas cúbicas, los mayores coeficientes de todos los canales, ángulos multiplicados por la longitud del hueso: sección 4 del artículo.</translation>
    </message>
    <message>
        <source>Cubic wavelets, the largest coefficients of each channel, equally many: the paper&apos;s first approach in section 4.</source>
        <translation>Ondículas cúbicas, los mayores coeficientes de cada canal, en igual número: primer enfoque del artículo, sección 4.</translation>
    </message>
    <message>
        <source>Standard selection in the Haar basis, with which Arikan (2006) compared.</source>
        <translation>Selección estándar en la base de Haar, con la que comparó Arikan (2006).</translation>
    </message>
    <message>
        <source>Standard selection in the interpolating linear basis.</source>
        <translation>Selección estándar en la base lineal interpolante.</translation>
    </message>
    <message>
        <source>Cubic wavelets, each coefficient quantised by what its step does to the error in the world, channels making good what others lost; adaptive coding.</source>
        <translation>Ondículas cúbicas, cada coeficiente cuantificado según lo que su paso hace al error en el mundo, con canales que compensan lo que otros perdieron; codificación adaptativa.</translation>
    </message>
    <message>
        <source>Our reading of Arikan (2006): clustered PCA of short Bezier curves of virtual markers, the database being the clip alone; k-means clusters, DEFLATE, and no special care of the feet.</source>
        <translation>Nuestra lectura de Arikan (2006): PCA por grupos de curvas de Bézier cortas de marcadores virtuales, con el clip solo como base de datos; grupos por k-medias, DEFLATE y sin cuidado especial de los pies.</translation>
    </message>
    <message>
        <source>What engines do: each channel by itself, key frames left out where a line comes within the tolerance, steps as fine as the channel needs (as ACL&apos;s bit rates), DEFLATE.</source>
        <translation>Lo que hacen los motores: cada canal por sí solo, fotogramas clave omitidos donde una recta queda dentro de la tolerancia, pasos tan finos como el canal necesita (como las tasas de bits de ACL), DEFLATE.</translation>
    </message>
    <message>
        <source>Our reading of Liu and McMillan (2006): PCA of segments, adaptive key frames with cubic splines; on channels weighted by what they move, not on markers, and with no special care of the feet.</source>
        <translation>Nuestra lectura de Liu y McMillan (2006): PCA por segmentos, fotogramas clave adaptativos con splines cúbicos; sobre canales ponderados por lo que mueven y no sobre marcadores, sin cuidado especial de los pies.</translation>
    </message>
    <message>
        <source>Principal components of the poses without the root&apos;s position, everything in 16 bits, DEFLATE: the paper&apos;s section 3.2.</source>
        <translation>Componentes principales de las poses sin la posición de la raíz, todo en 16 bits, DEFLATE: sección 3.2 del artículo.</translation>
    </message>
    <message>
        <source>Cubic wavelets on unit quaternions, coefficients moved between components by annealing on the linearised rotation: the paper&apos;s section 6.3.</source>
        <translation>Ondículas cúbicas sobre cuaterniones unitarios, coeficientes movidos entre componentes por recocido sobre la rotación linealizada: sección 6.3 del artículo.</translation>
    </message>
    <message>
        <source>Every s-th frame in 16 bits, DEFLATE; natural cubic splines between.</source>
        <translation>Un fotograma de cada s en 16 bits, DEFLATE; splines cúbicos naturales entre ellos.</translation>
    </message>
</context>
<context>
    <name>mocapress::ResultPanel</name>
    <message>
        <source>%L1 / %L2 °/s</source>
        <translation>%L1 / %L2 °/s</translation>
    </message>
    <message>
        <source>compression ratio</source>
        <translation>tasa de compresión</translation>
    </message>
    <message>
        <source>Bytes of the channels as 32-bit floats, divided by the compressed motion bytes. The skeleton counts in neither, as in the paper.</source>
        <translation>Bytes de los canales como flotantes de 32 bits, divididos por los bytes comprimidos del movimiento. El esqueleto no cuenta en ninguno, como en el artículo.</translation>
    </message>
    <message>
        <source>eps_x</source>
        <translation>eps_x</translation>
    </message>
    <message>
        <source>Root mean square distance between original and compressed, weighted by bone length.</source>
        <translation>Distancia cuadrática media entre original y comprimido, ponderada por la longitud de los huesos.</translation>
    </message>
    <message>
        <source>State of the result</source>
        <translation>Estado del resultado</translation>
    </message>
    <message>
        <source>95 % of points within</source>
        <translation>95 % de los puntos a menos de</translation>
    </message>
    <message>
        <source>95th percentile of the distance over all joints and frames, unweighted.</source>
        <translation>Percentil 95 de la distancia en todas las articulaciones y fotogramas, sin ponderar.</translation>
    </message>
    <message>
        <source>99 % of points within</source>
        <translation>99 % de los puntos a menos de</translation>
    </message>
    <message>
        <source>99th percentile of the distance over all joints and frames, unweighted.</source>
        <translation>Percentil 99 de la distancia en todas las articulaciones y fotogramas, sin ponderar.</translation>
    </message>
    <message>
        <source>Worst point</source>
        <translation>Peor punto</translation>
    </message>
    <message>
        <source>Largest error of any point at any frame.</source>
        <translation>Mayor error de cualquier punto en cualquier fotograma.</translation>
    </message>
    <message>
        <source>Motion / file</source>
        <translation>Movimiento / archivo</translation>
    </message>
    <message>
        <source>Compressed motion bytes, and bytes of the whole file with its skeleton.</source>
        <translation>Bytes comprimidos del movimiento, y bytes del archivo entero con su esqueleto.</translation>
    </message>
    <message>
        <source>Coefficient ratio</source>
        <translation>Tasa de coeficientes</translation>
    </message>
    <message>
        <source>The paper&apos;s r: all wavelet coefficients over those that are kept.</source>
        <translation>La r del artículo: todos los coeficientes de ondículas frente a los que se conservan.</translation>
    </message>
    <message>
        <source>Bits per joint-sample</source>
        <translation>Bits por muestra</translation>
    </message>
    <message>
        <source>Motion bits for one joint at one frame; unlike a ratio it needs no baseline.</source>
        <translation>Bits de movimiento para una articulación en un fotograma; a diferencia de una tasa, no necesita referencia.</translation>
    </message>
    <message>
        <source>IK signals</source>
        <translation>Señales IK</translation>
    </message>
    <message>
        <source>Motion bytes of the correction that holds the feet, and its ratio r_IK.</source>
        <translation>Bytes de movimiento de la corrección que sujeta los pies, y su tasa r_IK.</translation>
    </message>
    <message>
        <source>Fastest knee</source>
        <translation>Rodilla más rápida</translation>
    </message>
    <message>
        <source>Highest speed of a held leg&apos;s knee, and that of the original. A much higher speed means that the correction makes the knee snap.</source>
        <translation>Mayor velocidad de la rodilla de una pierna sujeta, y la del original. Una velocidad mucho mayor significa que la corrección da un tirón a la rodilla.</translation>
    </message>
    <message>
        <source>eps_x, %1</source>
        <translation>eps_x, %1</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <comment>bytes</comment>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <comment>footskate</comment>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Visibility</source>
        <translation>Visibilidad</translation>
    </message>
    <message>
        <source>The most visible error, beside the size that people notice.</source>
        <translation>El error más visible, junto al tamaño que la gente nota.</translation>
    </message>
    <message>
        <source>Loop: seam</source>
        <translation>Bucle: unión</translation>
    </message>
    <message>
        <source>First / last pose</source>
        <translation>Primera / última pose</translation>
    </message>
    <message>
        <source>Change of the errors of pose and velocity from the last frame to the first: the jump where the loop starts again.</source>
        <translation>Cambio de los errores de pose y velocidad del último fotograma al primero: el salto donde el bucle vuelve a empezar.</translation>
    </message>
    <message>
        <source>RMS error of the first and the last pose on the body&apos;s surface. Clips are blended there.</source>
        <translation>Error RMS de la primera y la última pose en la superficie del cuerpo. Ahí se mezclan los clips.</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <comment>poses</comment>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Loop: elsewhere</source>
        <translation>Bucle: resto</translation>
    </message>
    <message>
        <source>The largest change of errors between two neighbouring frames. A smaller one at the seam does not stand out.</source>
        <translation>El mayor cambio de errores entre dos fotogramas vecinos. Uno menor en la unión no llama la atención.</translation>
    </message>
    <message>
        <source>%1, %2/frame</source>
        <translation>%1, %2/fotograma</translation>
    </message>
    <message>
        <source>On the skin: worst / RMS</source>
        <translation>En la piel: peor / RMS</translation>
    </message>
    <message>
        <source>Errors of points spread evenly over the mesh, over all frames.</source>
        <translation>Errores de puntos repartidos por igual sobre la malla, en todos los fotogramas.</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <comment>skin</comment>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>≈ %1</source>
        <translation>≈ %1</translation>
    </message>
    <message>
        <source>Foot drift: mean / worst</source>
        <translation>Deriva del pie: media / peor</translation>
    </message>
    <message>
        <source>Distance between a standing foot and its place in the original, over all contacts.</source>
        <translation>Distancia entre un pie apoyado y su lugar en el original, en todos los contactos.</translation>
    </message>
    <message>
        <source>Foot path: all / worst</source>
        <translation>Recorrido del pie: total / peor</translation>
    </message>
    <message>
        <source>Path of the feet over the ground while they stand, beyond the original&apos;s: sum over the clip, and worst contact. A foot that trembles in place has a long path.</source>
        <translation>Recorrido de los pies por el suelo mientras se apoyan, más allá del original: suma de todo el clip y peor contacto. Un pie que tiembla en su sitio tiene un recorrido largo.</translation>
    </message>
    <message>
        <source>%1, %2 at %L3 s: %L4 times the noticeable error; not noticed beyond %L5 m</source>
        <translation>%1, %2 a los %L3 s: %L4 veces el error perceptible; no se nota a más de %L5 m</translation>
    </message>
    <message>
        <source>Most visible error</source>
        <translation>Error más visible</translation>
    </message>
    <message>
        <source>All figures</source>
        <translation>Todas las cifras</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>mocapress::ReviewBar</name>
    <message>
        <source>Open the next clip that waits for a verdict (Q)</source>
        <translation>Abrir el siguiente clip que espera un veredicto (Q)</translation>
    </message>
    <message>
        <source>Next to review</source>
        <translation>Siguiente por revisar</translation>
    </message>
    <message>
        <source>Clips that are reviewed</source>
        <translation>Clips revisados</translation>
    </message>
    <message>
        <source>%L1 of %L2 reviewed</source>
        <translation>%L1 de %L2 revisados</translation>
    </message>
    <message>
        <source>%1, %L2 rejected</source>
        <translation>%1, %L2 rechazados</translation>
    </message>
</context>
<context>
    <name>mocapress::Sentence</name>
    <message>
        <source>%1 not finite or beyond 1e9, replaced by the frame before</source>
        <translation>%1 no finitos o de más de 1e9, reemplazados por los del fotograma anterior</translation>
    </message>
    <message>
        <source>%1 with the name of another joint, numbered: Name.2</source>
        <translation>%1 con el nombre de otra, numeradas: Nombre.2</translation>
    </message>
    <message>
        <source>%1 with the name of another joint</source>
        <translation>%1 con el nombre de otra</translation>
    </message>
    <message>
        <source>the file ends within its last frame, which is dropped</source>
        <translation>el archivo termina en medio de su último fotograma, que se descarta</translation>
    </message>
    <message>
        <source>keys lie unevenly: %1 of %2 frames carry keys; frames between are interpolated</source>
        <translation>las claves son irregulares: %1 de %2 fotogramas llevan claves; los intermedios se interpolan</translation>
    </message>
    <message>
        <source>take %1 is read; there are also %2</source>
        <translation>se lee la toma %1; también hay %2</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 y %2 más</translation>
    </message>
    <message>
        <source>looks like an additive clip, near its rest pose with the root at the origin: errors are those that it makes on that pose, and where feet stand means nothing</source>
        <translation>parece un clip aditivo, cerca de su pose de reposo con la raíz en el origen: los errores son los que produce sobre esa pose, y los apoyos de los pies no significan nada</translation>
    </message>
    <message>
        <source>no bone has a length: errors are measured on three points 3 cm from each joint</source>
        <translation>ningún hueso tiene longitud: los errores se miden en tres puntos a 3 cm de cada articulación</translation>
    </message>
    <message>
        <source>the mesh reaches much further than the bones at %1, first %2 (%3 cm, not %4): the surface there is the mesh</source>
        <translation>la malla sobresale mucho de los huesos en %1, la primera %2 (%3 cm en vez de %4): ahí la superficie es la malla</translation>
    </message>
    <message>
        <source>the figure stands along Z, but Y is taken to point up: --up z, or the import options of the studio, read it upright</source>
        <translation>la figura está de pie según Z, pero se toma Y como vertical: --up z, o las opciones de importación de Studio, la leen derecha</translation>
    </message>
    <message>
        <source>%1 beside other children left out</source>
        <translation>se excluye %1 junto a otros hijos</translation>
    </message>
    <message>
        <source>the header says %1 frames, %2 follow: all of them are read</source>
        <translation>la cabecera dice %1 fotogramas, siguen %2: se leen todos</translation>
    </message>
    <message>
        <source>%1 of scale kept as tracks, which move no joint</source>
        <translation>%1 de escala conservados como pistas, que no mueven ninguna articulación</translation>
    </message>
    <message>
        <source>a Frame Time of %1 s cannot be right: taken as %2 frames per second</source>
        <translation>un Frame Time de %1 s no puede ser correcto: se toma como %2 fotogramas por segundo</translation>
    </message>
    <message>
        <source>translation channels of the root are taken to replace OFFSET, as their values suggest</source>
        <translation>se supone que los canales de traslación de la raíz reemplazan OFFSET, como sugieren sus valores</translation>
    </message>
    <message>
        <source>translation channels of the joints below the root are taken to replace OFFSET, as their values suggest</source>
        <translation>se supone que los canales de traslación de las articulaciones bajo la raíz reemplazan OFFSET, como sugieren sus valores</translation>
    </message>
    <message>
        <source>translation channels of the root are taken to replace OFFSET, as Blender and MotionBuilder do: their values do not tell</source>
        <translation>se supone que los canales de traslación de la raíz reemplazan OFFSET, como hacen Blender y MotionBuilder: sus valores no lo dicen</translation>
    </message>
    <message>
        <source>translation channels of the joints below the root are taken to replace OFFSET, as Blender and MotionBuilder do: their values do not tell</source>
        <translation>se supone que los canales de traslación de las articulaciones bajo la raíz reemplazan OFFSET, como hacen Blender y MotionBuilder: sus valores no lo dicen</translation>
    </message>
    <message>
        <source>no unit of length is given: a rest pose %1 units tall is taken to have %2 cm to the unit</source>
        <translation>no se da una unidad de longitud: para una pose de reposo de %1 unidades de alto se toman %2 cm por unidad</translation>
    </message>
    <message>
        <source>frame numbers do not run 1, 2, 3 from here: frames are taken as they come</source>
        <translation>los números de fotograma no siguen 1, 2, 3 desde aquí: los fotogramas se toman como vienen</translation>
    </message>
    <message>
        <source>%1 missing from a frame, where the frame before is repeated</source>
        <translation>%1 ausente en un fotograma, donde se repite el anterior</translation>
    </message>
    <message>
        <source>%1 with three values where the skeleton names fewer, read as its dof and the axes missing from it</source>
        <translation>%1 con tres valores donde el esqueleto nombra menos, leídos como sus dof y los ejes que faltan</translation>
    </message>
    <message>
        <source>%1 with three values where the skeleton names fewer, read as rx ry rz</source>
        <translation>%1 con tres valores donde el esqueleto nombra menos, leídos como rx ry rz</translation>
    </message>
    <message>
        <source>%1 with dof but without values, left at rest</source>
        <translation>%1 con dof pero sin valores, en reposo</translation>
    </message>
    <message>
        <source>%1 with a length that changes (dof l), which is ignored</source>
        <translation>%1 con una longitud que cambia (dof l), que se ignora</translation>
    </message>
    <message>
        <source>%1 whose scale changes over time: joints are in their places, those of joints are kept as tracks, but errors are measured on a skin with the scales of the first frame</source>
        <translation>%1 cuya escala cambia con el tiempo: las articulaciones están en su sitio y sus escalas se conservan como pistas, pero los errores se miden sobre una piel con las escalas del primer fotograma</translation>
    </message>
    <message>
        <source>%1 scaled unevenly, first %2: joints are in their places, but a skin has the scales of the first frame</source>
        <translation>%1 con escala desigual, primero %2: las articulaciones están en su sitio, pero la piel tiene las escalas del primer fotograma</translation>
    </message>
    <message>
        <source>%1 of the animation left out, which moves no node</source>
        <translation>se excluye %1 de la animación, que no mueve ningún nodo</translation>
    </message>
    <message>
        <source>%1 of the animation left out, which move no node</source>
        <translation>se excluyen %1 de la animación, que no mueven ningún nodo</translation>
    </message>
    <message>
        <source>morph weights are not read: the file %1</source>
        <translation>no se leen los pesos de morph: el archivo %1</translation>
    </message>
    <message>
        <source>its character is not read: %1</source>
        <translation>no se lee su personaje: %1</translation>
    </message>
    <message>
        <source>the picture %1 is not shown: %2</source>
        <translation>no se muestra la imagen %1: %2</translation>
    </message>
    <message>
        <source>it is not beside the file</source>
        <translation>no está junto al archivo</translation>
    </message>
    <message>
        <source>it is neither PNG nor JPEG</source>
        <translation>no es PNG ni JPEG</translation>
    </message>
    <message>
        <source>it has more than 64 MiB</source>
        <translation>tiene más de 64 MiB</translation>
    </message>
    <message>
        <source>it has more than %1 bones</source>
        <translation>tiene más de %1 huesos</translation>
    </message>
    <message>
        <source>it has too many vertices</source>
        <translation>tiene demasiados vértices</translation>
    </message>
    <message>
        <source>a vertex is not finite, or farther than 1e9 cm away</source>
        <translation>un vértice no es finito, o está a más de 1e9 cm</translation>
    </message>
    <message>
        <source>the first take, %1, stands still</source>
        <translation>la primera toma, %1, está quieta</translation>
    </message>
    <message>
        <source>%1 left out: not a finite number</source>
        <translation>%1 sin leer: no es un número finito</translation>
    </message>
    <message>
        <source>%1 stated again: each counts once</source>
        <translation>%1 repetidas en el archivo: cada una cuenta una vez</translation>
    </message>
    <message>
        <source>%1 with spheric XYZ angles, which are read as XYZ angles</source>
        <translation>%1 con ángulos XYZ esféricos, que se leen como ángulos XYZ</translation>
    </message>
    <message>
        <source>%1 of weights or properties left out: too many, too long a name, or beyond 1e9</source>
        <translation>%1 de pesos o propiedades sin leer: demasiados, con un nombre demasiado largo, o de más de 1e9</translation>
    </message>
    <message>
        <source>the clip has no joint %1, nor %2 more: what hangs there stays in its bind pose</source>
        <translation>el clip no tiene la articulación %1, ni otras %2: lo que cuelga de ellas queda en su pose de enlace</translation>
    </message>
    <message>
        <source>the clip has no joint %1: what hangs there stays in its bind pose</source>
        <translation>el clip no tiene la articulación %1: lo que cuelga de ella queda en su pose de enlace</translation>
    </message>
    <message>
        <source>the clip has no joint %1, nor %2 more: they carry most of the character</source>
        <translation>el clip no tiene la articulación %1, ni otras %2: sostienen la mayor parte del personaje</translation>
    </message>
    <message>
        <source>the clip has no joint %1: they carry most of the character</source>
        <translation>el clip no tiene la articulación %1: sostiene la mayor parte del personaje</translation>
    </message>
    <message>
        <source>has other proportions than the clip, and legs of %1 % the length: it is shown and coloured with its own bones, and figures are measured on the clip&apos;s</source>
        <translation>tiene otras proporciones que el clip, y piernas al %1 % de longitud: se muestra y se colorea con sus propios huesos, y las cifras se miden sobre los del clip</translation>
    </message>
    <message>
        <source>is not put on: %1</source>
        <translation>no se pone: %1</translation>
    </message>
    <message>
        <source>cannot be put on: %1</source>
        <translation>no se puede poner: %1</translation>
    </message>
    <message>
        <source>has no mesh that hangs on joints</source>
        <translation>no tiene ninguna malla unida a articulaciones</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>No existe el archivo o la carpeta</translation>
    </message>
    <message>
        <source>is a folder, not a file</source>
        <translation>es una carpeta, no un archivo</translation>
    </message>
    <message>
        <source>is a pipe or a device, not a file</source>
        <translation>es una tubería o un dispositivo, no un archivo</translation>
    </message>
    <message>
        <source>cannot be read to its end</source>
        <translation>no se puede leer hasta el final</translation>
    </message>
    <message>
        <source>is a pointer of Git LFS, not the file itself: &apos;git lfs pull&apos; fetches that</source>
        <translation>es un puntero de Git LFS, no el archivo mismo: «git lfs pull» lo descarga</translation>
    </message>
    <message>
        <source>is none of %1</source>
        <translation>no es ninguno de %1</translation>
    </message>
    <message>
        <source>holds none of %1</source>
        <translation>no contiene ninguno de %1</translation>
    </message>
    <message>
        <source>is a link that leads nowhere</source>
        <translation>es un enlace que no lleva a ninguna parte</translation>
    </message>
    <message>
        <source>is a skeleton without motion: open one of its .amc files</source>
        <translation>es un esqueleto sin movimiento: abra uno de sus archivos .amc</translation>
    </message>
    <message>
        <source>holds no animation, but may be put on a clip as its character</source>
        <translation>no contiene ninguna animación, pero puede ponerse a un clip como su personaje</translation>
    </message>
    <message>
        <source>has no take %1: there are %2</source>
        <translation>no tiene la toma %1: hay %2</translation>
    </message>
    <message>
        <source>has neither bones nor anything else that moves</source>
        <translation>no tiene huesos ni nada que se mueva</translation>
    </message>
    <message>
        <source>no joint moves or is turned</source>
        <translation>ninguna articulación se mueve ni gira</translation>
    </message>
    <message>
        <source>needs more than %1 frames</source>
        <translation>necesita más de %1 fotogramas</translation>
    </message>
    <message>
        <source>needs more than %1 samples</source>
        <translation>necesita más de %1 muestras</translation>
    </message>
    <message>
        <source>joints are nested deeper than %1</source>
        <translation>las articulaciones están anidadas a más de %1 niveles</translation>
    </message>
    <message>
        <source>more than %1 joints</source>
        <translation>más de %1 articulaciones</translation>
    </message>
    <message>
        <source>the name of a joint has more than %1 bytes</source>
        <translation>el nombre de una articulación tiene más de %1 bytes</translation>
    </message>
    <message>
        <source>%1 has a transform that is not finite, or beyond 1e9</source>
        <translation>%1 tiene una transformación no finita, o de más de 1e9</translation>
    </message>
    <message>
        <source>%1 is farther than 1e9 cm away</source>
        <translation>%1 está a más de 1e9 cm</translation>
    </message>
    <message>
        <source>has a JSON value of another type than its place asks for</source>
        <translation>tiene un valor JSON de otro tipo que el que pide su lugar</translation>
    </message>
    <message>
        <source>cannot be read: a library that reads its parts failed</source>
        <translation>no se puede leer: falló una biblioteca que lee sus partes</translation>
    </message>
    <message>
        <source>expected one sample per second or more, found %1</source>
        <translation>se esperaba al menos una muestra por segundo, se encontró %1</translation>
    </message>
    <message>
        <source>expected a new line after the %1 values of the frame that begins in line %2, found %3</source>
        <translation>se esperaba una línea nueva tras los %1 valores del fotograma que empieza en la línea %2, se encontró %3</translation>
    </message>
    <message>
        <source>expected %1 values for %2, found %3</source>
        <translation>se esperaban %1 valores para %2, se encontró %3</translation>
    </message>
    <message>
        <source>expected a bone of %1, found %2</source>
        <translation>se esperaba un hueso de %1, se encontró %2</translation>
    </message>
    <message>
        <source>expected a positive unit of length, found %1</source>
        <translation>se esperaba una unidad de longitud positiva, se encontró %1</translation>
    </message>
    <message>
        <source>expected a complete frame, found none</source>
        <translation>se esperaba un fotograma completo, no se encontró ninguno</translation>
    </message>
    <message>
        <source>expected a name after &apos;name&apos;</source>
        <translation>se esperaba un nombre después de «name»</translation>
    </message>
    <message>
        <source>expected %1, found %2</source>
        <translation>se esperaba %1, se encontró %2</translation>
    </message>
    <message>
        <source>%1 channels such as Xposition or Zrotation</source>
        <translation>%1 canales como Xposition o Zrotation</translation>
    </message>
    <message>
        <source>a frame number</source>
        <translation>un número de fotograma</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nada</translation>
    </message>
    <message>
        <source>samples per second</source>
        <translation>muestras por segundo</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>el final del archivo</translation>
    </message>
    <message>
        <source>the number of frames</source>
        <translation>el número de fotogramas</translation>
    </message>
    <message>
        <source>the number of channels</source>
        <translation>el número de canales</translation>
    </message>
    <message>
        <source>the time of a frame in seconds</source>
        <translation>la duración de un fotograma en segundos</translation>
    </message>
    <message>
        <source>the name of the joint</source>
        <translation>el nombre de la articulación</translation>
    </message>
    <message>
        <source>the name of a bone</source>
        <translation>el nombre de un hueso</translation>
    </message>
    <message>
        <source>a coordinate of OFFSET</source>
        <translation>una coordenada de OFFSET</translation>
    </message>
    <message>
        <source>a coordinate of direction</source>
        <translation>una coordenada de direction</translation>
    </message>
    <message>
        <source>a coordinate of position</source>
        <translation>una coordenada de position</translation>
    </message>
    <message>
        <source>an angle of axis</source>
        <translation>un ángulo de axis</translation>
    </message>
    <message>
        <source>an angle of orientation</source>
        <translation>un ángulo de orientation</translation>
    </message>
    <message>
        <source>an order of axes such as XYZ</source>
        <translation>un orden de ejes como XYZ</translation>
    </message>
    <message>
        <source>the length of the bone</source>
        <translation>la longitud del hueso</translation>
    </message>
    <message>
        <source>the unit of length</source>
        <translation>la unidad de longitud</translation>
    </message>
    <message>
        <source>the end of the bone</source>
        <translation>el final del hueso</translation>
    </message>
    <message>
        <source>the end of the hierarchy</source>
        <translation>el final de la jerarquía</translation>
    </message>
    <message>
        <source>a section such as :units or :bonedata</source>
        <translation>una sección como :units o :bonedata</translation>
    </message>
    <message>
        <source>OFFSET, CHANNELS, JOINT, End Site or }</source>
        <translation>OFFSET, CHANNELS, JOINT, End Site o }</translation>
    </message>
    <message>
        <source>OFFSET or the } of the End Site</source>
        <translation>OFFSET o la } del End Site</translation>
    </message>
    <message>
        <source>deg or rad</source>
        <translation>deg o rad</translation>
    </message>
    <message>
        <source>tx, ty, tz, rx, ry, rz or l</source>
        <translation>tx, ty, tz, rx, ry, rz o l</translation>
    </message>
    <message>
        <source>numbers have a decimal comma, such as %1: a decimal point is read</source>
        <translation>los números llevan coma decimal, como %1: se lee un punto decimal</translation>
    </message>
    <message>
        <source>is UTF-16: save it as UTF-8 to have it read</source>
        <translation>es UTF-16: guárdelo como UTF-8 para que se lea</translation>
    </message>
    <message>
        <source>no joint has a channel: nothing moves</source>
        <translation>ninguna articulación tiene un canal: nada se mueve</translation>
    </message>
    <message>
        <source>no complete frame follows</source>
        <translation>no sigue ningún fotograma completo</translation>
    </message>
    <message>
        <source>a second CHANNELS line for one joint</source>
        <translation>una segunda línea CHANNELS para una articulación</translation>
    </message>
    <message>
        <source>channel %1 twice in one joint</source>
        <translation>canal %1 dos veces en una articulación</translation>
    </message>
    <message>
        <source>more than %1 channels of scale that change</source>
        <translation>más de %1 canales de escala que cambian</translation>
    </message>
    <message>
        <source>the file ends within its first frame</source>
        <translation>el archivo termina en medio de su primer fotograma</translation>
    </message>
    <message>
        <source>no bone has a value: nothing moves</source>
        <translation>ningún hueso tiene un valor: nada se mueve</translation>
    </message>
    <message>
        <source>frame %1 has only %2 bones</source>
        <translation>el fotograma %1 solo tiene %2 huesos</translation>
    </message>
    <message>
        <source>%1 is not in the first frame</source>
        <translation>%1 no está en el primer fotograma</translation>
    </message>
    <message>
        <source>%1 twice in one frame</source>
        <translation>%1 dos veces en un fotograma</translation>
    </message>
    <message>
        <source>%1 twice in one bone</source>
        <translation>%1 dos veces en un hueso</translation>
    </message>
    <message>
        <source>more than %1 bones</source>
        <translation>más de %1 huesos</translation>
    </message>
    <message>
        <source>this bone has no name</source>
        <translation>este hueso no tiene nombre</translation>
    </message>
    <message>
        <source>bone %1 lacks its direction or length</source>
        <translation>al hueso %1 le falta su dirección o su longitud</translation>
    </message>
    <message>
        <source>bone %1 is nested deeper than %2</source>
        <translation>el hueso %1 está anidado a más de %2 niveles</translation>
    </message>
    <message>
        <source>bone %1 does not hang from the root in :hierarchy</source>
        <translation>el hueso %1 no cuelga de la raíz en :hierarchy</translation>
    </message>
    <message>
        <source>the name of a bone has more than %1 bytes</source>
        <translation>el nombre de un hueso tiene más de %1 bytes</translation>
    </message>
    <message>
        <source>a second bone named %1</source>
        <translation>un segundo hueso llamado %1</translation>
    </message>
    <message>
        <source>a second parent for %1</source>
        <translation>un segundo padre para %1</translation>
    </message>
    <message>
        <source>has no line of names</source>
        <translation>no tiene línea de nombres</translation>
    </message>
    <message>
        <source>a column needs a name of 1 to 255 bytes</source>
        <translation>una columna necesita un nombre de 1 a 255 bytes</translation>
    </message>
    <message>
        <source>a name of a column has no quotes</source>
        <translation>el nombre de una columna no lleva comillas</translation>
    </message>
    <message>
        <source>two columns are called %1</source>
        <translation>dos columnas se llaman %1</translation>
    </message>
    <message>
        <source>is one more than the clip&apos;s %1</source>
        <translation>es una más que %1 del clip</translation>
    </message>
    <message>
        <source>ends after values of %1, the clip has %2</source>
        <translation>termina tras los valores de %1, el clip tiene %2</translation>
    </message>
    <message>
        <source>is compressed by EXT_meshopt_compression, which this program cannot read: it was built without libmeshoptimizer</source>
        <translation>está comprimido con EXT_meshopt_compression, que este programa no puede leer: se compiló sin libmeshoptimizer</translation>
    </message>
    <message>
        <source>is compressed by KHR_draco_mesh_compression, which this program cannot read: it was built without libdraco</source>
        <translation>está comprimido con KHR_draco_mesh_compression, que este programa no puede leer: se compiló sin libdraco</translation>
    </message>
    <message>
        <source>is not what %1 makes</source>
        <translation>no es lo que produce %1</translation>
    </message>
    <message>
        <source>is too large to read</source>
        <translation>es demasiado grande para leerlo</translation>
    </message>
    <message>
        <source>bufferView %1 %2</source>
        <translation>la bufferView %1 %2</translation>
    </message>
    <message>
        <source>has a mesh that %1</source>
        <translation>tiene una malla que %1</translation>
    </message>
    <message>
        <source>has an animation without keys</source>
        <translation>tiene una animación sin claves</translation>
    </message>
    <message>
        <source>has an animation with %1 key times, but %2 values</source>
        <translation>tiene una animación con %1 tiempos de clave, pero %2 valores</translation>
    </message>
    <message>
        <source>has an animation whose key times go back</source>
        <translation>tiene una animación cuyos tiempos de clave retroceden</translation>
    </message>
    <message>
        <source>has an animation channel without a sampler</source>
        <translation>tiene un canal de animación sin muestreador</translation>
    </message>
    <message>
        <source>has an animation channel without a target</source>
        <translation>tiene un canal de animación sin destino</translation>
    </message>
    <message>
        <source>has an animation of node %1, which it has not</source>
        <translation>tiene una animación del nodo %1, que no existe</translation>
    </message>
    <message>
        <source>has an animation that moves the morph weights of a node twice</source>
        <translation>tiene una animación que mueve dos veces los pesos de morph de un nodo</translation>
    </message>
    <message>
        <source>has an unknown interpolation, %1</source>
        <translation>tiene una interpolación desconocida, %1</translation>
    </message>
    <message>
        <source>has a rotation of length 0</source>
        <translation>tiene una rotación de longitud 0</translation>
    </message>
    <message>
        <source>has a node that is below itself</source>
        <translation>tiene un nodo que está debajo de sí mismo</translation>
    </message>
    <message>
        <source>has node %1 below two nodes, or twice below one</source>
        <translation>tiene el nodo %1 debajo de dos nodos, o dos veces debajo de uno</translation>
    </message>
    <message>
        <source>has more than %1 nodes</source>
        <translation>tiene más de %1 nodos</translation>
    </message>
    <message>
        <source>has a name of more than %1 bytes</source>
        <translation>tiene un nombre de más de %1 bytes</translation>
    </message>
    <message>
        <source>has morph weights of a node without a mesh</source>
        <translation>tiene pesos de morph de un nodo sin malla</translation>
    </message>
    <message>
        <source>has too many morph targets</source>
        <translation>tiene demasiados objetivos de morph</translation>
    </message>
    <message>
        <source>has too many morph weights</source>
        <translation>tiene demasiados pesos de morph</translation>
    </message>
    <message>
        <source>moves neither nodes nor morph weights that can be read</source>
        <translation>no mueve nodos ni pesos de morph que se puedan leer</translation>
    </message>
    <message>
        <source>asks for %1 frames of %2 nodes, too many for a file of so few bytes</source>
        <translation>pide %1 fotogramas de %2 nodos, demasiados para un archivo de tan pocos bytes</translation>
    </message>
    <message>
        <source>holds no keys</source>
        <translation>no contiene claves</translation>
    </message>
    <message>
        <source>its take %1 moves no node</source>
        <translation>su toma %1 no mueve ningún nodo</translation>
    </message>
    <message>
        <source>its nodes hang in a circle</source>
        <translation>sus nodos forman un círculo</translation>
    </message>
    <message>
        <source>its nodes hang deeper than %1</source>
        <translation>sus nodos están a más de %1 niveles</translation>
    </message>
    <message>
        <source>has keys at impossible times</source>
        <translation>tiene claves en tiempos imposibles</translation>
    </message>
    <message>
        <source>has too many nodes for so many frames</source>
        <translation>tiene demasiados nodos para tantos fotogramas</translation>
    </message>
    <message>
        <source>the target of %1 is out of reach with this method: the nearest is %2</source>
        <translation>el objetivo de %1 está fuera del alcance de este método: lo más cercano es %2</translation>
    </message>
    <message>
        <source>a promise beside the target is out of reach: %1</source>
        <translation>una promesa junto al objetivo está fuera de alcance: %1</translation>
    </message>
    <message>
        <source>no joint is of any importance</source>
        <translation>ninguna articulación tiene importancia</translation>
    </message>
    <message>
        <source>the importance of a joint must be a number, 0 or more</source>
        <translation>la importancia de una articulación debe ser un número, 0 o más</translation>
    </message>
    <message>
        <source>the importance of every joint is needed, or of none</source>
        <translation>se necesita la importancia de todas las articulaciones, o de ninguna</translation>
    </message>
    <message>
        <source>the skeleton has no joint named %1</source>
        <translation>el esqueleto no tiene ninguna articulación llamada %1</translation>
    </message>
    <message>
        <source>%1 is turned (degrees, RMS) by %2, not %3</source>
        <translation>%1 está girada (grados, RMS) %2 en vez de %3</translation>
    </message>
    <message>
        <source>the weighting skin needs a clip with a mesh on its joints, or a character that is put on it</source>
        <translation>la ponderación Piel necesita un clip con una malla en sus articulaciones, o un personaje puesto en él</translation>
    </message>
    <message>
        <source>cannot be written: its extension is none of .bvh, .fbx, .glb, .gltf, .amc, .csv</source>
        <translation>no se puede escribir: su extensión no es ninguna de .bvh, .fbx, .glb, .gltf, .amc, .csv</translation>
    </message>
    <message>
        <source>is not written: the motion has values that are not finite</source>
        <translation>no se escribe: el movimiento tiene valores que no son finitos</translation>
    </message>
    <message>
        <source>only an .fbx can be written onto an .fbx, and a .glb or .gltf onto a glTF</source>
        <translation>sobre un .fbx solo se puede escribir un .fbx, y sobre un glTF un .glb o .gltf</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>no se puede escribir: %1</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>no se puede leer: %1</translation>
    </message>
    <message>
        <source>cannot be looked at: %1</source>
        <translation>no se puede examinar: %1</translation>
    </message>
    <message>
        <source>has %1 for %2</source>
        <translation>tiene %1 para %2</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation>
            <numerusform>%n valor</numerusform>
            <numerusform>%n valores</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s)</source>
        <translation>
            <numerusform>%n articulación</numerusform>
            <numerusform>%n articulaciones</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n connection(s)</source>
        <translation>
            <numerusform>%n conexión</numerusform>
            <numerusform>%n conexiones</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n node(s)</source>
        <translation>
            <numerusform>%n nodo</numerusform>
            <numerusform>%n nodos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n bone(s)</source>
        <translation>
            <numerusform>%n hueso</numerusform>
            <numerusform>%n huesos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n channel(s)</source>
        <translation>
            <numerusform>%n canal</numerusform>
            <numerusform>%n canales</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n curve(s)</source>
        <translation>
            <numerusform>%n curva</numerusform>
            <numerusform>%n curvas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n key(s)</source>
        <translation>
            <numerusform>%n clave</numerusform>
            <numerusform>%n claves</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s)</source>
        <translation>
            <numerusform>%n fotograma</numerusform>
            <numerusform>%n fotogramas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n column(s)</source>
        <translation>
            <numerusform>%n columna</numerusform>
            <numerusform>%n columnas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n End Site(s)</source>
        <translation>
            <numerusform>%n End Site</numerusform>
            <numerusform>%n End Site</numerusform>
        </translation>
    </message>
    <message>
        <source>needs its skeleton, but neither %1.asf nor %2.asf is beside it</source>
        <translation>necesita su esqueleto, pero ni %1.asf ni %2.asf están junto a él</translation>
    </message>
    <message>
        <source>needs its skeleton, but %1.asf is not beside it</source>
        <translation>necesita su esqueleto, pero %1.asf no está junto a él</translation>
    </message>
    <message>
        <source>expected a number, found %1</source>
        <translation>se esperaba un número, se encontró %1</translation>
    </message>
    <message>
        <source>%1 with quaternions between keys, which are read as angles</source>
        <translation>%1 con cuaterniones entre las claves, que se leen como ángulos</translation>
    </message>
    <message>
        <source>the target of %1 is out of reach with this method: the nearest is %2, a smaller file</source>
        <translation>el objetivo de %1 está fuera del alcance de este método: lo más cercano es %2, un archivo más pequeño</translation>
    </message>
    <message>
        <source>the target of %1 is out of reach with this method: the nearest is %2, a larger file</source>
        <translation>el objetivo de %1 está fuera del alcance de este método: lo más cercano es %2, un archivo más grande</translation>
    </message>
    <message>
        <source>%1 (byte %2)</source>
        <translation>%1 (byte %2)</translation>
    </message>
    <message>
        <source>%1 (line %2)</source>
        <translation>%1 (línea %2)</translation>
    </message>
    <message>
        <source>byte %1: %2</source>
        <translation>byte %1: %2</translation>
    </message>
    <message>
        <source>not a Mocapress file</source>
        <translation>no es un archivo de Mocapress</translation>
    </message>
    <message>
        <source>not a bank of clips</source>
        <translation>no es un banco de clips</translation>
    </message>
    <message>
        <source>a clip of a bank: the bank is what is opened</source>
        <translation>un clip de un banco: lo que se abre es el banco</translation>
    </message>
    <message>
        <source>the version is unknown: a newer Mocapress is needed</source>
        <translation>la versión es desconocida: se necesita un Mocapress más nuevo</translation>
    </message>
    <message>
        <source>the file ends within its header</source>
        <translation>el archivo termina dentro de su cabecera</translation>
    </message>
    <message>
        <source>the file ends within a section</source>
        <translation>el archivo termina dentro de una sección</translation>
    </message>
    <message>
        <source>a section is damaged: its checksum differs</source>
        <translation>una sección está dañada: su suma de comprobación difiere</translation>
    </message>
    <message>
        <source>a section is missing</source>
        <translation>falta una sección</translation>
    </message>
    <message>
        <source>a section for the second time</source>
        <translation>una sección por segunda vez</translation>
    </message>
    <message>
        <source>a section that is not expected here</source>
        <translation>una sección que no se espera aquí</translation>
    </message>
    <message>
        <source>a second section loop</source>
        <translation>una segunda sección loop</translation>
    </message>
    <message>
        <source>bytes after the last section</source>
        <translation>bytes después de la última sección</translation>
    </message>
    <message>
        <source>bytes after the coded motion</source>
        <translation>bytes después del movimiento codificado</translation>
    </message>
    <message>
        <source>bytes after the last joint</source>
        <translation>bytes después de la última articulación</translation>
    </message>
    <message>
        <source>bytes after the DEFLATE stream</source>
        <translation>bytes después del flujo DEFLATE</translation>
    </message>
    <message>
        <source>bytes of curves where there are none</source>
        <translation>bytes de curvas donde no hay ninguna</translation>
    </message>
    <message>
        <source>%1 has the wrong size</source>
        <translation>%1 no tiene el tamaño correcto</translation>
    </message>
    <message>
        <source>%1 is too short</source>
        <translation>%1 es demasiado corto</translation>
    </message>
    <message>
        <source>ENDS has an impossible reach</source>
        <translation>ENDS tiene un alcance imposible</translation>
    </message>
    <message>
        <source>ENDS has impossible steps</source>
        <translation>ENDS tiene pasos imposibles</translation>
    </message>
    <message>
        <source>TIER has an impossible number of tiers</source>
        <translation>TIER tiene un número imposible de niveles</translation>
    </message>
    <message>
        <source>TIER has tiers that do not follow each other</source>
        <translation>TIER tiene niveles que no se siguen</translation>
    </message>
    <message>
        <source>a tier is missing</source>
        <translation>falta un nivel</translation>
    </message>
    <message>
        <source>tiers of another coding</source>
        <translation>niveles de otra codificación</translation>
    </message>
    <message>
        <source>the file has %1 tiers, not %2</source>
        <translation>el archivo tiene %1 niveles en vez de %2</translation>
    </message>
    <message>
        <source>a file with tiers takes no further section</source>
        <translation>un archivo con niveles no admite más secciones</translation>
    </message>
    <message>
        <source>a number of the motion is out of bounds</source>
        <translation>un número del movimiento está fuera de límites</translation>
    </message>
    <message>
        <source>a number of the skeleton is not finite</source>
        <translation>un número del esqueleto no es finito</translation>
    </message>
    <message>
        <source>a step is larger than 2^64</source>
        <translation>un paso es mayor que 2^64</translation>
    </message>
    <message>
        <source>a run of zeros passes the end of its channel</source>
        <translation>una serie de ceros pasa del final de su canal</translation>
    </message>
    <message>
        <source>a track has unknown flags</source>
        <translation>una pista tiene indicadores desconocidos</translation>
    </message>
    <message>
        <source>a joint has unknown flags</source>
        <translation>una articulación tiene indicadores desconocidos</translation>
    </message>
    <message>
        <source>a joint stands before its parent</source>
        <translation>una articulación está antes que su padre</translation>
    </message>
    <message>
        <source>a joint has more than 6 channels</source>
        <translation>una articulación tiene más de 6 canales</translation>
    </message>
    <message>
        <source>the axes are not a unit quaternion</source>
        <translation>los ejes no son un cuaternión unitario</translation>
    </message>
    <message>
        <source>not as many channels as JNTS states</source>
        <translation>no hay tantos canales como dice JNTS</translation>
    </message>
    <message>
        <source>an effector is not a joint</source>
        <translation>un efector no es una articulación</translation>
    </message>
    <message>
        <source>a basis where there are no wavelets</source>
        <translation>una base donde no hay ondículas</translation>
    </message>
    <message>
        <source>impossible orders of rotations</source>
        <translation>órdenes de rotación imposibles</translation>
    </message>
    <message>
        <source>an impossible unit of length</source>
        <translation>una unidad de longitud imposible</translation>
    </message>
    <message>
        <source>more frames than the limits allow</source>
        <translation>más fotogramas de los que permiten los límites</translation>
    </message>
    <message>
        <source>more joints or channels than the limits allow</source>
        <translation>más articulaciones o canales de los que permiten los límites</translation>
    </message>
    <message>
        <source>more values than the limits allow</source>
        <translation>más valores de los que permiten los límites</translation>
    </message>
    <message>
        <source>more than 2^22 frames</source>
        <translation>más de 2^22 fotogramas</translation>
    </message>
    <message>
        <source>more than 2^26 values</source>
        <translation>más de 2^26 valores</translation>
    </message>
    <message>
        <source>reading takes more scratch memory than the limits allow</source>
        <translation>la lectura necesita más memoria de trabajo de la que permiten los límites</translation>
    </message>
    <message>
        <source>the resident form takes more memory than the limits allow</source>
        <translation>la forma residente necesita más memoria de la que permiten los límites</translation>
    </message>
    <message>
        <source>the coding is not adaptive</source>
        <translation>la codificación no es adaptativa</translation>
    </message>
    <message>
        <source>%1 ends early</source>
        <translation>%1 acaba antes de tiempo</translation>
    </message>
    <message>
        <source>%1 end early</source>
        <translation>%1 acaban antes de tiempo</translation>
    </message>
    <message>
        <source>%1 is damaged</source>
        <translation>%1 está dañado</translation>
    </message>
    <message>
        <source>%1 are damaged</source>
        <translation>%1 están dañados</translation>
    </message>
    <message>
        <source>the coded motion</source>
        <translation>el movimiento codificado</translation>
    </message>
    <message>
        <source>the coded tracks</source>
        <translation>las pistas codificadas</translation>
    </message>
    <message>
        <source>the coded ends</source>
        <translation>los extremos codificados</translation>
    </message>
    <message>
        <source>the coded skeleton</source>
        <translation>el esqueleto codificado</translation>
    </message>
    <message>
        <source>the DEFLATE stream</source>
        <translation>el flujo DEFLATE</translation>
    </message>
    <message>
        <source>the skeleton</source>
        <translation>el esqueleto</translation>
    </message>
    <message>
        <source>the tracks</source>
        <translation>las pistas</translation>
    </message>
    <message>
        <source>more runs of tracks than was promised</source>
        <translation>más series de pistas de lo anunciado</translation>
    </message>
    <message>
        <source>other tracks than was promised</source>
        <translation>otras pistas que las anunciadas</translation>
    </message>
    <message>
        <source>the number of segments does not fit the frames</source>
        <translation>el número de segmentos no corresponde a los fotogramas</translation>
    </message>
    <message>
        <source>the sample rate is not a positive number</source>
        <translation>la cadencia no es un número positivo</translation>
    </message>
    <message>
        <source>the scale of steps is not a positive number</source>
        <translation>la escala de los pasos no es un número positivo</translation>
    </message>
    <message>
        <source>the segments have an impossible length</source>
        <translation>los segmentos tienen una longitud imposible</translation>
    </message>
    <message>
        <source>the skeleton has an impossible size</source>
        <translation>el esqueleto tiene un tamaño imposible</translation>
    </message>
    <message>
        <source>the tracks have an impossible size</source>
        <translation>las pistas tienen un tamaño imposible</translation>
    </message>
    <message>
        <source>too many samples for so few coded bytes</source>
        <translation>demasiadas muestras para tan pocos bytes codificados</translation>
    </message>
    <message>
        <source>inflates to more bytes than allowed</source>
        <translation>se descomprime en más bytes de los permitidos</translation>
    </message>
    <message>
        <source>unknown basis of tracks</source>
        <translation>base de pistas desconocida</translation>
    </message>
    <message>
        <source>unknown basis</source>
        <translation>base desconocida</translation>
    </message>
    <message>
        <source>unknown coding</source>
        <translation>codificación desconocida</translation>
    </message>
    <message>
        <source>unknown kind of loop</source>
        <translation>tipo de bucle desconocido</translation>
    </message>
    <message>
        <source>unknown kind of track</source>
        <translation>tipo de pista desconocido</translation>
    </message>
    <message>
        <source>unknown kind of channel</source>
        <translation>tipo de canal desconocido</translation>
    </message>
    <message>
        <source>unknown kind of source</source>
        <translation>tipo de fuente desconocido</translation>
    </message>
    <message>
        <source>unknown method</source>
        <translation>método desconocido</translation>
    </message>
    <message>
        <source>unknown solver</source>
        <translation>solucionador desconocido</translation>
    </message>
    <message>
        <source>unknown weighting</source>
        <translation>ponderación desconocida</translation>
    </message>
    <message>
        <source>unknown axis</source>
        <translation>eje desconocido</translation>
    </message>
    <message>
        <source>unknown convention</source>
        <translation>convención desconocida</translation>
    </message>
    <message>
        <source>unknown order of rotations</source>
        <translation>orden de rotaciones desconocido</translation>
    </message>
    <message>
        <source>unknown method of compression: %1</source>
        <translation>método de compresión desconocido: %1</translation>
    </message>
    <message>
        <source>not a wavelet clip: it was made by a comparison method (section COMP)</source>
        <translation>no es un clip de ondículas: lo hizo un método de comparación (sección COMP)</translation>
    </message>
    <message>
        <source>the motion has values that are not finite</source>
        <translation>el movimiento tiene valores que no son finitos</translation>
    </message>
    <message>
        <source>ends here: %1 bytes wanted, %2 left</source>
        <translation>acaba aquí: se necesitan %1 bytes, quedan %2</translation>
    </message>
    <message>
        <source>%1 bytes too many</source>
        <translation>sobran %1 bytes</translation>
    </message>
    <message>
        <source>the clips of the bank are damaged: their checksum differs</source>
        <translation>los clips del banco están dañados: su suma de comprobación difiere</translation>
    </message>
    <message>
        <source>clips of the bank are damaged: their checksum differs</source>
        <translation>hay clips del banco dañados: su suma de comprobación difiere</translation>
    </message>
    <message>
        <source>the head of the bank is damaged: its checksum differs</source>
        <translation>la cabecera del banco está dañada: su suma de comprobación difiere</translation>
    </message>
    <message>
        <source>the index of the bank is damaged: its checksum differs</source>
        <translation>el índice del banco está dañado: su suma de comprobación difiere</translation>
    </message>
    <message>
        <source>the index of the bank makes no sense</source>
        <translation>el índice del banco no tiene sentido</translation>
    </message>
    <message>
        <source>the tiers of the bank make no sense</source>
        <translation>los niveles del banco no tienen sentido</translation>
    </message>
    <message>
        <source>a tier of the bank is damaged: its checksum differs</source>
        <translation>un nivel del banco está dañado: su suma de comprobación difiere</translation>
    </message>
    <message>
        <source>the bank is cut short</source>
        <translation>el banco está cortado</translation>
    </message>
    <message>
        <source>the bank has an impossible head</source>
        <translation>el banco tiene una cabecera imposible</translation>
    </message>
    <message>
        <source>an unknown form of bank</source>
        <translation>una forma de banco desconocida</translation>
    </message>
    <message>
        <source>an impossible item of the bank</source>
        <translation>un elemento imposible del banco</translation>
    </message>
    <message>
        <source>the parts of the bank are out of order</source>
        <translation>las partes del banco están desordenadas</translation>
    </message>
    <message>
        <source>a clip of the bank has another size than it says</source>
        <translation>un clip del banco no tiene el tamaño que dice</translation>
    </message>
    <message>
        <source>a clip of the bank has another skeleton than it says</source>
        <translation>un clip del banco no tiene el esqueleto que dice</translation>
    </message>
    <message>
        <source>a clip of the bank</source>
        <translation>un clip del banco</translation>
    </message>
    <message>
        <source>what the bank&apos;s clips taught makes no sense</source>
        <translation>lo que enseñaron los clips del banco no tiene sentido</translation>
    </message>
    <message>
        <source>a number that is not finite</source>
        <translation>un número que no es finito</translation>
    </message>
    <message>
        <source>a value that is not finite</source>
        <translation>un valor que no es finito</translation>
    </message>
    <message>
        <source>a range that is not finite</source>
        <translation>un intervalo que no es finito</translation>
    </message>
    <message>
        <source>a step that is not finite</source>
        <translation>un paso que no es finito</translation>
    </message>
    <message>
        <source>segments that are too short</source>
        <translation>segmentos demasiado cortos</translation>
    </message>
    <message>
        <source>more components than possible</source>
        <translation>más componentes de los posibles</translation>
    </message>
    <message>
        <source>fewer components than stated</source>
        <translation>menos componentes de los anunciados</translation>
    </message>
    <message>
        <source>a component whose reach is not above 0</source>
        <translation>una componente cuyo alcance no es mayor que 0</translation>
    </message>
    <message>
        <source>an unknown cluster</source>
        <translation>un grupo desconocido</translation>
    </message>
    <message>
        <source>a segment of an unknown kind</source>
        <translation>un segmento de un tipo desconocido</translation>
    </message>
    <message>
        <source>two keys at one frame</source>
        <translation>dos claves en un fotograma</translation>
    </message>
    <message>
        <source>a key after the clip&apos;s end</source>
        <translation>una clave después del final del clip</translation>
    </message>
    <message>
        <source>a key after the segment&apos;s end</source>
        <translation>una clave después del final del segmento</translation>
    </message>
    <message>
        <source>no key at the clip&apos;s end</source>
        <translation>no hay clave al final del clip</translation>
    </message>
    <message>
        <source>no key at the segment&apos;s end</source>
        <translation>no hay clave al final del segmento</translation>
    </message>
    <message>
        <source>a stride longer than the clip</source>
        <translation>un paso más largo que el clip</translation>
    </message>
    <message>
        <source>a curve has %1 key times, but %2 values</source>
        <translation>una curva tiene %1 tiempos de clave, pero %2 valores</translation>
    </message>
    <message>
        <source>a curve ends within a key</source>
        <translation>una curva acaba en medio de una clave</translation>
    </message>
    <message>
        <source>has a key with unknown tangents</source>
        <translation>tiene una clave con tangentes desconocidas</translation>
    </message>
    <message>
        <source>has a key of an unknown kind</source>
        <translation>tiene una clave de un tipo desconocido</translation>
    </message>
    <message>
        <source>has meshes of more than %1 corners</source>
        <translation>tiene mallas de más de %1 esquinas</translation>
    </message>
    <message>
        <source>has a polygon with a point that its mesh has not</source>
        <translation>tiene un polígono con un punto que su malla no tiene</translation>
    </message>
    <message>
        <source>has a bone with more or fewer weights than points</source>
        <translation>tiene un hueso con más o menos pesos que puntos</translation>
    </message>
    <message>
        <source>has a bone with a weight of a point that its mesh has not</source>
        <translation>tiene un hueso con el peso de un punto que su malla no tiene</translation>
    </message>
    <message>
        <source>has more than %1 weights</source>
        <translation>tiene más de %1 pesos</translation>
    </message>
    <message>
        <source>has more than %1 records</source>
        <translation>tiene más de %1 registros</translation>
    </message>
    <message>
        <source>nests records deeper than %1</source>
        <translation>anida registros a más de %1 niveles</translation>
    </message>
    <message>
        <source>is FBX %1: versions from 6.0 on are read</source>
        <translation>es FBX %1: se leen las versiones desde la 6.0</translation>
    </message>
    <message>
        <source>ends within its head</source>
        <translation>acaba dentro de su cabecera</translation>
    </message>
    <message>
        <source>cannot be read as FBX: it begins neither like a binary file nor like an ASCII one</source>
        <translation>no se puede leer como FBX: no empieza como un archivo binario ni como uno ASCII</translation>
    </message>
    <message>
        <source>cannot be read as FBX: it states no version</source>
        <translation>no se puede leer como FBX: no indica la versión</translation>
    </message>
    <message>
        <source>has an array of an unknown encoding</source>
        <translation>tiene una matriz con una codificación desconocida</translation>
    </message>
    <message>
        <source>an array has fewer values than it states</source>
        <translation>una matriz tiene menos valores de los que indica</translation>
    </message>
    <message>
        <source>an array states more values than its bytes can hold</source>
        <translation>una matriz indica más valores de los que caben en sus bytes</translation>
    </message>
    <message>
        <source>has an array that cannot be unpacked</source>
        <translation>tiene una matriz que no se puede descomprimir</translation>
    </message>
    <message>
        <source>its take %1 has no first layer that is heard: a motion cannot be written there</source>
        <translation>su toma %1 no tiene una primera capa activa: no se puede escribir ahí un movimiento</translation>
    </message>
    <message>
        <source>numbers its objects too high to add any</source>
        <translation>numera sus objetos demasiado alto para añadir otros</translation>
    </message>
    <message>
        <source>has curves that several takes share: a motion cannot be written onto one</source>
        <translation>tiene curvas que comparten varias tomas: no se puede escribir un movimiento sobre una</translation>
    </message>
    <message>
        <source>is ASCII, big-endian or older than 7.0: a motion is put only onto other binary FBX files</source>
        <translation>es ASCII, big-endian o anterior a 7.0: un movimiento solo se pone sobre otros archivos FBX binarios</translation>
    </message>
    <message>
        <source>a text is too long for an FBX</source>
        <translation>un texto es demasiado largo para un FBX</translation>
    </message>
    <message>
        <source>a curve is too long for an FBX</source>
        <translation>una curva es demasiado larga para un FBX</translation>
    </message>
    <message>
        <source>an FBX of a version before 7.5 has at most 4 GiB</source>
        <translation>un FBX de una versión anterior a 7.5 tiene como máximo 4 GiB</translation>
    </message>
    <message>
        <source>a record states no end: nothing is written onto it</source>
        <translation>un registro no indica su final: no se escribe nada sobre él</translation>
    </message>
    <message>
        <source>has no %1</source>
        <translation>no tiene %1</translation>
    </message>
    <message>
        <source>is no glTF: its JSON is not an object</source>
        <translation>no es un glTF: su JSON no es un objeto</translation>
    </message>
    <message>
        <source>is no glTF 2.0: %1</source>
        <translation>no es un glTF 2.0: %1</translation>
    </message>
    <message>
        <source>it states no version</source>
        <translation>no indica la versión</translation>
    </message>
    <message>
        <source>its version is %1</source>
        <translation>su versión es %1</translation>
    </message>
    <message>
        <source>ends before the length it states</source>
        <translation>acaba antes de la longitud que indica</translation>
    </message>
    <message>
        <source>is version %1 of .glb, not 2</source>
        <translation>es la versión %1 de .glb, no la 2</translation>
    </message>
    <message>
        <source>has a chunk that reaches beyond its end</source>
        <translation>tiene un bloque que pasa de su final</translation>
    </message>
    <message>
        <source>does not begin with JSON</source>
        <translation>no empieza con JSON</translation>
    </message>
    <message>
        <source>holds no JSON</source>
        <translation>no contiene JSON</translation>
    </message>
    <message>
        <source>%1 is not a list of objects</source>
        <translation>%1 no es una lista de objetos</translation>
    </message>
    <message>
        <source>%1 is not a whole number from 0</source>
        <translation>%1 no es un entero desde 0</translation>
    </message>
    <message>
        <source>%1 names number %2 of only %3</source>
        <translation>%1 nombra el número %2 de solo %3</translation>
    </message>
    <message>
        <source>lacks a %1 that should name one of its %2</source>
        <translation>le falta un %1 que nombre uno de sus %2</translation>
    </message>
    <message>
        <source>%1 names what is none of its %2</source>
        <translation>%1 nombra algo que no es ninguno de sus %2</translation>
    </message>
    <message>
        <source>%1 is not %2 numbers up to 1e9</source>
        <translation>%1 no son %2 números de hasta 1e9</translation>
    </message>
    <message>
        <source>%1 is not a list</source>
        <translation>%1 no es una lista</translation>
    </message>
    <message>
        <source>%1 is not a text</source>
        <translation>%1 no es un texto</translation>
    </message>
    <message>
        <source>has a data URI without base64</source>
        <translation>tiene un URI de datos sin base64</translation>
    </message>
    <message>
        <source>has a data URI that is not base64</source>
        <translation>tiene un URI de datos que no es base64</translation>
    </message>
    <message>
        <source>refers to %1, but only files in its own folder are read</source>
        <translation>se refiere a %1, pero solo se leen archivos de su propia carpeta</translation>
    </message>
    <message>
        <source>refers to %1, which is not there</source>
        <translation>se refiere a %1, que no está ahí</translation>
    </message>
    <message>
        <source>%1 has neither a uri nor a chunk of a .glb</source>
        <translation>%1 no tiene ni uri ni un bloque de un .glb</translation>
    </message>
    <message>
        <source>%1 has %2 of the %3 bytes it states</source>
        <translation>%1 tiene %2 de los %3 bytes que indica</translation>
    </message>
    <message>
        <source>%1 reaches beyond its buffer</source>
        <translation>%1 pasa de su buffer</translation>
    </message>
    <message>
        <source>has an accessor of an unknown componentType</source>
        <translation>tiene un accessor de un componentType desconocido</translation>
    </message>
    <message>
        <source>%1 has a byteStride that is too small</source>
        <translation>%1 tiene un byteStride demasiado pequeño</translation>
    </message>
    <message>
        <source>has an accessor that reaches beyond %1</source>
        <translation>tiene un accessor que pasa de %1</translation>
    </message>
    <message>
        <source>%1 holds a number that is not finite or beyond 1e9</source>
        <translation>%1 contiene un número no finito o de más de 1e9</translation>
    </message>
    <message>
        <source>accessor %1 is not %2</source>
        <translation>el accessor %1 no es %2</translation>
    </message>
    <message>
        <source>states more zeros that have no bytes than are read</source>
        <translation>indica más ceros sin bytes de los que se leen</translation>
    </message>
    <message>
        <source>%1 has sparse values without sense</source>
        <translation>%1 tiene valores dispersos sin sentido</translation>
    </message>
    <message>
        <source>%1 has a sparse value for an element that it has not</source>
        <translation>%1 tiene un valor disperso para un elemento que no tiene</translation>
    </message>
    <message>
        <source>has a skin with %1 joints, but only %2 bind matrices</source>
        <translation>tiene una piel con %1 articulaciones, pero solo %2 matrices de enlace</translation>
    </message>
    <message>
        <source>has a mesh packed without attributes</source>
        <translation>tiene una malla empaquetada sin atributos</translation>
    </message>
    <message>
        <source>has a packed mesh without the attributes it states</source>
        <translation>tiene una malla empaquetada sin los atributos que indica</translation>
    </message>
    <message>
        <source>has a mesh with more or fewer normals than positions</source>
        <translation>tiene una malla con más o menos normales que posiciones</translation>
    </message>
    <message>
        <source>has a triangle with a vertex that its mesh has not</source>
        <translation>tiene un triángulo con un vértice que su malla no tiene</translation>
    </message>
    <message>
        <source>has a mesh with more or fewer weights than positions</source>
        <translation>tiene una malla con más o menos pesos que posiciones</translation>
    </message>
    <message>
        <source>has a vertex on a joint that its skin has not</source>
        <translation>tiene un vértice en una articulación que su piel no tiene</translation>
    </message>
    <message>
        <source>has a mesh with more or fewer places in its picture than positions</source>
        <translation>tiene una malla con más o menos lugares en su imagen que posiciones</translation>
    </message>
    <message>
        <source>the motion is too large for a .glb: 4 GB are the most</source>
        <translation>el movimiento es demasiado grande para un .glb: 4 GB como máximo</translation>
    </message>
    <message>
        <source>verification: %1</source>
        <translation>verificación: %1</translation>
    </message>
    <message>
        <source>no project: %1</source>
        <translation>no es un proyecto: %1</translation>
    </message>
    <message>
        <source>the preset &quot;%1&quot; %2</source>
        <translation>el preajuste «%1» %2</translation>
    </message>
    <message>
        <source>the compression %1</source>
        <translation>la compresión %1</translation>
    </message>
    <message>
        <source>this clip cannot be written as .mcpr: %1</source>
        <translation>este clip no se puede escribir como .mcpr: %1</translation>
    </message>
    <message>
        <source>its tracks cannot be kept: %1</source>
        <translation>sus pistas no se pueden conservar: %1</translation>
    </message>
    <message>
        <source>the name of joint %1... has %2 bytes, at most %3 are possible</source>
        <translation>el nombre de la articulación %1... tiene %2 bytes, como máximo son posibles %3</translation>
    </message>
    <message>
        <source>joint %1 has %2 channels, at most %3 are possible</source>
        <translation>la articulación %1 tiene %2 canales, como máximo son posibles %3</translation>
    </message>
    <message>
        <source>joint %1 is too far away for 32-bit floats</source>
        <translation>la articulación %1 está demasiado lejos para flotantes de 32 bits</translation>
    </message>
    <message>
        <source>it has no joints</source>
        <translation>no tiene articulaciones</translation>
    </message>
    <message>
        <source>its sample rate is not a positive number</source>
        <translation>su cadencia no es un número positivo</translation>
    </message>
    <message>
        <source>there are %1, at most %2 are possible</source>
        <translation>hay %1, como máximo son posibles %2</translation>
    </message>
    <message>
        <source>motion and tracks have %1 values, at most %2 are possible</source>
        <translation>movimiento y pistas tienen %1 valores, como máximo son posibles %2</translation>
    </message>
    <message>
        <source>an .asf of this skeleton would have %1 bones, at most %2 are possible</source>
        <translation>un .asf de este esqueleto tendría %1 huesos, como máximo son posibles %2</translation>
    </message>
    <message>
        <source>%1, at most %2 are possible</source>
        <translation>%1, como máximo son posibles %2</translation>
    </message>
    <message>
        <source>%1 values (frames times channels)</source>
        <translation>%1 valores (fotogramas por canales)</translation>
    </message>
    <message>
        <source>%1 values are too many for a motion of so few bytes</source>
        <translation>%1 valores son demasiados para un movimiento de tan pocos bytes</translation>
    </message>
    <message>
        <source>the name of one has more than %1 bytes</source>
        <translation>el nombre de una tiene más de %1 bytes</translation>
    </message>
    <message>
        <source>%1 has another number of frames than the clip</source>
        <translation>%1 tiene otro número de fotogramas que el clip</translation>
    </message>
    <message>
        <source>%1 has a value that is not finite</source>
        <translation>%1 tiene un valor que no es finito</translation>
    </message>
    <message>
        <source>the motion to be written is not coded yet</source>
        <translation>el movimiento que se va a escribir aún no está codificado</translation>
    </message>
    <message>
        <source>the motion to be written lacks its finest bands</source>
        <translation>al movimiento que se va a escribir le faltan sus bandas más finas</translation>
    </message>
    <message>
        <source>an .amc holds one figure with one root, but this clip has %1 roots: .bvh and .glb can hold it</source>
        <translation>un .amc contiene una figura con una raíz, pero este clip tiene %1 raíces: .bvh y .glb lo admiten</translation>
    </message>
    <message>
        <source>a bone&apos;s name would be too long for an .asf: %1</source>
        <translation>el nombre de un hueso sería demasiado largo para un .asf: %1</translation>
    </message>
    <message>
        <source>in an .asf bones of this skeleton would be nested deeper than %1</source>
        <translation>en un .asf, huesos de este esqueleto estarían anidados a más de %1 niveles</translation>
    </message>
    <message>
        <source>a joint is scaled to nothing: what hangs from it has no place</source>
        <translation>una articulación está escalada a nada: lo que cuelga de ella no tiene lugar</translation>
    </message>
    <message>
        <source>has no joint %1, which the motion has</source>
        <translation>no tiene la articulación %1, que el movimiento tiene</translation>
    </message>
    <message>
        <source>scales %1 to nothing: it cannot follow a motion</source>
        <translation>escala %1 a nada: no puede seguir un movimiento</translation>
    </message>
    <message>
        <source>no feet were found on this skeleton: name the joints to be corrected</source>
        <translation>no se encontraron pies en este esqueleto: nombre las articulaciones que corregir</translation>
    </message>
    <message>
        <source>no joint above %1 can turn to move it</source>
        <translation>ninguna articulación por encima de %1 puede girar para moverla</translation>
    </message>
    <message>
        <source>a chain of joints that ends at %1 does not begin at a joint above it that can turn</source>
        <translation>una cadena que acaba en %1 no empieza en una articulación superior que pueda girar</translation>
    </message>
    <message>
        <source>more than %1 effectors</source>
        <translation>más de %1 efectores</translation>
    </message>
    <message>
        <source>these effectors are not one limb</source>
        <translation>estos efectores no forman una extremidad</translation>
    </message>
    <message>
        <source>the importance of frames %1 to %2 is not a number from 1 to %3</source>
        <translation>la importancia de los fotogramas %1 a %2 no es un número de 1 a %3</translation>
    </message>
    <message>
        <source>frames %1 to %2 are not a range of the clip, which has %3 frames</source>
        <translation>los fotogramas %1 a %2 no son un intervalo del clip, que tiene %3 fotogramas</translation>
    </message>
    <message>
        <source>inverse kinematics can correct wavelet methods only</source>
        <translation>la cinemática inversa solo corrige métodos de ondículas</translation>
    </message>
    <message>
        <source>the coefficient ratio is a target of wavelet methods only</source>
        <translation>la tasa de coeficientes solo es un objetivo de los métodos de ondículas</translation>
    </message>
    <message>
        <source>is not a compressed form of the original: it has %1, the original %2</source>
        <translation>no es una forma comprimida del original: tiene %1, el original %2</translation>
    </message>
    <message>
        <source>the clip has no frames</source>
        <translation>el clip no tiene fotogramas</translation>
    </message>
    <message>
        <source>the clip is not a loop</source>
        <translation>el clip no es un bucle</translation>
    </message>
    <message>
        <source>the tracks are not those of the original</source>
        <translation>las pistas no son las del original</translation>
    </message>
    <message>
        <source>the tracks have not as many frames as those of the original</source>
        <translation>las pistas no tienen tantos fotogramas como las del original</translation>
    </message>
    <message>
        <source>has an unknown method: %1</source>
        <translation>tiene un método desconocido: %1</translation>
    </message>
    <message>
        <source>unknown method: %1</source>
        <translation>método desconocido: %1</translation>
    </message>
    <message>
        <source>has a coding other than adaptive, the only one of the closed loop</source>
        <translation>tiene otra codificación que la adaptativa, la única del bucle cerrado</translation>
    </message>
    <message>
        <source>has a target that is not above 0</source>
        <translation>tiene un objetivo que no es mayor que 0</translation>
    </message>
    <message>
        <source>has a coefficient ratio, a target of wavelet methods only</source>
        <translation>tiene una tasa de coeficientes, objetivo solo de los métodos de ondículas</translation>
    </message>
    <message>
        <source>has a track error that is not above 0</source>
        <translation>tiene un error de pistas que no es mayor que 0</translation>
    </message>
    <message>
        <source>has a promise that is not above 0: %1</source>
        <translation>tiene una promesa que no es mayor que 0: %1</translation>
    </message>
    <message>
        <source>has the effort draft, which does not promise its target</source>
        <translation>tiene el esfuerzo borrador, que no promete su objetivo</translation>
    </message>
    <message>
        <source>has an importance of frames that is not a number from 1 to %1</source>
        <translation>tiene una importancia de fotogramas que no es un número de 1 a %1</translation>
    </message>
    <message>
        <source>has an importance of %1 that is not a number of 0 or more</source>
        <translation>tiene una importancia de %1 que no es un número de 0 o más</translation>
    </message>
    <message>
        <source>has an IK correction, which can correct wavelet methods only</source>
        <translation>tiene una corrección IK, que solo corrige métodos de ondículas</translation>
    </message>
    <message>
        <source>has an IK ratio that is not above 0</source>
        <translation>tiene una tasa IK que no es mayor que 0</translation>
    </message>
    <message>
        <source>%1 is not a JSON object</source>
        <translation>%1 no es un objeto JSON</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 no es un número</translation>
    </message>
    <message>
        <source>%1 is not a whole number</source>
        <translation>%1 no es un entero</translation>
    </message>
    <message>
        <source>%1 is not a frame</source>
        <translation>%1 no es un fotograma</translation>
    </message>
    <message>
        <source>%1 is not above 0</source>
        <translation>%1 no es mayor que 0</translation>
    </message>
    <message>
        <source>%1 is below 0</source>
        <translation>%1 es menor que 0</translation>
    </message>
    <message>
        <source>%1 is neither a number nor &quot;auto&quot;</source>
        <translation>%1 no es ni un número ni «auto»</translation>
    </message>
    <message>
        <source>%1 is not a list of names</source>
        <translation>%1 no es una lista de nombres</translation>
    </message>
    <message>
        <source>%1 is not a list of contacts</source>
        <translation>%1 no es una lista de contactos</translation>
    </message>
    <message>
        <source>%1 is not a list of joints with a first and a last frame</source>
        <translation>%1 no es una lista de articulaciones con un primer y un último fotograma</translation>
    </message>
    <message>
        <source>%1 is not a list of ranges with a first and a last frame</source>
        <translation>%1 no es una lista de intervalos con un primer y un último fotograma</translation>
    </message>
    <message>
        <source>%1 is not a list of ranges</source>
        <translation>%1 no es una lista de intervalos</translation>
    </message>
    <message>
        <source>%1 of %2 is not a number</source>
        <translation>%1 de %2 no es un número</translation>
    </message>
    <message>
        <source>%1 is &quot;%2&quot;, not one of %3</source>
        <translation>%1 es «%2», ninguno de %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is unknown</source>
        <translation>«%1» es desconocido</translation>
    </message>
    <message>
        <source>&quot;distance_m&quot; is not from %1 to %2</source>
        <translation>«distance_m» no está entre %1 y %2</translation>
    </message>
    <message>
        <source>what should be limits is not a JSON object</source>
        <translation>lo que debería ser límites no es un objeto JSON</translation>
    </message>
    <message>
        <source>a preset has no &quot;name&quot;</source>
        <translation>un preajuste no tiene «name»</translation>
    </message>
    <message>
        <source>holds no preset</source>
        <translation>no contiene ningún preajuste</translation>
    </message>
    <message>
        <source>is not JSON from here on</source>
        <translation>no es JSON a partir de aquí</translation>
    </message>
    <message>
        <source>holds a number that is too large</source>
        <translation>contiene un número demasiado grande</translation>
    </message>
    <message>
        <source>nests its JSON more than %1 deep</source>
        <translation>anida su JSON a más de %1 niveles</translation>
    </message>
    <message>
        <source>holds too many JSON values</source>
        <translation>contiene demasiados valores JSON</translation>
    </message>
    <message>
        <source>has a clip without a path</source>
        <translation>tiene un clip sin ruta</translation>
    </message>
    <message>
        <source>is not a project: %1</source>
        <translation>no es un proyecto: %1</translation>
    </message>
    <message>
        <source>is not a project</source>
        <translation>no es un proyecto</translation>
    </message>
    <message>
        <source>was saved by a newer version of Mocapress</source>
        <translation>lo guardó una versión más nueva de Mocapress</translation>
    </message>
    <message>
        <source>was written by a newer version of Mocapress</source>
        <translation>lo escribió una versión más nueva de Mocapress</translation>
    </message>
    <message>
        <source>is no file of notes</source>
        <translation>no es un archivo de notas</translation>
    </message>
    <message>
        <source>has notes of another form: %1</source>
        <translation>tiene notas de otra forma: %1</translation>
    </message>
    <message>
        <source>holds the notes of a clip in another format</source>
        <translation>contiene las notas de un clip de otro formato</translation>
    </message>
    <message>
        <source>the link is refused, for it names no clip by an absolute path on this computer: %1</source>
        <translation>se rechaza el enlace, pues no nombra ningún clip con una ruta absoluta de este ordenador: %1</translation>
    </message>
    <message>
        <source>is not a list of blind tests</source>
        <translation>no es una lista de pruebas ciegas</translation>
    </message>
    <message>
        <source>a blind test has an unknown cue: %1</source>
        <translation>una prueba ciega tiene un indicio desconocido: %1</translation>
    </message>
    <message>
        <source>a blind test has a level that is not above 0</source>
        <translation>una prueba ciega tiene un nivel que no es mayor que 0</translation>
    </message>
    <message>
        <source>a blind test lacks a value, or has one of another type</source>
        <translation>a una prueba ciega le falta un valor, o tiene uno de otro tipo</translation>
    </message>
    <message>
        <source>{%1} means nothing in a name: there are {folder}, {stem}, {type}, {preset} and {method}</source>
        <translation>{%1} no significa nada en un nombre: hay {folder}, {stem}, {type}, {preset} y {method}</translation>
    </message>
    <message>
        <source>the name pattern has a { without its }: %1</source>
        <translation>el patrón de nombres tiene una { sin su }: %1</translation>
    </message>
    <message>
        <source>is not a file name below the batch&apos;s folder: %1</source>
        <translation>no es un nombre de archivo bajo la carpeta del lote: %1</translation>
    </message>
    <message>
        <source>a bank is made of .mcpr files, which are not among the formats</source>
        <translation>un banco se hace de archivos .mcpr, que no están entre los formatos</translation>
    </message>
    <message>
        <source>only a packed bank is coded by what its clips teach</source>
        <translation>solo un banco compacto se codifica con lo que enseñan sus clips</translation>
    </message>
    <message>
        <source>%1 exists: not overwritten</source>
        <translation>%1 existe: no se sobrescribe</translation>
    </message>
    <message>
        <source>%1 exists and is not this batch&apos;s: not overwritten</source>
        <translation>%1 existe y no es de este lote: no se sobrescribe</translation>
    </message>
    <message>
        <source>%1 is a file that clips of this batch are made from</source>
        <translation>%1 es un archivo del que salen clips de este lote</translation>
    </message>
    <message>
        <source>is one of the inputs: not overwritten</source>
        <translation>es una de las entradas: no se sobrescribe</translation>
    </message>
    <message>
        <source>reads back with another number of frames</source>
        <translation>se relee con otro número de fotogramas</translation>
    </message>
    <message>
        <source>reads back without %1</source>
        <translation>se relee sin %1</translation>
    </message>
    <message>
        <source>reads back %1 cm off at %2</source>
        <translation>se relee con %1 cm de desvío en %2</translation>
    </message>
    <message>
        <source>the preset has a contact up to frame %1, but the clip ends before</source>
        <translation>el preajuste tiene un contacto hasta el fotograma %1, pero el clip acaba antes</translation>
    </message>
    <message>
        <source>%1 was asked for, but it came to %2</source>
        <translation>se pidió %1, pero resultó %2</translation>
    </message>
    <message>
        <source>%1 does not read back as it was written</source>
        <translation>%1 no se relee como se escribió</translation>
    </message>
    <message>
        <source>the written file has another shape</source>
        <translation>el archivo escrito tiene otra forma</translation>
    </message>
    <message>
        <source>the written file cannot be read: %1</source>
        <translation>el archivo escrito no se puede leer: %1</translation>
    </message>
    <message>
        <source>another run is using it: %1; if it is gone, its batch can be taken over</source>
        <translation>lo usa otra ejecución: %1; si ya no existe, otra puede encargarse de su lote</translation>
    </message>
    <message>
        <source>another run is using it: %1</source>
        <translation>lo usa otra ejecución: %1</translation>
    </message>
    <message>
        <source>another run is using it</source>
        <translation>lo usa otra ejecución</translation>
    </message>
    <message>
        <source>%1 on %2, process %3, since %4</source>
        <translation>%1 en %2, proceso %3, desde %4</translation>
    </message>
    <message>
        <source>cannot be listed, but holds clips that are done</source>
        <translation>no se puede listar, pero contiene clips terminados</translation>
    </message>
    <message>
        <source>is not the journal of a batch</source>
        <translation>no es el diario de un lote</translation>
    </message>
    <message>
        <source>changed while it was read</source>
        <translation>cambió mientras se leía</translation>
    </message>
    <message>
        <source>holds a batch already: it can be resumed or overwritten</source>
        <translation>ya contiene un lote: se puede reanudar o sobrescribir</translation>
    </message>
    <message>
        <source>is not of the same batch as the others</source>
        <translation>no es del mismo lote que los demás</translation>
    </message>
    <message>
        <source>holds no journal of a batch</source>
        <translation>no contiene ningún diario de un lote</translation>
    </message>
    <message>
        <source>%1 has an unknown preset</source>
        <translation>%1 tiene un preajuste desconocido</translation>
    </message>
    <message>
        <source>is not a queue of clips: %1</source>
        <translation>no es una cola de clips: %1</translation>
    </message>
    <message>
        <source>is not a queue of clips</source>
        <translation>no es una cola de clips</translation>
    </message>
    <message>
        <source>has an unknown format: %1</source>
        <translation>tiene un formato desconocido: %1</translation>
    </message>
    <message>
        <source>has an unknown form of bank: %1</source>
        <translation>tiene una forma de banco desconocida: %1</translation>
    </message>
    <message>
        <source>a script for sbatch cannot name %1: it has %2 in it</source>
        <translation>un script para sbatch no puede nombrar %1: contiene %2</translation>
    </message>
    <message>
        <source>a line break or another control character</source>
        <translation>un salto de línea u otro carácter de control</translation>
    </message>
    <message>
        <source>a backslash</source>
        <translation>una barra invertida</translation>
    </message>
    <message>
        <source>cannot be made: %1</source>
        <translation>no se puede crear: %1</translation>
    </message>
    <message>
        <source>is written, but a power cut may undo it: its folder cannot be synchronised: %1</source>
        <translation>está escrito, pero un corte de luz puede deshacerlo: su carpeta no se puede sincronizar: %1</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>no es un archivo corriente</translation>
    </message>
    <message>
        <source>is a link that somebody else put into a folder shared by all</source>
        <translation>es un enlace que otra persona puso en una carpeta compartida por todos</translation>
    </message>
    <message>
        <source>became shorter while it was read</source>
        <translation>se acortó mientras se leía</translation>
    </message>
    <message>
        <source>takes more memory than this machine has to give</source>
        <translation>necesita más memoria de la que tiene este equipo</translation>
    </message>
    <message>
        <source>is a name that is not UTF-8</source>
        <translation>es un nombre que no es UTF-8</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>Permiso denegado</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>Operación no permitida</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>No queda espacio en el dispositivo</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>Se superó la cuota de disco</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Sistema de archivos de solo lectura</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>El nombre del archivo es demasiado largo</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>El archivo existe</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>No es una carpeta</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>Es una carpeta</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>Demasiados archivos abiertos</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Error de entrada/salida</translation>
    </message>
    <message>
        <source>Too many levels of symbolic links</source>
        <translation>Demasiados niveles de enlaces simbólicos</translation>
    </message>
    <message>
        <source>a record has too few bytes for its values</source>
        <translation>un registro tiene muy pocos bytes para sus valores</translation>
    </message>
    <message>
        <source>a record is smaller than its values</source>
        <translation>un registro es menor que sus valores</translation>
    </message>
    <message>
        <source>a record reaches beyond its parent</source>
        <translation>un registro pasa de su padre</translation>
    </message>
    <message>
        <source>a record ends before the place it states</source>
        <translation>un registro acaba antes del lugar que indica</translation>
    </message>
    <message>
        <source>a value reaches beyond its record</source>
        <translation>un valor pasa de su registro</translation>
    </message>
    <message>
        <source>ends within a record</source>
        <translation>acaba dentro de un registro</translation>
    </message>
    <message>
        <source>ends within an array</source>
        <translation>acaba dentro de una matriz</translation>
    </message>
    <message>
        <source>ends within a value</source>
        <translation>acaba dentro de un valor</translation>
    </message>
    <message>
        <source>ends within a text</source>
        <translation>acaba dentro de un texto</translation>
    </message>
    <message>
        <source>has a value of an unknown type</source>
        <translation>tiene un valor de un tipo desconocido</translation>
    </message>
    <message>
        <source>has a value outside of records</source>
        <translation>tiene un valor fuera de los registros</translation>
    </message>
    <message>
        <source>closes a record that is not open</source>
        <translation>cierra un registro que no está abierto</translation>
    </message>
    <message>
        <source>is not pictured in the report: %1</source>
        <translation>no aparece dibujado en el informe: %1</translation>
    </message>
    <message>
        <source>opens a record without a name</source>
        <translation>abre un registro sin nombre</translation>
    </message>
    <message>
        <source>a finer tier without MOTN</source>
        <translation>un nivel más fino sin MOTN</translation>
    </message>
    <message>
        <source>the first tier does not end where TIER says</source>
        <translation>el primer nivel no acaba donde dice TIER</translation>
    </message>
    <message>
        <source>the file ends within a tier</source>
        <translation>el archivo termina dentro de un nivel</translation>
    </message>
    <message>
        <source>a tier is damaged: its checksum differs</source>
        <translation>un nivel está dañado: su suma de comprobación difiere</translation>
    </message>
    <message>
        <source>the sizes of the segments do not add up to MOTN or to a finer tier</source>
        <translation>los tamaños de los segmentos no suman MOTN ni un nivel más fino</translation>
    </message>
</context>
<context>
    <name>mocapress::Session</name>
    <message>
        <source>Import Options</source>
        <translation>Opciones de importación</translation>
    </message>
    <message>
        <source>Character</source>
        <translation>Personaje</translation>
    </message>
</context>
<context>
    <name>mocapress::SettingsField</name>
    <message>
        <source>Target</source>
        <translation>Objetivo</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>Weighting</source>
        <translation>Ponderación</translation>
    </message>
    <message>
        <source>Coding</source>
        <translation>Codificación</translation>
    </message>
    <message>
        <source>Held Feet</source>
        <translation>Pies sujetos</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Contactos</translation>
    </message>
    <message>
        <source>A or B</source>
        <translation>A o B</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Ajustes</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Preajuste</translation>
    </message>
    <message>
        <source>Effort</source>
        <translation>Esfuerzo</translation>
    </message>
    <message>
        <source>Importance</source>
        <translation>Importancia</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Extremos</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>Pistas</translation>
    </message>
    <message>
        <source>Care in a Range</source>
        <translation>Cuidado en un intervalo</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Bucle</translation>
    </message>
    <message>
        <source>Viewing Distance</source>
        <translation>Distancia de observación</translation>
    </message>
    <message>
        <source>Limits of Visibility</source>
        <translation>Límites de visibilidad</translation>
    </message>
</context>
<context>
    <name>mocapress::Sight</name>
    <message>
        <source>not visible</source>
        <translation>no visible</translation>
    </message>
    <message>
        <source>borderline</source>
        <translation>en el límite</translation>
    </message>
    <message>
        <source>visible</source>
        <translation>visible</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>velocidad</translation>
    </message>
    <message>
        <source>place about the body</source>
        <translation>posición respecto al cuerpo</translation>
    </message>
    <message>
        <source>trembling</source>
        <translation>temblor</translation>
    </message>
    <message>
        <source>sliding foot</source>
        <translation>pie que desliza</translation>
    </message>
    <message>
        <source>floating foot</source>
        <translation>pie que flota</translation>
    </message>
    <message>
        <source>below the floor</source>
        <translation>bajo el suelo</translation>
    </message>
    <message>
        <source>flight</source>
        <translation>vuelo</translation>
    </message>
    <message>
        <source>turned head</source>
        <translation>cabeza girada</translation>
    </message>
    <message>
        <source>turned hand</source>
        <translation>mano girada</translation>
    </message>
    <message>
        <source>%1: %2 %3, noticed from %4</source>
        <translation>%1: %2 %3, se nota a partir de %4</translation>
    </message>
    <message>
        <source>%1 from %L2 m</source>
        <translation>%1 a %L2 m</translation>
    </message>
</context>
<context>
    <name>mocapress::SightStrip</name>
    <message>
        <source>Visible errors</source>
        <translation>Errores visibles</translation>
    </message>
    <message>
        <source>Times at which errors are visible. The heat map shows them by joint.</source>
        <translation>Momentos en que los errores son visibles. El mapa de calor los muestra por articulación.</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Visto</translation>
    </message>
    <message>
        <source>Times at which errors are visible (full column) or borderline (half a column).</source>
        <translation>Momentos en que los errores son visibles (columna entera) o están en el límite (media columna).</translation>
    </message>
    <message>
        <source>%1, frame %L2</source>
        <translation>%1, fotograma %L2</translation>
    </message>
</context>
<context>
    <name>mocapress::SignOffExport</name>
    <message>
        <source>Export Sign-off</source>
        <translation>Exportar visto bueno</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Páginas web (*.html)</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tablas (*.csv)</translation>
    </message>
    <message>
        <source>Exported %1.</source>
        <translation>%1 exportado.</translation>
    </message>
</context>
<context>
    <name>mocapress::SlideModel</name>
    <message>
        <source>%L1–%L2</source>
        <translation>%L1–%L2</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Articulación</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Fotogramas</translation>
    </message>
    <message>
        <source>Frames in which the foot of the original stands on the ground.</source>
        <translation>Fotogramas en los que el pie del original se apoya en el suelo.</translation>
    </message>
    <message>
        <source>cm/s</source>
        <translation>cm/s</translation>
    </message>
    <message>
        <source>Highest speed over the ground.</source>
        <translation>Mayor velocidad sobre el suelo.</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Deriva</translation>
    </message>
    <message>
        <source>Largest distance between the foot and its place in the original.</source>
        <translation>Mayor distancia entre el pie y su lugar en el original.</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Recorrido</translation>
    </message>
    <message>
        <source>Path of the foot over the ground beyond the original&apos;s. A foot that trembles in place has a long path.</source>
        <translation>Recorrido del pie por el suelo más allá del original. Un pie que tiembla en su sitio tiene un recorrido largo.</translation>
    </message>
</context>
<context>
    <name>mocapress::SlotControl</name>
    <message>
        <source>Settings %1</source>
        <translation>Ajustes %1</translation>
    </message>
    <message>
        <source>Two settings to compare: tune one, switch to the other (A), and compare the results.</source>
        <translation>Dos juegos de ajustes para comparar: afine uno, pase al otro (A) y compare los resultados.</translation>
    </message>
    <message>
        <source>Copy settings to the other</source>
        <translation>Copiar los ajustes al otro</translation>
    </message>
    <message>
        <source>%1   %2</source>
        <translation>%1   %2</translation>
    </message>
    <message>
        <source>→ %1</source>
        <translation>→ %1</translation>
    </message>
    <message>
        <source>Copy these settings to %1</source>
        <translation>Copiar estos ajustes a %1</translation>
    </message>
</context>
<context>
    <name>mocapress::StudyClips</name>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Clips of the study</source>
        <translation>Clips del estudio</translation>
    </message>
    <message>
        <source>Drop files or folders here.</source>
        <translation>Suelte aquí archivos o carpetas.</translation>
    </message>
    <message>
        <source>Add Files…</source>
        <translation>Añadir archivos…</translation>
    </message>
    <message>
        <source>Add motions</source>
        <translation>Añadir movimientos</translation>
    </message>
    <message>
        <source>Add Folder…</source>
        <translation>Añadir carpeta…</translation>
    </message>
    <message>
        <source>Add every motion below a folder</source>
        <translation>Añadir todos los movimientos de una carpeta y sus subcarpetas</translation>
    </message>
    <message>
        <source>Remove the selected clips from the list (Del)</source>
        <translation>Quitar de la lista los clips seleccionados (Supr)</translation>
    </message>
</context>
<context>
    <name>mocapress::StudyPanel</name>
    <message>
        <source>Also with feet held</source>
        <translation>También con los pies sujetos</translation>
    </message>
    <message>
        <source>Progress of the study</source>
        <translation>Avance del estudio</translation>
    </message>
    <message>
        <source>Measurements that are already there are kept.</source>
        <translation>Las medidas que ya existen se conservan.</translation>
    </message>
    <message>
        <source>Clips</source>
        <translation>Clips</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>Métodos</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Objetivos</translation>
    </message>
    <message>
        <source>Methods of the study</source>
        <translation>Métodos del estudio</translation>
    </message>
    <message>
        <source>IK ratio of the study</source>
        <translation>Tasa IK del estudio</translation>
    </message>
    <message>
        <source>Coefficient ratio of the IK correction (r_IK).</source>
        <translation>Tasa de coeficientes de la corrección IK (r_IK).</translation>
    </message>
    <message>
        <source>:1</source>
        <translation>:1</translation>
    </message>
    <message>
        <source>Ratios to reach</source>
        <translation>Tasas que alcanzar</translation>
    </message>
    <message>
        <source>Compression ratios, separated by spaces.</source>
        <translation>Tasas de compresión, separadas por espacios.</translation>
    </message>
    <message>
        <source>Errors to keep, in cm</source>
        <translation>Errores que mantener, en cm</translation>
    </message>
    <message>
        <source>Errors eps_x to compress to, in centimetres, separated by spaces.</source>
        <translation>Errores eps_x a los que comprimir, en centímetros, separados por espacios.</translation>
    </message>
    <message>
        <source>Weighting of the study</source>
        <translation>Ponderación del estudio</translation>
    </message>
    <message>
        <source>Ratios</source>
        <translation>Tasas</translation>
    </message>
    <message>
        <source>Errors (cm)</source>
        <translation>Errores (cm)</translation>
    </message>
    <message>
        <source>Weighting</source>
        <translation>Ponderación</translation>
    </message>
    <message>
        <source>Kept in</source>
        <translation>Se guarda en</translation>
    </message>
    <message>
        <source>This computer&apos;s cache</source>
        <translation>Caché de este ordenador</translation>
    </message>
    <message>
        <source>Folder of the study: %1</source>
        <translation>Carpeta del estudio: %1</translation>
    </message>
    <message>
        <source>Folder for measurements, from which a stopped study continues. Click to choose a folder; if it holds a study, that study is shown.
%1</source>
        <translation>Carpeta de las medidas, desde la que continúa un estudio detenido. Haga clic para elegir una carpeta; si contiene un estudio, se muestra.
%1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Run Study</source>
        <translation>Ejecutar estudio</translation>
    </message>
    <message>
        <source>Adds a curve of annealed wavelets with feet held by inverse kinematics, at the same ratios.</source>
        <translation>Añade una curva de ondículas recocidas con los pies sujetos por cinemática inversa, a las mismas tasas.</translation>
    </message>
    <message>
        <source>Points on which the error eps_x is measured. Surface: a body modelled around the bones, so that turned heads and hands count. Shell: three points 3 cm from every joint, as in ACL. Bone ends and joint origins: points on the bones, weighted by bone length; joint origins are the paper&apos;s.</source>
        <translation>Puntos en los que se mide el error eps_x. Superficie: un cuerpo modelado alrededor de los huesos, para que cuenten las cabezas y manos giradas. Envoltura: tres puntos a 3 cm de cada articulación, como en ACL. Extremos de huesos y orígenes de articulaciones: puntos en los huesos, ponderados por su longitud; los orígenes de articulaciones son los del artículo.</translation>
    </message>
</context>
<context>
    <name>mocapress::StudyResults</name>
    <message>
        <source>Clips shown</source>
        <translation>Clips mostrados</translation>
    </message>
    <message>
        <source>Show one clip, or the average: the geometric mean of all clips&apos; ratios at equal error, with the points of all clips behind it.</source>
        <translation>Mostrar un clip, o la media: la media geométrica de las tasas de todos los clips con el mismo error, con los puntos de todos los clips detrás.</translation>
    </message>
    <message>
        <source>S&amp;how</source>
        <translation>M&amp;ostrar</translation>
    </message>
    <message>
        <source>%1
Click to load it into the studio.</source>
        <translation>%1
Haga clic para cargarlo en Studio.</translation>
    </message>
    <message>
        <source>Rows of the study</source>
        <translation>Filas del estudio</translation>
    </message>
    <message numerus="yes">
        <source>Average over %Ln clip(s)</source>
        <translation>
            <numerusform>Media de %Ln clip</numerusform>
            <numerusform>Media de %Ln clips</numerusform>
        </translation>
    </message>
    <message>
        <source>All clips</source>
        <translation>Todos los clips</translation>
    </message>
</context>
<context>
    <name>mocapress::StudyRowsModel</name>
    <message>
        <source>%L1:1</source>
        <translation>%L1:1</translation>
    </message>
    <message>
        <source>r = %L1</source>
        <translation>r = %L1</translation>
    </message>
    <message>
        <source>%L1 cm</source>
        <translation>%L1 cm</translation>
    </message>
    <message>
        <source>max %L1 cm</source>
        <translation>máx. %L1 cm</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1:1, %2</source>
        <translation>%1:1, %2</translation>
    </message>
    <message>
        <source>eps_x %1 cm, at most %2 cm</source>
        <translation>eps_x %1 cm, como máximo %2 cm</translation>
    </message>
    <message numerus="yes">
        <source>%1 cm of footskate in %Ln contact(s)</source>
        <translation>
            <numerusform>%1 cm de deslizamiento en %Ln contacto</numerusform>
            <numerusform>%1 cm de deslizamiento en %Ln contactos</numerusform>
        </translation>
    </message>
    <message>
        <source>Asked for %1.</source>
        <translation>Pedido: %1.</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Clip</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>Asked</source>
        <translation>Pedido</translation>
    </message>
    <message>
        <source>Target: a ratio, or the largest error allowed.</source>
        <translation>Objetivo: una tasa, o el mayor error permitido.</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Tasa</translation>
    </message>
    <message>
        <source>Bytes of the channels as 32-bit floats, divided by compressed bytes.</source>
        <translation>Bytes de los canales como flotantes de 32 bits, divididos por los bytes comprimidos.</translation>
    </message>
    <message>
        <source>eps_x cm</source>
        <translation>eps_x cm</translation>
    </message>
    <message>
        <source>Weighted root mean square error.</source>
        <translation>Error cuadrático medio ponderado.</translation>
    </message>
    <message>
        <source>Max cm</source>
        <translation>Máx. cm</translation>
    </message>
    <message>
        <source>Largest error of any point at any frame.</source>
        <translation>Mayor error de cualquier punto en cualquier fotograma.</translation>
    </message>
    <message>
        <source>Slide cm</source>
        <translation>Desliz. cm</translation>
    </message>
    <message>
        <source>Path of feet while they stand in the original.</source>
        <translation>Recorrido de los pies mientras se apoyan en el original.</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Segundos</translation>
    </message>
    <message>
        <source>Time to compress, including the search for the target.</source>
        <translation>Tiempo de compresión, con la búsqueda del objetivo.</translation>
    </message>
    <message>
        <source>%L1 times the noticeable error</source>
        <translation>%L1 veces el error perceptible</translation>
    </message>
</context>
<context>
    <name>mocapress::StudySession</name>
    <message>
        <source>The picture could not be made.</source>
        <translation>No se pudo crear la imagen.</translation>
    </message>
</context>
<context>
    <name>mocapress::StudyStatus</name>
    <message numerus="yes">
        <source>%Ln compression(s) to run</source>
        <translation>
            <numerusform>%Ln compresión por hacer</numerusform>
            <numerusform>%Ln compresiones por hacer</numerusform>
        </translation>
    </message>
    <message>
        <source>%L1 of %L2</source>
        <translation>%L1 de %L2</translation>
    </message>
    <message>
        <source>%1, about %2 left</source>
        <translation>%1, quedan unos %2</translation>
    </message>
    <message numerus="yes">
        <source>, %Ln out of reach</source>
        <translation>
            <numerusform>, %Ln fuera de alcance</numerusform>
            <numerusform>, %Ln fuera de alcance</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %Ln of clips that cannot be read</source>
        <translation>
            <numerusform>, %Ln de clips que no se pueden leer</numerusform>
            <numerusform>, %Ln de clips que no se pueden leer</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln compression(s)%1</source>
        <translation>
            <numerusform>%Ln compresión%1</numerusform>
            <numerusform>%Ln compresiones%1</numerusform>
        </translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>Escribiendo…</translation>
    </message>
    <message>
        <source>Drawing the report…</source>
        <translation>Dibujando el informe…</translation>
    </message>
    <message>
        <source>Cancelled after %L1 of %L2; the next run continues from there</source>
        <translation>Cancelado tras %L1 de %L2; la próxima ejecución continúa desde ahí</translation>
    </message>
    <message>
        <source>Add a clip to study</source>
        <translation>Añada un clip que estudiar</translation>
    </message>
    <message>
        <source>Check a method to study</source>
        <translation>Marque un método que estudiar</translation>
    </message>
    <message>
        <source>Enter a ratio or an error</source>
        <translation>Introduzca una tasa o un error</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Midiendo…</translation>
    </message>
    <message>
        <source>Curves appear after the study has run</source>
        <translation>Las curvas aparecen cuando se ha ejecutado el estudio</translation>
    </message>
</context>
<context>
    <name>mocapress::StudyWindow</name>
    <message>
        <source>Study</source>
        <translation>Estudio</translation>
    </message>
    <message>
        <source>Wrote %1.</source>
        <translation>%1 escrito.</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportar</translation>
    </message>
    <message>
        <source>Write the measurements to a file</source>
        <translation>Escribir las medidas en un archivo</translation>
    </message>
    <message>
        <source>Rows as CSV…</source>
        <translation>Filas como CSV…</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>Valores separados por comas (*.csv)</translation>
    </message>
    <message>
        <source>Plot as PNG…</source>
        <translation>Gráfico como PNG…</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Imágenes (*.png)</translation>
    </message>
    <message>
        <source>Plot as PDF…</source>
        <translation>Gráfico como PDF…</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>Documentos PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Report as HTML…</source>
        <translation>Informe como HTML…</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Páginas web (*.html)</translation>
    </message>
    <message>
        <source>Add Clips</source>
        <translation>Añadir clips</translation>
    </message>
    <message>
        <source>Motion (%1)</source>
        <translation>Movimiento (%1)</translation>
    </message>
    <message>
        <source>Add All Clips below</source>
        <translation>Añadir todos los clips de la carpeta</translation>
    </message>
    <message>
        <source>Folder of the Study</source>
        <translation>Carpeta del estudio</translation>
    </message>
    <message>
        <source>In the studio: %1, %2, %3.</source>
        <translation>En Studio: %1, %2, %3.</translation>
    </message>
</context>
<context>
    <name>mocapress::TargetControl</name>
    <message>
        <source> bytes</source>
        <translation> bytes</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> : 1</source>
        <translation> : 1</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Objetivo</translation>
    </message>
    <message>
        <source>Compression ratio</source>
        <translation>Tasa de compresión</translation>
    </message>
    <message>
        <source>Error (eps_x)</source>
        <translation>Error (eps_x)</translation>
    </message>
    <message>
        <source>Target on a slider</source>
        <translation>Objetivo con un deslizador</translation>
    </message>
    <message>
        <source>Target value</source>
        <translation>Valor del objetivo</translation>
    </message>
    <message>
        <source>Target as a number; type it or use the arrows.</source>
        <translation>El objetivo como número; escríbalo o use las flechas.</translation>
    </message>
    <message>
        <source>Hard maximum</source>
        <translation>Máximo absoluto</translation>
    </message>
    <message>
        <source>Drag to change the target. A draft appears at once and is refined when you pause. What the preset promises of head, hands and fingers is kept beside an error.</source>
        <translation>Arrastre para cambiar el objetivo. Un borrador aparece enseguida y se refina cuando se detiene. Lo que el preajuste promete de cabeza, manos y dedos se mantiene junto a un error.</translation>
    </message>
    <message>
        <source>Problem with the target</source>
        <translation>Problema con el objetivo</translation>
    </message>
    <message>
        <source>The target must be above zero.</source>
        <translation>El objetivo debe ser mayor que cero.</translation>
    </message>
    <message>
        <source> times</source>
        <translation> veces</translation>
    </message>
    <message>
        <source>Visibility</source>
        <translation>Visibilidad</translation>
    </message>
    <message>
        <source>Sizes: the compression ratio (bytes of the channels as 32-bit floats, divided by compressed motion bytes) or the motion bytes themselves. Qualities: the weighted RMS error eps_x, the largest error of any point at any frame, or visibility, the largest error as a multiple of what people notice: at 1, no error is visible.</source>
        <translation>Tamaños: la tasa de compresión (bytes de los canales como flotantes de 32 bits, divididos por los bytes comprimidos del movimiento) o los propios bytes del movimiento. Calidades: el error RMS ponderado eps_x, el mayor error de cualquier punto en cualquier fotograma, o la visibilidad, el mayor error como múltiplo de lo que la gente nota: con 1, ningún error es visible.</translation>
    </message>
    <message>
        <source>Size of the motion</source>
        <translation>Tamaño del movimiento</translation>
    </message>
</context>
<context>
    <name>mocapress::TimeRuler</name>
    <message>
        <source>Time ruler</source>
        <translation>Regla de tiempo</translation>
    </message>
    <message>
        <source>Frames and seconds. The menu Play chooses a range.</source>
        <translation>Fotogramas y segundos. El menú Reproducir elige un intervalo.</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Fotograma</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Segundos</translation>
    </message>
    <message>
        <source>Care</source>
        <translation>Cuidado</translation>
    </message>
    <message>
        <source>Frames %L1–%L2: the target is %L3 times stricter. A click chooses the range.</source>
        <translation>Fotogramas %L1–%L2: el objetivo es %L3 veces más estricto. Un clic elige el intervalo.</translation>
    </message>
    <message>
        <source>Drag to choose a range, then right-click it.</source>
        <translation>Arrastre para elegir un intervalo y haga clic en él con el botón derecho.</translation>
    </message>
    <message>
        <source>Frames %L1–%L2, %3. A double click chooses the whole clip again.</source>
        <translation>Fotogramas %L1–%L2, %3. Un doble clic vuelve a elegir todo el clip.</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
</context>
<context>
    <name>mocapress::Timeline</name>
    <message>
        <source>Visible part of the clip</source>
        <translation>Parte visible del clip</translation>
    </message>
    <message>
        <source>&amp;Poses</source>
        <translation>&amp;Poses</translation>
    </message>
    <message>
        <source>&amp;Bytes</source>
        <translation>&amp;Bytes</translation>
    </message>
    <message>
        <source>&amp;Errors</source>
        <translation>&amp;Errores</translation>
    </message>
    <message>
        <source>Visible E&amp;rrors</source>
        <translation>Errores &amp;visibles</translation>
    </message>
    <message>
        <source>&amp;Notes</source>
        <translation>&amp;Notas</translation>
    </message>
    <message>
        <source>&amp;Contacts</source>
        <translation>&amp;Contactos</translation>
    </message>
</context>
<context>
    <name>mocapress::ToolWindows</name>
    <message>
        <source>The batch of this project is running. Stop it or wait until it ends.</source>
        <translation>El lote de este proyecto está en marcha. Deténgalo o espere a que termine.</translation>
    </message>
</context>
<context>
    <name>mocapress::TransportBar</name>
    <message>
        <source>First Frame</source>
        <translation>Primer fotograma</translation>
    </message>
    <message>
        <source>Previous Frame</source>
        <translation>Fotograma anterior</translation>
    </message>
    <message>
        <source>Play or Pause</source>
        <translation>Reproducir o pausar</translation>
    </message>
    <message>
        <source>Next Frame</source>
        <translation>Fotograma siguiente</translation>
    </message>
    <message>
        <source>Last Frame</source>
        <translation>Último fotograma</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Bucle</translation>
    </message>
    <message>
        <source>Play Backwards; Press Again to Go Faster</source>
        <translation>Reproducir hacia atrás; pulse otra vez para ir más rápido</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Play Forwards; Press Again to Go Faster</source>
        <translation>Reproducir hacia delante; pulse otra vez para ir más rápido</translation>
    </message>
    <message>
        <source>Ten Frames Back</source>
        <translation>Diez fotogramas atrás</translation>
    </message>
    <message>
        <source>Ten Frames On</source>
        <translation>Diez fotogramas adelante</translation>
    </message>
    <message>
        <source>Play from Here</source>
        <translation>Reproducir desde aquí</translation>
    </message>
    <message>
        <source>Play to Here</source>
        <translation>Reproducir hasta aquí</translation>
    </message>
    <message>
        <source>Play the Whole Clip</source>
        <translation>Reproducir todo el clip</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Fotograma</translation>
    </message>
    <message>
        <source>Drag to any frame.</source>
        <translation>Arrastre a cualquier fotograma.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Frame read-out</source>
        <translation>Indicador de fotograma</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Playing speed; 1× is the recorded speed.</source>
        <translation>Velocidad de reproducción; 1× es la velocidad de grabación.</translation>
    </message>
    <message>
        <source>%L1×</source>
        <translation>%L1×</translation>
    </message>
    <message>
        <source>%L1 s</source>
        <translation>%L1 s</translation>
    </message>
    <message>
        <source>%L1 / %L2</source>
        <translation>%L1 / %L2</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>Toma</translation>
    </message>
    <message>
        <source>Animation of the file to read.</source>
        <translation>Animación del archivo que se lee.</translation>
    </message>
</context>
<context>
    <name>mocapress::ViewActions</name>
    <message>
        <source>&amp;Overlay</source>
        <translation>&amp;Superponer</translation>
    </message>
    <message>
        <source>The original as a ghost over the compressed figure</source>
        <translation>El original como fantasma sobre la figura comprimida</translation>
    </message>
    <message>
        <source>&amp;Side by Side</source>
        <translation>&amp;Lado a lado</translation>
    </message>
    <message>
        <source>Original and compressed figure beside each other</source>
        <translation>Figura original y comprimida una junto a otra</translation>
    </message>
    <message>
        <source>&amp;Wipe</source>
        <translation>&amp;Cortinilla</translation>
    </message>
    <message>
        <source>Original on one side of a divider that can be dragged, compressed figure on the other</source>
        <translation>El original a un lado de un separador que se puede arrastrar, la figura comprimida al otro</translation>
    </message>
    <message>
        <source>Sw&amp;ap</source>
        <translation>Intercam&amp;biar</translation>
    </message>
    <message>
        <source>Swap original and compressed figure</source>
        <translation>Intercambiar la figura original y la comprimida</translation>
    </message>
    <message>
        <source>&amp;Blink</source>
        <translation>&amp;Alternar</translation>
    </message>
    <message>
        <source>Original and compressed figure take turns in one place</source>
        <translation>La figura original y la comprimida se turnan en el mismo lugar</translation>
    </message>
    <message>
        <source>Colour by &amp;Error</source>
        <translation>Colorear por &amp;error</translation>
    </message>
    <message>
        <source>Colour every joint by its distance from the original, in cm</source>
        <translation>Colorear cada articulación por su distancia al original, en cm</translation>
    </message>
    <message>
        <source>Show Skin</source>
        <translation>Mostrar piel</translation>
    </message>
    <message>
        <source>Show figures with their skin or as skeletons</source>
        <translation>Mostrar las figuras con su piel o como esqueletos</translation>
    </message>
    <message>
        <source>&amp;Path of the Joint</source>
        <translation>&amp;Trayectoria de la articulación</translation>
    </message>
    <message>
        <source>Path of the selected joint, half a second before and after the current frame</source>
        <translation>Trayectoria de la articulación seleccionada, medio segundo antes y después del fotograma actual</translation>
    </message>
    <message>
        <source>&amp;Follow</source>
        <translation>Se&amp;guir</translation>
    </message>
    <message>
        <source>The camera moves with the figure</source>
        <translation>La cámara se mueve con la figura</translation>
    </message>
    <message>
        <source>I&amp;n Place</source>
        <translation>En el siti&amp;o</translation>
    </message>
    <message>
        <source>Play without the root&apos;s travel over the ground</source>
        <translation>Reproducir sin el desplazamiento de la raíz por el suelo</translation>
    </message>
    <message>
        <source>F&amp;loor View</source>
        <translation>Vista de &amp;planta</translation>
    </message>
    <message>
        <source>Look straight down, as on a plan</source>
        <translation>Mirar en vertical, como en un plano</translation>
    </message>
    <message>
        <source>&amp;Reset Camera</source>
        <translation>&amp;Restablecer la cámara</translation>
    </message>
    <message>
        <source>Look at the whole figure again</source>
        <translation>Volver a mirar la figura entera</translation>
    </message>
    <message>
        <source>Ghost &amp;Trail</source>
        <translation>Estela &amp;fantasma</translation>
    </message>
    <message>
        <source>Faded poses of the compressed figure before (blue) and after (orange) the current frame</source>
        <translation>Poses difuminadas de la figura comprimida antes (azul) y después (naranja) del fotograma actual</translation>
    </message>
    <message numerus="yes">
        <source>%Ln pose(s) before and after</source>
        <translation>
            <numerusform>%Ln pose antes y después</numerusform>
            <numerusform>%Ln poses antes y después</numerusform>
        </translation>
    </message>
    <message>
        <source>Poses of the Tra&amp;il</source>
        <translation>&amp;Poses de la estela</translation>
    </message>
    <message>
        <source>Fo&amp;ur Views</source>
        <translation>C&amp;uatro vistas</translation>
    </message>
    <message>
        <source>The same figures from anywhere, from the front, the side and the top</source>
        <translation>Las mismas figuras desde cualquier lado, de frente, de lado y desde arriba</translation>
    </message>
    <message>
        <source>E&amp;xaggerate the Difference</source>
        <translation>E&amp;xagerar la diferencia</translation>
    </message>
    <message>
        <source>Show poses and paths with a difference from the original that is so many times larger than it is</source>
        <translation>Mostrar poses y trayectorias con una diferencia con el original tantas veces mayor de lo que es</translation>
    </message>
    <message>
        <source>%L1 times</source>
        <translation>%L1 veces</translation>
    </message>
    <message>
        <source>From the Fro&amp;nt</source>
        <translation>De fr&amp;ente</translation>
    </message>
    <message>
        <source>Look along the z axis; again: as before</source>
        <translation>Mirar a lo largo del eje z; otra vez: como antes</translation>
    </message>
    <message>
        <source>From the S&amp;ide</source>
        <translation>&amp;De lado</translation>
    </message>
    <message>
        <source>Look along the x axis; again: as before</source>
        <translation>Mirar a lo largo del eje x; otra vez: como antes</translation>
    </message>
    <message>
        <source>Frame &amp;Joint</source>
        <translation>Encuadrar la art&amp;iculación</translation>
    </message>
    <message>
        <source>Look at the selected joint, or at the whole figure without one</source>
        <translation>Mirar la articulación seleccionada, o la figura entera si no hay ninguna</translation>
    </message>
    <message>
        <source>Camera &amp;%L1</source>
        <translation>Cámara &amp;%L1</translation>
    </message>
    <message>
        <source>Look from where the camera was when it was kept</source>
        <translation>Mirar desde donde estaba la cámara cuando se guardó</translation>
    </message>
    <message>
        <source>Keep as Camera %L1</source>
        <translation>Guardar como cámara %L1</translation>
    </message>
    <message>
        <source>Keep the camera&apos;s place, relative to the figure</source>
        <translation>Guardar la posición de la cámara respecto a la figura</translation>
    </message>
    <message>
        <source>Exaggeration</source>
        <translation>Exageración</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Cámaras</translation>
    </message>
</context>
<context>
    <name>mocapress::ViewPictures</name>
    <message>
        <source>Making the video…</source>
        <translation>Creando el vídeo…</translation>
    </message>
    <message>
        <source>Wrote %1.</source>
        <translation>%1 escrito.</translation>
    </message>
    <message>
        <source>The 3D view gave no picture.</source>
        <translation>La vista 3D no dio ninguna imagen.</translation>
    </message>
    <message>
        <source>Copied the picture of the view.</source>
        <translation>Imagen de la vista copiada.</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Guardar imagen</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Imágenes (*.png)</translation>
    </message>
    <message>
        <source>Film of the Range</source>
        <translation>Película del intervalo</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Vuelta completa</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.webm *.gif)</source>
        <translation>Vídeos (*.mp4 *.webm *.gif)</translation>
    </message>
    <message>
        <source>Numbered pictures in a folder (*.png)</source>
        <translation>Imágenes numeradas en una carpeta (*.png)</translation>
    </message>
    <message numerus="yes">
        <source>Taking %Ln picture(s)…</source>
        <translation>
            <numerusform>Tomando %Ln imagen…</numerusform>
            <numerusform>Tomando %Ln imágenes…</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
</context>
<context>
    <name>mocapress::Viewport</name>
    <message>
        <source>The 3D view needs OpenGL 3.2, which is not available here.</source>
        <translation>La vista 3D necesita OpenGL 3.2, que no está disponible aquí.</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>Vista 3D</translation>
    </message>
</context>
</TS>
