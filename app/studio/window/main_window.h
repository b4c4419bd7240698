// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <QObject>

#include "app/studio/compare/error_display.h"
#include "app/studio/document/clip_files.h"
#include "app/studio/document/preset_shelf.h"
#include "app/studio/document/preset_views.h"
#include "app/studio/document/session.h"
#include "app/studio/library/library.h"
#include "app/studio/library/library_views.h"
#include "app/studio/library/project_files.h"
#include "app/studio/window/actions.h"
#include "app/studio/window/commands.h"
#include "app/studio/window/panels.h"
#include "app/studio/window/theme.h"
#include "app/studio/window/window_state.h"
#include "app/studio/window/work.h"
#include "widgets/models/library_model.h"
#include "widgets/timeline/playback.h"

class QWidget;

namespace mocapress {

class ClipFiles;
class ClipLinks;
class FrameNotes;
class IncomingFiles;
class Library;
class Notices;
class PinnedResults;
class ProjectFiles;
class Session;
class SignOffExport;
class StudyWindow;
class ToolWindows;
class Trace;
class ViewPictures;

/// Decides if the window may close: only after an unsaved compressed clip is saved or given up, and
/// the project is in its file.
class Leaving : public QObject {
  Q_OBJECT

 public:
  Leaving(Session* session, ClipFiles* files, Library* library, ProjectFiles* projects,
          QWidget* window);

  /// Called when the window is about to close. False: the user is asked, and the answer may close
  /// it.
  bool mayClose();

  /// Another window will show the same work, so that closing this one loses nothing.
  void expectReturn() { returns_ = true; }

 private:
  Session* session_;
  ClipFiles* files_;
  Library* library_;
  ProjectFiles* projects_;
  QWidget* window_;
  bool returns_ = false;
  bool may_lose_clip_ = false;
  bool may_lose_project_ = false;  // the project cannot be written, and the user quits regardless
};

/// The studio's window, which makes its parts and connects them.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  /// Shows this work, which must outlive the window. Null: the window makes its own.
  explicit MainWindow(Work* work = nullptr);

  Work& work() { return *work_; }
  Session& session() { return *session_; }
  Playback& playback() { return *playback_; }
  ClipFiles& files() { return *files_; }
  Library& library() { return *library_; }
  ProjectFiles& projects() { return *projects_; }
  const Views& views() const { return panels_.views; }
  const InspectionViews& inspection() const { return panels_.inspection; }
  const Actions& actions() const { return actions_; }
  const std::vector<Command>& commands() const { return commands_; }
  PresetShelf& presets() { return *presets_; }
  PinnedPanel& pinnedPanel() { return *panels_.pinned; }
  LibraryPanel& libraryPanel() { return *panels_.library; }
  MessageBar& messages() { return *panels_.messages; }
  const ErrorDisplay* errorDisplay() const { return error_display_; }
  Trace& trace() { return *trace_; }
  ViewPictures& pictures() { return *pictures_; }

  /// The part of this window's state that a window in another language takes over, besides the
  /// work.
  WindowState state() const;

  /// Shows the present state of the work as the window before showed it.
  void takeOver(const WindowState& state);

  /// See IncomingFiles::open().
  void open(const QStringList& paths, const QString& skeleton = {});

  /// See ToolWindows::showStudy().
  StudyWindow* showStudy();

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void connectFileActions();
  void connectEditActions();
  void connectWindowActions();
  void addContextMenus();
  void connectChoices();
  void changeLanguage(const QString& code);
  void updateTitle();
  void updateCommands();

  // Children instead of members: they must outlive the widgets' hide events in ~QWidget().
  Work* work_;
  Session* session_ = &work_->session;
  Playback* playback_ = new Playback(Playback::steadyClock(), this);
  LibraryModel* clips_ = &work_->clips;
  Library* library_ = &work_->library;
  PresetShelf* presets_ = &work_->presets;
  ClipFiles* files_ = new ClipFiles(session_, this);
  ProjectFiles* projects_ = new ProjectFiles(library_, this);
  WindowLayout layout_{this};
  Theme* theme_ = new Theme(this);
  ErrorDisplay* error_display_ = new ErrorDisplay(this);
  Actions actions_;
  Panels panels_;
  RecentMenus recent_;
  std::vector<Command> commands_;
  Inspector* inspector_;
  LibraryViews* library_views_;
  FrameNotes* notes_;
  ClipLinks* links_;
  SignOffExport* sign_off_;
  PresetViews* preset_views_;
  PinnedResults* pinned_ = &work_->pinned;
  Trace* trace_;
  Notices* notices_;
  IncomingFiles* incoming_;
  Leaving* leaving_;
  ToolWindows* tools_;
  ViewPictures* pictures_;
  bool changes_language_ = false;
};

}  // namespace mocapress
