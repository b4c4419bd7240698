// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>
#include <QString>
#include <functional>
#include <string>
#include <vector>

#include "app/jobs/open_clip.h"
#include "core/report/review_page.h"
#include "core/study/row.h"

class QMenu;
class QWidget;

namespace mocapress {

struct RecentFile {
  QString path;
  QString skeleton;  // chosen by hand; empty: the one beside the clip
  bool operator==(const RecentFile&) const = default;
};

/// Recent files that still exist, newest first. They are kept in the user's settings.
QList<RecentFile> recentFiles();

/// The .asf chosen by hand for this clip; empty: none.
QString rememberedSkeleton(const QString& path);

void rememberRecentFile(const RecentFile& file);

class Session;

/// Patterns of readable motions for a file dialog: "*.bvh *.amc *.fbx".
QString motionPatterns();

/// The bundled walk, from the installed share directory, or from the source tree if the program
/// runs in its build directory. Empty: neither is there.
QString sampleClip();

/// Opening and saving with their dialogs, recent files, and the question about unsaved work.
class ClipFiles : public QObject {
  Q_OBJECT

 public:
  ClipFiles(Session* session, QWidget* window);

  /// Opens the newest recent file that still exists, else the bundled walk.
  void openFirst();

  void open(const QString& path, const QString& skeleton = {});
  void chooseClip();

  /// Opens a row of a study, see Session::openRow().
  void openRow(const StudyRow& row);

  /// Asks for the skeleton of the file that could not be opened.
  void chooseSkeleton();

  /// Asks for unit, axes and rate of the open motion, if its file states them wrongly or not at
  /// all.
  void chooseImportOptions();

  /// Asks for a file whose character the open clip then wears.
  void chooseCharacter();

  void chooseOriginal();
  void save();

  /// Saves the compressed clip, or exports its motion in another format.
  void saveAs();
  void exportMotion();

  /// Writes a page that shows the clip and its original in a browser.
  void exportReview();

  /// Returns remarks for a clip's page: the library's verdict and notes.
  using Remarks = std::function<ReviewRemarks(const QString& key)>;
  void setRemarks(Remarks remarks) { remarks_ = std::move(remarks); }

  /// Runs `then` at once if there is no unsaved work. Otherwise asks, and runs `then` after the
  /// work is saved or given up; never if the user cancels.
  void leave(std::function<void()> then);

  void fillRecentMenu(QMenu* menu);

 signals:
  /// `wants_skeleton`: choosing a skeleton may help.
  void openFailed(const QString& message, bool wants_skeleton);
  void saved(const QString& name);
  void exported(const QString& name);

 private:
  QString directory() const;
  QString suggestedPath(const QString& extension) const;
  /// `worn`: the file of a character that can be written with the motion; empty: none.
  void choosePlace(const QString& title, const QString& extension, QStringList extensions,
                   const QString& worn = {});
  void write(const QString& path, const QString& worn);
  void noteSaved(const QString& path);

  Session* session_;
  QWidget* window_;
  Remarks remarks_ = [](const QString&) { return ReviewRemarks(); };
  OpenRequest unread_;                  // request that failed last
  std::function<void()> after_saving_;  // runs after saving, see leave()
};

}  // namespace mocapress
