// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/study_rows_model.h"

#include <QFileInfo>
#include <QLocale>
#include <cmath>
#include <limits>
#include <optional>

#include "widgets/models/colours.h"
#include "widgets/models/display_names.h"
#include "widgets/models/number_text.h"
#include "widgets/models/sentence.h"

namespace mocapress {
namespace {

std::optional<double> value(const StudyRow& row, int column) {
  if (column == StudyRowsModel::Asked) return row.settings.target.value;
  if (!row.measured) return std::nullopt;
  const Measurement& measured = *row.measured;
  switch (column) {
    case StudyRowsModel::Ratio:
      return measured.ratio;
    case StudyRowsModel::Eps:
      return measured.eps_cm(row.settings.weighting);
    case StudyRowsModel::Max:
      return measured.max_cm(row.settings.weighting);
    case StudyRowsModel::Footskate:
      return measured.footskate_cm;
    case StudyRowsModel::Seconds:
      return measured.encode_seconds;
    default:
      return std::nullopt;
  }
}

bool isFigure(int column) {
  return column >= StudyRowsModel::Asked;
}

QString display(const StudyRow& row, int column) {
  if (column == StudyRowsModel::Clip) return clipTitle(row);
  if (column == StudyRowsModel::Method) return seriesTitle(row);
  if (column == StudyRowsModel::Asked) return targetText(row.settings.target);
  const auto found = value(row, column);
  if (!found) return QStringLiteral("–");
  if (column == StudyRowsModel::Ratio) return shown(*found, 1) + QStringLiteral(":1");
  return shownFigure(*found);
}

QVariant sortKey(const StudyRow& row, int column) {
  if (!isFigure(column)) return display(row, column);
  // Rows without a value come last.
  return value(row, column).value_or(std::numeric_limits<double>::max());
}

}  // namespace

QString seriesTitle(const StudyRow& row) {
  return seriesTitle(row.settings.method, row.ik_ratio());
}

QString clipTitle(const StudyRow& row) {
  return QFileInfo(QString::fromStdString(row.clip)).completeBaseName();
}

QString targetText(const Target& target) {
  switch (target.kind) {
    case Target::Kind::Ratio:
      return StudyRowsModel::tr("%L1:1").arg(target.value);
    case Target::Kind::CoefficientRatio:
      return StudyRowsModel::tr("r = %L1").arg(target.value);
    case Target::Kind::Size:
      return QLocale().formattedDataSize(std::llround(target.value));
    case Target::Kind::Error:
      return StudyRowsModel::tr("%L1 cm").arg(target.value);
    case Target::Kind::MaxError:
      return StudyRowsModel::tr("max %L1 cm").arg(target.value);
    case Target::Kind::Visibility:
      return StudyRowsModel::tr("%L1 times the noticeable error").arg(target.value);
  }
  return {};
}

void StudyRowsModel::clear() {
  beginResetModel();
  rows_.clear();
  endResetModel();
}

void StudyRowsModel::append(const std::vector<StudyRow>& rows) {
  if (rows.empty()) return;
  const int first = rowCount();
  beginInsertRows({}, first, first + static_cast<int>(rows.size()) - 1);
  rows_.insert(rows_.end(), rows.begin(), rows.end());
  endInsertRows();
}

QString StudyRowsModel::description(int index) const {
  const StudyRow& row = this->row(index);
  QStringList lines{tr("%1, %2").arg(clipTitle(row), seriesTitle(row))};
  if (!row.measured) {
    lines << translatedSentence(QString::fromStdString(row.error));
    return lines.join(QLatin1Char('\n'));
  }
  const Measurement& measured = *row.measured;
  lines << tr("%1:1, %2")
               .arg(shown(measured.ratio, 1),
                    QLocale().formattedDataSize(static_cast<qint64>(measured.motion_bytes)));
  lines << tr("eps_x %1 cm, at most %2 cm")
               .arg(shownFigure(measured.eps_cm(row.settings.weighting)),
                    shownFigure(measured.max_cm(row.settings.weighting)));
  if (measured.footskate_cm)
    lines << tr("%1 cm of footskate in %Ln contact(s)", nullptr, measured.contacts)
                 .arg(shown(*measured.footskate_cm, 1));
  if (!row.reached()) lines << tr("Asked for %1.").arg(targetText(row.settings.target));
  return lines.join(QLatin1Char('\n'));
}

int StudyRowsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int StudyRowsModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kColumns;
}

QVariant StudyRowsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const StudyRow& row = this->row(index.row());
  switch (role) {
    case Qt::DisplayRole:
      return display(row, index.column());
    case Qt::ToolTipRole:
      return description(index.row());
    case Qt::TextAlignmentRole:
      return QVariant((isFigure(index.column()) ? Qt::AlignRight : Qt::AlignLeft) |
                      Qt::AlignVCenter);
    case Qt::DecorationRole:
      if (index.column() == Method)
        return seriesStyle(row.settings.method, row.ik_ratio().has_value()).colour;
      return {};
    case SortRole:
      return sortKey(row, index.column());
    case ClipPathRole:
      return QString::fromStdString(row.clip);
    default:
      return {};
  }
}

QVariant StudyRowsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole)
    return QVariant((isFigure(section) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  struct Texts {
    QString name, tip;
  };
  const auto texts = [&]() -> Texts {
    switch (section) {
      case Clip:
        return {tr("Clip"), {}};
      case Method:
        return {tr("Method"), {}};
      case Asked:
        return {tr("Asked"), tr("Target: a ratio, or the largest error allowed.")};
      case Ratio:
        return {tr("Ratio"),
                tr("Bytes of the channels as 32-bit floats, divided by compressed bytes.")};
      case Eps:
        return {tr("eps_x cm"), tr("Weighted root mean square error.")};
      case Max:
        return {tr("Max cm"), tr("Largest error of any point at any frame.")};
      case Footskate:
        return {tr("Slide cm"), tr("Path of feet while they stand in the original.")};
      default:
        return {tr("Seconds"), tr("Time to compress, including the search for the target.")};
    }
  }();
  if (role == Qt::DisplayRole) return texts.name;
  if (role == Qt::ToolTipRole) return texts.tip;
  return {};
}

}  // namespace mocapress
