// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/compression_panel.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/models/display_names.h"
#include "widgets/panels/correction_control.h"
#include "widgets/panels/preset_chooser.h"
#include "widgets/panels/target_control.h"

namespace mocapress {
namespace {

constexpr int kImportanceWidth = 200;  // width of the text on the button

template <typename Value>
void addChoices(QComboBox* box, std::initializer_list<Value> values) {
  for (const Value value : values) box->addItem(displayName(value), static_cast<int>(value));
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
}

template <typename Value>
void choose(QComboBox* box, Value value) {
  box->setCurrentIndex(box->findData(static_cast<int>(value)));
}

template <typename Value>
Value chosen(const QComboBox* box) {
  return static_cast<Value>(box->currentData().toInt());
}

}  // namespace

CompressionPanel::CompressionPanel(QWidget* parent)
    : QWidget(parent),
      presets_(new PresetChooser(this)),
      target_(new TargetControl(this)),
      track_error_(new QDoubleSpinBox(this)),
      tracks_(makeTracks()),
      correction_(new CorrectionControl(this)),
      method_(new QComboBox(this)),
      effort_(new QComboBox(this)),
      ends_(new QComboBox(this)),
      importance_(new QToolButton(this)),
      weighting_(new QComboBox(this)),
      distance_(new QDoubleSpinBox(this)),
      coding_(new QComboBox(this)) {
  makeChoices();
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(12);
  form->setVerticalSpacing(6);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("Method"), method_);
  form->addRow(tr("Effort"), effort_);
  form->addRow(tr("Importance"), importance_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(10);
  column->addWidget(presets_);
  column->addWidget(target_);
  column->addWidget(tracks_);
  column->addWidget(correction_);
  column->addLayout(form);
  column->addWidget(makeDrawer());

  connect(target_, &TargetControl::targetChanged, this, [this](const Target& target) {
    options_.target = target;
    emit optionsChanged(options_);
  });
  connect(correction_, &CorrectionControl::correctionChanged, this,
          [this](const std::optional<EncodeCorrection>& correction) {
            options_.correction = correction;
            emit optionsChanged(options_);
          });
  const auto chosen_in = [this](QComboBox* box, auto EncodeSettings::*member) {
    connect(box, &QComboBox::activated, this, [this, box, member] {
      using Value = std::remove_reference_t<decltype(options_.*member)>;
      options_.*member = chosen<Value>(box);
      if (box == method_) options_.basis = Basis::Cubic;  // a study may have set another
      showWhatApplies();
      emit optionsChanged(options_);
    });
  };
  chosen_in(method_, &EncodeSettings::method);
  chosen_in(effort_, &EncodeSettings::effort);
  chosen_in(ends_, &EncodeSettings::ends);
  chosen_in(weighting_, &EncodeSettings::weighting);
  chosen_in(coding_, &EncodeSettings::coding);
  connect(distance_, &QDoubleSpinBox::valueChanged, this, [this](double metres) {
    options_.limits.distance_m = metres;
    emit optionsChanged(options_);
  });
  connect(track_error_, &QDoubleSpinBox::valueChanged, this, &CompressionPanel::trackErrorChanged);
  connect(importance_, &QToolButton::clicked, this, &CompressionPanel::importanceRequested);
  setOptions({});
}

/// Makes the control for scalar tracks, whose errors the target does not cover.
QWidget* CompressionPanel::makeTracks() {
  auto* tracks = new QWidget(this);
  track_error_->setAlignment(Qt::AlignRight);
  track_error_->setDecimals(4);
  track_error_->setRange(1e-4, 1e6);
  track_error_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  track_error_->setKeyboardTracking(false);
  track_error_->setAccessibleName(tr("Tracks within"));
  track_error_->setToolTip(
      tr("Largest error allowed for values of morph weights and scales, independent of the target "
         "of the motion. Weights range from 0 to 1; switches and constants are kept exactly."));
  auto* label = new QLabel(tr("Tracks within"), tracks);
  label->setBuddy(track_error_);
  auto* row = new QHBoxLayout(tracks);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(12);
  row->addWidget(label);
  row->addWidget(track_error_, 1);
  tracks->hide();
  return tracks;
}

void CompressionPanel::setTrackError(double track_error) {
  const QSignalBlocker silent(track_error_);
  track_error_->setValue(track_error);
}

void CompressionPanel::setHasTracks(bool has_tracks) {
  tracks_->setVisible(has_tracks);
}

/// Makes the drawer of rarely changed settings.
QWidget* CompressionPanel::makeDrawer() {
  auto* drawer = new QWidget(this);
  auto* more = new QToolButton(drawer);
  more->setText(tr("More"));
  more->setToolTip(tr("Rarely changed settings: error weighting, ends of the clip, and coding."));
  more->setCheckable(true);
  more->setAutoRaise(true);
  more->setArrowType(Qt::RightArrow);
  more->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  auto* inside = new QWidget(drawer);
  auto* form = new QFormLayout(inside);
  form->setContentsMargins(0, 0, 0, 0);
  form->setHorizontalSpacing(12);
  form->setVerticalSpacing(6);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("Weighting"), weighting_);
  form->addRow(tr("Viewing distance"), distance_);
  form->addRow(tr("Ends"), ends_);
  form->addRow(tr("Coding"), coding_);
  inside->setVisible(false);
  connect(more, &QToolButton::toggled, inside, [more, inside](bool open) {
    more->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    inside->setVisible(open);
  });
  auto* column = new QVBoxLayout(drawer);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addWidget(more);
  column->addWidget(inside);
  return drawer;
}

void CompressionPanel::makeChoices() {
  addChoices(method_, {Method::ClosedLoop, Method::Annealed, Method::Standard, Method::PerChannel});
  method_->insertSeparator(1);
  method_->setAccessibleName(tr("Method"));
  method_->setToolTip(
      tr("Closed loop gives by far the smallest files: it rounds every coefficient by its effect "
         "on world-space error. The others are the paper's methods, which choose the coefficients "
         "to keep. Annealed searches for the channels where coefficients lower the error most, "
         "Standard keeps the largest of all channels, Per channel keeps as many in each."));
  addChoices(effort_, {Effort::Default, Effort::Best});
  effort_->setAccessibleName(tr("Effort"));
  addChoices(ends_, {Ends::Free, Ends::Even, Ends::Exact});
  ends_->setAccessibleName(tr("Ends"));
  importance_->setAccessibleName(tr("Importance"));
  importance_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  addChoices(weighting_, kWeightingsWithoutMesh);
  weighting_->setAccessibleName(tr("Weighting"));
  weighting_->setToolTip(
      tr("Points on which the error eps_x is measured. Surface: a body modelled around the bones, "
         "so that turned heads and hands count. Skin: the mesh of the clip or of the character put "
         "on it. Shell: three points 3 cm from every joint, as in ACL. Bone ends and joint "
         "origins: points on "
         "the bones, weighted by bone length; joint origins are the paper's."));
  distance_->setRange(kLeastDistance, kMostDistance);
  distance_->setDecimals(1);
  distance_->setSuffix(tr(" m"));
  distance_->setKeyboardTracking(false);
  distance_->setAccessibleName(tr("Viewing distance"));
  distance_->setToolTip(
      tr("Distance from which the figure is watched. The nearer, the smaller an error that is "
         "noticed."));
  addChoices(coding_, {Coding::Deflate, Coding::Rle16, Coding::Adaptive});
  coding_->setAccessibleName(tr("Coding"));
}

/// Disables the controls that the method ignores, and says why.
void CompressionPanel::showWhatApplies() {
  const bool closed = options_.method == Method::ClosedLoop;
  effort_->setEnabled(closed);
  effort_->setToolTip(
      closed ? tr("Best searches longer for a smaller result: it saves about 1 % and takes some "
                  "three times as long.")
             : tr("Effort applies only to the closed loop; the paper's methods have one result."));
  ends_->setEnabled(closed);
  ends_->setToolTip(
      closed ? tr("Errors of the first and last pose, where clips are blended and looped. Even: no "
                  "larger than the target, and equal at both ends of a loop. Exact: at most a "
                  "tenth of the target, for some 4 % more bytes. Free: no bound.")
             : tr("Only the closed loop corrects the first and last pose."));
  coding_->setEnabled(!closed);
  choose(coding_, effective_coding(options_));
  coding_->setToolTip(
      closed ? tr("The closed loop always uses adaptive coding, whose bytes it counts while it "
                  "searches.")
             : tr("Coding of kept coefficients as bytes: 16-bit words with runs of zeros, with or "
                  "without DEFLATE on top, or an adaptive range coder."));
  const bool heeded = closed || options_.method == Method::Annealed;
  const bool fits = options_.importance.joints.empty() ||
                    std::ssize(options_.importance.joints) == skeleton_.joint_count();
  const QString importance =
      fits ? importanceText(named(options_.importance, skeleton_)) : QString();
  importance_->setText(!heeded                ? tr("Not used")
                       : importance.isEmpty() ? tr("All equal")
                                              : fontMetrics().elidedText(importance, Qt::ElideRight,
                                                                         kImportanceWidth));
  importance_->setToolTip(
      heeded
          ? QStringLiteral("<p>%1</p><p>%2</p>")
                .arg(importance,
                     tr("Give errors of feet, hands, the head, contacts or any joint more weight."))
          : tr("This method ignores importance: choose %1 or %2.")
                .arg(displayName(Method::ClosedLoop), displayName(Method::Annealed)));
  importance_->setEnabled(heeded);
}

void CompressionPanel::setOptions(const EncodeSettings& options) {
  options_ = options;
  const QSignalBlocker silent(distance_);
  distance_->setValue(options.limits.distance_m);
  target_->setTarget(options.target);
  correction_->setCorrection(options.correction);
  choose(method_, options.method);
  choose(effort_, options.effort);
  choose(ends_, options.ends);
  choose(weighting_, options.weighting);
  showWhatApplies();
}

void CompressionPanel::setSkeleton(const Skeleton& skeleton) {
  skeleton_ = skeleton;
  correction_->setSkeleton(skeleton);
  weighting_->clear();
  if (skeleton.skin())
    addChoices(weighting_, kWeightings);
  else
    addChoices(weighting_, kWeightingsWithoutMesh);
  choose(weighting_, options_.weighting);
  showWhatApplies();
}

}  // namespace mocapress
