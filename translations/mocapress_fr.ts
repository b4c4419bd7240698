<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr">
<context>
    <name>mocapress::Actions</name>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>Open a motion or a compressed clip (.mcpr)</source>
        <translation>Ouvrir un mouvement ou un clip compressé (.mcpr)</translation>
    </message>
    <message>
        <source>Open Sample &amp;Walk</source>
        <translation>Ouvrir la &amp;marche d&apos;exemple</translation>
    </message>
    <message>
        <source>Choose Skeleton…</source>
        <translation>Choisir le squelette…</translation>
    </message>
    <message>
        <source>&amp;Compare with Original…</source>
        <translation>&amp;Comparer à l&apos;original…</translation>
    </message>
    <message>
        <source>Save the compressed clip as .mcpr</source>
        <translation>Enregistrer le clip compressé en .mcpr</translation>
    </message>
    <message>
        <source>A&amp;dd Clips to Library…</source>
        <translation>A&amp;jouter des clips…</translation>
    </message>
    <message>
        <source>&amp;New Project</source>
        <translation>&amp;Nouveau projet</translation>
    </message>
    <message>
        <source>Open Pro&amp;ject…</source>
        <translation>Ouvrir un &amp;projet…</translation>
    </message>
    <message>
        <source>Sa&amp;ve Project As…</source>
        <translation>Enre&amp;gistrer le projet sous…</translation>
    </message>
    <message>
        <source>Switch between &amp;A and B</source>
        <translation>Passer de A à &amp;B</translation>
    </message>
    <message>
        <source>&amp;Copy Settings to the Other</source>
        <translation>&amp;Copier les réglages vers l&apos;autre</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>Next &amp;Worst Frame</source>
        <translation>Pire image &amp;suivante</translation>
    </message>
    <message>
        <source>Go to the frame with the largest error, then to the next largest (N)</source>
        <translation>Aller à l&apos;image de plus grande erreur, encore : à la suivante (N)</translation>
    </message>
    <message>
        <source>P&amp;revious Worst Frame</source>
        <translation>Pire image p&amp;récédente</translation>
    </message>
    <message>
        <source>&amp;Hold Feet</source>
        <translation>Tenir &amp;les pieds</translation>
    </message>
    <message>
        <source>Compress with or without inverse kinematics (I)</source>
        <translation>Compresser avec ou sans cinématique inverse (I)</translation>
    </message>
    <message>
        <source>Without I&amp;K</source>
        <translation>Sans &amp;IK</translation>
    </message>
    <message>
        <source>Show the compressed figure without the IK correction of its feet (B)</source>
        <translation>Voir la figure compressée avant que ses pieds soient tenus (B)</translation>
    </message>
    <message>
        <source>Reset La&amp;yout</source>
        <translation>Rétablir la disp&amp;osition</translation>
    </message>
    <message>
        <source>&amp;Study…</source>
        <translation>&amp;Étude…</translation>
    </message>
    <message>
        <source>Compare the file sizes and errors of methods on many clips</source>
        <translation>Comparer les méthodes sur beaucoup de clips : taille contre erreur</translation>
    </message>
    <message>
        <source>&amp;Guide</source>
        <translation>&amp;Guide</translation>
    </message>
    <message>
        <source>&amp;Keyboard Shortcuts</source>
        <translation>&amp;Raccourcis clavier</translation>
    </message>
    <message>
        <source>Like the &amp;System</source>
        <translation>Comme le &amp;système</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Clair</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>S&amp;ombre</translation>
    </message>
    <message>
        <source>&amp;About Mocapress</source>
        <translation>À &amp;propos de Mocapress</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Fichiers &amp;récents</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Édition</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Lecture</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>The&amp;me</source>
        <translation>Thè&amp;me</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>Lan&amp;gue</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Outils</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Aid&amp;e</translation>
    </message>
    <message>
        <source>&amp;Batch Export…</source>
        <translation>Exportation par &amp;lot…</translation>
    </message>
    <message>
        <source>Compress many clips, verify each of them and write a report</source>
        <translation>Compresser de nombreux clips, vérifier chacun et rendre compte de tous</translation>
    </message>
    <message>
        <source>Batch Export of the &amp;Library…</source>
        <translation>Exportation par lot de la &amp;bibliothèque…</translation>
    </message>
    <message>
        <source>Export all clips of the library, each with its own settings</source>
        <translation>Exporter tous les clips de la bibliothèque, chacun avec ses propres réglages</translation>
    </message>
    <message>
        <source>Add &amp;Folder to Library…</source>
        <translation>Ajouter un &amp;dossier à la bibliothèque…</translation>
    </message>
    <message>
        <source>&amp;Pin This Result</source>
        <translation>É&amp;pingler ce résultat</translation>
    </message>
    <message>
        <source>Keep this result in the view beside results of other settings (D)</source>
        <translation>Garder ce résultat en vue à côté de ceux d&apos;autres réglages (D)</translation>
    </message>
    <message>
        <source>Error S&amp;cale</source>
        <translation>Éc&amp;helle d&apos;erreur</translation>
    </message>
    <message>
        <source>Recent Projec&amp;ts</source>
        <translation>Proje&amp;ts récents</translation>
    </message>
    <message>
        <source>Save as .mcpr, .bvh, .fbx, .glb, .amc with its .asf, or .csv</source>
        <translation>Enregistrer en .mcpr, .bvh, .fbx, .glb, .amc avec son .asf, ou .csv</translation>
    </message>
    <message>
        <source>E&amp;xport Motion…</source>
        <translation>E&amp;xporter le mouvement…</translation>
    </message>
    <message>
        <source>Write the decompressed motion with the unit, axes and rate of its source</source>
        <translation>Écrire le mouvement issu du clip compressé, sous la forme de sa source</translation>
    </message>
    <message>
        <source>Export Review Pa&amp;ge…</source>
        <translation>Exporter la page &amp;web de revue…</translation>
    </message>
    <message>
        <source>Write a web page that shows original and compressed clip</source>
        <translation>Écrire une page qui montre l’original et le clip compressé dans un navigateur</translation>
    </message>
    <message>
        <source>&amp;Import Options…</source>
        <translation>Options d’&amp;importation…</translation>
    </message>
    <message>
        <source>Read the open motion again with another length unit, up axis, frame rate or root convention</source>
        <translation>Relire le mouvement ouvert avec une autre unité, un autre axe vertical, une autre cadence ou une autre racine</translation>
    </message>
    <message>
        <source>Put a C&amp;haracter on It…</source>
        <translation>&amp;Habiller d’un personnage…</translation>
    </message>
    <message>
        <source>Show the clip, and all clips with the same rig, on the mesh of an FBX or glTF whose joints have the same names</source>
        <translation>Montrer le clip, et tous les clips de son squelette, avec la peau d’un FBX ou glTF dont les articulations portent les mêmes noms</translation>
    </message>
    <message>
        <source>Ta&amp;ke Its Character Off</source>
        <translation>Retirer son personn&amp;age</translation>
    </message>
    <message>
        <source>Show the clip, and all clips with the same rig, as in their files</source>
        <translation>Montrer le clip, et tous les clips de son squelette, comme leurs fichiers le disent</translation>
    </message>
    <message>
        <source>Angle Scale</source>
        <translation>Échelle d&apos;angle</translation>
    </message>
    <message>
        <source>Colours and S&amp;cales</source>
        <translation>Couleu&amp;rs et échelles</translation>
    </message>
    <message>
        <source>Pane&amp;ls</source>
        <translation>Pannea&amp;ux</translation>
    </message>
    <message>
        <source>&amp;Save Compressed Clip</source>
        <translation>&amp;Enregistrer le clip compressé</translation>
    </message>
    <message>
        <source>Save Compressed Clip &amp;As…</source>
        <translation>Enregistrer le clip compressé &amp;sous…</translation>
    </message>
    <message>
        <source>Next to &amp;Review</source>
        <translation>&amp;Suivant à relire</translation>
    </message>
    <message>
        <source>Open the next clip that waits for a verdict (Q)</source>
        <translation>Ouvrir le clip suivant qui attend un verdict (Q)</translation>
    </message>
    <message>
        <source>&amp;Approve, and Next</source>
        <translation>&amp;Approuver, puis le suivant</translation>
    </message>
    <message>
        <source>Re&amp;ject, and Next</source>
        <translation>Re&amp;jeter, puis le suivant</translation>
    </message>
    <message>
        <source>&amp;Note on This Frame…</source>
        <translation>&amp;Note sur cette image…</translation>
    </message>
    <message>
        <source>Next No&amp;te</source>
        <translation>No&amp;te suivante</translation>
    </message>
    <message>
        <source>&amp;Review</source>
        <translation>&amp;Revue</translation>
    </message>
    <message>
        <source>Ex&amp;port Sign-off…</source>
        <translation>Exporter la &amp;validation…</translation>
    </message>
    <message>
        <source>Write verdicts, worst frames and notes of the library as HTML, PDF or CSV</source>
        <translation>Écrire verdicts, pires images et notes de la bibliothèque en HTML, PDF ou CSV</translation>
    </message>
    <message>
        <source>Write a note on the frame that is shown and the joint that is chosen. A click with Ctrl in the picture writes one on a place there.</source>
        <translation>Écrire une note sur l&apos;image montrée et l&apos;articulation choisie. Un clic avec Ctrl dans l&apos;image en écrit une à cet endroit.</translation>
    </message>
    <message>
        <source>&amp;Write Notes beside the Clips</source>
        <translation>É&amp;crire les notes à côté des clips</translation>
    </message>
    <message>
        <source>Write the notes of each clip to NAME.notes.json in its folder</source>
        <translation>Écrire les notes de chaque clip dans NOM.notes.json, dans son dossier</translation>
    </message>
    <message>
        <source>Rea&amp;d Notes beside the Clips</source>
        <translation>&amp;Lire les notes à côté des clips</translation>
    </message>
    <message>
        <source>Add notes from the files NAME.notes.json beside the clips</source>
        <translation>Ajouter les notes des fichiers NOM.notes.json à côté des clips</translation>
    </message>
    <message>
        <source>Copy &amp;Link to This Frame</source>
        <translation>Copier le l&amp;ien vers cette image</translation>
    </message>
    <message>
        <source>Copy a link that opens this clip, frame, joint and view</source>
        <translation>Copier un lien qui ouvre ce clip, cette image, cette articulation et cette vue</translation>
    </message>
    <message>
        <source>&amp;Blind Test…</source>
        <translation>Test à l&apos;a&amp;veugle…</translation>
    </message>
    <message>
        <source>Find out from which error on you tell the compressed clip from the original</source>
        <translation>Trouver à partir de quelle erreur vous distinguez le clip compressé de l&apos;original</translation>
    </message>
    <message>
        <source>Copy Pict&amp;ure of the View</source>
        <translation>Copier l&apos;&amp;image de la vue</translation>
    </message>
    <message>
        <source>Save Picture of the &amp;View…</source>
        <translation>Enregistrer l&apos;image de la &amp;vue…</translation>
    </message>
    <message>
        <source>&amp;Film of the Range…</source>
        <translation>&amp;Film de la plage…</translation>
    </message>
    <message>
        <source>Write the chosen range, or the clip, as a video or as numbered pictures</source>
        <translation>Écrire la plage choisie, ou le clip, en vidéo ou en images numérotées</translation>
    </message>
    <message>
        <source>&amp;Turntable…</source>
        <translation>&amp;Tour complet…</translation>
    </message>
    <message>
        <source>Write this frame from all sides as a video or as numbered pictures</source>
        <translation>Écrire cette image vue de tous les côtés, en vidéo ou en images numérotées</translation>
    </message>
    <message>
        <source>&amp;Find a Command…</source>
        <translation>&amp;Chercher une commande…</translation>
    </message>
    <message>
        <source>Keyboard &amp;Map…</source>
        <translation>Raccourcis per&amp;sonnels…</translation>
    </message>
    <message>
        <source>Choose the keys of all commands</source>
        <translation>Choisir les touches de toutes les commandes</translation>
    </message>
    <message>
        <source>Pict&amp;ures and Films</source>
        <translation>Images et &amp;films</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Ligne de temps</translation>
    </message>
    <message>
        <source>Pin What an &amp;Engine Would Do</source>
        <translation>Épingler ce que ferait un &amp;moteur</translation>
    </message>
    <message>
        <source>Compress the clip track by track, with key frames, to the same number of bytes, and show it beside this result</source>
        <translation>Compresser le clip piste par piste, avec des images clés, au même nombre d&apos;octets, et le montrer à côté de ce résultat</translation>
    </message>
    <message>
        <source>Fold Panels Below</source>
        <translation>Replier les panneaux du bas</translation>
    </message>
    <message>
        <source>Fold the panels below the timeline to their tabs, or unfold them</source>
        <translation>Replier les panneaux sous la ligne de temps sur leurs onglets, ou les déplier</translation>
    </message>
    <message>
        <source>Compare in the Ran&amp;ge</source>
        <translation>Comparer &amp;dans la plage</translation>
    </message>
    <message>
        <source>Loop the chosen range with both figures side by side, and show its errors alone</source>
        <translation>Jouer la plage choisie en boucle, les deux figures côte à côte, et montrer ses erreurs seules</translation>
    </message>
    <message>
        <source>Co&amp;mpare Library with a Batch…</source>
        <translation>Comparer la bibliothèq&amp;ue à un lot…</translation>
    </message>
    <message>
        <source>Show what got larger, worse or newly visible since an earlier batch or project</source>
        <translation>Montrer ce qui est plus gros, pire ou visible depuis un lot ou projet antérieur</translation>
    </message>
    <message>
        <source>Note on the Ran&amp;ge…</source>
        <translation>Note sur la &amp;plage…</translation>
    </message>
    <message>
        <source>Write a note on the chosen range and the joint that is chosen</source>
        <translation>Écrit une note sur la plage et l&apos;articulation choisies</translation>
    </message>
</context>
<context>
    <name>mocapress::AnnealingPanel</name>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Progress of the refinement</source>
        <translation>Avancement de l&apos;affinage</translation>
    </message>
    <message>
        <source>Stop refining. The best result so far is kept if it is better than the draft.</source>
        <translation>Arrêter l&apos;affinage. Le meilleur résultat obtenu est gardé s&apos;il vaut mieux que l&apos;ébauche.</translation>
    </message>
    <message>
        <source>%L1 s left</source>
        <translation>encore %L1 s</translation>
    </message>
    <message>
        <source>%L1 min left</source>
        <translation>encore %L1 min</translation>
    </message>
    <message>
        <source>Progress of refining the draft. Annealing moves fewer and fewer coefficients at a time; the closed loop sweeps over all coefficients until no change helps. Most targets need several passes, whose number is an estimate.</source>
        <translation>L&apos;ébauche est affinée : le recuit déplace de moins en moins de coefficients à la fois, une boucle fermée les parcourt tous, jusqu&apos;à ce que plus rien n&apos;aide. La plupart des cibles demandent plusieurs passes ; leur nombre reste une estimation jusqu&apos;à la dernière.</translation>
    </message>
    <message>
        <source>Time left</source>
        <translation>Temps restant</translation>
    </message>
</context>
<context>
    <name>mocapress::BatchOutput</name>
    <message>
        <source>Replace existing files</source>
        <translation>Remplacer les fichiers présents</translation>
    </message>
    <message>
        <source>Pattern of file names</source>
        <translation>Modèle des noms</translation>
    </message>
    <message>
        <source>If this is off, a clip fails when its file exists and is not from this batch. A file is replaced only after the new one was read back and measured.</source>
        <translation>Sinon, un clip dont le fichier existe déjà sans être de ce lot échoue et le dit. Dans tous les cas, un fichier n&apos;est remplacé qu&apos;après relecture et mesure du nouveau.</translation>
    </message>
    <message>
        <source>Compressed (.mcpr)</source>
        <translation>Compressé (.mcpr)</translation>
    </message>
    <message>
        <source>The compressed file, to be shipped.</source>
        <translation>Ce qui est livré.</translation>
    </message>
    <message>
        <source>BVH</source>
        <translation>BVH</translation>
    </message>
    <message>
        <source>The decompressed motion.</source>
        <translation>Le mouvement décompressé.</translation>
    </message>
    <message>
        <source>ASF/AMC</source>
        <translation>ASF/AMC</translation>
    </message>
    <message>
        <source>The decompressed motion and its skeleton.</source>
        <translation>Le mouvement décompressé et son squelette.</translation>
    </message>
    <message>
        <source>CSV</source>
        <translation>CSV</translation>
    </message>
    <message>
        <source>The decompressed channels as a table.</source>
        <translation>Les canaux décompressés en tableau.</translation>
    </message>
    <message>
        <source>FBX</source>
        <translation>FBX</translation>
    </message>
    <message>
        <source>The decompressed motion on its skeleton, for Maya, MotionBuilder and engines.</source>
        <translation>Le mouvement décompressé sur son squelette, pour Maya, MotionBuilder et les moteurs.</translation>
    </message>
    <message>
        <source>glTF (.glb)</source>
        <translation>glTF (.glb)</translation>
    </message>
    <message>
        <source>The decompressed motion on its skeleton, for Blender and engines.</source>
        <translation>Le mouvement décompressé sur son squelette, pour Blender et les moteurs de jeu.</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Noms</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Fichiers</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>Folder of the batch: %1</source>
        <translation>Dossier du lot : %1</translation>
    </message>
    <message>
        <source>Folder for files and report. If it holds a batch, that batch is resumed.</source>
        <translation>Où vont les fichiers et le rapport. Un dossier qui contient un lot reprend là où il en était.</translation>
    </message>
    <message>
        <source>&lt;p&gt;{folder}: the folder that was added, and its subfolders down to the clip&lt;br&gt;{stem}: the clip&apos;s name&lt;br&gt;{type}: the source&apos;s format, such as bvh&lt;br&gt;{preset}, {method}: the preset and method of the clip&lt;/p&gt;</source>
        <translation>&lt;p&gt;{folder} : le dossier par lequel le clip a été trouvé, et ceux entre les deux&lt;br&gt;{stem} : le nom du clip&lt;br&gt;{type} : le format de la source, comme bvh&lt;br&gt;{preset}, {method} : ce par quoi il est compressé&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Bank of all clips</source>
        <translation>Banque de tous les clips</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>Packed</source>
        <translation>Compacte</translation>
    </message>
    <message>
        <source>Cooked</source>
        <translation>Préparée</translation>
    </message>
    <message>
        <source>&lt;p&gt;One more file, bank.mcpk, with all compressed clips.&lt;br&gt;Packed: the smallest, for shipping.&lt;br&gt;Cooked: engines sample its clips without unpacking them.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Tous les fichiers compressés en un seul, bank.mcpk, à côté d&apos;eux.&lt;br&gt;Compacte : la plus petite, pour livrer.&lt;br&gt;Préparée : les moteurs y lisent les clips tels quels.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Bank</source>
        <translation>Banque</translation>
    </message>
    <message>
        <source>Fit the coder to the clips</source>
        <translation>Apprendre de ses clips</translation>
    </message>
    <message>
        <source>Fits the statistics of the coder to the clips of a packed bank. This takes up to a minute and saves 1 to 2 % of the bytes of some hundred clips. A bank of a few clips is not changed.</source>
        <translation>Code les mouvements d&apos;une banque compacte d&apos;après ce que ses clips apprennent les uns des autres : 1 à 2 % d&apos;octets en moins à partir de quelques centaines, pour une minute de plus tout au plus. Quelques clips n&apos;apprennent rien, et leur banque reste telle quelle.</translation>
    </message>
</context>
<context>
    <name>mocapress::BatchQueueModel</name>
    <message>
        <source>Reading</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>Compressing</source>
        <translation>Compression</translation>
    </message>
    <message>
        <source>Verifying</source>
        <translation>Vérification</translation>
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
        <translation>au plus %1 cm</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>En attente</translation>
    </message>
    <message>
        <source>%1, %L2 %</source>
        <translation>%1, %L2 %</translation>
    </message>
    <message>
        <source>✓ Verified</source>
        <translation>✓ Vérifié</translation>
    </message>
    <message>
        <source>✗ %1</source>
        <translation>✗ %1</translation>
    </message>
    <message>
        <source>Locked: the clip keeps its own settings. Click to give it the settings shared by all clips.</source>
        <translation>Verrouillé : garde ses propres réglages. Cliquez pour lui donner ceux que tous partagent.</translation>
    </message>
    <message>
        <source>Click to lock the clip&apos;s settings, so that changes for all clips do not apply to it.</source>
        <translation>Cliquez pour verrouiller ses réglages : un changement pour tous les clips ne le touche plus.</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>verrouillé</translation>
    </message>
    <message>
        <source>not locked</source>
        <translation>non verrouillé</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Clip</translation>
    </message>
    <message>
        <source>Locked clips keep their own settings.</source>
        <translation>Les clips verrouillés gardent leurs propres réglages.</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>The preset and its target.</source>
        <translation>Le préréglage et sa cible.</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Verified: the file was read back, decoded and measured.</source>
        <translation>Vérifié : le fichier a été relu, décodé et mesuré.</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Bytes of the channels as 32-bit floats, divided by compressed bytes.</source>
        <translation>Octets des canaux en flottants 32 bits sur octets compressés.</translation>
    </message>
    <message>
        <source>eps_x cm</source>
        <translation>eps_x cm</translation>
    </message>
    <message>
        <source>Weighted root mean square error.</source>
        <translation>Erreur quadratique moyenne pondérée.</translation>
    </message>
    <message>
        <source>Max cm</source>
        <translation>Max cm</translation>
    </message>
    <message>
        <source>Largest error of any point at any frame.</source>
        <translation>Plus grande erreur d&apos;un point quelconque, toutes images confondues.</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Mise à l&apos;écart</translation>
    </message>
    <message numerus="yes">
        <source>✓ Verified, %Ln warning(s)</source>
        <translation>
            <numerusform>✓ Vérifié, %Ln avertissement</numerusform>
            <numerusform>✓ Vérifié, %Ln avertissements</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>The clip is not exported. Tick it to export it too.</source>
        <translation>Il n&apos;est pas exporté. Cochez le clip pour l&apos;exporter aussi.</translation>
    </message>
    <message>
        <source>Only ticked clips are exported.</source>
        <translation>Seuls les clips cochés sont exportés.</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>not visible</source>
        <translation>invisible</translation>
    </message>
    <message>
        <source>%1 times the noticeable error</source>
        <translation>%1 fois le perceptible</translation>
    </message>
    <message>
        <source>The clip&apos;s verdict in the library. Rejected clips are exported only if they are ticked. A verdict is stale if files or settings have changed since.</source>
        <translation>Ce que la bibliothèque dit du clip. Un clip rejeté reste à l&apos;écart tant qu&apos;il n&apos;est pas coché. Périmé : ce n&apos;est pas à propos de ces fichiers et réglages.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln care range(s)</source>
        <translation>
            <numerusform>%Ln plage soignée</numerusform>
            <numerusform>%Ln plages soignées</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mocapress::BatchQueueView</name>
    <message>
        <source>Clips of the batch</source>
        <translation>Clips du lot</translation>
    </message>
    <message>
        <source>Remove from Queue</source>
        <translation>Retirer de la file d&apos;attente</translation>
    </message>
    <message>
        <source>Drop clips or folders of clips here</source>
        <translation>Déposez ici des clips ou des dossiers de clips</translation>
    </message>
    <message>
        <source>The .asf beside an .amc is found</source>
        <translation>Un .amc trouve son .asf à côté de lui</translation>
    </message>
    <message>
        <source>Leave Out</source>
        <translation>Mettre à l&apos;écart</translation>
    </message>
    <message>
        <source>Export Too</source>
        <translation>Exporter aussi</translation>
    </message>
</context>
<context>
    <name>mocapress::BatchSession</name>
    <message>
        <source>Add clips to begin.</source>
        <translation>Ajoutez des clips pour commencer.</translation>
    </message>
    <message>
        <source>Choose a folder for the files.</source>
        <translation>Choisissez le dossier de destination.</translation>
    </message>
    <message>
        <source>Choose at least one file format.</source>
        <translation>Choisissez au moins un type de fichier.</translation>
    </message>
    <message>
        <source>Wrote %1: submit it with sbatch.</source>
        <translation>%1 écrit : soumettez-le avec sbatch.</translation>
    </message>
    <message>
        <source>Clips can be added after the batch has ended.</source>
        <translation>Des clips peuvent être ajoutés quand le lot est terminé.</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Sortie</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>Remove Clips</source>
        <translation>Retirer des clips</translation>
    </message>
    <message>
        <source>Add Clips</source>
        <translation>Ajouter des clips</translation>
    </message>
    <message>
        <source>Leave Out Clips</source>
        <translation>Mettre des clips à l&apos;écart</translation>
    </message>
    <message>
        <source>Export Clips Too</source>
        <translation>Exporter aussi des clips</translation>
    </message>
    <message>
        <source>Every clip is left out. Tick the clips to export.</source>
        <translation>Tous les clips sont à l&apos;écart. Cochez ceux à exporter.</translation>
    </message>
    <message>
        <source>A bank needs compressed files: choose Compressed (.mcpr) too.</source>
        <translation>Une banque est faite de fichiers compressés : choisissez-les aussi.</translation>
    </message>
    <message>
        <source>A cluster&apos;s tasks cannot make a bank, since none has all clips: set Bank to None to write a script.</source>
        <translation>Aucune tâche n&apos;a tous les clips d&apos;une banque : choisissez « Aucune » pour écrire un script.</translation>
    </message>
    <message>
        <source>Character</source>
        <translation>Personnage</translation>
    </message>
</context>
<context>
    <name>mocapress::BatchStatus</name>
    <message numerus="yes">
        <source>, %Ln failed</source>
        <translation>
            <numerusform>, %Ln échec</numerusform>
            <numerusform>, %Ln échecs</numerusform>
        </translation>
    </message>
    <message>
        <source>%L1 of %L2</source>
        <translation>%L1 sur %L2</translation>
    </message>
    <message>
        <source>%1, about %2 left</source>
        <translation>%1, encore environ %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln clip(s) to export</source>
        <translation>
            <numerusform>%Ln clip à exporter</numerusform>
            <numerusform>%Ln clips à exporter</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln clip(s) exported and verified</source>
        <translation>
            <numerusform>%Ln clip exporté et vérifié</numerusform>
            <numerusform>%Ln clips exportés et vérifiés</numerusform>
        </translation>
    </message>
    <message>
        <source>Paused at %1</source>
        <translation>En pause à %1</translation>
    </message>
    <message>
        <source>Stopping after the current clips: %1</source>
        <translation>Arrêt après les clips en cours : %1</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>Annulation…</translation>
    </message>
    <message>
        <source>Stopped at %1; the next start continues from there</source>
        <translation>Arrêté à %1 ; reprendra de là</translation>
    </message>
    <message>
        <source>&amp;Go On</source>
        <translation>&amp;Reprendre</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message numerus="yes">
        <source>&amp;Retry %Ln Failed</source>
        <translation>
            <numerusform>&amp;Réessayer %Ln échec</numerusform>
            <numerusform>&amp;Réessayer %Ln échecs</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exporter</translation>
    </message>
    <message numerus="yes">
        <source>, %Ln left out</source>
        <translation>
            <numerusform>, %Ln à l&apos;écart</numerusform>
            <numerusform>, %Ln à l&apos;écart</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %Ln with warnings</source>
        <translation>
            <numerusform>, dont %Ln avec avertissements</numerusform>
            <numerusform>, dont %Ln avec avertissements</numerusform>
        </translation>
    </message>
    <message>
        <source>Waiting for another program that is changing the bank…</source>
        <translation>En attente : un autre programme modifie la banque…</translation>
    </message>
    <message>
        <source>Fitting the coder to the clips of the bank…</source>
        <translation>Apprentissage sur les clips pour leur banque…</translation>
    </message>
    <message>
        <source>Making the bank: %L1 of %L2</source>
        <translation>Création de la banque : %L1 sur %L2</translation>
    </message>
    <message numerus="yes">
        <source>, %Ln with a stale verdict</source>
        <translation>
            <numerusform>, %Ln avec un verdict périmé</numerusform>
            <numerusform>, %Ln avec un verdict périmé</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mocapress::BatchWindow</name>
    <message>
        <source>Use Shared Settings for Selection</source>
        <translation>Leur donner les réglages partagés</translation>
    </message>
    <message>
        <source>&amp;Stop after Current</source>
        <translation>&amp;Arrêter après le clip en cours</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;nnuler</translation>
    </message>
    <message>
        <source>Slurm Script…</source>
        <translation>Script Slurm…</translation>
    </message>
    <message>
        <source>Batch Export</source>
        <translation>Exportation par lot</translation>
    </message>
    <message>
        <source>Add &amp;Files…</source>
        <translation>Ajouter des &amp;fichiers…</translation>
    </message>
    <message>
        <source>Add motions</source>
        <translation>Ajouter des mouvements</translation>
    </message>
    <message>
        <source>Add Fol&amp;der…</source>
        <translation>Ajouter un &amp;dossier…</translation>
    </message>
    <message>
        <source>Add every motion below a folder</source>
        <translation>Ajouter chaque mouvement d&apos;un dossier et de ses sous-dossiers</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Sortie</translation>
    </message>
    <message>
        <source>Progress of the batch</source>
        <translation>Avancement du lot</translation>
    </message>
    <message>
        <source>Compress each clip, read the file back, measure it and put it in place. Finished clips that have not changed are kept.</source>
        <translation>Compresser, relire, mesurer et mettre en place. Ce qui est fait et inchangé est gardé.</translation>
    </message>
    <message>
        <source>Finish the clips in progress and start no others</source>
        <translation>Finir les clips en cours et ne pas en commencer d’autres</translation>
    </message>
    <message>
        <source>Stop the clips in progress and put them back in the queue</source>
        <translation>Abandonner les clips en cours : ils attendent de nouveau</translation>
    </message>
    <message>
        <source>Open a page with the measurements of every clip and pictures of the worst frames</source>
        <translation>Chaque clip avec ses chiffres, et les pires images dessinées</translation>
    </message>
    <message>
        <source>Write a script for Slurm&apos;s sbatch that compresses this queue on a cluster</source>
        <translation>Faire traiter cette file par une grappe : un script pour sbatch</translation>
    </message>
    <message>
        <source>Add Clips</source>
        <translation>Ajouter des clips</translation>
    </message>
    <message>
        <source>Motion (%1)</source>
        <translation>Mouvement (%1)</translation>
    </message>
    <message>
        <source>Add All Clips below</source>
        <translation>Ajouter tous les clips contenus</translation>
    </message>
    <message>
        <source>Folder of the Batch</source>
        <translation>Dossier du lot</translation>
    </message>
    <message>
        <source>Slurm Script</source>
        <translation>Script Slurm</translation>
    </message>
    <message>
        <source>Tasks of the job array</source>
        <translation>Tâches du tableau de jobs</translation>
    </message>
    <message>
        <source>Shell scripts (*.sh)</source>
        <translation>Scripts shell (*.sh)</translation>
    </message>
    <message>
        <source>Settings of all clips</source>
        <translation>Réglages de tous les clips</translation>
    </message>
    <message numerus="yes">
        <source>Settings of %Ln selected clip(s)</source>
        <translation>
            <numerusform>Réglages de %Ln clip sélectionné</numerusform>
            <numerusform>Réglages de %Ln clips sélectionnés</numerusform>
        </translation>
    </message>
    <message>
        <source>Changes made while clips are selected apply to these clips only, and lock them.</source>
        <translation>Un changement fait pendant une sélection ne vaut que pour ces clips, et les verrouille.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Open Rep&amp;ort</source>
        <translation>Ouvrir le rapp&amp;ort</translation>
    </message>
    <message>
        <source>Character on all clips</source>
        <translation>Personnage sur tous les clips</translation>
    </message>
    <message>
        <source>Character on All Clips</source>
        <translation>Personnage sur tous les clips</translation>
    </message>
    <message>
        <source>Report: %1</source>
        <translation>Rapport : %1</translation>
    </message>
</context>
<context>
    <name>mocapress::BlindTestWindow</name>
    <message>
        <source>Blind Test</source>
        <translation>Test à l&apos;aveugle</translation>
    </message>
    <message>
        <source>Viewer</source>
        <translation>Spectateur</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Viewing distance</source>
        <translation>Distance de vue</translation>
    </message>
    <message>
        <source>Distance at which a person would look as tall as the figure does on your screen</source>
        <translation>Distance à laquelle une personne paraîtrait aussi grande que la figure sur votre écran</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Questions</translation>
    </message>
    <message>
        <source>Show A, X and B side by side</source>
        <translation>Montrer A, X et B côte à côte</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Commencer</translation>
    </message>
    <message>
        <source>Compressing the clip at %m levels: %v</source>
        <translation>Compression du clip à %m niveaux : %v</translation>
    </message>
    <message>
        <source>1: A, the original    2: X    3: B, compressed        ←: X is A    →: X is B        Esc: stop</source>
        <translation>1 : A, l&apos;original    2 : X    3 : B, compressé        ← : X est A    → : X est B        Échap : arrêter</translation>
    </message>
    <message>
        <source>Use as Limits</source>
        <translation>Prendre comme limites</translation>
    </message>
    <message>
        <source>Judge visibility by your own threshold from now on; other cues keep their limits</source>
        <translation>Juger désormais la visibilité d&apos;après votre propre seuil ; les autres indices gardent leurs limites</translation>
    </message>
    <message>
        <source>Another Test</source>
        <translation>Un autre test</translation>
    </message>
    <message>
        <source>In Use</source>
        <translation>En usage</translation>
    </message>
    <message>
        <source>A is the original of %1, B the same clip compressed, more or less visibly. X is one of the two: say which. The test finds the smallest error that you notice, in about five minutes. Nobody is told whether an answer was right.</source>
        <translation>A est l&apos;original de %1, B le même clip compressé, plus ou moins visiblement. X est l&apos;un des deux : dites lequel. Le test trouve la plus petite erreur que vous remarquez, en cinq minutes environ. Il ne dit pas si une réponse est juste.</translation>
    </message>
    <message>
        <source>Open a motion and compress it by the closed loop: the test takes the open clip.</source>
        <translation>Ouvrez un mouvement et compressez-le en boucle fermée : le test prend le clip ouvert.</translation>
    </message>
    <message>
        <source>This clip cannot be compressed at enough levels for a test.</source>
        <translation>Ce clip ne peut pas être compressé à assez de niveaux pour un test.</translation>
    </message>
    <message>
        <source>Question %L1 of %L2: is X the original or the compressed one?</source>
        <translation>Question %L1 sur %L2 : X est-il l&apos;original ou le compressé ?</translation>
    </message>
    <message>
        <source>%L1 of %L2 answers were right. Somebody who guesses has as many with a probability of %L3.</source>
        <translation>%L1 réponses sur %L2 sont justes. Qui devine en a autant avec une probabilité de %L3.</translation>
    </message>
    <message>
        <source>You notice errors from %L1 times what the limits say (95 % interval: %L2 to %L3). Most were seen as: %4, from %L5 m.</source>
        <translation>Vous remarquez les erreurs à partir de %L1 fois ce que disent les limites (intervalle à 95 % : %L2 à %L3). La plupart sont vues comme : %4, à %L5 m.</translation>
    </message>
    <message>
        <source>The answers do not tell a threshold: they are too few, or it lies outside of the levels.</source>
        <translation>Les réponses ne donnent pas de seuil : elles sont trop peu nombreuses, ou il est hors des niveaux.</translation>
    </message>
    <message>
        <source>Kept in %1.</source>
        <translation>Conservé dans %1.</translation>
    </message>
    <message>
        <source>Use Built-in Limits</source>
        <translation>Prendre les limites intégrées</translation>
    </message>
    <message>
        <source>Judge visibility as before any test</source>
        <translation>Juge la visibilité comme avant tout test</translation>
    </message>
    <message>
        <source>Visibility is judged by %1.</source>
        <translation>La visibilité est jugée selon %1.</translation>
    </message>
</context>
<context>
    <name>mocapress::ByteCostModel</name>
    <message>
        <source>Skeleton</source>
        <translation>Squelette</translation>
    </message>
    <message>
        <source>Description of the clip</source>
        <translation>Description du clip</translation>
    </message>
    <message>
        <source>Table of segments</source>
        <translation>Table des segments</translation>
    </message>
    <message>
        <source>Chains of the IK correction</source>
        <translation>Chaînes de la correction IK</translation>
    </message>
    <message>
        <source>First and last pose</source>
        <translation>Première et dernière pose</translation>
    </message>
    <message>
        <source>Turned axes</source>
        <translation>Axes tournés</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>Pistes</translation>
    </message>
    <message>
        <source>Rounding of the coder</source>
        <translation>Arrondi du codeur</translation>
    </message>
    <message>
        <source>Motion (cannot be divided)</source>
        <translation>Mouvement (indivisible)</translation>
    </message>
    <message>
        <source>Frame of the file</source>
        <translation>Cadre du fichier</translation>
    </message>
    <message>
        <source>%L1 %</source>
        <translation>%L1 %</translation>
    </message>
    <message>
        <source>Bytes of the file that code this joint, as the decoder counts them. Rows in italics belong to no joint.</source>
        <translation>Octets du fichier qui codent cette articulation, tels que le décodeur les compte. Les lignes en italique n&apos;appartiennent à aucune articulation.</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Articulation</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Octets</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Part</translation>
    </message>
</context>
<context>
    <name>mocapress::ByteStrip</name>
    <message>
        <source>Bytes over time</source>
        <translation>Octets dans le temps</translation>
    </message>
    <message>
        <source>Compressed bytes over time. The table of bytes has them by joint.</source>
        <translation>Octets compressés dans le temps. La table des octets les donne par articulation.</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Octets</translation>
    </message>
    <message>
        <source>Compressed bytes over time, on a scale of the dearest moment.</source>
        <translation>Octets compressés dans le temps, à l&apos;échelle du moment le plus coûteux.</translation>
    </message>
    <message>
        <source>Frames from %L1: %L2 bytes, most of them for %3 (%L4)</source>
        <translation>Images à partir de %L1 : %L2 octets, surtout pour %3 (%L4)</translation>
    </message>
</context>
<context>
    <name>mocapress::ByteView</name>
    <message>
        <source>%1: error × 2</source>
        <translation>%1 : erreur × 2</translation>
    </message>
    <message>
        <source>10 % more bytes</source>
        <translation>10 % d&apos;octets en plus</translation>
    </message>
    <message>
        <source>10 % fewer bytes</source>
        <translation>10 % d&apos;octets en moins</translation>
    </message>
</context>
<context>
    <name>mocapress::BytesPanel</name>
    <message>
        <source>Bytes by joint</source>
        <translation>Octets par articulation</translation>
    </message>
    <message>
        <source>Other settings, tried</source>
        <translation>Autres réglages, essayés</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Changement</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Octets</translation>
    </message>
    <message>
        <source>Its error</source>
        <translation>Son erreur</translation>
    </message>
    <message>
        <source>See what it saves to be less exact in one place, or what more bytes bring. Each line is a real encode.</source>
        <translation>Voyez ce que l&apos;on gagne à être moins exact à un endroit, ou ce qu&apos;apportent plus d&apos;octets. Chaque ligne est un vrai encodage.</translation>
    </message>
    <message>
        <source>Try Other Settings</source>
        <translation>Essayer d&apos;autres réglages</translation>
    </message>
    <message>
        <source>Use These</source>
        <translation>Prendre ceux-ci</translation>
    </message>
    <message>
        <source>Compress with the settings of the chosen line; can be undone</source>
        <translation>Compresser avec les réglages de la ligne choisie ; peut être annulé</translation>
    </message>
    <message>
        <source>%L1 → %L2 mm</source>
        <translation>%L1 → %L2 mm</translation>
    </message>
    <message>
        <source>Trying…</source>
        <translation>Essai…</translation>
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
        <translation>Un degré de liberté de l&apos;articulation choisie.</translation>
    </message>
    <message>
        <source>Channel over time</source>
        <translation>Canal au cours du temps</translation>
    </message>
    <message>
        <source>The recorded and the compressed channel; below, their difference. Click to go to a frame.</source>
        <translation>Le canal enregistré et le canal compressé, et dessous ce qui les sépare. Cliquer pour s&apos;y rendre.</translation>
    </message>
    <message>
        <source>Kept coefficients by scale</source>
        <translation>Coefficients gardés par échelle</translation>
    </message>
    <message>
        <source>Share of this channel&apos;s wavelet coefficients that are kept, from the coarsest scale to the finest.</source>
        <translation>Coefficients d&apos;ondelettes de ce canal qui sont gardés, parmi tous, de l&apos;échelle la plus grossière à la plus fine. La compression garde les quelques-uns qui comptent.</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Temps (s)</translation>
    </message>
    <message>
        <source>Scale (finer →)</source>
        <translation>Échelle (plus fine →)</translation>
    </message>
    <message>
        <source>Kept (%)</source>
        <translation>Gardés (%)</translation>
    </message>
    <message>
        <source>The selected joint has no motion of its own.</source>
        <translation>L&apos;articulation choisie ne bouge pas d&apos;elle-même.</translation>
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
        <translation>Retirer le personnage</translation>
    </message>
    <message>
        <source>Remove the character; clips with a mesh of their own use that</source>
        <translation>Retirer le personnage : chaque clip a son propre maillage, s’il en a un</translation>
    </message>
    <message>
        <source>Own mesh of each clip</source>
        <translation>Celui de chaque clip</translation>
    </message>
    <message>
        <source>Character on all clips: %1</source>
        <translation>Personnage sur tous les clips : %1</translation>
    </message>
    <message>
        <source>Character (FBX or glTF) for every clip whose joints it fits. Errors are measured on its mesh, and the weighting Skin uses it. Other clips are unchanged, and the report lists them.</source>
        <translation>Le maillage d’un FBX ou d’un glTF, mis sur chaque clip auquel il va : les erreurs y sont mesurées, et la pondération Peau compresse d’après lui. Les autres clips gardent ce qu’ils ont, et le rapport le dit.</translation>
    </message>
</context>
<context>
    <name>mocapress::ClipFiles</name>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Motion and compressed clips (%1 *.mcpr);;All files (*)</source>
        <translation>Mouvements et clips compressés (%1 *.mcpr);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Skeleton of %1</source>
        <translation>Squelette de %1</translation>
    </message>
    <message>
        <source>Skeletons (*.asf)</source>
        <translation>Squelettes (*.asf)</translation>
    </message>
    <message>
        <source>Put a Character on the Clip</source>
        <translation>Habiller le clip d’un personnage</translation>
    </message>
    <message>
        <source>Characters (*.fbx *.glb *.gltf *.vrm)</source>
        <translation>Personnages (*.fbx *.glb *.gltf *.vrm)</translation>
    </message>
    <message>
        <source>Compare with Original</source>
        <translation>Comparer à l&apos;original</translation>
    </message>
    <message>
        <source>Motion (%1)</source>
        <translation>Mouvement (%1)</translation>
    </message>
    <message>
        <source>Compressed clips (*.mcpr)</source>
        <translation>Clips compressés (*.mcpr)</translation>
    </message>
    <message>
        <source>Unsaved Changes</source>
        <translation>Modifications non enregistrées</translation>
    </message>
    <message>
        <source>Save the compressed clip of %1?</source>
        <translation>Enregistrer le clip compressé de %1 ?</translation>
    </message>
    <message>
        <source>The project keeps the clip&apos;s settings either way.</source>
        <translation>Le projet conserve de toute façon les réglages du clip.</translation>
    </message>
    <message>
        <source>Biovision motion (*.bvh)</source>
        <translation>Mouvement Biovision (*.bvh)</translation>
    </message>
    <message>
        <source>Acclaim motion with its skeleton (*.amc)</source>
        <translation>Mouvement Acclaim avec son squelette (*.amc)</translation>
    </message>
    <message>
        <source>FBX on its skeleton (*.fbx)</source>
        <translation>FBX avec son squelette (*.fbx)</translation>
    </message>
    <message>
        <source>%1 with this motion (*.%2)</source>
        <translation>%1 avec ce mouvement (*.%2)</translation>
    </message>
    <message>
        <source>%1 is the file of the character. Replace it with a file that also has this motion?</source>
        <translation>%1 est le personnage. Le remplacer par un qui bouge ainsi ?</translation>
    </message>
    <message>
        <source>glTF on its skeleton (*.glb)</source>
        <translation>glTF avec son squelette (*.glb)</translation>
    </message>
    <message>
        <source>Table of channels (*.csv)</source>
        <translation>Tableau des canaux (*.csv)</translation>
    </message>
    <message>
        <source>Review pages (*.html)</source>
        <translation>Pages de revue (*.html)</translation>
    </message>
    <message>
        <source>Save Clip</source>
        <translation>Enregistrer le clip</translation>
    </message>
    <message>
        <source>Export Motion</source>
        <translation>Exporter le mouvement</translation>
    </message>
    <message>
        <source>Export Review Page</source>
        <translation>Exporter la page de revue</translation>
    </message>
    <message>
        <source>The skeleton is written to %1, which exists already. Replace it?</source>
        <translation>Le squelette est écrit dans %1, qui existe déjà. Le remplacer ?</translation>
    </message>
    <message>
        <source>%1 is the original that is open. Replace it with the compressed motion?</source>
        <translation>%1 est l&apos;original ouvert. Le remplacer par son mouvement compressé ?</translation>
    </message>
</context>
<context>
    <name>mocapress::ClipLinks</name>
    <message>
        <source>%1 is not on this computer, and the library has no clip of that name.</source>
        <translation>%1 n&apos;est pas sur cet ordinateur, et la bibliothèque n&apos;a aucun clip de ce nom.</translation>
    </message>
    <message>
        <source>Copied the link to this frame and view.</source>
        <translation>Lien vers cette image et cette vue copié.</translation>
    </message>
</context>
<context>
    <name>mocapress::CommandPalette</name>
    <message>
        <source>No command has these words.</source>
        <translation>Aucune commande ne contient ces mots.</translation>
    </message>
    <message>
        <source>Find a Command</source>
        <translation>Chercher une commande</translation>
    </message>
    <message>
        <source>Words of a command, such as: next note</source>
        <translation>Mots d&apos;une commande, par exemple : note suivante</translation>
    </message>
    <message>
        <source>Words of a command</source>
        <translation>Mots d&apos;une commande</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Commandes</translation>
    </message>
</context>
<context>
    <name>mocapress::CompressionPanel</name>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Weighting</source>
        <translation>Pondération</translation>
    </message>
    <message>
        <source>Coding</source>
        <translation>Codage</translation>
    </message>
    <message>
        <source>Effort</source>
        <translation>Effort</translation>
    </message>
    <message>
        <source>Importance</source>
        <translation>Importance</translation>
    </message>
    <message>
        <source>Closed loop gives by far the smallest files: it rounds every coefficient by its effect on world-space error. The others are the paper&apos;s methods, which choose the coefficients to keep. Annealed searches for the channels where coefficients lower the error most, Standard keeps the largest of all channels, Per channel keeps as many in each.</source>
        <translation>La boucle fermée arrondit chaque coefficient selon son effet sur l&apos;erreur dans le monde, et donne de loin les plus petits fichiers. Les autres sont celles de l&apos;article, qui choisissent les coefficients à garder : le recuit les déplace vers les canaux où ils réduisent le plus l&apos;erreur, standard garde les plus grands de tous, par canal en garde autant de chacun.</translation>
    </message>
    <message>
        <source>Best searches longer for a smaller result: it saves about 1 % and takes some three times as long.</source>
        <translation>Le meilleur cherche plus longtemps un résultat plus petit : environ 1 % de moins, pour trois fois le temps.</translation>
    </message>
    <message>
        <source>Effort applies only to the closed loop; the paper&apos;s methods have one result.</source>
        <translation>Seule la boucle fermée peut s&apos;efforcer davantage : les méthodes de l&apos;article n&apos;ont qu&apos;un résultat.</translation>
    </message>
    <message>
        <source>The closed loop always uses adaptive coding, whose bytes it counts while it searches.</source>
        <translation>La boucle fermée pèse les octets de son propre codage adaptatif et n&apos;en a pas d&apos;autre.</translation>
    </message>
    <message>
        <source>Coding of kept coefficients as bytes: 16-bit words with runs of zeros, with or without DEFLATE on top, or an adaptive range coder.</source>
        <translation>Comment les coefficients gardés deviennent des octets : mots de 16 bits avec plages de zéros, au besoin compactés par DEFLATE, ou un codeur par intervalle adaptatif.</translation>
    </message>
    <message>
        <source>Not used</source>
        <translation>Sans effet</translation>
    </message>
    <message>
        <source>All equal</source>
        <translation>Toutes égales</translation>
    </message>
    <message>
        <source>Give errors of feet, hands, the head, contacts or any joint more weight.</source>
        <translation>Prendre plus soin des pieds, des mains, de la tête, des contacts ou d&apos;une articulation.</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Plus</translation>
    </message>
    <message>
        <source>This method ignores importance: choose %1 or %2.</source>
        <translation>Cette méthode ignore l&apos;importance : choisissez %1 ou %2.</translation>
    </message>
    <message>
        <source>Rarely changed settings: error weighting, ends of the clip, and coding.</source>
        <translation>Pondération de l&apos;erreur, extrémités du clip et codage : rarement changés.</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Extrémités</translation>
    </message>
    <message>
        <source>Only the closed loop corrects the first and last pose.</source>
        <translation>Seule la boucle fermée code une fois de plus la première et la dernière pose.</translation>
    </message>
    <message>
        <source>Errors of the first and last pose, where clips are blended and looped. Even: no larger than the target, and equal at both ends of a loop. Exact: at most a tenth of the target, for some 4 % more bytes. Free: no bound.</source>
        <translation>La première et la dernière pose, où les clips sont fondus et bouclés. Égales : pas plus loin que la cible, et celles d&apos;une boucle pareilles. Exactes : un dixième de celle-ci, pour environ 4 % d&apos;octets de plus. Libres : ce qui vient.</translation>
    </message>
    <message>
        <source>Tracks within</source>
        <translation>Pistes à moins de</translation>
    </message>
    <message>
        <source>Largest error allowed for values of morph weights and scales, independent of the target of the motion. Weights range from 0 to 1; switches and constants are kept exactly.</source>
        <translation>De combien les valeurs des poids de morphing et des échelles peuvent s&apos;écarter, quelle que soit la cible du mouvement. Un poids va de 0 à 1 ; les interrupteurs et les constantes sont gardés exactement.</translation>
    </message>
    <message>
        <source>Points on which the error eps_x is measured. Surface: a body modelled around the bones, so that turned heads and hands count. Skin: the mesh of the clip or of the character put on it. Shell: three points 3 cm from every joint, as in ACL. Bone ends and joint origins: points on the bones, weighted by bone length; joint origins are the paper&apos;s.</source>
        <translation>Les points que compte l&apos;erreur eps_x. Surface : un corps modelé autour des os, si bien que la tête et les mains tournées comptent. Peau : des points du maillage du clip ou du personnage qui l&apos;habille. Coque : trois points à 3 cm de chaque articulation, comme ACL. Extrémités des os et origines des articulations : des points sur les os, selon leur longueur ; les dernières sont celles de l&apos;article.</translation>
    </message>
    <message>
        <source>Viewing distance</source>
        <translation>Distance de vue</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Distance from which the figure is watched. The nearer, the smaller an error that is noticed.</source>
        <translation>Distance d&apos;où l&apos;on regarde la figure. Plus elle est courte, plus l&apos;erreur remarquée est petite.</translation>
    </message>
</context>
<context>
    <name>mocapress::ContactStrip</name>
    <message>
        <source>Contacts</source>
        <translation>Contacts</translation>
    </message>
    <message>
        <source>Remove Contact</source>
        <translation>Retirer le contact</translation>
    </message>
    <message>
        <source>Add Contact Here</source>
        <translation>Ajouter un contact ici</translation>
    </message>
    <message>
        <source>%1 stands in frames %L2–%L3 and drifts by %4 from the original. Drag an end to move it.</source>
        <translation>%1 au sol, images %L2–%L3 ; dérive de %4 par rapport à l&apos;original. Faites glisser un bout pour le déplacer.</translation>
    </message>
</context>
<context>
    <name>mocapress::ConvergencePlot</name>
    <message>
        <source>Iteration</source>
        <translation>Itération</translation>
    </message>
    <message>
        <source>eps_x (cm)</source>
        <translation>eps_x (cm)</translation>
    </message>
    <message>
        <source>Error while refining</source>
        <translation>Erreur pendant l&apos;affinage</translation>
    </message>
    <message>
        <source>Error after each iteration of the refinement.</source>
        <translation>Comment l&apos;erreur baisse pendant que le résultat est affiné.</translation>
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
        <translation>Enregistre où sont les pieds dans l&apos;original et les y ramène par cinématique inverse, pour que les pieds posés ne glissent pas. Ce que cela prend compte dans le taux de compression.</translation>
    </message>
    <message>
        <source>Searches for the smallest correction that removes at least nine tenths of the sliding, or leaves no foot sliding more than a millimetre.</source>
        <translation>Laisser l&apos;encodeur trouver combien dépenser pour les pieds : au moins neuf dixièmes du glissement en moins, ou aucun pied qui glisse de plus d&apos;un millimètre, pour le moins d&apos;octets.</translation>
    </message>
    <message>
        <source>IK ratio</source>
        <translation>Taux IK</translation>
    </message>
    <message>
        <source>Coefficients of the correction over those kept (r_IK in the paper). Lower values hold the feet better and take more bytes.</source>
        <translation>Le r_IK de l&apos;article : coefficients de la correction sur ceux qui sont gardés. Plus bas, les pieds tiennent mieux et cela coûte plus.</translation>
    </message>
    <message>
        <source> : 1</source>
        <translation> : 1</translation>
    </message>
    <message>
        <source>IK ratio on a slider</source>
        <translation>Taux IK au curseur</translation>
    </message>
    <message>
        <source>When feet are held</source>
        <translation>Où les pieds sont tenus</translation>
    </message>
    <message>
        <source>Hold the feet at every frame, as in the paper, or only while they stand on the ground, blended in and out.</source>
        <translation>À chaque image comme dans l&apos;article, ou seulement là où ils sont au sol, en fondu.</translation>
    </message>
    <message>
        <source>Held joints</source>
        <translation>Articulations tenues</translation>
    </message>
    <message>
        <source>Joints to hold; the feet by default.</source>
        <translation>D&apos;autres articulations que les pieds peuvent être tenues aussi.</translation>
    </message>
    <message>
        <source>Hold at</source>
        <translation>Tenus à</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Articulations</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Pieds</translation>
    </message>
    <message numerus="yes">
        <source>%Ln joint(s)</source>
        <translation>
            <numerusform>%Ln articulation</numerusform>
            <numerusform>%Ln articulations</numerusform>
        </translation>
    </message>
    <message>
        <source>Hold feet (IK)</source>
        <translation>Tenir les pieds (IK)</translation>
    </message>
</context>
<context>
    <name>mocapress::EncodingBar</name>
    <message>
        <source>Clips that are compressed</source>
        <translation>Clips compressés</translation>
    </message>
    <message>
        <source>Pause compressing clips in the background</source>
        <translation>Suspendre la compression en arrière-plan</translation>
    </message>
    <message>
        <source>Compress all clips in the background with their own settings, the open clip first.</source>
        <translation>Compresser tous les clips en arrière-plan, chacun selon ses réglages. Le clip ouvert passe d’abord.</translation>
    </message>
    <message>
        <source>%L1 of %L2 compressed</source>
        <translation>%L1 compressés sur %L2</translation>
    </message>
    <message>
        <source>%1, %L2 failed</source>
        <translation>%1, %L2 en échec</translation>
    </message>
</context>
<context>
    <name>mocapress::ErrorDisplay</name>
    <message>
        <source>Errors in &amp;Degrees</source>
        <translation>Erreurs en &amp;degrés</translation>
    </message>
    <message>
        <source>Degrees</source>
        <translation>Degrés</translation>
    </message>
    <message>
        <source>Show rotation errors of joints (in degrees, world space) instead of distances in heat map and error graph (%1)</source>
        <translation>Carte de chaleur et graphique d&apos;erreur : de combien de degrés les articulations sont tournées dans l&apos;espace, au lieu de leur écart (%1)</translation>
    </message>
    <message>
        <source>Visible Errors</source>
        <translation>Erreurs visibles</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Vu</translation>
    </message>
    <message>
        <source>Show visible errors of joints instead of distances in the heat map (%1)</source>
        <translation>Carte de chaleur : où l&apos;on remarque l&apos;écart des articulations, au lieu de sa valeur (%1)</translation>
    </message>
</context>
<context>
    <name>mocapress::ErrorGraph</name>
    <message>
        <source>Error over time</source>
        <translation>Erreur au cours du temps</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Temps (s)</translation>
    </message>
    <message>
        <source>Error (cm)</source>
        <translation>Erreur (cm)</translation>
    </message>
    <message>
        <source>worst of all joints</source>
        <translation>la pire articulation</translation>
    </message>
    <message>
        <source>World-space distance or angle between joints and the original. Click to go to a frame, turn the wheel to zoom, double-click to show all.</source>
        <translation>Distance des articulations à l&apos;original dans l&apos;espace, ou angle dont elles sont tournées. Clic pour s&apos;y rendre, molette pour agrandir, double-clic pour tout voir.</translation>
    </message>
    <message>
        <source>Angle (°)</source>
        <translation>Angle (°)</translation>
    </message>
    <message>
        <source>Frame %L1</source>
        <translation>Image %L1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
</context>
<context>
    <name>mocapress::ErrorScaleChoice</name>
    <message>
        <source>&amp;Automatic</source>
        <translation>&amp;Automatique</translation>
    </message>
</context>
<context>
    <name>mocapress::ErrorStrip</name>
    <message>
        <source>Error strip</source>
        <translation>Bande d&apos;erreur</translation>
    </message>
    <message>
        <source>Largest and mean error at every frame. The table of joints has the numbers.</source>
        <translation>Erreur maximale et moyenne à chaque image. Le tableau des articulations a les nombres.</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Errors of this size or more have full height and the lightest colour. Click to choose another scale.</source>
        <translation>Les erreurs de cette taille et plus sont les plus hautes et les plus claires. Cliquez pour choisir une autre échelle.</translation>
    </message>
    <message>
        <source>Largest error at every frame as a column, mean error as a line. Turn the wheel to zoom, with Shift to scroll; drag with Shift to choose the range to play.</source>
        <translation>L&apos;erreur maximale de chaque image en colonne, la moyenne en ligne. La molette agrandit, avec Maj elle fait défiler ; Maj et glisser choisit la plage lue.</translation>
    </message>
    <message>
        <source>A jump of one frame: %1 at frame %L2, %3</source>
        <translation>Un saut d&apos;une image : %1 à l&apos;image %L2, %3</translation>
    </message>
</context>
<context>
    <name>mocapress::FactorControl</name>
    <message>
        <source>%1 on a slider</source>
        <translation>%1, curseur</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
</context>
<context>
    <name>mocapress::Figures</name>
    <message>
        <source>Nothing open</source>
        <translation>Rien d&apos;ouvert</translation>
    </message>
    <message>
        <source>Not compressed</source>
        <translation>Non compressé</translation>
    </message>
    <message>
        <source>Compressing…</source>
        <translation>Compression…</translation>
    </message>
    <message>
        <source>As recorded in the file</source>
        <translation>Tel qu&apos;enregistré dans le fichier</translation>
    </message>
    <message>
        <source>%1, with the settings of the study</source>
        <translation>%1, comme dans l&apos;étude</translation>
    </message>
    <message>
        <source>%1, read from the file and measured against the original</source>
        <translation>%1, du fichier, mesuré contre l&apos;original</translation>
    </message>
    <message>
        <source>%1, %L2 s</source>
        <translation>%1, %L2 s</translation>
    </message>
    <message>
        <source>Footskate is measured against the original.</source>
        <translation>Le glissement se mesure contre l&apos;original.</translation>
    </message>
    <message>
        <source>No foot stands on the ground in this clip.</source>
        <translation>Aucun pied n&apos;est posé au sol dans ce clip.</translation>
    </message>
    <message>
        <source>%1, without IK</source>
        <translation>%1, sans IK</translation>
    </message>
    <message>
        <source>Draft; the refined result follows</source>
        <translation>Ébauche ; le résultat affiné arrive</translation>
    </message>
    <message>
        <source>Refinement cancelled; the best so far is kept</source>
        <translation>Affinage annulé ; le meilleur résultat est gardé</translation>
    </message>
    <message>
        <source>Refinement cancelled; the draft is kept</source>
        <translation>Affinage annulé ; l&apos;ébauche est gardée</translation>
    </message>
    <message>
        <source>No result for these settings; the draft is kept</source>
        <translation>Pas de réponse à ces réglages ; l&apos;ébauche est gardée</translation>
    </message>
    <message>
        <source>No result for these settings; the last one is kept</source>
        <translation>Pas de réponse à ces réglages ; la précédente est gardée</translation>
    </message>
    <message numerus="yes">
        <source>%1, %Ln iteration(s), %L2 s</source>
        <translation>
            <numerusform>%1, %Ln itération, %L2 s</numerusform>
            <numerusform>%1, %Ln itérations, %L2 s</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln contact(s): mean drift of the feet %1, worst %2; their path is %3 longer than the original&apos;s</source>
        <translation>
            <numerusform>%Ln contact : le pied dérive de %1 en moyenne, de %2 au pire ; son chemin est plus long de %3 que dans l&apos;original</numerusform>
            <numerusform>%Ln contacts : les pieds dérivent de %1 en moyenne, de %2 au pire ; leur chemin est plus long de %3 que dans l&apos;original</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %L2 s, as a loop</source>
        <translation>%1, %L2 s, en boucle</translation>
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
        <translation>Distance quadratique moyenne entre original et compressé, pondérée par la longueur d&apos;os : la distorsion de l&apos;article.</translation>
    </message>
    <message>
        <source>p95</source>
        <translation>p95</translation>
    </message>
    <message>
        <source>95 % of all points at all frames have a smaller error.</source>
        <translation>95 % de tous les points à toutes les images sont plus proches de l&apos;original.</translation>
    </message>
    <message>
        <source>p99</source>
        <translation>p99</translation>
    </message>
    <message>
        <source>99 % of all points at all frames have a smaller error.</source>
        <translation>99 % de tous les points à toutes les images sont plus proches de l&apos;original.</translation>
    </message>
    <message>
        <source>max</source>
        <translation>max</translation>
    </message>
    <message>
        <source>Largest error of any point at any frame.</source>
        <translation>Plus grande erreur d&apos;un point quelconque, toutes images confondues.</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>taux</translation>
    </message>
    <message>
        <source>Bytes of the channels as 32-bit floats, divided by the compressed motion bytes, as in the paper.</source>
        <translation>Canaux en flottants de 32 bits sur les octets du mouvement compressé, comme dans l&apos;article.</translation>
    </message>
    <message>
        <source>bits per joint-sample</source>
        <translation>bits par échantillon d&apos;articulation</translation>
    </message>
    <message>
        <source>Motion bits for one joint at one frame; unlike a ratio it needs no baseline.</source>
        <translation>Bits du mouvement pour une articulation à une image : ne dépend d&apos;aucune référence.</translation>
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
        <translation>dérive du pied</translation>
    </message>
    <message>
        <source>Largest distance between a standing foot and its place in the original.</source>
        <translation>Le plus loin qu&apos;un pied s&apos;éloigne de l&apos;endroit où il devrait se tenir.</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>mouvement</translation>
    </message>
    <message>
        <source>Compressed motion bytes; the skeleton in the file takes more.</source>
        <translation>Octets du mouvement compressé ; le fichier contient en plus son squelette.</translation>
    </message>
    <message>
        <source>Errors in the range</source>
        <translation>Erreurs dans la plage</translation>
    </message>
    <message>
        <source>Errors of all joints in the frames of the chosen range: root mean square, 95th percentile and largest. A double click on the ruler chooses the whole clip again.</source>
        <translation>Erreurs de toutes les articulations dans la plage choisie : moyenne quadratique, 95e centile et maximum. Un double-clic sur la règle choisit de nouveau tout le clip.</translation>
    </message>
</context>
<context>
    <name>mocapress::FilmRecorder</name>
    <message>
        <source>%1: ffmpeg could not write the video (%2)</source>
        <translation>%1 : ffmpeg n&apos;a pas pu écrire la vidéo (%2)</translation>
    </message>
    <message>
        <source>A video needs the program ffmpeg, which is not installed here. Numbered pictures (.png) need nothing.</source>
        <translation>Une vidéo demande le programme ffmpeg, qui n&apos;est pas installé ici. Les images numérotées (.png) ne demandent rien.</translation>
    </message>
    <message>
        <source>%1: there is such a folder already</source>
        <translation>%1 : ce dossier existe déjà</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2)</source>
        <translation>%1 : impossible d&apos;écrire (%2)</translation>
    </message>
    <message>
        <source>The 3D view gave no picture.</source>
        <translation>La vue 3D n&apos;a pas donné d&apos;image.</translation>
    </message>
</context>
<context>
    <name>mocapress::FolderSearch</name>
    <message>
        <source>There are no clips in %1.</source>
        <translation>Il n&apos;y a aucun clip dans %1.</translation>
    </message>
</context>
<context>
    <name>mocapress::FootskatePanel</name>
    <message>
        <source>Findings of footskate</source>
        <translation>Glissements trouvés</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Contact</translation>
    </message>
    <message>
        <source>begins below</source>
        <translation>commence sous</translation>
    </message>
    <message>
        <source>ends above</source>
        <translation>finit au-dessus</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source>Height below which a contact begins</source>
        <translation>Hauteur sous laquelle un contact commence</translation>
    </message>
    <message>
        <source>Height above which a contact ends</source>
        <translation>Hauteur au-dessus de laquelle un contact finit</translation>
    </message>
    <message>
        <source> cm/s</source>
        <translation> cm/s</translation>
    </message>
    <message>
        <source>Speed below which a contact begins</source>
        <translation>Vitesse sous laquelle un contact commence</translation>
    </message>
    <message>
        <source>Speed above which a contact ends</source>
        <translation>Vitesse au-dessus de laquelle un contact finit</translation>
    </message>
    <message>
        <source>%1, measured in the original.</source>
        <translation>%1, mesurée sur l&apos;original.</translation>
    </message>
</context>
<context>
    <name>mocapress::ForeignLock</name>
    <message>
        <source>%1 was opened by another Mocapress meanwhile, so it was not taken over.</source>
        <translation>%1 a été ouvert entre-temps par un autre Mocapress, et n&apos;a donc pas été repris.</translation>
    </message>
    <message>
        <source>The project cannot be taken over: its lock %1 is still held, or you may not change it.</source>
        <translation>Le projet ne peut pas être repris : son verrou %1 est encore tenu, ou vous ne pouvez pas le modifier.</translation>
    </message>
    <message>
        <source>%1 is open in another window of Mocapress</source>
        <translation>%1 est ouvert dans une autre fenêtre de Mocapress</translation>
    </message>
    <message>
        <source>%1 is open on the computer %2, since %3</source>
        <translation>%1 est ouvert sur l&apos;ordinateur %2, depuis %3</translation>
    </message>
    <message>
        <source>%1 is open on the computer %2, by %3, since %4</source>
        <translation>%1 est ouvert sur l&apos;ordinateur %2, par %3, depuis %4</translation>
    </message>
</context>
<context>
    <name>mocapress::FrameNotes</name>
    <message>
        <source>Frame %L1</source>
        <translation>Image %L1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Stale: the clip&apos;s file or settings have changed since.</source>
        <translation>Périmée : le fichier du clip ou ses réglages ont changé depuis.</translation>
    </message>
    <message>
        <source>Frames %L1–%L2</source>
        <translation>Images %L1–%L2</translation>
    </message>
</context>
<context>
    <name>mocapress::HeatMap</name>
    <message>
        <source>Heat map of errors</source>
        <translation>Carte de chaleur des erreurs</translation>
    </message>
    <message>
        <source>Error of every joint at every frame. Arrow keys move to the next joint or frame.</source>
        <translation>Erreur de chaque articulation à chaque image. Les flèches vont à l&apos;articulation ou à l&apos;image suivante.</translation>
    </message>
    <message>
        <source>Errors are measured against the original.</source>
        <translation>Les erreurs se mesurent contre l&apos;original.</translation>
    </message>
    <message>
        <source>%1, frame %L2: %3</source>
        <translation>%1, image %L2 : %3</translation>
    </message>
</context>
<context>
    <name>mocapress::Help</name>
    <message>
        <source>Guide</source>
        <translation>Guide</translation>
    </message>
    <message>
        <source>Keyboard Shortcuts</source>
        <translation>Raccourcis clavier</translation>
    </message>
    <message>
        <source>About Mocapress</source>
        <translation>À propos de Mocapress</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Mocapress %1&lt;/h3&gt;&lt;p&gt;Compresses human motion capture clips with wavelets, after Philippe Beaudoin, Pierre Poulin and Michiel van de Panne, &lt;i&gt;Adapting Wavelet Compression to Human Motion Capture Clips&lt;/i&gt;, Graphics Interface 2007.&lt;/p&gt;&lt;p&gt;The studio is free software under the GNU General Public License, version 3 or later; the compression library is under the MIT licence.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Mocapress %1&lt;/h3&gt;&lt;p&gt;Compresse des captures de mouvement humain par ondelettes, d&apos;après Philippe Beaudoin, Pierre Poulin et Michiel van de Panne, &lt;i&gt;Adapting Wavelet Compression to Human Motion Capture Clips&lt;/i&gt;, Graphics Interface 2007.&lt;/p&gt;&lt;p&gt;Le studio est un logiciel libre sous licence publique générale GNU, version 3 ou ultérieure ; la bibliothèque de compression est sous licence MIT.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Right or middle drag: move</source>
        <translation>Glisser à droite ou au milieu : déplacer</translation>
    </message>
    <message>
        <source>Wheel: nearer or further</source>
        <translation>Molette : plus près ou plus loin</translation>
    </message>
    <message>
        <source>Click on a joint: select it</source>
        <translation>Clic sur une articulation : la choisir</translation>
    </message>
    <message>
        <source>Drag an end of a contact: move it; right button: add or remove</source>
        <translation>Tirer le bout d&apos;un contact : le déplacer ; bouton droit : ajouter ou retirer</translation>
    </message>
    <message>
        <source>Shift and drag on the error strip: choose the range that is played</source>
        <translation>Maj et glisser sur la bande d&apos;erreur : choisir la plage lue</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Souris</translation>
    </message>
    <message>
        <source>Wheel over the timeline: zoom; with Shift: move along</source>
        <translation>Molette sur la frise : agrandir ; avec Maj : faire défiler</translation>
    </message>
    <message>
        <source>Click on the scale of the error strip: choose another</source>
        <translation>Clic sur l&apos;échelle de la bande d&apos;erreur : en choisir une autre</translation>
    </message>
    <message>
        <source>Drag on the ruler: choose a range; right button: what to do with it</source>
        <translation>Glisser sur la règle : choisir une plage ; bouton droit : qu&apos;en faire</translation>
    </message>
    <message>
        <source>Left drag in the 3D view: turn; in a view along an axis: move</source>
        <translation>Glisser à gauche dans la vue 3D : tourner ; dans une vue selon un axe : déplacer</translation>
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
        <translation>Options d’importation – %1</translation>
    </message>
    <message>
        <source>Guessed by the figure&apos;s height</source>
        <translation>Devinée d’après la taille du personnage</translation>
    </message>
    <message>
        <source>As in the skeleton file</source>
        <translation>Selon le squelette</translation>
    </message>
    <message>
        <source>Centimetre</source>
        <translation>Centimètre</translation>
    </message>
    <message>
        <source>Metre</source>
        <translation>Mètre</translation>
    </message>
    <message>
        <source>Millimetre</source>
        <translation>Millimètre</translation>
    </message>
    <message>
        <source>Inch</source>
        <translation>Pouce</translation>
    </message>
    <message>
        <source>CMU&apos;s unit (0.45 to the inch)</source>
        <translation>Unité du CMU (0,45 par pouce)</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Autre</translation>
    </message>
    <message>
        <source>Y, as usual</source>
        <translation>Y, comme d’habitude</translation>
    </message>
    <message>
        <source>Guessed by the root&apos;s values</source>
        <translation>Devinée d’après les valeurs de la racine</translation>
    </message>
    <message>
        <source>Adds to its OFFSET</source>
        <translation>S’ajoute à son OFFSET</translation>
    </message>
    <message>
        <source>Replaces its OFFSET</source>
        <translation>Remplace son OFFSET</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>Selon le fichier</translation>
    </message>
    <message>
        <source>%L1 Hz</source>
        <translation>%L1 Hz</translation>
    </message>
    <message>
        <source>&amp;Length unit</source>
        <translation>Unité de &amp;longueur</translation>
    </message>
    <message>
        <source>&amp;Up axis</source>
        <translation>Axe &amp;vertical</translation>
    </message>
    <message>
        <source>Frame &amp;rate</source>
        <translation>&amp;Cadence</translation>
    </message>
    <message>
        <source>BVH r&amp;oot</source>
        <translation>&amp;Racine BVH</translation>
    </message>
    <message>
        <source>Length unit</source>
        <translation>Unité de longueur</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>Cadence</translation>
    </message>
    <message>
        <source>Centimetres in one unit</source>
        <translation>Centimètres par unité</translation>
    </message>
    <message>
        <source>Frames per second</source>
        <translation>Images par seconde</translation>
    </message>
    <message>
        <source>Now read with %L1 cm to the unit, %2 up, %L3 Hz</source>
        <translation>Lu actuellement : %L1 cm par unité, %2 vers le haut, %L3 Hz</translation>
    </message>
    <message>
        <source>, the root adds to its OFFSET</source>
        <translation>, la racine s’ajoute à son OFFSET</translation>
    </message>
    <message>
        <source>, the root replaces its OFFSET</source>
        <translation>, la racine remplace son OFFSET</translation>
    </message>
    <message>
        <source>%L1 Hz, CMU&apos;s: the file does not say</source>
        <translation>%L1 Hz, celle du CMU : le fichier n’en dit rien</translation>
    </message>
</context>
<context>
    <name>mocapress::ImportancePanel</name>
    <message>
        <source>Contacts</source>
        <translation>Contacts</translation>
    </message>
    <message>
        <source>Factor on the weight of a foot while it stands. About 20 keeps feet planted without inverse kinematics, for some more bytes at the same error.</source>
        <translation>Combien de fois sa part pèse un pied pendant qu&apos;il est posé. Environ 20 garde les pieds en place sans cinématique inverse, pour quelques octets de plus à erreur égale.</translation>
    </message>
    <message>
        <source>All Equal</source>
        <translation>Toutes égales</translation>
    </message>
    <message>
        <source>Factor on the weight of these joints. Other joints get less accurate in return: the size or error that was asked for stays the same.</source>
        <translation>Par combien le poids de ces articulations est multiplié. Ce qu&apos;elles gagnent, les autres le perdent : la taille, ou l&apos;erreur promise, reste.</translation>
    </message>
    <message>
        <source>Give all joints the same weight again.</source>
        <translation>Prendre de nouveau le même soin de toutes les articulations.</translation>
    </message>
    <message>
        <source>Any joint</source>
        <translation>Toute articulation</translation>
    </message>
    <message>
        <source>Set factors of single joints.</source>
        <translation>Donner à des articulations un facteur propre.</translation>
    </message>
    <message>
        <source>Find a joint</source>
        <translation>Chercher une articulation</translation>
    </message>
    <message>
        <source>Importance of every joint</source>
        <translation>Importance de chaque articulation</translation>
    </message>
    <message>
        <source>Double-click a factor to change it.</source>
        <translation>Double-cliquez sur un facteur pour le changer.</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Articulation</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Facteur</translation>
    </message>
    <message>
        <source>No joint of this skeleton has the name of this part of the body.</source>
        <translation>Aucune articulation de ce squelette ne porte le nom de cette partie du corps.</translation>
    </message>
    <message>
        <source>Weights of errors by part of the body. Parts with more weight get more accurate, the rest less.</source>
        <translation>Ce dont l&apos;encodeur prend plus soin, aux dépens du reste.</translation>
    </message>
    <message>
        <source>This method ignores importance: choose %1 or %2.</source>
        <translation>Cette méthode ignore l&apos;importance : choisissez %1 ou %2.</translation>
    </message>
</context>
<context>
    <name>mocapress::IncomingFiles</name>
    <message>
        <source>Left out; the library takes only motions: %1</source>
        <translation>Laissés de côté, la bibliothèque prend des mouvements : %1</translation>
    </message>
    <message>
        <source>Left out; only one project is open at a time: %1</source>
        <translation>Laissés de côté, un seul projet est ouvert à la fois : %1</translation>
    </message>
</context>
<context>
    <name>mocapress::Inspector</name>
    <message>
        <source>The curve of this clip appears after it is compressed.</source>
        <translation>La courbe de ce clip est tracée dès qu&apos;il est compressé.</translation>
    </message>
    <message>
        <source>Frames %L1–%L2: RMS %3, p95 %4, max %5 (%6, frame %L7)</source>
        <translation>Images %L1–%L2 : RMS %3, p95 %4, max %5 (%6, image %L7)</translation>
    </message>
</context>
<context>
    <name>mocapress::JobRunner</name>
    <message>
        <source>An unknown error occurred.</source>
        <translation>Une erreur inconnue s&apos;est produite.</translation>
    </message>
</context>
<context>
    <name>mocapress::JointErrorModel</name>
    <message>
        <source>Joint</source>
        <translation>Articulation</translation>
    </message>
    <message>
        <source>Joint origins and bone ends, in the skeleton&apos;s order.</source>
        <translation>Origines d&apos;articulations et bouts d&apos;os, dans l&apos;ordre du squelette.</translation>
    </message>
    <message>
        <source>World-space distance from the original, mean over the clip.</source>
        <translation>Distance à l&apos;original dans l&apos;espace, moyenne sur le clip.</translation>
    </message>
    <message>
        <source>Largest world-space distance from the original at any frame.</source>
        <translation>Plus grande distance à l&apos;original dans l&apos;espace, à une image.</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Max</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Angle between the joint&apos;s world-space rotation and the original&apos;s, RMS over the clip. Bone ends turn with their joint.</source>
        <translation>Angle dans l&apos;espace entre la rotation de l&apos;articulation et celle de l&apos;original, moyenne quadratique sur la séquence. Les bouts d&apos;os tournent avec leur articulation.</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Vu</translation>
    </message>
    <message>
        <source>The joint&apos;s most visible error, as a multiple of the noticeable error: up to 1 is not visible, up to 2 borderline.</source>
        <translation>Le pire de l&apos;articulation, en multiples de ce que l&apos;on remarque : jusqu&apos;à 1 invisible, jusqu&apos;à 2 limite.</translation>
    </message>
    <message>
        <source>RMS %1</source>
        <translation>RMS %1</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Peau</translation>
    </message>
    <message>
        <source>Largest error at any frame of the part of the mesh that mainly follows this joint.</source>
        <translation>La plus grande distance du maillage que cette articulation porte pour l&apos;essentiel, sur toutes les images.</translation>
    </message>
</context>
<context>
    <name>mocapress::JointsPanel</name>
    <message>
        <source>Joints</source>
        <translation>Articulations</translation>
    </message>
</context>
<context>
    <name>mocapress::KeptProject</name>
    <message>
        <source>The last project</source>
        <translation>Le dernier projet</translation>
    </message>
    <message>
        <source>%1 is read-only. This is a copy without a name.</source>
        <translation>%1 ne peut pas être modifié à son emplacement. Voici une copie sans nom.</translation>
    </message>
    <message>
        <source>The project was not saved: %1</source>
        <translation>Le projet n&apos;est pas enregistré : %1</translation>
    </message>
    <message>
        <source>its lock was replaced or removed by someone else; use Save Project As to keep the changes in another file</source>
        <translation>son verrou a été remplacé ou supprimé par quelqu&apos;un d&apos;autre ; choisissez « Enregistrer le projet sous » pour garder les changements dans un autre fichier</translation>
    </message>
    <message>
        <source>it was taken over on the computer %1; use Save Project As to keep the changes in another file</source>
        <translation>il a été repris sur l&apos;ordinateur %1 ; choisissez « Enregistrer le projet sous » pour garder les changements dans un autre fichier</translation>
    </message>
    <message>
        <source>%1. This is a new project.</source>
        <translation>%1. Ceci est un nouveau projet.</translation>
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
        <translation>Attribuer</translation>
    </message>
    <message>
        <source>No Key</source>
        <translation>Aucune touche</translation>
    </message>
    <message>
        <source>Usual Key</source>
        <translation>Touche d&apos;origine</translation>
    </message>
    <message>
        <source>Keyboard Map</source>
        <translation>Raccourcis personnels</translation>
    </message>
    <message>
        <source>Words of a command, or a key</source>
        <translation>Mots d&apos;une commande, ou une touche</translation>
    </message>
    <message>
        <source>Words of a command</source>
        <translation>Mots d&apos;une commande</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Commandes</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menu</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Touche</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>Nouvelle touche</translation>
    </message>
    <message>
        <source>Usual Keys for All</source>
        <translation>Touches d&apos;origine pour toutes</translation>
    </message>
    <message>
        <source>%1 belongs to “%2”, which loses it when you assign it.</source>
        <translation>%1 appartient à « %2 », qui la perd si vous l&apos;attribuez.</translation>
    </message>
</context>
<context>
    <name>mocapress::LaunchOptions</name>
    <message>
        <source>Compress human motion capture clips with wavelets, and look at the result.</source>
        <translation>Compresser des captures de mouvement humain par ondelettes, et voir ce que cela fait.</translation>
    </message>
    <message>
        <source>Skeleton (.asf) of an .amc.</source>
        <translation>Le squelette .asf d&apos;un .amc.</translation>
    </message>
    <message>
        <source>Compression ratio at the start.</source>
        <translation>Le taux de compression au départ.</translation>
    </message>
    <message>
        <source>Hold the feet, with this IK ratio at the start.</source>
        <translation>Tenir les pieds, avec ce taux IK au départ.</translation>
    </message>
    <message>
        <source>Write timings to standard error.</source>
        <translation>Écrire les durées sur l&apos;erreur standard.</translation>
    </message>
    <message>
        <source>After the clip is compressed, write a picture of the window and quit.</source>
        <translation>Écrire une image de la fenêtre une fois le clip compressé, et quitter.</translation>
    </message>
    <message>
        <source>A project (.mocapress), a motion or a .mcpr file. Several files, and folders, are added to the library. Or a link (mocapress://...).</source>
        <translation>Un projet (.mocapress), un mouvement ou un fichier .mcpr. Plusieurs fichiers, et des dossiers, vont dans la bibliothèque. Ou un lien (mocapress://...).</translation>
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
        <translation>Note</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>Add Clips</source>
        <translation>Ajouter des clips</translation>
    </message>
    <message>
        <source>Remove Clip</source>
        <translation>Retirer le clip</translation>
    </message>
    <message numerus="yes">
        <source>%Ln clip(s) were taken out of the library; Redo brings them back.</source>
        <translation>
            <numerusform>%Ln clip a été retiré de la bibliothèque ; Rétablir le ramène.</numerusform>
            <numerusform>%Ln clips ont été retirés de la bibliothèque ; Rétablir les ramène.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>No verdict for %Ln clip(s): the file is missing.</source>
        <translation>
            <numerusform>Pas de verdict pour %Ln clip : le fichier manque.</numerusform>
            <numerusform>Pas de verdict pour %Ln clips : le fichier manque.</numerusform>
        </translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Préréglage</translation>
    </message>
    <message numerus="yes">
        <source>The files of %Ln clip(s) have changed.</source>
        <translation>
            <numerusform>Les fichiers de %Ln clip ont changé.</numerusform>
            <numerusform>Les fichiers de %Ln clips ont changé.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The files of %Ln clip(s) are missing. The library&apos;s context menu finds them in another folder.</source>
        <translation>
            <numerusform>Les fichiers de %Ln clip manquent. Le menu contextuel de la bibliothèque les retrouve dans un autre dossier.</numerusform>
            <numerusform>Les fichiers de %Ln clips manquent. Le menu contextuel de la bibliothèque les retrouve dans un autre dossier.</numerusform>
        </translation>
    </message>
    <message>
        <source>Find Clips</source>
        <translation>Retrouver des clips</translation>
    </message>
    <message numerus="yes">
        <source>Found %Ln clip(s)</source>
        <translation>
            <numerusform>%Ln clip retrouvé</numerusform>
            <numerusform>%Ln clips retrouvés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %Ln still missing</source>
        <translation>
            <numerusform>, %Ln manque encore</numerusform>
            <numerusform>, %Ln manquent encore</numerusform>
        </translation>
    </message>
    <message>
        <source>Paste Settings</source>
        <translation>Coller les réglages</translation>
    </message>
    <message>
        <source>Paste Importance</source>
        <translation>Coller l’importance</translation>
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
        <translation>Personnage</translation>
    </message>
    <message>
        <source>The clip&apos;s files changed while it was compressed.</source>
        <translation>Ses fichiers ont changé pendant la compression.</translation>
    </message>
    <message>
        <source>No clip has notes on its frames.</source>
        <translation>Aucun clip n&apos;a de note sur ses images.</translation>
    </message>
    <message numerus="yes">
        <source>Wrote the notes of %Ln file(s) beside them.</source>
        <translation>
            <numerusform>Les notes de %Ln fichier ont été écrites à côté de lui.</numerusform>
            <numerusform>Les notes de %Ln fichiers ont été écrites à côté d’eux.</numerusform>
        </translation>
    </message>
    <message>
        <source>Read Notes</source>
        <translation>Lecture des notes</translation>
    </message>
    <message numerus="yes">
        <source>Read %Ln note(s).</source>
        <translation>
            <numerusform>%Ln note lue.</numerusform>
            <numerusform>%Ln notes lues.</numerusform>
        </translation>
    </message>
    <message>
        <source>The files beside the clips have no other notes.</source>
        <translation>Les fichiers à côté des clips n&apos;ont pas d&apos;autres notes.</translation>
    </message>
    <message>
        <source>nothing changed by more than 1 %</source>
        <translation>rien n’a changé de plus de 1 %</translation>
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
            <numerusform>%Ln clip comparé à %1 : %2 octets avant, %3 maintenant ; %4.</numerusform>
            <numerusform>%Ln clips comparés à %1 : %2 octets avant, %3 maintenant ; %4.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mocapress::LibraryColumns</name>
    <message>
        <source>loop, last pose repeats the first</source>
        <translation>boucle, la dernière pose répète la première</translation>
    </message>
    <message>
        <source>loop</source>
        <translation>boucle</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Clip</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Taux</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Octets</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Worst</source>
        <translation>Pire</translation>
    </message>
    <message>
        <source>Slide</source>
        <translation>Glissement</translation>
    </message>
    <message>
        <source>Eye</source>
        <translation>Œil</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Alertes</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Boucle</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Préréglage</translation>
    </message>
    <message>
        <source>Clip, with its result and verdict</source>
        <translation>Le clip, son résultat, et ce que vous en avez dit</translation>
    </message>
    <message>
        <source>Compression ratio of the motion</source>
        <translation>Combien de fois le mouvement est plus petit</translation>
    </message>
    <message>
        <source>Bytes of the compressed motion</source>
        <translation>Octets du mouvement compressé</translation>
    </message>
    <message>
        <source>Error of the whole clip, eps_x</source>
        <translation>Erreur de tout le clip, eps_x</translation>
    </message>
    <message>
        <source>The largest error of any point at any frame</source>
        <translation>La plus grande erreur d’un point, toutes images confondues</translation>
    </message>
    <message>
        <source>Path of feet that stand in the original, summed over all contacts</source>
        <translation>De combien glissent les pieds posés dans l’original, tous contacts confondus</translation>
    </message>
    <message>
        <source>Visibility of errors</source>
        <translation>Visibilité des erreurs</translation>
    </message>
    <message>
        <source>Verdict of the review</source>
        <translation>Ce que vous en avez dit</translation>
    </message>
    <message>
        <source>Places that were repaired or guessed when the clip was read</source>
        <translation>Notes de la lecture, qui a réparé ou deviné quelque chose</translation>
    </message>
    <message>
        <source>Kind of loop, if the clip is one</source>
        <translation>Si le clip est une boucle</translation>
    </message>
    <message>
        <source>Length of the clip in seconds</source>
        <translation>Durée du clip, en secondes</translation>
    </message>
    <message>
        <source>Preset of the clip&apos;s settings</source>
        <translation>Le préréglage dont viennent ses réglages</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Bytes since</source>
        <translation>Octets depuis</translation>
    </message>
    <message>
        <source>Error since</source>
        <translation>Erreur depuis</translation>
    </message>
    <message>
        <source>Changes since</source>
        <translation>Changements depuis</translation>
    </message>
    <message>
        <source>Bytes that it has more than in the batch that is compared</source>
        <translation>Octets en plus par rapport au lot comparé</translation>
    </message>
    <message>
        <source>Error that it has more than in the batch that is compared</source>
        <translation>Erreur en plus par rapport au lot comparé</translation>
    </message>
    <message>
        <source>Changes since the batch that is compared, the gravest first</source>
        <translation>Changements depuis le lot comparé, les plus graves d’abord</translation>
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
        <translation>en échec</translation>
    </message>
    <message>
        <source>newly visible</source>
        <translation>visible depuis</translation>
    </message>
    <message>
        <source>worse</source>
        <translation>pire</translation>
    </message>
    <message>
        <source>larger</source>
        <translation>plus gros</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>disparu</translation>
    </message>
    <message>
        <source>added</source>
        <translation>ajouté</translation>
    </message>
    <message>
        <source>no longer failed</source>
        <translation>plus en échec</translation>
    </message>
    <message>
        <source>no longer visible</source>
        <translation>plus visible</translation>
    </message>
    <message>
        <source>better</source>
        <translation>meilleur</translation>
    </message>
    <message>
        <source>smaller</source>
        <translation>plus petit</translation>
    </message>
</context>
<context>
    <name>mocapress::LibraryFilter</name>
    <message>
        <source>All clips</source>
        <translation>Tous les clips</translation>
    </message>
    <message>
        <source>Not reviewed</source>
        <translation>Non revus</translation>
    </message>
    <message>
        <source>Approved</source>
        <translation>Approuvés</translation>
    </message>
    <message>
        <source>Rejected</source>
        <translation>Rejetés</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Périmés</translation>
    </message>
    <message>
        <source>With warnings</source>
        <translation>Avec alertes</translation>
    </message>
    <message>
        <source>With visible errors</source>
        <translation>Avec erreurs visibles</translation>
    </message>
    <message>
        <source>Not compressed yet</source>
        <translation>Pas encore compressés</translation>
    </message>
    <message>
        <source>Missed or failed</source>
        <translation>Manqués ou en échec</translation>
    </message>
    <message>
        <source>To review</source>
        <translation>À relire</translation>
    </message>
    <message>
        <source>With notes</source>
        <translation>Avec notes</translation>
    </message>
</context>
<context>
    <name>mocapress::LibraryGroups</name>
    <message>
        <source>By folder</source>
        <translation>Par dossier</translation>
    </message>
    <message>
        <source>By verdict</source>
        <translation>Par verdict</translation>
    </message>
    <message>
        <source>By visibility</source>
        <translation>Par visibilité</translation>
    </message>
    <message>
        <source>As a list</source>
        <translation>En liste</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>By %1</source>
        <comment>title of a column</comment>
        <translation>Par %1</translation>
    </message>
    <message>
        <source>Without warnings</source>
        <translation>Sans alertes</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>moins de %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>de %1 à %2</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>By slide</source>
        <translation>Par glissement</translation>
    </message>
    <message>
        <source>By worst error</source>
        <translation>Par pire erreur</translation>
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
        <translation>Illisible</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Lecture…</translation>
    </message>
    <message numerus="yes">
        <source>%Ln frame(s)</source>
        <translation>
            <numerusform>%Ln image</numerusform>
            <numerusform>%Ln images</numerusform>
        </translation>
    </message>
    <message>
        <source>✓ approved</source>
        <translation>✓ approuvé</translation>
    </message>
    <message>
        <source>✕ rejected</source>
        <translation>✕ rejeté</translation>
    </message>
    <message>
        <source>target met</source>
        <translation>cible atteinte</translation>
    </message>
    <message>
        <source>! target missed</source>
        <translation>! cible manquée</translation>
    </message>
    <message>
        <source>! file missing</source>
        <translation>! fichier manquant</translation>
    </message>
    <message>
        <source>! %1</source>
        <translation>! %1</translation>
    </message>
    <message>
        <source>file missing</source>
        <translation>fichier manquant</translation>
    </message>
    <message>
        <source>file changed</source>
        <translation>fichier modifié</translation>
    </message>
    <message>
        <source>settings changed</source>
        <translation>réglages modifiés</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>files not known</source>
        <translation>fichiers inconnus</translation>
    </message>
    <message>
        <source>✓ stale: %1</source>
        <translation>✓ périmé : %1</translation>
    </message>
    <message>
        <source>✕ stale: %1</source>
        <translation>✕ périmé : %1</translation>
    </message>
    <message numerus="yes">
        <source>%Ln note(s)</source>
        <translation>
            <numerusform>%Ln remarque</numerusform>
            <numerusform>%Ln remarques</numerusform>
        </translation>
    </message>
    <message>
        <source>! cannot be compressed</source>
        <translation>! ne peut être compressé</translation>
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
        <translation>%1 : %2 octets, %3 avant</translation>
    </message>
    <message>
        <source>%1: %2 bytes</source>
        <translation>%1 : %2 octets</translation>
    </message>
    <message>
        <source>%L1 not compressed yet</source>
        <translation>%L1 pas encore compressés</translation>
    </message>
    <message>
        <source>%1: %2 bytes before, %3</source>
        <translation>%1 : %2 octets avant, %3</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>take of a file</comment>
        <translation>%1 : %2</translation>
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
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Clips of the project</source>
        <translation>Clips du projet</translation>
    </message>
    <message>
        <source>Add motion files to the project. Each keeps its own settings.</source>
        <translation>Ajouter des mouvements au projet. Chacun garde ses réglages.</translation>
    </message>
    <message>
        <source>Remove the selected clips from the project; their files stay.</source>
        <translation>Retirer du projet les clips choisis ; leurs fichiers restent.</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>Not reviewed</source>
        <translation>Non examiné</translation>
    </message>
    <message>
        <source>Approved</source>
        <translation>Approuvé</translation>
    </message>
    <message>
        <source>Rejected</source>
        <translation>Rejeté</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>Note about this clip</source>
        <translation>Note sur ce clip</translation>
    </message>
    <message>
        <source>The project keeps this note with the verdict.</source>
        <translation>Gardée dans le projet, avec le verdict.</translation>
    </message>
    <message>
        <source>Export Selected, Each with Its Own Settings…</source>
        <translation>Exporter les clips choisis, chacun avec ses réglages…</translation>
    </message>
    <message>
        <source>Export All, Each with Its Own Settings…</source>
        <translation>Exporter tous les clips, chacun avec ses réglages…</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Filter of the clips</source>
        <translation>Filtre des clips</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtrer</translation>
    </message>
    <message>
        <source>&amp;Clips…</source>
        <translation>&amp;Clips…</translation>
    </message>
    <message>
        <source>&amp;Folder…</source>
        <translation>&amp;Dossier…</translation>
    </message>
    <message>
        <source>Verdict on the selected clips, with their present files and settings.</source>
        <translation>Ce que vous dites des clips sélectionnés, tels que leurs fichiers sont et sont compressés maintenant.</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Préréglage</translation>
    </message>
    <message>
        <source>Find Missing Clips in a Folder…</source>
        <translation>Retrouver les clips manquants dans un dossier…</translation>
    </message>
    <message>
        <source>Clips that are shown</source>
        <translation>Clips montrés</translation>
    </message>
    <message>
        <source>Filter of shown clips</source>
        <translation>Quels clips sont montrés</translation>
    </message>
    <message>
        <source>Groups of the clips</source>
        <translation>Groupes des clips</translation>
    </message>
    <message>
        <source>Order and columns</source>
        <translation>Ordre et colonnes</translation>
    </message>
    <message>
        <source>What clips are sorted by, and the columns beside them</source>
        <translation>Critère de tri des clips, et colonnes à leur côté</translation>
    </message>
    <message>
        <source>Sort By</source>
        <translation>Trier par</translation>
    </message>
    <message>
        <source>Order of the Library</source>
        <translation>Ordre de la bibliothèque</translation>
    </message>
    <message>
        <source>Grouping of clips</source>
        <translation>Comment les clips sont groupés</translation>
    </message>
    <message>
        <source>Copy Settings</source>
        <translation>Copier les réglages</translation>
    </message>
    <message>
        <source>Paste Settings</source>
        <translation>Coller les réglages</translation>
    </message>
    <message>
        <source>Paste Importance Only</source>
        <translation>Coller l’importance seule</translation>
    </message>
    <message>
        <source>Put a Character On…</source>
        <translation>Mettre un personnage…</translation>
    </message>
    <message>
        <source>Take the Character Off</source>
        <translation>Retirer le personnage</translation>
    </message>
    <message>
        <source>Notes on Reading</source>
        <translation>Notes sur la lecture</translation>
    </message>
    <message>
        <source>Words in a clip&apos;s name, folder or state, such as “walks missed”, and bounds on columns, such as “error&gt;=5mm ratio&lt;20”: lengths without a unit are in cm.</source>
        <translation>Mots du nom, du dossier ou de l&apos;état d&apos;un clip, comme « marches manquée », et bornes de colonnes, comme « erreur&gt;=5mm taux&lt;20 » : les longueurs sans unité sont en cm.</translation>
    </message>
</context>
<context>
    <name>mocapress::LibraryPlot</name>
    <message>
        <source>Clips of the library, error over ratio</source>
        <translation>Clips de la bibliothèque, erreur selon le taux</translation>
    </message>
    <message>
        <source>The columns of the library show all measurements.</source>
        <translation>Les colonnes de la bibliothèque ont tous les chiffres.</translation>
    </message>
    <message>
        <source>Compression ratio (smaller files →)</source>
        <translation>Taux de compression (fichiers plus petits →)</translation>
    </message>
    <message>
        <source>eps_x (cm)</source>
        <translation>eps_x (cm)</translation>
    </message>
    <message>
        <source>Clips appear here after they are compressed</source>
        <translation>Compressez les clips de la bibliothèque pour les voir ici</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
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
        <translation>%1, %L2 cible manquée</translation>
    </message>
</context>
<context>
    <name>mocapress::LibraryViews</name>
    <message>
        <source>Add Clips</source>
        <translation>Ajouter des clips</translation>
    </message>
    <message>
        <source>Motion (%1)</source>
        <translation>Mouvement (%1)</translation>
    </message>
    <message>
        <source>Add Folder</source>
        <translation>Ajouter un dossier</translation>
    </message>
    <message>
        <source>Find Missing Clips</source>
        <translation>Retrouver les clips manquants</translation>
    </message>
    <message>
        <source>Put a Character On</source>
        <translation>Mettre un personnage</translation>
    </message>
    <message>
        <source>Characters (*.fbx *.glb *.gltf *.vrm)</source>
        <translation>Personnages (*.fbx *.glb *.gltf *.vrm)</translation>
    </message>
    <message>
        <source>This is the last clip that waits for a verdict.</source>
        <translation>C&apos;est le dernier clip qui attend un verdict.</translation>
    </message>
    <message>
        <source>No clip that is shown waits for a verdict.</source>
        <translation>Aucun clip affiché n&apos;attend de verdict.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Compare Library with a Batch</source>
        <translation>Comparer la bibliothèque à un lot</translation>
    </message>
    <message>
        <source>Batches and projects (batch*.jsonl report*.json report*.html *.mocapress)</source>
        <translation>Lots et projets (batch*.jsonl report*.json report*.html *.mocapress)</translation>
    </message>
</context>
<context>
    <name>mocapress::MainWindow</name>
    <message>
        <source>The language changes when Mocapress is started again.</source>
        <translation>La langue change au prochain démarrage de Mocapress.</translation>
    </message>
    <message>
        <source>%1[*] – %2</source>
        <translation>%1[*] – %2</translation>
    </message>
    <message>
        <source>Your own limits of visibility are not used: %1</source>
        <translation>Vos propres limites de visibilité ne sont pas utilisées : %1</translation>
    </message>
</context>
<context>
    <name>mocapress::MessageBar</name>
    <message>
        <source>Message</source>
        <translation>Message</translation>
    </message>
    <message>
        <source>Close message</source>
        <translation>Fermer le message</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Possible solution</source>
        <translation>Ce qui peut aider</translation>
    </message>
    <message>
        <source>Work in progress</source>
        <translation>Un travail est en cours</translation>
    </message>
</context>
<context>
    <name>mocapress::Methods</name>
    <message>
        <source>Closed-loop wavelets</source>
        <translation>Ondelettes en boucle fermée</translation>
    </message>
    <message>
        <source>Annealed wavelets</source>
        <translation>Ondelettes par recuit</translation>
    </message>
    <message>
        <source>Standard wavelets</source>
        <translation>Ondelettes standard</translation>
    </message>
    <message>
        <source>Per-channel wavelets</source>
        <translation>Ondelettes par canal</translation>
    </message>
    <message>
        <source>Haar wavelets</source>
        <translation>Ondelettes de Haar</translation>
    </message>
    <message>
        <source>Linear wavelets</source>
        <translation>Ondelettes linéaires</translation>
    </message>
    <message>
        <source>PCA</source>
        <translation>ACP</translation>
    </message>
    <message>
        <source>Frame subsampling</source>
        <translation>Sous-échantillonnage d&apos;images</translation>
    </message>
    <message>
        <source>Quaternion wavelets</source>
        <translation>Ondelettes de quaternions</translation>
    </message>
    <message>
        <source>Segment PCA, after Liu &amp; McMillan</source>
        <translation>ACP par segments, d&apos;après Liu et McMillan</translation>
    </message>
    <message>
        <source>Clustered PCA, after Arikan</source>
        <translation>ACP par groupes, d&apos;après Arikan</translation>
    </message>
    <message>
        <source>%1 + IK %L2:1</source>
        <translation>%1 + IK %L2:1</translation>
    </message>
    <message>
        <source>Key frames per track</source>
        <translation>Images clés par piste</translation>
    </message>
</context>
<context>
    <name>mocapress::Names</name>
    <message>
        <source>16-bit runs</source>
        <translation>Suites de 16 bits</translation>
    </message>
    <message>
        <source>16-bit runs + DEFLATE</source>
        <translation>Suites de 16 bits + DEFLATE</translation>
    </message>
    <message>
        <source>Adaptive</source>
        <translation>Adaptatif</translation>
    </message>
    <message>
        <source>Bone ends</source>
        <translation>Bouts d&apos;os</translation>
    </message>
    <message>
        <source>Joint origins</source>
        <translation>Origines d&apos;articulations</translation>
    </message>
    <message>
        <source>Every frame</source>
        <translation>Chaque image</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Contacts</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Shell</source>
        <translation>Coque</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Peau</translation>
    </message>
</context>
<context>
    <name>mocapress::NoteStrip</name>
    <message>
        <source>Notes on frames</source>
        <translation>Notes sur des images</translation>
    </message>
    <message>
        <source>The menu Review adds a note and goes from one to the next.</source>
        <translation>Le menu Revue ajoute une note et va de l&apos;une à l&apos;autre.</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>A click on a mark goes to its frame and joint; the right button edits or removes the note.</source>
        <translation>Un clic sur une marque va à son image et à son articulation ; le bouton droit modifie ou retire la note.</translation>
    </message>
    <message>
        <source>Edit Note…</source>
        <translation>Modifier la note…</translation>
    </message>
    <message>
        <source>Remove Note</source>
        <translation>Retirer la note</translation>
    </message>
</context>
<context>
    <name>mocapress::Notices</name>
    <message numerus="yes">
        <source>The last session ended unexpectedly. Its project was restored: %Ln clip(s).</source>
        <translation>
            <numerusform>La dernière session s&apos;est terminée de façon inattendue. Son projet est de retour : %Ln clip.</numerusform>
            <numerusform>La dernière session s&apos;est terminée de façon inattendue. Son projet est de retour : %Ln clips.</numerusform>
        </translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 enregistré.</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>Ouverture de %1…</translation>
    </message>
    <message>
        <source>Exported %1.</source>
        <translation>%1 exporté.</translation>
    </message>
</context>
<context>
    <name>mocapress::OpenClip</name>
    <message>
        <source>%1 is not the original of the compressed clip: joints, frames or sample rate differ.</source>
        <translation>%1 n&apos;est pas l&apos;original du clip compressé : articulations, images ou cadence diffèrent.</translation>
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
        <translation>Compressé</translation>
    </message>
    <message>
        <source>Difference × %L1</source>
        <translation>Différence × %L1</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Face</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Dessus</translation>
    </message>
</context>
<context>
    <name>mocapress::Panels</name>
    <message>
        <source>Library</source>
        <translation>Bibliothèque</translation>
    </message>
    <message>
        <source>Compression</source>
        <translation>Compression</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Articulations</translation>
    </message>
    <message>
        <source>Footskate</source>
        <translation>Glissement</translation>
    </message>
    <message>
        <source>Error over time</source>
        <translation>Courbe d&apos;erreur</translation>
    </message>
    <message>
        <source>Heat map</source>
        <translation>Carte de chaleur</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Canal</translation>
    </message>
    <message>
        <source>Rate-distortion</source>
        <translation>Débit-distorsion</translation>
    </message>
    <message>
        <source>Importance</source>
        <translation>Importance</translation>
    </message>
    <message>
        <source>Pinned</source>
        <translation>Épinglés</translation>
    </message>
    <message>
        <source>All clips</source>
        <translation>Tous</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Octets</translation>
    </message>
</context>
<context>
    <name>mocapress::PartNames</name>
    <message>
        <source>Clear</source>
        <translation>Effacer</translation>
    </message>
    <message>
        <source>More tools</source>
        <translation>Plus d&apos;outils</translation>
    </message>
</context>
<context>
    <name>mocapress::PinnedModel</name>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Double click to give it another name.</source>
        <translation>Double-cliquer pour changer le nom.</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Taux</translation>
    </message>
    <message>
        <source>Compression ratio</source>
        <translation>Taux de compression</translation>
    </message>
    <message>
        <source>Weighted root mean square distance from the original.</source>
        <translation>Distance quadratique moyenne pondérée à l’original.</translation>
    </message>
    <message>
        <source>95 % of all points at all frames have at most this error.</source>
        <translation>95 % de tous les points et de toutes les images sont en deçà.</translation>
    </message>
    <message>
        <source>Largest error of any point at any frame.</source>
        <translation>Plus grande distance d&apos;un point, toutes images confondues.</translation>
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
        <translation>Max</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Dérive</translation>
    </message>
    <message>
        <source>Largest distance between a standing foot and its place in the original.</source>
        <translation>Le plus loin qu&apos;un pied s&apos;éloigne de l&apos;endroit où il devrait se tenir.</translation>
    </message>
</context>
<context>
    <name>mocapress::PinnedPanel</name>
    <message>
        <source>Pin This</source>
        <translation>Épingler</translation>
    </message>
    <message>
        <source>Make Current</source>
        <translation>Reprendre</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>Ôter</translation>
    </message>
    <message>
        <source>Pinned results</source>
        <translation>Résultats épinglés</translation>
    </message>
    <message>
        <source>Keep the current result in the view, as a figure with its own colour, while you try other settings.</source>
        <translation>Garder en vue le résultat actuel, figure de sa propre couleur, pendant que d&apos;autres réglages sont essayés.</translation>
    </message>
    <message>
        <source>Use the settings of the selected result. This can be undone.</source>
        <translation>Continuer à partir des réglages du résultat choisi. Peut être annulé.</translation>
    </message>
    <message>
        <source>Remove the selected result from the view.</source>
        <translation>Retirer de la vue le résultat choisi.</translation>
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
        <translation>Épingler</translation>
    </message>
    <message>
        <source>Take Off a Pin</source>
        <translation>Désépingler</translation>
    </message>
    <message>
        <source>Name of a Pin</source>
        <translation>Nom d&apos;une épingle</translation>
    </message>
    <message>
        <source>%1 (%L2)</source>
        <translation>%1 (%L2)</translation>
    </message>
    <message>
        <source>The result is not final yet, or four are pinned.</source>
        <translation>Le résultat n&apos;est pas encore définitif, ou quatre sont épinglés.</translation>
    </message>
    <message>
        <source>Four results are pinned already.</source>
        <translation>Quatre résultats sont déjà épinglés.</translation>
    </message>
</context>
<context>
    <name>mocapress::Plots</name>
    <message>
        <source>Copy Image</source>
        <translation>Copier l&apos;image</translation>
    </message>
</context>
<context>
    <name>mocapress::PoseStrip</name>
    <message>
        <source>Poses over time</source>
        <translation>Poses au fil du temps</translation>
    </message>
    <message>
        <source>Poses of the clip along the time; a click goes there.</source>
        <translation>Poses du clip au fil du temps ; un clic y va.</translation>
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
        <translation>Hors de portée pour ce clip par cette méthode.</translation>
    </message>
</context>
<context>
    <name>mocapress::PresetChooser</name>
    <message>
        <source>Preset</source>
        <translation>Préréglage</translation>
    </message>
    <message>
        <source>A preset sets target, method, importance, effort and IK. Your own presets are kept in the settings of this program.</source>
        <translation>Réglages qui vont ensemble : cible, méthode, importance, effort et IK. Les vôtres sont gardés avec les préférences du programme.</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Préréglages</translation>
    </message>
    <message>
        <source>Keep, share and remove presets of your own</source>
        <translation>Garder, partager et retirer vos préréglages</translation>
    </message>
    <message>
        <source>Save as Preset…</source>
        <translation>Enregistrer comme préréglage…</translation>
    </message>
    <message>
        <source>Rename Preset…</source>
        <translation>Renommer le préréglage…</translation>
    </message>
    <message>
        <source>Remove Preset</source>
        <translation>Retirer le préréglage</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importer…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>Custom settings</source>
        <translation>Réglages propres</translation>
    </message>
    <message>
        <source>%1, modified</source>
        <translation>%1, modifié</translation>
    </message>
</context>
<context>
    <name>mocapress::PresetEditor</name>
    <message>
        <source>Hold feet by inverse kinematics</source>
        <translation>Tenir les pieds par cinématique inverse</translation>
    </message>
    <message>
        <source>Kind of target</source>
        <translation>Ce qui est demandé</translation>
    </message>
    <message>
        <source>Error, eps_x</source>
        <translation>Erreur, eps_x</translation>
    </message>
    <message>
        <source>Hard maximum</source>
        <translation>Maximum absolu</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Octets</translation>
    </message>
    <message>
        <source>Coefficient ratio</source>
        <translation>Rapport de coefficients</translation>
    </message>
    <message>
        <source>Value of the target</source>
        <translation>Combien</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Keeps standing feet in place, for some more bytes.</source>
        <translation>Les pieds restent où ils sont dans l&apos;original, pour quelques octets de plus.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Cible</translation>
    </message>
    <message>
        <source>:1</source>
        <translation>:1</translation>
    </message>
    <message>
        <source> bytes</source>
        <translation> octets</translation>
    </message>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source>Visibility</source>
        <translation>Visibilité</translation>
    </message>
    <message>
        <source>Error, eps_x: the weighted root mean square error; single frames may exceed it. Hard maximum: largest error of any point of the body at any frame. Visibility: largest error as a multiple of what people notice; at 1, no error is visible. Quality targets suit all kinds of clips; ratio and bytes ignore how hard a clip is to compress.</source>
        <translation>eps_x : l&apos;erreur quadratique moyenne pondérée, que certaines images peuvent dépasser. Maximum absolu : aucun point du corps n&apos;est plus loin à aucune image. Visibilité : aucun écart ne dépasse tant de fois ce que l&apos;on remarque ; à 1, rien n&apos;est visible. Les cibles de qualité conviennent à tous les clips ; le rapport et les octets ignorent la difficulté d&apos;un clip.</translation>
    </message>
    <message>
        <source> times</source>
        <translation> fois</translation>
    </message>
    <message>
        <source>Weighting</source>
        <translation>Pondération</translation>
    </message>
    <message>
        <source>Points on which the error eps_x is measured. Surface: a body modelled around the bones, so that turned heads and hands count. Skin: the mesh of the clip or of the batch&apos;s character; clips without a mesh are refused. Shell: three points 3 cm from every joint, as in ACL. Bone ends and joint origins: points on the bones, weighted by bone length; joint origins are the paper&apos;s.</source>
        <translation>Les points que compte l&apos;erreur eps_x. Surface : un corps modelé autour des os, si bien que la tête et les mains tournées comptent. Peau : des points du maillage du clip ou du personnage du lot ; les clips sans maillage sont refusés. Coque : trois points à 3 cm de chaque articulation, comme ACL. Extrémités des os et origines des articulations : des points sur les os, selon leur longueur ; les dernières sont celles de l&apos;article.</translation>
    </message>
</context>
<context>
    <name>mocapress::PresetShelf</name>
    <message>
        <source>This is the name of a built-in preset. Choose another name.</source>
        <translation>Le nom d&apos;un préréglage intégré ne peut être donné à un autre.</translation>
    </message>
    <message>
        <source>Save Preset</source>
        <translation>Enregistrer le préréglage</translation>
    </message>
    <message>
        <source>There is a preset %1 already.</source>
        <translation>Il y a déjà un préréglage %1.</translation>
    </message>
    <message>
        <source>Rename Preset</source>
        <translation>Renommer le préréglage</translation>
    </message>
    <message>
        <source>Remove Preset</source>
        <translation>Retirer le préréglage</translation>
    </message>
    <message>
        <source>Import Presets</source>
        <translation>Importer des préréglages</translation>
    </message>
    <message>
        <source>Wrote %1.</source>
        <translation>%1 écrit.</translation>
    </message>
    <message>
        <source>Presets could not be kept: %1</source>
        <translation>Les préréglages n&apos;ont pu être gardés : %1</translation>
    </message>
    <message>
        <source>The presets could not be read; their file was renamed to %1.</source>
        <translation>Les préréglages gardés jusqu&apos;ici sont illisibles ; leur fichier est maintenant %1.</translation>
    </message>
</context>
<context>
    <name>mocapress::PresetViews</name>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Rename Preset</source>
        <translation>Renommer le préréglage</translation>
    </message>
    <message>
        <source>Import Presets</source>
        <translation>Importer des préréglages</translation>
    </message>
    <message>
        <source>Presets (*.json)</source>
        <translation>Préréglages (*.json)</translation>
    </message>
    <message>
        <source>Export Preset</source>
        <translation>Exporter le préréglage</translation>
    </message>
    <message>
        <source>Save as Preset</source>
        <translation>Enregistrer comme préréglage</translation>
    </message>
    <message>
        <source>Save Preset</source>
        <translation>Enregistrer le préréglage</translation>
    </message>
</context>
<context>
    <name>mocapress::Presets</name>
    <message>
        <source>Hero close-up</source>
        <translation>Gros plan du héros</translation>
    </message>
    <message>
        <source>Gameplay</source>
        <translation>Jeu</translation>
    </message>
    <message>
        <source>Crowd</source>
        <translation>Foule</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archive</translation>
    </message>
    <message>
        <source>For archives that replace the source: no point of the body&apos;s surface has an error above 1 mm at any frame.</source>
        <translation>À garder à la place de la source : aucun point de la surface du corps n&apos;a une erreur de plus de 1 mm, à aucune image.</translation>
    </message>
    <message>
        <source>Planted feet</source>
        <translation>Pieds plantés</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Pieds</translation>
    </message>
    <message>
        <source>Hands</source>
        <translation>Mains</translation>
    </message>
    <message>
        <source>Fingers</source>
        <translation>Doigts</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Tête</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Ébauche</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Meilleur</translation>
    </message>
    <message>
        <source>%1 × %L2</source>
        <translation>%1 × %L2</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Contacts</translation>
    </message>
    <message>
        <source>Importance: %1.</source>
        <translation>Importance : %1.</translation>
    </message>
    <message>
        <source>Effort: %1.</source>
        <translation>Effort : %1.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln contact(s) of its own.</source>
        <translation>
            <numerusform>%Ln contact propre.</numerusform>
            <numerusform>%Ln contacts propres.</numerusform>
        </translation>
    </message>
    <message>
        <source>Characters in play: an error of 2.5 mm on the body&apos;s surface, at most 2.5 degrees of heads and 4 of hands.</source>
        <translation>Personnages en jeu : une erreur de 2,5 mm sur la surface du corps, la tête tournée de 2,5 degrés au plus et les mains de 4.</translation>
    </message>
    <message>
        <source>Characters near the camera: an error of 0.65 mm on the body&apos;s surface, about a degree of heads and hands.</source>
        <translation>Personnages que la caméra approche : une erreur de 0,65 mm sur la surface du corps, la tête et les mains tournées d&apos;environ un degré au plus.</translation>
    </message>
    <message>
        <source>Figures in the background: an error of 6 mm on the body&apos;s surface, at most 7.5 degrees of heads and 12 of hands.</source>
        <translation>Figurants : une erreur de 6 mm sur la surface du corps, la tête tournée de 7,5 degrés au plus et les mains de 12.</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Libres</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Égales</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Exactes</translation>
    </message>
    <message>
        <source>Ends: %1.</source>
        <translation>Extrémités : %1.</translation>
    </message>
    <message>
        <source>Like Gameplay, with much less sliding of feet, for 5 to 13 % more bytes.</source>
        <translation>Comme Jeu, avec des pieds qui restent où ils sont posés : bien moins de glissement, pour 5 à 13 % d&apos;octets de plus.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln range(s) with more care.</source>
        <translation>
            <numerusform>%Ln plage plus soignée.</numerusform>
            <numerusform>%Ln plages plus soignées.</numerusform>
        </translation>
    </message>
    <message>
        <source>Watched from %L1 m.</source>
        <translation>Regardé à %L1 m.</translation>
    </message>
</context>
<context>
    <name>mocapress::ProjectFiles</name>
    <message>
        <source>Mocapress projects (*.mocapress)</source>
        <translation>Projets Mocapress (*.mocapress)</translation>
    </message>
    <message>
        <source>Unnamed Project</source>
        <translation>Projet sans nom</translation>
    </message>
    <message>
        <source>Open Project</source>
        <translation>Ouvrir un projet</translation>
    </message>
    <message>
        <source>Save Project</source>
        <translation>Enregistrer le projet</translation>
    </message>
    <message numerus="yes">
        <source>Save the project of %Ln clip(s) under a name?</source>
        <translation>
            <numerusform>Enregistrer sous un nom le projet de %Ln clip ?</numerusform>
            <numerusform>Enregistrer sous un nom le projet de %Ln clips ?</numerusform>
        </translation>
    </message>
    <message>
        <source>A project without a name stays in File &gt; Recent Projects, under its date.</source>
        <translation>Sans nom, il reste sous Fichier &gt; Projets récents, avec sa date.</translation>
    </message>
    <message>
        <source>&amp;Keep It Unnamed</source>
        <translation>&amp;Garder sans nom</translation>
    </message>
    <message>
        <source>Project Not Written</source>
        <translation>Projet non enregistré</translation>
    </message>
    <message>
        <source>The last changes of the project cannot be written. Quit without them?</source>
        <translation>Les dernières modifications du projet ne peuvent pas être enregistrées. Quitter sans elles ?</translation>
    </message>
    <message>
        <source>Use Save Project As to save them to another file.</source>
        <translation>« Enregistrer le projet sous » les place ailleurs.</translation>
    </message>
    <message>
        <source>Project in Use</source>
        <translation>Projet en cours d&apos;utilisation</translation>
    </message>
    <message>
        <source>If Mocapress has ended there, the project can be taken over. If not, each would overwrite the other&apos;s work.</source>
        <translation>Si Mocapress y est terminé, le projet peut être repris. Sinon, chacun écraserait le travail de l&apos;autre.</translation>
    </message>
    <message>
        <source>Take Over</source>
        <translation>Prendre le relais</translation>
    </message>
    <message>
        <source>Unnamed, %1</source>
        <translation>Sans nom, %1</translation>
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
        <translation>Aucun</translation>
    </message>
    <message>
        <source>%1. Open a copy of it?</source>
        <translation>%1. En ouvrir une copie ?</translation>
    </message>
</context>
<context>
    <name>mocapress::RangeActions</name>
    <message>
        <source>More &amp;Care in the Range</source>
        <translation>Plus de soin dans la pla&amp;ge</translation>
    </message>
    <message>
        <source>C&amp;ontacts in the Range</source>
        <translation>C&amp;ontacts dans la plage</translation>
    </message>
    <message>
        <source>The Clip as a Loo&amp;p</source>
        <translation>Le clip en &amp;boucle</translation>
    </message>
    <message>
        <source>As &amp;elsewhere</source>
        <translation>Comme &amp;ailleurs</translation>
    </message>
    <message>
        <source>The target is a size: the other frames get worse</source>
        <translation>La cible est une taille : les autres images se dégradent</translation>
    </message>
    <message>
        <source>%1 times stricter</source>
        <translation>%1 fois plus strict</translation>
    </message>
    <message>
        <source>%1 stands</source>
        <translation>%1 est posé</translation>
    </message>
    <message>
        <source>%1 is in the air</source>
        <translation>%1 est en l&apos;air</translation>
    </message>
    <message>
        <source>No foot stands in this clip</source>
        <translation>Aucun pied n&apos;est posé dans ce clip</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation>&amp;Automatique</translation>
    </message>
    <message>
        <source>&amp;Not a loop</source>
        <translation>&amp;Pas une boucle</translation>
    </message>
    <message>
        <source>The last frame &amp;repeats the first</source>
        <translation>La dernière image &amp;répète la première</translation>
    </message>
    <message>
        <source>The first frame follo&amp;ws the last</source>
        <translation>La première image &amp;suit la dernière</translation>
    </message>
    <message>
        <source>First choose a range: drag along the ruler of the timeline</source>
        <translation>Choisissez d’abord une plage : faites glisser sur la règle de la chronologie</translation>
    </message>
    <message>
        <source>First open a clip</source>
        <translation>Ouvrez d’abord un clip</translation>
    </message>
</context>
<context>
    <name>mocapress::RatePlot</name>
    <message>
        <source>Rate-distortion plot</source>
        <translation>Courbe débit-distorsion</translation>
    </message>
    <message>
        <source>Error over compression ratio, one curve for each method. The table below lists every point.</source>
        <translation>Erreur selon le taux de compression, une courbe par méthode. Le tableau dessous a chaque point.</translation>
    </message>
    <message>
        <source>Compression ratio (smaller files →)</source>
        <translation>Taux de compression (fichiers plus petits →)</translation>
    </message>
    <message>
        <source>current result</source>
        <translation>vous êtes ici</translation>
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
        <translation>approuvé</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>rejeté</translation>
    </message>
    <message>
        <source>the clip&apos;s file changed</source>
        <translation>le fichier du clip a changé</translation>
    </message>
    <message>
        <source>the settings changed</source>
        <translation>les réglages ont changé</translation>
    </message>
    <message>
        <source>the clip&apos;s file and the settings changed</source>
        <translation>le fichier du clip et les réglages ont changé</translation>
    </message>
    <message>
        <source>it does not say which file and settings were reviewed</source>
        <translation>il ne dit pas quels fichier et réglages ont été relus</translation>
    </message>
    <message>
        <source>the file is missing</source>
        <translation>le fichier manque</translation>
    </message>
    <message>
        <source>not visible</source>
        <translation>invisible</translation>
    </message>
    <message>
        <source>borderline</source>
        <translation>limite</translation>
    </message>
    <message>
        <source>visible</source>
        <translation>visible</translation>
    </message>
    <message>
        <source>Sign-off</source>
        <translation>Validation</translation>
    </message>
    <message>
        <source>Sign-off: %1</source>
        <translation>Validation : %1</translation>
    </message>
    <message>
        <source>%1 of %2 reviewed: %3 approved, %4 rejected</source>
        <translation>%1 relus sur %2 : %3 approuvés, %4 rejetés</translation>
    </message>
    <message>
        <source>; %1 verdicts stale</source>
        <translation> ; %1 verdicts périmés</translation>
    </message>
    <message>
        <source>; %1 without a verdict</source>
        <translation> ; %1 sans verdict</translation>
    </message>
    <message>
        <source>Worst frames</source>
        <translation>Pires images</translation>
    </message>
    <message>
        <source>Every clip</source>
        <translation>Tous les clips</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Clip</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>image</translation>
    </message>
    <message>
        <source>error, cm</source>
        <translation>erreur, cm</translation>
    </message>
    <message>
        <source>largest, cm</source>
        <translation>maximum, cm</translation>
    </message>
    <message>
        <source>point</source>
        <translation>point</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>articulation</translation>
    </message>
    <message>
        <source>note</source>
        <translation>note</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>verdict</translation>
    </message>
    <message>
        <source>by</source>
        <translation>par</translation>
    </message>
    <message>
        <source>when</source>
        <translation>quand</translation>
    </message>
    <message>
        <source>stale</source>
        <translation>périmé</translation>
    </message>
    <message>
        <source>eye</source>
        <translation>œil</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>taux</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>octets</translation>
    </message>
    <message>
        <source>A verdict or note is stale if the clip&apos;s file or its settings have changed since; stale verdicts do not count as reviewed. Links open the clip in Mocapress on this computer.</source>
        <translation>Un verdict ou une note est périmé si le fichier du clip ou ses réglages ont changé depuis ; les verdicts périmés ne comptent pas comme relus. Les liens ouvrent le clip dans Mocapress sur cet ordinateur.</translation>
    </message>
    <message>
        <source>%1 from %2 m</source>
        <translation>%1 à %2 m</translation>
    </message>
    <message>
        <source>built-in limits</source>
        <translation>les limites intégrées</translation>
    </message>
    <message>
        <source>The eye judges from the viewing distance that is named, by %1.</source>
        <translation>L&apos;œil juge de la distance indiquée, selon %1.</translation>
    </message>
    <message>
        <source>own limits: %1</source>
        <translation>limites propres : %1</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 ou %2</translation>
    </message>
    <message>
        <source>The frame with the largest error of each clip, the largest first.</source>
        <translation>L&apos;image de plus grande erreur de chaque clip, la plus grande d&apos;abord.</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>image %1</translation>
    </message>
    <message>
        <source>frames %1</source>
        <translation>images %1</translation>
    </message>
    <message>
        <source>stale: %1</source>
        <translation>périmé : %1</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <translation>%1 par %2</translation>
    </message>
    <message>
        <source>largest error %1 cm</source>
        <translation>erreur maximale %1 cm</translation>
    </message>
    <message>
        <source>errors %1, by %2</source>
        <translation>erreurs : %1, selon %2</translation>
    </message>
    <message>
        <source>%1 of %2 at frame %3: %4, noticed from %5</source>
        <translation>%1, %2, image %3 : %4, remarqué à partir de %5</translation>
    </message>
    <message>
        <source>The viewer needs JavaScript.</source>
        <translation>La visionneuse a besoin de JavaScript.</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Voir</translation>
    </message>
    <message>
        <source>%1 cannot be shown: %2</source>
        <translation>%1 ne peut pas être affiché : %2</translation>
    </message>
    <message>
        <source>%1 cannot be loaded</source>
        <translation>%1 ne peut pas être chargé</translation>
    </message>
    <message>
        <source>Previous clip</source>
        <translation>Clip précédent</translation>
    </message>
    <message>
        <source>Next clip</source>
        <translation>Clip suivant</translation>
    </message>
    <message>
        <source>Loading</source>
        <translation>Chargement</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Key: %1</source>
        <translation>Touche : %1</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Superposer</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Côte à côte</translation>
    </message>
    <message>
        <source>Wipe</source>
        <translation>Volet</translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>Échanger</translation>
    </message>
    <message>
        <source>Original</source>
        <translation>Original</translation>
    </message>
    <message>
        <source>Compressed</source>
        <translation>Compressé</translation>
    </message>
    <message>
        <source>Colour by error</source>
        <translation>Colorer par erreur</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Suivre</translation>
    </message>
    <message>
        <source>Worst frame before</source>
        <translation>Pire image précédente</translation>
    </message>
    <message>
        <source>Next worst frame</source>
        <translation>Pire image suivante</translation>
    </message>
    <message>
        <source>Reset camera</source>
        <translation>Réinitialiser la caméra</translation>
    </message>
    <message>
        <source>Frame %1 of %2, %3 s.</source>
        <translation>Image %1 sur %2, %3 s.</translation>
    </message>
    <message>
        <source>On the bones, %1 is %2 cm off.</source>
        <translation>Sur les os, écart de %1 : %2 cm.</translation>
    </message>
    <message>
        <source>The lightest colour is %1 cm.</source>
        <translation>La couleur la plus claire vaut %1 cm.</translation>
    </message>
    <message>
        <source>%1 to %2 s: %3</source>
        <translation>%1 à %2 s : %3</translation>
    </message>
    <message>
        <source>any</source>
        <translation>toutes</translation>
    </message>
    <message>
        <source>Rows are joints, the first row is any joint. A full bar marks times with visible errors, half a bar borderline ones, no bar errors that nobody sees.</source>
        <translation>Chaque ligne est une articulation, la première les réunit toutes. Une barre entière marque les moments où les erreurs sont visibles, une demi-barre ceux où elles sont à la limite ; sans barre, personne ne voit d&apos;erreur.</translation>
    </message>
    <message>
        <source>compression ratio %1 smaller</source>
        <translation>taux de compression %1 plus petit</translation>
    </message>
    <message>
        <source>%1: %2 cm at %3</source>
        <translation>%1 : %2 cm à %3</translation>
    </message>
    <message>
        <source>Batch export</source>
        <translation>Export par lots</translation>
    </message>
    <message>
        <source>Errors from 1 to 2 times the noticeable size are borderline, larger ones visible. Each clip is judged from the viewing distance that its verdict names, by %1. report.csv lists distance and own limits of each clip.</source>
        <translation>De 1 à 2 fois la taille perceptible, une erreur est à la limite ; au-delà, elle est visible. Chaque clip est jugé de la distance que son verdict indique, selon %1. report.csv donne la distance et les limites propres de chaque clip.</translation>
    </message>
    <message>
        <source>clips with visible errors</source>
        <translation>clips avec erreurs visibles</translation>
    </message>
    <message>
        <source>clips with borderline errors</source>
        <translation>clips avec erreurs à la limite</translation>
    </message>
    <message>
        <source>without visible errors</source>
        <translation>sans erreurs visibles</translation>
    </message>
    <message>
        <source>clips done, each read back and measured</source>
        <translation>clips terminés, chacun relu et mesuré</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>en échec</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>reviewed: %1 approved, %2 rejected</source>
        <translation>relus : %1 approuvés, %2 rejetés</translation>
    </message>
    <message>
        <source>stale verdicts</source>
        <translation>verdicts périmés</translation>
    </message>
    <message>
        <source>still waiting</source>
        <translation>encore en attente</translation>
    </message>
    <message>
        <source>compression ratio of all clips together: %1 KB to %2 KB</source>
        <translation>taux de compression de tous les clips ensemble : de %1 à %2 Ko</translation>
    </message>
    <message>
        <source>largest error of any point at any frame; largest %1 %2 cm</source>
        <translation>plus grande erreur d&apos;un point à une image ; plus grand %1 : %2 cm</translation>
    </message>
    <message>
        <source>%1 over its original at its worst frame</source>
        <translation>%1 sur son original, à sa pire image</translation>
    </message>
    <message>
        <source>%1, %2 s: error of %3 cm at the %4.</source>
        <translation>%1, %2 s : erreur de %3 cm, %4.</translation>
    </message>
    <message>
        <source>The frame with the largest error of each of the clips whose errors are most visible: original in grey, compressed in red.</source>
        <translation>L&apos;image de plus grande erreur des clips dont les erreurs se voient le plus : l&apos;original en gris, le compressé en rouge.</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>En échec</translation>
    </message>
    <message>
        <source>No file was written for these clips; older files of theirs are unchanged.</source>
        <translation>Aucun fichier n&apos;a été écrit pour ces clips ; leurs anciens fichiers sont inchangés.</translation>
    </message>
    <message>
        <source>preset</source>
        <translation>préréglage</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>raison</translation>
    </message>
    <message>
        <source>feet held</source>
        <translation>pieds tenus</translation>
    </message>
    <message>
        <source>Errors of the file as read back from the disk, against the original: distances in centimetres, rotation errors of joints, head and hands in degrees.</source>
        <translation>Erreurs du fichier relu sur le disque, par rapport à l&apos;original : distances en centimètres, erreurs de rotation des articulations, de la tête et des mains en degrés.</translation>
    </message>
    <message>
        <source>visibility</source>
        <translation>visibilité</translation>
    </message>
    <message>
        <source>warnings</source>
        <translation>avertissements</translation>
    </message>
    <message>
        <source>max</source>
        <translation>max</translation>
    </message>
    <message>
        <source>at frame</source>
        <translation>à l&apos;image</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>articulations</translation>
    </message>
    <message>
        <source>head</source>
        <translation>tête</translation>
    </message>
    <message>
        <source>hands</source>
        <translation>mains</translation>
    </message>
    <message>
        <source>foot drift</source>
        <translation>dérive des pieds</translation>
    </message>
    <message>
        <source>worst drift</source>
        <translation>pire dérive</translation>
    </message>
    <message>
        <source>foot path</source>
        <translation>trajet des pieds</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>images</translation>
    </message>
    <message>
        <source>asked</source>
        <translation>demandé</translation>
    </message>
    <message>
        <source>method</source>
        <translation>méthode</translation>
    </message>
    <message>
        <source>The charts show the %1 clips with the most visible errors, out of %2.</source>
        <translation>Les graphiques montrent les %1 clips dont les erreurs se voient le plus, sur %2.</translation>
    </message>
    <message>
        <source>Visible errors over time</source>
        <translation>Erreurs visibles dans le temps</translation>
    </message>
    <message>
        <source>%1: visible errors over time</source>
        <translation>%1 : erreurs visibles dans le temps</translation>
    </message>
    <message>
        <source>Repaired or guessed on reading</source>
        <translation>Réparé ou deviné à la lecture</translation>
    </message>
    <message>
        <source>report.csv lists each warning with its file and line.</source>
        <translation>report.csv donne chaque avertissement avec son fichier et sa ligne.</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>avertissement</translation>
    </message>
    <message>
        <source>count</source>
        <translation>nombre</translation>
    </message>
    <message>
        <source>clips</source>
        <translation>clips</translation>
    </message>
    <message>
        <source>Verified</source>
        <translation>Vérifié</translation>
    </message>
    <message>
        <source>Each file was read back and decoded as an engine would, by the runtime decoder within its default limits; errors are those of the decoded motion. Engines cannot play files in the paper&apos;s codings and of comparison methods: the library decodes these. The column verified_by of report.csv names the decoder of each clip.</source>
        <translation>Chaque fichier a été relu et décodé comme le ferait un moteur, par le décodeur d&apos;exécution dans ses limites par défaut ; les erreurs sont celles du mouvement décodé. Les moteurs ne lisent pas les codages de l&apos;article ni les méthodes de comparaison : la bibliothèque décode ces fichiers. La colonne verified_by de report.csv nomme le décodeur de chaque clip.</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Taux</translation>
    </message>
    <message>
        <source>Bytes of the channels as 32-bit floats, divided by the bytes of the coded motion. The skeleton counts on neither side. 1 KB = 1024 bytes.</source>
        <translation>Octets des canaux en flottants de 32 bits, divisés par les octets du mouvement codé. Le squelette ne compte d&apos;aucun côté. 1 Ko = 1024 octets.</translation>
    </message>
    <message>
        <source>Weighted root mean square distance between points of the body and the same points of the original. report.csv has it in two more weightings.</source>
        <translation>Distance quadratique moyenne pondérée entre les points du corps et les mêmes points de l&apos;original. report.csv la donne dans deux autres pondérations.</translation>
    </message>
    <message>
        <source>p95, p99, max</source>
        <translation>p95, p99, max</translation>
    </message>
    <message>
        <source>Percentiles and maximum of these distances over all points and frames, unweighted.</source>
        <translation>Centiles et maximum de ces distances sur tous les points et toutes les images, sans pondération.</translation>
    </message>
    <message>
        <source>Visibility</source>
        <translation>Visibilité</translation>
    </message>
    <message>
        <source>Joints, head, hands</source>
        <translation>Articulations, tête, mains</translation>
    </message>
    <message>
        <source>Angle between a joint&apos;s world-space rotation and the original&apos;s, root mean square over frames and joints. Head and hands are recognised by their names.</source>
        <translation>Angle entre la rotation d&apos;une articulation dans le monde et celle de l&apos;original, moyenne quadratique sur les images et les articulations. La tête et les mains sont reconnues à leurs noms.</translation>
    </message>
    <message>
        <source>Foot drift, foot path</source>
        <translation>Dérive et trajet des pieds</translation>
    </message>
    <message>
        <source>Both are measured while a foot stands in the original. Drift is the distance between a foot and its place in the original, as the mean over contacts and in the worst contact. Path is the length of the foot&apos;s path beyond the original&apos;s, summed over all contacts; a foot that trembles in place has a long path.</source>
        <translation>Les deux se mesurent tant qu&apos;un pied est posé dans l&apos;original. La dérive est la distance entre un pied et sa place dans l&apos;original, en moyenne sur les contacts et au pire contact. Le trajet est la longueur parcourue par le pied au-delà de celle de l&apos;original, sur tous les contacts ; un pied qui tremble sur place a un long trajet.</translation>
    </message>
    <message>
        <source>Verdict, note</source>
        <translation>Verdict, note</translation>
    </message>
    <message>
        <source>The reviewer&apos;s verdict and note, with name and date. A verdict is stale, and does not count, if the clip&apos;s file or its settings have changed since.</source>
        <translation>Le verdict et la note de la personne qui relit, avec nom et date. Un verdict est périmé, et ne compte pas, si le fichier du clip ou ses réglages ont changé depuis.</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Avertissements</translation>
    </message>
    <message>
        <source>Number of places that were repaired or guessed when the clip was read; they are listed above.</source>
        <translation>Nombre d&apos;endroits réparés ou devinés à la lecture du clip ; ils sont donnés ci-dessus.</translation>
    </message>
    <message>
        <source>How clips were measured</source>
        <translation>Comment les clips ont été mesurés</translation>
    </message>
    <message>
        <source>any visibility</source>
        <translation>toute visibilité</translation>
    </message>
    <message>
        <source>any verdict</source>
        <translation>tout verdict</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>with warnings or without</source>
        <translation>avec ou sans avertissements</translation>
    </message>
    <message>
        <source>with warnings</source>
        <translation>avec avertissements</translation>
    </message>
    <message>
        <source>without warnings</source>
        <translation>sans avertissements</translation>
    </message>
    <message>
        <source>max over, cm</source>
        <translation>max au-dessus de, cm</translation>
    </message>
    <message>
        <source>ratio below</source>
        <translation>taux sous</translation>
    </message>
    <message>
        <source>name, preset, reason ...</source>
        <translation>nom, préréglage, raison ...</translation>
    </message>
    <message>
        <source>show all</source>
        <translation>tout afficher</translation>
    </message>
    <message>
        <source>%1 of %2 clips</source>
        <translation>%1 clips sur %2</translation>
    </message>
    <message>
        <source>%1 of %2 clips, the first %3 of them below</source>
        <translation>%1 clips sur %2, les %3 premiers ci-dessous</translation>
    </message>
    <message>
        <source>Compression study</source>
        <translation>Étude de compression</translation>
    </message>
    <message>
        <source>Clips: %1, methods: %2, compressions: %3. Error weighting: %4.</source>
        <translation>Clips : %1, méthodes : %2, compressions : %3. Pondération des erreurs : %4.</translation>
    </message>
    <message>
        <source>Error against compression ratio, averaged over the clips</source>
        <translation>Erreur selon le taux de compression, en moyenne sur les clips</translation>
    </message>
    <message>
        <source>Error against compression ratio</source>
        <translation>Erreur selon le taux de compression</translation>
    </message>
    <message>
        <source>%1: error against compression ratio</source>
        <translation>%1 : erreur selon le taux de compression</translation>
    </message>
    <message>
        <source>The paper</source>
        <translation>L&apos;article</translation>
    </message>
    <message>
        <source>The paper: %1</source>
        <translation>L&apos;article : %1</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 images</translation>
    </message>
    <message>
        <source>one clip</source>
        <translation>un clip</translation>
    </message>
    <message>
        <source>geometric mean of %1 clips</source>
        <translation>moyenne géométrique de %1 clips</translation>
    </message>
    <message>
        <source>%1 at %2 = %3 cm, %4</source>
        <translation>%1 à %2 = %3 cm, %4</translation>
    </message>
    <message>
        <source> (the paper: about %1:1)</source>
        <translation> (l&apos;article : environ %1:1)</translation>
    </message>
    <message>
        <source>smaller than %1 at equal error</source>
        <translation>plus petit que %1 à erreur égale</translation>
    </message>
    <message>
        <source>to compress a frame by %1, including the search for the target</source>
        <translation>pour compresser une image par %1, recherche de l&apos;objectif comprise</translation>
    </message>
    <message>
        <source>Use %1: it has the smallest files at %2 = %3 cm over all clips.</source>
        <translation>Utilisez %1 : ses fichiers sont les plus petits à %2 = %3 cm sur tous les clips.</translation>
    </message>
    <message>
        <source>Recommended method</source>
        <translation>Méthode recommandée</translation>
    </message>
    <message>
        <source>The presets use %1. The table shows the ratio at the error of each preset. Presets also bound the errors of heads, hands and roots, which costs some more bytes.</source>
        <translation>Les préréglages utilisent %1. Le tableau donne le taux à l&apos;erreur de chaque préréglage. Les préréglages bornent aussi les erreurs des têtes, des mains et des racines, ce qui coûte quelques octets de plus.</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Préréglage</translation>
    </message>
    <message>
        <source>mean ratio</source>
        <translation>taux moyen</translation>
    </message>
    <message>
        <source>wavelets by %1</source>
        <translation>ondelettes par %1</translation>
    </message>
    <message>
        <source>no wavelets</source>
        <translation>pas d&apos;ondelettes</translation>
    </message>
    <message>
        <source>Bytes of the channels as 32-bit floats, divided by the bytes of the coded motion. The skeleton counts on neither side, as in the paper. 1 KB = 1024 bytes.</source>
        <translation>Octets des canaux en flottants de 32 bits, divisés par les octets du mouvement codé. Le squelette ne compte d&apos;aucun côté, comme dans l&apos;article. 1 Ko = 1024 octets.</translation>
    </message>
    <message>
        <source>The paper&apos;s positional distortion (section 3.1), weighted by %1: the weighted root mean square distance between points of the body and the same points of the original. The paper&apos;s own figures use the weighting %2.</source>
        <translation>La distorsion de position de l&apos;article (section 3.1), pondérée selon « %1 » : la distance quadratique moyenne pondérée entre les points du corps et les mêmes points de l&apos;original. Les chiffres de l&apos;article utilisent la pondération « %2 ».</translation>
    </message>
    <message>
        <source>Judged from %1 m, by %2.</source>
        <translation>Jugée de %1 m, selon %2.</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>Geometric mean over the clips of the ratio at equal %1, at errors within the measured range of every clip. Ratios between measured points are interpolated, linearly in the logarithms of ratio and error, and marked %2.</source>
        <translation>Moyenne géométrique sur les clips du taux à %1 égal, aux erreurs mesurées pour tous les clips. Entre les points mesurés, les taux sont interpolés linéairement dans les logarithmes du taux et de l&apos;erreur, et marqués %2.</translation>
    </message>
    <message>
        <source>Coding</source>
        <translation>Codage</translation>
    </message>
    <message>
        <source>%1, seed %2</source>
        <translation>%1, graine %2</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Wall time of a compression, including the search for the target; compressions at the same time: up to %1. Work that the compressions of a clip share counts in the first of them. The paper used a 2 GHz Athlon 64.</source>
        <translation>Temps réel d&apos;une compression, recherche de l&apos;objectif comprise ; compressions simultanées : jusqu&apos;à %1. Le travail commun aux compressions d&apos;un clip compte dans la première. L&apos;article utilisait un Athlon 64 à 2 GHz.</translation>
    </message>
    <message>
        <source>Figures marked as the paper&apos;s are from Tables 1 and 2 of %1.</source>
        <translation>Les chiffres attribués à l&apos;article viennent des tableaux 1 et 2 de %1.</translation>
    </message>
    <message>
        <source>These methods have no mean, since no error is within the range of all clips: %1.</source>
        <translation>Ces méthodes n&apos;ont pas de moyenne, car aucune erreur n&apos;est dans la plage de tous les clips : %1.</translation>
    </message>
    <message>
        <source>Files are smaller to the right, errors smaller to the bottom. Curves are geometric means of the ratio at equal error. The dotted line is 0.5 cm: the paper saw no artifacts below it.</source>
        <translation>Les fichiers sont plus petits vers la droite, les erreurs plus petites vers le bas. Les courbes sont des moyennes géométriques du taux à erreur égale. La ligne pointillée est à 0.5 cm : l&apos;article n&apos;a pas vu d&apos;artefacts en dessous.</translation>
    </message>
    <message>
        <source>Hollow marks are the paper&apos;s Table 1.</source>
        <translation>Les marques creuses sont du tableau 1 de l&apos;article.</translation>
    </message>
    <message>
        <source>frame %1, %2 s</source>
        <translation>image %1, %2 s</translation>
    </message>
    <message>
        <source>%1 at %2: %3 %4 cm over the clip, largest error %5 cm; at this frame: %6.</source>
        <translation>%1 à %2 : %3 %4 cm sur le clip, erreur maximale %5 cm ; à cette image : %6.</translation>
    </message>
    <message>
        <source>%1, %2 to %3</source>
        <translation>%1, %2 à %3</translation>
    </message>
    <message>
        <source>%1: foot that slides most</source>
        <translation>%1 : pied qui glisse le plus</translation>
    </message>
    <message>
        <source>%1: %2 slides %3 cm while planted.</source>
        <translation>%1 : %2 glisse de %3 cm alors qu&apos;il est posé.</translation>
    </message>
    <message>
        <source>%1 at %2:1</source>
        <translation>%1 à %2:1</translation>
    </message>
    <message>
        <source>Compressed motion in red over the original in grey, all at the same ratio. The first pictures show the frame with the largest error of %1: %2. Lines on the floor are half a metre apart.</source>
        <translation>Le mouvement compressé en rouge sur l&apos;original en gris, tous au même taux. Les premières images montrent le moment de plus grande erreur de %1 : %2. Les lignes du sol sont espacées d&apos;un demi-mètre.</translation>
    </message>
    <message>
        <source>The foot that slides most</source>
        <translation>Le pied qui glisse le plus</translation>
    </message>
    <message>
        <source>Path of the foot over the floor during one contact: original in grey, compressed dark.</source>
        <translation>Trajet du pied sur le sol pendant un contact : original en gris, compressé en foncé.</translation>
    </message>
    <message>
        <source>Size at equal error</source>
        <translation>Taille à erreur égale</translation>
    </message>
    <message>
        <source>Time of the annealing</source>
        <translation>Temps du recuit</translation>
    </message>
    <message>
        <source>Feet held by inverse kinematics</source>
        <translation>Pieds tenus par cinématique inverse</translation>
    </message>
    <message>
        <source>Sliding feet</source>
        <translation>Pieds qui glissent</translation>
    </message>
    <message>
        <source>Rotation errors</source>
        <translation>Erreurs de rotation</translation>
    </message>
    <message>
        <source>Missed targets</source>
        <translation>Objectifs manqués</translation>
    </message>
    <message>
        <source>drift %1</source>
        <translation>dérive %1</translation>
    </message>
    <message>
        <source>contacts</source>
        <translation>contacts</translation>
    </message>
    <message>
        <source>mean of a contact</source>
        <translation>moyenne par contact</translation>
    </message>
    <message>
        <source>At the paper&apos;s coefficient ratio r = %1</source>
        <translation>Au rapport de coefficients de l&apos;article r = %1</translation>
    </message>
    <message>
        <source>At the compression ratio %1:1</source>
        <translation>Au taux de compression %1:1</translation>
    </message>
    <message>
        <source>KB (ratio)</source>
        <translation>Ko (taux)</translation>
    </message>
    <message>
        <source>paper</source>
        <translation>article</translation>
    </message>
    <message>
        <source>ms a frame</source>
        <translation>ms par image</translation>
    </message>
    <message>
        <source>iterations</source>
        <translation>itérations</translation>
    </message>
    <message>
        <source>paper: ms</source>
        <translation>article : ms</translation>
    </message>
    <message>
        <source>Horizontal path of the feet during contacts, beyond the original&apos;s; in brackets the mean contact and the worst contact. Contacts are detected in the original; clips without contacts are not listed.</source>
        <translation>Trajet horizontal des pieds pendant les contacts, au-delà de celui de l&apos;original ; entre parenthèses, le contact moyen et le pire. Les contacts sont détectés dans l&apos;original ; les clips sans contact ne figurent pas.</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>secondes</translation>
    </message>
    <message>
        <source>Compression ratio at %1.</source>
        <translation>Taux de compression à %1.</translation>
    </message>
    <message>
        <source>Angle between a joint&apos;s world-space rotation and the original&apos;s, root mean square over frames and joints; in brackets that of the head and of the worse hand, if they are recognised by their names. Measured at %1.</source>
        <translation>Angle entre la rotation d&apos;une articulation dans le monde et celle de l&apos;original, moyenne quadratique sur les images et les articulations ; entre parenthèses, celui de la tête et de la pire main, si leurs noms les font reconnaître. Mesuré à %1.</translation>
    </message>
    <message>
        <source>%1 (cm) without, with IK</source>
        <translation>%1 (cm) sans, avec IK</translation>
    </message>
    <message>
        <source>footskate (cm) without, with IK</source>
        <translation>glissement (cm) sans, avec IK</translation>
    </message>
    <message>
        <source>without</source>
        <translation>sans</translation>
    </message>
    <message>
        <source>with</source>
        <translation>avec</translation>
    </message>
    <message>
        <source>knee</source>
        <translation>genou</translation>
    </message>
    <message>
        <source>Clips with and without IK have the same compression ratio, so bytes of the correction are missing elsewhere. Knee: its highest speed, divided by that of the original.</source>
        <translation>Les clips avec et sans IK ont le même taux de compression : les octets de la correction manquent donc ailleurs. Genou : sa plus grande vitesse, divisée par celle de l&apos;original.</translation>
    </message>
    <message>
        <source>every method</source>
        <translation>toutes les méthodes</translation>
    </message>
    <message>
        <source>%1 gave %2</source>
        <translation>%1 a donné %2</translation>
    </message>
    <message>
        <source>%1 combinations of clip and method missed a target</source>
        <translation>%1 combinaisons de clip et de méthode ont manqué un objectif</translation>
    </message>
    <message>
        <source>missed target</source>
        <translation>objectif manqué</translation>
    </message>
    <message>
        <source>first reason</source>
        <translation>première raison</translation>
    </message>
    <message>
        <source>nearest result</source>
        <translation>résultat le plus proche</translation>
    </message>
    <message>
        <source>Cubic wavelets, coefficients moved between channels by annealing: the paper&apos;s Algorithm 1, candidates compared by a quadratic error model.</source>
        <translation>Ondelettes cubiques, coefficients déplacés entre les canaux par recuit : l&apos;algorithme 1 de l&apos;article, candidats comparés par un modèle quadratique de l&apos;erreur.</translation>
    </message>
    <message>
        <source>Cubic wavelets, the largest coefficients of all channels, angles scaled by the length of the bone: the paper&apos;s section 4.</source>
        <translation>Ondelettes cubiques, les plus grands coefficients de tous les canaux, angles multipliés par la longueur de l&apos;os : section 4 de l&apos;article.</translation>
    </message>
    <message>
        <source>Cubic wavelets, the largest coefficients of each channel, equally many: the paper&apos;s first approach in section 4.</source>
        <translation>Ondelettes cubiques, les plus grands coefficients de chaque canal, en nombre égal : première approche de l&apos;article, section 4.</translation>
    </message>
    <message>
        <source>Standard selection in the Haar basis, with which Arikan (2006) compared.</source>
        <translation>Sélection standard dans la base de Haar, à laquelle Arikan (2006) s&apos;est comparé.</translation>
    </message>
    <message>
        <source>Standard selection in the interpolating linear basis.</source>
        <translation>Sélection standard dans la base linéaire interpolante.</translation>
    </message>
    <message>
        <source>Cubic wavelets, each coefficient quantised by what its step does to the error in the world, channels making good what others lost; adaptive coding.</source>
        <translation>Ondelettes cubiques, chaque coefficient quantifié selon l&apos;effet de son pas sur l&apos;erreur dans le monde, les canaux compensant ce que d&apos;autres ont perdu ; codage adaptatif.</translation>
    </message>
    <message>
        <source>Our reading of Arikan (2006): clustered PCA of short Bezier curves of virtual markers, the database being the clip alone; k-means clusters, DEFLATE, and no special care of the feet.</source>
        <translation>Notre lecture d&apos;Arikan (2006) : PCA par groupes de courtes courbes de Bézier de marqueurs virtuels, la base de données étant le clip seul ; groupes par k-moyennes, DEFLATE, sans soin particulier des pieds.</translation>
    </message>
    <message>
        <source>What engines do: each channel by itself, key frames left out where a line comes within the tolerance, steps as fine as the channel needs (as ACL&apos;s bit rates), DEFLATE.</source>
        <translation>Ce que font les moteurs : chaque canal à part, images clés omises là où une droite reste dans la tolérance, pas aussi fin que le canal le demande (comme les débits d&apos;ACL), DEFLATE.</translation>
    </message>
    <message>
        <source>Our reading of Liu and McMillan (2006): PCA of segments, adaptive key frames with cubic splines; on channels weighted by what they move, not on markers, and with no special care of the feet.</source>
        <translation>Notre lecture de Liu et McMillan (2006) : PCA par segments, images clés adaptatives avec splines cubiques ; sur des canaux pondérés par ce qu&apos;ils déplacent et non sur des marqueurs, sans soin particulier des pieds.</translation>
    </message>
    <message>
        <source>Principal components of the poses without the root&apos;s position, everything in 16 bits, DEFLATE: the paper&apos;s section 3.2.</source>
        <translation>Composantes principales des poses sans la position de la racine, tout en 16 bits, DEFLATE : section 3.2 de l&apos;article.</translation>
    </message>
    <message>
        <source>Cubic wavelets on unit quaternions, coefficients moved between components by annealing on the linearised rotation: the paper&apos;s section 6.3.</source>
        <translation>Ondelettes cubiques sur des quaternions unitaires, coefficients déplacés entre composantes par recuit sur la rotation linéarisée : section 6.3 de l&apos;article.</translation>
    </message>
    <message>
        <source>Every s-th frame in 16 bits, DEFLATE; natural cubic splines between.</source>
        <translation>Une image sur s en 16 bits, DEFLATE ; splines cubiques naturelles entre elles.</translation>
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
        <translation>taux de compression</translation>
    </message>
    <message>
        <source>Bytes of the channels as 32-bit floats, divided by the compressed motion bytes. The skeleton counts in neither, as in the paper.</source>
        <translation>Octets des canaux en tableau de flottants de 32 bits sur les octets du mouvement compressé ; le squelette n&apos;est compté ni dans l&apos;un ni dans l&apos;autre, comme dans l&apos;article.</translation>
    </message>
    <message>
        <source>eps_x</source>
        <translation>eps_x</translation>
    </message>
    <message>
        <source>Root mean square distance between original and compressed, weighted by bone length.</source>
        <translation>Distance quadratique moyenne entre original et compressé, pondérée par la longueur d&apos;os.</translation>
    </message>
    <message>
        <source>State of the result</source>
        <translation>État de la réponse</translation>
    </message>
    <message>
        <source>95 % of points within</source>
        <translation>95 % des points à moins de</translation>
    </message>
    <message>
        <source>95th percentile of the distance over all joints and frames, unweighted.</source>
        <translation>95e centile de la distance sur toutes les articulations et images, non pondéré.</translation>
    </message>
    <message>
        <source>99 % of points within</source>
        <translation>99 % des points à moins de</translation>
    </message>
    <message>
        <source>99th percentile of the distance over all joints and frames, unweighted.</source>
        <translation>99e centile de la distance sur toutes les articulations et images, non pondéré.</translation>
    </message>
    <message>
        <source>Worst point</source>
        <translation>Pire point</translation>
    </message>
    <message>
        <source>Largest error of any point at any frame.</source>
        <translation>Plus grande erreur d&apos;un point quelconque, toutes images confondues.</translation>
    </message>
    <message>
        <source>Motion / file</source>
        <translation>Mouvement / fichier</translation>
    </message>
    <message>
        <source>Compressed motion bytes, and bytes of the whole file with its skeleton.</source>
        <translation>Octets du mouvement compressé, et octets de tout le fichier avec son squelette.</translation>
    </message>
    <message>
        <source>Coefficient ratio</source>
        <translation>Taux de coefficients</translation>
    </message>
    <message>
        <source>The paper&apos;s r: all wavelet coefficients over those that are kept.</source>
        <translation>Le r de l&apos;article : tous les coefficients d&apos;ondelettes sur ceux qui sont gardés.</translation>
    </message>
    <message>
        <source>Bits per joint-sample</source>
        <translation>Bits par échantillon</translation>
    </message>
    <message>
        <source>Motion bits for one joint at one frame; unlike a ratio it needs no baseline.</source>
        <translation>Bits du mouvement pour une articulation à une image : ne dépend d&apos;aucune référence.</translation>
    </message>
    <message>
        <source>IK signals</source>
        <translation>Signaux IK</translation>
    </message>
    <message>
        <source>Motion bytes of the correction that holds the feet, and its ratio r_IK.</source>
        <translation>Ce que tenir les pieds prend des octets du mouvement, et son taux r_IK.</translation>
    </message>
    <message>
        <source>Fastest knee</source>
        <translation>Genou le plus rapide</translation>
    </message>
    <message>
        <source>Highest speed of a held leg&apos;s knee, and that of the original. A much higher speed means that the correction makes the knee snap.</source>
        <translation>La plus grande vitesse du genou d&apos;une jambe tenue, et celle de l&apos;original : une correction ne doit pas faire claquer les genoux.</translation>
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
        <translation>Visibilité</translation>
    </message>
    <message>
        <source>The most visible error, beside the size that people notice.</source>
        <translation>Si un écart dépasse ce que l&apos;on remarque.</translation>
    </message>
    <message>
        <source>Loop: seam</source>
        <translation>Boucle : raccord</translation>
    </message>
    <message>
        <source>First / last pose</source>
        <translation>Première / dernière pose</translation>
    </message>
    <message>
        <source>Change of the errors of pose and velocity from the last frame to the first: the jump where the loop starts again.</source>
        <translation>De combien l&apos;écart des poses et des vitesses change de la dernière image à la première : ce qui saute là où la boucle recommence.</translation>
    </message>
    <message>
        <source>RMS error of the first and the last pose on the body&apos;s surface. Clips are blended there.</source>
        <translation>De combien la première et la dernière pose s&apos;écartent de l&apos;original, sur la surface du corps : là où les séquences sont enchaînées.</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <comment>poses</comment>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Loop: elsewhere</source>
        <translation>Boucle : ailleurs</translation>
    </message>
    <message>
        <source>The largest change of errors between two neighbouring frames. A smaller one at the seam does not stand out.</source>
        <translation>Le plus grand changement de ce genre entre deux images successives. Un raccord en dessous ne ressort pas.</translation>
    </message>
    <message>
        <source>%1, %2/frame</source>
        <translation>%1, %2/image</translation>
    </message>
    <message>
        <source>On the skin: worst / RMS</source>
        <translation>Sur la peau : pire / RMS</translation>
    </message>
    <message>
        <source>Errors of points spread evenly over the mesh, over all frames.</source>
        <translation>Distances de points répartis régulièrement sur le maillage, sur toutes les images.</translation>
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
        <translation>Dérive du pied : moy. / pire</translation>
    </message>
    <message>
        <source>Distance between a standing foot and its place in the original, over all contacts.</source>
        <translation>De combien un pied s&apos;éloigne de l&apos;endroit où il devrait se tenir, sur ses contacts.</translation>
    </message>
    <message>
        <source>Foot path: all / worst</source>
        <translation>Chemin des pieds : tout / pire</translation>
    </message>
    <message>
        <source>Path of the feet over the ground while they stand, beyond the original&apos;s: sum over the clip, and worst contact. A foot that trembles in place has a long path.</source>
        <translation>Longueur du chemin des pieds sur le sol pendant qu&apos;ils se tiennent, au-delà de celui de l&apos;original : sommée sur le clip, et pour le pire contact. Le tremblement d&apos;un pied sur place s&apos;y additionne.</translation>
    </message>
    <message>
        <source>%1, %2 at %L3 s: %L4 times the noticeable error; not noticed beyond %L5 m</source>
        <translation>%1, %2 à %L3 s : %L4 fois l&apos;erreur perceptible ; invisible au-delà de %L5 m</translation>
    </message>
    <message>
        <source>Most visible error</source>
        <translation>Erreur la plus visible</translation>
    </message>
    <message>
        <source>All figures</source>
        <translation>Tous les chiffres</translation>
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
        <translation>Ouvrir le clip suivant qui attend un verdict (Q)</translation>
    </message>
    <message>
        <source>Next to review</source>
        <translation>Suivant à relire</translation>
    </message>
    <message>
        <source>Clips that are reviewed</source>
        <translation>Clips relus</translation>
    </message>
    <message>
        <source>%L1 of %L2 reviewed</source>
        <translation>%L1 relus sur %L2</translation>
    </message>
    <message>
        <source>%1, %L2 rejected</source>
        <translation>%1, %L2 rejetés</translation>
    </message>
</context>
<context>
    <name>mocapress::Sentence</name>
    <message>
        <source>%1 not finite or beyond 1e9, replaced by the frame before</source>
        <translation>%1 : non finies ou au-delà de 1e9, remplacées par l&apos;image précédente</translation>
    </message>
    <message>
        <source>%1 with the name of another joint, numbered: Name.2</source>
        <translation>%1 portant le nom d&apos;une autre, numérotées : Nom.2</translation>
    </message>
    <message>
        <source>%1 with the name of another joint</source>
        <translation>%1 portant le nom d&apos;une autre</translation>
    </message>
    <message>
        <source>the file ends within its last frame, which is dropped</source>
        <translation>le fichier se termine au milieu de sa dernière image, qui est laissée de côté</translation>
    </message>
    <message>
        <source>keys lie unevenly: %1 of %2 frames carry keys; frames between are interpolated</source>
        <translation>les clés sont irrégulières : %1 images sur %2 en portent ; les autres sont interpolées</translation>
    </message>
    <message>
        <source>take %1 is read; there are also %2</source>
        <translation>la prise %1 est lue ; il y a aussi %2</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 et %2 de plus</translation>
    </message>
    <message>
        <source>looks like an additive clip, near its rest pose with the root at the origin: errors are those that it makes on that pose, and where feet stand means nothing</source>
        <translation>ressemble à un clip additif, près de sa pose de repos avec la racine à l&apos;origine : les erreurs sont celles sur cette pose, et les appuis des pieds n&apos;ont pas de sens</translation>
    </message>
    <message>
        <source>no bone has a length: errors are measured on three points 3 cm from each joint</source>
        <translation>aucun os n&apos;a de longueur : les erreurs sont mesurées sur trois points à 3 cm de chaque articulation</translation>
    </message>
    <message>
        <source>the mesh reaches much further than the bones at %1, first %2 (%3 cm, not %4): the surface there is the mesh</source>
        <translation>le maillage dépasse de loin les os à %1, d&apos;abord %2 (%3 cm au lieu de %4) : la surface y est le maillage</translation>
    </message>
    <message>
        <source>the figure stands along Z, but Y is taken to point up: --up z, or the import options of the studio, read it upright</source>
        <translation>la figure est debout selon Z, mais Y est pris pour le haut : --up z, ou les options d&apos;importation du studio, la redressent</translation>
    </message>
    <message>
        <source>%1 beside other children left out</source>
        <translation>%1 à côté d&apos;autres enfants laissés de côté</translation>
    </message>
    <message>
        <source>the header says %1 frames, %2 follow: all of them are read</source>
        <translation>l&apos;en-tête annonce %1 images, %2 suivent : toutes sont lues</translation>
    </message>
    <message>
        <source>%1 of scale kept as tracks, which move no joint</source>
        <translation>%1 d&apos;échelle gardés comme pistes, qui ne déplacent aucune articulation</translation>
    </message>
    <message>
        <source>a Frame Time of %1 s cannot be right: taken as %2 frames per second</source>
        <translation>un Frame Time de %1 s ne peut être juste : pris pour %2 images par seconde</translation>
    </message>
    <message>
        <source>translation channels of the root are taken to replace OFFSET, as their values suggest</source>
        <translation>les translations de la racine remplacent OFFSET, comme leurs valeurs le suggèrent</translation>
    </message>
    <message>
        <source>translation channels of the joints below the root are taken to replace OFFSET, as their values suggest</source>
        <translation>les translations sous la racine remplacent OFFSET, comme leurs valeurs le suggèrent</translation>
    </message>
    <message>
        <source>translation channels of the root are taken to replace OFFSET, as Blender and MotionBuilder do: their values do not tell</source>
        <translation>les translations de la racine remplacent OFFSET, comme le font Blender et MotionBuilder : leurs valeurs n&apos;en disent rien</translation>
    </message>
    <message>
        <source>translation channels of the joints below the root are taken to replace OFFSET, as Blender and MotionBuilder do: their values do not tell</source>
        <translation>les translations sous la racine remplacent OFFSET, comme le font Blender et MotionBuilder : leurs valeurs n&apos;en disent rien</translation>
    </message>
    <message>
        <source>no unit of length is given: a rest pose %1 units tall is taken to have %2 cm to the unit</source>
        <translation>aucune unité de longueur n&apos;est donnée : à une pose de repos haute de %1 unités sont attribués %2 cm par unité</translation>
    </message>
    <message>
        <source>frame numbers do not run 1, 2, 3 from here: frames are taken as they come</source>
        <translation>à partir d&apos;ici les numéros d&apos;image ne se suivent pas : les images sont prises comme elles viennent</translation>
    </message>
    <message>
        <source>%1 missing from a frame, where the frame before is repeated</source>
        <translation>%1 manquant dans une image, où la précédente est répétée</translation>
    </message>
    <message>
        <source>%1 with three values where the skeleton names fewer, read as its dof and the axes missing from it</source>
        <translation>%1 avec trois valeurs là où le squelette en nomme moins, lues selon ses dof puis les axes qui y manquent</translation>
    </message>
    <message>
        <source>%1 with three values where the skeleton names fewer, read as rx ry rz</source>
        <translation>%1 avec trois valeurs là où le squelette en nomme moins, lues comme rx ry rz</translation>
    </message>
    <message>
        <source>%1 with dof but without values, left at rest</source>
        <translation>%1 avec des dof mais sans valeurs, laissés au repos</translation>
    </message>
    <message>
        <source>%1 with a length that changes (dof l), which is ignored</source>
        <translation>%1 à longueur variable (dof l), ce qui est ignoré</translation>
    </message>
    <message>
        <source>%1 whose scale changes over time: joints are in their places, those of joints are kept as tracks, but errors are measured on a skin with the scales of the first frame</source>
        <translation>%1 à échelle variable : les articulations sont à leur place et leurs échelles gardées comme pistes, mais les erreurs sont mesurées sur une peau à l&apos;échelle de la première image</translation>
    </message>
    <message>
        <source>%1 scaled unevenly, first %2: joints are in their places, but a skin has the scales of the first frame</source>
        <translation>%1 à l&apos;échelle inégale, d&apos;abord %2 : les articulations sont à leur place, mais une peau a l&apos;échelle de la première image</translation>
    </message>
    <message>
        <source>%1 of the animation left out, which moves no node</source>
        <translation>%1 de l&apos;animation laissé de côté, qui ne déplace aucun nœud</translation>
    </message>
    <message>
        <source>%1 of the animation left out, which move no node</source>
        <translation>%1 de l&apos;animation laissés de côté, qui ne déplacent aucun nœud</translation>
    </message>
    <message>
        <source>morph weights are not read: the file %1</source>
        <translation>les poids de morphing ne sont pas lus : le fichier %1</translation>
    </message>
    <message>
        <source>its character is not read: %1</source>
        <translation>son personnage n&apos;est pas lu : %1</translation>
    </message>
    <message>
        <source>the picture %1 is not shown: %2</source>
        <translation>l&apos;image %1 n&apos;est pas montrée : %2</translation>
    </message>
    <message>
        <source>it is not beside the file</source>
        <translation>elle n&apos;est pas à côté du fichier</translation>
    </message>
    <message>
        <source>it is neither PNG nor JPEG</source>
        <translation>elle n&apos;est ni PNG ni JPEG</translation>
    </message>
    <message>
        <source>it has more than 64 MiB</source>
        <translation>elle dépasse 64 Mio</translation>
    </message>
    <message>
        <source>it has more than %1 bones</source>
        <translation>il a plus de %1 os</translation>
    </message>
    <message>
        <source>it has too many vertices</source>
        <translation>il a trop de sommets</translation>
    </message>
    <message>
        <source>a vertex is not finite, or farther than 1e9 cm away</source>
        <translation>un sommet n&apos;est pas fini, ou à plus de 1e9 cm</translation>
    </message>
    <message>
        <source>the first take, %1, stands still</source>
        <translation>la première prise, %1, est immobile</translation>
    </message>
    <message>
        <source>%1 left out: not a finite number</source>
        <translation>%1 de côté : pas un nombre fini</translation>
    </message>
    <message>
        <source>%1 stated again: each counts once</source>
        <translation>%1 en double dans le fichier : chacune compte une fois</translation>
    </message>
    <message>
        <source>%1 with spheric XYZ angles, which are read as XYZ angles</source>
        <translation>%1 avec des angles XYZ sphériques, lus comme des angles XYZ</translation>
    </message>
    <message>
        <source>%1 of weights or properties left out: too many, too long a name, or beyond 1e9</source>
        <translation>%1 de poids ou de propriétés de côté : trop nombreuses, au nom trop long ou au-delà de 1e9</translation>
    </message>
    <message>
        <source>the clip has no joint %1, nor %2 more: what hangs there stays in its bind pose</source>
        <translation>le clip n&apos;a pas d&apos;articulation %1, ni %2 autre(s) : ce qui y tient reste dans sa pose de liaison</translation>
    </message>
    <message>
        <source>the clip has no joint %1: what hangs there stays in its bind pose</source>
        <translation>le clip n&apos;a pas d&apos;articulation %1 : ce qui y tient reste dans sa pose de liaison</translation>
    </message>
    <message>
        <source>the clip has no joint %1, nor %2 more: they carry most of the character</source>
        <translation>le clip n&apos;a pas d&apos;articulation %1, ni %2 autre(s) : elles portent l&apos;essentiel du personnage</translation>
    </message>
    <message>
        <source>the clip has no joint %1: they carry most of the character</source>
        <translation>le clip n&apos;a pas d&apos;articulation %1 : elle porte l&apos;essentiel du personnage</translation>
    </message>
    <message>
        <source>has other proportions than the clip, and legs of %1 % the length: it is shown and coloured with its own bones, and figures are measured on the clip&apos;s</source>
        <translation>a d&apos;autres proportions que le clip, et des jambes de %1 % de leur longueur : il est montré et coloré avec ses propres os, et les chiffres sont mesurés sur ceux du clip</translation>
    </message>
    <message>
        <source>is not put on: %1</source>
        <translation>n&apos;est pas mis : %1</translation>
    </message>
    <message>
        <source>cannot be put on: %1</source>
        <translation>ne peut être mis : %1</translation>
    </message>
    <message>
        <source>has no mesh that hangs on joints</source>
        <translation>n&apos;a pas de maillage tenu par des articulations</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Aucun fichier ou dossier de ce nom</translation>
    </message>
    <message>
        <source>is a folder, not a file</source>
        <translation>est un dossier, pas un fichier</translation>
    </message>
    <message>
        <source>is a pipe or a device, not a file</source>
        <translation>est un tube ou un périphérique, pas un fichier</translation>
    </message>
    <message>
        <source>cannot be read to its end</source>
        <translation>ne peut être lu jusqu&apos;au bout</translation>
    </message>
    <message>
        <source>is a pointer of Git LFS, not the file itself: &apos;git lfs pull&apos; fetches that</source>
        <translation>est un pointeur Git LFS, pas le fichier lui-même : « git lfs pull » va le chercher</translation>
    </message>
    <message>
        <source>is none of %1</source>
        <translation>n&apos;est aucun de %1</translation>
    </message>
    <message>
        <source>holds none of %1</source>
        <translation>ne contient aucun de %1</translation>
    </message>
    <message>
        <source>is a link that leads nowhere</source>
        <translation>est un lien qui ne mène nulle part</translation>
    </message>
    <message>
        <source>is a skeleton without motion: open one of its .amc files</source>
        <translation>est un squelette sans mouvement : ouvrez un de ses fichiers .amc</translation>
    </message>
    <message>
        <source>holds no animation, but may be put on a clip as its character</source>
        <translation>ne contient aucune animation, mais peut servir de personnage à un clip</translation>
    </message>
    <message>
        <source>has no take %1: there are %2</source>
        <translation>n&apos;a pas de prise %1 : il y a %2</translation>
    </message>
    <message>
        <source>has neither bones nor anything else that moves</source>
        <translation>n&apos;a ni os ni rien d&apos;autre qui bouge</translation>
    </message>
    <message>
        <source>no joint moves or is turned</source>
        <translation>aucune articulation ne bouge ni ne tourne</translation>
    </message>
    <message>
        <source>needs more than %1 frames</source>
        <translation>demande plus de %1 images</translation>
    </message>
    <message>
        <source>needs more than %1 samples</source>
        <translation>demande plus de %1 échantillons</translation>
    </message>
    <message>
        <source>joints are nested deeper than %1</source>
        <translation>des articulations sont imbriquées à plus de %1 niveaux</translation>
    </message>
    <message>
        <source>more than %1 joints</source>
        <translation>plus de %1 articulations</translation>
    </message>
    <message>
        <source>the name of a joint has more than %1 bytes</source>
        <translation>le nom d&apos;une articulation dépasse %1 octets</translation>
    </message>
    <message>
        <source>%1 has a transform that is not finite, or beyond 1e9</source>
        <translation>%1 a une transformation non finie, ou au-delà de 1e9</translation>
    </message>
    <message>
        <source>%1 is farther than 1e9 cm away</source>
        <translation>%1 est à plus de 1e9 cm</translation>
    </message>
    <message>
        <source>has a JSON value of another type than its place asks for</source>
        <translation>a une valeur JSON d&apos;un autre type que celui attendu à sa place</translation>
    </message>
    <message>
        <source>cannot be read: a library that reads its parts failed</source>
        <translation>ne peut être lu : une bibliothèque qui en lit des parties a échoué</translation>
    </message>
    <message>
        <source>expected one sample per second or more, found %1</source>
        <translation>attendu au moins un échantillon par seconde, trouvé %1</translation>
    </message>
    <message>
        <source>expected a new line after the %1 values of the frame that begins in line %2, found %3</source>
        <translation>attendu une nouvelle ligne après les %1 valeurs de l&apos;image qui commence à la ligne %2, trouvé %3</translation>
    </message>
    <message>
        <source>expected %1 values for %2, found %3</source>
        <translation>attendu %1 valeurs pour %2, trouvé %3</translation>
    </message>
    <message>
        <source>expected a bone of %1, found %2</source>
        <translation>attendu un os de %1, trouvé %2</translation>
    </message>
    <message>
        <source>expected a positive unit of length, found %1</source>
        <translation>attendu une unité de longueur positive, trouvé %1</translation>
    </message>
    <message>
        <source>expected a complete frame, found none</source>
        <translation>attendu une image complète, rien trouvé</translation>
    </message>
    <message>
        <source>expected a name after &apos;name&apos;</source>
        <translation>attendu un nom après « name »</translation>
    </message>
    <message>
        <source>expected %1, found %2</source>
        <translation>attendu : %1, trouvé : %2</translation>
    </message>
    <message>
        <source>%1 channels such as Xposition or Zrotation</source>
        <translation>%1 canaux comme Xposition ou Zrotation</translation>
    </message>
    <message>
        <source>a frame number</source>
        <translation>un numéro d&apos;image</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>samples per second</source>
        <translation>des échantillons par seconde</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>la fin du fichier</translation>
    </message>
    <message>
        <source>the number of frames</source>
        <translation>le nombre d&apos;images</translation>
    </message>
    <message>
        <source>the number of channels</source>
        <translation>le nombre de canaux</translation>
    </message>
    <message>
        <source>the time of a frame in seconds</source>
        <translation>la durée d&apos;une image en secondes</translation>
    </message>
    <message>
        <source>the name of the joint</source>
        <translation>le nom de l&apos;articulation</translation>
    </message>
    <message>
        <source>the name of a bone</source>
        <translation>le nom d&apos;un os</translation>
    </message>
    <message>
        <source>a coordinate of OFFSET</source>
        <translation>une coordonnée d&apos;OFFSET</translation>
    </message>
    <message>
        <source>a coordinate of direction</source>
        <translation>une coordonnée de direction</translation>
    </message>
    <message>
        <source>a coordinate of position</source>
        <translation>une coordonnée de position</translation>
    </message>
    <message>
        <source>an angle of axis</source>
        <translation>un angle de axis</translation>
    </message>
    <message>
        <source>an angle of orientation</source>
        <translation>un angle d&apos;orientation</translation>
    </message>
    <message>
        <source>an order of axes such as XYZ</source>
        <translation>un ordre d&apos;axes comme XYZ</translation>
    </message>
    <message>
        <source>the length of the bone</source>
        <translation>la longueur de l&apos;os</translation>
    </message>
    <message>
        <source>the unit of length</source>
        <translation>l&apos;unité de longueur</translation>
    </message>
    <message>
        <source>the end of the bone</source>
        <translation>la fin de l&apos;os</translation>
    </message>
    <message>
        <source>the end of the hierarchy</source>
        <translation>la fin de la hiérarchie</translation>
    </message>
    <message>
        <source>a section such as :units or :bonedata</source>
        <translation>une section comme :units ou :bonedata</translation>
    </message>
    <message>
        <source>OFFSET, CHANNELS, JOINT, End Site or }</source>
        <translation>OFFSET, CHANNELS, JOINT, End Site ou }</translation>
    </message>
    <message>
        <source>OFFSET or the } of the End Site</source>
        <translation>OFFSET ou le } du End Site</translation>
    </message>
    <message>
        <source>deg or rad</source>
        <translation>deg ou rad</translation>
    </message>
    <message>
        <source>tx, ty, tz, rx, ry, rz or l</source>
        <translation>tx, ty, tz, rx, ry, rz ou l</translation>
    </message>
    <message>
        <source>numbers have a decimal comma, such as %1: a decimal point is read</source>
        <translation>les nombres ont une virgule décimale, comme %1 : c&apos;est un point qui est lu</translation>
    </message>
    <message>
        <source>is UTF-16: save it as UTF-8 to have it read</source>
        <translation>est en UTF-16 : enregistrez-le en UTF-8 pour qu&apos;il soit lu</translation>
    </message>
    <message>
        <source>no joint has a channel: nothing moves</source>
        <translation>aucune articulation n&apos;a de canal : rien ne bouge</translation>
    </message>
    <message>
        <source>no complete frame follows</source>
        <translation>aucune image complète ne suit</translation>
    </message>
    <message>
        <source>a second CHANNELS line for one joint</source>
        <translation>une seconde ligne CHANNELS pour une articulation</translation>
    </message>
    <message>
        <source>channel %1 twice in one joint</source>
        <translation>canal %1 deux fois dans une articulation</translation>
    </message>
    <message>
        <source>more than %1 channels of scale that change</source>
        <translation>plus de %1 canaux d&apos;échelle qui changent</translation>
    </message>
    <message>
        <source>the file ends within its first frame</source>
        <translation>le fichier se termine au milieu de sa première image</translation>
    </message>
    <message>
        <source>no bone has a value: nothing moves</source>
        <translation>aucun os n&apos;a de valeur : rien ne bouge</translation>
    </message>
    <message>
        <source>frame %1 has only %2 bones</source>
        <translation>l&apos;image %1 n&apos;a que %2 os</translation>
    </message>
    <message>
        <source>%1 is not in the first frame</source>
        <translation>%1 n&apos;est pas dans la première image</translation>
    </message>
    <message>
        <source>%1 twice in one frame</source>
        <translation>%1 deux fois dans une image</translation>
    </message>
    <message>
        <source>%1 twice in one bone</source>
        <translation>%1 deux fois dans un os</translation>
    </message>
    <message>
        <source>more than %1 bones</source>
        <translation>plus de %1 os</translation>
    </message>
    <message>
        <source>this bone has no name</source>
        <translation>cet os n&apos;a pas de nom</translation>
    </message>
    <message>
        <source>bone %1 lacks its direction or length</source>
        <translation>il manque à l&apos;os %1 sa direction ou sa longueur</translation>
    </message>
    <message>
        <source>bone %1 is nested deeper than %2</source>
        <translation>l&apos;os %1 est imbriqué à plus de %2 niveaux</translation>
    </message>
    <message>
        <source>bone %1 does not hang from the root in :hierarchy</source>
        <translation>l&apos;os %1 ne tient pas à la racine dans :hierarchy</translation>
    </message>
    <message>
        <source>the name of a bone has more than %1 bytes</source>
        <translation>le nom d&apos;un os dépasse %1 octets</translation>
    </message>
    <message>
        <source>a second bone named %1</source>
        <translation>un second os nommé %1</translation>
    </message>
    <message>
        <source>a second parent for %1</source>
        <translation>un second parent pour %1</translation>
    </message>
    <message>
        <source>has no line of names</source>
        <translation>n&apos;a pas de ligne de noms</translation>
    </message>
    <message>
        <source>a column needs a name of 1 to 255 bytes</source>
        <translation>une colonne demande un nom de 1 à 255 octets</translation>
    </message>
    <message>
        <source>a name of a column has no quotes</source>
        <translation>un nom de colonne n&apos;a pas de guillemets</translation>
    </message>
    <message>
        <source>two columns are called %1</source>
        <translation>deux colonnes s&apos;appellent %1</translation>
    </message>
    <message>
        <source>is one more than the clip&apos;s %1</source>
        <translation>est une de plus que les %1 du clip</translation>
    </message>
    <message>
        <source>ends after values of %1, the clip has %2</source>
        <translation>se termine après les valeurs de %1, le clip en a %2</translation>
    </message>
    <message>
        <source>is compressed by EXT_meshopt_compression, which this program cannot read: it was built without libmeshoptimizer</source>
        <translation>est compressé par EXT_meshopt_compression, que ce programme ne peut lire : il a été compilé sans libmeshoptimizer</translation>
    </message>
    <message>
        <source>is compressed by KHR_draco_mesh_compression, which this program cannot read: it was built without libdraco</source>
        <translation>est compressé par KHR_draco_mesh_compression, que ce programme ne peut lire : il a été compilé sans libdraco</translation>
    </message>
    <message>
        <source>is not what %1 makes</source>
        <translation>n&apos;est pas ce que produit %1</translation>
    </message>
    <message>
        <source>is too large to read</source>
        <translation>est trop grand pour être lu</translation>
    </message>
    <message>
        <source>bufferView %1 %2</source>
        <translation>la bufferView %1 %2</translation>
    </message>
    <message>
        <source>has a mesh that %1</source>
        <translation>a un maillage qui %1</translation>
    </message>
    <message>
        <source>has an animation without keys</source>
        <translation>a une animation sans clés</translation>
    </message>
    <message>
        <source>has an animation with %1 key times, but %2 values</source>
        <translation>a une animation avec %1 temps de clé, mais %2 valeurs</translation>
    </message>
    <message>
        <source>has an animation whose key times go back</source>
        <translation>a une animation dont les temps de clé reculent</translation>
    </message>
    <message>
        <source>has an animation channel without a sampler</source>
        <translation>a un canal d&apos;animation sans échantillonneur</translation>
    </message>
    <message>
        <source>has an animation channel without a target</source>
        <translation>a un canal d&apos;animation sans cible</translation>
    </message>
    <message>
        <source>has an animation of node %1, which it has not</source>
        <translation>a une animation du nœud %1, qu&apos;il n&apos;a pas</translation>
    </message>
    <message>
        <source>has an animation that moves the morph weights of a node twice</source>
        <translation>a une animation qui déplace deux fois les poids de morphing d&apos;un nœud</translation>
    </message>
    <message>
        <source>has an unknown interpolation, %1</source>
        <translation>a une interpolation inconnue, %1</translation>
    </message>
    <message>
        <source>has a rotation of length 0</source>
        <translation>a une rotation de longueur 0</translation>
    </message>
    <message>
        <source>has a node that is below itself</source>
        <translation>a un nœud qui est sous lui-même</translation>
    </message>
    <message>
        <source>has node %1 below two nodes, or twice below one</source>
        <translation>a le nœud %1 sous deux nœuds, ou deux fois sous un</translation>
    </message>
    <message>
        <source>has more than %1 nodes</source>
        <translation>a plus de %1 nœuds</translation>
    </message>
    <message>
        <source>has a name of more than %1 bytes</source>
        <translation>a un nom de plus de %1 octets</translation>
    </message>
    <message>
        <source>has morph weights of a node without a mesh</source>
        <translation>a des poids de morphing d&apos;un nœud sans maillage</translation>
    </message>
    <message>
        <source>has too many morph targets</source>
        <translation>a trop de cibles de morphing</translation>
    </message>
    <message>
        <source>has too many morph weights</source>
        <translation>a trop de poids de morphing</translation>
    </message>
    <message>
        <source>moves neither nodes nor morph weights that can be read</source>
        <translation>ne déplace ni nœuds ni poids de morphing lisibles</translation>
    </message>
    <message>
        <source>asks for %1 frames of %2 nodes, too many for a file of so few bytes</source>
        <translation>demande %1 images de %2 nœuds, trop pour un fichier de si peu d&apos;octets</translation>
    </message>
    <message>
        <source>holds no keys</source>
        <translation>ne contient pas de clés</translation>
    </message>
    <message>
        <source>its take %1 moves no node</source>
        <translation>sa prise %1 ne déplace aucun nœud</translation>
    </message>
    <message>
        <source>its nodes hang in a circle</source>
        <translation>ses nœuds forment un cercle</translation>
    </message>
    <message>
        <source>its nodes hang deeper than %1</source>
        <translation>ses nœuds sont à plus de %1 niveaux</translation>
    </message>
    <message>
        <source>has keys at impossible times</source>
        <translation>a des clés à des temps impossibles</translation>
    </message>
    <message>
        <source>has too many nodes for so many frames</source>
        <translation>a trop de nœuds pour tant d&apos;images</translation>
    </message>
    <message>
        <source>the target of %1 is out of reach with this method: the nearest is %2</source>
        <translation>l&apos;objectif de %1 est hors de portée de cette méthode : le plus proche est %2</translation>
    </message>
    <message>
        <source>a promise beside the target is out of reach: %1</source>
        <translation>une promesse à côté de l&apos;objectif est hors de portée : %1</translation>
    </message>
    <message>
        <source>no joint is of any importance</source>
        <translation>aucune articulation n&apos;a d&apos;importance</translation>
    </message>
    <message>
        <source>the importance of a joint must be a number, 0 or more</source>
        <translation>l&apos;importance d&apos;une articulation doit être un nombre, 0 ou plus</translation>
    </message>
    <message>
        <source>the importance of every joint is needed, or of none</source>
        <translation>il faut l&apos;importance de toutes les articulations, ou d&apos;aucune</translation>
    </message>
    <message>
        <source>the skeleton has no joint named %1</source>
        <translation>le squelette n&apos;a pas d&apos;articulation nommée %1</translation>
    </message>
    <message>
        <source>%1 is turned (degrees, RMS) by %2, not %3</source>
        <translation>%1 est tournée (degrés, RMS) de %2 au lieu de %3</translation>
    </message>
    <message>
        <source>the weighting skin needs a clip with a mesh on its joints, or a character that is put on it</source>
        <translation>la pondération « peau » demande un clip avec un maillage sur ses articulations, ou un personnage mis dessus</translation>
    </message>
    <message>
        <source>cannot be written: its extension is none of .bvh, .fbx, .glb, .gltf, .amc, .csv</source>
        <translation>ne peut être écrit : son extension n&apos;est aucune de .bvh, .fbx, .glb, .gltf, .amc, .csv</translation>
    </message>
    <message>
        <source>is not written: the motion has values that are not finite</source>
        <translation>n&apos;est pas écrit : le mouvement a des valeurs non finies</translation>
    </message>
    <message>
        <source>only an .fbx can be written onto an .fbx, and a .glb or .gltf onto a glTF</source>
        <translation>seul un .fbx peut être écrit sur un .fbx, et un .glb ou .gltf sur un glTF</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>ne peut être écrit : %1</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>ne peut être lu : %1</translation>
    </message>
    <message>
        <source>cannot be looked at: %1</source>
        <translation>ne peut être examiné : %1</translation>
    </message>
    <message>
        <source>has %1 for %2</source>
        <translation>a %1 pour %2</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation>
            <numerusform>%n valeur</numerusform>
            <numerusform>%n valeurs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s)</source>
        <translation>
            <numerusform>%n articulation</numerusform>
            <numerusform>%n articulations</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n connection(s)</source>
        <translation>
            <numerusform>%n connexion</numerusform>
            <numerusform>%n connexions</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n node(s)</source>
        <translation>
            <numerusform>%n nœud</numerusform>
            <numerusform>%n nœuds</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n bone(s)</source>
        <translation>
            <numerusform>%n os</numerusform>
            <numerusform>%n os</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n channel(s)</source>
        <translation>
            <numerusform>%n canal</numerusform>
            <numerusform>%n canaux</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n curve(s)</source>
        <translation>
            <numerusform>%n courbe</numerusform>
            <numerusform>%n courbes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n key(s)</source>
        <translation>
            <numerusform>%n clé</numerusform>
            <numerusform>%n clés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s)</source>
        <translation>
            <numerusform>%n image</numerusform>
            <numerusform>%n images</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n column(s)</source>
        <translation>
            <numerusform>%n colonne</numerusform>
            <numerusform>%n colonnes</numerusform>
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
        <translation>a besoin de son squelette, mais ni %1.asf ni %2.asf n&apos;est à côté</translation>
    </message>
    <message>
        <source>needs its skeleton, but %1.asf is not beside it</source>
        <translation>a besoin de son squelette, mais %1.asf n&apos;est pas à côté</translation>
    </message>
    <message>
        <source>expected a number, found %1</source>
        <translation>attendu un nombre, trouvé %1</translation>
    </message>
    <message>
        <source>%1 with quaternions between keys, which are read as angles</source>
        <translation>%1 avec des quaternions entre les clés, lus comme des angles</translation>
    </message>
    <message>
        <source>the target of %1 is out of reach with this method: the nearest is %2, a smaller file</source>
        <translation>l&apos;objectif de %1 est hors de portée de cette méthode : le plus proche est %2, un fichier plus petit</translation>
    </message>
    <message>
        <source>the target of %1 is out of reach with this method: the nearest is %2, a larger file</source>
        <translation>l&apos;objectif de %1 est hors de portée de cette méthode : le plus proche est %2, un fichier plus gros</translation>
    </message>
    <message>
        <source>%1 (byte %2)</source>
        <translation>%1 (octet %2)</translation>
    </message>
    <message>
        <source>%1 (line %2)</source>
        <translation>%1 (ligne %2)</translation>
    </message>
    <message>
        <source>byte %1: %2</source>
        <translation>octet %1 : %2</translation>
    </message>
    <message>
        <source>not a Mocapress file</source>
        <translation>pas un fichier Mocapress</translation>
    </message>
    <message>
        <source>not a bank of clips</source>
        <translation>pas une banque de clips</translation>
    </message>
    <message>
        <source>a clip of a bank: the bank is what is opened</source>
        <translation>un clip d&apos;une banque : c&apos;est la banque qui s&apos;ouvre</translation>
    </message>
    <message>
        <source>the version is unknown: a newer Mocapress is needed</source>
        <translation>la version est inconnue : il faut un Mocapress plus récent</translation>
    </message>
    <message>
        <source>the file ends within its header</source>
        <translation>le fichier se termine dans son en-tête</translation>
    </message>
    <message>
        <source>the file ends within a section</source>
        <translation>le fichier se termine dans une section</translation>
    </message>
    <message>
        <source>a section is damaged: its checksum differs</source>
        <translation>une section est abîmée : sa somme de contrôle diffère</translation>
    </message>
    <message>
        <source>a section is missing</source>
        <translation>il manque une section</translation>
    </message>
    <message>
        <source>a section for the second time</source>
        <translation>une section pour la seconde fois</translation>
    </message>
    <message>
        <source>a section that is not expected here</source>
        <translation>une section inattendue à cet endroit</translation>
    </message>
    <message>
        <source>a second section loop</source>
        <translation>une seconde section loop</translation>
    </message>
    <message>
        <source>bytes after the last section</source>
        <translation>des octets après la dernière section</translation>
    </message>
    <message>
        <source>bytes after the coded motion</source>
        <translation>des octets après le mouvement codé</translation>
    </message>
    <message>
        <source>bytes after the last joint</source>
        <translation>des octets après la dernière articulation</translation>
    </message>
    <message>
        <source>bytes after the DEFLATE stream</source>
        <translation>des octets après le flux DEFLATE</translation>
    </message>
    <message>
        <source>bytes of curves where there are none</source>
        <translation>des octets de courbes là où il n&apos;y en a pas</translation>
    </message>
    <message>
        <source>%1 has the wrong size</source>
        <translation>%1 n&apos;a pas la bonne taille</translation>
    </message>
    <message>
        <source>%1 is too short</source>
        <translation>%1 est trop court</translation>
    </message>
    <message>
        <source>ENDS has an impossible reach</source>
        <translation>ENDS a une portée impossible</translation>
    </message>
    <message>
        <source>ENDS has impossible steps</source>
        <translation>ENDS a des pas impossibles</translation>
    </message>
    <message>
        <source>TIER has an impossible number of tiers</source>
        <translation>TIER a un nombre de niveaux impossible</translation>
    </message>
    <message>
        <source>TIER has tiers that do not follow each other</source>
        <translation>TIER a des niveaux qui ne se suivent pas</translation>
    </message>
    <message>
        <source>a tier is missing</source>
        <translation>il manque un niveau</translation>
    </message>
    <message>
        <source>tiers of another coding</source>
        <translation>des niveaux d&apos;un autre codage</translation>
    </message>
    <message>
        <source>the file has %1 tiers, not %2</source>
        <translation>le fichier a %1 niveaux au lieu de %2</translation>
    </message>
    <message>
        <source>a file with tiers takes no further section</source>
        <translation>un fichier à niveaux n&apos;admet plus de section</translation>
    </message>
    <message>
        <source>a number of the motion is out of bounds</source>
        <translation>un nombre du mouvement est hors limites</translation>
    </message>
    <message>
        <source>a number of the skeleton is not finite</source>
        <translation>un nombre du squelette n&apos;est pas fini</translation>
    </message>
    <message>
        <source>a step is larger than 2^64</source>
        <translation>un pas dépasse 2^64</translation>
    </message>
    <message>
        <source>a run of zeros passes the end of its channel</source>
        <translation>une suite de zéros dépasse la fin de son canal</translation>
    </message>
    <message>
        <source>a track has unknown flags</source>
        <translation>une piste a des indicateurs inconnus</translation>
    </message>
    <message>
        <source>a joint has unknown flags</source>
        <translation>une articulation a des indicateurs inconnus</translation>
    </message>
    <message>
        <source>a joint stands before its parent</source>
        <translation>une articulation précède son parent</translation>
    </message>
    <message>
        <source>a joint has more than 6 channels</source>
        <translation>une articulation a plus de 6 canaux</translation>
    </message>
    <message>
        <source>the axes are not a unit quaternion</source>
        <translation>les axes ne sont pas un quaternion unitaire</translation>
    </message>
    <message>
        <source>not as many channels as JNTS states</source>
        <translation>pas autant de canaux que JNTS l&apos;annonce</translation>
    </message>
    <message>
        <source>an effector is not a joint</source>
        <translation>un effecteur n&apos;est pas une articulation</translation>
    </message>
    <message>
        <source>a basis where there are no wavelets</source>
        <translation>une base là où il n&apos;y a pas d&apos;ondelettes</translation>
    </message>
    <message>
        <source>impossible orders of rotations</source>
        <translation>des ordres de rotation impossibles</translation>
    </message>
    <message>
        <source>an impossible unit of length</source>
        <translation>une unité de longueur impossible</translation>
    </message>
    <message>
        <source>more frames than the limits allow</source>
        <translation>plus d&apos;images que les limites ne le permettent</translation>
    </message>
    <message>
        <source>more joints or channels than the limits allow</source>
        <translation>plus d&apos;articulations ou de canaux que les limites ne le permettent</translation>
    </message>
    <message>
        <source>more values than the limits allow</source>
        <translation>plus de valeurs que les limites ne le permettent</translation>
    </message>
    <message>
        <source>more than 2^22 frames</source>
        <translation>plus de 2^22 images</translation>
    </message>
    <message>
        <source>more than 2^26 values</source>
        <translation>plus de 2^26 valeurs</translation>
    </message>
    <message>
        <source>reading takes more scratch memory than the limits allow</source>
        <translation>la lecture demande plus de mémoire de travail que les limites ne le permettent</translation>
    </message>
    <message>
        <source>the resident form takes more memory than the limits allow</source>
        <translation>la forme résidente demande plus de mémoire que les limites ne le permettent</translation>
    </message>
    <message>
        <source>the coding is not adaptive</source>
        <translation>le codage n&apos;est pas adaptatif</translation>
    </message>
    <message>
        <source>%1 ends early</source>
        <translation>%1 finit trop tôt</translation>
    </message>
    <message>
        <source>%1 end early</source>
        <translation>%1 finissent trop tôt</translation>
    </message>
    <message>
        <source>%1 is damaged</source>
        <translation>%1 est abîmé</translation>
    </message>
    <message>
        <source>%1 are damaged</source>
        <translation>%1 sont abîmés</translation>
    </message>
    <message>
        <source>the coded motion</source>
        <translation>le mouvement codé</translation>
    </message>
    <message>
        <source>the coded tracks</source>
        <translation>les pistes codées</translation>
    </message>
    <message>
        <source>the coded ends</source>
        <translation>les extrémités codées</translation>
    </message>
    <message>
        <source>the coded skeleton</source>
        <translation>le squelette codé</translation>
    </message>
    <message>
        <source>the DEFLATE stream</source>
        <translation>le flux DEFLATE</translation>
    </message>
    <message>
        <source>the skeleton</source>
        <translation>le squelette</translation>
    </message>
    <message>
        <source>the tracks</source>
        <translation>les pistes</translation>
    </message>
    <message>
        <source>more runs of tracks than was promised</source>
        <translation>plus de suites de pistes qu&apos;annoncé</translation>
    </message>
    <message>
        <source>other tracks than was promised</source>
        <translation>d&apos;autres pistes que celles annoncées</translation>
    </message>
    <message>
        <source>the number of segments does not fit the frames</source>
        <translation>le nombre de segments ne va pas avec les images</translation>
    </message>
    <message>
        <source>the sample rate is not a positive number</source>
        <translation>la cadence n&apos;est pas un nombre positif</translation>
    </message>
    <message>
        <source>the scale of steps is not a positive number</source>
        <translation>l&apos;échelle des pas n&apos;est pas un nombre positif</translation>
    </message>
    <message>
        <source>the segments have an impossible length</source>
        <translation>les segments ont une longueur impossible</translation>
    </message>
    <message>
        <source>the skeleton has an impossible size</source>
        <translation>le squelette a une taille impossible</translation>
    </message>
    <message>
        <source>the tracks have an impossible size</source>
        <translation>les pistes ont une taille impossible</translation>
    </message>
    <message>
        <source>too many samples for so few coded bytes</source>
        <translation>trop d&apos;échantillons pour si peu d&apos;octets codés</translation>
    </message>
    <message>
        <source>inflates to more bytes than allowed</source>
        <translation>se décompresse en plus d&apos;octets que permis</translation>
    </message>
    <message>
        <source>unknown basis of tracks</source>
        <translation>base de pistes inconnue</translation>
    </message>
    <message>
        <source>unknown basis</source>
        <translation>base inconnue</translation>
    </message>
    <message>
        <source>unknown coding</source>
        <translation>codage inconnu</translation>
    </message>
    <message>
        <source>unknown kind of loop</source>
        <translation>sorte de boucle inconnue</translation>
    </message>
    <message>
        <source>unknown kind of track</source>
        <translation>sorte de piste inconnue</translation>
    </message>
    <message>
        <source>unknown kind of channel</source>
        <translation>sorte de canal inconnue</translation>
    </message>
    <message>
        <source>unknown kind of source</source>
        <translation>sorte de source inconnue</translation>
    </message>
    <message>
        <source>unknown method</source>
        <translation>méthode inconnue</translation>
    </message>
    <message>
        <source>unknown solver</source>
        <translation>solveur inconnu</translation>
    </message>
    <message>
        <source>unknown weighting</source>
        <translation>pondération inconnue</translation>
    </message>
    <message>
        <source>unknown axis</source>
        <translation>axe inconnu</translation>
    </message>
    <message>
        <source>unknown convention</source>
        <translation>convention inconnue</translation>
    </message>
    <message>
        <source>unknown order of rotations</source>
        <translation>ordre de rotations inconnu</translation>
    </message>
    <message>
        <source>unknown method of compression: %1</source>
        <translation>méthode de compression inconnue : %1</translation>
    </message>
    <message>
        <source>not a wavelet clip: it was made by a comparison method (section COMP)</source>
        <translation>pas un clip d&apos;ondelettes : il vient d&apos;une méthode de comparaison (section COMP)</translation>
    </message>
    <message>
        <source>the motion has values that are not finite</source>
        <translation>le mouvement a des valeurs non finies</translation>
    </message>
    <message>
        <source>ends here: %1 bytes wanted, %2 left</source>
        <translation>finit ici : %1 octets voulus, il en reste %2</translation>
    </message>
    <message>
        <source>%1 bytes too many</source>
        <translation>%1 octets de trop</translation>
    </message>
    <message>
        <source>the clips of the bank are damaged: their checksum differs</source>
        <translation>les clips de la banque sont abîmés : leur somme de contrôle diffère</translation>
    </message>
    <message>
        <source>clips of the bank are damaged: their checksum differs</source>
        <translation>des clips de la banque sont abîmés : leur somme de contrôle diffère</translation>
    </message>
    <message>
        <source>the head of the bank is damaged: its checksum differs</source>
        <translation>l&apos;en-tête de la banque est abîmé : sa somme de contrôle diffère</translation>
    </message>
    <message>
        <source>the index of the bank is damaged: its checksum differs</source>
        <translation>l&apos;index de la banque est abîmé : sa somme de contrôle diffère</translation>
    </message>
    <message>
        <source>the index of the bank makes no sense</source>
        <translation>l&apos;index de la banque n&apos;a pas de sens</translation>
    </message>
    <message>
        <source>the tiers of the bank make no sense</source>
        <translation>les niveaux de la banque n&apos;ont pas de sens</translation>
    </message>
    <message>
        <source>a tier of the bank is damaged: its checksum differs</source>
        <translation>un niveau de la banque est abîmé : sa somme de contrôle diffère</translation>
    </message>
    <message>
        <source>the bank is cut short</source>
        <translation>la banque est tronquée</translation>
    </message>
    <message>
        <source>the bank has an impossible head</source>
        <translation>la banque a un en-tête impossible</translation>
    </message>
    <message>
        <source>an unknown form of bank</source>
        <translation>une forme de banque inconnue</translation>
    </message>
    <message>
        <source>an impossible item of the bank</source>
        <translation>un élément impossible de la banque</translation>
    </message>
    <message>
        <source>the parts of the bank are out of order</source>
        <translation>les parties de la banque sont en désordre</translation>
    </message>
    <message>
        <source>a clip of the bank has another size than it says</source>
        <translation>un clip de la banque n&apos;a pas la taille qu&apos;il annonce</translation>
    </message>
    <message>
        <source>a clip of the bank has another skeleton than it says</source>
        <translation>un clip de la banque n&apos;a pas le squelette qu&apos;il annonce</translation>
    </message>
    <message>
        <source>a clip of the bank</source>
        <translation>un clip de la banque</translation>
    </message>
    <message>
        <source>what the bank&apos;s clips taught makes no sense</source>
        <translation>ce que les clips de la banque ont appris n&apos;a pas de sens</translation>
    </message>
    <message>
        <source>a number that is not finite</source>
        <translation>un nombre qui n&apos;est pas fini</translation>
    </message>
    <message>
        <source>a value that is not finite</source>
        <translation>une valeur qui n&apos;est pas finie</translation>
    </message>
    <message>
        <source>a range that is not finite</source>
        <translation>une plage qui n&apos;est pas finie</translation>
    </message>
    <message>
        <source>a step that is not finite</source>
        <translation>un pas qui n&apos;est pas fini</translation>
    </message>
    <message>
        <source>segments that are too short</source>
        <translation>des segments trop courts</translation>
    </message>
    <message>
        <source>more components than possible</source>
        <translation>plus de composantes que possible</translation>
    </message>
    <message>
        <source>fewer components than stated</source>
        <translation>moins de composantes qu&apos;annoncé</translation>
    </message>
    <message>
        <source>a component whose reach is not above 0</source>
        <translation>une composante dont la portée ne dépasse pas 0</translation>
    </message>
    <message>
        <source>an unknown cluster</source>
        <translation>un groupe inconnu</translation>
    </message>
    <message>
        <source>a segment of an unknown kind</source>
        <translation>un segment d&apos;une sorte inconnue</translation>
    </message>
    <message>
        <source>two keys at one frame</source>
        <translation>deux clés à une image</translation>
    </message>
    <message>
        <source>a key after the clip&apos;s end</source>
        <translation>une clé après la fin du clip</translation>
    </message>
    <message>
        <source>a key after the segment&apos;s end</source>
        <translation>une clé après la fin du segment</translation>
    </message>
    <message>
        <source>no key at the clip&apos;s end</source>
        <translation>pas de clé à la fin du clip</translation>
    </message>
    <message>
        <source>no key at the segment&apos;s end</source>
        <translation>pas de clé à la fin du segment</translation>
    </message>
    <message>
        <source>a stride longer than the clip</source>
        <translation>un pas plus long que le clip</translation>
    </message>
    <message>
        <source>a curve has %1 key times, but %2 values</source>
        <translation>une courbe a %1 temps de clé, mais %2 valeurs</translation>
    </message>
    <message>
        <source>a curve ends within a key</source>
        <translation>une courbe finit au milieu d&apos;une clé</translation>
    </message>
    <message>
        <source>has a key with unknown tangents</source>
        <translation>a une clé aux tangentes inconnues</translation>
    </message>
    <message>
        <source>has a key of an unknown kind</source>
        <translation>a une clé d&apos;une sorte inconnue</translation>
    </message>
    <message>
        <source>has meshes of more than %1 corners</source>
        <translation>a des maillages de plus de %1 coins</translation>
    </message>
    <message>
        <source>has a polygon with a point that its mesh has not</source>
        <translation>a un polygone avec un point que son maillage n&apos;a pas</translation>
    </message>
    <message>
        <source>has a bone with more or fewer weights than points</source>
        <translation>a un os avec plus ou moins de poids que de points</translation>
    </message>
    <message>
        <source>has a bone with a weight of a point that its mesh has not</source>
        <translation>a un os avec le poids d&apos;un point que son maillage n&apos;a pas</translation>
    </message>
    <message>
        <source>has more than %1 weights</source>
        <translation>a plus de %1 poids</translation>
    </message>
    <message>
        <source>has more than %1 records</source>
        <translation>a plus de %1 enregistrements</translation>
    </message>
    <message>
        <source>nests records deeper than %1</source>
        <translation>imbrique des enregistrements à plus de %1 niveaux</translation>
    </message>
    <message>
        <source>is FBX %1: versions from 6.0 on are read</source>
        <translation>est du FBX %1 : les versions sont lues à partir de 6.0</translation>
    </message>
    <message>
        <source>ends within its head</source>
        <translation>se termine dans son en-tête</translation>
    </message>
    <message>
        <source>cannot be read as FBX: it begins neither like a binary file nor like an ASCII one</source>
        <translation>ne peut être lu comme FBX : il ne commence ni comme un fichier binaire ni comme un fichier ASCII</translation>
    </message>
    <message>
        <source>cannot be read as FBX: it states no version</source>
        <translation>ne peut être lu comme FBX : il n&apos;annonce pas de version</translation>
    </message>
    <message>
        <source>has an array of an unknown encoding</source>
        <translation>a un tableau d&apos;un encodage inconnu</translation>
    </message>
    <message>
        <source>an array has fewer values than it states</source>
        <translation>un tableau a moins de valeurs qu&apos;il n&apos;annonce</translation>
    </message>
    <message>
        <source>an array states more values than its bytes can hold</source>
        <translation>un tableau annonce plus de valeurs que ses octets n&apos;en contiennent</translation>
    </message>
    <message>
        <source>has an array that cannot be unpacked</source>
        <translation>a un tableau qui ne peut être décompressé</translation>
    </message>
    <message>
        <source>its take %1 has no first layer that is heard: a motion cannot be written there</source>
        <translation>sa prise %1 n&apos;a pas de première couche active : un mouvement ne peut y être écrit</translation>
    </message>
    <message>
        <source>numbers its objects too high to add any</source>
        <translation>numérote ses objets trop haut pour en ajouter</translation>
    </message>
    <message>
        <source>has curves that several takes share: a motion cannot be written onto one</source>
        <translation>a des courbes que plusieurs prises partagent : un mouvement ne peut être écrit sur une seule</translation>
    </message>
    <message>
        <source>is ASCII, big-endian or older than 7.0: a motion is put only onto other binary FBX files</source>
        <translation>est en ASCII, gros-boutiste ou antérieur à 7.0 : un mouvement n&apos;est mis que sur d&apos;autres fichiers FBX binaires</translation>
    </message>
    <message>
        <source>a text is too long for an FBX</source>
        <translation>un texte est trop long pour un FBX</translation>
    </message>
    <message>
        <source>a curve is too long for an FBX</source>
        <translation>une courbe est trop longue pour un FBX</translation>
    </message>
    <message>
        <source>an FBX of a version before 7.5 has at most 4 GiB</source>
        <translation>un FBX d&apos;une version antérieure à 7.5 fait au plus 4 Gio</translation>
    </message>
    <message>
        <source>a record states no end: nothing is written onto it</source>
        <translation>un enregistrement n&apos;annonce pas de fin : rien n&apos;est écrit dessus</translation>
    </message>
    <message>
        <source>has no %1</source>
        <translation>n&apos;a pas de %1</translation>
    </message>
    <message>
        <source>is no glTF: its JSON is not an object</source>
        <translation>n&apos;est pas un glTF : son JSON n&apos;est pas un objet</translation>
    </message>
    <message>
        <source>is no glTF 2.0: %1</source>
        <translation>n&apos;est pas un glTF 2.0 : %1</translation>
    </message>
    <message>
        <source>it states no version</source>
        <translation>il n&apos;annonce pas de version</translation>
    </message>
    <message>
        <source>its version is %1</source>
        <translation>sa version est %1</translation>
    </message>
    <message>
        <source>ends before the length it states</source>
        <translation>se termine avant la longueur qu&apos;il annonce</translation>
    </message>
    <message>
        <source>is version %1 of .glb, not 2</source>
        <translation>est de la version %1 de .glb, et non 2</translation>
    </message>
    <message>
        <source>has a chunk that reaches beyond its end</source>
        <translation>a un bloc qui dépasse sa fin</translation>
    </message>
    <message>
        <source>does not begin with JSON</source>
        <translation>ne commence pas par du JSON</translation>
    </message>
    <message>
        <source>holds no JSON</source>
        <translation>ne contient pas de JSON</translation>
    </message>
    <message>
        <source>%1 is not a list of objects</source>
        <translation>%1 n&apos;est pas une liste d&apos;objets</translation>
    </message>
    <message>
        <source>%1 is not a whole number from 0</source>
        <translation>%1 n&apos;est pas un entier à partir de 0</translation>
    </message>
    <message>
        <source>%1 names number %2 of only %3</source>
        <translation>%1 désigne le numéro %2, mais il n&apos;y a que %3</translation>
    </message>
    <message>
        <source>lacks a %1 that should name one of its %2</source>
        <translation>n&apos;a pas de %1 qui désigne un de ses %2</translation>
    </message>
    <message>
        <source>%1 names what is none of its %2</source>
        <translation>%1 désigne ce qui n&apos;est aucun de ses %2</translation>
    </message>
    <message>
        <source>%1 is not %2 numbers up to 1e9</source>
        <translation>%1 n&apos;est pas %2 nombres d&apos;au plus 1e9</translation>
    </message>
    <message>
        <source>%1 is not a list</source>
        <translation>%1 n&apos;est pas une liste</translation>
    </message>
    <message>
        <source>%1 is not a text</source>
        <translation>%1 n&apos;est pas un texte</translation>
    </message>
    <message>
        <source>has a data URI without base64</source>
        <translation>a une URI de données sans base64</translation>
    </message>
    <message>
        <source>has a data URI that is not base64</source>
        <translation>a une URI de données qui n&apos;est pas en base64</translation>
    </message>
    <message>
        <source>refers to %1, but only files in its own folder are read</source>
        <translation>renvoie à %1, mais seuls les fichiers de son dossier sont lus</translation>
    </message>
    <message>
        <source>refers to %1, which is not there</source>
        <translation>renvoie à %1, qui n&apos;est pas là</translation>
    </message>
    <message>
        <source>%1 has neither a uri nor a chunk of a .glb</source>
        <translation>%1 n&apos;a ni uri ni bloc d&apos;un .glb</translation>
    </message>
    <message>
        <source>%1 has %2 of the %3 bytes it states</source>
        <translation>%1 a %2 des %3 octets qu&apos;il annonce</translation>
    </message>
    <message>
        <source>%1 reaches beyond its buffer</source>
        <translation>%1 dépasse son buffer</translation>
    </message>
    <message>
        <source>has an accessor of an unknown componentType</source>
        <translation>a un accessor d&apos;un componentType inconnu</translation>
    </message>
    <message>
        <source>%1 has a byteStride that is too small</source>
        <translation>%1 a un byteStride trop petit</translation>
    </message>
    <message>
        <source>has an accessor that reaches beyond %1</source>
        <translation>a un accessor qui dépasse %1</translation>
    </message>
    <message>
        <source>%1 holds a number that is not finite or beyond 1e9</source>
        <translation>%1 contient un nombre non fini ou au-delà de 1e9</translation>
    </message>
    <message>
        <source>accessor %1 is not %2</source>
        <translation>l&apos;accessor %1 n&apos;est pas %2</translation>
    </message>
    <message>
        <source>states more zeros that have no bytes than are read</source>
        <translation>annonce plus de zéros sans octets qu&apos;il n&apos;en est lu</translation>
    </message>
    <message>
        <source>%1 has sparse values without sense</source>
        <translation>%1 a des valeurs éparses dénuées de sens</translation>
    </message>
    <message>
        <source>%1 has a sparse value for an element that it has not</source>
        <translation>%1 a une valeur éparse pour un élément qu&apos;il n&apos;a pas</translation>
    </message>
    <message>
        <source>has a skin with %1 joints, but only %2 bind matrices</source>
        <translation>a une peau de %1 articulations, mais seulement %2 matrices de liaison</translation>
    </message>
    <message>
        <source>has a mesh packed without attributes</source>
        <translation>a un maillage compacté sans attributs</translation>
    </message>
    <message>
        <source>has a packed mesh without the attributes it states</source>
        <translation>a un maillage compacté sans les attributs qu&apos;il annonce</translation>
    </message>
    <message>
        <source>has a mesh with more or fewer normals than positions</source>
        <translation>a un maillage avec plus ou moins de normales que de positions</translation>
    </message>
    <message>
        <source>has a triangle with a vertex that its mesh has not</source>
        <translation>a un triangle avec un sommet que son maillage n&apos;a pas</translation>
    </message>
    <message>
        <source>has a mesh with more or fewer weights than positions</source>
        <translation>a un maillage avec plus ou moins de poids que de positions</translation>
    </message>
    <message>
        <source>has a vertex on a joint that its skin has not</source>
        <translation>a un sommet sur une articulation que sa peau n&apos;a pas</translation>
    </message>
    <message>
        <source>has a mesh with more or fewer places in its picture than positions</source>
        <translation>a un maillage avec plus ou moins de places dans son image que de positions</translation>
    </message>
    <message>
        <source>the motion is too large for a .glb: 4 GB are the most</source>
        <translation>le mouvement est trop grand pour un .glb : 4 Go au plus</translation>
    </message>
    <message>
        <source>verification: %1</source>
        <translation>vérification : %1</translation>
    </message>
    <message>
        <source>no project: %1</source>
        <translation>pas un projet : %1</translation>
    </message>
    <message>
        <source>the preset &quot;%1&quot; %2</source>
        <translation>le préréglage « %1 » %2</translation>
    </message>
    <message>
        <source>the compression %1</source>
        <translation>la compression %1</translation>
    </message>
    <message>
        <source>this clip cannot be written as .mcpr: %1</source>
        <translation>ce clip ne peut être écrit en .mcpr : %1</translation>
    </message>
    <message>
        <source>its tracks cannot be kept: %1</source>
        <translation>ses pistes ne peuvent être gardées : %1</translation>
    </message>
    <message>
        <source>the name of joint %1... has %2 bytes, at most %3 are possible</source>
        <translation>le nom de l&apos;articulation %1... a %2 octets, %3 au plus sont possibles</translation>
    </message>
    <message>
        <source>joint %1 has %2 channels, at most %3 are possible</source>
        <translation>l&apos;articulation %1 a %2 canaux, %3 au plus sont possibles</translation>
    </message>
    <message>
        <source>joint %1 is too far away for 32-bit floats</source>
        <translation>l&apos;articulation %1 est trop loin pour des flottants de 32 bits</translation>
    </message>
    <message>
        <source>it has no joints</source>
        <translation>il n&apos;a pas d&apos;articulations</translation>
    </message>
    <message>
        <source>its sample rate is not a positive number</source>
        <translation>sa cadence n&apos;est pas un nombre positif</translation>
    </message>
    <message>
        <source>there are %1, at most %2 are possible</source>
        <translation>il y en a %1, %2 au plus sont possibles</translation>
    </message>
    <message>
        <source>motion and tracks have %1 values, at most %2 are possible</source>
        <translation>le mouvement et les pistes ont %1 valeurs, %2 au plus sont possibles</translation>
    </message>
    <message>
        <source>an .asf of this skeleton would have %1 bones, at most %2 are possible</source>
        <translation>un .asf de ce squelette aurait %1 os, %2 au plus sont possibles</translation>
    </message>
    <message>
        <source>%1, at most %2 are possible</source>
        <translation>%1, %2 au plus sont possibles</translation>
    </message>
    <message>
        <source>%1 values (frames times channels)</source>
        <translation>%1 valeurs (images fois canaux)</translation>
    </message>
    <message>
        <source>%1 values are too many for a motion of so few bytes</source>
        <translation>%1 valeurs sont trop pour un mouvement de si peu d&apos;octets</translation>
    </message>
    <message>
        <source>the name of one has more than %1 bytes</source>
        <translation>le nom de l&apos;une dépasse %1 octets</translation>
    </message>
    <message>
        <source>%1 has another number of frames than the clip</source>
        <translation>%1 n&apos;a pas le même nombre d&apos;images que le clip</translation>
    </message>
    <message>
        <source>%1 has a value that is not finite</source>
        <translation>%1 a une valeur qui n&apos;est pas finie</translation>
    </message>
    <message>
        <source>the motion to be written is not coded yet</source>
        <translation>le mouvement à écrire n&apos;est pas encore codé</translation>
    </message>
    <message>
        <source>the motion to be written lacks its finest bands</source>
        <translation>il manque au mouvement à écrire ses bandes les plus fines</translation>
    </message>
    <message>
        <source>an .amc holds one figure with one root, but this clip has %1 roots: .bvh and .glb can hold it</source>
        <translation>un .amc contient une figure à une racine, mais ce clip a %1 racines : .bvh et .glb peuvent le contenir</translation>
    </message>
    <message>
        <source>a bone&apos;s name would be too long for an .asf: %1</source>
        <translation>un nom d&apos;os serait trop long pour un .asf : %1</translation>
    </message>
    <message>
        <source>in an .asf bones of this skeleton would be nested deeper than %1</source>
        <translation>dans un .asf, des os de ce squelette seraient imbriqués à plus de %1 niveaux</translation>
    </message>
    <message>
        <source>a joint is scaled to nothing: what hangs from it has no place</source>
        <translation>une articulation est réduite à rien : ce qui y tient n&apos;a pas de place</translation>
    </message>
    <message>
        <source>has no joint %1, which the motion has</source>
        <translation>n&apos;a pas l&apos;articulation %1, que le mouvement a</translation>
    </message>
    <message>
        <source>scales %1 to nothing: it cannot follow a motion</source>
        <translation>réduit %1 à rien : elle ne peut suivre un mouvement</translation>
    </message>
    <message>
        <source>no feet were found on this skeleton: name the joints to be corrected</source>
        <translation>aucun pied n&apos;a été trouvé sur ce squelette : nommez les articulations à corriger</translation>
    </message>
    <message>
        <source>no joint above %1 can turn to move it</source>
        <translation>aucune articulation au-dessus de %1 ne peut tourner pour la déplacer</translation>
    </message>
    <message>
        <source>a chain of joints that ends at %1 does not begin at a joint above it that can turn</source>
        <translation>une chaîne qui finit à %1 ne commence pas à une articulation au-dessus qui peut tourner</translation>
    </message>
    <message>
        <source>more than %1 effectors</source>
        <translation>plus de %1 effecteurs</translation>
    </message>
    <message>
        <source>these effectors are not one limb</source>
        <translation>ces effecteurs ne forment pas un membre</translation>
    </message>
    <message>
        <source>the importance of frames %1 to %2 is not a number from 1 to %3</source>
        <translation>l&apos;importance des images %1 à %2 n&apos;est pas un nombre de 1 à %3</translation>
    </message>
    <message>
        <source>frames %1 to %2 are not a range of the clip, which has %3 frames</source>
        <translation>les images %1 à %2 ne sont pas une plage du clip, qui a %3 images</translation>
    </message>
    <message>
        <source>inverse kinematics can correct wavelet methods only</source>
        <translation>la cinématique inverse ne corrige que les méthodes à ondelettes</translation>
    </message>
    <message>
        <source>the coefficient ratio is a target of wavelet methods only</source>
        <translation>le taux de coefficients n&apos;est une cible que des méthodes à ondelettes</translation>
    </message>
    <message>
        <source>is not a compressed form of the original: it has %1, the original %2</source>
        <translation>n&apos;est pas une forme compressée de l&apos;original : il a %1, l&apos;original %2</translation>
    </message>
    <message>
        <source>the clip has no frames</source>
        <translation>le clip n&apos;a pas d&apos;images</translation>
    </message>
    <message>
        <source>the clip is not a loop</source>
        <translation>le clip n&apos;est pas une boucle</translation>
    </message>
    <message>
        <source>the tracks are not those of the original</source>
        <translation>les pistes ne sont pas celles de l&apos;original</translation>
    </message>
    <message>
        <source>the tracks have not as many frames as those of the original</source>
        <translation>les pistes n&apos;ont pas autant d&apos;images que celles de l&apos;original</translation>
    </message>
    <message>
        <source>has an unknown method: %1</source>
        <translation>a une méthode inconnue : %1</translation>
    </message>
    <message>
        <source>unknown method: %1</source>
        <translation>méthode inconnue : %1</translation>
    </message>
    <message>
        <source>has a coding other than adaptive, the only one of the closed loop</source>
        <translation>a un autre codage que l&apos;adaptatif, le seul de la boucle fermée</translation>
    </message>
    <message>
        <source>has a target that is not above 0</source>
        <translation>a une cible qui ne dépasse pas 0</translation>
    </message>
    <message>
        <source>has a coefficient ratio, a target of wavelet methods only</source>
        <translation>a un taux de coefficients, cible des seules méthodes à ondelettes</translation>
    </message>
    <message>
        <source>has a track error that is not above 0</source>
        <translation>a une erreur de pistes qui ne dépasse pas 0</translation>
    </message>
    <message>
        <source>has a promise that is not above 0: %1</source>
        <translation>a une promesse qui ne dépasse pas 0 : %1</translation>
    </message>
    <message>
        <source>has the effort draft, which does not promise its target</source>
        <translation>a l&apos;effort « ébauche », qui ne promet pas sa cible</translation>
    </message>
    <message>
        <source>has an importance of frames that is not a number from 1 to %1</source>
        <translation>a une importance d&apos;images qui n&apos;est pas un nombre de 1 à %1</translation>
    </message>
    <message>
        <source>has an importance of %1 that is not a number of 0 or more</source>
        <translation>a une importance de %1 qui n&apos;est pas un nombre de 0 ou plus</translation>
    </message>
    <message>
        <source>has an IK correction, which can correct wavelet methods only</source>
        <translation>a une correction IK, qui ne corrige que les méthodes à ondelettes</translation>
    </message>
    <message>
        <source>has an IK ratio that is not above 0</source>
        <translation>a un taux IK qui ne dépasse pas 0</translation>
    </message>
    <message>
        <source>%1 is not a JSON object</source>
        <translation>%1 n&apos;est pas un objet JSON</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 n&apos;est pas un nombre</translation>
    </message>
    <message>
        <source>%1 is not a whole number</source>
        <translation>%1 n&apos;est pas un entier</translation>
    </message>
    <message>
        <source>%1 is not a frame</source>
        <translation>%1 n&apos;est pas une image</translation>
    </message>
    <message>
        <source>%1 is not above 0</source>
        <translation>%1 ne dépasse pas 0</translation>
    </message>
    <message>
        <source>%1 is below 0</source>
        <translation>%1 est inférieur à 0</translation>
    </message>
    <message>
        <source>%1 is neither a number nor &quot;auto&quot;</source>
        <translation>%1 n&apos;est ni un nombre ni « auto »</translation>
    </message>
    <message>
        <source>%1 is not a list of names</source>
        <translation>%1 n&apos;est pas une liste de noms</translation>
    </message>
    <message>
        <source>%1 is not a list of contacts</source>
        <translation>%1 n&apos;est pas une liste de contacts</translation>
    </message>
    <message>
        <source>%1 is not a list of joints with a first and a last frame</source>
        <translation>%1 n&apos;est pas une liste d&apos;articulations avec une première et une dernière image</translation>
    </message>
    <message>
        <source>%1 is not a list of ranges with a first and a last frame</source>
        <translation>%1 n&apos;est pas une liste de plages avec une première et une dernière image</translation>
    </message>
    <message>
        <source>%1 is not a list of ranges</source>
        <translation>%1 n&apos;est pas une liste de plages</translation>
    </message>
    <message>
        <source>%1 of %2 is not a number</source>
        <translation>%1 de %2 n&apos;est pas un nombre</translation>
    </message>
    <message>
        <source>%1 is &quot;%2&quot;, not one of %3</source>
        <translation>%1 est « %2 », aucun de %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is unknown</source>
        <translation>« %1 » est inconnu</translation>
    </message>
    <message>
        <source>&quot;distance_m&quot; is not from %1 to %2</source>
        <translation>« distance_m » n&apos;est pas de %1 à %2</translation>
    </message>
    <message>
        <source>what should be limits is not a JSON object</source>
        <translation>ce qui devrait être des limites n&apos;est pas un objet JSON</translation>
    </message>
    <message>
        <source>a preset has no &quot;name&quot;</source>
        <translation>un préréglage n&apos;a pas de « name »</translation>
    </message>
    <message>
        <source>holds no preset</source>
        <translation>ne contient pas de préréglage</translation>
    </message>
    <message>
        <source>is not JSON from here on</source>
        <translation>n&apos;est plus du JSON à partir d&apos;ici</translation>
    </message>
    <message>
        <source>holds a number that is too large</source>
        <translation>contient un nombre trop grand</translation>
    </message>
    <message>
        <source>nests its JSON more than %1 deep</source>
        <translation>imbrique son JSON à plus de %1 niveaux</translation>
    </message>
    <message>
        <source>holds too many JSON values</source>
        <translation>contient trop de valeurs JSON</translation>
    </message>
    <message>
        <source>has a clip without a path</source>
        <translation>a un clip sans chemin</translation>
    </message>
    <message>
        <source>is not a project: %1</source>
        <translation>n&apos;est pas un projet : %1</translation>
    </message>
    <message>
        <source>is not a project</source>
        <translation>n&apos;est pas un projet</translation>
    </message>
    <message>
        <source>was saved by a newer version of Mocapress</source>
        <translation>a été enregistré par une version plus récente de Mocapress</translation>
    </message>
    <message>
        <source>was written by a newer version of Mocapress</source>
        <translation>a été écrit par une version plus récente de Mocapress</translation>
    </message>
    <message>
        <source>is no file of notes</source>
        <translation>n&apos;est pas un fichier de notes</translation>
    </message>
    <message>
        <source>has notes of another form: %1</source>
        <translation>a des notes d&apos;une autre forme : %1</translation>
    </message>
    <message>
        <source>holds the notes of a clip in another format</source>
        <translation>contient les notes d&apos;un clip d&apos;un autre format</translation>
    </message>
    <message>
        <source>the link is refused, for it names no clip by an absolute path on this computer: %1</source>
        <translation>le lien est refusé, car il ne nomme aucun clip par un chemin absolu sur cet ordinateur : %1</translation>
    </message>
    <message>
        <source>is not a list of blind tests</source>
        <translation>n&apos;est pas une liste de tests à l&apos;aveugle</translation>
    </message>
    <message>
        <source>a blind test has an unknown cue: %1</source>
        <translation>un test à l&apos;aveugle a un indice inconnu : %1</translation>
    </message>
    <message>
        <source>a blind test has a level that is not above 0</source>
        <translation>un test à l&apos;aveugle a un niveau qui ne dépasse pas 0</translation>
    </message>
    <message>
        <source>a blind test lacks a value, or has one of another type</source>
        <translation>il manque une valeur à un test à l&apos;aveugle, ou il en a une d&apos;un autre type</translation>
    </message>
    <message>
        <source>{%1} means nothing in a name: there are {folder}, {stem}, {type}, {preset} and {method}</source>
        <translation>{%1} ne veut rien dire dans un nom : il y a {folder}, {stem}, {type}, {preset} et {method}</translation>
    </message>
    <message>
        <source>the name pattern has a { without its }: %1</source>
        <translation>le modèle de noms a une { sans sa } : %1</translation>
    </message>
    <message>
        <source>is not a file name below the batch&apos;s folder: %1</source>
        <translation>n&apos;est pas un nom de fichier sous le dossier du lot : %1</translation>
    </message>
    <message>
        <source>a bank is made of .mcpr files, which are not among the formats</source>
        <translation>une banque est faite de fichiers .mcpr, qui ne sont pas parmi les formats</translation>
    </message>
    <message>
        <source>only a packed bank is coded by what its clips teach</source>
        <translation>seule une banque compacte est codée par ce que ses clips apprennent</translation>
    </message>
    <message>
        <source>%1 exists: not overwritten</source>
        <translation>%1 existe : non remplacé</translation>
    </message>
    <message>
        <source>%1 exists and is not this batch&apos;s: not overwritten</source>
        <translation>%1 existe et n&apos;est pas de ce lot : non remplacé</translation>
    </message>
    <message>
        <source>%1 is a file that clips of this batch are made from</source>
        <translation>%1 est un fichier dont viennent des clips de ce lot</translation>
    </message>
    <message>
        <source>is one of the inputs: not overwritten</source>
        <translation>est une des entrées : non remplacé</translation>
    </message>
    <message>
        <source>reads back with another number of frames</source>
        <translation>se relit avec un autre nombre d&apos;images</translation>
    </message>
    <message>
        <source>reads back without %1</source>
        <translation>se relit sans %1</translation>
    </message>
    <message>
        <source>reads back %1 cm off at %2</source>
        <translation>se relit avec %1 cm d&apos;écart à %2</translation>
    </message>
    <message>
        <source>the preset has a contact up to frame %1, but the clip ends before</source>
        <translation>le préréglage a un contact jusqu&apos;à l&apos;image %1, mais le clip finit avant</translation>
    </message>
    <message>
        <source>%1 was asked for, but it came to %2</source>
        <translation>%1 était demandé, mais le résultat est %2</translation>
    </message>
    <message>
        <source>%1 does not read back as it was written</source>
        <translation>%1 ne se relit pas tel qu&apos;il a été écrit</translation>
    </message>
    <message>
        <source>the written file has another shape</source>
        <translation>le fichier écrit a une autre forme</translation>
    </message>
    <message>
        <source>the written file cannot be read: %1</source>
        <translation>le fichier écrit ne peut être lu : %1</translation>
    </message>
    <message>
        <source>another run is using it: %1; if it is gone, its batch can be taken over</source>
        <translation>un autre travail s&apos;en sert : %1 ; s&apos;il a disparu, son lot peut être repris</translation>
    </message>
    <message>
        <source>another run is using it: %1</source>
        <translation>un autre travail s&apos;en sert : %1</translation>
    </message>
    <message>
        <source>another run is using it</source>
        <translation>un autre travail s&apos;en sert</translation>
    </message>
    <message>
        <source>%1 on %2, process %3, since %4</source>
        <translation>%1 sur %2, processus %3, depuis %4</translation>
    </message>
    <message>
        <source>cannot be listed, but holds clips that are done</source>
        <translation>ne peut être listé, mais contient des clips finis</translation>
    </message>
    <message>
        <source>is not the journal of a batch</source>
        <translation>n&apos;est pas le journal d&apos;un lot</translation>
    </message>
    <message>
        <source>changed while it was read</source>
        <translation>a changé pendant sa lecture</translation>
    </message>
    <message>
        <source>holds a batch already: it can be resumed or overwritten</source>
        <translation>contient déjà un lot : il peut être repris ou remplacé</translation>
    </message>
    <message>
        <source>is not of the same batch as the others</source>
        <translation>n&apos;est pas du même lot que les autres</translation>
    </message>
    <message>
        <source>holds no journal of a batch</source>
        <translation>ne contient pas de journal d&apos;un lot</translation>
    </message>
    <message>
        <source>%1 has an unknown preset</source>
        <translation>%1 a un préréglage inconnu</translation>
    </message>
    <message>
        <source>is not a queue of clips: %1</source>
        <translation>n&apos;est pas une file de clips : %1</translation>
    </message>
    <message>
        <source>is not a queue of clips</source>
        <translation>n&apos;est pas une file de clips</translation>
    </message>
    <message>
        <source>has an unknown format: %1</source>
        <translation>a un format inconnu : %1</translation>
    </message>
    <message>
        <source>has an unknown form of bank: %1</source>
        <translation>a une forme de banque inconnue : %1</translation>
    </message>
    <message>
        <source>a script for sbatch cannot name %1: it has %2 in it</source>
        <translation>un script pour sbatch ne peut nommer %1 : il contient %2</translation>
    </message>
    <message>
        <source>a line break or another control character</source>
        <translation>un saut de ligne ou un autre caractère de contrôle</translation>
    </message>
    <message>
        <source>a backslash</source>
        <translation>une barre oblique inverse</translation>
    </message>
    <message>
        <source>cannot be made: %1</source>
        <translation>ne peut être créé : %1</translation>
    </message>
    <message>
        <source>is written, but a power cut may undo it: its folder cannot be synchronised: %1</source>
        <translation>est écrit, mais une coupure de courant peut l&apos;annuler : son dossier ne peut être synchronisé : %1</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>n&apos;est pas un fichier ordinaire</translation>
    </message>
    <message>
        <source>is a link that somebody else put into a folder shared by all</source>
        <translation>est un lien que quelqu&apos;un d&apos;autre a mis dans un dossier commun à tous</translation>
    </message>
    <message>
        <source>became shorter while it was read</source>
        <translation>s&apos;est raccourci pendant sa lecture</translation>
    </message>
    <message>
        <source>takes more memory than this machine has to give</source>
        <translation>demande plus de mémoire que cette machine n&apos;en a</translation>
    </message>
    <message>
        <source>is a name that is not UTF-8</source>
        <translation>est un nom qui n&apos;est pas en UTF-8</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>Permission refusée</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>Opération non permise</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>Plus de place sur le disque</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>Quota de disque dépassé</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Système de fichiers en lecture seule</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>Nom de fichier trop long</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>Le fichier existe</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>N&apos;est pas un dossier</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>Est un dossier</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>Trop de fichiers ouverts</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Erreur d&apos;entrée/sortie</translation>
    </message>
    <message>
        <source>Too many levels of symbolic links</source>
        <translation>Trop de niveaux de liens symboliques</translation>
    </message>
    <message>
        <source>a record has too few bytes for its values</source>
        <translation>un enregistrement a trop peu d&apos;octets pour ses valeurs</translation>
    </message>
    <message>
        <source>a record is smaller than its values</source>
        <translation>un enregistrement est plus petit que ses valeurs</translation>
    </message>
    <message>
        <source>a record reaches beyond its parent</source>
        <translation>un enregistrement dépasse son parent</translation>
    </message>
    <message>
        <source>a record ends before the place it states</source>
        <translation>un enregistrement finit avant la place qu&apos;il annonce</translation>
    </message>
    <message>
        <source>a value reaches beyond its record</source>
        <translation>une valeur dépasse son enregistrement</translation>
    </message>
    <message>
        <source>ends within a record</source>
        <translation>se termine dans un enregistrement</translation>
    </message>
    <message>
        <source>ends within an array</source>
        <translation>se termine dans un tableau</translation>
    </message>
    <message>
        <source>ends within a value</source>
        <translation>se termine dans une valeur</translation>
    </message>
    <message>
        <source>ends within a text</source>
        <translation>se termine dans un texte</translation>
    </message>
    <message>
        <source>has a value of an unknown type</source>
        <translation>a une valeur d&apos;un type inconnu</translation>
    </message>
    <message>
        <source>has a value outside of records</source>
        <translation>a une valeur hors des enregistrements</translation>
    </message>
    <message>
        <source>closes a record that is not open</source>
        <translation>ferme un enregistrement qui n&apos;est pas ouvert</translation>
    </message>
    <message>
        <source>is not pictured in the report: %1</source>
        <translation>n&apos;est pas illustré dans le rapport : %1</translation>
    </message>
    <message>
        <source>opens a record without a name</source>
        <translation>ouvre un enregistrement sans nom</translation>
    </message>
    <message>
        <source>a finer tier without MOTN</source>
        <translation>un niveau plus fin sans MOTN</translation>
    </message>
    <message>
        <source>the first tier does not end where TIER says</source>
        <translation>le premier niveau ne finit pas là où TIER le dit</translation>
    </message>
    <message>
        <source>the file ends within a tier</source>
        <translation>le fichier se termine dans un niveau</translation>
    </message>
    <message>
        <source>a tier is damaged: its checksum differs</source>
        <translation>un niveau est abîmé : sa somme de contrôle diffère</translation>
    </message>
    <message>
        <source>the sizes of the segments do not add up to MOTN or to a finer tier</source>
        <translation>les tailles des segments ne font pas celle de MOTN ou d&apos;un niveau plus fin</translation>
    </message>
</context>
<context>
    <name>mocapress::Session</name>
    <message>
        <source>Import Options</source>
        <translation>Options d’importation</translation>
    </message>
    <message>
        <source>Character</source>
        <translation>Personnage</translation>
    </message>
</context>
<context>
    <name>mocapress::SettingsField</name>
    <message>
        <source>Target</source>
        <translation>Cible</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Weighting</source>
        <translation>Pondération</translation>
    </message>
    <message>
        <source>Coding</source>
        <translation>Codage</translation>
    </message>
    <message>
        <source>Held Feet</source>
        <translation>Pieds tenus</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Contacts</translation>
    </message>
    <message>
        <source>A or B</source>
        <translation>A ou B</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Préréglage</translation>
    </message>
    <message>
        <source>Effort</source>
        <translation>Effort</translation>
    </message>
    <message>
        <source>Importance</source>
        <translation>Importance</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Extrémités</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>Pistes</translation>
    </message>
    <message>
        <source>Care in a Range</source>
        <translation>Soin dans une plage</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Boucle</translation>
    </message>
    <message>
        <source>Viewing Distance</source>
        <translation>Distance de vue</translation>
    </message>
    <message>
        <source>Limits of Visibility</source>
        <translation>Seuils de visibilité</translation>
    </message>
</context>
<context>
    <name>mocapress::Sight</name>
    <message>
        <source>not visible</source>
        <translation>invisible</translation>
    </message>
    <message>
        <source>borderline</source>
        <translation>limite</translation>
    </message>
    <message>
        <source>visible</source>
        <translation>visible</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>vitesse</translation>
    </message>
    <message>
        <source>place about the body</source>
        <translation>place par rapport au corps</translation>
    </message>
    <message>
        <source>trembling</source>
        <translation>tremblement</translation>
    </message>
    <message>
        <source>sliding foot</source>
        <translation>pied qui glisse</translation>
    </message>
    <message>
        <source>floating foot</source>
        <translation>pied qui flotte</translation>
    </message>
    <message>
        <source>below the floor</source>
        <translation>sous le sol</translation>
    </message>
    <message>
        <source>flight</source>
        <translation>vol</translation>
    </message>
    <message>
        <source>turned head</source>
        <translation>tête tournée</translation>
    </message>
    <message>
        <source>turned hand</source>
        <translation>main tournée</translation>
    </message>
    <message>
        <source>%1: %2 %3, noticed from %4</source>
        <translation>%1 : %2 %3, remarqué à partir de %4</translation>
    </message>
    <message>
        <source>%1 from %L2 m</source>
        <translation>%1 à %L2 m</translation>
    </message>
</context>
<context>
    <name>mocapress::SightStrip</name>
    <message>
        <source>Visible errors</source>
        <translation>Erreurs visibles</translation>
    </message>
    <message>
        <source>Times at which errors are visible. The heat map shows them by joint.</source>
        <translation>Où l&apos;on remarque que la séquence est compressée. La carte de chaleur le montre par articulation.</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Vu</translation>
    </message>
    <message>
        <source>Times at which errors are visible (full column) or borderline (half a column).</source>
        <translation>Où l&apos;on remarque que la séquence est compressée : une demi-colonne est limite, une colonne entière est visible.</translation>
    </message>
    <message>
        <source>%1, frame %L2</source>
        <translation>%1, image %L2</translation>
    </message>
</context>
<context>
    <name>mocapress::SignOffExport</name>
    <message>
        <source>Export Sign-off</source>
        <translation>Exporter la validation</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Pages web (*.html)</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tableaux (*.csv)</translation>
    </message>
    <message>
        <source>Exported %1.</source>
        <translation>%1 exporté.</translation>
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
        <translation>Articulation</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Frames in which the foot of the original stands on the ground.</source>
        <translation>Pendant que l&apos;original est posé au sol.</translation>
    </message>
    <message>
        <source>cm/s</source>
        <translation>cm/s</translation>
    </message>
    <message>
        <source>Highest speed over the ground.</source>
        <translation>Plus grande vitesse sur le sol.</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Dérive</translation>
    </message>
    <message>
        <source>Largest distance between the foot and its place in the original.</source>
        <translation>De combien le pied s&apos;éloigne de l&apos;endroit où il devrait se tenir.</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Chemin</translation>
    </message>
    <message>
        <source>Path of the foot over the ground beyond the original&apos;s. A foot that trembles in place has a long path.</source>
        <translation>Longueur de son chemin sur le sol au-delà de celui de l&apos;original : le tremblement d&apos;un pied sur place s&apos;y additionne.</translation>
    </message>
</context>
<context>
    <name>mocapress::SlotControl</name>
    <message>
        <source>Settings %1</source>
        <translation>Réglages %1</translation>
    </message>
    <message>
        <source>Two settings to compare: tune one, switch to the other (A), and compare the results.</source>
        <translation>Deux réglages à comparer : en régler un, passer à l&apos;autre (A) et regarder les deux.</translation>
    </message>
    <message>
        <source>Copy settings to the other</source>
        <translation>Copier les réglages vers l&apos;autre</translation>
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
        <translation>Copier ces réglages vers %1</translation>
    </message>
</context>
<context>
    <name>mocapress::StudyClips</name>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Clips of the study</source>
        <translation>Clips de l&apos;étude</translation>
    </message>
    <message>
        <source>Drop files or folders here.</source>
        <translation>Déposer ici fichiers ou dossiers.</translation>
    </message>
    <message>
        <source>Add Files…</source>
        <translation>Ajouter des fichiers…</translation>
    </message>
    <message>
        <source>Add motions</source>
        <translation>Ajouter des mouvements</translation>
    </message>
    <message>
        <source>Add Folder…</source>
        <translation>Ajouter un dossier…</translation>
    </message>
    <message>
        <source>Add every motion below a folder</source>
        <translation>Ajouter chaque mouvement d&apos;un dossier</translation>
    </message>
    <message>
        <source>Remove the selected clips from the list (Del)</source>
        <translation>Retirer de la liste les clips choisis (Suppr)</translation>
    </message>
</context>
<context>
    <name>mocapress::StudyPanel</name>
    <message>
        <source>Also with feet held</source>
        <translation>Aussi avec les pieds tenus</translation>
    </message>
    <message>
        <source>Progress of the study</source>
        <translation>Progrès de l&apos;étude</translation>
    </message>
    <message>
        <source>Measurements that are already there are kept.</source>
        <translation>Ce qui a été mesuré ne l&apos;est pas de nouveau.</translation>
    </message>
    <message>
        <source>Clips</source>
        <translation>Clips</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>Méthodes</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Cibles</translation>
    </message>
    <message>
        <source>Methods of the study</source>
        <translation>Méthodes de l&apos;étude</translation>
    </message>
    <message>
        <source>IK ratio of the study</source>
        <translation>Taux IK de l&apos;étude</translation>
    </message>
    <message>
        <source>Coefficient ratio of the IK correction (r_IK).</source>
        <translation>De combien les signaux de correction sont compressés (r_IK).</translation>
    </message>
    <message>
        <source>:1</source>
        <translation>:1</translation>
    </message>
    <message>
        <source>Ratios to reach</source>
        <translation>Taux à atteindre</translation>
    </message>
    <message>
        <source>Compression ratios, separated by spaces.</source>
        <translation>Taux de compression, séparés par des espaces.</translation>
    </message>
    <message>
        <source>Errors to keep, in cm</source>
        <translation>Erreurs à tenir, en cm</translation>
    </message>
    <message>
        <source>Errors eps_x to compress to, in centimetres, separated by spaces.</source>
        <translation>Bornes d&apos;eps_x en centimètres, séparées par des espaces.</translation>
    </message>
    <message>
        <source>Weighting of the study</source>
        <translation>Pondération de l&apos;étude</translation>
    </message>
    <message>
        <source>Ratios</source>
        <translation>Taux</translation>
    </message>
    <message>
        <source>Errors (cm)</source>
        <translation>Erreurs (cm)</translation>
    </message>
    <message>
        <source>Weighting</source>
        <translation>Pondération</translation>
    </message>
    <message>
        <source>Kept in</source>
        <translation>Gardé dans</translation>
    </message>
    <message>
        <source>This computer&apos;s cache</source>
        <translation>Cache de cet ordinateur</translation>
    </message>
    <message>
        <source>Folder of the study: %1</source>
        <translation>Dossier de l&apos;étude : %1</translation>
    </message>
    <message>
        <source>Folder for measurements, from which a stopped study continues. Click to choose a folder; if it holds a study, that study is shown.
%1</source>
        <translation>Où les mesures sont gardées, pour qu&apos;une étude arrêtée reprenne où elle était. Cliquer pour choisir un dossier, ou un dossier qui contient une étude, pour la voir.
%1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Run Study</source>
        <translation>Lancer l&apos;étude</translation>
    </message>
    <message>
        <source>Adds a curve of annealed wavelets with feet held by inverse kinematics, at the same ratios.</source>
        <translation>Une courbe de plus : les ondelettes par recuit dont la cinématique inverse tient les pieds en place, aux taux demandés.</translation>
    </message>
    <message>
        <source>Points on which the error eps_x is measured. Surface: a body modelled around the bones, so that turned heads and hands count. Shell: three points 3 cm from every joint, as in ACL. Bone ends and joint origins: points on the bones, weighted by bone length; joint origins are the paper&apos;s.</source>
        <translation>Les points que compte l&apos;erreur eps_x. Surface : un corps modelé autour des os, si bien que la tête et les mains tournées comptent. Coque : trois points à 3 cm de chaque articulation, comme ACL. Extrémités des os et origines des articulations : des points sur les os, selon leur longueur ; les dernières sont celles de l&apos;article.</translation>
    </message>
</context>
<context>
    <name>mocapress::StudyResults</name>
    <message>
        <source>Clips shown</source>
        <translation>Clips montrés</translation>
    </message>
    <message>
        <source>Show one clip, or the average: the geometric mean of all clips&apos; ratios at equal error, with the points of all clips behind it.</source>
        <translation>Un clip, ou la moyenne des clips : la moyenne géométrique de leurs taux à erreur égale, avec les points de tous derrière.</translation>
    </message>
    <message>
        <source>S&amp;how</source>
        <translation>A&amp;fficher</translation>
    </message>
    <message>
        <source>%1
Click to load it into the studio.</source>
        <translation>%1
Cliquer pour le charger dans le studio.</translation>
    </message>
    <message>
        <source>Rows of the study</source>
        <translation>Lignes de l&apos;étude</translation>
    </message>
    <message numerus="yes">
        <source>Average over %Ln clip(s)</source>
        <translation>
            <numerusform>Moyenne sur %Ln clip</numerusform>
            <numerusform>Moyenne sur %Ln clips</numerusform>
        </translation>
    </message>
    <message>
        <source>All clips</source>
        <translation>Tous les clips</translation>
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
        <translation>max %L1 cm</translation>
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
        <translation>eps_x %1 cm, au plus %2 cm</translation>
    </message>
    <message numerus="yes">
        <source>%1 cm of footskate in %Ln contact(s)</source>
        <translation>
            <numerusform>%1 cm de glissement en %Ln contact</numerusform>
            <numerusform>%1 cm de glissement en %Ln contacts</numerusform>
        </translation>
    </message>
    <message>
        <source>Asked for %1.</source>
        <translation>Demandé : %1.</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Clip</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Asked</source>
        <translation>Demandé</translation>
    </message>
    <message>
        <source>Target: a ratio, or the largest error allowed.</source>
        <translation>La cible : un taux, ou une erreur à ne pas dépasser.</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Taux</translation>
    </message>
    <message>
        <source>Bytes of the channels as 32-bit floats, divided by compressed bytes.</source>
        <translation>Octets des canaux en flottants de 32 bits sur octets compressés.</translation>
    </message>
    <message>
        <source>eps_x cm</source>
        <translation>eps_x cm</translation>
    </message>
    <message>
        <source>Weighted root mean square error.</source>
        <translation>Erreur quadratique moyenne pondérée.</translation>
    </message>
    <message>
        <source>Max cm</source>
        <translation>Max cm</translation>
    </message>
    <message>
        <source>Largest error of any point at any frame.</source>
        <translation>Plus grande erreur d&apos;un point quelconque, toutes images confondues.</translation>
    </message>
    <message>
        <source>Slide cm</source>
        <translation>Gliss. cm</translation>
    </message>
    <message>
        <source>Path of feet while they stand in the original.</source>
        <translation>De combien les pieds glissent pendant qu&apos;ils sont posés dans l&apos;original.</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Secondes</translation>
    </message>
    <message>
        <source>Time to compress, including the search for the target.</source>
        <translation>Durée de la compression, recherche de la cible comprise.</translation>
    </message>
    <message>
        <source>%L1 times the noticeable error</source>
        <translation>%L1 fois le perceptible</translation>
    </message>
</context>
<context>
    <name>mocapress::StudySession</name>
    <message>
        <source>The picture could not be made.</source>
        <translation>L&apos;image n&apos;a pas pu être faite.</translation>
    </message>
</context>
<context>
    <name>mocapress::StudyStatus</name>
    <message numerus="yes">
        <source>%Ln compression(s) to run</source>
        <translation>
            <numerusform>%Ln compression à faire</numerusform>
            <numerusform>%Ln compressions à faire</numerusform>
        </translation>
    </message>
    <message>
        <source>%L1 of %L2</source>
        <translation>%L1 sur %L2</translation>
    </message>
    <message>
        <source>%1, about %2 left</source>
        <translation>%1, encore %2 environ</translation>
    </message>
    <message numerus="yes">
        <source>, %Ln out of reach</source>
        <translation>
            <numerusform>, %Ln hors d&apos;atteinte</numerusform>
            <numerusform>, %Ln hors d&apos;atteinte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %Ln of clips that cannot be read</source>
        <translation>
            <numerusform>, %Ln d&apos;un clip illisible</numerusform>
            <numerusform>, %Ln de clips illisibles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln compression(s)%1</source>
        <translation>
            <numerusform>%Ln compression%1</numerusform>
            <numerusform>%Ln compressions%1</numerusform>
        </translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>Écriture…</translation>
    </message>
    <message>
        <source>Drawing the report…</source>
        <translation>Tracé du rapport…</translation>
    </message>
    <message>
        <source>Cancelled after %L1 of %L2; the next run continues from there</source>
        <translation>Annulé après %L1 sur %L2 ; la prochaine fois reprend de là</translation>
    </message>
    <message>
        <source>Add a clip to study</source>
        <translation>Ajouter un clip à étudier</translation>
    </message>
    <message>
        <source>Check a method to study</source>
        <translation>Cocher une méthode à étudier</translation>
    </message>
    <message>
        <source>Enter a ratio or an error</source>
        <translation>Donner un taux ou une erreur à atteindre</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Mesure…</translation>
    </message>
    <message>
        <source>Curves appear after the study has run</source>
        <translation>Lancer l&apos;étude pour voir des courbes</translation>
    </message>
</context>
<context>
    <name>mocapress::StudyWindow</name>
    <message>
        <source>Study</source>
        <translation>Étude</translation>
    </message>
    <message>
        <source>Wrote %1.</source>
        <translation>%1 écrit.</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exporter</translation>
    </message>
    <message>
        <source>Write the measurements to a file</source>
        <translation>Écrire les mesures dans un fichier</translation>
    </message>
    <message>
        <source>Rows as CSV…</source>
        <translation>Lignes en CSV…</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>Valeurs séparées par des virgules (*.csv)</translation>
    </message>
    <message>
        <source>Plot as PNG…</source>
        <translation>Courbe en PNG…</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Images (*.png)</translation>
    </message>
    <message>
        <source>Plot as PDF…</source>
        <translation>Courbe en PDF…</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>Documents PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Report as HTML…</source>
        <translation>Rapport en HTML…</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Pages web (*.html)</translation>
    </message>
    <message>
        <source>Add Clips</source>
        <translation>Ajouter des clips</translation>
    </message>
    <message>
        <source>Motion (%1)</source>
        <translation>Mouvement (%1)</translation>
    </message>
    <message>
        <source>Add All Clips below</source>
        <translation>Ajouter tous les clips de</translation>
    </message>
    <message>
        <source>Folder of the Study</source>
        <translation>Dossier de l&apos;étude</translation>
    </message>
    <message>
        <source>In the studio: %1, %2, %3.</source>
        <translation>Dans le studio : %1, %2, %3.</translation>
    </message>
</context>
<context>
    <name>mocapress::TargetControl</name>
    <message>
        <source> bytes</source>
        <translation> octets</translation>
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
        <translation>Cible</translation>
    </message>
    <message>
        <source>Compression ratio</source>
        <translation>Taux de compression</translation>
    </message>
    <message>
        <source>Error (eps_x)</source>
        <translation>Erreur (eps_x)</translation>
    </message>
    <message>
        <source>Target on a slider</source>
        <translation>Cible au curseur</translation>
    </message>
    <message>
        <source>Target value</source>
        <translation>Valeur de la cible</translation>
    </message>
    <message>
        <source>Target as a number; type it or use the arrows.</source>
        <translation>La cible en nombre ; la taper ou la faire défiler.</translation>
    </message>
    <message>
        <source>Hard maximum</source>
        <translation>Maximum absolu</translation>
    </message>
    <message>
        <source>Drag to change the target. A draft appears at once and is refined when you pause. What the preset promises of head, hands and fingers is kept beside an error.</source>
        <translation>Glissez : une ébauche suit aussitôt, affinée dès que vous marquez une pause. Ce que le préréglage promet pour la tête, les mains et les doigts est tenu en plus d’une erreur.</translation>
    </message>
    <message>
        <source>Problem with the target</source>
        <translation>Problème avec la cible</translation>
    </message>
    <message>
        <source>The target must be above zero.</source>
        <translation>À zéro, il n&apos;y a rien à demander.</translation>
    </message>
    <message>
        <source> times</source>
        <translation> fois</translation>
    </message>
    <message>
        <source>Visibility</source>
        <translation>Visibilité</translation>
    </message>
    <message>
        <source>Sizes: the compression ratio (bytes of the channels as 32-bit floats, divided by compressed motion bytes) or the motion bytes themselves. Qualities: the weighted RMS error eps_x, the largest error of any point at any frame, or visibility, the largest error as a multiple of what people notice: at 1, no error is visible.</source>
        <translation>Demander une taille (taux de compression : octets des canaux en flottants de 32 bits sur les octets du mouvement compressé ; ou ces octets mêmes) ou une qualité (erreur moyenne pondérée eps_x ; une distance qu&apos;aucune articulation ne dépasse à aucune image ; ou l&apos;écart maximal, en multiple de ce que l&apos;on remarque : à 1, rien n&apos;est visible).</translation>
    </message>
    <message>
        <source>Size of the motion</source>
        <translation>Taille du mouvement</translation>
    </message>
</context>
<context>
    <name>mocapress::TimeRuler</name>
    <message>
        <source>Time ruler</source>
        <translation>Règle du temps</translation>
    </message>
    <message>
        <source>Frames and seconds. The menu Play chooses a range.</source>
        <translation>Images et secondes. Le menu Lecture choisit une plage.</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Secondes</translation>
    </message>
    <message>
        <source>Care</source>
        <translation>Soin</translation>
    </message>
    <message>
        <source>Frames %L1–%L2: the target is %L3 times stricter. A click chooses the range.</source>
        <translation>Images %L1–%L2 : la cible est %L3 fois plus stricte. Un clic choisit la plage.</translation>
    </message>
    <message>
        <source>Drag to choose a range, then right-click it.</source>
        <translation>Glissez pour choisir une plage, puis faites un clic droit.</translation>
    </message>
    <message>
        <source>Frames %L1–%L2, %3. A double click chooses the whole clip again.</source>
        <translation>Images %L1–%L2, %3. Un double clic choisit de nouveau tout le clip.</translation>
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
        <translation>Partie visible du clip</translation>
    </message>
    <message>
        <source>&amp;Poses</source>
        <translation>&amp;Poses</translation>
    </message>
    <message>
        <source>&amp;Bytes</source>
        <translation>&amp;Octets</translation>
    </message>
    <message>
        <source>&amp;Errors</source>
        <translation>&amp;Erreurs</translation>
    </message>
    <message>
        <source>Visible E&amp;rrors</source>
        <translation>Erreurs &amp;visibles</translation>
    </message>
    <message>
        <source>&amp;Notes</source>
        <translation>&amp;Notes</translation>
    </message>
    <message>
        <source>&amp;Contacts</source>
        <translation>&amp;Contacts</translation>
    </message>
</context>
<context>
    <name>mocapress::ToolWindows</name>
    <message>
        <source>The batch of this project is running. Stop it or wait until it ends.</source>
        <translation>Le lot de ce projet est en cours : arrêtez-le d&apos;abord, ou laissez-le finir.</translation>
    </message>
</context>
<context>
    <name>mocapress::TransportBar</name>
    <message>
        <source>First Frame</source>
        <translation>Première image</translation>
    </message>
    <message>
        <source>Previous Frame</source>
        <translation>Image précédente</translation>
    </message>
    <message>
        <source>Play or Pause</source>
        <translation>Lire ou suspendre</translation>
    </message>
    <message>
        <source>Next Frame</source>
        <translation>Image suivante</translation>
    </message>
    <message>
        <source>Last Frame</source>
        <translation>Dernière image</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Boucle</translation>
    </message>
    <message>
        <source>Play Backwards; Press Again to Go Faster</source>
        <translation>Lire à rebours, encore : plus vite</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play Forwards; Press Again to Go Faster</source>
        <translation>Lire en avant, encore : plus vite</translation>
    </message>
    <message>
        <source>Ten Frames Back</source>
        <translation>Dix images en arrière</translation>
    </message>
    <message>
        <source>Ten Frames On</source>
        <translation>Dix images en avant</translation>
    </message>
    <message>
        <source>Play from Here</source>
        <translation>Lire à partir d&apos;ici</translation>
    </message>
    <message>
        <source>Play to Here</source>
        <translation>Lire jusqu&apos;ici</translation>
    </message>
    <message>
        <source>Play the Whole Clip</source>
        <translation>Lire tout le clip</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Drag to any frame.</source>
        <translation>Glisser vers une image.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Frame read-out</source>
        <translation>Affichage de l&apos;image</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Playing speed; 1× is the recorded speed.</source>
        <translation>Vitesse de lecture ; 1× comme enregistré.</translation>
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
        <translation>Prise</translation>
    </message>
    <message>
        <source>Animation of the file to read.</source>
        <translation>L&apos;animation du fichier qui est lue.</translation>
    </message>
</context>
<context>
    <name>mocapress::ViewActions</name>
    <message>
        <source>&amp;Overlay</source>
        <translation>&amp;Superposer</translation>
    </message>
    <message>
        <source>The original as a ghost over the compressed figure</source>
        <translation>L&apos;original en fantôme sur la figure compressée</translation>
    </message>
    <message>
        <source>&amp;Side by Side</source>
        <translation>Côte à &amp;côte</translation>
    </message>
    <message>
        <source>Original and compressed figure beside each other</source>
        <translation>Figures originale et compressée l&apos;une à côté de l&apos;autre</translation>
    </message>
    <message>
        <source>&amp;Wipe</source>
        <translation>&amp;Volet</translation>
    </message>
    <message>
        <source>Original on one side of a divider that can be dragged, compressed figure on the other</source>
        <translation>Une seule image avec un volet à faire glisser, même pendant la lecture</translation>
    </message>
    <message>
        <source>Sw&amp;ap</source>
        <translation>&amp;Échanger</translation>
    </message>
    <message>
        <source>Swap original and compressed figure</source>
        <translation>Échanger les places des figures originale et compressée</translation>
    </message>
    <message>
        <source>&amp;Blink</source>
        <translation>&amp;Alterner</translation>
    </message>
    <message>
        <source>Original and compressed figure take turns in one place</source>
        <translation>Figures originale et compressée alternent à la même place</translation>
    </message>
    <message>
        <source>Colour by &amp;Error</source>
        <translation>Colorer selon l&apos;&amp;erreur</translation>
    </message>
    <message>
        <source>Colour every joint by its distance from the original, in cm</source>
        <translation>Colorer chaque articulation selon sa distance à l&apos;original, en cm</translation>
    </message>
    <message>
        <source>Show Skin</source>
        <translation>Afficher la peau</translation>
    </message>
    <message>
        <source>Show figures with their skin or as skeletons</source>
        <translation>Les figures avec leur peau, ou en squelettes</translation>
    </message>
    <message>
        <source>&amp;Path of the Joint</source>
        <translation>&amp;Trajet de l&apos;articulation</translation>
    </message>
    <message>
        <source>Path of the selected joint, half a second before and after the current frame</source>
        <translation>Le chemin de l&apos;articulation choisie, une demi-seconde de part et d&apos;autre</translation>
    </message>
    <message>
        <source>&amp;Follow</source>
        <translation>S&amp;uivre</translation>
    </message>
    <message>
        <source>The camera moves with the figure</source>
        <translation>La caméra suit la figure</translation>
    </message>
    <message>
        <source>I&amp;n Place</source>
        <translation>Sur &amp;place</translation>
    </message>
    <message>
        <source>Play without the root&apos;s travel over the ground</source>
        <translation>Lire sans le trajet de la racine sur le sol</translation>
    </message>
    <message>
        <source>F&amp;loor View</source>
        <translation>Vue de &amp;dessus</translation>
    </message>
    <message>
        <source>Look straight down, as on a plan</source>
        <translation>Regarder à la verticale, comme sur un plan</translation>
    </message>
    <message>
        <source>&amp;Reset Camera</source>
        <translation>&amp;Rétablir la caméra</translation>
    </message>
    <message>
        <source>Look at the whole figure again</source>
        <translation>Revoir toute la figure</translation>
    </message>
    <message>
        <source>Ghost &amp;Trail</source>
        <translation>Traînée &amp;fantôme</translation>
    </message>
    <message>
        <source>Faded poses of the compressed figure before (blue) and after (orange) the current frame</source>
        <translation>Où la figure compressée était (bleu) et sera (orange), estompée</translation>
    </message>
    <message numerus="yes">
        <source>%Ln pose(s) before and after</source>
        <translation>
            <numerusform>%Ln pose avant et après</numerusform>
            <numerusform>%Ln poses avant et après</numerusform>
        </translation>
    </message>
    <message>
        <source>Poses of the Tra&amp;il</source>
        <translation>Poses de la traî&amp;née</translation>
    </message>
    <message>
        <source>Fo&amp;ur Views</source>
        <translation>&amp;Quatre vues</translation>
    </message>
    <message>
        <source>The same figures from anywhere, from the front, the side and the top</source>
        <translation>Les mêmes figures sous un angle libre, de face, de profil et de dessus</translation>
    </message>
    <message>
        <source>E&amp;xaggerate the Difference</source>
        <translation>E&amp;xagérer la différence</translation>
    </message>
    <message>
        <source>Show poses and paths with a difference from the original that is so many times larger than it is</source>
        <translation>Montrer poses et trajectoires avec un écart à l&apos;original multiplié d&apos;autant</translation>
    </message>
    <message>
        <source>%L1 times</source>
        <translation>%L1 fois</translation>
    </message>
    <message>
        <source>From the Fro&amp;nt</source>
        <translation>De &amp;face</translation>
    </message>
    <message>
        <source>Look along the z axis; again: as before</source>
        <translation>Regarder selon l&apos;axe z ; encore : comme avant</translation>
    </message>
    <message>
        <source>From the S&amp;ide</source>
        <translation>De &amp;profil</translation>
    </message>
    <message>
        <source>Look along the x axis; again: as before</source>
        <translation>Regarder selon l&apos;axe x ; encore : comme avant</translation>
    </message>
    <message>
        <source>Frame &amp;Joint</source>
        <translation>Cadrer l&apos;&amp;articulation</translation>
    </message>
    <message>
        <source>Look at the selected joint, or at the whole figure without one</source>
        <translation>Regarder l&apos;articulation choisie, ou toute la figure sans elle</translation>
    </message>
    <message>
        <source>Camera &amp;%L1</source>
        <translation>Caméra &amp;%L1</translation>
    </message>
    <message>
        <source>Look from where the camera was when it was kept</source>
        <translation>Regarder d&apos;où était la caméra quand elle a été gardée</translation>
    </message>
    <message>
        <source>Keep as Camera %L1</source>
        <translation>Garder comme caméra %L1</translation>
    </message>
    <message>
        <source>Keep the camera&apos;s place, relative to the figure</source>
        <translation>Garder la place de la caméra, relative à la figure</translation>
    </message>
    <message>
        <source>Exaggeration</source>
        <translation>Exagération</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Caméras</translation>
    </message>
</context>
<context>
    <name>mocapress::ViewPictures</name>
    <message>
        <source>Making the video…</source>
        <translation>Création de la vidéo…</translation>
    </message>
    <message>
        <source>Wrote %1.</source>
        <translation>%1 écrit.</translation>
    </message>
    <message>
        <source>The 3D view gave no picture.</source>
        <translation>La vue 3D n&apos;a pas donné d&apos;image.</translation>
    </message>
    <message>
        <source>Copied the picture of the view.</source>
        <translation>Image de la vue copiée.</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Enregistrer l&apos;image</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Images (*.png)</translation>
    </message>
    <message>
        <source>Film of the Range</source>
        <translation>Film de la plage</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Tour complet</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.webm *.gif)</source>
        <translation>Vidéos (*.mp4 *.webm *.gif)</translation>
    </message>
    <message>
        <source>Numbered pictures in a folder (*.png)</source>
        <translation>Images numérotées dans un dossier (*.png)</translation>
    </message>
    <message numerus="yes">
        <source>Taking %Ln picture(s)…</source>
        <translation>
            <numerusform>Prise de %Ln image…</numerusform>
            <numerusform>Prise de %Ln images…</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>mocapress::Viewport</name>
    <message>
        <source>The 3D view needs OpenGL 3.2, which is not available here.</source>
        <translation>La vue 3D a besoin d&apos;OpenGL 3.2, qui n&apos;est pas disponible ici.</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>Vue 3D</translation>
    </message>
</context>
</TS>
