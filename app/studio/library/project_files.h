// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>

class QMenu;
class QWidget;

namespace mocapress {

class Library;

/// Projects as the user meets them: dialogs, former projects, and the question about one that has
/// no name.
class ProjectFiles : public QObject {
  Q_OBJECT

 public:
  ProjectFiles(Library* library, QWidget* window);

  /// "Knights", or that there is no name.
  QString title() const;

  void startNew();
  void choose();

  /// `then`: once it is open, or a copy of it.
  void open(const QString& path, std::function<void()> then = {});

  /// With a file dialog. False: nothing was saved.
  bool saveAs();

  void fillRecentMenu(QMenu* menu);

  /// Where the project cannot be written: runs `then` if the user quits all the same.
  void askToQuit(std::function<void()> then);

 private:
  void leave(std::function<void()> then);
  void offerCopy(const QString& path);
  void noteOpened();

  Library* library_;
  QWidget* window_;
  std::function<void()> after_opening_;  // what waits for it, see open()
};

}  // namespace mocapress
