<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja">
<context>
    <name>mocapress::Actions</name>
    <message>
        <source>Tools</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>開く(&amp;O)…</translation>
    </message>
    <message>
        <source>Open a motion or a compressed clip (.mcpr)</source>
        <translation>モーションまたは圧縮クリップ(.mcpr)を開く</translation>
    </message>
    <message>
        <source>Open Sample &amp;Walk</source>
        <translation>サンプルの歩行を開く(&amp;W)</translation>
    </message>
    <message>
        <source>Choose Skeleton…</source>
        <translation>スケルトンを選択…</translation>
    </message>
    <message>
        <source>&amp;Compare with Original…</source>
        <translation>元と比較(&amp;C)…</translation>
    </message>
    <message>
        <source>Save the compressed clip as .mcpr</source>
        <translation>圧縮クリップを .mcpr として保存</translation>
    </message>
    <message>
        <source>A&amp;dd Clips to Library…</source>
        <translation>クリップを追加(&amp;D)…</translation>
    </message>
    <message>
        <source>&amp;New Project</source>
        <translation>新規プロジェクト(&amp;N)</translation>
    </message>
    <message>
        <source>Open Pro&amp;ject…</source>
        <translation>プロジェクトを開く(&amp;J)…</translation>
    </message>
    <message>
        <source>Sa&amp;ve Project As…</source>
        <translation>プロジェクトを保存(&amp;V)…</translation>
    </message>
    <message>
        <source>Switch between &amp;A and B</source>
        <translation>AとBを切り替え(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Copy Settings to the Other</source>
        <translation>設定をもう一方へコピー(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>終了(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>元に戻す(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>やり直す(&amp;R)</translation>
    </message>
    <message>
        <source>Next &amp;Worst Frame</source>
        <translation>次に悪いフレーム(&amp;W)</translation>
    </message>
    <message>
        <source>Go to the frame with the largest error, then to the next largest (N)</source>
        <translation>誤差が最大のフレームへ、もう一度で次に悪いフレームへ (N)</translation>
    </message>
    <message>
        <source>P&amp;revious Worst Frame</source>
        <translation>前の悪いフレーム(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Hold Feet</source>
        <translation>足を固定(&amp;H)</translation>
    </message>
    <message>
        <source>Compress with or without inverse kinematics (I)</source>
        <translation>逆運動学の有無を切り替えて圧縮 (I)</translation>
    </message>
    <message>
        <source>Without I&amp;K</source>
        <translation>IKなし(&amp;K)</translation>
    </message>
    <message>
        <source>Show the compressed figure without the IK correction of its feet (B)</source>
        <translation>足を固定する前の圧縮後の人形を見る (B)</translation>
    </message>
    <message>
        <source>Reset La&amp;yout</source>
        <translation>配置をリセット(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;Study…</source>
        <translation>比較研究(&amp;S)…</translation>
    </message>
    <message>
        <source>Compare the file sizes and errors of methods on many clips</source>
        <translation>多くのクリップで手法を比較：サイズと誤差</translation>
    </message>
    <message>
        <source>&amp;Guide</source>
        <translation>ガイド(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Keyboard Shortcuts</source>
        <translation>キーボードショートカット(&amp;K)</translation>
    </message>
    <message>
        <source>Like the &amp;System</source>
        <translation>システムに従う(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>ライト(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>ダーク(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;About Mocapress</source>
        <translation>Mocapressについて(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>ファイル(&amp;F)</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>最近使ったファイル(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>編集(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>再生(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>表示(&amp;V)</translation>
    </message>
    <message>
        <source>The&amp;me</source>
        <translation>テーマ(&amp;M)</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>言語(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>ツール(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Batch Export…</source>
        <translation>一括書き出し(&amp;B)…</translation>
    </message>
    <message>
        <source>Compress many clips, verify each of them and write a report</source>
        <translation>多数のクリップを圧縮し、一つずつ検証して、全体を報告します</translation>
    </message>
    <message>
        <source>Batch Export of the &amp;Library…</source>
        <translation>ライブラリを一括書き出し(&amp;L)…</translation>
    </message>
    <message>
        <source>Export all clips of the library, each with its own settings</source>
        <translation>ライブラリのすべてのクリップを、それぞれの設定で書き出します</translation>
    </message>
    <message>
        <source>Add &amp;Folder to Library…</source>
        <translation>ライブラリにフォルダーを追加(&amp;F)…</translation>
    </message>
    <message>
        <source>&amp;Pin This Result</source>
        <translation>この結果をピン留め(&amp;P)</translation>
    </message>
    <message>
        <source>Keep this result in the view beside results of other settings (D)</source>
        <translation>この結果をほかの設定の結果と並べて表示し続けます (D)</translation>
    </message>
    <message>
        <source>Error S&amp;cale</source>
        <translation>誤差の尺度(&amp;C)</translation>
    </message>
    <message>
        <source>Recent Projec&amp;ts</source>
        <translation>最近のプロジェクト(&amp;T)</translation>
    </message>
    <message>
        <source>Save as .mcpr, .bvh, .fbx, .glb, .amc with its .asf, or .csv</source>
        <translation>.mcpr、.bvh、.fbx、.glb、.amc（.asf 付き）または .csv として保存します</translation>
    </message>
    <message>
        <source>E&amp;xport Motion…</source>
        <translation>モーションを書き出す(&amp;X)…</translation>
    </message>
    <message>
        <source>Write the decompressed motion with the unit, axes and rate of its source</source>
        <translation>圧縮クリップから得られるモーションを、元ファイルと同じ形式の取り決めで書き出します</translation>
    </message>
    <message>
        <source>Export Review Pa&amp;ge…</source>
        <translation>レビューページを書き出す(&amp;G)…</translation>
    </message>
    <message>
        <source>Write a web page that shows original and compressed clip</source>
        <translation>元のクリップと圧縮クリップをブラウザーで見るページを書き出します</translation>
    </message>
    <message>
        <source>&amp;Import Options…</source>
        <translation>読み込みオプション(&amp;I)…</translation>
    </message>
    <message>
        <source>Read the open motion again with another length unit, up axis, frame rate or root convention</source>
        <translation>開いているモーションを、別の単位・上方向の軸・フレームレート・ルートの扱いで読み直します</translation>
    </message>
    <message>
        <source>Put a C&amp;haracter on It…</source>
        <translation>キャラクターを適用(&amp;H)…</translation>
    </message>
    <message>
        <source>Show the clip, and all clips with the same rig, on the mesh of an FBX or glTF whose joints have the same names</source>
        <translation>このクリップと、同じリグのすべてのクリップを、同じ名前の関節を持つ FBX または glTF のスキンで表示します</translation>
    </message>
    <message>
        <source>Ta&amp;ke Its Character Off</source>
        <translation>キャラクターを外す(&amp;K)</translation>
    </message>
    <message>
        <source>Show the clip, and all clips with the same rig, as in their files</source>
        <translation>このクリップと、同じリグのすべてのクリップを、それぞれのファイルのとおりに表示します</translation>
    </message>
    <message>
        <source>Angle Scale</source>
        <translation>角度の尺度</translation>
    </message>
    <message>
        <source>Colours and S&amp;cales</source>
        <translation>色と尺度(&amp;C)</translation>
    </message>
    <message>
        <source>Pane&amp;ls</source>
        <translation>パネル(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Save Compressed Clip</source>
        <translation>圧縮クリップを保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save Compressed Clip &amp;As…</source>
        <translation>圧縮クリップに名前を付けて保存(&amp;A)…</translation>
    </message>
    <message>
        <source>Next to &amp;Review</source>
        <translation>次のレビュー対象(&amp;R)</translation>
    </message>
    <message>
        <source>Open the next clip that waits for a verdict (Q)</source>
        <translation>判定待ちの次のクリップを開きます（Q）</translation>
    </message>
    <message>
        <source>&amp;Approve, and Next</source>
        <translation>承認して次へ(&amp;A)</translation>
    </message>
    <message>
        <source>Re&amp;ject, and Next</source>
        <translation>却下して次へ(&amp;J)</translation>
    </message>
    <message>
        <source>&amp;Note on This Frame…</source>
        <translation>このフレームにメモ(&amp;N)…</translation>
    </message>
    <message>
        <source>Next No&amp;te</source>
        <translation>次のメモ(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Review</source>
        <translation>レビュー(&amp;R)</translation>
    </message>
    <message>
        <source>Ex&amp;port Sign-off…</source>
        <translation>承認レポートを書き出す(&amp;P)…</translation>
    </message>
    <message>
        <source>Write verdicts, worst frames and notes of the library as HTML, PDF or CSV</source>
        <translation>ライブラリの判定、最悪のフレーム、メモを HTML、PDF、CSV に書き出す</translation>
    </message>
    <message>
        <source>Write a note on the frame that is shown and the joint that is chosen. A click with Ctrl in the picture writes one on a place there.</source>
        <translation>表示中のフレームと選択中の関節にメモを書く。画面を Ctrl を押しながらクリックすると、その場所に書きます。</translation>
    </message>
    <message>
        <source>&amp;Write Notes beside the Clips</source>
        <translation>メモをクリップの横に書き出す(&amp;W)</translation>
    </message>
    <message>
        <source>Write the notes of each clip to NAME.notes.json in its folder</source>
        <translation>各クリップのメモを同じフォルダーの NAME.notes.json に書き出す</translation>
    </message>
    <message>
        <source>Rea&amp;d Notes beside the Clips</source>
        <translation>クリップの横のメモを読み込む(&amp;D)</translation>
    </message>
    <message>
        <source>Add notes from the files NAME.notes.json beside the clips</source>
        <translation>クリップの横の NAME.notes.json からメモを追加する</translation>
    </message>
    <message>
        <source>Copy &amp;Link to This Frame</source>
        <translation>このフレームへのリンクをコピー(&amp;L)</translation>
    </message>
    <message>
        <source>Copy a link that opens this clip, frame, joint and view</source>
        <translation>このクリップ、フレーム、関節、視点を開くリンクをコピーする</translation>
    </message>
    <message>
        <source>&amp;Blind Test…</source>
        <translation>ブラインドテスト(&amp;B)…</translation>
    </message>
    <message>
        <source>Find out from which error on you tell the compressed clip from the original</source>
        <translation>どの誤差から圧縮クリップと元を見分けられるかを調べます</translation>
    </message>
    <message>
        <source>Copy Pict&amp;ure of the View</source>
        <translation>ビューの画像をコピー(&amp;U)</translation>
    </message>
    <message>
        <source>Save Picture of the &amp;View…</source>
        <translation>ビューの画像を保存(&amp;V)…</translation>
    </message>
    <message>
        <source>&amp;Film of the Range…</source>
        <translation>範囲の動画(&amp;F)…</translation>
    </message>
    <message>
        <source>Write the chosen range, or the clip, as a video or as numbered pictures</source>
        <translation>選択した範囲（なければクリップ全体）を動画または連番画像として書き出します</translation>
    </message>
    <message>
        <source>&amp;Turntable…</source>
        <translation>ターンテーブル(&amp;T)…</translation>
    </message>
    <message>
        <source>Write this frame from all sides as a video or as numbered pictures</source>
        <translation>このフレームを全方向から見た動画または連番画像として書き出します</translation>
    </message>
    <message>
        <source>&amp;Find a Command…</source>
        <translation>コマンドを検索(&amp;F)…</translation>
    </message>
    <message>
        <source>Keyboard &amp;Map…</source>
        <translation>キー割り当て(&amp;M)…</translation>
    </message>
    <message>
        <source>Choose the keys of all commands</source>
        <translation>すべてのコマンドのキーを選びます</translation>
    </message>
    <message>
        <source>Pict&amp;ures and Films</source>
        <translation>画像と動画(&amp;U)</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>タイムライン</translation>
    </message>
    <message>
        <source>Pin What an &amp;Engine Would Do</source>
        <translation>エンジンの場合をピン留め(&amp;E)</translation>
    </message>
    <message>
        <source>Compress the clip track by track, with key frames, to the same number of bytes, and show it beside this result</source>
        <translation>クリップをトラックごとにキーフレームで同じバイト数に圧縮し、この結果と並べて表示します</translation>
    </message>
    <message>
        <source>Fold Panels Below</source>
        <translation>下のパネルを折りたたむ</translation>
    </message>
    <message>
        <source>Fold the panels below the timeline to their tabs, or unfold them</source>
        <translation>タイムラインの下のパネルをタブだけに折りたたむ、または開く</translation>
    </message>
    <message>
        <source>Compare in the Ran&amp;ge</source>
        <translation>範囲内で比較(&amp;G)</translation>
    </message>
    <message>
        <source>Loop the chosen range with both figures side by side, and show its errors alone</source>
        <translation>選んだ範囲を2体並べて繰り返し再生し、その誤差だけを表示します</translation>
    </message>
    <message>
        <source>Co&amp;mpare Library with a Batch…</source>
        <translation>ライブラリを一括処理と比較(&amp;M)…</translation>
    </message>
    <message>
        <source>Show what got larger, worse or newly visible since an earlier batch or project</source>
        <translation>以前の一括処理やプロジェクトから増大・悪化したもの、新たに見えるものを表示します</translation>
    </message>
    <message>
        <source>Note on the Ran&amp;ge…</source>
        <translation>範囲にメモ(&amp;G)…</translation>
    </message>
    <message>
        <source>Write a note on the chosen range and the joint that is chosen</source>
        <translation>選択中の範囲と関節にメモを書きます</translation>
    </message>
</context>
<context>
    <name>mocapress::AnnealingPanel</name>
    <message>
        <source>Cancel</source>
        <translation>中止</translation>
    </message>
    <message>
        <source>Progress of the refinement</source>
        <translation>仕上げの進み具合</translation>
    </message>
    <message>
        <source>Stop refining. The best result so far is kept if it is better than the draft.</source>
        <translation>仕上げを止めます。下書きより良ければ、それまでの最良の結果を残します。</translation>
    </message>
    <message>
        <source>%L1 s left</source>
        <translation>残り %L1 秒</translation>
    </message>
    <message>
        <source>%L1 min left</source>
        <translation>残り %L1 分</translation>
    </message>
    <message>
        <source>Progress of refining the draft. Annealing moves fewer and fewer coefficients at a time; the closed loop sweeps over all coefficients until no change helps. Most targets need several passes, whose number is an estimate.</source>
        <translation>下書きを仕上げます：焼きなましは一度に動かす係数を減らしていき、閉ループは全係数を巡り、改善がなくなるまで続けます。多くの目標は数回の処理を要し、その回数は最後まで推定です。</translation>
    </message>
    <message>
        <source>Time left</source>
        <translation>残り時間</translation>
    </message>
</context>
<context>
    <name>mocapress::BatchOutput</name>
    <message>
        <source>Replace existing files</source>
        <translation>既存のファイルを置き換える</translation>
    </message>
    <message>
        <source>Pattern of file names</source>
        <translation>名前の型</translation>
    </message>
    <message>
        <source>If this is off, a clip fails when its file exists and is not from this batch. A file is replaced only after the new one was read back and measured.</source>
        <translation>そうでなければ、この一括処理のものではないファイルが既にあるクリップは失敗し、その旨を示します。いずれの場合も、新しいファイルを読み戻して測定した後にだけ置き換えます。</translation>
    </message>
    <message>
        <source>Compressed (.mcpr)</source>
        <translation>圧縮ファイル (.mcpr)</translation>
    </message>
    <message>
        <source>The compressed file, to be shipped.</source>
        <translation>出荷するもの。</translation>
    </message>
    <message>
        <source>BVH</source>
        <translation>BVH</translation>
    </message>
    <message>
        <source>The decompressed motion.</source>
        <translation>展開したモーション。</translation>
    </message>
    <message>
        <source>ASF/AMC</source>
        <translation>ASF/AMC</translation>
    </message>
    <message>
        <source>The decompressed motion and its skeleton.</source>
        <translation>展開したモーションとそのスケルトン。</translation>
    </message>
    <message>
        <source>CSV</source>
        <translation>CSV</translation>
    </message>
    <message>
        <source>The decompressed channels as a table.</source>
        <translation>展開したチャンネルの表。</translation>
    </message>
    <message>
        <source>FBX</source>
        <translation>FBX</translation>
    </message>
    <message>
        <source>The decompressed motion on its skeleton, for Maya, MotionBuilder and engines.</source>
        <translation>展開したモーションとスケルトン。Maya、MotionBuilder、エンジン向け。</translation>
    </message>
    <message>
        <source>glTF (.glb)</source>
        <translation>glTF (.glb)</translation>
    </message>
    <message>
        <source>The decompressed motion on its skeleton, for Blender and engines.</source>
        <translation>展開したモーションとスケルトン。Blender やゲームエンジン用。</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>フォルダー</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選択…</translation>
    </message>
    <message>
        <source>Folder of the batch: %1</source>
        <translation>一括処理のフォルダー: %1</translation>
    </message>
    <message>
        <source>Folder for files and report. If it holds a batch, that batch is resumed.</source>
        <translation>ファイルと報告の書き出し先。一括処理の残るフォルダーでは続きから始めます。</translation>
    </message>
    <message>
        <source>&lt;p&gt;{folder}: the folder that was added, and its subfolders down to the clip&lt;br&gt;{stem}: the clip&apos;s name&lt;br&gt;{type}: the source&apos;s format, such as bvh&lt;br&gt;{preset}, {method}: the preset and method of the clip&lt;/p&gt;</source>
        <translation>&lt;p&gt;{folder}: クリップが見つかったフォルダーとその間のフォルダー&lt;br&gt;{stem}: クリップの名前&lt;br&gt;{type}: 元のファイルの形式（bvh など）&lt;br&gt;{preset}、{method}: 圧縮に使うもの&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Bank of all clips</source>
        <translation>すべてのクリップのバンク</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Packed</source>
        <translation>圧縮</translation>
    </message>
    <message>
        <source>Cooked</source>
        <translation>展開済み</translation>
    </message>
    <message>
        <source>&lt;p&gt;One more file, bank.mcpk, with all compressed clips.&lt;br&gt;Packed: the smallest, for shipping.&lt;br&gt;Cooked: engines sample its clips without unpacking them.&lt;/p&gt;</source>
        <translation>&lt;p&gt;すべての圧縮ファイルを、その横の bank.mcpk 一つにまとめます。&lt;br&gt;圧縮: 最も小さく、配布用です。&lt;br&gt;展開済み: エンジンがそのまま読み出せます。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Bank</source>
        <translation>バンク</translation>
    </message>
    <message>
        <source>Fit the coder to the clips</source>
        <translation>クリップから学習する</translation>
    </message>
    <message>
        <source>Fits the statistics of the coder to the clips of a packed bank. This takes up to a minute and saves 1 to 2 % of the bytes of some hundred clips. A bank of a few clips is not changed.</source>
        <translation>圧縮バンクの動きを、クリップどうしから学んだことで符号化します。数百クリップあれば 1～2 % 小さくなりますが、最長で 1 分ほど長くかかります。少数のクリップからは何も学べず、バンクは変わりません。</translation>
    </message>
</context>
<context>
    <name>mocapress::BatchQueueModel</name>
    <message>
        <source>Reading</source>
        <translation>読み込み中</translation>
    </message>
    <message>
        <source>Compressing</source>
        <translation>圧縮中</translation>
    </message>
    <message>
        <source>Verifying</source>
        <translation>検証中</translation>
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
        <translation>最大 %1 cm</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>待機中</translation>
    </message>
    <message>
        <source>%1, %L2 %</source>
        <translation>%1、%L2 %</translation>
    </message>
    <message>
        <source>✓ Verified</source>
        <translation>✓ 検証済み</translation>
    </message>
    <message>
        <source>✗ %1</source>
        <translation>✗ %1</translation>
    </message>
    <message>
        <source>Locked: the clip keeps its own settings. Click to give it the settings shared by all clips.</source>
        <translation>ロック中: 独自の設定を保ちます。クリックすると共通の設定に戻します。</translation>
    </message>
    <message>
        <source>Click to lock the clip&apos;s settings, so that changes for all clips do not apply to it.</source>
        <translation>クリックすると設定をロックします: 全クリップへの変更の影響を受けません。</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>ロック中</translation>
    </message>
    <message>
        <source>not locked</source>
        <translation>ロックなし</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>クリップ</translation>
    </message>
    <message>
        <source>Locked clips keep their own settings.</source>
        <translation>ロックしたクリップは独自の設定を保ちます。</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>The preset and its target.</source>
        <translation>プリセットとその目標。</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>Verified: the file was read back, decoded and measured.</source>
        <translation>検証済み: ファイルを読み戻し、復号して測定しました。</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>圧縮率</translation>
    </message>
    <message>
        <source>Bytes of the channels as 32-bit floats, divided by compressed bytes.</source>
        <translation>32 ビット浮動小数点のチャンネルのバイト数を圧縮後のバイト数で割ったもの。</translation>
    </message>
    <message>
        <source>eps_x cm</source>
        <translation>eps_x cm</translation>
    </message>
    <message>
        <source>Weighted root mean square error.</source>
        <translation>重み付き二乗平均平方根誤差。</translation>
    </message>
    <message>
        <source>Max cm</source>
        <translation>最大 cm</translation>
    </message>
    <message>
        <source>Largest error of any point at any frame.</source>
        <translation>全フレーム・全点での最大誤差。</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>除外</translation>
    </message>
    <message numerus="yes">
        <source>✓ Verified, %Ln warning(s)</source>
        <translation>
            <numerusform>✓ 検証済み、警告 %Ln 件</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>The clip is not exported. Tick it to export it too.</source>
        <translation>書き出されません。書き出すにはクリップにチェックを入れてください。</translation>
    </message>
    <message>
        <source>Only ticked clips are exported.</source>
        <translation>チェックを入れたクリップだけが書き出されます。</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>not visible</source>
        <translation>見えない</translation>
    </message>
    <message>
        <source>%1 times the noticeable error</source>
        <translation>知覚限界の %1 倍</translation>
    </message>
    <message>
        <source>The clip&apos;s verdict in the library. Rejected clips are exported only if they are ticked. A verdict is stale if files or settings have changed since.</source>
        <translation>ライブラリでのクリップの判定です。却下したクリップは、チェックを入れるまで除かれます。無効：このファイルと設定についての判定ではありません。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln care range(s)</source>
        <translation>
            <numerusform>重視 %Ln 範囲</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mocapress::BatchQueueView</name>
    <message>
        <source>Clips of the batch</source>
        <translation>一括処理のクリップ</translation>
    </message>
    <message>
        <source>Remove from Queue</source>
        <translation>キューから外す</translation>
    </message>
    <message>
        <source>Drop clips or folders of clips here</source>
        <translation>クリップまたはクリップのフォルダーをここにドロップ</translation>
    </message>
    <message>
        <source>The .asf beside an .amc is found</source>
        <translation>.amc は隣の .asf を使います</translation>
    </message>
    <message>
        <source>Leave Out</source>
        <translation>除外する</translation>
    </message>
    <message>
        <source>Export Too</source>
        <translation>これも書き出す</translation>
    </message>
</context>
<context>
    <name>mocapress::BatchSession</name>
    <message>
        <source>Add clips to begin.</source>
        <translation>クリップを追加して始めます。</translation>
    </message>
    <message>
        <source>Choose a folder for the files.</source>
        <translation>書き出し先のフォルダーを選んでください。</translation>
    </message>
    <message>
        <source>Choose at least one file format.</source>
        <translation>ファイルの種類を一つ以上選んでください。</translation>
    </message>
    <message>
        <source>Wrote %1: submit it with sbatch.</source>
        <translation>%1 を書き出しました: sbatch で投入してください。</translation>
    </message>
    <message>
        <source>Clips can be added after the batch has ended.</source>
        <translation>クリップの追加は、一括処理が終わってからできます。</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>出力</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Remove Clips</source>
        <translation>クリップを外す</translation>
    </message>
    <message>
        <source>Add Clips</source>
        <translation>クリップを追加</translation>
    </message>
    <message>
        <source>Leave Out Clips</source>
        <translation>クリップの除外</translation>
    </message>
    <message>
        <source>Export Clips Too</source>
        <translation>除外したクリップも書き出す</translation>
    </message>
    <message>
        <source>Every clip is left out. Tick the clips to export.</source>
        <translation>すべてのクリップが除外されています。書き出すものにチェックを入れてください。</translation>
    </message>
    <message>
        <source>A bank needs compressed files: choose Compressed (.mcpr) too.</source>
        <translation>バンクは圧縮ファイルから作ります。圧縮ファイルも選んでください。</translation>
    </message>
    <message>
        <source>A cluster&apos;s tasks cannot make a bank, since none has all clips: set Bank to None to write a script.</source>
        <translation>どのタスクもバンクの全クリップを持ちません。スクリプトを書くには「なし」を選んでください。</translation>
    </message>
    <message>
        <source>Character</source>
        <translation>キャラクター</translation>
    </message>
</context>
<context>
    <name>mocapress::BatchStatus</name>
    <message numerus="yes">
        <source>, %Ln failed</source>
        <translation>
            <numerusform>、失敗 %Ln</numerusform>
        </translation>
    </message>
    <message>
        <source>%L1 of %L2</source>
        <translation>%L1 / %L2</translation>
    </message>
    <message>
        <source>%1, about %2 left</source>
        <translation>%1、残り約 %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln clip(s) to export</source>
        <translation>
            <numerusform>書き出すクリップ %Ln</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln clip(s) exported and verified</source>
        <translation>
            <numerusform>%Ln クリップを書き出し検証しました</numerusform>
        </translation>
    </message>
    <message>
        <source>Paused at %1</source>
        <translation>%1 で一時停止中</translation>
    </message>
    <message>
        <source>Stopping after the current clips: %1</source>
        <translation>処理中のクリップの後で停止します: %1</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>中止しています…</translation>
    </message>
    <message>
        <source>Stopped at %1; the next start continues from there</source>
        <translation>%1 で停止。続きから再開します</translation>
    </message>
    <message>
        <source>&amp;Go On</source>
        <translation>再開(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>一時停止(&amp;P)</translation>
    </message>
    <message numerus="yes">
        <source>&amp;Retry %Ln Failed</source>
        <translation>
            <numerusform>失敗した %Ln 件を再試行(&amp;R)</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>書き出し(&amp;E)</translation>
    </message>
    <message numerus="yes">
        <source>, %Ln left out</source>
        <translation>
            <numerusform>、除外 %Ln 件</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %Ln with warnings</source>
        <translation>
            <numerusform>、うち警告あり %Ln 件</numerusform>
        </translation>
    </message>
    <message>
        <source>Waiting for another program that is changing the bank…</source>
        <translation>待機中: 別のプログラムがバンクを変更しています…</translation>
    </message>
    <message>
        <source>Fitting the coder to the clips of the bank…</source>
        <translation>バンクのためにクリップから学習しています…</translation>
    </message>
    <message>
        <source>Making the bank: %L1 of %L2</source>
        <translation>バンクを作成しています: %L1 / %L2</translation>
    </message>
    <message numerus="yes">
        <source>, %Ln with a stale verdict</source>
        <translation>
            <numerusform>、判定が無効 %Ln 個</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mocapress::BatchWindow</name>
    <message>
        <source>Use Shared Settings for Selection</source>
        <translation>共通の設定に戻す</translation>
    </message>
    <message>
        <source>&amp;Stop after Current</source>
        <translation>現在の後で停止(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>中止(&amp;C)</translation>
    </message>
    <message>
        <source>Slurm Script…</source>
        <translation>Slurm スクリプト…</translation>
    </message>
    <message>
        <source>Batch Export</source>
        <translation>一括書き出し</translation>
    </message>
    <message>
        <source>Add &amp;Files…</source>
        <translation>ファイルを追加(&amp;F)…</translation>
    </message>
    <message>
        <source>Add motions</source>
        <translation>モーションを追加</translation>
    </message>
    <message>
        <source>Add Fol&amp;der…</source>
        <translation>フォルダーを追加(&amp;D)…</translation>
    </message>
    <message>
        <source>Add every motion below a folder</source>
        <translation>フォルダー以下のすべてのモーションを追加</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>出力</translation>
    </message>
    <message>
        <source>Progress of the batch</source>
        <translation>一括処理の進み具合</translation>
    </message>
    <message>
        <source>Compress each clip, read the file back, measure it and put it in place. Finished clips that have not changed are kept.</source>
        <translation>圧縮し、読み戻し、測定して配置します。済んでいて変更のないものはそのまま残します。</translation>
    </message>
    <message>
        <source>Finish the clips in progress and start no others</source>
        <translation>処理中のクリップを終え、新しいものは始めません</translation>
    </message>
    <message>
        <source>Stop the clips in progress and put them back in the queue</source>
        <translation>処理中のクリップをやめます: 待機に戻ります</translation>
    </message>
    <message>
        <source>Open a page with the measurements of every clip and pictures of the worst frames</source>
        <translation>全クリップの数値と、最悪フレームの図</translation>
    </message>
    <message>
        <source>Write a script for Slurm&apos;s sbatch that compresses this queue on a cluster</source>
        <translation>このキューをクラスターで処理: sbatch 用スクリプト</translation>
    </message>
    <message>
        <source>Add Clips</source>
        <translation>クリップの追加</translation>
    </message>
    <message>
        <source>Motion (%1)</source>
        <translation>モーション (%1)</translation>
    </message>
    <message>
        <source>Add All Clips below</source>
        <translation>以下のすべてのクリップを追加</translation>
    </message>
    <message>
        <source>Folder of the Batch</source>
        <translation>一括処理のフォルダー</translation>
    </message>
    <message>
        <source>Slurm Script</source>
        <translation>Slurm スクリプト</translation>
    </message>
    <message>
        <source>Tasks of the job array</source>
        <translation>ジョブ配列のタスク数</translation>
    </message>
    <message>
        <source>Shell scripts (*.sh)</source>
        <translation>シェルスクリプト (*.sh)</translation>
    </message>
    <message>
        <source>Settings of all clips</source>
        <translation>全クリップの設定</translation>
    </message>
    <message numerus="yes">
        <source>Settings of %Ln selected clip(s)</source>
        <translation>
            <numerusform>選択した %Ln クリップの設定</numerusform>
        </translation>
    </message>
    <message>
        <source>Changes made while clips are selected apply to these clips only, and lock them.</source>
        <translation>クリップを選択中の変更はそれらだけのもので、ロックします。</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直す</translation>
    </message>
    <message>
        <source>Open Rep&amp;ort</source>
        <translation>報告を開く(&amp;O)</translation>
    </message>
    <message>
        <source>Character on all clips</source>
        <translation>すべてのクリップのキャラクター</translation>
    </message>
    <message>
        <source>Character on All Clips</source>
        <translation>すべてのクリップのキャラクター</translation>
    </message>
    <message>
        <source>Report: %1</source>
        <translation>報告：%1</translation>
    </message>
</context>
<context>
    <name>mocapress::BlindTestWindow</name>
    <message>
        <source>Blind Test</source>
        <translation>ブラインドテスト</translation>
    </message>
    <message>
        <source>Viewer</source>
        <translation>見る人</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Viewing distance</source>
        <translation>視距離</translation>
    </message>
    <message>
        <source>Distance at which a person would look as tall as the figure does on your screen</source>
        <translation>画面上の人物と同じ大きさに人が見える距離</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>質問の数</translation>
    </message>
    <message>
        <source>Show A, X and B side by side</source>
        <translation>A、X、B を並べて表示</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Compressing the clip at %m levels: %v</source>
        <translation>%m 段階でクリップを圧縮中：%v</translation>
    </message>
    <message>
        <source>1: A, the original    2: X    3: B, compressed        ←: X is A    →: X is B        Esc: stop</source>
        <translation>1：A（元）    2：X    3：B（圧縮）        ←：X は A    →：X は B        Esc：中止</translation>
    </message>
    <message>
        <source>Use as Limits</source>
        <translation>限界値として使う</translation>
    </message>
    <message>
        <source>Judge visibility by your own threshold from now on; other cues keep their limits</source>
        <translation>今後は自分の閾値で見え方を判定します。ほかの手がかりの限界値は変わりません</translation>
    </message>
    <message>
        <source>Another Test</source>
        <translation>もう一度テスト</translation>
    </message>
    <message>
        <source>In Use</source>
        <translation>使用中</translation>
    </message>
    <message>
        <source>A is the original of %1, B the same clip compressed, more or less visibly. X is one of the two: say which. The test finds the smallest error that you notice, in about five minutes. Nobody is told whether an answer was right.</source>
        <translation>A は %1 の元、B は同じクリップを圧縮したもので、違いの見えやすさはさまざまです。X はそのどちらかです。どちらかを答えてください。約 5 分で、気づく最小の誤差がわかります。答えが正しいかどうかは表示されません。</translation>
    </message>
    <message>
        <source>Open a motion and compress it by the closed loop: the test takes the open clip.</source>
        <translation>モーションを開いて閉ループで圧縮してください。テストは開いているクリップで行います。</translation>
    </message>
    <message>
        <source>This clip cannot be compressed at enough levels for a test.</source>
        <translation>このクリップはテストに十分な段階で圧縮できません。</translation>
    </message>
    <message>
        <source>Question %L1 of %L2: is X the original or the compressed one?</source>
        <translation>質問 %L1 / %L2：X は元ですか、圧縮されたものですか？</translation>
    </message>
    <message>
        <source>%L1 of %L2 answers were right. Somebody who guesses has as many with a probability of %L3.</source>
        <translation>%L2 問中 %L1 問が正解です。当て推量でこれだけ当たる確率は %L3 です。</translation>
    </message>
    <message>
        <source>You notice errors from %L1 times what the limits say (95 % interval: %L2 to %L3). Most were seen as: %4, from %L5 m.</source>
        <translation>限界値の %L1 倍から誤差に気づきます（95 % 区間：%L2 ～ %L3）。主な手がかりは%4、距離 %L5 m です。</translation>
    </message>
    <message>
        <source>The answers do not tell a threshold: they are too few, or it lies outside of the levels.</source>
        <translation>答えから閾値がわかりません。答えが少なすぎるか、閾値が段階の外にあります。</translation>
    </message>
    <message>
        <source>Kept in %1.</source>
        <translation>%1 に保存しました。</translation>
    </message>
    <message>
        <source>Use Built-in Limits</source>
        <translation>組み込みの限界値を使う</translation>
    </message>
    <message>
        <source>Judge visibility as before any test</source>
        <translation>テスト前と同じ限界値で見え方を判定します</translation>
    </message>
    <message>
        <source>Visibility is judged by %1.</source>
        <translation>見え方は%1で判定されます。</translation>
    </message>
</context>
<context>
    <name>mocapress::ByteCostModel</name>
    <message>
        <source>Skeleton</source>
        <translation>スケルトン</translation>
    </message>
    <message>
        <source>Description of the clip</source>
        <translation>クリップの記述</translation>
    </message>
    <message>
        <source>Table of segments</source>
        <translation>区間の表</translation>
    </message>
    <message>
        <source>Chains of the IK correction</source>
        <translation>IK 補正のチェーン</translation>
    </message>
    <message>
        <source>First and last pose</source>
        <translation>最初と最後のポーズ</translation>
    </message>
    <message>
        <source>Turned axes</source>
        <translation>回転した軸</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>トラック</translation>
    </message>
    <message>
        <source>Rounding of the coder</source>
        <translation>符号化の丸め</translation>
    </message>
    <message>
        <source>Motion (cannot be divided)</source>
        <translation>モーション（分割できません）</translation>
    </message>
    <message>
        <source>Frame of the file</source>
        <translation>ファイルの枠</translation>
    </message>
    <message>
        <source>%L1 %</source>
        <translation>%L1 %</translation>
    </message>
    <message>
        <source>Bytes of the file that code this joint, as the decoder counts them. Rows in italics belong to no joint.</source>
        <translation>この関節を符号化するファイルのバイト数（デコーダーの計算による）。斜体の行はどの関節にも属しません。</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>関節</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>バイト</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>割合</translation>
    </message>
</context>
<context>
    <name>mocapress::ByteStrip</name>
    <message>
        <source>Bytes over time</source>
        <translation>時間ごとのバイト数</translation>
    </message>
    <message>
        <source>Compressed bytes over time. The table of bytes has them by joint.</source>
        <translation>時間ごとの圧縮バイト数。関節ごとの値はバイトの表にあります。</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>バイト</translation>
    </message>
    <message>
        <source>Compressed bytes over time, on a scale of the dearest moment.</source>
        <translation>時間ごとの圧縮バイト数（最も多い時点を基準に表示）。</translation>
    </message>
    <message>
        <source>Frames from %L1: %L2 bytes, most of them for %3 (%L4)</source>
        <translation>フレーム %L1 から：%L2 バイト、最多は %3（%L4）</translation>
    </message>
</context>
<context>
    <name>mocapress::ByteView</name>
    <message>
        <source>%1: error × 2</source>
        <translation>%1: 誤差 × 2</translation>
    </message>
    <message>
        <source>10 % more bytes</source>
        <translation>バイト数を 10 % 増やす</translation>
    </message>
    <message>
        <source>10 % fewer bytes</source>
        <translation>バイト数を 10 % 減らす</translation>
    </message>
</context>
<context>
    <name>mocapress::BytesPanel</name>
    <message>
        <source>Bytes by joint</source>
        <translation>関節ごとのバイト数</translation>
    </message>
    <message>
        <source>Other settings, tried</source>
        <translation>試したほかの設定</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>変更</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>バイト</translation>
    </message>
    <message>
        <source>Its error</source>
        <translation>その誤差</translation>
    </message>
    <message>
        <source>See what it saves to be less exact in one place, or what more bytes bring. Each line is a real encode.</source>
        <translation>ある部分の精度を下げると何バイト減るか、バイト数を増やすと何が良くなるかを調べます。各行は実際の圧縮結果です。</translation>
    </message>
    <message>
        <source>Try Other Settings</source>
        <translation>ほかの設定を試す</translation>
    </message>
    <message>
        <source>Use These</source>
        <translation>これを使う</translation>
    </message>
    <message>
        <source>Compress with the settings of the chosen line; can be undone</source>
        <translation>選んだ行の設定で圧縮します（取り消し可能）</translation>
    </message>
    <message>
        <source>%L1 → %L2 mm</source>
        <translation>%L1 → %L2 mm</translation>
    </message>
    <message>
        <source>Trying…</source>
        <translation>試しています…</translation>
    </message>
</context>
<context>
    <name>mocapress::ChannelGraph</name>
    <message>
        <source>Channel</source>
        <translation>チャンネル</translation>
    </message>
    <message>
        <source>One degree of freedom of the selected joint.</source>
        <translation>選んだ関節の自由度のひとつ。</translation>
    </message>
    <message>
        <source>Channel over time</source>
        <translation>チャンネルの時間変化</translation>
    </message>
    <message>
        <source>The recorded and the compressed channel; below, their difference. Click to go to a frame.</source>
        <translation>記録時と圧縮後のチャンネル、下はその差。クリックで移動。</translation>
    </message>
    <message>
        <source>Kept coefficients by scale</source>
        <translation>スケール別の残した係数</translation>
    </message>
    <message>
        <source>Share of this channel&apos;s wavelet coefficients that are kept, from the coarsest scale to the finest.</source>
        <translation>このチャンネルのウェーブレット係数のうち残したもの。粗いスケールから細かいスケールへ。圧縮は効くものだけを残します。</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>時間 (s)</translation>
    </message>
    <message>
        <source>Scale (finer →)</source>
        <translation>スケール(細かい →)</translation>
    </message>
    <message>
        <source>Kept (%)</source>
        <translation>残存率 (%)</translation>
    </message>
    <message>
        <source>The selected joint has no motion of its own.</source>
        <translation>選んだ関節は自分では動きません。</translation>
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
        <translation>キャラクターを外す</translation>
    </message>
    <message>
        <source>Remove the character; clips with a mesh of their own use that</source>
        <translation>キャラクターを外す：各クリップは、あればそれ自身のメッシュを使います</translation>
    </message>
    <message>
        <source>Own mesh of each clip</source>
        <translation>クリップごとのもの</translation>
    </message>
    <message>
        <source>Character on all clips: %1</source>
        <translation>すべてのクリップのキャラクター：%1</translation>
    </message>
    <message>
        <source>Character (FBX or glTF) for every clip whose joints it fits. Errors are measured on its mesh, and the weighting Skin uses it. Other clips are unchanged, and the report lists them.</source>
        <translation>合うクリップすべてに着せる、FBX または glTF のメッシュ。誤差はその上で測られ、重み付け「スキン」はそれに従って圧縮します。ほかのクリップは元のままで、レポートにその旨が示されます。</translation>
    </message>
</context>
<context>
    <name>mocapress::ClipFiles</name>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>Motion and compressed clips (%1 *.mcpr);;All files (*)</source>
        <translation>モーションと圧縮クリップ (%1 *.mcpr);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Skeleton of %1</source>
        <translation>%1 のスケルトン</translation>
    </message>
    <message>
        <source>Skeletons (*.asf)</source>
        <translation>スケルトン (*.asf)</translation>
    </message>
    <message>
        <source>Put a Character on the Clip</source>
        <translation>クリップにキャラクターを適用</translation>
    </message>
    <message>
        <source>Characters (*.fbx *.glb *.gltf *.vrm)</source>
        <translation>キャラクター (*.fbx *.glb *.gltf *.vrm)</translation>
    </message>
    <message>
        <source>Compare with Original</source>
        <translation>元と比較</translation>
    </message>
    <message>
        <source>Motion (%1)</source>
        <translation>モーション (%1)</translation>
    </message>
    <message>
        <source>Compressed clips (*.mcpr)</source>
        <translation>圧縮クリップ (*.mcpr)</translation>
    </message>
    <message>
        <source>Unsaved Changes</source>
        <translation>保存されていない変更</translation>
    </message>
    <message>
        <source>Save the compressed clip of %1?</source>
        <translation>%1 の圧縮クリップを保存しますか?</translation>
    </message>
    <message>
        <source>The project keeps the clip&apos;s settings either way.</source>
        <translation>どちらを選んでも、クリップの設定はプロジェクトに残ります。</translation>
    </message>
    <message>
        <source>Biovision motion (*.bvh)</source>
        <translation>Biovision モーション (*.bvh)</translation>
    </message>
    <message>
        <source>Acclaim motion with its skeleton (*.amc)</source>
        <translation>Acclaim モーションとスケルトン (*.amc)</translation>
    </message>
    <message>
        <source>FBX on its skeleton (*.fbx)</source>
        <translation>FBX とスケルトン (*.fbx)</translation>
    </message>
    <message>
        <source>%1 with this motion (*.%2)</source>
        <translation>この動きを付けた %1 (*.%2)</translation>
    </message>
    <message>
        <source>%1 is the file of the character. Replace it with a file that also has this motion?</source>
        <translation>%1 はキャラクターです。この動きを付けたものに置き換えますか？</translation>
    </message>
    <message>
        <source>glTF on its skeleton (*.glb)</source>
        <translation>glTF とスケルトン (*.glb)</translation>
    </message>
    <message>
        <source>Table of channels (*.csv)</source>
        <translation>チャンネルの表 (*.csv)</translation>
    </message>
    <message>
        <source>Review pages (*.html)</source>
        <translation>レビューページ (*.html)</translation>
    </message>
    <message>
        <source>Save Clip</source>
        <translation>クリップを保存</translation>
    </message>
    <message>
        <source>Export Motion</source>
        <translation>モーションを書き出す</translation>
    </message>
    <message>
        <source>Export Review Page</source>
        <translation>レビューページを書き出す</translation>
    </message>
    <message>
        <source>The skeleton is written to %1, which exists already. Replace it?</source>
        <translation>スケルトンは %1 に書き込まれますが、このファイルはすでにあります。置き換えますか？</translation>
    </message>
    <message>
        <source>%1 is the original that is open. Replace it with the compressed motion?</source>
        <translation>%1 は開いている元のファイルです。圧縮後のモーションで置き換えますか？</translation>
    </message>
</context>
<context>
    <name>mocapress::ClipLinks</name>
    <message>
        <source>%1 is not on this computer, and the library has no clip of that name.</source>
        <translation>%1 はこのコンピューターになく、ライブラリにもその名前のクリップがありません。</translation>
    </message>
    <message>
        <source>Copied the link to this frame and view.</source>
        <translation>このフレームと視点へのリンクをコピーしました。</translation>
    </message>
</context>
<context>
    <name>mocapress::CommandPalette</name>
    <message>
        <source>No command has these words.</source>
        <translation>これらの語を含むコマンドはありません。</translation>
    </message>
    <message>
        <source>Find a Command</source>
        <translation>コマンドの検索</translation>
    </message>
    <message>
        <source>Words of a command, such as: next note</source>
        <translation>コマンドの言葉（例：次のメモ）</translation>
    </message>
    <message>
        <source>Words of a command</source>
        <translation>コマンドの言葉</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>コマンド</translation>
    </message>
</context>
<context>
    <name>mocapress::CompressionPanel</name>
    <message>
        <source>Method</source>
        <translation>手法</translation>
    </message>
    <message>
        <source>Weighting</source>
        <translation>重み付け</translation>
    </message>
    <message>
        <source>Coding</source>
        <translation>符号化</translation>
    </message>
    <message>
        <source>Effort</source>
        <translation>労力</translation>
    </message>
    <message>
        <source>Importance</source>
        <translation>重要度</translation>
    </message>
    <message>
        <source>Closed loop gives by far the smallest files: it rounds every coefficient by its effect on world-space error. The others are the paper&apos;s methods, which choose the coefficients to keep. Annealed searches for the channels where coefficients lower the error most, Standard keeps the largest of all channels, Per channel keeps as many in each.</source>
        <translation>閉ループは、ワールドでの誤差への影響を見ながら各係数を丸め、群を抜いて小さくなります。ほかは論文の手法で、残す係数を選びます。焼きなましは誤差が最も減るチャンネルへ係数を移し、標準は全体で大きいものを、チャンネル別は各チャンネルから同じ数だけ残します。</translation>
    </message>
    <message>
        <source>Best searches longer for a smaller result: it saves about 1 % and takes some three times as long.</source>
        <translation>「最良」はより小さくなるものを長く探します。3 倍ほどの時間で約 1 % 小さくなります。</translation>
    </message>
    <message>
        <source>Effort applies only to the closed loop; the paper&apos;s methods have one result.</source>
        <translation>労力を選べるのは閉ループだけです。論文の手法の結果は一つです。</translation>
    </message>
    <message>
        <source>The closed loop always uses adaptive coding, whose bytes it counts while it searches.</source>
        <translation>閉ループは自身の適応符号化のバイト数を見て選ぶため、ほかの符号化はありません。</translation>
    </message>
    <message>
        <source>Coding of kept coefficients as bytes: 16-bit words with runs of zeros, with or without DEFLATE on top, or an adaptive range coder.</source>
        <translation>残した係数をバイトにする方法。ゼロの連続をまとめた 16 ビット語(さらに DEFLATE で詰めることも可)、または適応レンジ符号化。</translation>
    </message>
    <message>
        <source>Not used</source>
        <translation>無効</translation>
    </message>
    <message>
        <source>All equal</source>
        <translation>すべて同じ</translation>
    </message>
    <message>
        <source>Give errors of feet, hands, the head, contacts or any joint more weight.</source>
        <translation>足、手、頭、接地、任意の関節をより丁寧に扱います。</translation>
    </message>
    <message>
        <source>More</source>
        <translation>詳細</translation>
    </message>
    <message>
        <source>This method ignores importance: choose %1 or %2.</source>
        <translation>この手法は重要度を考慮しません。%1か%2を選んでください。</translation>
    </message>
    <message>
        <source>Rarely changed settings: error weighting, ends of the clip, and coding.</source>
        <translation>誤差の重み付け、クリップの両端、符号化。めったに変えません。</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>両端</translation>
    </message>
    <message>
        <source>Only the closed loop corrects the first and last pose.</source>
        <translation>最初と最後のポーズをもう一度符号化するのは閉ループだけです。</translation>
    </message>
    <message>
        <source>Errors of the first and last pose, where clips are blended and looped. Even: no larger than the target, and equal at both ends of a loop. Exact: at most a tenth of the target, for some 4 % more bytes. Free: no bound.</source>
        <translation>最初と最後のポーズ。クリップがブレンドされ、ループする所です。均等：目標より離れず、ループでは両端がそろいます。厳密：目標の十分の一で、約 4 % 大きくなります。自由：成り行きのまま。</translation>
    </message>
    <message>
        <source>Tracks within</source>
        <translation>トラックの許容誤差</translation>
    </message>
    <message>
        <source>Largest error allowed for values of morph weights and scales, independent of the target of the motion. Weights range from 0 to 1; switches and constants are kept exactly.</source>
        <translation>モーフウェイトとスケールの値がずれてよい大きさです。モーションの目標とは別に働きます。重みは0から1までで、スイッチと定数はそのまま保たれます。</translation>
    </message>
    <message>
        <source>Points on which the error eps_x is measured. Surface: a body modelled around the bones, so that turned heads and hands count. Skin: the mesh of the clip or of the character put on it. Shell: three points 3 cm from every joint, as in ACL. Bone ends and joint origins: points on the bones, weighted by bone length; joint origins are the paper&apos;s.</source>
        <translation>誤差 eps_x が数える点です。体表：骨の周りに作った体の表面の点。頭や手の回転も数えます。スキン：クリップ、または着せたキャラクターのメッシュ上の点。シェル：ACL と同じく、各関節から 3 cm の三点。骨の先端と関節原点：骨の長さで重み付けした骨上の点で、後者は論文のものです。</translation>
    </message>
    <message>
        <source>Viewing distance</source>
        <translation>視距離</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Distance from which the figure is watched. The nearer, the smaller an error that is noticed.</source>
        <translation>人物を見る距離。近いほど小さな誤差に気づきます。</translation>
    </message>
</context>
<context>
    <name>mocapress::ContactStrip</name>
    <message>
        <source>Contacts</source>
        <translation>接地</translation>
    </message>
    <message>
        <source>Remove Contact</source>
        <translation>接地を削除</translation>
    </message>
    <message>
        <source>Add Contact Here</source>
        <translation>ここに接地を追加</translation>
    </message>
    <message>
        <source>%1 stands in frames %L2–%L3 and drifts by %4 from the original. Drag an end to move it.</source>
        <translation>%1が接地、フレーム%L2–%L3。元に対して%4ずれます。端をドラッグすると移動します。</translation>
    </message>
</context>
<context>
    <name>mocapress::ConvergencePlot</name>
    <message>
        <source>Iteration</source>
        <translation>反復</translation>
    </message>
    <message>
        <source>eps_x (cm)</source>
        <translation>eps_x (cm)</translation>
    </message>
    <message>
        <source>Error while refining</source>
        <translation>仕上げ中の誤差</translation>
    </message>
    <message>
        <source>Error after each iteration of the refinement.</source>
        <translation>結果を仕上げる間に誤差が減っていく様子。</translation>
    </message>
</context>
<context>
    <name>mocapress::CorrectionControl</name>
    <message>
        <source>Auto</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>Stores the places of the feet and moves the feet there by inverse kinematics, so that planted feet do not slide. The bytes of this correction count in the compression ratio.</source>
        <translation>元の足の位置を記録し、逆運動学でそこへ戻すので、接地した足が滑りません。その分も圧縮率に含まれます。</translation>
    </message>
    <message>
        <source>Searches for the smallest correction that removes at least nine tenths of the sliding, or leaves no foot sliding more than a millimetre.</source>
        <translation>足にどれだけ使うかをエンコーダに任せます：最も少ないバイト数で、滑りの9割以上をなくすか、どの足の滑りも1ミリ以下にします。</translation>
    </message>
    <message>
        <source>IK ratio</source>
        <translation>IK比</translation>
    </message>
    <message>
        <source>Coefficients of the correction over those kept (r_IK in the paper). Lower values hold the feet better and take more bytes.</source>
        <translation>論文の r_IK：補正の全係数と残した係数の比。低いほど足がよく固定され、コストも増えます。</translation>
    </message>
    <message>
        <source> : 1</source>
        <translation> : 1</translation>
    </message>
    <message>
        <source>IK ratio on a slider</source>
        <translation>IK比のスライダー</translation>
    </message>
    <message>
        <source>When feet are held</source>
        <translation>足を固定する範囲</translation>
    </message>
    <message>
        <source>Hold the feet at every frame, as in the paper, or only while they stand on the ground, blended in and out.</source>
        <translation>論文どおり全フレーム、または接地している間だけ(前後はなめらかに)。</translation>
    </message>
    <message>
        <source>Held joints</source>
        <translation>固定する関節</translation>
    </message>
    <message>
        <source>Joints to hold; the feet by default.</source>
        <translation>足以外の関節も固定できます。</translation>
    </message>
    <message>
        <source>Hold at</source>
        <translation>固定範囲</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>関節</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>足</translation>
    </message>
    <message numerus="yes">
        <source>%Ln joint(s)</source>
        <translation>
            <numerusform>%Ln 個の関節</numerusform>
        </translation>
    </message>
    <message>
        <source>Hold feet (IK)</source>
        <translation>足を固定 (IK)</translation>
    </message>
</context>
<context>
    <name>mocapress::EncodingBar</name>
    <message>
        <source>Clips that are compressed</source>
        <translation>圧縮したクリップ</translation>
    </message>
    <message>
        <source>Pause compressing clips in the background</source>
        <translation>裏での圧縮を一時停止</translation>
    </message>
    <message>
        <source>Compress all clips in the background with their own settings, the open clip first.</source>
        <translation>すべてのクリップをそれぞれの設定で裏で圧縮します。開いているクリップが先です。</translation>
    </message>
    <message>
        <source>%L1 of %L2 compressed</source>
        <translation>%L2 件中 %L1 件を圧縮</translation>
    </message>
    <message>
        <source>%1, %L2 failed</source>
        <translation>%1、失敗 %L2 件</translation>
    </message>
</context>
<context>
    <name>mocapress::ErrorDisplay</name>
    <message>
        <source>Errors in &amp;Degrees</source>
        <translation>誤差を度で表示(&amp;D)</translation>
    </message>
    <message>
        <source>Degrees</source>
        <translation>度</translation>
    </message>
    <message>
        <source>Show rotation errors of joints (in degrees, world space) instead of distances in heat map and error graph (%1)</source>
        <translation>ヒートマップと誤差のグラフ：位置のずれの代わりに、関節の回転が空間で何度ずれているかを示す（%1）</translation>
    </message>
    <message>
        <source>Visible Errors</source>
        <translation>目に見える誤差</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>見え方</translation>
    </message>
    <message>
        <source>Show visible errors of joints instead of distances in the heat map (%1)</source>
        <translation>ヒートマップ：関節のずれの大きさの代わりに、ずれが人の目に付く箇所を表示します（%1）</translation>
    </message>
</context>
<context>
    <name>mocapress::ErrorGraph</name>
    <message>
        <source>Error over time</source>
        <translation>誤差の時間変化</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>時間 (s)</translation>
    </message>
    <message>
        <source>Error (cm)</source>
        <translation>誤差 (cm)</translation>
    </message>
    <message>
        <source>worst of all joints</source>
        <translation>全関節の最悪</translation>
    </message>
    <message>
        <source>World-space distance or angle between joints and the original. Click to go to a frame, turn the wheel to zoom, double-click to show all.</source>
        <translation>空間での関節の元との距離、または回転のずれ。クリックで移動、ホイールで拡大、ダブルクリックで全体。</translation>
    </message>
    <message>
        <source>Angle (°)</source>
        <translation>角度 (°)</translation>
    </message>
    <message>
        <source>Frame %L1</source>
        <translation>フレーム %L1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>mocapress::ErrorScaleChoice</name>
    <message>
        <source>&amp;Automatic</source>
        <translation>自動(&amp;A)</translation>
    </message>
</context>
<context>
    <name>mocapress::ErrorStrip</name>
    <message>
        <source>Error strip</source>
        <translation>誤差の帯</translation>
    </message>
    <message>
        <source>Largest and mean error at every frame. The table of joints has the numbers.</source>
        <translation>各フレームの最大誤差と平均誤差。数値は関節の表にあります。</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>誤差</translation>
    </message>
    <message>
        <source>Errors of this size or more have full height and the lightest colour. Click to choose another scale.</source>
        <translation>この大きさ以上の誤差は最も高く明るく示されます。クリックで別の尺度を選べます。</translation>
    </message>
    <message>
        <source>Largest error at every frame as a column, mean error as a line. Turn the wheel to zoom, with Shift to scroll; drag with Shift to choose the range to play.</source>
        <translation>各フレームの最大誤差を柱で、平均を線で示します。ホイールで拡大、Shift+ホイールで移動、Shift+ドラッグで再生範囲を選びます。</translation>
    </message>
    <message>
        <source>A jump of one frame: %1 at frame %L2, %3</source>
        <translation>1フレームの飛び：%1、フレーム %L2、%3</translation>
    </message>
</context>
<context>
    <name>mocapress::FactorControl</name>
    <message>
        <source>%1 on a slider</source>
        <translation>%1(スライダー)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
</context>
<context>
    <name>mocapress::Figures</name>
    <message>
        <source>Nothing open</source>
        <translation>何も開いていません</translation>
    </message>
    <message>
        <source>Not compressed</source>
        <translation>未圧縮</translation>
    </message>
    <message>
        <source>Compressing…</source>
        <translation>圧縮中…</translation>
    </message>
    <message>
        <source>As recorded in the file</source>
        <translation>ファイルの記録どおり</translation>
    </message>
    <message>
        <source>%1, with the settings of the study</source>
        <translation>%1、比較研究のとおり</translation>
    </message>
    <message>
        <source>%1, read from the file and measured against the original</source>
        <translation>%1、ファイルから、元と比べて計測</translation>
    </message>
    <message>
        <source>%1, %L2 s</source>
        <translation>%1、%L2 s</translation>
    </message>
    <message>
        <source>Footskate is measured against the original.</source>
        <translation>足滑りは元と比べて計測されます。</translation>
    </message>
    <message>
        <source>No foot stands on the ground in this clip.</source>
        <translation>このクリップでは足が接地しません。</translation>
    </message>
    <message>
        <source>%1, without IK</source>
        <translation>%1、IKなし</translation>
    </message>
    <message>
        <source>Draft; the refined result follows</source>
        <translation>下書き。仕上げ中です</translation>
    </message>
    <message>
        <source>Refinement cancelled; the best so far is kept</source>
        <translation>仕上げを中止。それまでの最良の結果を残しました</translation>
    </message>
    <message>
        <source>Refinement cancelled; the draft is kept</source>
        <translation>仕上げを中止。下書きを残しました</translation>
    </message>
    <message>
        <source>No result for these settings; the draft is kept</source>
        <translation>この設定では結果が出ません。下書きを残しました</translation>
    </message>
    <message>
        <source>No result for these settings; the last one is kept</source>
        <translation>この設定では結果が出ません。前の結果を残しました</translation>
    </message>
    <message numerus="yes">
        <source>%1, %Ln iteration(s), %L2 s</source>
        <translation>
            <numerusform>%1、反復 %Ln 回、%L2 s</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln contact(s): mean drift of the feet %1, worst %2; their path is %3 longer than the original&apos;s</source>
        <translation>
            <numerusform>接地%Ln回：足のずれは平均%1、最大%2。軌跡は元より%3長い</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %L2 s, as a loop</source>
        <translation>%1、%L2 s、ループ</translation>
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
        <translation>元と圧縮後の距離の二乗平均平方根(骨の長さで重み付け)：論文の歪み。</translation>
    </message>
    <message>
        <source>p95</source>
        <translation>p95</translation>
    </message>
    <message>
        <source>95 % of all points at all frames have a smaller error.</source>
        <translation>全フレームの全点の95 %がこれより元に近い。</translation>
    </message>
    <message>
        <source>p99</source>
        <translation>p99</translation>
    </message>
    <message>
        <source>99 % of all points at all frames have a smaller error.</source>
        <translation>全フレームの全点の99 %がこれより元に近い。</translation>
    </message>
    <message>
        <source>max</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Largest error of any point at any frame.</source>
        <translation>全フレーム・全点での最大誤差。</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>圧縮率</translation>
    </message>
    <message>
        <source>Bytes of the channels as 32-bit floats, divided by the compressed motion bytes, as in the paper.</source>
        <translation>32ビット浮動小数点のチャンネルと圧縮後の動きのバイト数の比(論文どおり)。</translation>
    </message>
    <message>
        <source>bits per joint-sample</source>
        <translation>関節サンプルあたりビット</translation>
    </message>
    <message>
        <source>Motion bits for one joint at one frame; unlike a ratio it needs no baseline.</source>
        <translation>1関節・1フレームあたりの動きのビット数。基準に依存しません。</translation>
    </message>
    <message>
        <source>eps_x, %1</source>
        <translation>eps_x、%1</translation>
    </message>
    <message>
        <source>≈ %1</source>
        <translation>≈ %1</translation>
    </message>
    <message>
        <source>foot drift</source>
        <translation>足のずれ</translation>
    </message>
    <message>
        <source>Largest distance between a standing foot and its place in the original.</source>
        <translation>足が本来の接地位置から最も離れる距離。</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>モーション</translation>
    </message>
    <message>
        <source>Compressed motion bytes; the skeleton in the file takes more.</source>
        <translation>圧縮したモーションのバイト数。ファイルにはほかにスケルトンが入ります。</translation>
    </message>
    <message>
        <source>Errors in the range</source>
        <translation>範囲内の誤差</translation>
    </message>
    <message>
        <source>Errors of all joints in the frames of the chosen range: root mean square, 95th percentile and largest. A double click on the ruler chooses the whole clip again.</source>
        <translation>選択した範囲の全関節の誤差：二乗平均平方根、95パーセンタイル、最大。ルーラーをダブルクリックするとクリップ全体に戻ります。</translation>
    </message>
</context>
<context>
    <name>mocapress::FilmRecorder</name>
    <message>
        <source>%1: ffmpeg could not write the video (%2)</source>
        <translation>%1：ffmpeg が動画を書き出せませんでした（%2）</translation>
    </message>
    <message>
        <source>A video needs the program ffmpeg, which is not installed here. Numbered pictures (.png) need nothing.</source>
        <translation>動画には ffmpeg が必要ですが、インストールされていません。連番画像（.png）には何も要りません。</translation>
    </message>
    <message>
        <source>%1: there is such a folder already</source>
        <translation>%1：このフォルダーはすでにあります</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2)</source>
        <translation>%1：書き込めません（%2）</translation>
    </message>
    <message>
        <source>The 3D view gave no picture.</source>
        <translation>3D ビューから画像を得られませんでした。</translation>
    </message>
</context>
<context>
    <name>mocapress::FolderSearch</name>
    <message>
        <source>There are no clips in %1.</source>
        <translation>%1 にはクリップがありません。</translation>
    </message>
</context>
<context>
    <name>mocapress::FootskatePanel</name>
    <message>
        <source>Findings of footskate</source>
        <translation>足滑りの検出結果</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>接地</translation>
    </message>
    <message>
        <source>begins below</source>
        <translation>開始(以下)</translation>
    </message>
    <message>
        <source>ends above</source>
        <translation>終了(以上)</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速さ</translation>
    </message>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source>Height below which a contact begins</source>
        <translation>接地が始まる高さ</translation>
    </message>
    <message>
        <source>Height above which a contact ends</source>
        <translation>接地が終わる高さ</translation>
    </message>
    <message>
        <source> cm/s</source>
        <translation> cm/s</translation>
    </message>
    <message>
        <source>Speed below which a contact begins</source>
        <translation>接地が始まる速さ</translation>
    </message>
    <message>
        <source>Speed above which a contact ends</source>
        <translation>接地が終わる速さ</translation>
    </message>
    <message>
        <source>%1, measured in the original.</source>
        <translation>%1(元のモーションで計測)。</translation>
    </message>
</context>
<context>
    <name>mocapress::ForeignLock</name>
    <message>
        <source>%1 was opened by another Mocapress meanwhile, so it was not taken over.</source>
        <translation>%1はその間に別のMocapressで開かれたため、引き継ぎませんでした。</translation>
    </message>
    <message>
        <source>The project cannot be taken over: its lock %1 is still held, or you may not change it.</source>
        <translation>プロジェクトを引き継げません: ロック%1がまだ使用中か、変更する権限がありません。</translation>
    </message>
    <message>
        <source>%1 is open in another window of Mocapress</source>
        <translation>%1 は Mocapress の別のウィンドウで開かれています</translation>
    </message>
    <message>
        <source>%1 is open on the computer %2, since %3</source>
        <translation>%1 はコンピューター %2 で %3 から開かれています</translation>
    </message>
    <message>
        <source>%1 is open on the computer %2, by %3, since %4</source>
        <translation>%1 はコンピューター %2 で %3 が %4 から開いています</translation>
    </message>
</context>
<context>
    <name>mocapress::FrameNotes</name>
    <message>
        <source>Frame %L1</source>
        <translation>フレーム %L1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>Stale: the clip&apos;s file or settings have changed since.</source>
        <translation>古いメモ：その後クリップのファイルか設定が変わりました。</translation>
    </message>
    <message>
        <source>Frames %L1–%L2</source>
        <translation>フレーム %L1–%L2</translation>
    </message>
</context>
<context>
    <name>mocapress::HeatMap</name>
    <message>
        <source>Heat map of errors</source>
        <translation>誤差のヒートマップ</translation>
    </message>
    <message>
        <source>Error of every joint at every frame. Arrow keys move to the next joint or frame.</source>
        <translation>全関節・全フレームの誤差。矢印キーで隣の関節やフレームへ。</translation>
    </message>
    <message>
        <source>Errors are measured against the original.</source>
        <translation>誤差は元と比べて計測されます。</translation>
    </message>
    <message>
        <source>%1, frame %L2: %3</source>
        <translation>%1、フレーム %L2：%3</translation>
    </message>
</context>
<context>
    <name>mocapress::Help</name>
    <message>
        <source>Guide</source>
        <translation>ガイド</translation>
    </message>
    <message>
        <source>Keyboard Shortcuts</source>
        <translation>キーボードショートカット</translation>
    </message>
    <message>
        <source>About Mocapress</source>
        <translation>Mocapressについて</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Mocapress %1&lt;/h3&gt;&lt;p&gt;Compresses human motion capture clips with wavelets, after Philippe Beaudoin, Pierre Poulin and Michiel van de Panne, &lt;i&gt;Adapting Wavelet Compression to Human Motion Capture Clips&lt;/i&gt;, Graphics Interface 2007.&lt;/p&gt;&lt;p&gt;The studio is free software under the GNU General Public License, version 3 or later; the compression library is under the MIT licence.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Mocapress %1&lt;/h3&gt;&lt;p&gt;人のモーションキャプチャをウェーブレットで圧縮します。Philippe Beaudoin、Pierre Poulin、Michiel van de Panne, &lt;i&gt;Adapting Wavelet Compression to Human Motion Capture Clips&lt;/i&gt;, Graphics Interface 2007 に基づきます。&lt;/p&gt;&lt;p&gt;スタジオはGNU一般公衆利用許諾書バージョン3以降の自由ソフトウェア、圧縮ライブラリはMITライセンスです。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Right or middle drag: move</source>
        <translation>右または中ドラッグ：移動</translation>
    </message>
    <message>
        <source>Wheel: nearer or further</source>
        <translation>ホイール：近づく・遠ざかる</translation>
    </message>
    <message>
        <source>Click on a joint: select it</source>
        <translation>関節をクリック：選択</translation>
    </message>
    <message>
        <source>Drag an end of a contact: move it; right button: add or remove</source>
        <translation>接地の端をドラッグ：移動、右ボタン：追加・削除</translation>
    </message>
    <message>
        <source>Shift and drag on the error strip: choose the range that is played</source>
        <translation>誤差の帯でShift＋ドラッグ：再生範囲を選択</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>マウス</translation>
    </message>
    <message>
        <source>Wheel over the timeline: zoom; with Shift: move along</source>
        <translation>タイムライン上でホイール：拡大縮小、Shift を押しながら：移動</translation>
    </message>
    <message>
        <source>Click on the scale of the error strip: choose another</source>
        <translation>誤差の帯の目盛りをクリック：別の尺度を選ぶ</translation>
    </message>
    <message>
        <source>Drag on the ruler: choose a range; right button: what to do with it</source>
        <translation>ルーラー上をドラッグ：範囲を選ぶ、右ボタン：範囲に対する操作</translation>
    </message>
    <message>
        <source>Left drag in the 3D view: turn; in a view along an axis: move</source>
        <translation>3D ビューで左ドラッグ：回転。軸方向のビューでは移動</translation>
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
        <translation>読み込みオプション – %1</translation>
    </message>
    <message>
        <source>Guessed by the figure&apos;s height</source>
        <translation>人物の身長から推定</translation>
    </message>
    <message>
        <source>As in the skeleton file</source>
        <translation>スケルトンの記述どおり</translation>
    </message>
    <message>
        <source>Centimetre</source>
        <translation>センチメートル</translation>
    </message>
    <message>
        <source>Metre</source>
        <translation>メートル</translation>
    </message>
    <message>
        <source>Millimetre</source>
        <translation>ミリメートル</translation>
    </message>
    <message>
        <source>Inch</source>
        <translation>インチ</translation>
    </message>
    <message>
        <source>CMU&apos;s unit (0.45 to the inch)</source>
        <translation>CMU の単位（1 インチ = 0.45）</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>その他</translation>
    </message>
    <message>
        <source>Y, as usual</source>
        <translation>Y（通常どおり）</translation>
    </message>
    <message>
        <source>Guessed by the root&apos;s values</source>
        <translation>ルートの値から推定</translation>
    </message>
    <message>
        <source>Adds to its OFFSET</source>
        <translation>OFFSET に加算</translation>
    </message>
    <message>
        <source>Replaces its OFFSET</source>
        <translation>OFFSET を置き換え</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>ファイルの記述どおり</translation>
    </message>
    <message>
        <source>%L1 Hz</source>
        <translation>%L1 Hz</translation>
    </message>
    <message>
        <source>&amp;Length unit</source>
        <translation>長さの単位(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Up axis</source>
        <translation>上方向の軸(&amp;U)</translation>
    </message>
    <message>
        <source>Frame &amp;rate</source>
        <translation>フレームレート(&amp;R)</translation>
    </message>
    <message>
        <source>BVH r&amp;oot</source>
        <translation>BVH のルート(&amp;O)</translation>
    </message>
    <message>
        <source>Length unit</source>
        <translation>長さの単位</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>フレームレート</translation>
    </message>
    <message>
        <source>Centimetres in one unit</source>
        <translation>1 単位あたりのセンチメートル</translation>
    </message>
    <message>
        <source>Frames per second</source>
        <translation>毎秒のフレーム数</translation>
    </message>
    <message>
        <source>Now read with %L1 cm to the unit, %2 up, %L3 Hz</source>
        <translation>現在の読み方: 1 単位 = %L1 cm、上は %2、%L3 Hz</translation>
    </message>
    <message>
        <source>, the root adds to its OFFSET</source>
        <translation>、ルートは OFFSET に加算</translation>
    </message>
    <message>
        <source>, the root replaces its OFFSET</source>
        <translation>、ルートは OFFSET を置き換え</translation>
    </message>
    <message>
        <source>%L1 Hz, CMU&apos;s: the file does not say</source>
        <translation>%L1 Hz（CMU の値。ファイルに記載なし）</translation>
    </message>
</context>
<context>
    <name>mocapress::ImportancePanel</name>
    <message>
        <source>Contacts</source>
        <translation>接地</translation>
    </message>
    <message>
        <source>Factor on the weight of a foot while it stands. About 20 keeps feet planted without inverse kinematics, for some more bytes at the same error.</source>
        <translation>接地している足が本来の何倍の重みを持つか。20 前後で、逆運動学なしでも足が滑らなくなります。同じ誤差で少しバイト数が増えます。</translation>
    </message>
    <message>
        <source>All Equal</source>
        <translation>すべて同じにする</translation>
    </message>
    <message>
        <source>Factor on the weight of these joints. Other joints get less accurate in return: the size or error that was asked for stays the same.</source>
        <translation>これらの関節の重みを何倍にするか。ここが良くなる分、ほかが悪くなります。サイズや約束した誤差は変わりません。</translation>
    </message>
    <message>
        <source>Give all joints the same weight again.</source>
        <translation>すべての関節を再び同じように扱います。</translation>
    </message>
    <message>
        <source>Any joint</source>
        <translation>任意の関節</translation>
    </message>
    <message>
        <source>Set factors of single joints.</source>
        <translation>個々の関節に独自の倍率を与えます。</translation>
    </message>
    <message>
        <source>Find a joint</source>
        <translation>関節を検索</translation>
    </message>
    <message>
        <source>Importance of every joint</source>
        <translation>各関節の重要度</translation>
    </message>
    <message>
        <source>Double-click a factor to change it.</source>
        <translation>倍率をダブルクリックすると変更できます。</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>関節</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>倍率</translation>
    </message>
    <message>
        <source>No joint of this skeleton has the name of this part of the body.</source>
        <translation>このスケルトンには、この部位の名前を持つ関節がありません。</translation>
    </message>
    <message>
        <source>Weights of errors by part of the body. Parts with more weight get more accurate, the rest less.</source>
        <translation>ほかより丁寧に扱うところ。その分、残りの誤差が増えます。</translation>
    </message>
    <message>
        <source>This method ignores importance: choose %1 or %2.</source>
        <translation>この手法は重要度を考慮しません。%1か%2を選んでください。</translation>
    </message>
</context>
<context>
    <name>mocapress::IncomingFiles</name>
    <message>
        <source>Left out; the library takes only motions: %1</source>
        <translation>ライブラリはモーションだけを扱うため除きました：%1</translation>
    </message>
    <message>
        <source>Left out; only one project is open at a time: %1</source>
        <translation>一度に開けるプロジェクトは一つのため除きました：%1</translation>
    </message>
</context>
<context>
    <name>mocapress::Inspector</name>
    <message>
        <source>The curve of this clip appears after it is compressed.</source>
        <translation>圧縮が済むとこのクリップの曲線が描かれます。</translation>
    </message>
    <message>
        <source>Frames %L1–%L2: RMS %3, p95 %4, max %5 (%6, frame %L7)</source>
        <translation>フレーム %L1–%L2：RMS %3、p95 %4、最大 %5（%6、フレーム %L7）</translation>
    </message>
</context>
<context>
    <name>mocapress::JobRunner</name>
    <message>
        <source>An unknown error occurred.</source>
        <translation>不明なエラーが起きました。</translation>
    </message>
</context>
<context>
    <name>mocapress::JointErrorModel</name>
    <message>
        <source>Joint</source>
        <translation>関節</translation>
    </message>
    <message>
        <source>Joint origins and bone ends, in the skeleton&apos;s order.</source>
        <translation>関節の原点と骨の先端(スケルトンの順)。</translation>
    </message>
    <message>
        <source>World-space distance from the original, mean over the clip.</source>
        <translation>空間での元との距離、クリップ全体の平均。</translation>
    </message>
    <message>
        <source>Largest world-space distance from the original at any frame.</source>
        <translation>空間での元との距離、全フレームの最大。</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Angle between the joint&apos;s world-space rotation and the original&apos;s, RMS over the clip. Bone ends turn with their joint.</source>
        <translation>空間での関節の回転と元の回転との角度、クリップ全体の二乗平均平方根。骨の先端は関節と共に回転します。</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>見え方</translation>
    </message>
    <message>
        <source>The joint&apos;s most visible error, as a multiple of the noticeable error: up to 1 is not visible, up to 2 borderline.</source>
        <translation>関節の最悪値。人が気付く大きさの何倍かで示します。1 までは見えず、2 までは境界です。</translation>
    </message>
    <message>
        <source>RMS %1</source>
        <translation>RMS %1</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>スキン</translation>
    </message>
    <message>
        <source>Largest error at any frame of the part of the mesh that mainly follows this joint.</source>
        <translation>この関節が主に動かすメッシュの、全フレーム中の最大距離です。</translation>
    </message>
</context>
<context>
    <name>mocapress::JointsPanel</name>
    <message>
        <source>Joints</source>
        <translation>関節</translation>
    </message>
</context>
<context>
    <name>mocapress::KeptProject</name>
    <message>
        <source>The last project</source>
        <translation>前回のプロジェクト</translation>
    </message>
    <message>
        <source>%1 is read-only. This is a copy without a name.</source>
        <translation>%1はその場所では変更できません。これは名前のないコピーです。</translation>
    </message>
    <message>
        <source>The project was not saved: %1</source>
        <translation>プロジェクトが書き込まれていません: %1</translation>
    </message>
    <message>
        <source>its lock was replaced or removed by someone else; use Save Project As to keep the changes in another file</source>
        <translation>ロックが他の誰かに置き換えられたか削除されました。変更を別のファイルに残すには、「プロジェクトを保存」を使ってください</translation>
    </message>
    <message>
        <source>it was taken over on the computer %1; use Save Project As to keep the changes in another file</source>
        <translation>コンピューター%1で引き継がれました。変更を別のファイルに残すには、「プロジェクトを保存」を使ってください</translation>
    </message>
    <message>
        <source>%1. This is a new project.</source>
        <translation>%1。これは新しいプロジェクトです。</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1。</translation>
    </message>
</context>
<context>
    <name>mocapress::KeyboardMap</name>
    <message>
        <source>Assign</source>
        <translation>割り当て</translation>
    </message>
    <message>
        <source>No Key</source>
        <translation>キーなし</translation>
    </message>
    <message>
        <source>Usual Key</source>
        <translation>既定のキー</translation>
    </message>
    <message>
        <source>Keyboard Map</source>
        <translation>キー割り当て</translation>
    </message>
    <message>
        <source>Words of a command, or a key</source>
        <translation>コマンドの言葉またはキー</translation>
    </message>
    <message>
        <source>Words of a command</source>
        <translation>コマンドの言葉</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>メニュー</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>新しいキー</translation>
    </message>
    <message>
        <source>Usual Keys for All</source>
        <translation>すべて既定のキーに戻す</translation>
    </message>
    <message>
        <source>%1 belongs to “%2”, which loses it when you assign it.</source>
        <translation>%1 は「%2」のキーです。割り当てるとそちらからは外れます。</translation>
    </message>
</context>
<context>
    <name>mocapress::LaunchOptions</name>
    <message>
        <source>Compress human motion capture clips with wavelets, and look at the result.</source>
        <translation>人のモーションキャプチャをウェーブレットで圧縮し、その結果を見ます。</translation>
    </message>
    <message>
        <source>Skeleton (.asf) of an .amc.</source>
        <translation>.amc 用の .asf スケルトン。</translation>
    </message>
    <message>
        <source>Compression ratio at the start.</source>
        <translation>最初の圧縮率。</translation>
    </message>
    <message>
        <source>Hold the feet, with this IK ratio at the start.</source>
        <translation>足を固定し、最初のIK比をこれにします。</translation>
    </message>
    <message>
        <source>Write timings to standard error.</source>
        <translation>所要時間を標準エラー出力に書きます。</translation>
    </message>
    <message>
        <source>After the clip is compressed, write a picture of the window and quit.</source>
        <translation>圧縮が済んだらウィンドウの画像を書いて終了します。</translation>
    </message>
    <message>
        <source>A project (.mocapress), a motion or a .mcpr file. Several files, and folders, are added to the library. Or a link (mocapress://...).</source>
        <translation>プロジェクト (.mocapress)、モーション、または .mcpr ファイル。複数のファイルやフォルダーはライブラリに追加されます。リンク (mocapress://...) も開けます。</translation>
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
        <translation>%1 mm 未満</translation>
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
        <translation>メモ</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Add Clips</source>
        <translation>クリップを追加</translation>
    </message>
    <message>
        <source>Remove Clip</source>
        <translation>クリップを外す</translation>
    </message>
    <message numerus="yes">
        <source>%Ln clip(s) were taken out of the library; Redo brings them back.</source>
        <translation>
            <numerusform>%Ln 個のクリップをライブラリから除きました。「やり直す」で戻ります。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>No verdict for %Ln clip(s): the file is missing.</source>
        <translation>
            <numerusform>%Ln 個のクリップは判定できません：ファイルがありません。</numerusform>
        </translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>プリセット</translation>
    </message>
    <message numerus="yes">
        <source>The files of %Ln clip(s) have changed.</source>
        <translation>
            <numerusform>%Ln 個のクリップのファイルが変更されました。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The files of %Ln clip(s) are missing. The library&apos;s context menu finds them in another folder.</source>
        <translation>
            <numerusform>%Ln 個のクリップのファイルがありません。ライブラリの右クリックメニューで別のフォルダーから探せます。</numerusform>
        </translation>
    </message>
    <message>
        <source>Find Clips</source>
        <translation>クリップを探す</translation>
    </message>
    <message numerus="yes">
        <source>Found %Ln clip(s)</source>
        <translation>
            <numerusform>%Ln 個のクリップが見つかりました</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %Ln still missing</source>
        <translation>
            <numerusform>、未発見 %Ln 個</numerusform>
        </translation>
    </message>
    <message>
        <source>Paste Settings</source>
        <translation>設定を貼り付け</translation>
    </message>
    <message>
        <source>Paste Importance</source>
        <translation>重要度を貼り付け</translation>
    </message>
    <message numerus="yes">
        <source>%1, %Ln Clip(s)</source>
        <translation>
            <numerusform>%1、クリップ %Ln 件</numerusform>
        </translation>
    </message>
    <message>
        <source>Character</source>
        <translation>キャラクター</translation>
    </message>
    <message>
        <source>The clip&apos;s files changed while it was compressed.</source>
        <translation>圧縮中にファイルが変わりました。</translation>
    </message>
    <message>
        <source>No clip has notes on its frames.</source>
        <translation>フレームにメモのあるクリップはありません。</translation>
    </message>
    <message numerus="yes">
        <source>Wrote the notes of %Ln file(s) beside them.</source>
        <translation>
            <numerusform>%Ln 個のファイルのメモを横に書き出しました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Read Notes</source>
        <translation>メモの読み込み</translation>
    </message>
    <message numerus="yes">
        <source>Read %Ln note(s).</source>
        <translation>
            <numerusform>メモを %Ln 個読み込みました。</numerusform>
        </translation>
    </message>
    <message>
        <source>The files beside the clips have no other notes.</source>
        <translation>クリップの横のファイルに、ほかのメモはありません。</translation>
    </message>
    <message>
        <source>nothing changed by more than 1 %</source>
        <translation>1 % を超える変化はありません</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>%L1 %2</source>
        <comment>number of clips, change</comment>
        <translation>%2 %L1</translation>
    </message>
    <message numerus="yes">
        <source>%Ln clip(s) compared with %1: %2 bytes then, %3 now; %4.</source>
        <translation>
            <numerusform>%Ln 個のクリップを %1 と比較：以前 %2 バイト、現在 %3 バイト。%4。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mocapress::LibraryColumns</name>
    <message>
        <source>loop, last pose repeats the first</source>
        <translation>ループ（最後の姿勢が最初と同じ）</translation>
    </message>
    <message>
        <source>loop</source>
        <translation>ループ</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>クリップ</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>圧縮率</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>バイト数</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>誤差</translation>
    </message>
    <message>
        <source>Worst</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Slide</source>
        <translation>滑り</translation>
    </message>
    <message>
        <source>Eye</source>
        <translation>見え方</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>ループ</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>プリセット</translation>
    </message>
    <message>
        <source>Clip, with its result and verdict</source>
        <translation>クリップとその結果、あなたの判定</translation>
    </message>
    <message>
        <source>Compression ratio of the motion</source>
        <translation>動きが何分の一になったか</translation>
    </message>
    <message>
        <source>Bytes of the compressed motion</source>
        <translation>圧縮した動きのバイト数</translation>
    </message>
    <message>
        <source>Error of the whole clip, eps_x</source>
        <translation>クリップ全体の誤差 eps_x</translation>
    </message>
    <message>
        <source>The largest error of any point at any frame</source>
        <translation>全フレーム全点のうち最大の誤差</translation>
    </message>
    <message>
        <source>Path of feet that stand in the original, summed over all contacts</source>
        <translation>元では立っていた足が滑った距離（全接地の合計）</translation>
    </message>
    <message>
        <source>Visibility of errors</source>
        <translation>目が違いに気づくか</translation>
    </message>
    <message>
        <source>Verdict of the review</source>
        <translation>あなたの判定</translation>
    </message>
    <message>
        <source>Places that were repaired or guessed when the clip was read</source>
        <translation>読み込みで修復や推測をした際の注記</translation>
    </message>
    <message>
        <source>Kind of loop, if the clip is one</source>
        <translation>クリップがループかどうか</translation>
    </message>
    <message>
        <source>Length of the clip in seconds</source>
        <translation>クリップの長さ（秒）</translation>
    </message>
    <message>
        <source>Preset of the clip&apos;s settings</source>
        <translation>設定の元になったプリセット</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>Bytes since</source>
        <translation>以後のバイト</translation>
    </message>
    <message>
        <source>Error since</source>
        <translation>以後の誤差</translation>
    </message>
    <message>
        <source>Changes since</source>
        <translation>以後の変化</translation>
    </message>
    <message>
        <source>Bytes that it has more than in the batch that is compared</source>
        <translation>比較する一括処理より増えたバイト</translation>
    </message>
    <message>
        <source>Error that it has more than in the batch that is compared</source>
        <translation>比較する一括処理より増えた誤差</translation>
    </message>
    <message>
        <source>Changes since the batch that is compared, the gravest first</source>
        <translation>比較する一括処理からの変化（重大な順）</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失敗</translation>
    </message>
    <message>
        <source>newly visible</source>
        <translation>新たに見える</translation>
    </message>
    <message>
        <source>worse</source>
        <translation>悪化</translation>
    </message>
    <message>
        <source>larger</source>
        <translation>増大</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>消滅</translation>
    </message>
    <message>
        <source>added</source>
        <translation>追加</translation>
    </message>
    <message>
        <source>no longer failed</source>
        <translation>失敗が解消</translation>
    </message>
    <message>
        <source>no longer visible</source>
        <translation>見えなくなった</translation>
    </message>
    <message>
        <source>better</source>
        <translation>改善</translation>
    </message>
    <message>
        <source>smaller</source>
        <translation>縮小</translation>
    </message>
</context>
<context>
    <name>mocapress::LibraryFilter</name>
    <message>
        <source>All clips</source>
        <translation>全クリップ</translation>
    </message>
    <message>
        <source>Not reviewed</source>
        <translation>未確認</translation>
    </message>
    <message>
        <source>Approved</source>
        <translation>承認</translation>
    </message>
    <message>
        <source>Rejected</source>
        <translation>却下</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>無効</translation>
    </message>
    <message>
        <source>With warnings</source>
        <translation>警告あり</translation>
    </message>
    <message>
        <source>With visible errors</source>
        <translation>目に見える誤差あり</translation>
    </message>
    <message>
        <source>Not compressed yet</source>
        <translation>未圧縮</translation>
    </message>
    <message>
        <source>Missed or failed</source>
        <translation>未達または失敗</translation>
    </message>
    <message>
        <source>To review</source>
        <translation>レビュー待ち</translation>
    </message>
    <message>
        <source>With notes</source>
        <translation>メモあり</translation>
    </message>
</context>
<context>
    <name>mocapress::LibraryGroups</name>
    <message>
        <source>By folder</source>
        <translation>フォルダー別</translation>
    </message>
    <message>
        <source>By verdict</source>
        <translation>判定別</translation>
    </message>
    <message>
        <source>By visibility</source>
        <translation>見え方別</translation>
    </message>
    <message>
        <source>As a list</source>
        <translation>一覧</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>By %1</source>
        <comment>title of a column</comment>
        <translation>%1別</translation>
    </message>
    <message>
        <source>Without warnings</source>
        <translation>警告なし</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>%1 未満</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1～%2</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>By slide</source>
        <translation>滑り別</translation>
    </message>
    <message>
        <source>By worst error</source>
        <translation>最大誤差別</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
</context>
<context>
    <name>mocapress::LibraryModel</name>
    <message>
        <source>Cannot be read</source>
        <translation>読み込めません</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>読み込み中…</translation>
    </message>
    <message numerus="yes">
        <source>%Ln frame(s)</source>
        <translation>
            <numerusform>%Ln フレーム</numerusform>
        </translation>
    </message>
    <message>
        <source>✓ approved</source>
        <translation>✓ 承認</translation>
    </message>
    <message>
        <source>✕ rejected</source>
        <translation>✕ 却下</translation>
    </message>
    <message>
        <source>target met</source>
        <translation>目標達成</translation>
    </message>
    <message>
        <source>! target missed</source>
        <translation>! 目標未達</translation>
    </message>
    <message>
        <source>! file missing</source>
        <translation>! ファイルなし</translation>
    </message>
    <message>
        <source>! %1</source>
        <translation>! %1</translation>
    </message>
    <message>
        <source>file missing</source>
        <translation>ファイルなし</translation>
    </message>
    <message>
        <source>file changed</source>
        <translation>ファイル変更</translation>
    </message>
    <message>
        <source>settings changed</source>
        <translation>設定変更</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>files not known</source>
        <translation>対象不明</translation>
    </message>
    <message>
        <source>✓ stale: %1</source>
        <translation>✓ 無効：%1</translation>
    </message>
    <message>
        <source>✕ stale: %1</source>
        <translation>✕ 無効：%1</translation>
    </message>
    <message numerus="yes">
        <source>%Ln note(s)</source>
        <translation>
            <numerusform>注記%Ln件</numerusform>
        </translation>
    </message>
    <message>
        <source>! cannot be compressed</source>
        <translation>! 圧縮できません</translation>
    </message>
    <message numerus="yes">
        <source>%Ln clip(s)</source>
        <comment>selected</comment>
        <translation>
            <numerusform>クリップ %Ln 件</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 bytes, %3 before</source>
        <translation>%1：%2 バイト（以前は %3）</translation>
    </message>
    <message>
        <source>%1: %2 bytes</source>
        <translation>%1：%2 バイト</translation>
    </message>
    <message>
        <source>%L1 not compressed yet</source>
        <translation>%L1 件は未圧縮</translation>
    </message>
    <message>
        <source>%1: %2 bytes before, %3</source>
        <translation>%1：以前は %2 バイト、%3</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>take of a file</comment>
        <translation>%1：%2</translation>
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
        <translation>除く</translation>
    </message>
    <message>
        <source>Clips of the project</source>
        <translation>プロジェクトのクリップ</translation>
    </message>
    <message>
        <source>Add motion files to the project. Each keeps its own settings.</source>
        <translation>モーションをプロジェクトに追加。設定はそれぞれに保たれます。</translation>
    </message>
    <message>
        <source>Remove the selected clips from the project; their files stay.</source>
        <translation>選んだクリップをプロジェクトから除きます。ファイルは残ります。</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Not reviewed</source>
        <translation>未確認</translation>
    </message>
    <message>
        <source>Approved</source>
        <translation>承認</translation>
    </message>
    <message>
        <source>Rejected</source>
        <translation>却下</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>Note about this clip</source>
        <translation>このクリップのメモ</translation>
    </message>
    <message>
        <source>The project keeps this note with the verdict.</source>
        <translation>判定とともにプロジェクトに保存されます。</translation>
    </message>
    <message>
        <source>Export Selected, Each with Its Own Settings…</source>
        <translation>選択したクリップをそれぞれの設定で書き出し…</translation>
    </message>
    <message>
        <source>Export All, Each with Its Own Settings…</source>
        <translation>すべてのクリップをそれぞれの設定で書き出し…</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>追加</translation>
    </message>
    <message>
        <source>Filter of the clips</source>
        <translation>クリップの絞り込み</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>絞り込み</translation>
    </message>
    <message>
        <source>&amp;Clips…</source>
        <translation>クリップ(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Folder…</source>
        <translation>フォルダー(&amp;F)…</translation>
    </message>
    <message>
        <source>Verdict on the selected clips, with their present files and settings.</source>
        <translation>選択したクリップの、今のファイルと圧縮についての判定です。</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>プリセット</translation>
    </message>
    <message>
        <source>Find Missing Clips in a Folder…</source>
        <translation>見つからないクリップをフォルダーから探す…</translation>
    </message>
    <message>
        <source>Clips that are shown</source>
        <translation>表示するクリップ</translation>
    </message>
    <message>
        <source>Filter of shown clips</source>
        <translation>どのクリップを表示するか</translation>
    </message>
    <message>
        <source>Groups of the clips</source>
        <translation>クリップのまとめ方</translation>
    </message>
    <message>
        <source>Order and columns</source>
        <translation>並び順と列</translation>
    </message>
    <message>
        <source>What clips are sorted by, and the columns beside them</source>
        <translation>クリップの並び順と、横に示す列</translation>
    </message>
    <message>
        <source>Sort By</source>
        <translation>並べ替え</translation>
    </message>
    <message>
        <source>Order of the Library</source>
        <translation>ライブラリの順</translation>
    </message>
    <message>
        <source>Grouping of clips</source>
        <translation>クリップをどうまとめるか</translation>
    </message>
    <message>
        <source>Copy Settings</source>
        <translation>設定をコピー</translation>
    </message>
    <message>
        <source>Paste Settings</source>
        <translation>設定を貼り付け</translation>
    </message>
    <message>
        <source>Paste Importance Only</source>
        <translation>重要度だけを貼り付け</translation>
    </message>
    <message>
        <source>Put a Character On…</source>
        <translation>キャラクターを着せる…</translation>
    </message>
    <message>
        <source>Take the Character Off</source>
        <translation>キャラクターを外す</translation>
    </message>
    <message>
        <source>Notes on Reading</source>
        <translation>読み込みに関するメモ</translation>
    </message>
    <message>
        <source>Words in a clip&apos;s name, folder or state, such as “walks missed”, and bounds on columns, such as “error&gt;=5mm ratio&lt;20”: lengths without a unit are in cm.</source>
        <translation>クリップの名前、フォルダー、状態に含まれる語（例：「walks 未達」）と、列の範囲（例：「誤差&gt;=5mm 圧縮率&lt;20」）。単位のない長さは cm です。</translation>
    </message>
</context>
<context>
    <name>mocapress::LibraryPlot</name>
    <message>
        <source>Clips of the library, error over ratio</source>
        <translation>ライブラリのクリップ、圧縮率と誤差</translation>
    </message>
    <message>
        <source>The columns of the library show all measurements.</source>
        <translation>数値はすべてライブラリの列にあります。</translation>
    </message>
    <message>
        <source>Compression ratio (smaller files →)</source>
        <translation>圧縮率（ファイルが小さい →）</translation>
    </message>
    <message>
        <source>eps_x (cm)</source>
        <translation>eps_x (cm)</translation>
    </message>
    <message>
        <source>Clips appear here after they are compressed</source>
        <translation>ライブラリのクリップを圧縮するとここに表示されます</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>不明</translation>
    </message>
</context>
<context>
    <name>mocapress::LibraryTree</name>
    <message numerus="yes">
        <source>%Ln clip(s)</source>
        <translation>
            <numerusform>クリップ %Ln 個</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %L2 missed</source>
        <translation>%1、未達 %L2</translation>
    </message>
</context>
<context>
    <name>mocapress::LibraryViews</name>
    <message>
        <source>Add Clips</source>
        <translation>クリップを追加</translation>
    </message>
    <message>
        <source>Motion (%1)</source>
        <translation>モーション (%1)</translation>
    </message>
    <message>
        <source>Add Folder</source>
        <translation>フォルダーの追加</translation>
    </message>
    <message>
        <source>Find Missing Clips</source>
        <translation>見つからないクリップを探す</translation>
    </message>
    <message>
        <source>Put a Character On</source>
        <translation>キャラクターを着せる</translation>
    </message>
    <message>
        <source>Characters (*.fbx *.glb *.gltf *.vrm)</source>
        <translation>キャラクター (*.fbx *.glb *.gltf *.vrm)</translation>
    </message>
    <message>
        <source>This is the last clip that waits for a verdict.</source>
        <translation>判定待ちのクリップはこれが最後です。</translation>
    </message>
    <message>
        <source>No clip that is shown waits for a verdict.</source>
        <translation>表示中のクリップに判定待ちはありません。</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Compare Library with a Batch</source>
        <translation>ライブラリを一括処理と比較</translation>
    </message>
    <message>
        <source>Batches and projects (batch*.jsonl report*.json report*.html *.mocapress)</source>
        <translation>一括処理とプロジェクト (batch*.jsonl report*.json report*.html *.mocapress)</translation>
    </message>
</context>
<context>
    <name>mocapress::MainWindow</name>
    <message>
        <source>The language changes when Mocapress is started again.</source>
        <translation>言語はMocapressの次回起動時に変わります。</translation>
    </message>
    <message>
        <source>%1[*] – %2</source>
        <translation>%1[*] – %2</translation>
    </message>
    <message>
        <source>Your own limits of visibility are not used: %1</source>
        <translation>自分の見え方の限界値は使われません：%1</translation>
    </message>
</context>
<context>
    <name>mocapress::MessageBar</name>
    <message>
        <source>Message</source>
        <translation>メッセージ</translation>
    </message>
    <message>
        <source>Close message</source>
        <translation>メッセージを閉じる</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Possible solution</source>
        <translation>対処</translation>
    </message>
    <message>
        <source>Work in progress</source>
        <translation>処理中です</translation>
    </message>
</context>
<context>
    <name>mocapress::Methods</name>
    <message>
        <source>Closed-loop wavelets</source>
        <translation>閉ループのウェーブレット</translation>
    </message>
    <message>
        <source>Annealed wavelets</source>
        <translation>焼きなましのウェーブレット</translation>
    </message>
    <message>
        <source>Standard wavelets</source>
        <translation>標準のウェーブレット</translation>
    </message>
    <message>
        <source>Per-channel wavelets</source>
        <translation>チャンネル別のウェーブレット</translation>
    </message>
    <message>
        <source>Haar wavelets</source>
        <translation>ハールウェーブレット</translation>
    </message>
    <message>
        <source>Linear wavelets</source>
        <translation>線形ウェーブレット</translation>
    </message>
    <message>
        <source>PCA</source>
        <translation>主成分分析 (PCA)</translation>
    </message>
    <message>
        <source>Frame subsampling</source>
        <translation>フレーム間引き</translation>
    </message>
    <message>
        <source>Quaternion wavelets</source>
        <translation>四元数ウェーブレット</translation>
    </message>
    <message>
        <source>Segment PCA, after Liu &amp; McMillan</source>
        <translation>区間別 PCA (Liu と McMillan による)</translation>
    </message>
    <message>
        <source>Clustered PCA, after Arikan</source>
        <translation>クラスタ別 PCA (Arikan による)</translation>
    </message>
    <message>
        <source>%1 + IK %L2:1</source>
        <translation>%1 + IK %L2:1</translation>
    </message>
    <message>
        <source>Key frames per track</source>
        <translation>トラックごとのキーフレーム</translation>
    </message>
</context>
<context>
    <name>mocapress::Names</name>
    <message>
        <source>16-bit runs</source>
        <translation>16ビット連長</translation>
    </message>
    <message>
        <source>16-bit runs + DEFLATE</source>
        <translation>16ビット連長＋DEFLATE</translation>
    </message>
    <message>
        <source>Adaptive</source>
        <translation>適応</translation>
    </message>
    <message>
        <source>Bone ends</source>
        <translation>骨の先端</translation>
    </message>
    <message>
        <source>Joint origins</source>
        <translation>関節の原点</translation>
    </message>
    <message>
        <source>Every frame</source>
        <translation>全フレーム</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>接地</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>体表</translation>
    </message>
    <message>
        <source>Shell</source>
        <translation>シェル</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>スキン</translation>
    </message>
</context>
<context>
    <name>mocapress::NoteStrip</name>
    <message>
        <source>Notes on frames</source>
        <translation>フレームのメモ</translation>
    </message>
    <message>
        <source>The menu Review adds a note and goes from one to the next.</source>
        <translation>レビューメニューでメモの追加と移動ができます。</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>A click on a mark goes to its frame and joint; the right button edits or removes the note.</source>
        <translation>印をクリックするとそのフレームと関節へ移ります。右ボタンでメモを編集・削除できます。</translation>
    </message>
    <message>
        <source>Edit Note…</source>
        <translation>メモを編集…</translation>
    </message>
    <message>
        <source>Remove Note</source>
        <translation>メモを削除</translation>
    </message>
</context>
<context>
    <name>mocapress::Notices</name>
    <message numerus="yes">
        <source>The last session ended unexpectedly. Its project was restored: %Ln clip(s).</source>
        <translation>
            <numerusform>前回は予期せず終了しました。プロジェクトを復元しました：%Ln クリップ。</numerusform>
        </translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 を保存しました。</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>%1 を開いています…</translation>
    </message>
    <message>
        <source>Exported %1.</source>
        <translation>%1 を書き出しました。</translation>
    </message>
</context>
<context>
    <name>mocapress::OpenClip</name>
    <message>
        <source>%1 is not the original of the compressed clip: joints, frames or sample rate differ.</source>
        <translation>%1 は圧縮クリップの元ではありません：関節、フレーム数、サンプルレートのいずれかが違います。</translation>
    </message>
</context>
<context>
    <name>mocapress::Overlay</name>
    <message>
        <source>Original</source>
        <translation>元</translation>
    </message>
    <message>
        <source>Compressed</source>
        <translation>圧縮後</translation>
    </message>
    <message>
        <source>Difference × %L1</source>
        <translation>差 × %L1</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>側面</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>上面</translation>
    </message>
</context>
<context>
    <name>mocapress::Panels</name>
    <message>
        <source>Library</source>
        <translation>ライブラリ</translation>
    </message>
    <message>
        <source>Compression</source>
        <translation>圧縮</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>関節</translation>
    </message>
    <message>
        <source>Footskate</source>
        <translation>足滑り</translation>
    </message>
    <message>
        <source>Error over time</source>
        <translation>誤差の時間変化</translation>
    </message>
    <message>
        <source>Heat map</source>
        <translation>ヒートマップ</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>チャンネル</translation>
    </message>
    <message>
        <source>Rate-distortion</source>
        <translation>レート歪み</translation>
    </message>
    <message>
        <source>Importance</source>
        <translation>重要度</translation>
    </message>
    <message>
        <source>Pinned</source>
        <translation>ピン留め</translation>
    </message>
    <message>
        <source>All clips</source>
        <translation>全クリップ</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>バイト</translation>
    </message>
</context>
<context>
    <name>mocapress::PartNames</name>
    <message>
        <source>Clear</source>
        <translation>消去</translation>
    </message>
    <message>
        <source>More tools</source>
        <translation>ほかのツール</translation>
    </message>
</context>
<context>
    <name>mocapress::PinnedModel</name>
    <message>
        <source>Result</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>Double click to give it another name.</source>
        <translation>ダブルクリックで名前を変更します。</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>圧縮率</translation>
    </message>
    <message>
        <source>Compression ratio</source>
        <translation>圧縮率</translation>
    </message>
    <message>
        <source>Weighted root mean square distance from the original.</source>
        <translation>オリジナルからの重み付き二乗平均平方根距離。</translation>
    </message>
    <message>
        <source>95 % of all points at all frames have at most this error.</source>
        <translation>すべての点とフレームの 95 % がこの範囲に入ります。</translation>
    </message>
    <message>
        <source>Largest error of any point at any frame.</source>
        <translation>全フレーム、全点での最大距離。</translation>
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
        <translation>最大</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>ずれ</translation>
    </message>
    <message>
        <source>Largest distance between a standing foot and its place in the original.</source>
        <translation>足が本来の接地位置から最も離れる距離。</translation>
    </message>
</context>
<context>
    <name>mocapress::PinnedPanel</name>
    <message>
        <source>Pin This</source>
        <translation>ピン留め</translation>
    </message>
    <message>
        <source>Make Current</source>
        <translation>現在の設定に</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>外す</translation>
    </message>
    <message>
        <source>Pinned results</source>
        <translation>ピン留めした結果</translation>
    </message>
    <message>
        <source>Keep the current result in the view, as a figure with its own colour, while you try other settings.</source>
        <translation>ほかの設定を試す間、現在の結果を独自の色の人形として表示し続けます。</translation>
    </message>
    <message>
        <source>Use the settings of the selected result. This can be undone.</source>
        <translation>選んだ結果の設定から続けます。元に戻せます。</translation>
    </message>
    <message>
        <source>Remove the selected result from the view.</source>
        <translation>選んだ結果を表示から外します。</translation>
    </message>
</context>
<context>
    <name>mocapress::PinnedResults</name>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>ピン留め</translation>
    </message>
    <message>
        <source>Take Off a Pin</source>
        <translation>ピンを外す</translation>
    </message>
    <message>
        <source>Name of a Pin</source>
        <translation>ピンの名前</translation>
    </message>
    <message>
        <source>%1 (%L2)</source>
        <translation>%1 (%L2)</translation>
    </message>
    <message>
        <source>The result is not final yet, or four are pinned.</source>
        <translation>結果がまだ確定していないか、すでに4つピン留めされています。</translation>
    </message>
    <message>
        <source>Four results are pinned already.</source>
        <translation>すでに4つの結果がピン留めされています。</translation>
    </message>
</context>
<context>
    <name>mocapress::Plots</name>
    <message>
        <source>Copy Image</source>
        <translation>画像をコピー</translation>
    </message>
</context>
<context>
    <name>mocapress::PoseStrip</name>
    <message>
        <source>Poses over time</source>
        <translation>時間に沿ったポーズ</translation>
    </message>
    <message>
        <source>Poses of the clip along the time; a click goes there.</source>
        <translation>時間に沿ったクリップのポーズ。クリックするとそこへ移動します。</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>ポーズ</translation>
    </message>
</context>
<context>
    <name>mocapress::Presenter</name>
    <message>
        <source>This method cannot reach the target for this clip.</source>
        <translation>このクリップではこの手法で到達できません。</translation>
    </message>
</context>
<context>
    <name>mocapress::PresetChooser</name>
    <message>
        <source>Preset</source>
        <translation>プリセット</translation>
    </message>
    <message>
        <source>A preset sets target, method, importance, effort and IK. Your own presets are kept in the settings of this program.</source>
        <translation>ひとまとまりの設定。目標、手法、重要度、労力、IK。自分のプリセットはこのプログラムの設定と一緒に保存されます。</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>プリセット</translation>
    </message>
    <message>
        <source>Keep, share and remove presets of your own</source>
        <translation>自分のプリセットの保存・共有・削除</translation>
    </message>
    <message>
        <source>Save as Preset…</source>
        <translation>プリセットとして保存…</translation>
    </message>
    <message>
        <source>Rename Preset…</source>
        <translation>プリセットの名前を変更…</translation>
    </message>
    <message>
        <source>Remove Preset</source>
        <translation>プリセットを削除</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>読み込み…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>書き出し…</translation>
    </message>
    <message>
        <source>Custom settings</source>
        <translation>独自の設定</translation>
    </message>
    <message>
        <source>%1, modified</source>
        <translation>%1(変更あり)</translation>
    </message>
</context>
<context>
    <name>mocapress::PresetEditor</name>
    <message>
        <source>Hold feet by inverse kinematics</source>
        <translation>逆運動学で足を固定する</translation>
    </message>
    <message>
        <source>Kind of target</source>
        <translation>求めるもの</translation>
    </message>
    <message>
        <source>Error, eps_x</source>
        <translation>誤差 eps_x</translation>
    </message>
    <message>
        <source>Hard maximum</source>
        <translation>絶対的な上限</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>圧縮率</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>バイト</translation>
    </message>
    <message>
        <source>Coefficient ratio</source>
        <translation>係数比</translation>
    </message>
    <message>
        <source>Value of the target</source>
        <translation>その量</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>手法</translation>
    </message>
    <message>
        <source>Keeps standing feet in place, for some more bytes.</source>
        <translation>足は元の位置に留まります。バイト数は少し増えます。</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>:1</source>
        <translation>:1</translation>
    </message>
    <message>
        <source> bytes</source>
        <translation> バイト</translation>
    </message>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source>Visibility</source>
        <translation>視認性</translation>
    </message>
    <message>
        <source>Error, eps_x: the weighted root mean square error; single frames may exceed it. Hard maximum: largest error of any point of the body at any frame. Visibility: largest error as a multiple of what people notice; at 1, no error is visible. Quality targets suit all kinds of clips; ratio and bytes ignore how hard a clip is to compress.</source>
        <translation>eps_x: 重み付き二乗平均平方根誤差。個々のフレームでは超えることがあります。絶対的な上限: どのフレームでも体のどの点もこれ以上離れません。視認性: どのずれも、人が気づく差のこの倍数を超えません。1 なら何も見えません。品質の目標はどんなクリップにも向きます。圧縮率とバイト数はクリップの難しさを知りません。</translation>
    </message>
    <message>
        <source> times</source>
        <translation> 倍</translation>
    </message>
    <message>
        <source>Weighting</source>
        <translation>重み付け</translation>
    </message>
    <message>
        <source>Points on which the error eps_x is measured. Surface: a body modelled around the bones, so that turned heads and hands count. Skin: the mesh of the clip or of the batch&apos;s character; clips without a mesh are refused. Shell: three points 3 cm from every joint, as in ACL. Bone ends and joint origins: points on the bones, weighted by bone length; joint origins are the paper&apos;s.</source>
        <translation>誤差 eps_x が数える点です。体表：骨の周りに作った体の表面の点。頭や手の回転も数えます。スキン：クリップ、または一括処理のキャラクターのメッシュ上の点。メッシュのないクリップは拒否されます。シェル：ACL と同じく、各関節から 3 cm の三点。骨の先端と関節原点：骨の長さで重み付けした骨上の点で、後者は論文のものです。</translation>
    </message>
</context>
<context>
    <name>mocapress::PresetShelf</name>
    <message>
        <source>This is the name of a built-in preset. Choose another name.</source>
        <translation>組み込みプリセットの名前は他に使えません。</translation>
    </message>
    <message>
        <source>Save Preset</source>
        <translation>プリセットを保存</translation>
    </message>
    <message>
        <source>There is a preset %1 already.</source>
        <translation>プリセット %1 はすでにあります。</translation>
    </message>
    <message>
        <source>Rename Preset</source>
        <translation>プリセットの名前を変更</translation>
    </message>
    <message>
        <source>Remove Preset</source>
        <translation>プリセットを削除</translation>
    </message>
    <message>
        <source>Import Presets</source>
        <translation>プリセットの読み込み</translation>
    </message>
    <message>
        <source>Wrote %1.</source>
        <translation>%1 を書きました。</translation>
    </message>
    <message>
        <source>Presets could not be kept: %1</source>
        <translation>プリセットを保存できませんでした: %1</translation>
    </message>
    <message>
        <source>The presets could not be read; their file was renamed to %1.</source>
        <translation>これまでのプリセットは読めませんでした。そのファイルは%1になりました。</translation>
    </message>
</context>
<context>
    <name>mocapress::PresetViews</name>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Rename Preset</source>
        <translation>プリセットの名前を変更</translation>
    </message>
    <message>
        <source>Import Presets</source>
        <translation>プリセットの読み込み</translation>
    </message>
    <message>
        <source>Presets (*.json)</source>
        <translation>プリセット (*.json)</translation>
    </message>
    <message>
        <source>Export Preset</source>
        <translation>プリセットの書き出し</translation>
    </message>
    <message>
        <source>Save as Preset</source>
        <translation>プリセットとして保存</translation>
    </message>
    <message>
        <source>Save Preset</source>
        <translation>プリセットを保存</translation>
    </message>
</context>
<context>
    <name>mocapress::Presets</name>
    <message>
        <source>Hero close-up</source>
        <translation>主役のクローズアップ</translation>
    </message>
    <message>
        <source>Gameplay</source>
        <translation>ゲームプレイ</translation>
    </message>
    <message>
        <source>Crowd</source>
        <translation>群衆</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>保管</translation>
    </message>
    <message>
        <source>For archives that replace the source: no point of the body&apos;s surface has an error above 1 mm at any frame.</source>
        <translation>元データの代わりに保管：どのフレームでも、体表のどの点も誤差が 1 mm を超えません。</translation>
    </message>
    <message>
        <source>Planted feet</source>
        <translation>滑らない足</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>足</translation>
    </message>
    <message>
        <source>Hands</source>
        <translation>手</translation>
    </message>
    <message>
        <source>Fingers</source>
        <translation>指</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>頭</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>下書き</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>標準</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>最良</translation>
    </message>
    <message>
        <source>%1 × %L2</source>
        <translation>%1 × %L2</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>接地</translation>
    </message>
    <message>
        <source>Importance: %1.</source>
        <translation>重要度: %1。</translation>
    </message>
    <message>
        <source>Effort: %1.</source>
        <translation>労力: %1。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln contact(s) of its own.</source>
        <translation>
            <numerusform>独自の接地 %Ln 個。</numerusform>
        </translation>
    </message>
    <message>
        <source>Characters in play: an error of 2.5 mm on the body&apos;s surface, at most 2.5 degrees of heads and 4 of hands.</source>
        <translation>操作中の人物：体表の誤差 2.5 mm、頭の回転は最大 2.5 度、手は 4 度。</translation>
    </message>
    <message>
        <source>Characters near the camera: an error of 0.65 mm on the body&apos;s surface, about a degree of heads and hands.</source>
        <translation>カメラが近づく人物：体表の誤差 0.65 mm、頭と手の回転は最大でも約 1 度。</translation>
    </message>
    <message>
        <source>Figures in the background: an error of 6 mm on the body&apos;s surface, at most 7.5 degrees of heads and 12 of hands.</source>
        <translation>背景の人物：体表の誤差 6 mm、頭の回転は最大 7.5 度、手は 12 度。</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>自由</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>均等</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>厳密</translation>
    </message>
    <message>
        <source>Ends: %1.</source>
        <translation>両端：%1。</translation>
    </message>
    <message>
        <source>Like Gameplay, with much less sliding of feet, for 5 to 13 % more bytes.</source>
        <translation>ゲームプレイと同じで、足は立った位置にとどまります：滑りはずっと少なく、バイト数は 5～13 % 増えます。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln range(s) with more care.</source>
        <translation>
            <numerusform>重視する範囲 %Ln 個。</numerusform>
        </translation>
    </message>
    <message>
        <source>Watched from %L1 m.</source>
        <translation>%L1 m から見ます。</translation>
    </message>
</context>
<context>
    <name>mocapress::ProjectFiles</name>
    <message>
        <source>Mocapress projects (*.mocapress)</source>
        <translation>Mocapressプロジェクト (*.mocapress)</translation>
    </message>
    <message>
        <source>Unnamed Project</source>
        <translation>名前のないプロジェクト</translation>
    </message>
    <message>
        <source>Open Project</source>
        <translation>プロジェクトを開く</translation>
    </message>
    <message>
        <source>Save Project</source>
        <translation>プロジェクトを保存</translation>
    </message>
    <message numerus="yes">
        <source>Save the project of %Ln clip(s) under a name?</source>
        <translation>
            <numerusform>%Ln個のクリップのプロジェクトに名前を付けて保存しますか?</numerusform>
        </translation>
    </message>
    <message>
        <source>A project without a name stays in File &gt; Recent Projects, under its date.</source>
        <translation>名前がなくても、日時とともに「ファイル &gt; 最近のプロジェクト」に残ります。</translation>
    </message>
    <message>
        <source>&amp;Keep It Unnamed</source>
        <translation>名前なしで残す(&amp;K)</translation>
    </message>
    <message>
        <source>Project Not Written</source>
        <translation>プロジェクトが書き込まれていません</translation>
    </message>
    <message>
        <source>The last changes of the project cannot be written. Quit without them?</source>
        <translation>プロジェクトの最後の変更を書き込めません。変更を残さずに終了しますか?</translation>
    </message>
    <message>
        <source>Use Save Project As to save them to another file.</source>
        <translation>「プロジェクトを保存」で別の場所に残せます。</translation>
    </message>
    <message>
        <source>Project in Use</source>
        <translation>使用中のプロジェクト</translation>
    </message>
    <message>
        <source>If Mocapress has ended there, the project can be taken over. If not, each would overwrite the other&apos;s work.</source>
        <translation>そこでMocapressが終了していれば、プロジェクトを引き継げます。終了していなければ、互いの作業を上書きしてしまいます。</translation>
    </message>
    <message>
        <source>Take Over</source>
        <translation>引き継ぐ</translation>
    </message>
    <message>
        <source>Unnamed, %1</source>
        <translation>名前なし、%1</translation>
    </message>
    <message numerus="yes">
        <source>%1, %Ln clip(s)</source>
        <translation>
            <numerusform>%1、クリップ%Ln個</numerusform>
        </translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>%1. Open a copy of it?</source>
        <translation>%1。コピーを開きますか？</translation>
    </message>
</context>
<context>
    <name>mocapress::RangeActions</name>
    <message>
        <source>More &amp;Care in the Range</source>
        <translation>範囲をより忠実に(&amp;C)</translation>
    </message>
    <message>
        <source>C&amp;ontacts in the Range</source>
        <translation>範囲内の接地(&amp;O)</translation>
    </message>
    <message>
        <source>The Clip as a Loo&amp;p</source>
        <translation>クリップのループ(&amp;P)</translation>
    </message>
    <message>
        <source>As &amp;elsewhere</source>
        <translation>ほかと同じ(&amp;E)</translation>
    </message>
    <message>
        <source>The target is a size: the other frames get worse</source>
        <translation>目標がサイズなので、ほかのフレームは粗くなります</translation>
    </message>
    <message>
        <source>%1 times stricter</source>
        <translation>%1 倍厳しく</translation>
    </message>
    <message>
        <source>%1 stands</source>
        <translation>%1 は接地</translation>
    </message>
    <message>
        <source>%1 is in the air</source>
        <translation>%1 は空中</translation>
    </message>
    <message>
        <source>No foot stands in this clip</source>
        <translation>このクリップでは足が接地しません</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation>自動判定(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Not a loop</source>
        <translation>ループではない(&amp;N)</translation>
    </message>
    <message>
        <source>The last frame &amp;repeats the first</source>
        <translation>最終フレームが先頭を繰り返す(&amp;R)</translation>
    </message>
    <message>
        <source>The first frame follo&amp;ws the last</source>
        <translation>先頭が最終フレームに続く(&amp;W)</translation>
    </message>
    <message>
        <source>First choose a range: drag along the ruler of the timeline</source>
        <translation>先に範囲を選んでください：タイムラインの目盛りをドラッグします</translation>
    </message>
    <message>
        <source>First open a clip</source>
        <translation>先にクリップを開いてください</translation>
    </message>
</context>
<context>
    <name>mocapress::RatePlot</name>
    <message>
        <source>Rate-distortion plot</source>
        <translation>レート歪みプロット</translation>
    </message>
    <message>
        <source>Error over compression ratio, one curve for each method. The table below lists every point.</source>
        <translation>圧縮率に対する誤差、手法ごとに1本の曲線。下の表に全点があります。</translation>
    </message>
    <message>
        <source>Compression ratio (smaller files →)</source>
        <translation>圧縮率(ファイルが小さい →)</translation>
    </message>
    <message>
        <source>current result</source>
        <translation>現在地</translation>
    </message>
    <message>
        <source>eps_x (cm), %1</source>
        <translation>eps_x (cm)、%1</translation>
    </message>
</context>
<context>
    <name>mocapress::Report</name>
    <message>
        <source>approved</source>
        <translation>承認</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>却下</translation>
    </message>
    <message>
        <source>the clip&apos;s file changed</source>
        <translation>クリップのファイルが変わりました</translation>
    </message>
    <message>
        <source>the settings changed</source>
        <translation>設定が変わりました</translation>
    </message>
    <message>
        <source>the clip&apos;s file and the settings changed</source>
        <translation>クリップのファイルと設定が変わりました</translation>
    </message>
    <message>
        <source>it does not say which file and settings were reviewed</source>
        <translation>どのファイルと設定をレビューしたか記録がありません</translation>
    </message>
    <message>
        <source>the file is missing</source>
        <translation>ファイルがありません</translation>
    </message>
    <message>
        <source>not visible</source>
        <translation>見えない</translation>
    </message>
    <message>
        <source>borderline</source>
        <translation>境界</translation>
    </message>
    <message>
        <source>visible</source>
        <translation>見える</translation>
    </message>
    <message>
        <source>Sign-off</source>
        <translation>承認レポート</translation>
    </message>
    <message>
        <source>Sign-off: %1</source>
        <translation>承認レポート：%1</translation>
    </message>
    <message>
        <source>%1 of %2 reviewed: %3 approved, %4 rejected</source>
        <translation>%2 個中 %1 個レビュー済み：承認 %3、却下 %4</translation>
    </message>
    <message>
        <source>; %1 verdicts stale</source>
        <translation>、無効な判定 %1</translation>
    </message>
    <message>
        <source>; %1 without a verdict</source>
        <translation>、判定なし %1</translation>
    </message>
    <message>
        <source>Worst frames</source>
        <translation>最悪のフレーム</translation>
    </message>
    <message>
        <source>Every clip</source>
        <translation>すべてのクリップ</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>クリップ</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>error, cm</source>
        <translation>誤差 cm</translation>
    </message>
    <message>
        <source>largest, cm</source>
        <translation>最大 cm</translation>
    </message>
    <message>
        <source>point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>関節</translation>
    </message>
    <message>
        <source>note</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>by</source>
        <translation>レビュー担当</translation>
    </message>
    <message>
        <source>when</source>
        <translation>日時</translation>
    </message>
    <message>
        <source>stale</source>
        <translation>無効</translation>
    </message>
    <message>
        <source>eye</source>
        <translation>見え方</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>圧縮率</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>バイト</translation>
    </message>
    <message>
        <source>A verdict or note is stale if the clip&apos;s file or its settings have changed since; stale verdicts do not count as reviewed. Links open the clip in Mocapress on this computer.</source>
        <translation>判定やメモは、その後にクリップのファイルや設定が変わると無効になります。無効な判定はレビュー済みに数えません。リンクはこのコンピューターの Mocapress でクリップを開きます。</translation>
    </message>
    <message>
        <source>%1 from %2 m</source>
        <translation>%2 m から%1</translation>
    </message>
    <message>
        <source>built-in limits</source>
        <translation>組み込みの限界値</translation>
    </message>
    <message>
        <source>The eye judges from the viewing distance that is named, by %1.</source>
        <translation>見え方は、示した視距離から、%1で判定します。</translation>
    </message>
    <message>
        <source>own limits: %1</source>
        <translation>自分の限界値：%1</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 または %2</translation>
    </message>
    <message>
        <source>The frame with the largest error of each clip, the largest first.</source>
        <translation>各クリップで誤差が最大のフレームを、大きい順に示します。</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>フレーム %1</translation>
    </message>
    <message>
        <source>frames %1</source>
        <translation>フレーム %1</translation>
    </message>
    <message>
        <source>stale: %1</source>
        <translation>無効：%1</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>largest error %1 cm</source>
        <translation>最大誤差 %1 cm</translation>
    </message>
    <message>
        <source>errors %1, by %2</source>
        <translation>誤差：%1（%2による）</translation>
    </message>
    <message>
        <source>%1 of %2 at frame %3: %4, noticed from %5</source>
        <translation>%1、%2、フレーム %3：%4（%5から気づく）</translation>
    </message>
    <message>
        <source>The viewer needs JavaScript.</source>
        <translation>ビューアーには JavaScript が必要です。</translation>
    </message>
    <message>
        <source>View</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>%1 cannot be shown: %2</source>
        <translation>%1 を表示できません：%2</translation>
    </message>
    <message>
        <source>%1 cannot be loaded</source>
        <translation>%1 を読み込めません</translation>
    </message>
    <message>
        <source>Previous clip</source>
        <translation>前のクリップ</translation>
    </message>
    <message>
        <source>Next clip</source>
        <translation>次のクリップ</translation>
    </message>
    <message>
        <source>Loading</source>
        <translation>読み込み中</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>Key: %1</source>
        <translation>キー：%1</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>重ねる</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>並べる</translation>
    </message>
    <message>
        <source>Wipe</source>
        <translation>ワイプ</translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>入れ替え</translation>
    </message>
    <message>
        <source>Original</source>
        <translation>元</translation>
    </message>
    <message>
        <source>Compressed</source>
        <translation>圧縮後</translation>
    </message>
    <message>
        <source>Colour by error</source>
        <translation>誤差で色分け</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>追従</translation>
    </message>
    <message>
        <source>Worst frame before</source>
        <translation>前の最悪フレーム</translation>
    </message>
    <message>
        <source>Next worst frame</source>
        <translation>次の最悪フレーム</translation>
    </message>
    <message>
        <source>Reset camera</source>
        <translation>カメラをリセット</translation>
    </message>
    <message>
        <source>Frame %1 of %2, %3 s.</source>
        <translation>フレーム %1 / %2、%3 秒。</translation>
    </message>
    <message>
        <source>On the bones, %1 is %2 cm off.</source>
        <translation>骨の上では、%1 のずれは %2 cm。</translation>
    </message>
    <message>
        <source>The lightest colour is %1 cm.</source>
        <translation>最も明るい色は %1 cm。</translation>
    </message>
    <message>
        <source>%1 to %2 s: %3</source>
        <translation>%1～%2 秒：%3</translation>
    </message>
    <message>
        <source>any</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>Rows are joints, the first row is any joint. A full bar marks times with visible errors, half a bar borderline ones, no bar errors that nobody sees.</source>
        <translation>各行は関節で、最初の行はすべての関節です。全高の棒は誤差が見える時間、半分の棒は境界の時間を示します。棒のない時間の誤差は誰にも見えません。</translation>
    </message>
    <message>
        <source>compression ratio %1 smaller</source>
        <translation>圧縮率 %1 小さいファイル</translation>
    </message>
    <message>
        <source>%1: %2 cm at %3</source>
        <translation>%1：%3 で %2 cm</translation>
    </message>
    <message>
        <source>Batch export</source>
        <translation>一括書き出し</translation>
    </message>
    <message>
        <source>Errors from 1 to 2 times the noticeable size are borderline, larger ones visible. Each clip is judged from the viewing distance that its verdict names, by %1. report.csv lists distance and own limits of each clip.</source>
        <translation>気づく大きさの 1～2 倍の誤差は境界、それより大きい誤差は見えるものとします。各クリップは判定に示した視距離から、%1で判定します。report.csv に各クリップの距離と自分の限界値があります。</translation>
    </message>
    <message>
        <source>clips with visible errors</source>
        <translation>誤差が見えるクリップ</translation>
    </message>
    <message>
        <source>clips with borderline errors</source>
        <translation>誤差が境界のクリップ</translation>
    </message>
    <message>
        <source>without visible errors</source>
        <translation>誤差が見えないクリップ</translation>
    </message>
    <message>
        <source>clips done, each read back and measured</source>
        <translation>完了したクリップ（読み直して測定済み）</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失敗</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>reviewed: %1 approved, %2 rejected</source>
        <translation>レビュー済み：承認 %1、却下 %2</translation>
    </message>
    <message>
        <source>stale verdicts</source>
        <translation>無効な判定</translation>
    </message>
    <message>
        <source>still waiting</source>
        <translation>待機中</translation>
    </message>
    <message>
        <source>compression ratio of all clips together: %1 KB to %2 KB</source>
        <translation>全クリップを合わせた圧縮率：%1 KB から %2 KB</translation>
    </message>
    <message>
        <source>largest error of any point at any frame; largest %1 %2 cm</source>
        <translation>すべての点とフレームでの最大誤差。%1 の最大は %2 cm</translation>
    </message>
    <message>
        <source>%1 over its original at its worst frame</source>
        <translation>最悪のフレームでの %1 と元の動き</translation>
    </message>
    <message>
        <source>%1, %2 s: error of %3 cm at the %4.</source>
        <translation>%1、%2 秒：誤差 %3 cm、%4。</translation>
    </message>
    <message>
        <source>The frame with the largest error of each of the clips whose errors are most visible: original in grey, compressed in red.</source>
        <translation>誤差が最も見えるクリップの、誤差が最大のフレームです。元の動きは灰色、圧縮後は赤です。</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>失敗</translation>
    </message>
    <message>
        <source>No file was written for these clips; older files of theirs are unchanged.</source>
        <translation>これらのクリップのファイルは書き出されていません。以前のファイルはそのままです。</translation>
    </message>
    <message>
        <source>preset</source>
        <translation>プリセット</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>理由</translation>
    </message>
    <message>
        <source>feet held</source>
        <translation>足を固定</translation>
    </message>
    <message>
        <source>Errors of the file as read back from the disk, against the original: distances in centimetres, rotation errors of joints, head and hands in degrees.</source>
        <translation>ディスクから読み直したファイルの、元の動きに対する誤差です。距離はセンチメートル、関節・頭・手の回転誤差は度です。</translation>
    </message>
    <message>
        <source>visibility</source>
        <translation>見え方</translation>
    </message>
    <message>
        <source>warnings</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>max</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>at frame</source>
        <translation>フレーム位置</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>関節</translation>
    </message>
    <message>
        <source>head</source>
        <translation>頭</translation>
    </message>
    <message>
        <source>hands</source>
        <translation>手</translation>
    </message>
    <message>
        <source>foot drift</source>
        <translation>足のずれ</translation>
    </message>
    <message>
        <source>worst drift</source>
        <translation>最大のずれ</translation>
    </message>
    <message>
        <source>foot path</source>
        <translation>足の軌跡</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>フレーム数</translation>
    </message>
    <message>
        <source>asked</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>method</source>
        <translation>方式</translation>
    </message>
    <message>
        <source>The charts show the %1 clips with the most visible errors, out of %2.</source>
        <translation>グラフは %2 個中、誤差が最も見える %1 個のクリップです。</translation>
    </message>
    <message>
        <source>Visible errors over time</source>
        <translation>時間ごとの見える誤差</translation>
    </message>
    <message>
        <source>%1: visible errors over time</source>
        <translation>%1：時間ごとの見える誤差</translation>
    </message>
    <message>
        <source>Repaired or guessed on reading</source>
        <translation>読み込み時の修復と推定</translation>
    </message>
    <message>
        <source>report.csv lists each warning with its file and line.</source>
        <translation>report.csv に各警告のファイルと行があります。</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>count</source>
        <translation>件数</translation>
    </message>
    <message>
        <source>clips</source>
        <translation>クリップ</translation>
    </message>
    <message>
        <source>Verified</source>
        <translation>検証</translation>
    </message>
    <message>
        <source>Each file was read back and decoded as an engine would, by the runtime decoder within its default limits; errors are those of the decoded motion. Engines cannot play files in the paper&apos;s codings and of comparison methods: the library decodes these. The column verified_by of report.csv names the decoder of each clip.</source>
        <translation>各ファイルを読み直し、エンジンと同じくランタイムのデコーダーで既定の制限内でデコードしました。誤差はデコードした動きのものです。論文の符号化と比較用の方式はエンジンでは再生できず、ライブラリーがデコードします。report.csv の列 verified_by に各クリップのデコーダーがあります。</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>圧縮率</translation>
    </message>
    <message>
        <source>Bytes of the channels as 32-bit floats, divided by the bytes of the coded motion. The skeleton counts on neither side. 1 KB = 1024 bytes.</source>
        <translation>32 ビット浮動小数点でのチャンネルのバイト数を、符号化した動きのバイト数で割ったものです。スケルトンはどちらにも数えません。1 KB = 1024 バイト。</translation>
    </message>
    <message>
        <source>Weighted root mean square distance between points of the body and the same points of the original. report.csv has it in two more weightings.</source>
        <translation>体の点と元の同じ点の距離の、重み付き二乗平均平方根です。report.csv にはほかに 2 通りの重み付けの値があります。</translation>
    </message>
    <message>
        <source>p95, p99, max</source>
        <translation>p95、p99、最大</translation>
    </message>
    <message>
        <source>Percentiles and maximum of these distances over all points and frames, unweighted.</source>
        <translation>すべての点とフレームでの、これらの距離の百分位数と最大値です（重みなし）。</translation>
    </message>
    <message>
        <source>Visibility</source>
        <translation>見え方</translation>
    </message>
    <message>
        <source>Joints, head, hands</source>
        <translation>関節、頭、手</translation>
    </message>
    <message>
        <source>Angle between a joint&apos;s world-space rotation and the original&apos;s, root mean square over frames and joints. Head and hands are recognised by their names.</source>
        <translation>関節のワールド空間での回転と元の回転の角度の、フレームと関節にわたる二乗平均平方根です。頭と手は名前で見分けます。</translation>
    </message>
    <message>
        <source>Foot drift, foot path</source>
        <translation>足のずれ、足の軌跡</translation>
    </message>
    <message>
        <source>Both are measured while a foot stands in the original. Drift is the distance between a foot and its place in the original, as the mean over contacts and in the worst contact. Path is the length of the foot&apos;s path beyond the original&apos;s, summed over all contacts; a foot that trembles in place has a long path.</source>
        <translation>どちらも、元の動きで足が接地している間に測ります。ずれは足と元の位置との距離で、接地の平均と最悪の接地の値です。軌跡は元より長く動いた道のりの、すべての接地での合計です。その場で震える足の軌跡は長くなります。</translation>
    </message>
    <message>
        <source>Verdict, note</source>
        <translation>判定、メモ</translation>
    </message>
    <message>
        <source>The reviewer&apos;s verdict and note, with name and date. A verdict is stale, and does not count, if the clip&apos;s file or its settings have changed since.</source>
        <translation>レビュー担当の判定とメモ、名前と日付です。その後にクリップのファイルや設定が変わった判定は無効で、数えません。</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Number of places that were repaired or guessed when the clip was read; they are listed above.</source>
        <translation>クリップの読み込み時に修復または推定した箇所の数です。一覧は上にあります。</translation>
    </message>
    <message>
        <source>How clips were measured</source>
        <translation>測定の方法</translation>
    </message>
    <message>
        <source>any visibility</source>
        <translation>見え方を問わない</translation>
    </message>
    <message>
        <source>any verdict</source>
        <translation>判定を問わない</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>with warnings or without</source>
        <translation>警告の有無を問わない</translation>
    </message>
    <message>
        <source>with warnings</source>
        <translation>警告あり</translation>
    </message>
    <message>
        <source>without warnings</source>
        <translation>警告なし</translation>
    </message>
    <message>
        <source>max over, cm</source>
        <translation>最大がこれより大きい cm</translation>
    </message>
    <message>
        <source>ratio below</source>
        <translation>圧縮率がこれより低い</translation>
    </message>
    <message>
        <source>name, preset, reason ...</source>
        <translation>名前、プリセット、理由…</translation>
    </message>
    <message>
        <source>show all</source>
        <translation>すべて表示</translation>
    </message>
    <message>
        <source>%1 of %2 clips</source>
        <translation>%2 個中 %1 個のクリップ</translation>
    </message>
    <message>
        <source>%1 of %2 clips, the first %3 of them below</source>
        <translation>%2 個中 %1 個のクリップ、以下は最初の %3 個</translation>
    </message>
    <message>
        <source>Compression study</source>
        <translation>圧縮の比較</translation>
    </message>
    <message>
        <source>Clips: %1, methods: %2, compressions: %3. Error weighting: %4.</source>
        <translation>クリップ %1、方式 %2、圧縮 %3。誤差の重み付け：%4。</translation>
    </message>
    <message>
        <source>Error against compression ratio, averaged over the clips</source>
        <translation>圧縮率に対する誤差、全クリップの平均</translation>
    </message>
    <message>
        <source>Error against compression ratio</source>
        <translation>圧縮率に対する誤差</translation>
    </message>
    <message>
        <source>%1: error against compression ratio</source>
        <translation>%1：圧縮率に対する誤差</translation>
    </message>
    <message>
        <source>The paper</source>
        <translation>論文</translation>
    </message>
    <message>
        <source>The paper: %1</source>
        <translation>論文：%1</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 フレーム</translation>
    </message>
    <message>
        <source>one clip</source>
        <translation>1 クリップ</translation>
    </message>
    <message>
        <source>geometric mean of %1 clips</source>
        <translation>%1 クリップの幾何平均</translation>
    </message>
    <message>
        <source>%1 at %2 = %3 cm, %4</source>
        <translation>%2 = %3 cm での%1、%4</translation>
    </message>
    <message>
        <source> (the paper: about %1:1)</source>
        <translation>（論文：約 %1:1）</translation>
    </message>
    <message>
        <source>smaller than %1 at equal error</source>
        <translation>同じ誤差で%1より小さい</translation>
    </message>
    <message>
        <source>to compress a frame by %1, including the search for the target</source>
        <translation>%1で 1 フレームを圧縮する時間（目標の探索を含む）</translation>
    </message>
    <message>
        <source>Use %1: it has the smallest files at %2 = %3 cm over all clips.</source>
        <translation>%1を使ってください。全クリップで %2 = %3 cm のとき、ファイルが最も小さくなります。</translation>
    </message>
    <message>
        <source>Recommended method</source>
        <translation>おすすめの方式</translation>
    </message>
    <message>
        <source>The presets use %1. The table shows the ratio at the error of each preset. Presets also bound the errors of heads, hands and roots, which costs some more bytes.</source>
        <translation>プリセットは%1を使います。表は各プリセットの誤差での圧縮率です。プリセットは頭・手・ルートの誤差も制限するため、実際には少しバイト数が増えます。</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>プリセット</translation>
    </message>
    <message>
        <source>mean ratio</source>
        <translation>平均圧縮率</translation>
    </message>
    <message>
        <source>wavelets by %1</source>
        <translation>ウェーブレット（%1）</translation>
    </message>
    <message>
        <source>no wavelets</source>
        <translation>ウェーブレットなし</translation>
    </message>
    <message>
        <source>Bytes of the channels as 32-bit floats, divided by the bytes of the coded motion. The skeleton counts on neither side, as in the paper. 1 KB = 1024 bytes.</source>
        <translation>32 ビット浮動小数点でのチャンネルのバイト数を、符号化した動きのバイト数で割ったものです。論文と同じく、スケルトンはどちらにも数えません。1 KB = 1024 バイト。</translation>
    </message>
    <message>
        <source>The paper&apos;s positional distortion (section 3.1), weighted by %1: the weighted root mean square distance between points of the body and the same points of the original. The paper&apos;s own figures use the weighting %2.</source>
        <translation>論文の位置の歪み（3.1 節）を「%1」で重み付けしたもので、体の点と元の同じ点の距離の重み付き二乗平均平方根です。論文の数値は「%2」の重み付けによります。</translation>
    </message>
    <message>
        <source>Judged from %1 m, by %2.</source>
        <translation>%1 m から、%2で判定します。</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>Geometric mean over the clips of the ratio at equal %1, at errors within the measured range of every clip. Ratios between measured points are interpolated, linearly in the logarithms of ratio and error, and marked %2.</source>
        <translation>等しい %1 での圧縮率の、全クリップの幾何平均です。すべてのクリップで測った範囲の誤差についてだけ求めます。測定点の間の圧縮率は、圧縮率と誤差の対数で線形に補間し、%2 を付けます。</translation>
    </message>
    <message>
        <source>Coding</source>
        <translation>符号化</translation>
    </message>
    <message>
        <source>%1, seed %2</source>
        <translation>%1、シード %2</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>Wall time of a compression, including the search for the target; compressions at the same time: up to %1. Work that the compressions of a clip share counts in the first of them. The paper used a 2 GHz Athlon 64.</source>
        <translation>目標の探索を含む 1 回の圧縮の実時間です。同時に行う圧縮は最大 %1。同じクリップの圧縮に共通の処理は、最初の圧縮に数えます。論文は 2 GHz の Athlon 64 を使いました。</translation>
    </message>
    <message>
        <source>Figures marked as the paper&apos;s are from Tables 1 and 2 of %1.</source>
        <translation>論文とした数値は %1 の表 1 と表 2 によります。</translation>
    </message>
    <message>
        <source>These methods have no mean, since no error is within the range of all clips: %1.</source>
        <translation>全クリップの範囲に入る誤差がないため、次の方式には平均がありません：%1。</translation>
    </message>
    <message>
        <source>Files are smaller to the right, errors smaller to the bottom. Curves are geometric means of the ratio at equal error. The dotted line is 0.5 cm: the paper saw no artifacts below it.</source>
        <translation>右ほどファイルが小さく、下ほど誤差が小さくなります。曲線は等しい誤差での圧縮率の幾何平均です。点線は 0.5 cm で、論文ではこれより下に不自然さは見えませんでした。</translation>
    </message>
    <message>
        <source>Hollow marks are the paper&apos;s Table 1.</source>
        <translation>白抜きの印は論文の表 1 です。</translation>
    </message>
    <message>
        <source>frame %1, %2 s</source>
        <translation>フレーム %1、%2 秒</translation>
    </message>
    <message>
        <source>%1 at %2: %3 %4 cm over the clip, largest error %5 cm; at this frame: %6.</source>
        <translation>%1（%2）：クリップ全体の %3 は %4 cm、最大誤差 %5 cm。このフレームでは %6。</translation>
    </message>
    <message>
        <source>%1, %2 to %3</source>
        <translation>%1、%2～%3</translation>
    </message>
    <message>
        <source>%1: foot that slides most</source>
        <translation>%1：最も滑る足</translation>
    </message>
    <message>
        <source>%1: %2 slides %3 cm while planted.</source>
        <translation>%1：接地中に %2 が %3 cm 滑ります。</translation>
    </message>
    <message>
        <source>%1 at %2:1</source>
        <translation>%1（%2:1）</translation>
    </message>
    <message>
        <source>Compressed motion in red over the original in grey, all at the same ratio. The first pictures show the frame with the largest error of %1: %2. Lines on the floor are half a metre apart.</source>
        <translation>圧縮後の動きは赤、元の動きは灰色で、圧縮率はすべて同じです。最初の絵は%1の誤差が最大のフレームです：%2。床の線の間隔は 50 cm です。</translation>
    </message>
    <message>
        <source>The foot that slides most</source>
        <translation>最も滑る足</translation>
    </message>
    <message>
        <source>Path of the foot over the floor during one contact: original in grey, compressed dark.</source>
        <translation>1 回の接地中に足が床で描く軌跡です。元は灰色、圧縮後は濃い色です。</translation>
    </message>
    <message>
        <source>Size at equal error</source>
        <translation>等しい誤差でのサイズ</translation>
    </message>
    <message>
        <source>Time of the annealing</source>
        <translation>アニーリングの時間</translation>
    </message>
    <message>
        <source>Feet held by inverse kinematics</source>
        <translation>IK で固定した足</translation>
    </message>
    <message>
        <source>Sliding feet</source>
        <translation>足の滑り</translation>
    </message>
    <message>
        <source>Rotation errors</source>
        <translation>回転の誤差</translation>
    </message>
    <message>
        <source>Missed targets</source>
        <translation>届かなかった目標</translation>
    </message>
    <message>
        <source>drift %1</source>
        <translation>ずれ %1</translation>
    </message>
    <message>
        <source>contacts</source>
        <translation>接地</translation>
    </message>
    <message>
        <source>mean of a contact</source>
        <translation>接地 1 回の平均</translation>
    </message>
    <message>
        <source>At the paper&apos;s coefficient ratio r = %1</source>
        <translation>論文の係数比 r = %1 のとき</translation>
    </message>
    <message>
        <source>At the compression ratio %1:1</source>
        <translation>圧縮率 %1:1 のとき</translation>
    </message>
    <message>
        <source>KB (ratio)</source>
        <translation>KB（圧縮率）</translation>
    </message>
    <message>
        <source>paper</source>
        <translation>論文</translation>
    </message>
    <message>
        <source>ms a frame</source>
        <translation>1 フレームの ms</translation>
    </message>
    <message>
        <source>iterations</source>
        <translation>反復</translation>
    </message>
    <message>
        <source>paper: ms</source>
        <translation>論文：ms</translation>
    </message>
    <message>
        <source>Horizontal path of the feet during contacts, beyond the original&apos;s; in brackets the mean contact and the worst contact. Contacts are detected in the original; clips without contacts are not listed.</source>
        <translation>接地中に足が水平に動いた、元より長い道のりです。かっこ内は接地の平均と最悪の接地です。接地は元の動きで検出します。接地のないクリップは載せません。</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>秒</translation>
    </message>
    <message>
        <source>Compression ratio at %1.</source>
        <translation>%1 での圧縮率です。</translation>
    </message>
    <message>
        <source>Angle between a joint&apos;s world-space rotation and the original&apos;s, root mean square over frames and joints; in brackets that of the head and of the worse hand, if they are recognised by their names. Measured at %1.</source>
        <translation>関節のワールド空間での回転と元の回転の角度の、フレームと関節にわたる二乗平均平方根です。かっこ内は、名前で見分けられた頭と、悪いほうの手の値です。%1 で測定。</translation>
    </message>
    <message>
        <source>%1 (cm) without, with IK</source>
        <translation>%1 (cm)、IK なしとあり</translation>
    </message>
    <message>
        <source>footskate (cm) without, with IK</source>
        <translation>足の滑り (cm)、IK なしとあり</translation>
    </message>
    <message>
        <source>without</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>with</source>
        <translation>あり</translation>
    </message>
    <message>
        <source>knee</source>
        <translation>膝</translation>
    </message>
    <message>
        <source>Clips with and without IK have the same compression ratio, so bytes of the correction are missing elsewhere. Knee: its highest speed, divided by that of the original.</source>
        <translation>IK のあるクリップとないクリップの圧縮率は同じなので、補正のバイト数はほかの部分から減ります。膝：最高速度を元の最高速度で割った値です。</translation>
    </message>
    <message>
        <source>every method</source>
        <translation>すべての方式</translation>
    </message>
    <message>
        <source>%1 gave %2</source>
        <translation>%1 で %2</translation>
    </message>
    <message>
        <source>%1 combinations of clip and method missed a target</source>
        <translation>クリップと方式の %1 通りが目標に届きませんでした</translation>
    </message>
    <message>
        <source>missed target</source>
        <translation>届かなかった目標</translation>
    </message>
    <message>
        <source>first reason</source>
        <translation>最初の理由</translation>
    </message>
    <message>
        <source>nearest result</source>
        <translation>最も近い結果</translation>
    </message>
    <message>
        <source>Cubic wavelets, coefficients moved between channels by annealing: the paper&apos;s Algorithm 1, candidates compared by a quadratic error model.</source>
        <translation>3 次ウェーブレット。アニーリングで係数をチャンネル間で移します。論文のアルゴリズム 1 で、候補は 2 次の誤差モデルで比べます。</translation>
    </message>
    <message>
        <source>Cubic wavelets, the largest coefficients of all channels, angles scaled by the length of the bone: the paper&apos;s section 4.</source>
        <translation>3 次ウェーブレット。全チャンネルの大きい係数を残します。角度は骨の長さで重み付けします。論文の 4 節。</translation>
    </message>
    <message>
        <source>Cubic wavelets, the largest coefficients of each channel, equally many: the paper&apos;s first approach in section 4.</source>
        <translation>3 次ウェーブレット。各チャンネルで同じ数の大きい係数を残します。論文の 4 節の最初の方法。</translation>
    </message>
    <message>
        <source>Standard selection in the Haar basis, with which Arikan (2006) compared.</source>
        <translation>Haar 基底での標準の選択。Arikan (2006) が比較に使いました。</translation>
    </message>
    <message>
        <source>Standard selection in the interpolating linear basis.</source>
        <translation>補間する線形基底での標準の選択。</translation>
    </message>
    <message>
        <source>Cubic wavelets, each coefficient quantised by what its step does to the error in the world, channels making good what others lost; adaptive coding.</source>
        <translation>3 次ウェーブレット。各係数を、その刻みがワールドの誤差に与える影響で量子化し、失われた分をほかのチャンネルが補います。適応符号化。</translation>
    </message>
    <message>
        <source>Our reading of Arikan (2006): clustered PCA of short Bezier curves of virtual markers, the database being the clip alone; k-means clusters, DEFLATE, and no special care of the feet.</source>
        <translation>Arikan (2006) の独自実装：仮想マーカーの短いベジエ曲線のクラスター PCA。データベースはこのクリップだけで、k 平均法、DEFLATE、足への特別な配慮はありません。</translation>
    </message>
    <message>
        <source>What engines do: each channel by itself, key frames left out where a line comes within the tolerance, steps as fine as the channel needs (as ACL&apos;s bit rates), DEFLATE.</source>
        <translation>エンジンの方法：チャンネルごとに、直線が許容差に収まるキーフレームを省き、必要な細かさの刻みで量子化します（ACL のビットレートと同様）。DEFLATE。</translation>
    </message>
    <message>
        <source>Our reading of Liu and McMillan (2006): PCA of segments, adaptive key frames with cubic splines; on channels weighted by what they move, not on markers, and with no special care of the feet.</source>
        <translation>Liu と McMillan (2006) の独自実装：区間ごとの PCA と、3 次スプラインによる適応的なキーフレーム。マーカーではなく動かす量で重み付けしたチャンネルに使い、足への特別な配慮はありません。</translation>
    </message>
    <message>
        <source>Principal components of the poses without the root&apos;s position, everything in 16 bits, DEFLATE: the paper&apos;s section 3.2.</source>
        <translation>ルート位置を除いた姿勢の主成分。すべて 16 ビット、DEFLATE。論文の 3.2 節。</translation>
    </message>
    <message>
        <source>Cubic wavelets on unit quaternions, coefficients moved between components by annealing on the linearised rotation: the paper&apos;s section 6.3.</source>
        <translation>単位クォータニオンの 3 次ウェーブレット。線形化した回転でのアニーリングで係数を成分間で移します。論文の 6.3 節。</translation>
    </message>
    <message>
        <source>Every s-th frame in 16 bits, DEFLATE; natural cubic splines between.</source>
        <translation>s フレームごとに 16 ビットで保存、DEFLATE。間は自然 3 次スプライン。</translation>
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
        <translation>圧縮率</translation>
    </message>
    <message>
        <source>Bytes of the channels as 32-bit floats, divided by the compressed motion bytes. The skeleton counts in neither, as in the paper.</source>
        <translation>チャンネルを32ビット浮動小数点の配列としたバイト数と圧縮後の動きのバイト数の比。論文どおりスケルトンはどちらにも含みません。</translation>
    </message>
    <message>
        <source>eps_x</source>
        <translation>eps_x</translation>
    </message>
    <message>
        <source>Root mean square distance between original and compressed, weighted by bone length.</source>
        <translation>元と圧縮後の距離の二乗平均平方根(骨の長さで重み付け)。</translation>
    </message>
    <message>
        <source>State of the result</source>
        <translation>答えの状態</translation>
    </message>
    <message>
        <source>95 % of points within</source>
        <translation>95 %の点がこの範囲</translation>
    </message>
    <message>
        <source>95th percentile of the distance over all joints and frames, unweighted.</source>
        <translation>全関節・全フレームの距離の95パーセンタイル(重みなし)。</translation>
    </message>
    <message>
        <source>99 % of points within</source>
        <translation>99 %の点がこの範囲</translation>
    </message>
    <message>
        <source>99th percentile of the distance over all joints and frames, unweighted.</source>
        <translation>全関節・全フレームの距離の99パーセンタイル(重みなし)。</translation>
    </message>
    <message>
        <source>Worst point</source>
        <translation>最悪の点</translation>
    </message>
    <message>
        <source>Largest error of any point at any frame.</source>
        <translation>全フレーム・全点での最大誤差。</translation>
    </message>
    <message>
        <source>Motion / file</source>
        <translation>動き / ファイル</translation>
    </message>
    <message>
        <source>Compressed motion bytes, and bytes of the whole file with its skeleton.</source>
        <translation>圧縮後の動きのバイト数と、スケルトンを含むファイル全体のバイト数。</translation>
    </message>
    <message>
        <source>Coefficient ratio</source>
        <translation>係数比</translation>
    </message>
    <message>
        <source>The paper&apos;s r: all wavelet coefficients over those that are kept.</source>
        <translation>論文の r：全ウェーブレット係数と残した係数の比。</translation>
    </message>
    <message>
        <source>Bits per joint-sample</source>
        <translation>関節サンプルあたりビット</translation>
    </message>
    <message>
        <source>Motion bits for one joint at one frame; unlike a ratio it needs no baseline.</source>
        <translation>1関節・1フレームあたりの動きのビット数。基準に依存しません。</translation>
    </message>
    <message>
        <source>IK signals</source>
        <translation>IK信号</translation>
    </message>
    <message>
        <source>Motion bytes of the correction that holds the feet, and its ratio r_IK.</source>
        <translation>足の固定が動きのバイト数に占める分と、その比 r_IK。</translation>
    </message>
    <message>
        <source>Fastest knee</source>
        <translation>最速の膝</translation>
    </message>
    <message>
        <source>Highest speed of a held leg&apos;s knee, and that of the original. A much higher speed means that the correction makes the knee snap.</source>
        <translation>固定した脚の膝の最大速度と元の最大速度。補正で膝が跳ねてはいけません。</translation>
    </message>
    <message>
        <source>eps_x, %1</source>
        <translation>eps_x、%1</translation>
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
        <translation>視認性</translation>
    </message>
    <message>
        <source>The most visible error, beside the size that people notice.</source>
        <translation>人が気づく以上のずれがあるかどうか。</translation>
    </message>
    <message>
        <source>Loop: seam</source>
        <translation>ループの継ぎ目</translation>
    </message>
    <message>
        <source>First / last pose</source>
        <translation>最初／最後のポーズ</translation>
    </message>
    <message>
        <source>Change of the errors of pose and velocity from the last frame to the first: the jump where the loop starts again.</source>
        <translation>最後のフレームから最初のフレームへ移るときに、ポーズと速度のずれがどれだけ変わるか。ループが再び始まるところで飛ぶ量です。</translation>
    </message>
    <message>
        <source>RMS error of the first and the last pose on the body&apos;s surface. Clips are blended there.</source>
        <translation>最初と最後のポーズが体表面で元からどれだけ離れているか。クリップがつながれるところです。</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <comment>poses</comment>
        <translation>%1／%2</translation>
    </message>
    <message>
        <source>Loop: elsewhere</source>
        <translation>ループの他の部分</translation>
    </message>
    <message>
        <source>The largest change of errors between two neighbouring frames. A smaller one at the seam does not stand out.</source>
        <translation>連続する二フレーム間の同じ変化の最大値です。継ぎ目がこれより小さければ目立ちません。</translation>
    </message>
    <message>
        <source>%1, %2/frame</source>
        <translation>%1、%2/フレーム</translation>
    </message>
    <message>
        <source>On the skin: worst / RMS</source>
        <translation>スキン上：最大 / RMS</translation>
    </message>
    <message>
        <source>Errors of points spread evenly over the mesh, over all frames.</source>
        <translation>メッシュ上に均等に置いた点の、全フレームでの距離です。</translation>
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
        <translation>足のずれ：平均／最大</translation>
    </message>
    <message>
        <source>Distance between a standing foot and its place in the original, over all contacts.</source>
        <translation>接地中に足が本来の位置から離れる距離。</translation>
    </message>
    <message>
        <source>Foot path: all / worst</source>
        <translation>足の軌跡：合計／最大</translation>
    </message>
    <message>
        <source>Path of the feet over the ground while they stand, beyond the original&apos;s: sum over the clip, and worst contact. A foot that trembles in place has a long path.</source>
        <translation>接地中の足が床の上で動いた軌跡の長さのうち元を超える分。クリップ全体の合計と最大の接地のもの。その場での震えも積算されます。</translation>
    </message>
    <message>
        <source>%1, %2 at %L3 s: %L4 times the noticeable error; not noticed beyond %L5 m</source>
        <translation>%1、%2、%L3 秒：気づく誤差の %L4 倍。%L5 m より遠くでは気づかれません</translation>
    </message>
    <message>
        <source>Most visible error</source>
        <translation>最も目につく誤差</translation>
    </message>
    <message>
        <source>All figures</source>
        <translation>すべての数値</translation>
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
        <translation>判定待ちの次のクリップを開きます（Q）</translation>
    </message>
    <message>
        <source>Next to review</source>
        <translation>次のレビュー対象</translation>
    </message>
    <message>
        <source>Clips that are reviewed</source>
        <translation>レビュー済みのクリップ</translation>
    </message>
    <message>
        <source>%L1 of %L2 reviewed</source>
        <translation>%L2 個中 %L1 個レビュー済み</translation>
    </message>
    <message>
        <source>%1, %L2 rejected</source>
        <translation>%1、却下 %L2</translation>
    </message>
</context>
<context>
    <name>mocapress::Sentence</name>
    <message>
        <source>%1 not finite or beyond 1e9, replaced by the frame before</source>
        <translation>%1が有限でないか 1e9 を超えていたため、前のフレームの値で置き換えました</translation>
    </message>
    <message>
        <source>%1 with the name of another joint, numbered: Name.2</source>
        <translation>%1がほかの関節と同じ名前だったため、番号を付けました（名前.2）</translation>
    </message>
    <message>
        <source>%1 with the name of another joint</source>
        <translation>%1がほかの関節と同じ名前です</translation>
    </message>
    <message>
        <source>the file ends within its last frame, which is dropped</source>
        <translation>ファイルが最後のフレームの途中で終わっているため、そのフレームを捨てました</translation>
    </message>
    <message>
        <source>keys lie unevenly: %1 of %2 frames carry keys; frames between are interpolated</source>
        <translation>キーの間隔が不揃いです：%2 フレーム中 %1 フレームにキーがあり、間は補間しました</translation>
    </message>
    <message>
        <source>take %1 is read; there are also %2</source>
        <translation>テイク %1 を読みました。ほかに %2 があります</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1、ほか %2 個</translation>
    </message>
    <message>
        <source>looks like an additive clip, near its rest pose with the root at the origin: errors are those that it makes on that pose, and where feet stand means nothing</source>
        <translation>加算クリップのようです（レストポーズに近く、ルートが原点）。誤差はそのポーズでの値で、足の接地には意味がありません</translation>
    </message>
    <message>
        <source>no bone has a length: errors are measured on three points 3 cm from each joint</source>
        <translation>どのボーンにも長さがないため、各関節から 3 cm の 3 点で誤差を測ります</translation>
    </message>
    <message>
        <source>the mesh reaches much further than the bones at %1, first %2 (%3 cm, not %4): the surface there is the mesh</source>
        <translation>%1でメッシュがボーンより大きく張り出しています（最初は %2：%4 cm でなく %3 cm）。そこではメッシュを表面とします</translation>
    </message>
    <message>
        <source>the figure stands along Z, but Y is taken to point up: --up z, or the import options of the studio, read it upright</source>
        <translation>人物は Z 方向に立っていますが、Y を上として読みました。--up z またはスタジオの読み込みオプションで直せます</translation>
    </message>
    <message>
        <source>%1 beside other children left out</source>
        <translation>ほかの子と並ぶ%1を省きました</translation>
    </message>
    <message>
        <source>the header says %1 frames, %2 follow: all of them are read</source>
        <translation>ヘッダーでは %1 フレームですが %2 フレームあり、すべて読みました</translation>
    </message>
    <message>
        <source>%1 of scale kept as tracks, which move no joint</source>
        <translation>スケールの%1をトラックとして残しました（関節は動かしません）</translation>
    </message>
    <message>
        <source>a Frame Time of %1 s cannot be right: taken as %2 frames per second</source>
        <translation>Frame Time %1 秒は正しくないため、毎秒 %2 フレームとしました</translation>
    </message>
    <message>
        <source>translation channels of the root are taken to replace OFFSET, as their values suggest</source>
        <translation>値から判断して、ルートの移動チャンネルは OFFSET を置き換えるものとしました</translation>
    </message>
    <message>
        <source>translation channels of the joints below the root are taken to replace OFFSET, as their values suggest</source>
        <translation>値から判断して、ルートより下の関節の移動チャンネルは OFFSET を置き換えるものとしました</translation>
    </message>
    <message>
        <source>translation channels of the root are taken to replace OFFSET, as Blender and MotionBuilder do: their values do not tell</source>
        <translation>値からは分からないため、Blender や MotionBuilder と同じく、ルートの移動チャンネルは OFFSET を置き換えるものとしました</translation>
    </message>
    <message>
        <source>translation channels of the joints below the root are taken to replace OFFSET, as Blender and MotionBuilder do: their values do not tell</source>
        <translation>値からは分からないため、Blender や MotionBuilder と同じく、ルートより下の関節の移動チャンネルは OFFSET を置き換えるものとしました</translation>
    </message>
    <message>
        <source>no unit of length is given: a rest pose %1 units tall is taken to have %2 cm to the unit</source>
        <translation>長さの単位が書かれていません。レストポーズの高さ %1 から、1 単位を %2 cm としました</translation>
    </message>
    <message>
        <source>frame numbers do not run 1, 2, 3 from here: frames are taken as they come</source>
        <translation>ここからフレーム番号が連続していません。並び順のまま読みました</translation>
    </message>
    <message>
        <source>%1 missing from a frame, where the frame before is repeated</source>
        <translation>あるフレームに%1がないため、前のフレームを繰り返しました</translation>
    </message>
    <message>
        <source>%1 with three values where the skeleton names fewer, read as its dof and the axes missing from it</source>
        <translation>%1に、骨格の指定より多い 3 つの値があります。dof とそこにない軸の順に読みました</translation>
    </message>
    <message>
        <source>%1 with three values where the skeleton names fewer, read as rx ry rz</source>
        <translation>%1に、骨格の指定より多い 3 つの値があります。rx ry rz として読みました</translation>
    </message>
    <message>
        <source>%1 with dof but without values, left at rest</source>
        <translation>%1に dof がありますが値がないため、レストのままです</translation>
    </message>
    <message>
        <source>%1 with a length that changes (dof l), which is ignored</source>
        <translation>%1の長さが変わりますが（dof l）、無視しました</translation>
    </message>
    <message>
        <source>%1 whose scale changes over time: joints are in their places, those of joints are kept as tracks, but errors are measured on a skin with the scales of the first frame</source>
        <translation>%1のスケールが時間とともに変わります。関節の位置は正しく、関節のスケールはトラックに残りますが、誤差は最初のフレームのスケールのスキンで測ります</translation>
    </message>
    <message>
        <source>%1 scaled unevenly, first %2: joints are in their places, but a skin has the scales of the first frame</source>
        <translation>%1が軸ごとに異なる大きさです（最初は %2）。関節の位置は正しいですが、スキンは最初のフレームのスケールです</translation>
    </message>
    <message>
        <source>%1 of the animation left out, which moves no node</source>
        <translation>アニメーションの%1を省きました（ノードを動かしません）</translation>
    </message>
    <message>
        <source>%1 of the animation left out, which move no node</source>
        <translation>アニメーションの%1を省きました（どれもノードを動かしません）</translation>
    </message>
    <message>
        <source>morph weights are not read: the file %1</source>
        <translation>モーフのウェイトを読めません：%1</translation>
    </message>
    <message>
        <source>its character is not read: %1</source>
        <translation>キャラクターを読めません：%1</translation>
    </message>
    <message>
        <source>the picture %1 is not shown: %2</source>
        <translation>画像 %1 を表示できません：%2</translation>
    </message>
    <message>
        <source>it is not beside the file</source>
        <translation>ファイルの隣にありません</translation>
    </message>
    <message>
        <source>it is neither PNG nor JPEG</source>
        <translation>PNG でも JPEG でもありません</translation>
    </message>
    <message>
        <source>it has more than 64 MiB</source>
        <translation>64 MiB を超えています</translation>
    </message>
    <message>
        <source>it has more than %1 bones</source>
        <translation>ボーンが %1 本を超えています</translation>
    </message>
    <message>
        <source>it has too many vertices</source>
        <translation>頂点が多すぎます</translation>
    </message>
    <message>
        <source>a vertex is not finite, or farther than 1e9 cm away</source>
        <translation>有限でないか 1e9 cm より遠い頂点があります</translation>
    </message>
    <message>
        <source>the first take, %1, stands still</source>
        <translation>最初のテイク %1 は動きません</translation>
    </message>
    <message>
        <source>%1 left out: not a finite number</source>
        <translation>有限の数でない%1を省きました</translation>
    </message>
    <message>
        <source>%1 stated again: each counts once</source>
        <translation>ファイルで繰り返された%1は、それぞれ 1 回と数えます</translation>
    </message>
    <message>
        <source>%1 with spheric XYZ angles, which are read as XYZ angles</source>
        <translation>%1の球面 XYZ 角を XYZ 角として読みました</translation>
    </message>
    <message>
        <source>%1 of weights or properties left out: too many, too long a name, or beyond 1e9</source>
        <translation>ウェイトやプロパティの%1を省きました（多すぎる、名前が長すぎる、または 1e9 を超える）</translation>
    </message>
    <message>
        <source>the clip has no joint %1, nor %2 more: what hangs there stays in its bind pose</source>
        <translation>クリップに関節 %1 ほか %2 個がありません。そこに付くものはバインドポーズのままです</translation>
    </message>
    <message>
        <source>the clip has no joint %1: what hangs there stays in its bind pose</source>
        <translation>クリップに関節 %1 がありません。そこに付くものはバインドポーズのままです</translation>
    </message>
    <message>
        <source>the clip has no joint %1, nor %2 more: they carry most of the character</source>
        <translation>クリップに関節 %1 ほか %2 個がありません。キャラクターの大部分がそこに付いています</translation>
    </message>
    <message>
        <source>the clip has no joint %1: they carry most of the character</source>
        <translation>クリップに関節 %1 がありません。キャラクターの大部分がそこに付いています</translation>
    </message>
    <message>
        <source>has other proportions than the clip, and legs of %1 % the length: it is shown and coloured with its own bones, and figures are measured on the clip&apos;s</source>
        <translation>クリップと体格が異なり、脚の長さは %1 % です。表示と色は自分のボーンで、数値はクリップのボーンで測ります</translation>
    </message>
    <message>
        <source>is not put on: %1</source>
        <translation>付けられません：%1</translation>
    </message>
    <message>
        <source>cannot be put on: %1</source>
        <translation>付けられません：%1</translation>
    </message>
    <message>
        <source>has no mesh that hangs on joints</source>
        <translation>関節に付いたメッシュがありません</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>ファイルもフォルダーもありません</translation>
    </message>
    <message>
        <source>is a folder, not a file</source>
        <translation>ファイルではなくフォルダーです</translation>
    </message>
    <message>
        <source>is a pipe or a device, not a file</source>
        <translation>ファイルではなくパイプまたはデバイスです</translation>
    </message>
    <message>
        <source>cannot be read to its end</source>
        <translation>最後まで読めません</translation>
    </message>
    <message>
        <source>is a pointer of Git LFS, not the file itself: &apos;git lfs pull&apos; fetches that</source>
        <translation>ファイル本体ではなく Git LFS のポインターです。git lfs pull で取得できます</translation>
    </message>
    <message>
        <source>is none of %1</source>
        <translation>%1 のいずれでもありません</translation>
    </message>
    <message>
        <source>holds none of %1</source>
        <translation>%1 のファイルがありません</translation>
    </message>
    <message>
        <source>is a link that leads nowhere</source>
        <translation>リンク先がありません</translation>
    </message>
    <message>
        <source>is a skeleton without motion: open one of its .amc files</source>
        <translation>動きのない骨格です。その .amc ファイルを開いてください</translation>
    </message>
    <message>
        <source>holds no animation, but may be put on a clip as its character</source>
        <translation>アニメーションはありませんが、クリップのキャラクターとして使えます</translation>
    </message>
    <message>
        <source>has no take %1: there are %2</source>
        <translation>テイク %1 はありません。あるのは %2 です</translation>
    </message>
    <message>
        <source>has neither bones nor anything else that moves</source>
        <translation>ボーンも、ほかに動くものもありません</translation>
    </message>
    <message>
        <source>no joint moves or is turned</source>
        <translation>動く関節も回る関節もありません</translation>
    </message>
    <message>
        <source>needs more than %1 frames</source>
        <translation>%1 フレームより多く必要です</translation>
    </message>
    <message>
        <source>needs more than %1 samples</source>
        <translation>%1 個より多いサンプルが必要です</translation>
    </message>
    <message>
        <source>joints are nested deeper than %1</source>
        <translation>関節の入れ子が %1 段を超えています</translation>
    </message>
    <message>
        <source>more than %1 joints</source>
        <translation>関節が %1 個を超えています</translation>
    </message>
    <message>
        <source>the name of a joint has more than %1 bytes</source>
        <translation>関節の名前が %1 バイトを超えています</translation>
    </message>
    <message>
        <source>%1 has a transform that is not finite, or beyond 1e9</source>
        <translation>%1 の変換が有限でないか、1e9 を超えています</translation>
    </message>
    <message>
        <source>%1 is farther than 1e9 cm away</source>
        <translation>%1 が 1e9 cm より遠くにあります</translation>
    </message>
    <message>
        <source>has a JSON value of another type than its place asks for</source>
        <translation>JSON の値の型が合いません</translation>
    </message>
    <message>
        <source>cannot be read: a library that reads its parts failed</source>
        <translation>読めません：一部を読むライブラリが失敗しました</translation>
    </message>
    <message>
        <source>expected one sample per second or more, found %1</source>
        <translation>毎秒 1 サンプル以上のはずが %1 です</translation>
    </message>
    <message>
        <source>expected a new line after the %1 values of the frame that begins in line %2, found %3</source>
        <translation>%2 行目に始まるフレームの %1 個の値の後に改行があるはずが %3 です</translation>
    </message>
    <message>
        <source>expected %1 values for %2, found %3</source>
        <translation>%2 の値は %1 個のはずが %3 個です</translation>
    </message>
    <message>
        <source>expected a bone of %1, found %2</source>
        <translation>%1 のボーンのはずが %2 です</translation>
    </message>
    <message>
        <source>expected a positive unit of length, found %1</source>
        <translation>正の長さの単位のはずが %1 です</translation>
    </message>
    <message>
        <source>expected a complete frame, found none</source>
        <translation>完全なフレームがありません</translation>
    </message>
    <message>
        <source>expected a name after &apos;name&apos;</source>
        <translation>&apos;name&apos; の後に名前がありません</translation>
    </message>
    <message>
        <source>expected %1, found %2</source>
        <translation>%1のはずが %2 です</translation>
    </message>
    <message>
        <source>%1 channels such as Xposition or Zrotation</source>
        <translation>Xposition や Zrotation などのチャンネル %1 個</translation>
    </message>
    <message>
        <source>a frame number</source>
        <translation>フレーム番号</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>空</translation>
    </message>
    <message>
        <source>samples per second</source>
        <translation>毎秒のサンプル数</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>ファイルの終わり</translation>
    </message>
    <message>
        <source>the number of frames</source>
        <translation>フレーム数</translation>
    </message>
    <message>
        <source>the number of channels</source>
        <translation>チャンネル数</translation>
    </message>
    <message>
        <source>the time of a frame in seconds</source>
        <translation>1 フレームの秒数</translation>
    </message>
    <message>
        <source>the name of the joint</source>
        <translation>関節の名前</translation>
    </message>
    <message>
        <source>the name of a bone</source>
        <translation>ボーンの名前</translation>
    </message>
    <message>
        <source>a coordinate of OFFSET</source>
        <translation>OFFSET の座標</translation>
    </message>
    <message>
        <source>a coordinate of direction</source>
        <translation>direction の座標</translation>
    </message>
    <message>
        <source>a coordinate of position</source>
        <translation>position の座標</translation>
    </message>
    <message>
        <source>an angle of axis</source>
        <translation>axis の角度</translation>
    </message>
    <message>
        <source>an angle of orientation</source>
        <translation>orientation の角度</translation>
    </message>
    <message>
        <source>an order of axes such as XYZ</source>
        <translation>XYZ などの軸の順序</translation>
    </message>
    <message>
        <source>the length of the bone</source>
        <translation>ボーンの長さ</translation>
    </message>
    <message>
        <source>the unit of length</source>
        <translation>長さの単位</translation>
    </message>
    <message>
        <source>the end of the bone</source>
        <translation>ボーンの終わり</translation>
    </message>
    <message>
        <source>the end of the hierarchy</source>
        <translation>階層の終わり</translation>
    </message>
    <message>
        <source>a section such as :units or :bonedata</source>
        <translation>:units や :bonedata などのセクション</translation>
    </message>
    <message>
        <source>OFFSET, CHANNELS, JOINT, End Site or }</source>
        <translation>OFFSET、CHANNELS、JOINT、End Site または }</translation>
    </message>
    <message>
        <source>OFFSET or the } of the End Site</source>
        <translation>OFFSET または End Site の }</translation>
    </message>
    <message>
        <source>deg or rad</source>
        <translation>deg または rad</translation>
    </message>
    <message>
        <source>tx, ty, tz, rx, ry, rz or l</source>
        <translation>tx、ty、tz、rx、ry、rz または l</translation>
    </message>
    <message>
        <source>numbers have a decimal comma, such as %1: a decimal point is read</source>
        <translation>%1 のように小数点がコンマの数があります。読めるのはピリオドです</translation>
    </message>
    <message>
        <source>is UTF-16: save it as UTF-8 to have it read</source>
        <translation>UTF-16 です。UTF-8 で保存すれば読めます</translation>
    </message>
    <message>
        <source>no joint has a channel: nothing moves</source>
        <translation>チャンネルを持つ関節がなく、何も動きません</translation>
    </message>
    <message>
        <source>no complete frame follows</source>
        <translation>完全なフレームが続きません</translation>
    </message>
    <message>
        <source>a second CHANNELS line for one joint</source>
        <translation>1 つの関節に CHANNELS 行が 2 つあります</translation>
    </message>
    <message>
        <source>channel %1 twice in one joint</source>
        <translation>1 つの関節にチャンネル %1 が 2 つあります</translation>
    </message>
    <message>
        <source>more than %1 channels of scale that change</source>
        <translation>変化するスケールのチャンネルが %1 個を超えています</translation>
    </message>
    <message>
        <source>the file ends within its first frame</source>
        <translation>最初のフレームの途中でファイルが終わっています</translation>
    </message>
    <message>
        <source>no bone has a value: nothing moves</source>
        <translation>値を持つボーンがなく、何も動きません</translation>
    </message>
    <message>
        <source>frame %1 has only %2 bones</source>
        <translation>フレーム %1 にはボーンが %2 本しかありません</translation>
    </message>
    <message>
        <source>%1 is not in the first frame</source>
        <translation>%1 が最初のフレームにありません</translation>
    </message>
    <message>
        <source>%1 twice in one frame</source>
        <translation>1 つのフレームに %1 が 2 つあります</translation>
    </message>
    <message>
        <source>%1 twice in one bone</source>
        <translation>1 本のボーンに %1 が 2 つあります</translation>
    </message>
    <message>
        <source>more than %1 bones</source>
        <translation>ボーンが %1 本を超えています</translation>
    </message>
    <message>
        <source>this bone has no name</source>
        <translation>このボーンには名前がありません</translation>
    </message>
    <message>
        <source>bone %1 lacks its direction or length</source>
        <translation>ボーン %1 に direction または length がありません</translation>
    </message>
    <message>
        <source>bone %1 is nested deeper than %2</source>
        <translation>ボーン %1 の入れ子が %2 段を超えています</translation>
    </message>
    <message>
        <source>bone %1 does not hang from the root in :hierarchy</source>
        <translation>:hierarchy でボーン %1 がルートにつながっていません</translation>
    </message>
    <message>
        <source>the name of a bone has more than %1 bytes</source>
        <translation>ボーンの名前が %1 バイトを超えています</translation>
    </message>
    <message>
        <source>a second bone named %1</source>
        <translation>%1 という名前のボーンが 2 本あります</translation>
    </message>
    <message>
        <source>a second parent for %1</source>
        <translation>%1 の親が 2 つあります</translation>
    </message>
    <message>
        <source>has no line of names</source>
        <translation>名前の行がありません</translation>
    </message>
    <message>
        <source>a column needs a name of 1 to 255 bytes</source>
        <translation>列には 1～255 バイトの名前が必要です</translation>
    </message>
    <message>
        <source>a name of a column has no quotes</source>
        <translation>列の名前に引用符は使えません</translation>
    </message>
    <message>
        <source>two columns are called %1</source>
        <translation>%1 という列が 2 つあります</translation>
    </message>
    <message>
        <source>is one more than the clip&apos;s %1</source>
        <translation>クリップの%1より 1 つ多いです</translation>
    </message>
    <message>
        <source>ends after values of %1, the clip has %2</source>
        <translation>%1分の値で終わっています（クリップは %2）</translation>
    </message>
    <message>
        <source>is compressed by EXT_meshopt_compression, which this program cannot read: it was built without libmeshoptimizer</source>
        <translation>EXT_meshopt_compression で圧縮されていますが、このプログラムは libmeshoptimizer なしで作られたため読めません</translation>
    </message>
    <message>
        <source>is compressed by KHR_draco_mesh_compression, which this program cannot read: it was built without libdraco</source>
        <translation>KHR_draco_mesh_compression で圧縮されていますが、このプログラムは libdraco なしで作られたため読めません</translation>
    </message>
    <message>
        <source>is not what %1 makes</source>
        <translation>%1 が作るものではありません</translation>
    </message>
    <message>
        <source>is too large to read</source>
        <translation>大きすぎて読めません</translation>
    </message>
    <message>
        <source>bufferView %1 %2</source>
        <translation>bufferView %1：%2</translation>
    </message>
    <message>
        <source>has a mesh that %1</source>
        <translation>メッシュがあり、%1</translation>
    </message>
    <message>
        <source>has an animation without keys</source>
        <translation>キーのないアニメーションがあります</translation>
    </message>
    <message>
        <source>has an animation with %1 key times, but %2 values</source>
        <translation>アニメーションのキー時刻が %1 個なのに値が %2 個です</translation>
    </message>
    <message>
        <source>has an animation whose key times go back</source>
        <translation>キーの時刻が逆戻りするアニメーションがあります</translation>
    </message>
    <message>
        <source>has an animation channel without a sampler</source>
        <translation>サンプラーのないアニメーションチャンネルがあります</translation>
    </message>
    <message>
        <source>has an animation channel without a target</source>
        <translation>対象のないアニメーションチャンネルがあります</translation>
    </message>
    <message>
        <source>has an animation of node %1, which it has not</source>
        <translation>存在しないノード %1 のアニメーションがあります</translation>
    </message>
    <message>
        <source>has an animation that moves the morph weights of a node twice</source>
        <translation>1 つのノードのモーフのウェイトを 2 度動かすアニメーションがあります</translation>
    </message>
    <message>
        <source>has an unknown interpolation, %1</source>
        <translation>未知の補間 %1 があります</translation>
    </message>
    <message>
        <source>has a rotation of length 0</source>
        <translation>長さ 0 の回転があります</translation>
    </message>
    <message>
        <source>has a node that is below itself</source>
        <translation>自分自身の下にあるノードがあります</translation>
    </message>
    <message>
        <source>has node %1 below two nodes, or twice below one</source>
        <translation>ノード %1 が 2 つのノードの下、または 1 つの下に 2 度あります</translation>
    </message>
    <message>
        <source>has more than %1 nodes</source>
        <translation>ノードが %1 個を超えています</translation>
    </message>
    <message>
        <source>has a name of more than %1 bytes</source>
        <translation>%1 バイトを超える名前があります</translation>
    </message>
    <message>
        <source>has morph weights of a node without a mesh</source>
        <translation>メッシュのないノードにモーフのウェイトがあります</translation>
    </message>
    <message>
        <source>has too many morph targets</source>
        <translation>モーフターゲットが多すぎます</translation>
    </message>
    <message>
        <source>has too many morph weights</source>
        <translation>モーフのウェイトが多すぎます</translation>
    </message>
    <message>
        <source>moves neither nodes nor morph weights that can be read</source>
        <translation>読めるノードもモーフのウェイトも動かしません</translation>
    </message>
    <message>
        <source>asks for %1 frames of %2 nodes, too many for a file of so few bytes</source>
        <translation>%2 ノード × %1 フレームは、この大きさのファイルには多すぎます</translation>
    </message>
    <message>
        <source>holds no keys</source>
        <translation>キーがありません</translation>
    </message>
    <message>
        <source>its take %1 moves no node</source>
        <translation>テイク %1 はノードを動かしません</translation>
    </message>
    <message>
        <source>its nodes hang in a circle</source>
        <translation>ノードが輪になっています</translation>
    </message>
    <message>
        <source>its nodes hang deeper than %1</source>
        <translation>ノードの入れ子が %1 段を超えています</translation>
    </message>
    <message>
        <source>has keys at impossible times</source>
        <translation>ありえない時刻のキーがあります</translation>
    </message>
    <message>
        <source>has too many nodes for so many frames</source>
        <translation>フレーム数に対してノードが多すぎます</translation>
    </message>
    <message>
        <source>the target of %1 is out of reach with this method: the nearest is %2</source>
        <translation>この方法では目標 %1 に届きません。最も近い値は %2 です</translation>
    </message>
    <message>
        <source>a promise beside the target is out of reach: %1</source>
        <translation>目標に添えた約束に届きません：%1</translation>
    </message>
    <message>
        <source>no joint is of any importance</source>
        <translation>重要な関節がありません</translation>
    </message>
    <message>
        <source>the importance of a joint must be a number, 0 or more</source>
        <translation>関節の重要度は 0 以上の数でなければなりません</translation>
    </message>
    <message>
        <source>the importance of every joint is needed, or of none</source>
        <translation>すべての関節の重要度を指定するか、まったく指定しないでください</translation>
    </message>
    <message>
        <source>the skeleton has no joint named %1</source>
        <translation>骨格に %1 という関節がありません</translation>
    </message>
    <message>
        <source>%1 is turned (degrees, RMS) by %2, not %3</source>
        <translation>%1 の回転（度、RMS）が %3 でなく %2 です</translation>
    </message>
    <message>
        <source>the weighting skin needs a clip with a mesh on its joints, or a character that is put on it</source>
        <translation>重み付け「スキン」には、関節にメッシュの付いたクリップか、付けたキャラクターが必要です</translation>
    </message>
    <message>
        <source>cannot be written: its extension is none of .bvh, .fbx, .glb, .gltf, .amc, .csv</source>
        <translation>書き込めません：拡張子が .bvh、.fbx、.glb、.gltf、.amc、.csv のいずれでもありません</translation>
    </message>
    <message>
        <source>is not written: the motion has values that are not finite</source>
        <translation>書き込みませんでした：動きに有限でない値があります</translation>
    </message>
    <message>
        <source>only an .fbx can be written onto an .fbx, and a .glb or .gltf onto a glTF</source>
        <translation>FBX の上には .fbx だけ、glTF の上には .glb か .gltf だけを書けます</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>書き込めません：%1</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>読めません：%1</translation>
    </message>
    <message>
        <source>cannot be looked at: %1</source>
        <translation>調べられません：%1</translation>
    </message>
    <message>
        <source>has %1 for %2</source>
        <translation>%2に%1があります</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation>
            <numerusform>%n 個の値</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s)</source>
        <translation>
            <numerusform>%n 個の関節</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n connection(s)</source>
        <translation>
            <numerusform>%n 個の接続</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n node(s)</source>
        <translation>
            <numerusform>%n 個のノード</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n bone(s)</source>
        <translation>
            <numerusform>%n 本のボーン</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n channel(s)</source>
        <translation>
            <numerusform>%n 個のチャンネル</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n curve(s)</source>
        <translation>
            <numerusform>%n 本のカーブ</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n key(s)</source>
        <translation>
            <numerusform>%n 個のキー</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s)</source>
        <translation>
            <numerusform>%n フレーム</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n column(s)</source>
        <translation>
            <numerusform>%n 列</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n End Site(s)</source>
        <translation>
            <numerusform>%n 個の End Site</numerusform>
        </translation>
    </message>
    <message>
        <source>needs its skeleton, but neither %1.asf nor %2.asf is beside it</source>
        <translation>骨格が必要ですが、%1.asf も %2.asf も隣にありません</translation>
    </message>
    <message>
        <source>needs its skeleton, but %1.asf is not beside it</source>
        <translation>骨格が必要ですが、%1.asf が隣にありません</translation>
    </message>
    <message>
        <source>expected a number, found %1</source>
        <translation>数のはずが %1 です</translation>
    </message>
    <message>
        <source>%1 with quaternions between keys, which are read as angles</source>
        <translation>%1のキー間の四元数を角度として読みました</translation>
    </message>
    <message>
        <source>the target of %1 is out of reach with this method: the nearest is %2, a smaller file</source>
        <translation>この方法では目標 %1 に届きません。最も近い値は %2 で、より小さいファイルです</translation>
    </message>
    <message>
        <source>the target of %1 is out of reach with this method: the nearest is %2, a larger file</source>
        <translation>この方法では目標 %1 に届きません。最も近い値は %2 で、より大きいファイルです</translation>
    </message>
    <message>
        <source>%1 (byte %2)</source>
        <translation>%1（バイト %2）</translation>
    </message>
    <message>
        <source>%1 (line %2)</source>
        <translation>%1（%2 行目）</translation>
    </message>
    <message>
        <source>byte %1: %2</source>
        <translation>バイト %1：%2</translation>
    </message>
    <message>
        <source>not a Mocapress file</source>
        <translation>Mocapress のファイルではありません</translation>
    </message>
    <message>
        <source>not a bank of clips</source>
        <translation>クリップのバンクではありません</translation>
    </message>
    <message>
        <source>a clip of a bank: the bank is what is opened</source>
        <translation>バンクのクリップです。バンクのほうを開いてください</translation>
    </message>
    <message>
        <source>the version is unknown: a newer Mocapress is needed</source>
        <translation>未知のバージョンです。新しい Mocapress が必要です</translation>
    </message>
    <message>
        <source>the file ends within its header</source>
        <translation>ファイルがヘッダーの途中で終わっています</translation>
    </message>
    <message>
        <source>the file ends within a section</source>
        <translation>ファイルがセクションの途中で終わっています</translation>
    </message>
    <message>
        <source>a section is damaged: its checksum differs</source>
        <translation>セクションが壊れています。チェックサムが合いません</translation>
    </message>
    <message>
        <source>a section is missing</source>
        <translation>セクションが足りません</translation>
    </message>
    <message>
        <source>a section for the second time</source>
        <translation>同じセクションが 2 度あります</translation>
    </message>
    <message>
        <source>a section that is not expected here</source>
        <translation>ここにあるはずのないセクションです</translation>
    </message>
    <message>
        <source>a second section loop</source>
        <translation>loop セクションが 2 つあります</translation>
    </message>
    <message>
        <source>bytes after the last section</source>
        <translation>最後のセクションの後にバイトがあります</translation>
    </message>
    <message>
        <source>bytes after the coded motion</source>
        <translation>符号化した動きの後にバイトがあります</translation>
    </message>
    <message>
        <source>bytes after the last joint</source>
        <translation>最後の関節の後にバイトがあります</translation>
    </message>
    <message>
        <source>bytes after the DEFLATE stream</source>
        <translation>DEFLATE ストリームの後にバイトがあります</translation>
    </message>
    <message>
        <source>bytes of curves where there are none</source>
        <translation>曲線がないのに曲線のバイトがあります</translation>
    </message>
    <message>
        <source>%1 has the wrong size</source>
        <translation>%1 の大きさが合いません</translation>
    </message>
    <message>
        <source>%1 is too short</source>
        <translation>%1 が短すぎます</translation>
    </message>
    <message>
        <source>ENDS has an impossible reach</source>
        <translation>ENDS の範囲がありえません</translation>
    </message>
    <message>
        <source>ENDS has impossible steps</source>
        <translation>ENDS の刻みがありえません</translation>
    </message>
    <message>
        <source>TIER has an impossible number of tiers</source>
        <translation>TIER の段数がありえません</translation>
    </message>
    <message>
        <source>TIER has tiers that do not follow each other</source>
        <translation>TIER の段が続いていません</translation>
    </message>
    <message>
        <source>a tier is missing</source>
        <translation>段が足りません</translation>
    </message>
    <message>
        <source>tiers of another coding</source>
        <translation>別の符号化の段です</translation>
    </message>
    <message>
        <source>the file has %1 tiers, not %2</source>
        <translation>ファイルの段は %2 でなく %1 です</translation>
    </message>
    <message>
        <source>a file with tiers takes no further section</source>
        <translation>段のあるファイルにセクションは足せません</translation>
    </message>
    <message>
        <source>a number of the motion is out of bounds</source>
        <translation>動きの数値が範囲外です</translation>
    </message>
    <message>
        <source>a number of the skeleton is not finite</source>
        <translation>骨格の数値が有限ではありません</translation>
    </message>
    <message>
        <source>a step is larger than 2^64</source>
        <translation>刻みが 2^64 を超えています</translation>
    </message>
    <message>
        <source>a run of zeros passes the end of its channel</source>
        <translation>ゼロの並びがチャンネルの終わりを越えています</translation>
    </message>
    <message>
        <source>a track has unknown flags</source>
        <translation>トラックに未知のフラグがあります</translation>
    </message>
    <message>
        <source>a joint has unknown flags</source>
        <translation>関節に未知のフラグがあります</translation>
    </message>
    <message>
        <source>a joint stands before its parent</source>
        <translation>関節が親より前にあります</translation>
    </message>
    <message>
        <source>a joint has more than 6 channels</source>
        <translation>関節のチャンネルが 6 つを超えています</translation>
    </message>
    <message>
        <source>the axes are not a unit quaternion</source>
        <translation>軸が単位四元数ではありません</translation>
    </message>
    <message>
        <source>not as many channels as JNTS states</source>
        <translation>チャンネルの数が JNTS と合いません</translation>
    </message>
    <message>
        <source>an effector is not a joint</source>
        <translation>エフェクターが関節ではありません</translation>
    </message>
    <message>
        <source>a basis where there are no wavelets</source>
        <translation>ウェーブレットがないのに基底があります</translation>
    </message>
    <message>
        <source>impossible orders of rotations</source>
        <translation>回転順序がありえません</translation>
    </message>
    <message>
        <source>an impossible unit of length</source>
        <translation>長さの単位がありえません</translation>
    </message>
    <message>
        <source>more frames than the limits allow</source>
        <translation>フレーム数が上限を超えています</translation>
    </message>
    <message>
        <source>more joints or channels than the limits allow</source>
        <translation>関節またはチャンネルの数が上限を超えています</translation>
    </message>
    <message>
        <source>more values than the limits allow</source>
        <translation>値の数が上限を超えています</translation>
    </message>
    <message>
        <source>more than 2^22 frames</source>
        <translation>フレームが 2^22 を超えています</translation>
    </message>
    <message>
        <source>more than 2^26 values</source>
        <translation>値が 2^26 を超えています</translation>
    </message>
    <message>
        <source>reading takes more scratch memory than the limits allow</source>
        <translation>読み込みの作業メモリが上限を超えています</translation>
    </message>
    <message>
        <source>the resident form takes more memory than the limits allow</source>
        <translation>常駐形式のメモリが上限を超えています</translation>
    </message>
    <message>
        <source>the coding is not adaptive</source>
        <translation>符号化が適応型ではありません</translation>
    </message>
    <message>
        <source>%1 ends early</source>
        <translation>%1が途中で終わっています</translation>
    </message>
    <message>
        <source>%1 end early</source>
        <translation>%1が途中で終わっています</translation>
    </message>
    <message>
        <source>%1 is damaged</source>
        <translation>%1が壊れています</translation>
    </message>
    <message>
        <source>%1 are damaged</source>
        <translation>%1が壊れています</translation>
    </message>
    <message>
        <source>the coded motion</source>
        <translation>符号化した動き</translation>
    </message>
    <message>
        <source>the coded tracks</source>
        <translation>符号化したトラック</translation>
    </message>
    <message>
        <source>the coded ends</source>
        <translation>符号化した両端</translation>
    </message>
    <message>
        <source>the coded skeleton</source>
        <translation>符号化した骨格</translation>
    </message>
    <message>
        <source>the DEFLATE stream</source>
        <translation>DEFLATE ストリーム</translation>
    </message>
    <message>
        <source>the skeleton</source>
        <translation>骨格</translation>
    </message>
    <message>
        <source>the tracks</source>
        <translation>トラック</translation>
    </message>
    <message>
        <source>more runs of tracks than was promised</source>
        <translation>トラックの並びが示された数を超えています</translation>
    </message>
    <message>
        <source>other tracks than was promised</source>
        <translation>示されたトラックと異なります</translation>
    </message>
    <message>
        <source>the number of segments does not fit the frames</source>
        <translation>セグメントの数がフレームと合いません</translation>
    </message>
    <message>
        <source>the sample rate is not a positive number</source>
        <translation>サンプルレートが正の数ではありません</translation>
    </message>
    <message>
        <source>the scale of steps is not a positive number</source>
        <translation>刻みの縮尺が正の数ではありません</translation>
    </message>
    <message>
        <source>the segments have an impossible length</source>
        <translation>セグメントの長さがありえません</translation>
    </message>
    <message>
        <source>the skeleton has an impossible size</source>
        <translation>骨格の大きさがありえません</translation>
    </message>
    <message>
        <source>the tracks have an impossible size</source>
        <translation>トラックの大きさがありえません</translation>
    </message>
    <message>
        <source>too many samples for so few coded bytes</source>
        <translation>バイト数のわりにサンプルが多すぎます</translation>
    </message>
    <message>
        <source>inflates to more bytes than allowed</source>
        <translation>展開すると許されたバイト数を超えます</translation>
    </message>
    <message>
        <source>unknown basis of tracks</source>
        <translation>未知のトラックの基底です</translation>
    </message>
    <message>
        <source>unknown basis</source>
        <translation>未知の基底です</translation>
    </message>
    <message>
        <source>unknown coding</source>
        <translation>未知の符号化です</translation>
    </message>
    <message>
        <source>unknown kind of loop</source>
        <translation>未知の種類のループです</translation>
    </message>
    <message>
        <source>unknown kind of track</source>
        <translation>未知の種類のトラックです</translation>
    </message>
    <message>
        <source>unknown kind of channel</source>
        <translation>未知の種類のチャンネルです</translation>
    </message>
    <message>
        <source>unknown kind of source</source>
        <translation>未知の種類のソースです</translation>
    </message>
    <message>
        <source>unknown method</source>
        <translation>未知の手法です</translation>
    </message>
    <message>
        <source>unknown solver</source>
        <translation>未知のソルバーです</translation>
    </message>
    <message>
        <source>unknown weighting</source>
        <translation>未知の重み付けです</translation>
    </message>
    <message>
        <source>unknown axis</source>
        <translation>未知の軸です</translation>
    </message>
    <message>
        <source>unknown convention</source>
        <translation>未知の規約です</translation>
    </message>
    <message>
        <source>unknown order of rotations</source>
        <translation>未知の回転順序です</translation>
    </message>
    <message>
        <source>unknown method of compression: %1</source>
        <translation>未知の圧縮手法です：%1</translation>
    </message>
    <message>
        <source>not a wavelet clip: it was made by a comparison method (section COMP)</source>
        <translation>ウェーブレットのクリップではなく、比較用の手法のものです（セクション COMP）</translation>
    </message>
    <message>
        <source>the motion has values that are not finite</source>
        <translation>動きに有限でない値があります</translation>
    </message>
    <message>
        <source>ends here: %1 bytes wanted, %2 left</source>
        <translation>ここで終わっています。%1 バイト必要ですが残りは %2 です</translation>
    </message>
    <message>
        <source>%1 bytes too many</source>
        <translation>%1 バイト余っています</translation>
    </message>
    <message>
        <source>the clips of the bank are damaged: their checksum differs</source>
        <translation>バンクのクリップが壊れています。チェックサムが合いません</translation>
    </message>
    <message>
        <source>clips of the bank are damaged: their checksum differs</source>
        <translation>バンクのクリップが壊れています。チェックサムが合いません</translation>
    </message>
    <message>
        <source>the head of the bank is damaged: its checksum differs</source>
        <translation>バンクの先頭が壊れています。チェックサムが合いません</translation>
    </message>
    <message>
        <source>the index of the bank is damaged: its checksum differs</source>
        <translation>バンクの索引が壊れています。チェックサムが合いません</translation>
    </message>
    <message>
        <source>the index of the bank makes no sense</source>
        <translation>バンクの索引が意味を成しません</translation>
    </message>
    <message>
        <source>the tiers of the bank make no sense</source>
        <translation>バンクの段が意味を成しません</translation>
    </message>
    <message>
        <source>a tier of the bank is damaged: its checksum differs</source>
        <translation>バンクの段が壊れています。チェックサムが合いません</translation>
    </message>
    <message>
        <source>the bank is cut short</source>
        <translation>バンクが途中で切れています</translation>
    </message>
    <message>
        <source>the bank has an impossible head</source>
        <translation>バンクの先頭がありえません</translation>
    </message>
    <message>
        <source>an unknown form of bank</source>
        <translation>未知のバンク形式です</translation>
    </message>
    <message>
        <source>an impossible item of the bank</source>
        <translation>バンクにありえない項目があります</translation>
    </message>
    <message>
        <source>the parts of the bank are out of order</source>
        <translation>バンクの部分の順序が違います</translation>
    </message>
    <message>
        <source>a clip of the bank has another size than it says</source>
        <translation>バンクのクリップの大きさが合いません</translation>
    </message>
    <message>
        <source>a clip of the bank has another skeleton than it says</source>
        <translation>バンクのクリップの骨格が合いません</translation>
    </message>
    <message>
        <source>a clip of the bank</source>
        <translation>バンクのクリップ</translation>
    </message>
    <message>
        <source>what the bank&apos;s clips taught makes no sense</source>
        <translation>バンクのクリップから得た統計が意味を成しません</translation>
    </message>
    <message>
        <source>a number that is not finite</source>
        <translation>有限でない数値です</translation>
    </message>
    <message>
        <source>a value that is not finite</source>
        <translation>有限でない値です</translation>
    </message>
    <message>
        <source>a range that is not finite</source>
        <translation>有限でない範囲です</translation>
    </message>
    <message>
        <source>a step that is not finite</source>
        <translation>有限でない刻みです</translation>
    </message>
    <message>
        <source>segments that are too short</source>
        <translation>セグメントが短すぎます</translation>
    </message>
    <message>
        <source>more components than possible</source>
        <translation>成分が多すぎます</translation>
    </message>
    <message>
        <source>fewer components than stated</source>
        <translation>成分が示された数より少ないです</translation>
    </message>
    <message>
        <source>a component whose reach is not above 0</source>
        <translation>範囲が 0 より大きくない成分があります</translation>
    </message>
    <message>
        <source>an unknown cluster</source>
        <translation>未知のクラスターです</translation>
    </message>
    <message>
        <source>a segment of an unknown kind</source>
        <translation>未知の種類のセグメントです</translation>
    </message>
    <message>
        <source>two keys at one frame</source>
        <translation>1 つのフレームにキーが 2 つあります</translation>
    </message>
    <message>
        <source>a key after the clip&apos;s end</source>
        <translation>クリップの終わりより後にキーがあります</translation>
    </message>
    <message>
        <source>a key after the segment&apos;s end</source>
        <translation>セグメントの終わりより後にキーがあります</translation>
    </message>
    <message>
        <source>no key at the clip&apos;s end</source>
        <translation>クリップの終わりにキーがありません</translation>
    </message>
    <message>
        <source>no key at the segment&apos;s end</source>
        <translation>セグメントの終わりにキーがありません</translation>
    </message>
    <message>
        <source>a stride longer than the clip</source>
        <translation>間隔がクリップより長いです</translation>
    </message>
    <message>
        <source>a curve has %1 key times, but %2 values</source>
        <translation>曲線のキー時刻が %1 個なのに値が %2 個です</translation>
    </message>
    <message>
        <source>a curve ends within a key</source>
        <translation>曲線がキーの途中で終わっています</translation>
    </message>
    <message>
        <source>has a key with unknown tangents</source>
        <translation>接線の種類が未知のキーがあります</translation>
    </message>
    <message>
        <source>has a key of an unknown kind</source>
        <translation>種類が未知のキーがあります</translation>
    </message>
    <message>
        <source>has meshes of more than %1 corners</source>
        <translation>メッシュの頂点が %1 個を超えています</translation>
    </message>
    <message>
        <source>has a polygon with a point that its mesh has not</source>
        <translation>メッシュにない頂点を使うポリゴンがあります</translation>
    </message>
    <message>
        <source>has a bone with more or fewer weights than points</source>
        <translation>ウェイトと頂点の数が合わないボーンがあります</translation>
    </message>
    <message>
        <source>has a bone with a weight of a point that its mesh has not</source>
        <translation>メッシュにない頂点のウェイトを持つボーンがあります</translation>
    </message>
    <message>
        <source>has more than %1 weights</source>
        <translation>ウェイトが %1 個を超えています</translation>
    </message>
    <message>
        <source>has more than %1 records</source>
        <translation>レコードが %1 個を超えています</translation>
    </message>
    <message>
        <source>nests records deeper than %1</source>
        <translation>レコードの入れ子が %1 段を超えています</translation>
    </message>
    <message>
        <source>is FBX %1: versions from 6.0 on are read</source>
        <translation>FBX %1 です。6.0 以降を読めます</translation>
    </message>
    <message>
        <source>ends within its head</source>
        <translation>先頭部の途中で終わっています</translation>
    </message>
    <message>
        <source>cannot be read as FBX: it begins neither like a binary file nor like an ASCII one</source>
        <translation>FBX として読めません。バイナリ形式でも ASCII 形式でもない始まり方です</translation>
    </message>
    <message>
        <source>cannot be read as FBX: it states no version</source>
        <translation>FBX として読めません。バージョンの記載がありません</translation>
    </message>
    <message>
        <source>has an array of an unknown encoding</source>
        <translation>エンコードが未知の配列があります</translation>
    </message>
    <message>
        <source>an array has fewer values than it states</source>
        <translation>配列の値が示された数より少ないです</translation>
    </message>
    <message>
        <source>an array states more values than its bytes can hold</source>
        <translation>配列の値の数がバイト数を超えています</translation>
    </message>
    <message>
        <source>has an array that cannot be unpacked</source>
        <translation>展開できない配列があります</translation>
    </message>
    <message>
        <source>its take %1 has no first layer that is heard: a motion cannot be written there</source>
        <translation>テイク %1 に有効な最初のレイヤーがないため、動きを書けません</translation>
    </message>
    <message>
        <source>numbers its objects too high to add any</source>
        <translation>オブジェクトの番号が大きすぎて追加できません</translation>
    </message>
    <message>
        <source>has curves that several takes share: a motion cannot be written onto one</source>
        <translation>複数のテイクが共有する曲線があるため、1 つのテイクに動きを書けません</translation>
    </message>
    <message>
        <source>is ASCII, big-endian or older than 7.0: a motion is put only onto other binary FBX files</source>
        <translation>ASCII、ビッグエンディアン、または 7.0 より前の形式です。動きを書き込めるのはそれ以外のバイナリ FBX だけです</translation>
    </message>
    <message>
        <source>a text is too long for an FBX</source>
        <translation>FBX には長すぎるテキストがあります</translation>
    </message>
    <message>
        <source>a curve is too long for an FBX</source>
        <translation>FBX には長すぎる曲線があります</translation>
    </message>
    <message>
        <source>an FBX of a version before 7.5 has at most 4 GiB</source>
        <translation>7.5 より前の FBX は 4 GiB までです</translation>
    </message>
    <message>
        <source>a record states no end: nothing is written onto it</source>
        <translation>終わりの記載がないレコードには書けません</translation>
    </message>
    <message>
        <source>has no %1</source>
        <translation>%1 がありません</translation>
    </message>
    <message>
        <source>is no glTF: its JSON is not an object</source>
        <translation>glTF ではありません。JSON がオブジェクトではありません</translation>
    </message>
    <message>
        <source>is no glTF 2.0: %1</source>
        <translation>glTF 2.0 ではありません：%1</translation>
    </message>
    <message>
        <source>it states no version</source>
        <translation>バージョンの記載がありません</translation>
    </message>
    <message>
        <source>its version is %1</source>
        <translation>バージョンは %1 です</translation>
    </message>
    <message>
        <source>ends before the length it states</source>
        <translation>示された長さより前に終わっています</translation>
    </message>
    <message>
        <source>is version %1 of .glb, not 2</source>
        <translation>.glb のバージョンが 2 でなく %1 です</translation>
    </message>
    <message>
        <source>has a chunk that reaches beyond its end</source>
        <translation>終わりを越えるチャンクがあります</translation>
    </message>
    <message>
        <source>does not begin with JSON</source>
        <translation>JSON で始まっていません</translation>
    </message>
    <message>
        <source>holds no JSON</source>
        <translation>JSON がありません</translation>
    </message>
    <message>
        <source>%1 is not a list of objects</source>
        <translation>%1 がオブジェクトのリストではありません</translation>
    </message>
    <message>
        <source>%1 is not a whole number from 0</source>
        <translation>%1 が 0 以上の整数ではありません</translation>
    </message>
    <message>
        <source>%1 names number %2 of only %3</source>
        <translation>%1 が %2 番を指していますが、%3 しかありません</translation>
    </message>
    <message>
        <source>lacks a %1 that should name one of its %2</source>
        <translation>%2 のいずれかを指す %1 がありません</translation>
    </message>
    <message>
        <source>%1 names what is none of its %2</source>
        <translation>%1 が %2 のいずれでもないものを指しています</translation>
    </message>
    <message>
        <source>%1 is not %2 numbers up to 1e9</source>
        <translation>%1 が 1e9 以下の %2 個の数値ではありません</translation>
    </message>
    <message>
        <source>%1 is not a list</source>
        <translation>%1 がリストではありません</translation>
    </message>
    <message>
        <source>%1 is not a text</source>
        <translation>%1 がテキストではありません</translation>
    </message>
    <message>
        <source>has a data URI without base64</source>
        <translation>base64 のないデータ URI があります</translation>
    </message>
    <message>
        <source>has a data URI that is not base64</source>
        <translation>base64 でないデータ URI があります</translation>
    </message>
    <message>
        <source>refers to %1, but only files in its own folder are read</source>
        <translation>%1 を参照していますが、読めるのは同じフォルダーのファイルだけです</translation>
    </message>
    <message>
        <source>refers to %1, which is not there</source>
        <translation>%1 を参照していますが、見つかりません</translation>
    </message>
    <message>
        <source>%1 has neither a uri nor a chunk of a .glb</source>
        <translation>%1 に uri も .glb のチャンクもありません</translation>
    </message>
    <message>
        <source>%1 has %2 of the %3 bytes it states</source>
        <translation>%1 は示された %3 バイトのうち %2 バイトしかありません</translation>
    </message>
    <message>
        <source>%1 reaches beyond its buffer</source>
        <translation>%1 がバッファーを越えています</translation>
    </message>
    <message>
        <source>has an accessor of an unknown componentType</source>
        <translation>componentType が未知のアクセサーがあります</translation>
    </message>
    <message>
        <source>%1 has a byteStride that is too small</source>
        <translation>%1 の byteStride が小さすぎます</translation>
    </message>
    <message>
        <source>has an accessor that reaches beyond %1</source>
        <translation>%1 を越えるアクセサーがあります</translation>
    </message>
    <message>
        <source>%1 holds a number that is not finite or beyond 1e9</source>
        <translation>%1 に有限でないか 1e9 を超える数値があります</translation>
    </message>
    <message>
        <source>accessor %1 is not %2</source>
        <translation>アクセサー %1 が %2 ではありません</translation>
    </message>
    <message>
        <source>states more zeros that have no bytes than are read</source>
        <translation>バイトのないゼロが読める数を超えています</translation>
    </message>
    <message>
        <source>%1 has sparse values without sense</source>
        <translation>%1 の疎な値が意味を成しません</translation>
    </message>
    <message>
        <source>%1 has a sparse value for an element that it has not</source>
        <translation>%1 に存在しない要素の疎な値があります</translation>
    </message>
    <message>
        <source>has a skin with %1 joints, but only %2 bind matrices</source>
        <translation>スキンの関節は %1 個ですが、バインド行列が %2 個しかありません</translation>
    </message>
    <message>
        <source>has a mesh packed without attributes</source>
        <translation>属性なしで圧縮されたメッシュがあります</translation>
    </message>
    <message>
        <source>has a packed mesh without the attributes it states</source>
        <translation>圧縮されたメッシュに示された属性がありません</translation>
    </message>
    <message>
        <source>has a mesh with more or fewer normals than positions</source>
        <translation>法線と位置の数が合わないメッシュがあります</translation>
    </message>
    <message>
        <source>has a triangle with a vertex that its mesh has not</source>
        <translation>メッシュにない頂点を使う三角形があります</translation>
    </message>
    <message>
        <source>has a mesh with more or fewer weights than positions</source>
        <translation>ウェイトと位置の数が合わないメッシュがあります</translation>
    </message>
    <message>
        <source>has a vertex on a joint that its skin has not</source>
        <translation>スキンにない関節に付いた頂点があります</translation>
    </message>
    <message>
        <source>has a mesh with more or fewer places in its picture than positions</source>
        <translation>テクスチャ座標と位置の数が合わないメッシュがあります</translation>
    </message>
    <message>
        <source>the motion is too large for a .glb: 4 GB are the most</source>
        <translation>動きが .glb には大きすぎます。上限は 4 GB です</translation>
    </message>
    <message>
        <source>verification: %1</source>
        <translation>検証：%1</translation>
    </message>
    <message>
        <source>no project: %1</source>
        <translation>プロジェクトではありません：%1</translation>
    </message>
    <message>
        <source>the preset &quot;%1&quot; %2</source>
        <translation>プリセット「%1」：%2</translation>
    </message>
    <message>
        <source>the compression %1</source>
        <translation>圧縮設定：%1</translation>
    </message>
    <message>
        <source>this clip cannot be written as .mcpr: %1</source>
        <translation>このクリップは .mcpr として書けません：%1</translation>
    </message>
    <message>
        <source>its tracks cannot be kept: %1</source>
        <translation>トラックを保存できません：%1</translation>
    </message>
    <message>
        <source>the name of joint %1... has %2 bytes, at most %3 are possible</source>
        <translation>関節 %1... の名前が %2 バイトです（最大 %3）</translation>
    </message>
    <message>
        <source>joint %1 has %2 channels, at most %3 are possible</source>
        <translation>関節 %1 のチャンネルが %2 個です（最大 %3）</translation>
    </message>
    <message>
        <source>joint %1 is too far away for 32-bit floats</source>
        <translation>関節 %1 が 32 ビット浮動小数点数には遠すぎます</translation>
    </message>
    <message>
        <source>it has no joints</source>
        <translation>関節がありません</translation>
    </message>
    <message>
        <source>its sample rate is not a positive number</source>
        <translation>サンプルレートが正の数ではありません</translation>
    </message>
    <message>
        <source>there are %1, at most %2 are possible</source>
        <translation>%1 個あります（最大 %2）</translation>
    </message>
    <message>
        <source>motion and tracks have %1 values, at most %2 are possible</source>
        <translation>動きとトラックの値が %1 個です（最大 %2）</translation>
    </message>
    <message>
        <source>an .asf of this skeleton would have %1 bones, at most %2 are possible</source>
        <translation>この骨格の .asf はボーンが %1 本になります（最大 %2）</translation>
    </message>
    <message>
        <source>%1, at most %2 are possible</source>
        <translation>%1（最大 %2）</translation>
    </message>
    <message>
        <source>%1 values (frames times channels)</source>
        <translation>値 %1 個（フレーム×チャンネル）</translation>
    </message>
    <message>
        <source>%1 values are too many for a motion of so few bytes</source>
        <translation>このバイト数の動きに値 %1 個は多すぎます</translation>
    </message>
    <message>
        <source>the name of one has more than %1 bytes</source>
        <translation>名前が %1 バイトを超えるものがあります</translation>
    </message>
    <message>
        <source>%1 has another number of frames than the clip</source>
        <translation>%1 のフレーム数がクリップと違います</translation>
    </message>
    <message>
        <source>%1 has a value that is not finite</source>
        <translation>%1 に有限でない値があります</translation>
    </message>
    <message>
        <source>the motion to be written is not coded yet</source>
        <translation>書く動きがまだ符号化されていません</translation>
    </message>
    <message>
        <source>the motion to be written lacks its finest bands</source>
        <translation>書く動きに最も細かい帯域がありません</translation>
    </message>
    <message>
        <source>an .amc holds one figure with one root, but this clip has %1 roots: .bvh and .glb can hold it</source>
        <translation>.amc に入るのはルートが 1 つの人形だけですが、このクリップにはルートが %1 個あります。.bvh か .glb なら書けます</translation>
    </message>
    <message>
        <source>a bone&apos;s name would be too long for an .asf: %1</source>
        <translation>.asf には長すぎるボーン名です：%1</translation>
    </message>
    <message>
        <source>in an .asf bones of this skeleton would be nested deeper than %1</source>
        <translation>.asf ではこの骨格のボーンの入れ子が %1 段を超えます</translation>
    </message>
    <message>
        <source>a joint is scaled to nothing: what hangs from it has no place</source>
        <translation>スケールが 0 の関節があり、その先の位置が定まりません</translation>
    </message>
    <message>
        <source>has no joint %1, which the motion has</source>
        <translation>動きにある関節 %1 がありません</translation>
    </message>
    <message>
        <source>scales %1 to nothing: it cannot follow a motion</source>
        <translation>%1 のスケールが 0 のため、動きに従えません</translation>
    </message>
    <message>
        <source>no feet were found on this skeleton: name the joints to be corrected</source>
        <translation>この骨格に足が見つかりません。補正する関節を指定してください</translation>
    </message>
    <message>
        <source>no joint above %1 can turn to move it</source>
        <translation>%1 を動かせる上の関節がありません</translation>
    </message>
    <message>
        <source>a chain of joints that ends at %1 does not begin at a joint above it that can turn</source>
        <translation>%1 で終わる関節の鎖が、回れる上の関節から始まっていません</translation>
    </message>
    <message>
        <source>more than %1 effectors</source>
        <translation>エフェクターが %1 個を超えています</translation>
    </message>
    <message>
        <source>these effectors are not one limb</source>
        <translation>これらのエフェクターは 1 本の肢を成しません</translation>
    </message>
    <message>
        <source>the importance of frames %1 to %2 is not a number from 1 to %3</source>
        <translation>フレーム %1～%2 の重要度が 1～%3 の数ではありません</translation>
    </message>
    <message>
        <source>frames %1 to %2 are not a range of the clip, which has %3 frames</source>
        <translation>フレーム %1～%2 は、%3 フレームのクリップの範囲ではありません</translation>
    </message>
    <message>
        <source>inverse kinematics can correct wavelet methods only</source>
        <translation>逆運動学で補正できるのはウェーブレットの手法だけです</translation>
    </message>
    <message>
        <source>the coefficient ratio is a target of wavelet methods only</source>
        <translation>係数比を目標にできるのはウェーブレットの手法だけです</translation>
    </message>
    <message>
        <source>is not a compressed form of the original: it has %1, the original %2</source>
        <translation>元の圧縮版ではありません。%1 で、元は %2 です</translation>
    </message>
    <message>
        <source>the clip has no frames</source>
        <translation>クリップにフレームがありません</translation>
    </message>
    <message>
        <source>the clip is not a loop</source>
        <translation>クリップがループではありません</translation>
    </message>
    <message>
        <source>the tracks are not those of the original</source>
        <translation>トラックが元のものではありません</translation>
    </message>
    <message>
        <source>the tracks have not as many frames as those of the original</source>
        <translation>トラックのフレーム数が元と違います</translation>
    </message>
    <message>
        <source>has an unknown method: %1</source>
        <translation>未知の手法です：%1</translation>
    </message>
    <message>
        <source>unknown method: %1</source>
        <translation>未知の手法です：%1</translation>
    </message>
    <message>
        <source>has a coding other than adaptive, the only one of the closed loop</source>
        <translation>閉ループでは適応型の符号化しか使えません</translation>
    </message>
    <message>
        <source>has a target that is not above 0</source>
        <translation>目標が 0 より大きくありません</translation>
    </message>
    <message>
        <source>has a coefficient ratio, a target of wavelet methods only</source>
        <translation>係数比を目標にできるのはウェーブレットの手法だけです</translation>
    </message>
    <message>
        <source>has a track error that is not above 0</source>
        <translation>トラックの誤差が 0 より大きくありません</translation>
    </message>
    <message>
        <source>has a promise that is not above 0: %1</source>
        <translation>約束の値が 0 より大きくありません：%1</translation>
    </message>
    <message>
        <source>has the effort draft, which does not promise its target</source>
        <translation>労力「ドラフト」は目標を約束しません</translation>
    </message>
    <message>
        <source>has an importance of frames that is not a number from 1 to %1</source>
        <translation>フレームの重要度が 1～%1 の数ではありません</translation>
    </message>
    <message>
        <source>has an importance of %1 that is not a number of 0 or more</source>
        <translation>%1 の重要度が 0 以上の数ではありません</translation>
    </message>
    <message>
        <source>has an IK correction, which can correct wavelet methods only</source>
        <translation>IK 補正を使えるのはウェーブレットの手法だけです</translation>
    </message>
    <message>
        <source>has an IK ratio that is not above 0</source>
        <translation>IK 比が 0 より大きくありません</translation>
    </message>
    <message>
        <source>%1 is not a JSON object</source>
        <translation>%1 が JSON オブジェクトではありません</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 が数値ではありません</translation>
    </message>
    <message>
        <source>%1 is not a whole number</source>
        <translation>%1 が整数ではありません</translation>
    </message>
    <message>
        <source>%1 is not a frame</source>
        <translation>%1 がフレームではありません</translation>
    </message>
    <message>
        <source>%1 is not above 0</source>
        <translation>%1 が 0 より大きくありません</translation>
    </message>
    <message>
        <source>%1 is below 0</source>
        <translation>%1 が 0 未満です</translation>
    </message>
    <message>
        <source>%1 is neither a number nor &quot;auto&quot;</source>
        <translation>%1 が数値でも &quot;auto&quot; でもありません</translation>
    </message>
    <message>
        <source>%1 is not a list of names</source>
        <translation>%1 が名前のリストではありません</translation>
    </message>
    <message>
        <source>%1 is not a list of contacts</source>
        <translation>%1 が接地のリストではありません</translation>
    </message>
    <message>
        <source>%1 is not a list of joints with a first and a last frame</source>
        <translation>%1 が最初と最後のフレームのある関節のリストではありません</translation>
    </message>
    <message>
        <source>%1 is not a list of ranges with a first and a last frame</source>
        <translation>%1 が最初と最後のフレームのある範囲のリストではありません</translation>
    </message>
    <message>
        <source>%1 is not a list of ranges</source>
        <translation>%1 が範囲のリストではありません</translation>
    </message>
    <message>
        <source>%1 of %2 is not a number</source>
        <translation>%1 の %2 が数値ではありません</translation>
    </message>
    <message>
        <source>%1 is &quot;%2&quot;, not one of %3</source>
        <translation>%1 が &quot;%2&quot; ですが、%3 のいずれかのはずです</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is unknown</source>
        <translation>&quot;%1&quot; は未知です</translation>
    </message>
    <message>
        <source>&quot;distance_m&quot; is not from %1 to %2</source>
        <translation>&quot;distance_m&quot; が %1～%2 ではありません</translation>
    </message>
    <message>
        <source>what should be limits is not a JSON object</source>
        <translation>限界値のはずが JSON オブジェクトではありません</translation>
    </message>
    <message>
        <source>a preset has no &quot;name&quot;</source>
        <translation>&quot;name&quot; のないプリセットがあります</translation>
    </message>
    <message>
        <source>holds no preset</source>
        <translation>プリセットがありません</translation>
    </message>
    <message>
        <source>is not JSON from here on</source>
        <translation>ここから先は JSON ではありません</translation>
    </message>
    <message>
        <source>holds a number that is too large</source>
        <translation>大きすぎる数値があります</translation>
    </message>
    <message>
        <source>nests its JSON more than %1 deep</source>
        <translation>JSON の入れ子が %1 段を超えています</translation>
    </message>
    <message>
        <source>holds too many JSON values</source>
        <translation>JSON の値が多すぎます</translation>
    </message>
    <message>
        <source>has a clip without a path</source>
        <translation>パスのないクリップがあります</translation>
    </message>
    <message>
        <source>is not a project: %1</source>
        <translation>プロジェクトではありません：%1</translation>
    </message>
    <message>
        <source>is not a project</source>
        <translation>プロジェクトではありません</translation>
    </message>
    <message>
        <source>was saved by a newer version of Mocapress</source>
        <translation>新しいバージョンの Mocapress で保存されています</translation>
    </message>
    <message>
        <source>was written by a newer version of Mocapress</source>
        <translation>新しいバージョンの Mocapress で書かれています</translation>
    </message>
    <message>
        <source>is no file of notes</source>
        <translation>メモのファイルではありません</translation>
    </message>
    <message>
        <source>has notes of another form: %1</source>
        <translation>メモの形式が違います：%1</translation>
    </message>
    <message>
        <source>holds the notes of a clip in another format</source>
        <translation>別の形式のクリップのメモです</translation>
    </message>
    <message>
        <source>the link is refused, for it names no clip by an absolute path on this computer: %1</source>
        <translation>リンクを開けません。このコンピューターの絶対パスでクリップを示していません：%1</translation>
    </message>
    <message>
        <source>is not a list of blind tests</source>
        <translation>ブラインドテストのリストではありません</translation>
    </message>
    <message>
        <source>a blind test has an unknown cue: %1</source>
        <translation>ブラインドテストに未知の手がかりがあります：%1</translation>
    </message>
    <message>
        <source>a blind test has a level that is not above 0</source>
        <translation>ブラインドテストに 0 より大きくないレベルがあります</translation>
    </message>
    <message>
        <source>a blind test lacks a value, or has one of another type</source>
        <translation>ブラインドテストに値がないか、型が違います</translation>
    </message>
    <message>
        <source>{%1} means nothing in a name: there are {folder}, {stem}, {type}, {preset} and {method}</source>
        <translation>{%1} は名前に使えません。使えるのは {folder}、{stem}、{type}、{preset}、{method} です</translation>
    </message>
    <message>
        <source>the name pattern has a { without its }: %1</source>
        <translation>名前の型に } のない { があります：%1</translation>
    </message>
    <message>
        <source>is not a file name below the batch&apos;s folder: %1</source>
        <translation>バッチのフォルダー以下のファイル名ではありません：%1</translation>
    </message>
    <message>
        <source>a bank is made of .mcpr files, which are not among the formats</source>
        <translation>バンクには .mcpr が必要ですが、書き出す形式にありません</translation>
    </message>
    <message>
        <source>only a packed bank is coded by what its clips teach</source>
        <translation>クリップに合わせて符号化できるのはパック済みバンクだけです</translation>
    </message>
    <message>
        <source>%1 exists: not overwritten</source>
        <translation>%1 はすでにあるため、上書きしません</translation>
    </message>
    <message>
        <source>%1 exists and is not this batch&apos;s: not overwritten</source>
        <translation>%1 はこのバッチのものではないため、上書きしません</translation>
    </message>
    <message>
        <source>%1 is a file that clips of this batch are made from</source>
        <translation>%1 はこのバッチのクリップの元のファイルです</translation>
    </message>
    <message>
        <source>is one of the inputs: not overwritten</source>
        <translation>入力の 1 つのため、上書きしません</translation>
    </message>
    <message>
        <source>reads back with another number of frames</source>
        <translation>読み戻すとフレーム数が違います</translation>
    </message>
    <message>
        <source>reads back without %1</source>
        <translation>読み戻すと %1 がありません</translation>
    </message>
    <message>
        <source>reads back %1 cm off at %2</source>
        <translation>読み戻すと %2 が %1 cm ずれています</translation>
    </message>
    <message>
        <source>the preset has a contact up to frame %1, but the clip ends before</source>
        <translation>プリセットの接地はフレーム %1 までですが、クリップはその前に終わります</translation>
    </message>
    <message>
        <source>%1 was asked for, but it came to %2</source>
        <translation>%1 を求めましたが、%2 になりました</translation>
    </message>
    <message>
        <source>%1 does not read back as it was written</source>
        <translation>%1 が書いたとおりに読み戻せません</translation>
    </message>
    <message>
        <source>the written file has another shape</source>
        <translation>書いたファイルの構成が違います</translation>
    </message>
    <message>
        <source>the written file cannot be read: %1</source>
        <translation>書いたファイルを読めません：%1</translation>
    </message>
    <message>
        <source>another run is using it: %1; if it is gone, its batch can be taken over</source>
        <translation>別の実行が使用中です：%1。それがもうなければ、そのバッチを引き継げます</translation>
    </message>
    <message>
        <source>another run is using it: %1</source>
        <translation>別の実行が使用中です：%1</translation>
    </message>
    <message>
        <source>another run is using it</source>
        <translation>別の実行が使用中です</translation>
    </message>
    <message>
        <source>%1 on %2, process %3, since %4</source>
        <translation>%2 の %1、プロセス %3、%4 から</translation>
    </message>
    <message>
        <source>cannot be listed, but holds clips that are done</source>
        <translation>一覧を読めませんが、完了したクリップがあります</translation>
    </message>
    <message>
        <source>is not the journal of a batch</source>
        <translation>バッチの記録ではありません</translation>
    </message>
    <message>
        <source>changed while it was read</source>
        <translation>読み込み中に変わりました</translation>
    </message>
    <message>
        <source>holds a batch already: it can be resumed or overwritten</source>
        <translation>すでにバッチがあります。再開または上書きできます</translation>
    </message>
    <message>
        <source>is not of the same batch as the others</source>
        <translation>ほかと同じバッチではありません</translation>
    </message>
    <message>
        <source>holds no journal of a batch</source>
        <translation>バッチの記録がありません</translation>
    </message>
    <message>
        <source>%1 has an unknown preset</source>
        <translation>%1 のプリセットが未知です</translation>
    </message>
    <message>
        <source>is not a queue of clips: %1</source>
        <translation>クリップの待ち行列ではありません：%1</translation>
    </message>
    <message>
        <source>is not a queue of clips</source>
        <translation>クリップの待ち行列ではありません</translation>
    </message>
    <message>
        <source>has an unknown format: %1</source>
        <translation>未知の形式です：%1</translation>
    </message>
    <message>
        <source>has an unknown form of bank: %1</source>
        <translation>未知のバンク形式です：%1</translation>
    </message>
    <message>
        <source>a script for sbatch cannot name %1: it has %2 in it</source>
        <translation>sbatch のスクリプトでは %1 を指定できません。%2が含まれています</translation>
    </message>
    <message>
        <source>a line break or another control character</source>
        <translation>改行などの制御文字</translation>
    </message>
    <message>
        <source>a backslash</source>
        <translation>バックスラッシュ</translation>
    </message>
    <message>
        <source>cannot be made: %1</source>
        <translation>作れません：%1</translation>
    </message>
    <message>
        <source>is written, but a power cut may undo it: its folder cannot be synchronised: %1</source>
        <translation>書きましたが、停電で失われることがあります。フォルダーを同期できません：%1</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>通常のファイルではありません</translation>
    </message>
    <message>
        <source>is a link that somebody else put into a folder shared by all</source>
        <translation>共有フォルダーに別の人が置いたリンクです</translation>
    </message>
    <message>
        <source>became shorter while it was read</source>
        <translation>読み込み中に短くなりました</translation>
    </message>
    <message>
        <source>takes more memory than this machine has to give</source>
        <translation>このコンピューターのメモリでは足りません</translation>
    </message>
    <message>
        <source>is a name that is not UTF-8</source>
        <translation>UTF-8 でない名前です</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>アクセスが許可されていません</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>操作が許可されていません</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>ディスクに空きがありません</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>ディスクの割り当てを超えました</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>読み取り専用のファイルシステムです</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>ファイル名が長すぎます</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>ファイルがすでにあります</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>フォルダーではありません</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>フォルダーです</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>開いているファイルが多すぎます</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>入出力エラー</translation>
    </message>
    <message>
        <source>Too many levels of symbolic links</source>
        <translation>シンボリックリンクの段数が多すぎます</translation>
    </message>
    <message>
        <source>a record has too few bytes for its values</source>
        <translation>レコードのバイト数が値に足りません</translation>
    </message>
    <message>
        <source>a record is smaller than its values</source>
        <translation>レコードが値より小さいです</translation>
    </message>
    <message>
        <source>a record reaches beyond its parent</source>
        <translation>レコードが親を越えています</translation>
    </message>
    <message>
        <source>a record ends before the place it states</source>
        <translation>レコードが示された位置より前に終わっています</translation>
    </message>
    <message>
        <source>a value reaches beyond its record</source>
        <translation>値がレコードを越えています</translation>
    </message>
    <message>
        <source>ends within a record</source>
        <translation>レコードの途中で終わっています</translation>
    </message>
    <message>
        <source>ends within an array</source>
        <translation>配列の途中で終わっています</translation>
    </message>
    <message>
        <source>ends within a value</source>
        <translation>値の途中で終わっています</translation>
    </message>
    <message>
        <source>ends within a text</source>
        <translation>テキストの途中で終わっています</translation>
    </message>
    <message>
        <source>has a value of an unknown type</source>
        <translation>型が未知の値があります</translation>
    </message>
    <message>
        <source>has a value outside of records</source>
        <translation>レコードの外に値があります</translation>
    </message>
    <message>
        <source>closes a record that is not open</source>
        <translation>開いていないレコードを閉じています</translation>
    </message>
    <message>
        <source>is not pictured in the report: %1</source>
        <translation>レポートに図がありません：%1</translation>
    </message>
    <message>
        <source>opens a record without a name</source>
        <translation>名前のないレコードを開いています</translation>
    </message>
    <message>
        <source>a finer tier without MOTN</source>
        <translation>MOTN がないのに細かい段があります</translation>
    </message>
    <message>
        <source>the first tier does not end where TIER says</source>
        <translation>最初の段が TIER の示すところで終わっていません</translation>
    </message>
    <message>
        <source>the file ends within a tier</source>
        <translation>ファイルが段の途中で終わっています</translation>
    </message>
    <message>
        <source>a tier is damaged: its checksum differs</source>
        <translation>段が壊れています。チェックサムが合いません</translation>
    </message>
    <message>
        <source>the sizes of the segments do not add up to MOTN or to a finer tier</source>
        <translation>セグメントの大きさの合計が MOTN や細かい段と合いません</translation>
    </message>
</context>
<context>
    <name>mocapress::Session</name>
    <message>
        <source>Import Options</source>
        <translation>読み込みオプション</translation>
    </message>
    <message>
        <source>Character</source>
        <translation>キャラクター</translation>
    </message>
</context>
<context>
    <name>mocapress::SettingsField</name>
    <message>
        <source>Target</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>手法</translation>
    </message>
    <message>
        <source>Weighting</source>
        <translation>重み付け</translation>
    </message>
    <message>
        <source>Coding</source>
        <translation>符号化</translation>
    </message>
    <message>
        <source>Held Feet</source>
        <translation>足の固定</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>接地</translation>
    </message>
    <message>
        <source>A or B</source>
        <translation>AまたはB</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>プリセット</translation>
    </message>
    <message>
        <source>Effort</source>
        <translation>労力</translation>
    </message>
    <message>
        <source>Importance</source>
        <translation>重要度</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>両端</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>トラック</translation>
    </message>
    <message>
        <source>Care in a Range</source>
        <translation>範囲の重視</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>ループ</translation>
    </message>
    <message>
        <source>Viewing Distance</source>
        <translation>視距離</translation>
    </message>
    <message>
        <source>Limits of Visibility</source>
        <translation>見え方の限界</translation>
    </message>
</context>
<context>
    <name>mocapress::Sight</name>
    <message>
        <source>not visible</source>
        <translation>見えない</translation>
    </message>
    <message>
        <source>borderline</source>
        <translation>境界</translation>
    </message>
    <message>
        <source>visible</source>
        <translation>見える</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>place about the body</source>
        <translation>体に対する位置</translation>
    </message>
    <message>
        <source>trembling</source>
        <translation>震え</translation>
    </message>
    <message>
        <source>sliding foot</source>
        <translation>足の滑り</translation>
    </message>
    <message>
        <source>floating foot</source>
        <translation>足の浮き</translation>
    </message>
    <message>
        <source>below the floor</source>
        <translation>床下</translation>
    </message>
    <message>
        <source>flight</source>
        <translation>空中の動き</translation>
    </message>
    <message>
        <source>turned head</source>
        <translation>頭の向き</translation>
    </message>
    <message>
        <source>turned hand</source>
        <translation>手の向き</translation>
    </message>
    <message>
        <source>%1: %2 %3, noticed from %4</source>
        <translation>%1：%2 %3（%4 から気付く）</translation>
    </message>
    <message>
        <source>%1 from %L2 m</source>
        <translation>%L2 m から%1</translation>
    </message>
</context>
<context>
    <name>mocapress::SightStrip</name>
    <message>
        <source>Visible errors</source>
        <translation>目に見える誤差</translation>
    </message>
    <message>
        <source>Times at which errors are visible. The heat map shows them by joint.</source>
        <translation>クリップの圧縮が人の目に付く箇所です。関節ごとの表示はヒートマップにあります。</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>見え方</translation>
    </message>
    <message>
        <source>Times at which errors are visible (full column) or borderline (half a column).</source>
        <translation>クリップの圧縮が人の目に付く箇所です。半分の高さは境界、全体の高さは見えることを表します。</translation>
    </message>
    <message>
        <source>%1, frame %L2</source>
        <translation>%1、フレーム %L2</translation>
    </message>
</context>
<context>
    <name>mocapress::SignOffExport</name>
    <message>
        <source>Export Sign-off</source>
        <translation>承認レポートを書き出す</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>ウェブページ (*.html)</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表 (*.csv)</translation>
    </message>
    <message>
        <source>Exported %1.</source>
        <translation>%1 を書き出しました。</translation>
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
        <translation>関節</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>Frames in which the foot of the original stands on the ground.</source>
        <translation>元が接地している間。</translation>
    </message>
    <message>
        <source>cm/s</source>
        <translation>cm/s</translation>
    </message>
    <message>
        <source>Highest speed over the ground.</source>
        <translation>地面に対する最大速度。</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>ずれ</translation>
    </message>
    <message>
        <source>Largest distance between the foot and its place in the original.</source>
        <translation>足が本来の接地位置から離れる距離。</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>軌跡</translation>
    </message>
    <message>
        <source>Path of the foot over the ground beyond the original&apos;s. A foot that trembles in place has a long path.</source>
        <translation>床の上の軌跡の長さのうち元を超える分。その場での震えも積算されます。</translation>
    </message>
</context>
<context>
    <name>mocapress::SlotControl</name>
    <message>
        <source>Settings %1</source>
        <translation>設定 %1</translation>
    </message>
    <message>
        <source>Two settings to compare: tune one, switch to the other (A), and compare the results.</source>
        <translation>比べるための2つの設定：一方を調整し、もう一方へ切り替え(A)て見比べます。</translation>
    </message>
    <message>
        <source>Copy settings to the other</source>
        <translation>設定をもう一方へコピー</translation>
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
        <translation>この設定を %1 にコピー</translation>
    </message>
</context>
<context>
    <name>mocapress::StudyClips</name>
    <message>
        <source>Remove</source>
        <translation>除く</translation>
    </message>
    <message>
        <source>Clips of the study</source>
        <translation>比較研究のクリップ</translation>
    </message>
    <message>
        <source>Drop files or folders here.</source>
        <translation>ファイルやフォルダーをここにドロップ。</translation>
    </message>
    <message>
        <source>Add Files…</source>
        <translation>ファイルを追加…</translation>
    </message>
    <message>
        <source>Add motions</source>
        <translation>モーションを追加</translation>
    </message>
    <message>
        <source>Add Folder…</source>
        <translation>フォルダーを追加…</translation>
    </message>
    <message>
        <source>Add every motion below a folder</source>
        <translation>フォルダー以下のモーションをすべて追加</translation>
    </message>
    <message>
        <source>Remove the selected clips from the list (Del)</source>
        <translation>選んだクリップを一覧から除く (Del)</translation>
    </message>
</context>
<context>
    <name>mocapress::StudyPanel</name>
    <message>
        <source>Also with feet held</source>
        <translation>足を固定した場合も</translation>
    </message>
    <message>
        <source>Progress of the study</source>
        <translation>比較研究の進行</translation>
    </message>
    <message>
        <source>Measurements that are already there are kept.</source>
        <translation>計測済みのものは計測し直しません。</translation>
    </message>
    <message>
        <source>Clips</source>
        <translation>クリップ</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>手法</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>Methods of the study</source>
        <translation>比較研究の手法</translation>
    </message>
    <message>
        <source>IK ratio of the study</source>
        <translation>比較研究のIK比</translation>
    </message>
    <message>
        <source>Coefficient ratio of the IK correction (r_IK).</source>
        <translation>補正信号をどれだけ圧縮するか (r_IK)。</translation>
    </message>
    <message>
        <source>:1</source>
        <translation>:1</translation>
    </message>
    <message>
        <source>Ratios to reach</source>
        <translation>目標の圧縮率</translation>
    </message>
    <message>
        <source>Compression ratios, separated by spaces.</source>
        <translation>圧縮率(空白区切り)。</translation>
    </message>
    <message>
        <source>Errors to keep, in cm</source>
        <translation>守る誤差 (cm)</translation>
    </message>
    <message>
        <source>Errors eps_x to compress to, in centimetres, separated by spaces.</source>
        <translation>eps_x の上限 (cm、空白区切り)。</translation>
    </message>
    <message>
        <source>Weighting of the study</source>
        <translation>比較研究の重み付け</translation>
    </message>
    <message>
        <source>Ratios</source>
        <translation>圧縮率</translation>
    </message>
    <message>
        <source>Errors (cm)</source>
        <translation>誤差 (cm)</translation>
    </message>
    <message>
        <source>Weighting</source>
        <translation>重み付け</translation>
    </message>
    <message>
        <source>Kept in</source>
        <translation>保存先</translation>
    </message>
    <message>
        <source>This computer&apos;s cache</source>
        <translation>このコンピューターのキャッシュ</translation>
    </message>
    <message>
        <source>Folder of the study: %1</source>
        <translation>比較研究のフォルダー：%1</translation>
    </message>
    <message>
        <source>Folder for measurements, from which a stopped study continues. Click to choose a folder; if it holds a study, that study is shown.
%1</source>
        <translation>計測結果の保存先。中断した比較研究は続きから再開します。クリックしてフォルダーを選ぶか、既存の比較研究を開きます。
%1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>中止</translation>
    </message>
    <message>
        <source>Run Study</source>
        <translation>比較研究を実行</translation>
    </message>
    <message>
        <source>Adds a curve of annealed wavelets with feet held by inverse kinematics, at the same ratios.</source>
        <translation>曲線を一つ追加します：焼きなましのウェーブレットで足を逆運動学により固定したものを、指定した比で。</translation>
    </message>
    <message>
        <source>Points on which the error eps_x is measured. Surface: a body modelled around the bones, so that turned heads and hands count. Shell: three points 3 cm from every joint, as in ACL. Bone ends and joint origins: points on the bones, weighted by bone length; joint origins are the paper&apos;s.</source>
        <translation>誤差 eps_x が数える点です。体表：骨の周りに作った体の表面の点。頭や手の回転も数えます。シェル：ACL と同じく、各関節から 3 cm の三点。骨の先端と関節原点：骨の長さで重み付けした骨上の点で、後者は論文のものです。</translation>
    </message>
</context>
<context>
    <name>mocapress::StudyResults</name>
    <message>
        <source>Clips shown</source>
        <translation>表示するクリップ</translation>
    </message>
    <message>
        <source>Show one clip, or the average: the geometric mean of all clips&apos; ratios at equal error, with the points of all clips behind it.</source>
        <translation>1つのクリップ、またはクリップの平均：同じ誤差での圧縮率の幾何平均。背後に全クリップの点。</translation>
    </message>
    <message>
        <source>S&amp;how</source>
        <translation>表示(&amp;H)</translation>
    </message>
    <message>
        <source>%1
Click to load it into the studio.</source>
        <translation>%1
クリックでスタジオに読み込みます。</translation>
    </message>
    <message>
        <source>Rows of the study</source>
        <translation>比較研究の行</translation>
    </message>
    <message numerus="yes">
        <source>Average over %Ln clip(s)</source>
        <translation>
            <numerusform>%Ln クリップの平均</numerusform>
        </translation>
    </message>
    <message>
        <source>All clips</source>
        <translation>すべてのクリップ</translation>
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
        <translation>最大 %L1 cm</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>%1:1, %2</source>
        <translation>%1:1、%2</translation>
    </message>
    <message>
        <source>eps_x %1 cm, at most %2 cm</source>
        <translation>eps_x %1 cm、最大 %2 cm</translation>
    </message>
    <message numerus="yes">
        <source>%1 cm of footskate in %Ln contact(s)</source>
        <translation>
            <numerusform>%Ln 回の接地で足滑り %1 cm</numerusform>
        </translation>
    </message>
    <message>
        <source>Asked for %1.</source>
        <translation>指定：%1。</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>クリップ</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>手法</translation>
    </message>
    <message>
        <source>Asked</source>
        <translation>指定</translation>
    </message>
    <message>
        <source>Target: a ratio, or the largest error allowed.</source>
        <translation>目標：圧縮率、または超えてはならない誤差。</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>圧縮率</translation>
    </message>
    <message>
        <source>Bytes of the channels as 32-bit floats, divided by compressed bytes.</source>
        <translation>32ビット浮動小数点のチャンネルと圧縮後のバイト数の比。</translation>
    </message>
    <message>
        <source>eps_x cm</source>
        <translation>eps_x cm</translation>
    </message>
    <message>
        <source>Weighted root mean square error.</source>
        <translation>重み付き二乗平均平方根誤差。</translation>
    </message>
    <message>
        <source>Max cm</source>
        <translation>最大 cm</translation>
    </message>
    <message>
        <source>Largest error of any point at any frame.</source>
        <translation>全フレーム・全点での最大誤差。</translation>
    </message>
    <message>
        <source>Slide cm</source>
        <translation>滑り cm</translation>
    </message>
    <message>
        <source>Path of feet while they stand in the original.</source>
        <translation>元で接地している間に足が滑る距離。</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>秒</translation>
    </message>
    <message>
        <source>Time to compress, including the search for the target.</source>
        <translation>目標の探索を含む圧縮時間。</translation>
    </message>
    <message>
        <source>%L1 times the noticeable error</source>
        <translation>知覚限界の %L1 倍</translation>
    </message>
</context>
<context>
    <name>mocapress::StudySession</name>
    <message>
        <source>The picture could not be made.</source>
        <translation>画像を作れませんでした。</translation>
    </message>
</context>
<context>
    <name>mocapress::StudyStatus</name>
    <message numerus="yes">
        <source>%Ln compression(s) to run</source>
        <translation>
            <numerusform>%Ln 件の圧縮を実行予定</numerusform>
        </translation>
    </message>
    <message>
        <source>%L1 of %L2</source>
        <translation>%L2 件中 %L1 件</translation>
    </message>
    <message>
        <source>%1, about %2 left</source>
        <translation>%1、残り約 %2</translation>
    </message>
    <message numerus="yes">
        <source>, %Ln out of reach</source>
        <translation>
            <numerusform>、%Ln 件は到達不可</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %Ln of clips that cannot be read</source>
        <translation>
            <numerusform>、%Ln 件は読めないクリップ</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln compression(s)%1</source>
        <translation>
            <numerusform>圧縮 %Ln 件%1</numerusform>
        </translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>書き込み中…</translation>
    </message>
    <message>
        <source>Drawing the report…</source>
        <translation>レポートを作成中…</translation>
    </message>
    <message>
        <source>Cancelled after %L1 of %L2; the next run continues from there</source>
        <translation>%L2 件中 %L1 件で中止。次回は続きから</translation>
    </message>
    <message>
        <source>Add a clip to study</source>
        <translation>比較するクリップを追加してください</translation>
    </message>
    <message>
        <source>Check a method to study</source>
        <translation>比較する手法を選んでください</translation>
    </message>
    <message>
        <source>Enter a ratio or an error</source>
        <translation>目標の圧縮率か誤差を入力してください</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>計測中…</translation>
    </message>
    <message>
        <source>Curves appear after the study has run</source>
        <translation>比較研究を実行すると曲線が出ます</translation>
    </message>
</context>
<context>
    <name>mocapress::StudyWindow</name>
    <message>
        <source>Study</source>
        <translation>比較研究</translation>
    </message>
    <message>
        <source>Wrote %1.</source>
        <translation>%1 を書きました。</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>エクスポート(&amp;E)</translation>
    </message>
    <message>
        <source>Write the measurements to a file</source>
        <translation>計測結果をファイルに書く</translation>
    </message>
    <message>
        <source>Rows as CSV…</source>
        <translation>行をCSVで…</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>カンマ区切り (*.csv)</translation>
    </message>
    <message>
        <source>Plot as PNG…</source>
        <translation>プロットをPNGで…</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>画像 (*.png)</translation>
    </message>
    <message>
        <source>Plot as PDF…</source>
        <translation>プロットをPDFで…</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>PDF文書 (*.pdf)</translation>
    </message>
    <message>
        <source>Report as HTML…</source>
        <translation>レポートをHTMLで…</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>ウェブページ (*.html)</translation>
    </message>
    <message>
        <source>Add Clips</source>
        <translation>クリップを追加</translation>
    </message>
    <message>
        <source>Motion (%1)</source>
        <translation>モーション (%1)</translation>
    </message>
    <message>
        <source>Add All Clips below</source>
        <translation>以下の全クリップを追加</translation>
    </message>
    <message>
        <source>Folder of the Study</source>
        <translation>比較研究のフォルダー</translation>
    </message>
    <message>
        <source>In the studio: %1, %2, %3.</source>
        <translation>スタジオに読み込み：%1、%2、%3。</translation>
    </message>
</context>
<context>
    <name>mocapress::TargetControl</name>
    <message>
        <source> bytes</source>
        <translation> バイト</translation>
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
        <translation>目標</translation>
    </message>
    <message>
        <source>Compression ratio</source>
        <translation>圧縮率</translation>
    </message>
    <message>
        <source>Error (eps_x)</source>
        <translation>誤差 (eps_x)</translation>
    </message>
    <message>
        <source>Target on a slider</source>
        <translation>目標のスライダー</translation>
    </message>
    <message>
        <source>Target value</source>
        <translation>目標値</translation>
    </message>
    <message>
        <source>Target as a number; type it or use the arrows.</source>
        <translation>目標の数値。入力または増減。</translation>
    </message>
    <message>
        <source>Hard maximum</source>
        <translation>絶対的な上限</translation>
    </message>
    <message>
        <source>Drag to change the target. A draft appears at once and is refined when you pause. What the preset promises of head, hands and fingers is kept beside an error.</source>
        <translation>ドラッグすると下書きがすぐに追い、手を止めると仕上げます。誤差を目標にする間は、プリセットが頭・手・指について約束する値も守られます。</translation>
    </message>
    <message>
        <source>Problem with the target</source>
        <translation>目標の問題</translation>
    </message>
    <message>
        <source>The target must be above zero.</source>
        <translation>0 では指定になりません。</translation>
    </message>
    <message>
        <source> times</source>
        <translation> 倍</translation>
    </message>
    <message>
        <source>Visibility</source>
        <translation>視認性</translation>
    </message>
    <message>
        <source>Sizes: the compression ratio (bytes of the channels as 32-bit floats, divided by compressed motion bytes) or the motion bytes themselves. Qualities: the weighted RMS error eps_x, the largest error of any point at any frame, or visibility, the largest error as a multiple of what people notice: at 1, no error is visible.</source>
        <translation>大きさ(圧縮率：32ビット浮動小数点のチャンネルと圧縮後の動きのバイト数の比、またはバイト数そのもの)か、品質(重み付き平均誤差 eps_x、またはどの関節もどのフレームでも超えない距離、またはどのずれも超えない「人が気づく差」の倍数: 1 なら何も見えません)を指定します。</translation>
    </message>
    <message>
        <source>Size of the motion</source>
        <translation>モーションのサイズ</translation>
    </message>
</context>
<context>
    <name>mocapress::TimeRuler</name>
    <message>
        <source>Time ruler</source>
        <translation>時間ルーラー</translation>
    </message>
    <message>
        <source>Frames and seconds. The menu Play chooses a range.</source>
        <translation>フレームと秒。範囲は再生メニューで選べます。</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>秒</translation>
    </message>
    <message>
        <source>Care</source>
        <translation>重視</translation>
    </message>
    <message>
        <source>Frames %L1–%L2: the target is %L3 times stricter. A click chooses the range.</source>
        <translation>フレーム %L1–%L2：目標が %L3 倍厳しくなります。クリックで範囲を選びます。</translation>
    </message>
    <message>
        <source>Drag to choose a range, then right-click it.</source>
        <translation>ドラッグで範囲を選び、右クリックします。</translation>
    </message>
    <message>
        <source>Frames %L1–%L2, %3. A double click chooses the whole clip again.</source>
        <translation>フレーム %L1–%L2、%3。ダブルクリックでクリップ全体に戻します。</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
</context>
<context>
    <name>mocapress::Timeline</name>
    <message>
        <source>Visible part of the clip</source>
        <translation>表示中の範囲</translation>
    </message>
    <message>
        <source>&amp;Poses</source>
        <translation>ポーズ(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Bytes</source>
        <translation>バイト(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Errors</source>
        <translation>誤差(&amp;E)</translation>
    </message>
    <message>
        <source>Visible E&amp;rrors</source>
        <translation>目につく誤差(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Notes</source>
        <translation>メモ(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Contacts</source>
        <translation>接地(&amp;C)</translation>
    </message>
</context>
<context>
    <name>mocapress::ToolWindows</name>
    <message>
        <source>The batch of this project is running. Stop it or wait until it ends.</source>
        <translation>このプロジェクトの一括書き出しが実行中です。先に停止するか、終わるまでお待ちください。</translation>
    </message>
</context>
<context>
    <name>mocapress::TransportBar</name>
    <message>
        <source>First Frame</source>
        <translation>最初のフレーム</translation>
    </message>
    <message>
        <source>Previous Frame</source>
        <translation>前のフレーム</translation>
    </message>
    <message>
        <source>Play or Pause</source>
        <translation>再生・一時停止</translation>
    </message>
    <message>
        <source>Next Frame</source>
        <translation>次のフレーム</translation>
    </message>
    <message>
        <source>Last Frame</source>
        <translation>最後のフレーム</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>ループ</translation>
    </message>
    <message>
        <source>Play Backwards; Press Again to Go Faster</source>
        <translation>逆再生、もう一度で高速</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Play Forwards; Press Again to Go Faster</source>
        <translation>順再生、もう一度で高速</translation>
    </message>
    <message>
        <source>Ten Frames Back</source>
        <translation>10フレーム戻る</translation>
    </message>
    <message>
        <source>Ten Frames On</source>
        <translation>10フレーム進む</translation>
    </message>
    <message>
        <source>Play from Here</source>
        <translation>ここから再生</translation>
    </message>
    <message>
        <source>Play to Here</source>
        <translation>ここまで再生</translation>
    </message>
    <message>
        <source>Play the Whole Clip</source>
        <translation>クリップ全体を再生</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>Drag to any frame.</source>
        <translation>任意のフレームへドラッグ。</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>Frame read-out</source>
        <translation>フレーム表示</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速さ</translation>
    </message>
    <message>
        <source>Playing speed; 1× is the recorded speed.</source>
        <translation>再生速度。1×が記録どおり。</translation>
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
        <translation>テイク</translation>
    </message>
    <message>
        <source>Animation of the file to read.</source>
        <translation>ファイルのどのアニメーションを読むかを選びます。</translation>
    </message>
</context>
<context>
    <name>mocapress::ViewActions</name>
    <message>
        <source>&amp;Overlay</source>
        <translation>重ねる(&amp;O)</translation>
    </message>
    <message>
        <source>The original as a ghost over the compressed figure</source>
        <translation>元をゴーストとして圧縮後の人形に重ねる</translation>
    </message>
    <message>
        <source>&amp;Side by Side</source>
        <translation>並べる(&amp;S)</translation>
    </message>
    <message>
        <source>Original and compressed figure beside each other</source>
        <translation>元と圧縮後の人形を並べる</translation>
    </message>
    <message>
        <source>&amp;Wipe</source>
        <translation>ワイプ(&amp;W)</translation>
    </message>
    <message>
        <source>Original on one side of a divider that can be dragged, compressed figure on the other</source>
        <translation>境界線を動かせる1枚の絵、再生中も</translation>
    </message>
    <message>
        <source>Sw&amp;ap</source>
        <translation>入れ替え(&amp;A)</translation>
    </message>
    <message>
        <source>Swap original and compressed figure</source>
        <translation>元と圧縮後の人形を入れ替える</translation>
    </message>
    <message>
        <source>&amp;Blink</source>
        <translation>交互に表示(&amp;B)</translation>
    </message>
    <message>
        <source>Original and compressed figure take turns in one place</source>
        <translation>元と圧縮後の人形を同じ場所で交互に表示</translation>
    </message>
    <message>
        <source>Colour by &amp;Error</source>
        <translation>誤差で色分け(&amp;E)</translation>
    </message>
    <message>
        <source>Colour every joint by its distance from the original, in cm</source>
        <translation>各関節を元との距離(cm)で色分け</translation>
    </message>
    <message>
        <source>Show Skin</source>
        <translation>スキンを表示</translation>
    </message>
    <message>
        <source>Show figures with their skin or as skeletons</source>
        <translation>フィギュアをスキン付き、またはスケルトンで表示します</translation>
    </message>
    <message>
        <source>&amp;Path of the Joint</source>
        <translation>関節の軌跡(&amp;P)</translation>
    </message>
    <message>
        <source>Path of the selected joint, half a second before and after the current frame</source>
        <translation>選んだ関節の前後0.5秒の軌跡</translation>
    </message>
    <message>
        <source>&amp;Follow</source>
        <translation>追従(&amp;F)</translation>
    </message>
    <message>
        <source>The camera moves with the figure</source>
        <translation>カメラが人形とともに動く</translation>
    </message>
    <message>
        <source>I&amp;n Place</source>
        <translation>その場(&amp;N)</translation>
    </message>
    <message>
        <source>Play without the root&apos;s travel over the ground</source>
        <translation>ルートの移動なしで再生</translation>
    </message>
    <message>
        <source>F&amp;loor View</source>
        <translation>上から見る(&amp;L)</translation>
    </message>
    <message>
        <source>Look straight down, as on a plan</source>
        <translation>平面図のように真上から見る</translation>
    </message>
    <message>
        <source>&amp;Reset Camera</source>
        <translation>カメラをリセット(&amp;R)</translation>
    </message>
    <message>
        <source>Look at the whole figure again</source>
        <translation>人形全体を見直す</translation>
    </message>
    <message>
        <source>Ghost &amp;Trail</source>
        <translation>ゴーストの軌跡(&amp;T)</translation>
    </message>
    <message>
        <source>Faded poses of the compressed figure before (blue) and after (orange) the current frame</source>
        <translation>圧縮後の人形の過去（青）と未来（オレンジ）の姿勢を薄く表示します</translation>
    </message>
    <message numerus="yes">
        <source>%Ln pose(s) before and after</source>
        <translation>
            <numerusform>前後 %Ln 姿勢ずつ</numerusform>
        </translation>
    </message>
    <message>
        <source>Poses of the Tra&amp;il</source>
        <translation>軌跡の姿勢数(&amp;I)</translation>
    </message>
    <message>
        <source>Fo&amp;ur Views</source>
        <translation>四面ビュー(&amp;U)</translation>
    </message>
    <message>
        <source>The same figures from anywhere, from the front, the side and the top</source>
        <translation>同じ人形を自由な角度、正面、側面、上面から表示します</translation>
    </message>
    <message>
        <source>E&amp;xaggerate the Difference</source>
        <translation>差を誇張(&amp;X)</translation>
    </message>
    <message>
        <source>Show poses and paths with a difference from the original that is so many times larger than it is</source>
        <translation>元との差を指定倍に拡大してポーズと軌跡を表示します</translation>
    </message>
    <message>
        <source>%L1 times</source>
        <translation>%L1 倍</translation>
    </message>
    <message>
        <source>From the Fro&amp;nt</source>
        <translation>正面から(&amp;N)</translation>
    </message>
    <message>
        <source>Look along the z axis; again: as before</source>
        <translation>z 軸方向から見ます。もう一度で元に戻ります</translation>
    </message>
    <message>
        <source>From the S&amp;ide</source>
        <translation>側面から(&amp;I)</translation>
    </message>
    <message>
        <source>Look along the x axis; again: as before</source>
        <translation>x 軸方向から見ます。もう一度で元に戻ります</translation>
    </message>
    <message>
        <source>Frame &amp;Joint</source>
        <translation>関節を画面に収める(&amp;J)</translation>
    </message>
    <message>
        <source>Look at the selected joint, or at the whole figure without one</source>
        <translation>選択した関節（なければ人形全体）を見ます</translation>
    </message>
    <message>
        <source>Camera &amp;%L1</source>
        <translation>カメラ &amp;%L1</translation>
    </message>
    <message>
        <source>Look from where the camera was when it was kept</source>
        <translation>保存したときのカメラ位置から見ます</translation>
    </message>
    <message>
        <source>Keep as Camera %L1</source>
        <translation>カメラ %L1 として保存</translation>
    </message>
    <message>
        <source>Keep the camera&apos;s place, relative to the figure</source>
        <translation>人形に対するカメラの位置を保存します</translation>
    </message>
    <message>
        <source>Exaggeration</source>
        <translation>誇張の倍率</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>カメラ</translation>
    </message>
</context>
<context>
    <name>mocapress::ViewPictures</name>
    <message>
        <source>Making the video…</source>
        <translation>動画を作成しています…</translation>
    </message>
    <message>
        <source>Wrote %1.</source>
        <translation>%1 を書き出しました。</translation>
    </message>
    <message>
        <source>The 3D view gave no picture.</source>
        <translation>3D ビューから画像を得られませんでした。</translation>
    </message>
    <message>
        <source>Copied the picture of the view.</source>
        <translation>ビューの画像をコピーしました。</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>画像を保存</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>画像 (*.png)</translation>
    </message>
    <message>
        <source>Film of the Range</source>
        <translation>範囲の動画</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>ターンテーブル</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.webm *.gif)</source>
        <translation>動画 (*.mp4 *.webm *.gif)</translation>
    </message>
    <message>
        <source>Numbered pictures in a folder (*.png)</source>
        <translation>フォルダー内の連番画像 (*.png)</translation>
    </message>
    <message numerus="yes">
        <source>Taking %Ln picture(s)…</source>
        <translation>
            <numerusform>%Ln 枚の画像を撮影しています…</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
</context>
<context>
    <name>mocapress::Viewport</name>
    <message>
        <source>The 3D view needs OpenGL 3.2, which is not available here.</source>
        <translation>3Dビューに必要なOpenGL 3.2がここでは使えません。</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3Dビュー</translation>
    </message>
</context>
</TS>
