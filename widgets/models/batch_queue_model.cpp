// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/batch_queue_model.h"

#include <QDir>
#include <QFileInfo>
#include <QFont>
#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <set>

#include "widgets/icons/themed_icon.h"
#include "widgets/models/display_names.h"
#include "widgets/models/number_text.h"
#include "widgets/models/sentence.h"

namespace mocapress {
namespace {

QString stageName(ClipProgress::Stage stage) {
  switch (stage) {
    case ClipProgress::Stage::Reading:
      return BatchQueueModel::tr("Reading");
    case ClipProgress::Stage::Encoding:
      return BatchQueueModel::tr("Compressing");
    case ClipProgress::Stage::Verifying:
      return BatchQueueModel::tr("Verifying");
  }
  return {};
}

/// The error without the clip's path, line and column at its start; the row already shows the path.
QString shortError(const QueuedClip& clip) {
  const QString path = QRegularExpression::escape(QString::fromStdString(clip.source.path));
  const QRegularExpression place(QStringLiteral("^%1(:\\d+)*:? ").arg(path));
  return QString::fromStdString(clip.error).remove(place);
}

}  // namespace

QString batchTargetText(const Target& target) {
  const QString value = QLocale().toString(target.value, 'g', 6);
  switch (target.kind) {
    case Target::Kind::Ratio:
      return BatchQueueModel::tr("%1:1").arg(value);
    case Target::Kind::CoefficientRatio:
      return BatchQueueModel::tr("r = %1").arg(value);
    case Target::Kind::Size:
      return QLocale().formattedDataSize(std::llround(target.value));
    case Target::Kind::Error:
      return BatchQueueModel::tr("eps_x %1 cm").arg(value);
    case Target::Kind::MaxError:
      return BatchQueueModel::tr("at most %1 cm").arg(value);
    case Target::Kind::Visibility:
      return target.value == 1 ? BatchQueueModel::tr("not visible")
                               : BatchQueueModel::tr("%1 times the noticeable error").arg(value);
  }
  return {};
}

const Settings& BatchQueueModel::presetOf(int row) const {
  const QueuedClip& clip = clips_[static_cast<std::size_t>(row)];
  return clip.own ? *clip.own : common_;
}

void BatchQueueModel::replace(const Settings& common, const std::vector<QueuedClip>& clips) {
  beginResetModel();
  common_ = common;
  clips_ = clips;
  translated_.clear();
  files_of_name_.clear();
  endResetModel();
}

void BatchQueueModel::setCommon(const Settings& preset) {
  if (preset == common_) return;
  common_ = preset;
  for (int row = 0; row < rowCount(); ++row)
    if (!clips_[static_cast<std::size_t>(row)].own) wait(row);
  emit edited();
}

void BatchQueueModel::setOwn(const std::vector<int>& rows, const std::optional<Settings>& preset) {
  std::map<int, std::optional<Settings>> by_row;
  for (const int row : rows) by_row[row] = preset;
  setOwn(by_row);
}

void BatchQueueModel::setOwn(const std::map<int, std::optional<Settings>>& by_row) {
  for (const auto& [row, preset] : by_row) {
    QueuedClip& clip = clips_[static_cast<std::size_t>(row)];
    const Settings before = presetOf(row);
    clip.own = preset;
    presetOf(row) == before ? changed(row) : wait(row);
  }
  if (!by_row.empty()) emit edited();
}

void BatchQueueModel::setReading(int row, const ReadOptions& reading) {
  clips_[static_cast<std::size_t>(row)].reading = reading;
  wait(row);
  emit edited();
}

void BatchQueueModel::setReviews(const ClipReviews& reviews) {
  bool any = false;
  for (int row = 0; row < rowCount(); ++row) {
    QueuedClip& clip = clips_[static_cast<std::size_t>(row)];
    const auto found = reviews.find(clip.key());
    if (found == reviews.end()) continue;
    const bool same_files = found->source == clip.files && found->missing == clip.missing;
    clip.files = found->source;
    clip.missing = found->missing;
    if (!same_files) changed(row);
    if (found->review == clip.review) continue;
    const bool was_rejected = clip.review.verdict == Verdict::Rejected;
    const bool is_rejected = found->review.verdict == Verdict::Rejected;
    if (was_rejected != is_rejected) clip.left_out = is_rejected;
    clip.review = found->review;
    any = true;
    changed(row);
  }
  if (any) emit edited();
}

void BatchQueueModel::setLeftOut(const std::vector<int>& rows, bool left_out) {
  for (const int row : rows) {
    clips_[static_cast<std::size_t>(row)].left_out = left_out;
    changed(row);
  }
  if (!rows.empty()) emit edited();
}

void BatchQueueModel::add(const std::vector<QueuedClip>& clips) {
  std::set<QString> there;
  for (const QueuedClip& clip : clips_) there.insert(clip.key());
  std::vector<QueuedClip> fresh;
  for (const QueuedClip& clip : clips)
    if (there.insert(clip.key()).second) fresh.push_back(clip);
  if (fresh.empty()) return;
  beginInsertRows({}, rowCount(), rowCount() + static_cast<int>(fresh.size()) - 1);
  clips_.insert(clips_.end(), fresh.begin(), fresh.end());
  files_of_name_.clear();
  endInsertRows();
  emit edited();
}

void BatchQueueModel::insert(const std::map<int, QueuedClip>& clips) {
  for (const auto& [row, clip] : clips) {
    beginInsertRows({}, row, row);
    clips_.insert(clips_.begin() + row, clip);
    files_of_name_.clear();
    endInsertRows();
  }
  if (!clips.empty()) emit edited();
}

void BatchQueueModel::remove(std::vector<int> rows) {
  std::sort(rows.rbegin(), rows.rend());
  for (const int row : rows) {
    beginRemoveRows({}, row, row);
    clips_.erase(clips_.begin() + row);
    files_of_name_.clear();
    endRemoveRows();
  }
  if (!rows.empty()) emit edited();
}

void BatchQueueModel::setProgress(int row, const ClipProgress& progress) {
  QueuedClip& clip = clips_[static_cast<std::size_t>(row)];
  clip.state = QueuedClip::State::Working;
  clip.progress = progress;
  changed(row);
}

void BatchQueueModel::setEnded(int row, const std::optional<Measurement>& measured,
                               const std::string& error, const std::vector<std::string>& warnings) {
  QueuedClip& clip = clips_[static_cast<std::size_t>(row)];
  clip.state = error.empty() ? QueuedClip::State::Done : QueuedClip::State::Failed;
  clip.measured = measured;
  clip.error = error;
  clip.warnings = warnings;
  changed(row);
}

void BatchQueueModel::stopWorking() {
  for (int row = 0; row < rowCount(); ++row)
    if (clips_[static_cast<std::size_t>(row)].state == QueuedClip::State::Working) wait(row);
}

void BatchQueueModel::waitAgain() {
  for (int row = 0; row < rowCount(); ++row) wait(row);
}

void BatchQueueModel::wait(int row) {
  QueuedClip& clip = clips_[static_cast<std::size_t>(row)];
  clip.state = QueuedClip::State::Waiting;
  clip.progress = {};
  clip.measured.reset();
  clip.error.clear();
  clip.warnings.clear();
  changed(row);
}

void BatchQueueModel::changed(int row) {
  emit dataChanged(index(row, 0), index(row, Columns - 1));
}

int BatchQueueModel::count(QueuedClip::State state) const {
  return static_cast<int>(std::count_if(clips_.begin(), clips_.end(), [&](const QueuedClip& clip) {
    return clip.state == state && !clip.left_out;
  }));
}

int BatchQueueModel::countLeftOut() const {
  return static_cast<int>(std::count_if(clips_.begin(), clips_.end(),
                                        [](const QueuedClip& clip) { return clip.left_out; }));
}

int BatchQueueModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(clips_.size());
}

int BatchQueueModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : Columns;
}

/// Translates a sentence once and keeps the result: the translation tries hundreds of patterns, and
/// rows are painted often.
QString BatchQueueModel::translated(const QString& sentence) const {
  auto found = translated_.find(sentence);
  if (found == translated_.end())
    found = translated_.insert(sentence, translatedSentence(sentence));
  return *found;
}

/// The file's name, with that of its folder where several files share the name.
QString BatchQueueModel::nameOf(const QueuedClip& clip) const {
  const auto base = [](const QueuedClip& one) {
    return QFileInfo(QString::fromStdString(one.source.path)).completeBaseName();
  };
  if (files_of_name_.isEmpty())
    for (const QueuedClip& one : clips_)
      files_of_name_[base(one)].insert(QString::fromStdString(one.source.path));
  const QString name = base(clip);
  if (files_of_name_.value(name).size() < 2) return name;
  const QFileInfo file(QString::fromStdString(clip.source.path));
  return file.dir().dirName() + QLatin1Char('/') + file.fileName();
}

QString BatchQueueModel::stateText(const QueuedClip& clip) const {
  if (clip.left_out) return tr("Left out");
  switch (clip.state) {
    case QueuedClip::State::Waiting:
      return tr("Waiting");
    case QueuedClip::State::Working:
      return tr("%1, %L2 %")
          .arg(stageName(clip.progress.stage))
          .arg(std::lround(100 * clip.progress.fraction));
    case QueuedClip::State::Done:
      if (!clip.warnings.empty())
        return tr("✓ Verified, %Ln warning(s)", nullptr, static_cast<int>(clip.warnings.size()));
      return tr("✓ Verified");
    case QueuedClip::State::Failed:
      return tr("✗ %1").arg(translated(shortError(clip)));
  }
  return {};
}

Staleness BatchQueueModel::staleVerdict(int row) const {
  const QueuedClip& clip = clips_[static_cast<std::size_t>(row)];
  if (clip.review.verdict == Verdict::None) return Staleness::None;
  if (clip.missing) return Staleness::Missing;
  if (clip.files.empty()) return Staleness::Unknown;
  return staleness(clip.review.source_hash, clip.review.settings_hash, clip.files,
                   settings_hash(presetOf(row), clip.reading));
}

int BatchQueueModel::countStale() const {
  int stale = 0;
  for (int row = 0; row < rowCount(); ++row)
    if (!clips_[static_cast<std::size_t>(row)].left_out && staleVerdict(row) != Staleness::None)
      ++stale;
  return stale;
}

QString BatchQueueModel::reviewText(int row) const {
  const QueuedClip& clip = clips_[static_cast<std::size_t>(row)];
  const QString note = QString::fromStdString(clip.review.note).simplified();
  if (clip.review.verdict == Verdict::None) return note;
  const QString verdict = verdictText(clip.review.verdict, staleVerdict(row));
  return note.isEmpty() ? verdict : tr("%1: %2").arg(verdict, note);
}

QVariant BatchQueueModel::figure(const QueuedClip& clip, int row, int column) const {
  if (!clip.measured) return QStringLiteral("–");
  switch (column) {
    case Ratio:
      return tr("%1:1").arg(shown(clip.measured->ratio, 1));
    case Eps:
      return shownFigure(clip.measured->eps_cm(presetOf(row).weighting));
    default:
      return shownFigure(clip.measured->max_cm(presetOf(row).weighting));
  }
}

QString BatchQueueModel::toolTip(int row, int column) const {
  const QueuedClip& clip = clips_[static_cast<std::size_t>(row)];
  if (column == Lock)
    return clip.own ? tr("Locked: the clip keeps its own settings. Click to give it the settings "
                         "shared by all clips.")
                    : tr("Click to lock the clip's settings, so that changes for all clips do not "
                         "apply to it.");
  if (column == State && clip.left_out)
    return tr("The clip is not exported. Tick it to export it too.");
  if (column == State && clip.state == QueuedClip::State::Failed)
    return translatedSentence(QString::fromStdString(clip.error));
  if (column == State && !clip.warnings.empty()) {
    QStringList lines;
    for (const std::string& warning : clip.warnings)
      lines << translatedSentence(QString::fromStdString(warning));
    return lines.join(QLatin1Char('\n'));
  }
  if (column == Preset) {
    const QString details = detailsOf(presetOf(row));
    if (!details.isEmpty()) return details;
  }
  if (column == Review && clip.review != ClipReview()) {
    QStringList lines{verdictText(clip.review.verdict, staleVerdict(row)),
                      reviewerText(clip.review), QString::fromStdString(clip.review.note)};
    lines.removeAll(QString());
    return lines.join(QLatin1Char('\n'));
  }
  return QDir::toNativeSeparators(QString::fromStdString(clip.source.path));
}

QVariant BatchQueueModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const int row = index.row();
  const QueuedClip& clip = clips_[static_cast<std::size_t>(row)];
  switch (role) {
    case Qt::DisplayRole:
      switch (index.column()) {
        case Clip:
          return clip.reading.take ? nameOf(clip) + QStringLiteral(": ") +
                                         QString::fromStdString(*clip.reading.take)
                                   : nameOf(clip);
        case Lock:
          return {};
        case Preset: {
          const Settings& preset = presetOf(row);
          const QString text =
              tr("%1 · %2").arg(displayName(preset), batchTargetText(preset.target));
          if (preset.ranges.empty()) return text;
          return tr("%1 · %2").arg(
              text, tr("%Ln care range(s)", nullptr, static_cast<int>(preset.ranges.size())));
        }
        case Review:
          return reviewText(row);
        case State:
          return stateText(clip);
        default:
          return figure(clip, row, index.column());
      }
    case Qt::CheckStateRole:
      if (index.column() != Clip) return {};
      return clip.left_out ? Qt::Unchecked : Qt::Checked;
    case Qt::DecorationRole:
      if (index.column() != Lock) return {};
      return themedIcon(clip.own ? QStringLiteral("lock") : QStringLiteral("unlock"));
    case Qt::AccessibleTextRole:
      if (index.column() == Lock) return clip.own ? tr("locked") : tr("not locked");
      return {};
    case Qt::ToolTipRole:
      return toolTip(row, index.column());
    case Qt::TextAlignmentRole:
      return QVariant((index.column() >= Ratio ? Qt::AlignRight : Qt::AlignLeft) |
                      Qt::AlignVCenter);
    case Qt::FontRole:
      if (index.column() == Preset && clip.own) {
        QFont font;
        font.setWeight(QFont::DemiBold);
        return font;
      }
      return {};
    case kProgressRole:
      if (clip.state == QueuedClip::State::Working) return clip.progress.fraction;
      return {};
    case kStateRole:
      return static_cast<int>(clip.left_out ? QueuedClip::State::Waiting : clip.state);
    default:
      return {};
  }
}

Qt::ItemFlags BatchQueueModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags usual = QAbstractTableModel::flags(index);
  return index.isValid() && index.column() == Clip ? usual | Qt::ItemIsUserCheckable : usual;
}

/// Only asks for the change: the owner of the undo history answers includeToggled() and changes the
/// model.
bool BatchQueueModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid() || index.column() != Clip || role != Qt::CheckStateRole) return false;
  emit includeToggled(index.row(), value.toInt() == Qt::Checked);
  return true;
}

QVariant BatchQueueModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole)
    return QVariant((section >= Ratio ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  struct Texts {
    QString name, tip;
  };
  const auto texts = [&]() -> Texts {
    switch (section) {
      case Clip:
        return {tr("Clip"), tr("Only ticked clips are exported.")};
      case Lock:
        return {{}, tr("Locked clips keep their own settings.")};
      case Preset:
        return {tr("Settings"), tr("The preset and its target.")};
      case Review:
        return {tr("Verdict"),
                tr("The clip's verdict in the library. Rejected clips are exported only if they "
                   "are ticked. A verdict is stale if files or settings have changed since.")};
      case State:
        return {tr("State"), tr("Verified: the file was read back, decoded and measured.")};
      case Ratio:
        return {tr("Ratio"),
                tr("Bytes of the channels as 32-bit floats, divided by compressed bytes.")};
      case Eps:
        return {tr("eps_x cm"), tr("Weighted root mean square error.")};
      default:
        return {tr("Max cm"), tr("Largest error of any point at any frame.")};
    }
  }();
  if (role == Qt::DisplayRole) return texts.name;
  if (role == Qt::ToolTipRole) return texts.tip;
  return {};
}

}  // namespace mocapress
