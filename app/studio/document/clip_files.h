// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>
#include <QString>
#include <functional>
#include <string>
#include <vector>

#include "app/jobs/open_clip.h"
#include "core/study/row.h"

class QMenu;
class QWidget;

namespace mocapress {

struct RecentFile {
  QString path;
  QString skeleton;  // chosen by hand; empty: found beside the clip
  bool operator==(const RecentFile&) const = default;
};

/// Newest first, those that still exist, kept in the user's settings.
QList<RecentFile> recentFiles();

/// The .asf that was chosen by hand for this clip; empty: none.
QString rememberedSkeleton(const QString& path);

void rememberRecentFile(const RecentFile& file);

class Session;

/// The motions that can be read, for a file dialog: "*.bvh *.amc *.fbx".
QString motionPatterns();

/// The bundled walk: from the installed share directory, or from the source tree where the program
/// runs out of its build directory. Empty: neither is there.
QString sampleClip();

/// Opening and saving as the user meets them: dialogs, recent files, and the one question that is
/// asked, about unsaved work.
class ClipFiles : public QObject {
  Q_OBJECT

 public:
  ClipFiles(Session* session, QWidget* window);

  /// Of what was open last, what is still there; else the bundled walk.
  void openFirst();

  void open(const QString& path, const QString& skeleton = {});
  void chooseClip();

  /// A row of a study, see Session::openRow().
  void openRow(const StudyRow& row);

  /// For what could not be opened last.
  void chooseSkeleton();

  /// What to read the open motion as, where its file says it wrongly or not at all.
  void chooseImportOptions();

  /// Whose looks the open clip takes on.
  void chooseCharacter();

  void chooseOriginal();
  void save();

  /// Compressed, or the motion that comes of it in any format that is written.
  void saveAs();
  void exportMotion();

  /// A page on which a browser shows the clip and its original.
  void exportReview();

  /// Remarks about a clip on its page: the library's verdict and note.
  using Remarks = std::function<std::vector<std::string>(const QString& path)>;
  void setRemarks(Remarks remarks) { remarks_ = std::move(remarks); }

  /// Runs `then` once nothing would be lost by it: at once, after saving, or never.
  void leave(std::function<void()> then);

  void fillRecentMenu(QMenu* menu);

 signals:
  /// `wants_skeleton`: choosing one may help.
  void openFailed(const QString& message, bool wants_skeleton);
  void saved(const QString& name);
  void exported(const QString& name);

 private:
  QString directory() const;
  QString suggestedPath(const QString& extension) const;
  void choosePlace(const QString& title, const QString& extension, const QStringList& extensions);
  void write(const QString& path);
  void noteSaved(const QString& path);

  Session* session_;
  QWidget* window_;
  Remarks remarks_ = [](const QString&) { return std::vector<std::string>(); };
  OpenRequest unread_;                  // what could not be opened last
  std::function<void()> after_saving_;  // what waits for it, see leave()
};

}  // namespace mocapress
