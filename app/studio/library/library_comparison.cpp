// SPDX-License-Identifier: GPL-3.0-or-later
// Comparison of a library's clips with an earlier batch or project.
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <map>

#include "app/studio/library/library.h"
#include "core/batch/batch_folder.h"
#include "widgets/models/library_columns.h"

namespace mocapress {
namespace {

constexpr double kSame = 0.01;  // smaller relative changes are ignored, as by `mocapress diff`

/// Measurements of the clip; unset: nobody tried to compress it.
std::optional<ClipFigures> figuresOf(const ProjectClip& clip) {
  if (!clip.failure.isEmpty()) return ClipFigures{.reason = clip.failure.toStdString()};
  // Figures by older settings are left out: they would be taken for those of the present weighting.
  if (!clip.outcome || outdated(clip) == Staleness::Settings) return {};
  ClipFigures figures{.done = true,
                      .bytes = clip.outcome->motion_bytes,
                      .eps_cm = clip.outcome->eps_cm,
                      .max_cm = clip.outcome->max_cm,
                      .sight = clip.outcome->sight,
                      .limits = clip.outcome->limits};
  if (clip.settings) figures.weighting = clip.settings->preset.weighting;
  return figures;
}

/// Throws Error.
QHash<QString, ClipFigures> earlierClips(const QString& path) {
  QHash<QString, ClipFigures> clips;
  if (isProjectFile(path)) {
    for (const ProjectClip& clip : readProject(path).clips)
      if (const auto figures = figuresOf(clip)) clips.insert(clip.key(), *figures);
    return clips;
  }
  const QFileInfo file(path);
  const QString folder = file.isDir() ? path : file.absolutePath();
  visit_rows(folder.toStdU16String(), [&clips](const BatchRow& row) {
    clips.insert(clipKey(QString::fromStdString(row.input), row.reading.take), figures_of(row));
  });
  return clips;
}

/// The file name and take in a key.
QString nameIn(const QString& key) {
  const auto take = key.indexOf(QLatin1Char('\n'));  // a take's name may have a slash; -1: no take
  return key.mid(key.lastIndexOf(QLatin1Char('/'), take) + 1);
}

/// Keys by their nameIn(). Empty: several keys have this name.
QHash<QString, QString> byName(const QStringList& keys) {
  QHash<QString, QString> names;
  for (const QString& key : keys) {
    QString& only = names[nameIn(key)];
    only = only.isNull() ? key : QStringLiteral("");
  }
  return names;
}

}  // namespace

std::optional<ClipDifference> differenceSince(const ProjectClip& clip) {
  const std::optional<ClipFigures> now = figuresOf(clip);
  if (!clip.earlier || !now) return {};
  return ClipDifference{clip.path.toStdString(), clip.earlier, now,
                        changes_of(clip.earlier, now, kSame)};
}

void Library::compareWith(const QString& path) {
  comparing_.start(
      [path](const Job&) { return earlierClips(path); },
      [this, path](const EarlierClips& earlier) {
        earlier_ = earlier;
        const QFileInfo file(path);
        compare(isProjectFile(path) || file.isDir() ? file.fileName() : file.dir().dirName());
      },
      [this](const QString& message) { emit failed(message); });
}

/// Looks each clip up in the batch to compare with. Returns false if there is no such batch.
bool Library::findEarlier() {
  if (earlier_.isEmpty()) return false;
  const QHash<QString, QString> earlier_by_name = byName(earlier_.keys());
  const QHash<QString, QString> own_by_name = byName(project_.rows().keys());
  for (ProjectClip& clip : project_.clips) {
    QString key = clip.key();
    if (!earlier_.contains(key) && own_by_name.value(nameIn(key)) == key)
      key = earlier_by_name.value(nameIn(key));
    clip.earlier.reset();
    if (earlier_.contains(key)) clip.earlier = earlier_.value(key);
  }
  return true;
}

void Library::compare(const QString& name) {
  findEarlier();
  std::vector<int> rows;
  std::map<ClipChange, int> counts;
  qulonglong before = 0, after = 0;
  int found = 0;
  for (std::size_t row = 0; row < project_.clips.size(); ++row) {
    rows.push_back(static_cast<int>(row));
    const std::optional<ClipDifference> since = differenceSince(project_.clips[row]);
    if (!since) continue;
    ++found;
    if (since->before->done && since->after->done) {
      before += since->before->bytes;
      after += since->after->bytes;
    }
    for (const ClipChange change : since->changes) ++counts[change];
  }
  showRows(rows);
  QStringList changes;
  for (const auto& [change, count] : counts)
    changes << tr("%L1 %2", "number of clips, change").arg(count).arg(displayName(change));
  if (changes.isEmpty()) changes << tr("nothing changed by more than 1 %");
  emit compared();
  emit noted(tr("%Ln clip(s) compared with %1: %2 bytes then, %3 now; %4.", nullptr, found)
                 .arg(name, QLocale().toString(before), QLocale().toString(after),
                      changes.join(tr(", "))));
}

}  // namespace mocapress
