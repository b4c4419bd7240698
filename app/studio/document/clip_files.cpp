// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/document/clip_files.h"

#include <QAction>
#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QSettings>
#include <algorithm>
#include <utility>

#include "app/studio/document/import_options_dialog.h"
#include "app/studio/document/session.h"
#include "core/codec/methods/comparison_method.h"
#include "core/formats/clip_files.h"
#include "core/formats/motion_file.h"

namespace mocapress {

namespace {

constexpr int kMostRemembered = 12;
const QString kList = QStringLiteral("recent-files");
const QString kPath = QStringLiteral("path");
const QString kSkeleton = QStringLiteral("skeleton");

}  // namespace

QList<RecentFile> recentFiles() {
  QSettings settings;
  QList<RecentFile> files;
  const int count = settings.beginReadArray(kList);
  for (int i = 0; i < count; ++i) {
    settings.setArrayIndex(i);
    const RecentFile file{settings.value(kPath).toString(), settings.value(kSkeleton).toString()};
    if (QFileInfo::exists(file.path)) files << file;
  }
  settings.endArray();
  return files;
}

QString rememberedSkeleton(const QString& path) {
  for (const RecentFile& file : recentFiles())
    if (file.path == QFileInfo(path).absoluteFilePath()) return file.skeleton;
  return {};
}

void rememberRecentFile(const RecentFile& file) {
  const RecentFile absolute{QFileInfo(file.path).absoluteFilePath(), file.skeleton};
  QList<RecentFile> files = recentFiles();
  files.removeIf([&](const RecentFile& other) { return other.path == absolute.path; });
  files.prepend(absolute);
  files.resize(std::min<qsizetype>(files.size(), kMostRemembered));

  QSettings settings;
  settings.beginWriteArray(kList, static_cast<int>(files.size()));
  for (int i = 0; i < files.size(); ++i) {
    settings.setArrayIndex(i);
    settings.setValue(kPath, files[i].path);
    settings.setValue(kSkeleton, files[i].skeleton);
  }
  settings.endArray();
}

namespace {

QString fileName(const QString& path) {
  return QFileInfo(path).fileName();
}

/// Formats that an open clip can be written in; only the first one keeps the whole clip.
const QStringList kExtensions = {QStringLiteral("mcpr"), QStringLiteral("bvh"),
                                 QStringLiteral("fbx"),  QStringLiteral("glb"),
                                 QStringLiteral("amc"),  QStringLiteral("csv")};

QString filterOf(const QString& extension) {
  if (extension == QLatin1String("mcpr")) return ClipFiles::tr("Compressed clips (*.mcpr)");
  if (extension == QLatin1String("bvh")) return ClipFiles::tr("Biovision motion (*.bvh)");
  if (extension == QLatin1String("fbx")) return ClipFiles::tr("FBX on its skeleton (*.fbx)");
  if (extension == QLatin1String("glb")) return ClipFiles::tr("glTF on its skeleton (*.glb)");
  if (extension == QLatin1String("amc"))
    return ClipFiles::tr("Acclaim motion with its skeleton (*.amc)");
  if (extension == QLatin1String("html")) return ClipFiles::tr("Review pages (*.html)");
  return ClipFiles::tr("Table of channels (*.csv)");
}

}  // namespace

QString motionPatterns() {
  return QString::fromStdString(readable_extensions(" ", "*"));
}

QString sampleClip() {
  const QString installed =
      QCoreApplication::applicationDirPath() + QStringLiteral("/../share/mocapress/samples");
  for (const QString& directory : {installed, QStringLiteral(MOCAPRESS_SAMPLES)}) {
    const QFileInfo clip(directory + QStringLiteral("/human_walk.amc"));
    if (clip.exists()) return clip.canonicalFilePath();
  }
  return {};
}

ClipFiles::ClipFiles(Session* session, QWidget* window)
    : QObject(window), session_(session), window_(window) {
  connect(session, &Session::opened, this, [](const OpenRequest& request) {
    rememberRecentFile({request.path, request.skeleton});
  });
  connect(session, &Session::openFailed, this,
          [this](const OpenRequest& request, const QString& message) {
            unread_ = request;
            const bool is_amc = request.path.endsWith(QLatin1String(".amc"), Qt::CaseInsensitive);
            emit openFailed(message, is_amc && QFileInfo::exists(request.path));
          });
  connect(session, &Session::saved, this, &ClipFiles::noteSaved);
  connect(session, &Session::exported, this,
          [this](const QString& path) { emit exported(fileName(path)); });
  connect(session, &Session::saveFailed, this, [this] { after_saving_ = nullptr; });
}

void ClipFiles::openFirst() {
  const QList<RecentFile> recent = recentFiles();
  const auto left = std::find_if(recent.begin(), recent.end(), [](const RecentFile& file) {
    return QFileInfo::exists(file.path);
  });
  const RecentFile first = left == recent.end() ? RecentFile{sampleClip(), {}} : *left;
  if (!first.path.isEmpty()) session_->open(first.path, first.skeleton);
}

void ClipFiles::open(const QString& path, const QString& skeleton) {
  leave([=, this] { session_->open(path, skeleton); });
}

void ClipFiles::openRow(const StudyRow& row) {
  const QString path = QString::fromStdString(row.clip);
  // If the row's clip is open, opening the row only changes settings, as a slider does.
  if (session_->isOpen(path) && !find_comparison_method(row.settings.method))
    return session_->openRow(row);
  leave([=, this] { session_->openRow(row, rememberedSkeleton(path)); });
}

void ClipFiles::chooseClip() {
  const QString path = QFileDialog::getOpenFileName(
      window_, tr("Open"), directory(),
      tr("Motion and compressed clips (%1 *.mcpr);;All files (*)").arg(motionPatterns()));
  if (!path.isEmpty()) open(path);
}

void ClipFiles::chooseSkeleton() {
  const QString skeleton =
      QFileDialog::getOpenFileName(window_, tr("Skeleton of %1").arg(fileName(unread_.path)),
                                   QFileInfo(unread_.path).path(), tr("Skeletons (*.asf)"));
  if (skeleton.isEmpty()) return;
  if (unread_.compare)
    session_->compareWith(unread_.path, skeleton);
  else
    session_->open(unread_.path, skeleton);
}

void ClipFiles::chooseCharacter() {
  const QString path =
      QFileDialog::getOpenFileName(window_, tr("Put a Character on the Clip"), directory(),
                                   tr("Characters (*.fbx *.glb *.gltf *.vrm)"));
  if (!path.isEmpty()) session_->putCharacter(path);
}

void ClipFiles::chooseOriginal() {
  const QString path = QFileDialog::getOpenFileName(
      window_, tr("Compare with Original"), directory(), tr("Motion (%1)").arg(motionPatterns()));
  if (!path.isEmpty()) session_->compareWith(path);
}

void ClipFiles::save() {
  const QString& path = session_->document().savedPath();
  if (path.isEmpty())
    saveAs();
  else
    session_->save(path);
}

void ClipFiles::saveAs() {
  // Before the clip is left, offers only the format that keeps the whole clip.
  choosePlace(tr("Save Clip"), QStringLiteral("mcpr"),
              after_saving_ ? QStringList{QStringLiteral("mcpr")} : kExtensions);
}

void ClipFiles::exportMotion() {
  choosePlace(tr("Export Motion"), QStringLiteral("bvh"), kExtensions,
              session_->document().wornFile());
}

void ClipFiles::exportReview() {
  choosePlace(tr("Export Review Page"), QStringLiteral("html"), {QStringLiteral("html")});
}

void ClipFiles::choosePlace(const QString& title, const QString& extension, QStringList extensions,
                            const QString& worn) {
  auto* dialog = new QFileDialog(window_, title, suggestedPath(extension));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  QStringList filters;
  for (const QString& each : extensions) filters << filterOf(each);
  // The last choices write the file of the character that the clip wears, with the clip's motion.
  const qsizetype offered = filters.size();
  for (const QString& each : {QStringLiteral("fbx"), QStringLiteral("glb")})
    if (!worn.isEmpty() && can_be_onto("motion." + each.toStdString(), worn.toStdU16String())) {
      extensions << each;
      filters << tr("%1 with this motion (*.%2)").arg(fileName(worn), each);
    }
  dialog->setNameFilters(filters);
  dialog->selectNameFilter(filterOf(extension));
  dialog->setDefaultSuffix(extension);
  dialog->selectFile(fileName(suggestedPath(extension)));
  // Replaces a known extension in the name by that of the chosen format.
  connect(dialog, &QFileDialog::filterSelected, this, [=](const QString& filter) {
    const QString chosen = extensions.value(static_cast<int>(filters.indexOf(filter)));
    dialog->setDefaultSuffix(chosen);
    const QStringList names = dialog->selectedFiles();
    const QFileInfo name(names.value(0));
    if (extensions.contains(name.suffix().toLower()))
      dialog->selectFile(name.completeBaseName() + QLatin1Char('.') + chosen);
  });
  connect(dialog, &QFileDialog::fileSelected, this, [=, this](const QString& path) {
    const bool wears = filters.indexOf(dialog->selectedNameFilter()) >= offered;
    write(path, wears ? worn : QString());
  });
  connect(dialog, &QFileDialog::rejected, this, [this] { after_saving_ = nullptr; });
  dialog->open();
}

void ClipFiles::write(const QString& path, const QString& worn) {
  const QFileInfo file(path);
  const QString kind = file.suffix().toLower();
  if (kind == QLatin1String("mcpr")) return session_->save(path);
  // Any of the dialogs accepts a typed name with this extension, and the clip may have changed
  // meanwhile.
  if (const OriginalPtr& original = session_->document().original();
      kind == QLatin1String("html") && original)
    return session_->exportReview(path, remarks_(session_->openKey()));
  const QString skeleton =
      file.path() + QLatin1Char('/') + file.completeBaseName() + QLatin1String(".asf");
  // The dialog asked about replacing `path`, but not about the original or a skeleton beside it.
  QString doubt;
  if (session_->isOpen(path))
    doubt = tr("%1 is the original that is open. Replace it with the compressed motion?")
                .arg(fileName(path));
  else if (kind == QLatin1String("amc") && QFileInfo::exists(skeleton))
    doubt = tr("The skeleton is written to %1, which exists already. Replace it?")
                .arg(fileName(skeleton));
  else if (!worn.isEmpty() && QFileInfo(path) == QFileInfo(worn))
    doubt = tr("%1 is the file of the character. Replace it with a file that also has this motion?")
                .arg(fileName(path));
  // A typed extension may be one that cannot hold the character.
  const QString onto = can_be_onto(path.toStdU16String(), worn.toStdU16String()) ? worn : QString();
  if (doubt.isEmpty()) return session_->exportMotion(path, onto);
  auto* question = new QMessageBox(QMessageBox::Question, tr("Export Motion"), doubt,
                                   QMessageBox::Yes | QMessageBox::No, window_);
  question->setDefaultButton(QMessageBox::No);
  question->setAttribute(Qt::WA_DeleteOnClose);
  connect(question, &QMessageBox::finished, this, [=, this](int button) {
    if (button == QMessageBox::Yes) session_->exportMotion(path, onto);
  });
  question->open();
}

void ClipFiles::chooseImportOptions() {
  const OriginalPtr& original = session_->document().original();
  if (!original) return;
  auto* dialog = new ImportOptionsDialog(*original, window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [=, this, path = original->path] {
    if (session_->isOpen(path))
      leave([=, this, options = dialog->options()] { session_->readAgain(options); });
  });
  dialog->open();
}

void ClipFiles::leave(std::function<void()> then) {
  const Document& document = session_->document();
  if (!document.modified()) return then();
  auto* question =
      new QMessageBox(QMessageBox::Question, tr("Unsaved Changes"),
                      tr("Save the compressed clip of %1?").arg(document.title()),
                      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
  question->setInformativeText(tr("The project keeps the clip's settings either way."));
  question->setAttribute(Qt::WA_DeleteOnClose);
  connect(question, &QMessageBox::finished, this, [this, then = std::move(then)](int button) {
    if (button == QMessageBox::Discard) then();
    if (button != QMessageBox::Save) return;
    after_saving_ = then;
    save();
  });
  question->open();
}

void ClipFiles::noteSaved(const QString& path) {
  rememberRecentFile({path, {}});
  emit saved(fileName(path));
  if (after_saving_) std::exchange(after_saving_, nullptr)();
}

void ClipFiles::fillRecentMenu(QMenu* menu) {
  menu->clear();
  for (const RecentFile& file : recentFiles()) {
    QAction* action = menu->addAction(fileName(file.path));
    action->setToolTip(file.path);
    connect(action, &QAction::triggered, this, [=, this] { open(file.path, file.skeleton); });
  }
  menu->setToolTipsVisible(true);
}

QString ClipFiles::directory() const {
  const QList<RecentFile> recent = recentFiles();
  return recent.isEmpty() ? QString() : QFileInfo(recent.front().path).path();
}

QString ClipFiles::suggestedPath(const QString& extension) const {
  const Document& document = session_->document();
  const QString& saved = document.savedPath();
  const QFileInfo clip(saved.isEmpty() ? document.original()->path : saved);
  const QString stem = clip.path() + QLatin1Char('/') + clip.completeBaseName();
  const QString path = stem + QLatin1Char('.') + extension;
  return session_->isOpen(path) ? stem + QLatin1String("-compressed.") + extension : path;
}

}  // namespace mocapress
