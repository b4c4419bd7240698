// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/result_panel.h"

#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QSettings>
#include <QToolButton>
#include <QVBoxLayout>
#include <QtMath>

#include "widgets/models/display_names.h"
#include "widgets/models/library_model.h"
#include "widgets/models/number_text.h"

namespace mocapress {
namespace {

const QString kUnknown = QStringLiteral("–");
constexpr double kHeadlineScale = 1.9;
constexpr double kVerdictScale = 1.5;
const QString kUnfolded = QStringLiteral("window/all-figures");

QString distance(const std::optional<double>& cm) {
  return cm ? lengthText(*cm) : kUnknown;
}

QString bytes(std::size_t count) {
  return sizeText(static_cast<double>(count));
}

QString correctionText(const ResultFigures& figures) {
  if (!figures.correction_bytes) return kUnknown;
  const QString size = bytes(*figures.correction_bytes);
  return figures.correction_ratio
             ? ResultPanel::tr("%1, %2").arg(size, ratioText(*figures.correction_ratio))
             : size;
}

QString kneeText(const ResultFigures& figures) {
  if (!figures.fastest_knee || !figures.fastest_knee_of_original) return kUnknown;
  return ResultPanel::tr("%L1 / %L2 °/s")
      .arg(qRadiansToDegrees(*figures.fastest_knee), 0, 'f', 0)
      .arg(qRadiansToDegrees(*figures.fastest_knee_of_original), 0, 'f', 0);
}

QString seenExplanation() {
  return ResultPanel::tr("The most visible error, beside the size that people notice.");
}

/// Describes the most visible error, its time, and the distance beyond which it is not noticed.
QString reasonText(const SeenFigures& seen) {
  return ResultPanel::tr(
             "%1, %2 at %L3 s: %L4 times the noticeable error; not noticed beyond %L5 m")
      .arg(displayName(seen.cue), seen.joint)
      .arg(seen.seconds, 0, 'f', 2)
      .arg(shownShort(seen.times_noticed))
      .arg(seen.unnoticed_from_m, 0, 'g', 2);
}

}  // namespace

ResultPanel::ResultPanel(QWidget* parent)
    : QWidget(parent), seen_(new QLabel(this)), reason_(new QLabel(this)) {
  QFont font = seen_->font();
  font.setPointSizeF(kVerdictScale * font.pointSizeF());
  font.setWeight(QFont::DemiBold);
  seen_->setFont(font);
  seen_->setAccessibleName(tr("Visibility"));
  seen_->setToolTip(seenExplanation());
  reason_->setWordWrap(true);
  reason_->setAccessibleName(tr("Most visible error"));
  reason_->setToolTip(seenExplanation());

  auto* head = new QGridLayout;
  head->setHorizontalSpacing(12);
  head->setVerticalSpacing(3);
  head->setColumnStretch(0, 1);
  head->setColumnStretch(1, 1);
  ratio_ = addHeadline(head, tr("compression ratio"),
                       tr("Bytes of the channels as 32-bit floats, divided by the compressed "
                          "motion bytes. The skeleton counts in neither, as in the paper."),
                       0);
  eps_ = addHeadline(head, tr("eps_x"),
                     tr("Root mean square distance between original and compressed, weighted by "
                        "bone length."),
                     1);
  eps_name_ = qobject_cast<QLabel*>(head->itemAtPosition(1, 1)->widget());
  state_ = new QLabel(this);
  state_->setWordWrap(true);
  state_->setForegroundRole(QPalette::PlaceholderText);
  state_->setAccessibleName(tr("State of the result"));
  head->addWidget(state_, 2, 0, 1, 2);

  QWidget* details = makeDetails();
  auto* unfold = new QToolButton(this);
  unfold->setText(tr("All figures"));
  unfold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  unfold->setAutoRaise(true);
  unfold->setCheckable(true);
  const auto show = [unfold, details](bool shown) {
    unfold->setArrowType(shown ? Qt::DownArrow : Qt::RightArrow);
    details->setVisible(shown);
  };
  connect(unfold, &QToolButton::toggled, this, show);
  connect(unfold, &QToolButton::clicked, this,
          [](bool shown) { QSettings().setValue(kUnfolded, shown); });
  unfold->setChecked(QSettings().value(kUnfolded, false).toBool());
  show(unfold->isChecked());

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addWidget(seen_);
  column->addWidget(reason_);
  column->addLayout(head);
  column->addWidget(unfold, 0, Qt::AlignLeft);
  column->addWidget(details);
  setFigures({});
}

QWidget* ResultPanel::makeDetails() {
  auto* details = new QWidget(this);
  grid_ = new QGridLayout(details);
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(12);
  grid_->setVerticalSpacing(3);
  grid_->setColumnStretch(0, 1);
  grid_->setColumnStretch(1, 1);
  p95_ = addRow(tr("95 % of points within"),
                tr("95th percentile of the distance over all joints and frames, unweighted."));
  p99_ = addRow(tr("99 % of points within"),
                tr("99th percentile of the distance over all joints and frames, unweighted."));
  max_ = addRow(tr("Worst point"), tr("Largest error of any point at any frame."));
  skin_ = addRow(tr("On the skin: worst / RMS"),
                 tr("Errors of points spread evenly over the mesh, over all frames."));
  slide_ = addRow(
      tr("Foot drift: mean / worst"),
      tr("Distance between a standing foot and its place in the original, over all contacts."));
  footskate_ = addRow(
      tr("Foot path: all / worst"),
      tr("Path of the feet over the ground while they stand, beyond the original's: sum over the "
         "clip, and worst contact. A foot that trembles in place has a long path."));
  ends_ = addRow({}, {});
  elsewhere_ =
      addRow(tr("Loop: elsewhere"), tr("The largest change of errors between two neighbouring "
                                       "frames. A smaller one at the seam does not stand out."));
  bytes_ = addRow(tr("Motion / file"),
                  tr("Compressed motion bytes, and bytes of the whole file with its skeleton."));
  coefficient_ratio_ =
      addRow(tr("Coefficient ratio"),
             tr("The paper's r: all wavelet coefficients over those that are kept."));
  bits_ =
      addRow(tr("Bits per joint-sample"),
             tr("Motion bits for one joint at one frame; unlike a ratio it needs no baseline."));
  correction_ =
      addRow(tr("IK signals"),
             tr("Motion bytes of the correction that holds the feet, and its ratio r_IK."));
  knee_ = addRow(tr("Fastest knee"),
                 tr("Highest speed of a held leg's knee, and that of the original. A much higher "
                    "speed means that the correction makes the knee snap."));
  return details;
}

QLabel* ResultPanel::addHeadline(QGridLayout* head, const QString& name, const QString& explanation,
                                 int column) {
  auto* value = new QLabel(this);
  QFont font = value->font();
  font.setPointSizeF(kHeadlineScale * font.pointSizeF());
  font.setWeight(QFont::DemiBold);
  value->setFont(font);
  value->setToolTip(explanation);
  value->setAccessibleName(name);
  auto* caption = new QLabel(name, this);
  caption->setToolTip(explanation);
  caption->setBuddy(value);
  head->addWidget(value, 0, column);
  head->addWidget(caption, 1, column);
  return value;
}

QLabel* ResultPanel::addRow(const QString& name, const QString& explanation) {
  const int row = grid_->rowCount();
  auto* caption = new QLabel(name, this);
  caption->setToolTip(explanation);
  auto* value = new QLabel(this);
  value->setToolTip(explanation);
  value->setAccessibleName(name);
  value->setAlignment(Qt::AlignRight);
  value->setTextInteractionFlags(Qt::TextSelectableByMouse);
  grid_->addWidget(caption, row, 0);
  grid_->addWidget(value, row, 1);
  return value;
}

void ResultPanel::setFigures(const std::optional<ResultFigures>& figures) {
  setEnabled(figures.has_value());
  if (!figures) {
    eps_name_->setText(tr("eps_x"));
    setEnds({});
    setSeen({});
    for (QLabel* label : {nameOf(skin_), skin_}) label->hide();
    for (QLabel* label : {ratio_, eps_, bytes_, p95_, p99_, max_, coefficient_ratio_, bits_,
                          footskate_, slide_, correction_, knee_})
      label->setText(kUnknown);
    return;
  }
  const auto maybe_about = [&](const QString& text) {
    return figures->size_is_estimated ? tr("≈ %1").arg(text) : text;
  };
  ratio_->setText(maybe_about(ratioText(figures->ratio)));
  eps_->setText(distance(figures->eps_cm));
  eps_name_->setText(tr("eps_x, %1").arg(displayName(figures->weighting).toLower()));
  setEnds(*figures);
  bytes_->setText(
      figures->size_is_estimated
          ? maybe_about(bytes(figures->motion_bytes))
          : tr("%1 / %2", "bytes").arg(bytes(figures->motion_bytes), bytes(figures->file_bytes)));
  p95_->setText(distance(figures->p95_cm));
  p99_->setText(distance(figures->p99_cm));
  max_->setText(distance(figures->max_cm));
  if (figures->skin)
    skin_->setText(tr("%1 / %2", "skin")
                       .arg(lengthText(figures->skin->max.cm), lengthText(figures->skin->rms)));
  for (QLabel* label : {nameOf(skin_), skin_}) label->setVisible(figures->skin.has_value());
  setSeen(figures->seen);
  coefficient_ratio_->setText(figures->coefficient_ratio ? ratioText(*figures->coefficient_ratio)
                                                         : kUnknown);
  bits_->setText(maybe_about(shownShort(figures->bits_per_joint_sample)));
  const auto pair = [](const QString& a, const QString& b) {
    return tr("%1 / %2", "footskate").arg(a, b);
  };
  const auto& slide = figures->slide;
  slide_->setText(slide ? pair(lengthText(slide->drift_mean_cm), lengthText(slide->drift_worst_cm))
                        : kUnknown);
  footskate_->setText(slide && figures->footskate_cm
                          ? pair(surplusText(*figures->footskate_cm), surplusText(slide->worst_cm))
                          : distance(figures->footskate_cm));
  correction_->setText(correctionText(*figures));
  knee_->setText(kneeText(*figures));
  // Lays out now: the next repaint would cut longer numbers off.
  for (QLayout* each : {static_cast<QLayout*>(grid_), layout()}) each->activate();
}

/// Shows the verdict on visibility, in the colour that library rows give to it, and the reason.
void ResultPanel::setSeen(const std::optional<SeenFigures>& seen) {
  seen_->setText(seen ? sightText(seen->sight, seen->distance_m) : kUnknown);
  reason_->setText(seen ? reasonText(*seen) : QString());
  for (QLabel* label : {seen_, reason_}) label->setVisible(seen.has_value());
  QPalette coloured = palette();
  if (seen && seen->sight != Sight::NotVisible)
    coloured.setColor(
        QPalette::WindowText,
        colourOf(seen->sight == Sight::Visible ? RowState::Bad : RowState::Doubtful, palette()));
  seen_->setPalette(coloured);
}

QLabel* ResultPanel::nameOf(QLabel* value) const {
  int row = 0, column = 0, rows = 0, columns = 0;
  grid_->getItemPosition(grid_->indexOf(value), &row, &column, &rows, &columns);
  return qobject_cast<QLabel*>(grid_->itemAtPosition(row, 0)->widget());
}

/// Shows the errors at both ends of a clip, or at the seam of a loop.
void ResultPanel::setEnds(const ResultFigures& figures) {
  const bool is_loop = figures.ends && figures.is_loop;
  const auto change = [](double cm, double cm_per_frame) {
    return tr("%1, %2/frame").arg(lengthText(cm), lengthText(cm_per_frame));
  };
  const EndErrors ends = figures.ends.value_or(EndErrors());
  const QString name = is_loop ? tr("Loop: seam") : tr("First / last pose");
  const QString explanation = is_loop
                                  ? tr("Change of the errors of pose and velocity from the last "
                                       "frame to the first: the jump where the loop starts again.")
                                  : tr("RMS error of the first and the last pose on the body's "
                                       "surface. Clips are blended there.");
  nameOf(ends_)->setText(name);
  ends_->setAccessibleName(name);
  for (QLabel* label : {nameOf(ends_), ends_}) label->setToolTip(explanation);
  ends_->setText(
      !figures.ends ? kUnknown
      : is_loop     ? change(ends.seam_cm, ends.seam_cm_per_frame)
                : tr("%1 / %2", "poses").arg(lengthText(ends.first_cm), lengthText(ends.last_cm)));
  elsewhere_->setText(change(ends.worst_neighbours_cm, ends.worst_neighbours_cm_per_frame));
  for (QLabel* label : {nameOf(elsewhere_), elsewhere_}) label->setVisible(is_loop);
}

void ResultPanel::setState(const QString& state) {
  state_->setText(state);
}

}  // namespace mocapress
