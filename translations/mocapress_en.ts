<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US" sourcelanguage="en">
<context>
    <name>mocapress::BatchQueueModel</name>
    <message numerus="yes">
        <source>✓ Verified, %Ln warning(s)</source>
        <translation>
            <numerusform>✓ Verified, %Ln warning</numerusform>
            <numerusform>✓ Verified, %Ln warnings</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln care range(s)</source>
        <translation>
            <numerusform>%Ln care range</numerusform>
            <numerusform>%Ln care ranges</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mocapress::BatchStatus</name>
    <message numerus="yes">
        <source>, %Ln failed</source>
        <translation>
            <numerusform>, %Ln failed</numerusform>
            <numerusform>, %Ln failed</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln clip(s) to export</source>
        <translation>
            <numerusform>%Ln clip to export</numerusform>
            <numerusform>%Ln clips to export</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln clip(s) exported and verified</source>
        <translation>
            <numerusform>%Ln clip exported and verified</numerusform>
            <numerusform>%Ln clips exported and verified</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>&amp;Retry %Ln Failed</source>
        <translation>
            <numerusform>&amp;Retry %Ln Failed</numerusform>
            <numerusform>&amp;Retry %Ln Failed</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %Ln left out</source>
        <translation>
            <numerusform>, %Ln left out</numerusform>
            <numerusform>, %Ln left out</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %Ln with warnings</source>
        <translation>
            <numerusform>, %Ln with warnings</numerusform>
            <numerusform>, %Ln with warnings</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %Ln with a stale verdict</source>
        <translation>
            <numerusform>, %Ln with a stale verdict</numerusform>
            <numerusform>, %Ln with stale verdicts</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mocapress::BatchWindow</name>
    <message numerus="yes">
        <source>Settings of %Ln selected clip(s)</source>
        <translation>
            <numerusform>Settings of the selected clip</numerusform>
            <numerusform>Settings of %Ln selected clips</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mocapress::CorrectionControl</name>
    <message numerus="yes">
        <source>%Ln joint(s)</source>
        <translation>
            <numerusform>%Ln joint</numerusform>
            <numerusform>%Ln joints</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mocapress::Figures</name>
    <message numerus="yes">
        <source>%Ln contact(s): mean drift of the feet %1, worst %2; their path is %3 longer than the original&apos;s</source>
        <translation>
            <numerusform>%Ln contact: mean drift of the foot %1, worst %2; its path is %3 longer than the original&apos;s</numerusform>
            <numerusform>%Ln contacts: mean drift of the feet %1, worst %2; their path is %3 longer than the original&apos;s</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1, %Ln iteration(s), %L2 s</source>
        <translation>
            <numerusform>%1, %Ln iteration, %L2 s</numerusform>
            <numerusform>%1, %Ln iterations, %L2 s</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mocapress::Library</name>
    <message numerus="yes">
        <source>%Ln clip(s) were taken out of the library; Redo brings them back.</source>
        <translation>
            <numerusform>%Ln clip was taken out of the library; Redo brings it back.</numerusform>
            <numerusform>%Ln clips were taken out of the library; Redo brings them back.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>No verdict for %Ln clip(s): the file is missing.</source>
        <translation>
            <numerusform>No verdict for %Ln clip: the file is missing.</numerusform>
            <numerusform>No verdict for %Ln clips: the files are missing.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The files of %Ln clip(s) have changed.</source>
        <translation>
            <numerusform>The files of %Ln clip have changed.</numerusform>
            <numerusform>The files of %Ln clips have changed.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The files of %Ln clip(s) are missing. The library&apos;s context menu finds them in another folder.</source>
        <translation>
            <numerusform>The files of %Ln clip are missing. The library&apos;s context menu finds them in another folder.</numerusform>
            <numerusform>The files of %Ln clips are missing. The library&apos;s context menu finds them in another folder.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Found %Ln clip(s)</source>
        <translation>
            <numerusform>Found %Ln clip</numerusform>
            <numerusform>Found %Ln clips</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %Ln still missing</source>
        <translation>
            <numerusform>, %Ln still missing</numerusform>
            <numerusform>, %Ln still missing</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1, %Ln Clip(s)</source>
        <translation>
            <numerusform>%1, %Ln Clip</numerusform>
            <numerusform>%1, %Ln Clips</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Wrote the notes of %Ln file(s) beside them.</source>
        <translation>
            <numerusform>Wrote the notes of %Ln file beside it.</numerusform>
            <numerusform>Wrote the notes of %Ln files beside them.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Read %Ln note(s).</source>
        <translation>
            <numerusform>Read %Ln note.</numerusform>
            <numerusform>Read %Ln notes.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln clip(s) compared with %1: %2 bytes then, %3 now; %4.</source>
        <translation>
            <numerusform>%Ln clip compared with %1: %2 bytes then, %3 now; %4.</numerusform>
            <numerusform>%Ln clips compared with %1: %2 bytes then, %3 now; %4.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mocapress::LibraryModel</name>
    <message numerus="yes">
        <source>%Ln frame(s)</source>
        <translation>
            <numerusform>%Ln frame</numerusform>
            <numerusform>%Ln frames</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln note(s)</source>
        <translation>
            <numerusform>%Ln note</numerusform>
            <numerusform>%Ln notes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln clip(s)</source>
        <comment>selected</comment>
        <translation>
            <numerusform>%Ln clip</numerusform>
            <numerusform>%Ln clips</numerusform>
        </translation>
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
</context>
<context>
    <name>mocapress::Notices</name>
    <message numerus="yes">
        <source>The last session ended unexpectedly. Its project was restored: %Ln clip(s).</source>
        <translation>
            <numerusform>The last session ended unexpectedly. Its project was restored: %Ln clip.</numerusform>
            <numerusform>The last session ended unexpectedly. Its project was restored: %Ln clips.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mocapress::Presets</name>
    <message numerus="yes">
        <source>%Ln contact(s) of its own.</source>
        <translation>
            <numerusform>%Ln contact of its own.</numerusform>
            <numerusform>%Ln contacts of its own.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln range(s) with more care.</source>
        <translation>
            <numerusform>%Ln range with more care.</numerusform>
            <numerusform>%Ln ranges with more care.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mocapress::ProjectFiles</name>
    <message numerus="yes">
        <source>Save the project of %Ln clip(s) under a name?</source>
        <translation>
            <numerusform>Save the project of %Ln clip under a name?</numerusform>
            <numerusform>Save the project of %Ln clips under a name?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1, %Ln clip(s)</source>
        <translation>
            <numerusform>%1, %Ln clip</numerusform>
            <numerusform>%1, %Ln clips</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mocapress::Sentence</name>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation>
            <numerusform>%n value</numerusform>
            <numerusform>%n values</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s)</source>
        <translation>
            <numerusform>%n joint</numerusform>
            <numerusform>%n joints</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n node(s)</source>
        <translation>
            <numerusform>%n node</numerusform>
            <numerusform>%n nodes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n bone(s)</source>
        <translation>
            <numerusform>%n bone</numerusform>
            <numerusform>%n bones</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n channel(s)</source>
        <translation>
            <numerusform>%n channel</numerusform>
            <numerusform>%n channels</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n curve(s)</source>
        <translation>
            <numerusform>%n curve</numerusform>
            <numerusform>%n curves</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n key(s)</source>
        <translation>
            <numerusform>%n key</numerusform>
            <numerusform>%n keys</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s)</source>
        <translation>
            <numerusform>%n frame</numerusform>
            <numerusform>%n frames</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n column(s)</source>
        <translation>
            <numerusform>%n column</numerusform>
            <numerusform>%n columns</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n End Site(s)</source>
        <translation>
            <numerusform>%n End Site</numerusform>
            <numerusform>%n End Sites</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n connection(s)</source>
        <translation>
            <numerusform>%n connection</numerusform>
            <numerusform>%n connections</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mocapress::StudyResults</name>
    <message numerus="yes">
        <source>Average over %Ln clip(s)</source>
        <translation>
            <numerusform>Average over %Ln clip</numerusform>
            <numerusform>Average over %Ln clips</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mocapress::StudyRowsModel</name>
    <message numerus="yes">
        <source>%1 cm of footskate in %Ln contact(s)</source>
        <translation>
            <numerusform>%1 cm of footskate in %Ln contact</numerusform>
            <numerusform>%1 cm of footskate in %Ln contacts</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mocapress::StudyStatus</name>
    <message numerus="yes">
        <source>%Ln compression(s) to run</source>
        <translation>
            <numerusform>%Ln compression to run</numerusform>
            <numerusform>%Ln compressions to run</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %Ln out of reach</source>
        <translation>
            <numerusform>, %Ln out of reach</numerusform>
            <numerusform>, %Ln out of reach</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %Ln of clips that cannot be read</source>
        <translation>
            <numerusform>, %Ln of clips that cannot be read</numerusform>
            <numerusform>, %Ln of clips that cannot be read</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln compression(s)%1</source>
        <translation>
            <numerusform>%Ln compression%1</numerusform>
            <numerusform>%Ln compressions%1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mocapress::ViewActions</name>
    <message numerus="yes">
        <source>%Ln pose(s) before and after</source>
        <translation>
            <numerusform>%Ln pose before and after</numerusform>
            <numerusform>%Ln poses before and after</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mocapress::ViewPictures</name>
    <message numerus="yes">
        <source>Taking %Ln picture(s)…</source>
        <translation>
            <numerusform>Taking %Ln picture…</numerusform>
            <numerusform>Taking %Ln pictures…</numerusform>
        </translation>
    </message>
</context>
</TS>
