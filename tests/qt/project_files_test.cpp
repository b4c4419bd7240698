// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/project_files.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTimer>
#include <QWidget>

#include "app/studio/document/session.h"
#include "app/studio/library/library.h"
#include "widgets/models/library_model.h"

namespace mocapress {
namespace {

class OfProjectFiles : public testing::Test {
 protected:
  OfProjectFiles() {
    window_.show();
    library_.begin(path("data"));
  }

  QString path(const char* name) const {
    return QDir(QDir(directory_.path()).canonicalPath()).filePath(QString::fromLatin1(name));
  }

  void addClips() { library_.add({path("walk.bvh"), path("jump.bvh")}); }

  /// The open question, if any.
  QMessageBox* question() const {
    for (QMessageBox* box : window_.findChildren<QMessageBox*>())
      if (box->isVisible()) return box;
    return nullptr;
  }

  void answer(QMessageBox::StandardButton button) const {
    ASSERT_TRUE(question());
    question()->button(button)->click();
  }

  /// Chooses a file in the next file dialog.
  void chooseSoon(const QString& file) {
    auto* look = new QTimer(&window_);
    QObject::connect(look, &QTimer::timeout, look, [look, file] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      if (!dialog) return;
      // Types the name as a user does: the choice of selectFile() is lost when the folder is listed
      // later.
      dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(file);
      static_cast<QDialog*>(dialog)->accept();
      if (!dialog->isVisible()) look->deleteLater();
    });
    look->start(10);
  }

  /// Writes the lock of a studio on another computer.
  void lockElsewhere(const QString& project) const {
    QFile lock(ProjectLock::fileOf(project));
    ASSERT_TRUE(lock.open(QIODevice::WriteOnly));
    lock.write("1\nmocapress-studio\nelsewhere\n");
  }

  void takeOver() const {
    ASSERT_TRUE(question());
    for (QAbstractButton* button : question()->buttons())
      if (question()->buttonRole(button) == QMessageBox::DestructiveRole) return button->click();
    FAIL() << "it cannot be taken over";
  }

  QTemporaryDir directory_;
  QWidget window_;
  Session session_;
  LibraryModel model_;
  Library library_{&session_, &model_};
  ProjectFiles files_{&library_, &window_};
};

TEST_F(OfProjectFiles, NewAsksAboutClipsWithoutANameAndKeepsThemFindableAnyway) {
  addClips();
  files_.startNew();
  answer(QMessageBox::Cancel);
  EXPECT_EQ(model_.rowCount(), 2);
  files_.startNew();
  answer(QMessageBox::Discard);
  EXPECT_EQ(model_.rowCount(), 0);

  QMenu menu;
  files_.fillRecentMenu(&menu);
  ASSERT_EQ(menu.actions().size(), 1);
  const QString date =
      QLocale().toString(library_.formerProjects()[0].written, QLocale::ShortFormat);
  EXPECT_TRUE(menu.actions()[0]->text().contains(date)) << qPrintable(menu.actions()[0]->text());
  EXPECT_TRUE(menu.actions()[0]->text().contains(QStringLiteral("2 clip")));
  menu.actions()[0]->trigger();
  EXPECT_FALSE(question()) << "an empty one is nothing to ask about";
  EXPECT_EQ(model_.rowCount(), 2);
}

TEST_F(OfProjectFiles, TheQuestionCanNameTheProjectFirst) {
  addClips();
  files_.startNew();
  chooseSoon(path("knights"));
  answer(QMessageBox::Save);
  EXPECT_EQ(model_.rowCount(), 0);
  QMenu menu;
  files_.fillRecentMenu(&menu);
  ASSERT_EQ(menu.actions().size(), 1) << "it is not there twice";
  EXPECT_TRUE(menu.actions()[0]->text().startsWith(QStringLiteral("knights")));
  files_.open(path("knights.mocapress"));
  EXPECT_EQ(model_.rowCount(), 2);
}

TEST_F(OfProjectFiles, TheDialogToSaveStartsWhereTheClipsAre) {
  QDir().mkpath(path("clips"));
  library_.add({path("clips/walk.bvh")});
  QString folder;
  QTimer look;
  QObject::connect(&look, &QTimer::timeout, [&folder] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    if (!dialog) return;
    folder = dialog->directory().path();
    dialog->reject();
  });
  look.start(10);
  EXPECT_FALSE(files_.saveAs());
  EXPECT_EQ(folder, path("clips"));
}

TEST_F(OfProjectFiles, OpenAsksTooButNotAboutAProjectWithAName) {
  addClips();
  ASSERT_TRUE(library_.saveAs(path("knights.mocapress")));
  EXPECT_EQ(files_.title(), QStringLiteral("knights"));
  files_.startNew();
  EXPECT_FALSE(question());
  EXPECT_EQ(model_.rowCount(), 0);
  EXPECT_EQ(files_.title(), QStringLiteral("Unnamed Project"));
  addClips();
  files_.open(path("knights.mocapress"));
  answer(QMessageBox::Discard);
  EXPECT_EQ(files_.title(), QStringLiteral("knights"));
  EXPECT_EQ(library_.formerProjects().size(), 1u);
}

TEST_F(OfProjectFiles, AProjectInUseIsOpenedAsACopyIfThatIsWanted) {
  addClips();
  ASSERT_TRUE(library_.saveAs(path("knights.mocapress")));
  QWidget window;
  window.show();
  Session session;
  LibraryModel model;
  Library library(&session, &model);
  ProjectFiles files(&library, &window);
  library.begin(path("data"));
  files.open(path("knights.mocapress"));
  const QList<QMessageBox*> boxes = window.findChildren<QMessageBox*>();
  ASSERT_EQ(boxes.size(), 1);
  boxes[0]->button(QMessageBox::Open)->click();
  EXPECT_EQ(model.rowCount(), 2);
  EXPECT_EQ(files.title(), QStringLiteral("Unnamed Project"));
}

TEST_F(OfProjectFiles, AProjectLockedElsewhereIsTakenOver) {
  addClips();
  const QString knights = path("knights.mocapress");
  ASSERT_TRUE(library_.saveAs(knights));
  files_.startNew();
  lockElsewhere(knights);
  files_.open(knights);
  ASSERT_TRUE(question());
  EXPECT_TRUE(question()->text().contains(QStringLiteral("elsewhere")));
  takeOver();
  EXPECT_EQ(library_.path(), knights);
}

TEST_F(OfProjectFiles, ReportsALockThatCannotBeTakenOver) {
  addClips();
  const QString knights = path("knights.mocapress");
  ASSERT_TRUE(library_.saveAs(knights));
  files_.startNew();
  const ProjectLock holder(knights);
  lockElsewhere(knights);
  QSignalSpy failed(&library_, &Library::failed);
  files_.open(knights);
  takeOver();
  ASSERT_EQ(failed.count(), 1);
  EXPECT_TRUE(failed[0][0].toString().contains(ProjectLock::fileOf(knights)));
  EXPECT_FALSE(question());
  EXPECT_NE(library_.path(), knights);
}

}  // namespace
}  // namespace mocapress
