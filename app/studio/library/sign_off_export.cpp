// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/sign_off_export.h"

#include <QBuffer>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHash>
#include <QPageLayout>
#include <QPageSize>
#include <QPdfWriter>
#include <QTextDocument>

#include "app/studio/library/library.h"
#include "core/base/file.h"
#include "core/report/verdict.h"
#include "widgets/models/library_model.h"
#include "widgets/models/report_texts.h"

namespace mocapress {
namespace {

constexpr int kResolution = 300;  // dots per inch

QByteArray pdfOf(const SignOff& report) {
  QTextDocument document;
  document.setHtml(QString::fromStdString(sign_off_html(report, ReportMedium::Paper)));
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setTitle(QString::fromStdString(report.title));
  writer.setCreator(QString::fromStdString(report.stamp.program));
  writer.setResolution(kResolution);
  writer.setPageSize(QPageSize(QPageSize::A4));
  writer.setPageOrientation(QPageLayout::Landscape);
  writer.setPageMargins({});  // the document has margins of its own
  document.print(&writer);
  buffer.close();
  return bytes;
}

SignOffFigures figuresIn(const ProjectClip& clip) {
  const Outcome& outcome = *clip.outcome;
  SignOffFigures figures{.ratio = outcome.ratio,
                         .bytes = outcome.motion_bytes,
                         .eps_cm = outcome.eps_cm,
                         .max_cm = outcome.max_cm,
                         .worst_frame = outcome.worst_frame,
                         .worst_point = outcome.worst_point,
                         .sight = outcome.sight,
                         .limits = outcome.limits};
  // Figures are stale when a verdict on that outcome would be stale.
  figures.stale = stale_reason({.verdict = Verdict::Approved,
                                .source_hash = outcome.source,
                                .settings_hash = outcome.settings},
                               clip.stamp.source, settingsHash(clip));
  // settingsHash() does not cover limits of visibility that change no bytes.
  if (!figures.stale && outdated(clip) == Staleness::Settings)
    figures.stale = "the settings changed";
  return figures;
}

}  // namespace

SignOff signOffOf(const Library& library, const LibraryModel& rows) {
  SignOff report{.title = library.name().toStdString(),
                 .clips = {},
                 .stamp = report_stamp(),
                 .language = reportLanguage()};
  const std::vector<ProjectClip>& clips = library.project().clips;
  QHash<QString, int> clips_of_name;
  for (int row = 0; row < rows.rowCount(); ++row) ++clips_of_name[rows.entry(row).name()];
  for (std::size_t row = 0; row < clips.size(); ++row) {
    const ProjectClip& clip = clips[row];
    const LibraryEntry& entry = rows.entry(static_cast<int>(row));
    QString name = entry.name();
    if (clips_of_name[name] > 1)
      name.prepend(QFileInfo(clip.path).dir().dirName() + QLatin1Char('/'));
    SignOffClip one{.name = name.toStdString(),
                    .path = clip.path.toStdString(),
                    .take = clip.reading.take.value_or(std::string()),
                    .sample_rate_hz = entry.sample_rate_hz,
                    .review = clip.review,
                    .source_hash = clip.stamp.source,
                    .settings_hash = settingsHash(clip),
                    .figures = {},
                    .problem = entry.missing             ? "the file is missing"
                               : entry.trouble.isEmpty() ? entry.failure.toStdString()
                                                         : entry.trouble.toStdString()};
    if (clip.outcome) one.figures = figuresIn(clip);
    report.clips.push_back(std::move(one));
  }
  return report;
}

void writeSignOff(const QString& path, const SignOff& report) {
  const QString kind = QFileInfo(path).suffix().toLower();
  if (kind == QLatin1String("pdf")) {
    const QByteArray pdf = pdfOf(report);
    return write_text(path.toStdU16String(),
                      {pdf.constData(), static_cast<std::size_t>(pdf.size())});
  }
  write_text(path.toStdU16String(),
             kind == QLatin1String("csv") ? sign_off_csv(report) : sign_off_html(report));
}

SignOffExport::SignOffExport(const Library* library, const LibraryModel* rows, QWidget* window)
    : QObject(window), library_(library), rows_(rows), window_(window) {}

void SignOffExport::choose() {
  QString name = QStringLiteral("sign-off");
  if (!library_->name().isEmpty()) name.prepend(library_->name() + QLatin1Char('-'));
  auto* dialog = new QFileDialog(window_, tr("Export Sign-off"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  const QStringList kinds{QStringLiteral("html"), QStringLiteral("pdf"), QStringLiteral("csv")};
  const QStringList filters{tr("Web pages (*.html)"), tr("PDF (*.pdf)"), tr("Tables (*.csv)")};
  dialog->setNameFilters(filters);
  dialog->setDefaultSuffix(kinds.front());
  if (!library_->path().isEmpty() && !library_->name().isEmpty())
    dialog->setDirectory(QFileInfo(library_->path()).dir());
  else
    dialog->setDirectory(library_->clipFolder());
  dialog->selectFile(name + QLatin1String(".html"));
  connect(dialog, &QFileDialog::filterSelected, dialog, [=](const QString& filter) {
    const QString kind = kinds.value(filters.indexOf(filter));
    dialog->setDefaultSuffix(kind);
    const QFileInfo chosen(dialog->selectedFiles().value(0));
    if (kinds.contains(chosen.suffix().toLower()))
      dialog->selectFile(chosen.completeBaseName() + QLatin1Char('.') + kind);
  });
  connect(dialog, &QFileDialog::fileSelected, this, &SignOffExport::write);
  dialog->open();
}

void SignOffExport::write(const QString& path) {
  writing_.start(
      [path, report = signOffOf(*library_, *rows_)](const Job&) {
        writeSignOff(path, report);
        return QFileInfo(path).fileName();
      },
      [this](const QString& name) { emit written(tr("Exported %1.").arg(name)); },
      [this](const QString& message) { emit failed(message); });
}

}  // namespace mocapress
