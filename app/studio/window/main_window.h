// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <QTimer>

#include "app/studio/compare/error_display.h"
#include "app/studio/compare/inspector.h"
#include "app/studio/compare/presenter.h"
#include "app/studio/document/clip_files.h"
#include "app/studio/document/preset_shelf.h"
#include "app/studio/document/preset_views.h"
#include "app/studio/document/session.h"
#include "app/studio/library/library.h"
#include "app/studio/library/library_views.h"
#include "app/studio/library/project_files.h"
#include "app/studio/study/study_session.h"
#include "app/studio/window/actions.h"
#include "app/studio/window/theme.h"
#include "app/studio/window/undo_target.h"
#include "app/studio/window/window_layout.h"
#include "widgets/models/library_model.h"
#include "widgets/models/pinned_model.h"
#include "widgets/timeline/playback.h"

namespace mocapress {

class LibraryPanel;
class PinnedPanel;
class PinnedResults;
class MessageBar;
class BatchWindow;
class SlotControl;
class StudyWindow;
class Trace;

/// The studio's window: 3D view and transport in the middle, settings and figures to the right,
/// joints and their errors below.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QWidget* parent = nullptr);

  Session& session() { return *session_; }
  Playback& playback() { return *playback_; }
  ClipFiles& files() { return *files_; }
  Library& library() { return *library_; }
  ProjectFiles& projects() { return *projects_; }
  const Views& views() const { return views_; }
  const InspectionViews& inspection() const { return inspection_; }
  const Actions& actions() const { return actions_; }
  PresetShelf& presets() { return *presets_; }
  PresetViews& presetViews() { return *preset_views_; }
  PinnedPanel& pinnedPanel() { return *pinned_panel_; }
  LibraryPanel& libraryPanel() { return *library_panel_; }
  MessageBar& messages() { return *messages_; }
  const ErrorDisplay* errorDisplay() const { return error_display_; }
  Trace& trace() { return *trace_; }

  /// One file is opened, with its skeleton; several and folders come into the library, and the
  /// first of them is opened if nothing is open yet. With a project among them they come into that.
  void open(const QStringList& paths, const QString& skeleton = {});

  /// Opens, or brings to the front, the window that compares methods. It lives as long as this one.
  StudyWindow* showStudy();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void openClips(const QStringList& paths, const QString& skeleton, bool opens_first);
  BatchWindow* showBatch();
  void exportClips(const std::vector<int>& rows);
  QWidget* makeCentre();
  QWidget* makeSidebar();
  void addDocks();
  void connectFileActions();
  void connectWindowActions();
  void connectMessages();
  void keepNote(const QString& note);
  void updateTitle();
  void showHere();
  void about();
  void connectChoices();

  // Children, not members: what the widgets show has to outlive their being hidden by ~QWidget().
  Session* session_ = new Session(this);
  Playback* playback_ = new Playback(Playback::steadyClock(), this);
  Models models_{new JointErrorModel(this), new SlideModel(this)};
  LibraryModel* clips_ = new LibraryModel(this);
  Library* library_ = new Library(session_, clips_, this);
  UndoTarget* undo_ = new UndoTarget(session_, library_, this);
  PresetShelf* presets_ = new PresetShelf(PresetShelf::usualFile(), this);
  ClipFiles* files_ = new ClipFiles(session_, this);
  ProjectFiles* projects_ = new ProjectFiles(library_, this);
  WindowLayout layout_{this};
  Theme* theme_ = new Theme(this);
  ErrorDisplay* error_display_ = new ErrorDisplay(this);
  Actions actions_;
  Views views_;
  InspectionViews inspection_;
  Inspector* inspector_;
  LibraryPanel* library_panel_;
  SlotControl* slot_control_;
  LibraryViews* library_views_;
  PresetViews* preset_views_;
  PinnedModel* pinned_model_ = new PinnedModel(this);
  PinnedPanel* pinned_panel_;
  PinnedResults* pinned_;
  MessageBar* messages_;
  RecentMenus recent_;
  Trace* trace_;
  StudySession* study_session_ = nullptr;  // none before it is asked for, nor its window
  StudyWindow* study_ = nullptr;
  BatchWindow* batch_ = nullptr;   // none before it is asked for
  QString kept_note_;              // said again once the clip of the project is open
  bool may_close_ = false;         // no compressed clip would be lost
  bool may_lose_project_ = false;  // what cannot be written of it
  bool opens_added_ = false;       // what comes into the library next
  QTimer slow_opening_;
  QString opening_;  // the file that is being read
};

}  // namespace mocapress
