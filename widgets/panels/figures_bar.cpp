// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/figures_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>

#include "widgets/models/display_names.h"
#include "widgets/models/number_text.h"

namespace mocapress {
namespace {

const QString kUnknown = QStringLiteral("–");

QString distance(const std::optional<double>& cm) {
  return cm ? lengthText(*cm) : kUnknown;
}

}  // namespace

FiguresBar::FiguresBar(QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 1, 8, 1);
  row->setSpacing(5);
  range_ = new QLabel(this);
  range_->setAccessibleName(tr("Errors in the range"));
  range_->setToolTip(
      tr("Errors of all joints in the frames of the chosen range: root mean square, "
         "95th percentile and largest. A double click on the ruler chooses the "
         "whole clip again."));
  row->addWidget(range_);
  eps_ = add(row, tr("eps_x"),
             tr("Root mean square distance between original and compressed, weighted by bone "
                "length: the paper's distortion."));
  p95_ = add(row, tr("p95"), tr("95 % of all points at all frames have a smaller error."));
  p99_ = add(row, tr("p99"), tr("99 % of all points at all frames have a smaller error."));
  max_ = add(row, tr("max"), tr("Largest error of any point at any frame."));
  footskate_ = add(row, tr("foot drift"),
                   tr("Largest distance between a standing foot and its place in the original."));
  size_ =
      add(row, tr("motion"), tr("Compressed motion bytes; the skeleton in the file takes more."));
  ratio_ = add(row, tr("ratio"),
               tr("Bytes of the channels as 32-bit floats, divided by the compressed motion bytes, "
                  "as in the paper."));
  bits_ = add(row, tr("bits per joint-sample"),
              tr("Motion bits for one joint at one frame; unlike a ratio it needs no baseline."));
  row->addStretch(1);
  setFigures({});
  setRange({});
}

FiguresBar::Figure FiguresBar::add(QHBoxLayout* row, const QString& name,
                                   const QString& explanation) {
  if (row->count() > 0) row->addSpacing(14);
  Figure figure{new QLabel(name, this), new QLabel(this)};
  figure.caption->setForegroundRole(QPalette::PlaceholderText);
  QFont bold = figure.value->font();
  bold.setWeight(QFont::DemiBold);
  figure.value->setFont(bold);
  figure.value->setAccessibleName(name);
  for (QLabel* label : {figure.caption, figure.value}) {
    label->setToolTip(explanation);
    row->addWidget(label);
  }
  return figure;
}

void FiguresBar::setRange(const QString& errors) {
  range_->setText(errors);
  range_->setVisible(!errors.isEmpty());
  for (const Figure& figure : {eps_, p95_, p99_, max_})
    for (QLabel* label : {figure.caption, figure.value}) label->setVisible(errors.isEmpty());
}

void FiguresBar::setFigures(const std::optional<ResultFigures>& figures) {
  const ResultFigures known = figures.value_or(ResultFigures());
  const auto show = [&](const Figure& figure, const QString& text) {
    figure.value->setText(figures ? text : kUnknown);
  };
  eps_.caption->setText(figures ? tr("eps_x, %1").arg(displayName(known.weighting).toLower())
                                : tr("eps_x"));
  show(eps_, distance(known.eps_cm));
  show(p95_, distance(known.p95_cm));
  show(p99_, distance(known.p99_cm));
  show(max_, distance(known.max_cm));
  show(footskate_,
       distance(known.slide ? std::optional(known.slide->drift_worst_cm) : std::nullopt));
  const auto maybe_about = [&](const QString& text) {
    return known.size_is_estimated ? tr("≈ %1").arg(text) : text;
  };
  show(size_, maybe_about(sizeText(static_cast<double>(known.motion_bytes))));
  show(ratio_, maybe_about(ratioText(known.ratio)));
  show(bits_, maybe_about(shownShort(known.bits_per_joint_sample)));
  layout()->activate();  // lays out now: the next repaint would cut longer numbers off
}

}  // namespace mocapress
