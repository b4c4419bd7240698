// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/main_window.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QCheckBox>
#include <QCloseEvent>
#include <QMenu>
#include <QWidget>

#include "app/studio/compare/byte_view.h"
#include "app/studio/compare/pinned_results.h"
#include "app/studio/compare/range_actions.h"
#include "app/studio/compare/range_comparison.h"
#include "app/studio/compare/view_pictures.h"
#include "app/studio/document/clip_files.h"
#include "app/studio/document/own_limits.h"
#include "app/studio/document/session.h"
#include "app/studio/library/clip_links.h"
#include "app/studio/library/frame_notes.h"
#include "app/studio/library/library.h"
#include "app/studio/library/project_files.h"
#include "app/studio/library/sign_off_export.h"
#include "app/studio/window/actions.h"
#include "app/studio/window/command_palette.h"
#include "app/studio/window/help.h"
#include "app/studio/window/incoming_files.h"
#include "app/studio/window/keyboard_map.h"
#include "app/studio/window/language.h"
#include "app/studio/window/notices.h"
#include "app/studio/window/panels_below.h"
#include "app/studio/window/part_names.h"
#include "app/studio/window/tool_windows.h"
#include "app/studio/window/trace.h"
#include "app/studio/window/undo_target.h"
#include "widgets/models/byte_cost_model.h"
#include "widgets/models/library_model.h"
#include "widgets/models/pinned_model.h"
#include "widgets/panels/compression_panel.h"
#include "widgets/panels/correction_control.h"
#include "widgets/panels/joints_panel.h"
#include "widgets/panels/library_panel.h"
#include "widgets/panels/message_bar.h"
#include "widgets/plots/error_graph.h"
#include "widgets/plots/heat_map.h"
#include "widgets/timeline/time_ruler.h"
#include "widgets/timeline/timeline.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {

Leaving::Leaving(Session* session, ClipFiles* files, Library* library, ProjectFiles* projects,
                 QWidget* window)
    : QObject(window),
      session_(session),
      files_(files),
      library_(library),
      projects_(projects),
      window_(window) {}

bool Leaving::mayClose() {
  if (returns_) return true;
  if (!may_lose_clip_ && session_->document().modified()) {
    files_->leave([this] {
      may_lose_clip_ = true;
      may_lose_clip_ = window_->close();
    });
    return false;
  }
  if (!may_lose_project_ && !library_->end()) {
    may_lose_clip_ = false;  // closing may yet be cancelled: ask about the clip again
    projects_->askToQuit([this] {
      may_lose_clip_ = may_lose_project_ = true;
      window_->close();
    });
    return false;
  }
  return true;
}

namespace {

constexpr QSize kFirstSize(1440, 900);
constexpr QSize kFrame(10, 40);  // a window's frame, with its title

}  // namespace

MainWindow::MainWindow(Work* work) : work_(work ? work : new Work(this)) {
  setWindowIcon(QIcon(QStringLiteral(":/icons/app.svg")));
  qApp->installEventFilter(new ShortcutsFirst(this));
  qApp->installEventFilter(new PartNames(this));
  resize(kFirstSize.boundedTo(screen()->availableSize() - kFrame));
  auto* undo = new UndoTarget(session_, library_, this);
  actions_ = makeActions(playback_, undo->histories(), this);
  actions_.error_scales = error_display_->scales(ErrorQuantity::Distance);
  actions_.angle_scales = error_display_->scales(ErrorQuantity::Angle);
  actions_.in_degrees = error_display_->inDegrees();
  actions_.as_seen = error_display_->asSeen();
  const Models models{new JointErrorModel(this), new SlideModel(this)};
  auto* byte_model = new ByteCostModel(this);
  panels_ = makePanels(this, &layout_, {models, clips_, &work_->pinned_model, byte_model},
                       playback_, actions_.transport);
  undo->setLibraryPanel(panels_.library);
  recent_ = addMenus(this, actions_, layout_.docks());
  layout_.restore(panels_.views.viewport);
  // The order of the parts below is fixed only by their constructors' arguments: what each shows
  // follows from the document and the playback, in whatever order their signals reach the parts.
  new Presenter(session_, playback_, models, panels_.views, error_display_, this);
  library_views_ =
      new LibraryViews(session_, library_, panels_.library, panels_.slot_control, this);
  library_views_->offer(presets_);
  library_views_->offer(panels_.library_plot);
  preset_views_ = new PresetViews(session_, presets_, panels_.views.compression->presets(), this);
  pinned_->showIn(panels_.pinned, panels_.views.viewport);
  inspector_ = new Inspector(session_, playback_, panels_.inspection, error_display_, this);
  new ByteView(session_, playback_, panels_.inspection.timeline->bytes(), byte_model, panels_.bytes,
               this);
  recent_.play->addActions(inspector_->rangeActions()->actions());
  recent_.play->setToolTipsVisible(true);  // tool tips say why an entry is grey
  new RangeComparison(playback_, panels_.inspection.timeline, panels_.views.graph,
                      actions_.compare_range,
                      {.overlay = actions_.view.mode[0],
                       .side_by_side = actions_.view.mode[1],
                       .quarters = actions_.view.quarters,
                       .loop = actions_.transport.loop},
                      this);
  recent_.timeline->addActions(panels_.inspection.timeline->foldActions());
  notes_ =
      new FrameNotes(session_, library_, playback_, panels_.inspection.timeline->notes(), this);
  notes_->showIn(panels_.views.viewport);
  links_ = new ClipLinks(session_, library_, playback_, panels_.views.viewport, this);
  sign_off_ = new SignOffExport(library_, clips_, this);
  trace_ = new Trace(session_, panels_.views.viewport, this);
  notices_ = new Notices(session_, library_, panels_.messages, this);
  notices_->tellOf(files_, actions_.choose_skeleton);
  notices_->tellOf(presets_);
  connect(links_, &ClipLinks::copied, notices_, &Notices::say);
  connect(links_, &ClipLinks::failed, library_, &Library::failed);
  connect(sign_off_, &SignOffExport::written, notices_, &Notices::say);
  connect(sign_off_, &SignOffExport::failed, library_, &Library::failed);
  incoming_ = new IncomingFiles(session_, library_, files_, projects_, notices_, this);
  leaving_ = new Leaving(session_, files_, library_, projects_, this);
  tools_ = new ToolWindows(session_, library_, files_, presets_, this);
  if (!ownLimits().problem.isEmpty())
    connect(
        session_, &Session::opened, notices_,
        [this] {
          notices_->say(
              tr("Your own limits of visibility are not used: %1").arg(ownLimits().problem));
        },
        Qt::SingleShotConnection);
  pictures_ = new ViewPictures(session_, playback_, panels_.views.viewport, this);
  notices_->tellOf(pictures_);
  connectFileActions();
  connectEditActions();
  connectWindowActions();
  addContextMenus();
  connectChoices();
  nameActions(actions_);
  commands_ = commandsOf(*menuBar());
  restoreKeys(commands_);
  connect(&session_->document(), &Document::titleChanged, this, &MainWindow::updateTitle);
  connect(&session_->document(), &Document::skinChanged, this, &MainWindow::updateTitle);
  connect(&session_->document(), &Document::decodedChanged, this, &MainWindow::updateTitle);
  connect(library_, &Library::projectChanged, this, &MainWindow::updateTitle);
  connect(playback_, &Playback::rangeChanged, this, &MainWindow::updateCommands);
  connect(clips_, &LibraryModel::modelReset, this, &MainWindow::updateCommands);
  connect(clips_, &LibraryModel::rowsInserted, this, &MainWindow::updateCommands);
  updateTitle();
  // Gives the view the focus, so that keys control the playback from the start.
  panels_.views.viewport->setFocus();
}

void MainWindow::open(const QStringList& paths, const QString& skeleton) {
  if (paths.size() == 1 && ClipLinks::isLink(paths.front())) return links_->open(paths.front());
  incoming_->open(paths, skeleton);
}

StudyWindow* MainWindow::showStudy() {
  return tools_->showStudy();
}

void MainWindow::connectFileActions() {
  connect(actions_.open, &QAction::triggered, files_, &ClipFiles::chooseClip);
  connect(actions_.open_sample, &QAction::triggered, files_,
          [this] { files_->open(sampleClip()); });
  connect(actions_.choose_skeleton, &QAction::triggered, files_, &ClipFiles::chooseSkeleton);
  connect(actions_.compare, &QAction::triggered, files_, &ClipFiles::chooseOriginal);
  connect(actions_.save, &QAction::triggered, files_, &ClipFiles::save);
  connect(actions_.save_as, &QAction::triggered, files_, &ClipFiles::saveAs);
  connect(actions_.export_motion, &QAction::triggered, files_, &ClipFiles::exportMotion);
  connect(actions_.export_review, &QAction::triggered, files_, &ClipFiles::exportReview);
  files_->setRemarks([this](const QString& key) { return library_->remarksOn(key); });
  connect(actions_.copy_picture, &QAction::triggered, pictures_, &ViewPictures::copy);
  connect(actions_.save_picture, &QAction::triggered, pictures_, &ViewPictures::choosePicture);
  connect(actions_.film, &QAction::triggered, pictures_, &ViewPictures::chooseFilm);
  connect(actions_.turntable, &QAction::triggered, pictures_, &ViewPictures::chooseTurntable);
  connect(actions_.import_options, &QAction::triggered, files_, &ClipFiles::chooseImportOptions);
  connect(actions_.put_character, &QAction::triggered, files_, &ClipFiles::chooseCharacter);
  connect(actions_.take_character_off, &QAction::triggered, session_, &Session::takeCharacterOff);
  connect(actions_.quit, &QAction::triggered, this, &QWidget::close);
  connect(actions_.add_clips, &QAction::triggered, library_views_, &LibraryViews::addClips);
  connect(actions_.add_folder, &QAction::triggered, library_views_, &LibraryViews::addFolder);
  connect(actions_.compare_batch, &QAction::triggered, library_views_,
          &LibraryViews::compareWithBatch);
  connect(actions_.new_project, &QAction::triggered, projects_, &ProjectFiles::startNew);
  connect(actions_.open_project, &QAction::triggered, projects_, &ProjectFiles::choose);
  connect(actions_.save_project, &QAction::triggered, projects_, &ProjectFiles::saveAs);
  connect(recent_.files, &QMenu::aboutToShow, files_,
          [this] { files_->fillRecentMenu(recent_.files); });
  connect(recent_.projects, &QMenu::aboutToShow, projects_,
          [this] { projects_->fillRecentMenu(recent_.projects); });
  actions_.open_sample->setEnabled(!sampleClip().isEmpty());
}

void MainWindow::connectEditActions() {
  const Views& views = panels_.views;
  connect(actions_.switch_slot, &QAction::triggered, session_, &Session::switchSlot);
  connect(actions_.copy_slot, &QAction::triggered, session_, &Session::copyToOtherSlot);
  actions_.without_ik->setChecked(session_->document().uncorrected());
  connect(actions_.without_ik, &QAction::toggled, &session_->document(), &Document::setUncorrected);
  connect(actions_.hold_feet, &QAction::triggered, views.compression->correction()->hold(),
          &QCheckBox::toggle);
  connect(actions_.pin, &QAction::triggered, pinned_, &PinnedResults::pinCurrent);
  connect(actions_.pin_engine, &QAction::triggered, pinned_, &PinnedResults::pinEngine);
  connect(pinned_, &PinnedResults::failed, panels_.messages,
          [this](const QString& message) { panels_.messages->showError(message); });
  connect(pinned_, &PinnedResults::canPinChanged, actions_.pin, &QAction::setEnabled);
  actions_.pin->setEnabled(pinned_->canPin());
  connect(actions_.next_review, &QAction::triggered, library_views_,
          &LibraryViews::showNextToReview);
  connect(actions_.approve, &QAction::triggered, library_views_,
          [this] { library_views_->judge(Verdict::Approved); });
  connect(actions_.reject, &QAction::triggered, library_views_,
          [this] { library_views_->judge(Verdict::Rejected); });
  connect(actions_.note_here, &QAction::triggered, notes_, &FrameNotes::addHere);
  connect(actions_.note_on_range, &QAction::triggered, notes_, &FrameNotes::addOnRange);
  connect(actions_.next_note, &QAction::triggered, notes_, &FrameNotes::showNext);
  connect(actions_.write_notes, &QAction::triggered, library_, &Library::writeNotes);
  connect(actions_.read_notes, &QAction::triggered, library_, &Library::readNotes);
  connect(actions_.copy_link, &QAction::triggered, links_, &ClipLinks::copy);
  connect(actions_.export_sign_off, &QAction::triggered, sign_off_, &SignOffExport::choose);
  connect(actions_.next_worst, &QAction::triggered, inspector_,
          [this] { inspector_->showNextWorst(1); });
  connect(actions_.previous_worst, &QAction::triggered, inspector_,
          [this] { inspector_->showNextWorst(-1); });
}

void MainWindow::connectWindowActions() {
  connectViewActions(actions_.view, panels_.views.viewport);
  connect(actions_.view.skin, &QAction::toggled, library_, &Library::setShowsSkin);
  connect(library_, &Library::entered, actions_.view.skin,
          [this] { actions_.view.skin->setChecked(library_->showsSkin()); });
  connect(actions_.reset_layout, &QAction::triggered, this, [this] { layout_.reset(); });
  // A new clip may change the rows, and so the height, of the timeline.
  connect(&session_->document(), &Document::clipChanged, layout_.below(), &PanelsBelow::fit,
          Qt::QueuedConnection);
  connect(actions_.panels_below, &QAction::triggered, layout_.below(), &PanelsBelow::toggle);
  connect(actions_.guide, &QAction::triggered, this, [this] { showGuide(this); });
  connect(actions_.shortcuts, &QAction::triggered, this,
          [this] { showShortcuts(*menuBar(), this); });
  connect(actions_.find_command, &QAction::triggered, this,
          [this] { (new CommandPalette(commands_, this))->show(); });
  connect(actions_.keyboard_map, &QAction::triggered, this,
          [this] { (new KeyboardMap(commands_, this))->show(); });
  connect(actions_.about, &QAction::triggered, this, [this] { showAbout(this); });
  connect(actions_.study, &QAction::triggered, tools_, &ToolWindows::showStudy);
  connect(actions_.blind_test, &QAction::triggered, tools_, &ToolWindows::showBlindTest);
  connect(actions_.batch, &QAction::triggered, tools_, &ToolWindows::showBatch);
  connect(actions_.export_library, &QAction::triggered, tools_,
          [this] { tools_->exportClips({}); });
  connect(panels_.library, &LibraryPanel::exportRequested, tools_, &ToolWindows::exportClips);
  // Raises the panel that a shortcut changes. A panel behind another tab counts as visible in Qt,
  // but lies outside the window.
  const auto is_in_sight = [this](const QWidget* panel) {
    return panel->isVisible() && panel->height() > PanelsBelow::kFolded &&
           rect().contains(panel->mapTo(this, panel->rect().center()));
  };
  for (const QAction* action : {actions_.in_degrees, actions_.as_seen})
    connect(action, &QAction::triggered, this, [this, action, is_in_sight] {
      const bool is_seen = is_in_sight(panels_.inspection.heat_map) ||
                           (action == actions_.in_degrees && is_in_sight(panels_.views.graph));
      if (!is_seen) layout_.bringUp(panels_.inspection.heat_map);
    });
}

void MainWindow::connectChoices() {
  actions_.themes->actions().at(static_cast<int>(theme_->choice()))->setChecked(true);
  connect(actions_.themes, &QActionGroup::triggered, theme_, [this](const QAction* action) {
    theme_->choose(static_cast<ThemeChoice>(action->data().toInt()));
  });
  for (QAction* action : actions_.languages->actions())
    if (action->data().toString() == chosenLanguage()) action->setChecked(true);
  connect(actions_.languages, &QActionGroup::triggered, this,
          [this](const QAction* action) { changeLanguage(action->data().toString()); });
}

/// Adds context menus to the views. They hold commands of the menu bar, with their keys.
void MainWindow::addContextMenus() {
  const ViewActions& view = actions_.view;
  connect(panels_.views.viewport, &Viewport::menuRequested, this, [this, view](const QPoint& at) {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addActions(
        {view.frame_joint, view.reset_camera, view.front, view.side, view.floor, view.quarters});
    menu->addSeparator();
    menu->addActions({view.by_error, view.exaggerate, view.path, view.trail, view.skin});
    menu->addSeparator();
    menu->addActions({actions_.note_here, actions_.pin, actions_.copy_picture,
                      actions_.save_picture, actions_.turntable});
    menu->popup(at);
  });
  panels_.inspection.timeline->addRangeActions(
      {actions_.transport.play, actions_.transport.whole_clip, actions_.compare_range,
       actions_.note_here, actions_.note_on_range, actions_.film});
  panels_.views.joints->addActions({view.frame_joint, view.path, actions_.note_here});
  panels_.views.joints->setContextMenuPolicy(Qt::ActionsContextMenu);
}

/// Closes the window; main() makes another one, which shows the same work.
void MainWindow::changeLanguage(const QString& code) {
  if (code == chosenLanguage()) return;
  chooseLanguage(code);
  if (tools_->busy())
    return notices_->say(tr("The language changes when Mocapress is started again."));
  changes_language_ = true;
  leaving_->expectReturn();
  // Closes later, since the menu with the chosen entry is still open.
  QMetaObject::invokeMethod(this, &QWidget::close, Qt::QueuedConnection);
}

void MainWindow::updateTitle() {
  const Document& document = session_->document();
  const QString project =
      QStringLiteral("%1 – %2").arg(projects_->title(), QCoreApplication::applicationName());
  // The project is always saved; the title marks an unsaved compressed clip.
  setWindowTitle(document.title().isEmpty() ? project + QStringLiteral("[*]")
                                            : tr("%1[*] – %2").arg(document.title(), project));
  setWindowModified(document.modified() || library_->stuck());
  updateCommands();
}

/// Commands that have nothing to work on are grey, in menus and in the palette.
void MainWindow::updateCommands() {
  const Document& document = session_->document();
  const ViewActions& view = actions_.view;
  const TransportActions& play = actions_.transport;
  const auto enable = [](bool enabled, const QList<QAction*>& actions) {
    for (QAction* action : actions) action->setEnabled(enabled);
  };
  const bool has_original = document.original() != nullptr;
  const bool has_decoded = document.decoded() != nullptr;
  const bool has_figure = document.skeleton() != nullptr;
  enable(has_figure, {actions_.copy_picture,
                      actions_.save_picture,
                      actions_.film,
                      actions_.turntable,
                      actions_.put_character,
                      actions_.note_here,
                      actions_.next_note,
                      actions_.copy_link,
                      view.front,
                      view.side,
                      view.floor,
                      view.frame_joint,
                      view.reset_camera,
                      play.first,
                      play.previous,
                      play.play,
                      play.next,
                      play.last,
                      play.backwards,
                      play.halt,
                      play.forwards,
                      play.ten_back,
                      play.ten_on,
                      play.range_from,
                      play.range_to,
                      play.whole_clip});
  enable(has_original,
         {actions_.import_options, actions_.switch_slot, actions_.copy_slot, actions_.hold_feet});
  enable(has_decoded, {actions_.save, actions_.save_as, actions_.export_motion});
  enable(has_decoded && has_original, {actions_.export_review, actions_.pin_engine});
  enable(has_decoded && document.decoded()->distortion,
         {actions_.next_worst, actions_.previous_worst});
  enable(clips_->rowCount() > 0,
         {actions_.next_review, actions_.approve, actions_.reject, actions_.write_notes,
          actions_.read_notes, actions_.export_library, actions_.export_sign_off,
          actions_.compare_batch});
  actions_.note_on_range->setEnabled(has_figure && playback_->range());
  actions_.take_character_off->setEnabled(!document.character().path.isEmpty());
  view.skin->setEnabled(document.skin() != nullptr);
  actions_.without_ik->setEnabled(has_decoded && document.decoded()->uncorrected_tracks);
  actions_.compare->setEnabled(has_decoded && !has_original);
}

WindowState MainWindow::state() const {
  const Viewport& view = *panels_.views.viewport;
  return {playback_->frame(),
          playback_->range(),
          view.options(),
          actions_.view.follow->isChecked(),
          view.framesByItself() ? std::nullopt : std::optional(view.cameraPlace()),
          library_views_->encodes()};
}

void MainWindow::takeOver(const WindowState& state) {
  work_->announce();
  showOptions(actions_.view, panels_.views.viewport, state.view);
  actions_.view.follow->setChecked(state.follows);
  playback_->setRange(state.range);
  playback_->seek(state.frame);
  if (state.camera) panels_.views.viewport->setCameraPlace(*state.camera);
  library_views_->setEncodes(state.encodes);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!leaving_->mayClose()) {
    changes_language_ = false;
    return event->ignore();
  }
  layout_.remember();
  tools_->close();
  event->accept();
  if (changes_language_) QCoreApplication::exit(kOtherLanguage);
}

}  // namespace mocapress
