// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>

class QMenu;
class QWidget;

namespace mocapress {

class Library;

/// Dialogs for projects, the list of former ones, and the question about one without a name.
class ProjectFiles : public QObject {
  Q_OBJECT

 public:
  ProjectFiles(Library* library, QWidget* window);

  /// The project's name, such as "Knights", or a text for an unnamed one.
  QString title() const;

  void startNew();
  void choose();

  /// `then` runs once the project, or a copy of it, is open.
  void open(const QString& path, std::function<void()> then = {});

  /// Asks for a file. False: nothing was saved.
  bool saveAs();

  void fillRecentMenu(QMenu* menu);

  /// Asks what to do if the project cannot be written; runs `then` if the user quits regardless.
  void askToQuit(std::function<void()> then);

 private:
  void leave(std::function<void()> then);
  void offerCopy(const QString& path);
  void noteOpened();

  Library* library_;
  QWidget* window_;
  std::function<void()> after_opening_;  // runs after opening, see open()
};

}  // namespace mocapress
