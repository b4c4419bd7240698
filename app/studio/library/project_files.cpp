// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/project_files.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <optional>
#include <utility>

#include "app/studio/library/foreign_lock.h"
#include "app/studio/library/library.h"

namespace mocapress {
namespace {

QString kinds() {
  return ProjectFiles::tr("Mocapress projects (*.mocapress)");
}

}  // namespace

ProjectFiles::ProjectFiles(Library* library, QWidget* window)
    : QObject(window), library_(library), window_(window) {
  connect(library, &Library::inUse, this, &ProjectFiles::offerCopy);
}

QString ProjectFiles::title() const {
  const QString name = library_->name();
  return name.isEmpty() ? tr("Unnamed Project") : name;
}

void ProjectFiles::startNew() {
  leave([this] { library_->startNew(); });
}

void ProjectFiles::choose() {
  const QString path = QFileDialog::getOpenFileName(window_, tr("Open Project"), {}, kinds());
  if (!path.isEmpty()) open(path);
}

void ProjectFiles::open(const QString& path, std::function<void()> then) {
  leave([this, path, then = std::move(then)] {
    after_opening_ = then;
    if (library_->open(path)) noteOpened();
  });
}

void ProjectFiles::noteOpened() {
  if (const auto then = std::exchange(after_opening_, nullptr)) then();
}

bool ProjectFiles::saveAs() {
  const QString start = library_->name().isEmpty() ? library_->clipFolder() : library_->path();
  QString path = QFileDialog::getSaveFileName(window_, tr("Save Project"), start, kinds());
  if (path.isEmpty()) return false;
  if (!isProjectFile(path)) path += QStringLiteral(".mocapress");
  return library_->saveAs(path);
}

/// Asks about a project without a name before it is left. A named one is always in its file.
void ProjectFiles::leave(std::function<void()> then) {
  if (!library_->needsName()) return then();
  auto* question =
      new QMessageBox(QMessageBox::Question, tr("Unnamed Project"),
                      tr("Save the project of %Ln clip(s) under a name?", nullptr,
                         static_cast<int>(library_->project().clips.size())),
                      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
  question->setInformativeText(
      tr("A project without a name stays in File > Recent Projects, under its date."));
  question->button(QMessageBox::Discard)->setText(tr("&Keep It Unnamed"));
  question->setAttribute(Qt::WA_DeleteOnClose);
  connect(question, &QMessageBox::finished, this, [this, then = std::move(then)](int button) {
    if (button == QMessageBox::Discard || (button == QMessageBox::Save && saveAs())) then();
  });
  question->open();
}

void ProjectFiles::askToQuit(std::function<void()> then) {
  auto* question =
      new QMessageBox(QMessageBox::Warning, tr("Project Not Written"),
                      tr("The last changes of the project cannot be written. Quit without them?"),
                      QMessageBox::Discard | QMessageBox::Cancel, window_);
  question->setInformativeText(tr("Use Save Project As to save them to another file."));
  question->setAttribute(Qt::WA_DeleteOnClose);
  connect(question, &QMessageBox::finished, this, [then = std::move(then)](int button) {
    if (button == QMessageBox::Discard) then();
  });
  question->open();
}

void ProjectFiles::offerCopy(const QString& path) {
  const std::optional<ForeignLock> lock = foreignLock(path);
  auto* question = new QMessageBox(QMessageBox::Question, tr("Project in Use"),
                                   tr("%1. Open a copy of it?").arg(whereOpen(path)),
                                   QMessageBox::Open | QMessageBox::Cancel, window_);
  QPushButton* take_over = nullptr;
  if (lock) {
    question->setInformativeText(
        tr("If Mocapress has ended there, the project can be taken over. If not, each would "
           "overwrite the other's work."));
    take_over = question->addButton(tr("Take Over"), QMessageBox::DestructiveRole);
  }
  question->setAttribute(Qt::WA_DeleteOnClose);
  connect(question, &QMessageBox::finished, this, [=, this](int button) {
    const bool takes_over = take_over && question->clickedButton() == take_over;
    const QString obstacle = takes_over ? removeForeignLock(path, *lock) : QString();
    if (!obstacle.isEmpty()) return emit library_->failed(obstacle);
    if (takes_over ? library_->open(path) : button == QMessageBox::Open && library_->openCopy(path))
      noteOpened();
  });
  question->open();
}

void ProjectFiles::fillRecentMenu(QMenu* menu) {
  menu->clear();
  for (const FormerProject& project : library_->formerProjects()) {
    QString text = QFileInfo(project.path).completeBaseName();
    if (!project.named)
      text = tr("Unnamed, %1").arg(QLocale().toString(project.written, QLocale::ShortFormat));
    if (project.clips) text = tr("%1, %Ln clip(s)", nullptr, *project.clips).arg(text);
    // Shows each & as a letter: a single & would mark a shortcut.
    QAction* action = menu->addAction(text.replace(QLatin1Char('&'), QLatin1String("&&")));
    action->setToolTip(QDir::toNativeSeparators(project.path));
    connect(action, &QAction::triggered, this, [this, path = project.path] { open(path); });
  }
  if (menu->isEmpty()) menu->addAction(tr("None"))->setEnabled(false);
  menu->setToolTipsVisible(true);
}

}  // namespace mocapress
