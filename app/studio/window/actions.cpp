// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/actions.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QUndoGroup>
#include <algorithm>
#include <array>

#include "app/studio/window/commands.h"
#include "core/report/review_page.h"
#include "widgets/icons/themed_icon.h"

namespace mocapress {

namespace {

struct Texts {
  Q_DECLARE_TR_FUNCTIONS(mocapress::Actions)
};

QAction* make(QObject* parent, const QString& text, const QKeySequence& shortcut = {},
              const QString& icon = {}) {
  auto* action = new QAction(text, parent);
  action->setShortcut(shortcut);
  if (!icon.isEmpty()) action->setIcon(themedIcon(icon));
  return action;
}

/// Makes exclusive choices and checks the first.
QActionGroup* makeChoices(QObject* parent, const QList<std::pair<QString, QVariant>>& choices) {
  auto* group = new QActionGroup(parent);
  for (const auto& [text, value] : choices) {
    QAction* action = group->addAction(text);
    action->setCheckable(true);
    action->setData(value);
  }
  group->actions().front()->setChecked(true);
  return group;
}

void addToolBar(QMainWindow* window, const Actions& actions) {
  QToolBar* bar = window->addToolBar(Texts::tr("Tools"));
  bar->setObjectName(QStringLiteral("tools"));
  bar->setMovable(false);
  bar->setIconSize({20, 20});
  bar->setToolButtonStyle(Qt::ToolButtonIconOnly);
  bar->addActions({actions.open, actions.save});
  bar->addSeparator();
  bar->addActions({actions.undo, actions.redo});
  bar->addSeparator();
  addInGroups(bar, actions.view);
  bar->addActions({actions.next_worst, actions.without_ik, actions.pin});
}

}  // namespace

Actions makeActions(Playback* playback, QUndoGroup* history, QMainWindow* window) {
  Actions actions;
  actions.open =
      make(window, Texts::tr("&Open…"), QKeySequence::Open, QStringLiteral("folder-open"));
  actions.open->setToolTip(Texts::tr("Open a motion or a compressed clip (.mcpr)"));
  actions.open_sample = make(window, Texts::tr("Open Sample &Walk"));
  actions.choose_skeleton = make(window, Texts::tr("Choose Skeleton…"));
  actions.compare = make(window, Texts::tr("&Compare with Original…"));
  actions.save =
      make(window, Texts::tr("&Save Compressed Clip"), QKeySequence::Save, QStringLiteral("save"));
  actions.save->setToolTip(Texts::tr("Save the compressed clip as .mcpr"));
  actions.save_as = make(window, Texts::tr("Save Compressed Clip &As…"), QKeySequence::SaveAs);
  actions.save_as->setToolTip(
      Texts::tr("Save as .mcpr, .bvh, .fbx, .glb, .amc with its .asf, or .csv"));
  actions.export_motion =
      make(window, Texts::tr("E&xport Motion…"), Qt::CTRL | Qt::SHIFT | Qt::Key_E);
  actions.export_motion->setToolTip(
      Texts::tr("Write the decompressed motion with the unit, axes and rate of its source"));
  actions.export_review = make(window, Texts::tr("Export Review Pa&ge…"));
  actions.export_review->setToolTip(
      Texts::tr("Write a web page that shows original and compressed clip"));
  actions.export_review->setVisible(has_review_viewer());
  actions.copy_picture =
      make(window, Texts::tr("Copy Pict&ure of the View"), Qt::CTRL | Qt::SHIFT | Qt::Key_C);
  actions.save_picture = make(window, Texts::tr("Save Picture of the &View…"));
  actions.film = make(window, Texts::tr("&Film of the Range…"));
  actions.film->setToolTip(
      Texts::tr("Write the chosen range, or the clip, as a video or as numbered pictures"));
  actions.turntable = make(window, Texts::tr("&Turntable…"));
  actions.turntable->setToolTip(
      Texts::tr("Write this frame from all sides as a video or as numbered pictures"));
  actions.import_options = make(window, Texts::tr("&Import Options…"));
  actions.import_options->setToolTip(
      Texts::tr("Read the open motion again with another length unit, up axis, frame rate or root "
                "convention"));
  actions.put_character = make(window, Texts::tr("Put a C&haracter on It…"));
  actions.put_character->setToolTip(
      Texts::tr("Show the clip, and all clips with the same rig, on the mesh of an FBX or glTF "
                "whose joints have the same names"));
  actions.take_character_off = make(window, Texts::tr("Ta&ke Its Character Off"));
  actions.take_character_off->setToolTip(
      Texts::tr("Show the clip, and all clips with the same rig, as in their files"));
  actions.batch = make(window, Texts::tr("&Batch Export…"), Qt::CTRL | Qt::Key_E);
  actions.batch->setToolTip(
      Texts::tr("Compress many clips, verify each of them and write a report"));
  actions.export_library = make(window, Texts::tr("Batch Export of the &Library…"));
  actions.export_library->setToolTip(
      Texts::tr("Export all clips of the library, each with its own settings"));
  actions.export_sign_off = make(window, Texts::tr("Ex&port Sign-off…"));
  actions.export_sign_off->setToolTip(
      Texts::tr("Write verdicts, worst frames and notes of the library as HTML, PDF or CSV"));
  actions.compare_batch = make(window, Texts::tr("Co&mpare Library with a Batch…"));
  actions.compare_batch->setToolTip(
      Texts::tr("Show what got larger, worse or newly visible since an earlier batch or project"));
  actions.add_clips = make(window, Texts::tr("A&dd Clips to Library…"));
  actions.add_folder = make(window, Texts::tr("Add &Folder to Library…"));
  actions.new_project = make(window, Texts::tr("&New Project"), QKeySequence::New);
  actions.open_project = make(window, Texts::tr("Open Pro&ject…"));
  actions.save_project = make(window, Texts::tr("Sa&ve Project As…"));
  actions.switch_slot = make(window, Texts::tr("Switch between &A and B"), Qt::Key_A);
  actions.copy_slot = make(window, Texts::tr("&Copy Settings to the Other"), Qt::SHIFT | Qt::Key_A);
  actions.pin = make(window, Texts::tr("&Pin This Result"), Qt::Key_D, QStringLiteral("pin"));
  actions.pin->setToolTip(
      Texts::tr("Keep this result in the view beside results of other settings (D)"));
  actions.pin_engine =
      make(window, Texts::tr("Pin What an &Engine Would Do"), Qt::SHIFT | Qt::Key_D);
  actions.pin_engine->setToolTip(
      Texts::tr("Compress the clip track by track, with key frames, to the same number of bytes, "
                "and show it beside this result"));
  actions.quit = make(window, Texts::tr("&Quit"), QKeySequence::Quit);
  actions.undo = history->createUndoAction(window, Texts::tr("&Undo"));
  actions.undo->setShortcut(QKeySequence::Undo);
  actions.undo->setProperty(kLastingName, Texts::tr("&Undo"));
  actions.undo->setIcon(themedIcon(QStringLiteral("undo")));
  actions.redo = history->createRedoAction(window, Texts::tr("&Redo"));
  actions.redo->setShortcut(QKeySequence::Redo);
  actions.redo->setProperty(kLastingName, Texts::tr("&Redo"));
  actions.redo->setIcon(themedIcon(QStringLiteral("redo")));
  actions.next_worst =
      make(window, Texts::tr("Next &Worst Frame"), Qt::Key_N, QStringLiteral("worst"));
  actions.next_worst->setToolTip(
      Texts::tr("Go to the frame with the largest error, then to the next largest (N)"));
  actions.previous_worst = make(window, Texts::tr("P&revious Worst Frame"), Qt::SHIFT | Qt::Key_N);
  actions.next_review = make(window, Texts::tr("Next to &Review"), Qt::Key_Q);
  actions.next_review->setToolTip(Texts::tr("Open the next clip that waits for a verdict (Q)"));
  actions.approve = make(window, Texts::tr("&Approve, and Next"), Qt::CTRL | Qt::Key_Return);
  actions.reject = make(window, Texts::tr("Re&ject, and Next"), Qt::CTRL | Qt::Key_Backspace);
  actions.note_here = make(window, Texts::tr("&Note on This Frame…"), Qt::CTRL | Qt::Key_M);
  actions.note_here->setToolTip(Texts::tr(
      "Write a note on the frame that is shown and the joint that is chosen. A click with "
      "Ctrl in the picture writes one on a place there."));
  actions.note_on_range =
      make(window, Texts::tr("Note on the Ran&ge…"), Qt::CTRL | Qt::SHIFT | Qt::Key_M);
  actions.note_on_range->setToolTip(
      Texts::tr("Write a note on the chosen range and the joint that is chosen"));
  actions.next_note = make(window, Texts::tr("Next No&te"), Qt::SHIFT | Qt::Key_M);
  actions.write_notes = make(window, Texts::tr("&Write Notes beside the Clips"));
  actions.write_notes->setToolTip(
      Texts::tr("Write the notes of each clip to NAME.notes.json in its folder"));
  actions.read_notes = make(window, Texts::tr("Rea&d Notes beside the Clips"));
  actions.read_notes->setToolTip(
      Texts::tr("Add notes from the files NAME.notes.json beside the clips"));
  actions.copy_link =
      make(window, Texts::tr("Copy &Link to This Frame"), Qt::CTRL | Qt::SHIFT | Qt::Key_L);
  actions.copy_link->setToolTip(
      Texts::tr("Copy a link that opens this clip, frame, joint and view"));
  actions.compare_range = make(window, Texts::tr("Compare in the Ran&ge"), Qt::SHIFT | Qt::Key_C);
  actions.compare_range->setToolTip(
      Texts::tr("Loop the chosen range with both figures side by side, and show its errors alone"));
  actions.hold_feet = make(window, Texts::tr("&Hold Feet"), Qt::Key_I);
  actions.hold_feet->setToolTip(Texts::tr("Compress with or without inverse kinematics (I)"));
  actions.without_ik =
      make(window, Texts::tr("Without I&K"), Qt::Key_B, QStringLiteral("without-ik"));
  actions.without_ik->setCheckable(true);
  actions.without_ik->setToolTip(
      Texts::tr("Show the compressed figure without the IK correction of its feet (B)"));
  actions.panels_below = make(window, Texts::tr("Fold Panels Below"), Qt::CTRL | Qt::Key_J);
  actions.panels_below->setToolTip(
      Texts::tr("Fold the panels below the timeline to their tabs, or unfold them"));
  actions.reset_layout = make(window, Texts::tr("Reset La&yout"));
  actions.study = make(window, Texts::tr("&Study…"), Qt::CTRL | Qt::Key_T);
  actions.study->setToolTip(
      Texts::tr("Compare the file sizes and errors of methods on many clips"));
  actions.blind_test = make(window, Texts::tr("&Blind Test…"));
  actions.blind_test->setToolTip(
      Texts::tr("Find out from which error on you tell the compressed clip from the original"));
  actions.guide = make(window, Texts::tr("&Guide"), QKeySequence::HelpContents);
  actions.shortcuts = make(window, Texts::tr("&Keyboard Shortcuts"), Qt::Key_Question);
  actions.find_command =
      make(window, Texts::tr("&Find a Command…"), Qt::CTRL | Qt::SHIFT | Qt::Key_P);
  actions.keyboard_map = make(window, Texts::tr("Keyboard &Map…"));
  actions.keyboard_map->setToolTip(Texts::tr("Choose the keys of all commands"));
  actions.themes = makeChoices(
      window,
      {{Texts::tr("Like the &System"), 0}, {Texts::tr("&Light"), 1}, {Texts::tr("&Dark"), 2}});
  // Each language is named in itself, so that its speakers can read the name.
  actions.languages = makeChoices(window, {{Texts::tr("Like the &System"), QString()},
                                           {QStringLiteral("English"), QStringLiteral("en")},
                                           {QStringLiteral("Español"), QStringLiteral("es")},
                                           {QStringLiteral("Français"), QStringLiteral("fr")},
                                           {QStringLiteral("日本語"), QStringLiteral("ja")}});
  actions.about = make(window, Texts::tr("&About Mocapress"));
  actions.view = makeViewActions(window);
  actions.transport = TransportBar::makeActions(playback, window);
  return actions;
}

void nameActions(const Actions& actions) {
  const ViewActions& view = actions.view;
  const TransportActions& play = actions.transport;
  const std::pair<const char*, QAction*> names[] = {
      {"open", actions.open},
      {"open-sample", actions.open_sample},
      {"compare", actions.compare},
      {"save", actions.save},
      {"save-as", actions.save_as},
      {"export-motion", actions.export_motion},
      {"export-review", actions.export_review},
      {"copy-picture", actions.copy_picture},
      {"save-picture", actions.save_picture},
      {"film", actions.film},
      {"turntable", actions.turntable},
      {"import-options", actions.import_options},
      {"put-character", actions.put_character},
      {"take-character-off", actions.take_character_off},
      {"batch", actions.batch},
      {"export-library", actions.export_library},
      {"export-sign-off", actions.export_sign_off},
      {"compare-batch", actions.compare_batch},
      {"add-clips", actions.add_clips},
      {"add-folder", actions.add_folder},
      {"new-project", actions.new_project},
      {"open-project", actions.open_project},
      {"save-project", actions.save_project},
      {"quit", actions.quit},
      {"switch-slot", actions.switch_slot},
      {"copy-slot", actions.copy_slot},
      {"pin", actions.pin},
      {"pin-engine", actions.pin_engine},
      {"undo", actions.undo},
      {"redo", actions.redo},
      {"next-review", actions.next_review},
      {"approve", actions.approve},
      {"reject", actions.reject},
      {"note-here", actions.note_here},
      {"note-on-range", actions.note_on_range},
      {"next-note", actions.next_note},
      {"write-notes", actions.write_notes},
      {"read-notes", actions.read_notes},
      {"copy-link", actions.copy_link},
      {"compare-range", actions.compare_range},
      {"next-worst", actions.next_worst},
      {"previous-worst", actions.previous_worst},
      {"hold-feet", actions.hold_feet},
      {"without-ik", actions.without_ik},
      {"panels-below", actions.panels_below},
      {"reset-layout", actions.reset_layout},
      {"study", actions.study},
      {"blind-test", actions.blind_test},
      {"guide", actions.guide},
      {"shortcuts", actions.shortcuts},
      {"find-command", actions.find_command},
      {"keyboard-map", actions.keyboard_map},
      {"about", actions.about},
      {"in-degrees", actions.in_degrees},
      {"as-seen", actions.as_seen},
      {"overlay", view.mode[0]},
      {"side-by-side", view.mode[1]},
      {"wipe", view.mode[2]},
      {"four-views", view.quarters},
      {"swap", view.swap},
      {"blink", view.blink},
      {"by-error", view.by_error},
      {"skin", view.skin},
      {"path", view.path},
      {"trail", view.trail},
      {"exaggerate", view.exaggerate},
      {"in-place", view.in_place},
      {"front", view.front},
      {"side", view.side},
      {"floor", view.floor},
      {"follow", view.follow},
      {"reset-camera", view.reset_camera},
      {"frame-joint", view.frame_joint},
      {"first", play.first},
      {"previous", play.previous},
      {"play", play.play},
      {"next", play.next},
      {"last", play.last},
      {"loop", play.loop},
      {"backwards", play.backwards},
      {"halt", play.halt},
      {"forwards", play.forwards},
      {"ten-back", play.ten_back},
      {"ten-on", play.ten_on},
      {"range-from", play.range_from},
      {"range-to", play.range_to},
      {"whole-clip", play.whole_clip}};
  for (const auto& [name, action] : names) action->setObjectName(QString::fromLatin1(name));
  for (std::size_t i = 0; i < view.go_to.size(); ++i) {
    view.go_to[i]->setObjectName(QStringLiteral("camera-%1").arg(i + 1));
    view.keep[i]->setObjectName(QStringLiteral("keep-camera-%1").arg(i + 1));
  }
}

RecentMenus addMenus(QMainWindow* window, const Actions& actions,
                     const QList<QDockWidget*>& docks) {
  RecentMenus recent;
  QMenu* file = window->menuBar()->addMenu(Texts::tr("&File"));
  file->addAction(actions.open);
  recent.files = file->addMenu(Texts::tr("Open &Recent"));
  file->addActions({actions.open_sample, actions.compare, actions.import_options,
                    actions.put_character, actions.take_character_off});
  file->addSeparator();
  file->addActions({actions.new_project, actions.open_project});
  recent.projects = file->addMenu(Texts::tr("Recent Projec&ts"));
  file->addActions({actions.save_project, actions.add_clips, actions.add_folder});
  file->addSeparator();
  file->addActions({actions.save, actions.save_as, actions.export_motion, actions.export_review});
  QMenu* pictures = file->addMenu(Texts::tr("Pict&ures and Films"));
  pictures->addActions(
      {actions.copy_picture, actions.save_picture, actions.film, actions.turntable});
  file->addSeparator();
  file->addActions(
      {actions.batch, actions.export_library, actions.compare_batch, actions.export_sign_off});
  file->addSeparator();
  file->addAction(actions.quit);

  QMenu* edit = window->menuBar()->addMenu(Texts::tr("&Edit"));
  edit->addActions({actions.undo, actions.redo});
  edit->addSeparator();
  edit->addActions({actions.switch_slot, actions.copy_slot, actions.pin, actions.pin_engine});

  QMenu* play = window->menuBar()->addMenu(Texts::tr("&Play"));
  const TransportActions& transport = actions.transport;
  play->addActions({transport.play, transport.backwards, transport.halt, transport.forwards});
  play->addSeparator();
  play->addActions({transport.previous, transport.next, transport.ten_back, transport.ten_on,
                    transport.first, transport.last});
  play->addSeparator();
  play->addActions({actions.next_worst, actions.previous_worst});
  play->addSeparator();
  play->addActions({transport.loop, transport.range_from, transport.range_to, transport.whole_clip,
                    actions.compare_range});
  recent.play = play;

  window->menuBar()
      ->addMenu(Texts::tr("&Review"))
      ->addActions({actions.next_review, actions.approve, actions.reject, actions.note_here,
                    actions.note_on_range, actions.next_note, actions.write_notes,
                    actions.read_notes, actions.copy_link});

  QMenu* view = window->menuBar()->addMenu(Texts::tr("&View"));
  addInGroups(view, actions.view);
  view->addAction(actions.view.by_error);
  QMenu* scales = view->addMenu(Texts::tr("Colours and S&cales"));
  scales->addActions({actions.in_degrees, actions.as_seen});
  scales->addMenu(Texts::tr("Error S&cale"))->addActions(actions.error_scales->actions());
  scales->addMenu(Texts::tr("Angle Scale"))->addActions(actions.angle_scales->actions());
  view->addActions({actions.hold_feet, actions.without_ik});
  view->addSeparator();
  QMenu* panels = view->addMenu(Texts::tr("Pane&ls"));
  for (const QDockWidget* dock : docks) panels->addAction(dock->toggleViewAction());
  panels->addSeparator();
  panels->addActions({actions.panels_below, actions.reset_layout});
  recent.timeline = view->addMenu(Texts::tr("Timeline"));
  view->addMenu(Texts::tr("The&me"))->addActions(actions.themes->actions());
  view->addMenu(Texts::tr("Lan&guage"))->addActions(actions.languages->actions());

  window->menuBar()->addMenu(Texts::tr("&Tools"))->addActions({actions.study, actions.blind_test});

  window->menuBar()
      ->addMenu(Texts::tr("&Help"))
      ->addActions({actions.find_command, actions.guide, actions.shortcuts, actions.keyboard_map,
                    actions.about});
  addToolBar(window, actions);
  return recent;
}

namespace {

bool isOneOf(const QKeyEvent& key, std::initializer_list<QKeySequence::StandardKey> keys) {
  return std::any_of(keys.begin(), keys.end(),
                     [&key](QKeySequence::StandardKey standard) { return key.matches(standard); });
}

/// True for keys that edit text on every desktop; X11 adds others.
bool editsText(const QKeyEvent& key) {
  return isOneOf(key, {QKeySequence::Copy, QKeySequence::Cut, QKeySequence::Paste,
                       QKeySequence::SelectAll}) ||
         key.key() == Qt::Key_Left || key.key() == Qt::Key_Right || key.key() == Qt::Key_Home ||
         key.key() == Qt::Key_End || key.key() == Qt::Key_Backspace || key.key() == Qt::Key_Delete;
}

}  // namespace

/// Ignores the ShortcutOverride of keys that belong to shortcuts. The widget still gets such a key
/// if no shortcut has it.
bool ShortcutsFirst::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return false;
  const bool is_number = qobject_cast<QAbstractSpinBox*>(watched);
  if (!is_number && !qobject_cast<QLineEdit*>(watched)) return false;
  const auto& key = static_cast<const QKeyEvent&>(*event);
  const bool has_modifier = key.modifiers() & (Qt::ControlModifier | Qt::AltModifier);
  const bool is_not_of_number = is_number && (key.key() == Qt::Key_Space ||
                                              (!key.text().isEmpty() && key.text()[0].isLetter()));
  const bool undoes_typing = !is_number && isOneOf(key, {QKeySequence::Undo, QKeySequence::Redo});
  const bool goes_to_shortcuts =
      is_not_of_number || (has_modifier && !editsText(key) && !undoes_typing);
  if (goes_to_shortcuts) event->ignore();
  return goes_to_shortcuts;
}

}  // namespace mocapress
