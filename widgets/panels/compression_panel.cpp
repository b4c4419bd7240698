// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/compression_panel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QVBoxLayout>

#include "widgets/panels/correction_control.h"
#include "widgets/panels/names.h"
#include "widgets/panels/target_control.h"

namespace mocapress {
namespace {

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
      target_(new TargetControl(this)),
      correction_(new CorrectionControl(this)),
      method_(new QComboBox(this)),
      weighting_(new QComboBox(this)),
      coding_(new QComboBox(this)) {
  addChoices(method_, {Method::Annealed, Method::Standard, Method::PerChannel, Method::ClosedLoop});
  method_->setAccessibleName(tr("Method"));
  method_->setToolTip(tr(
      "Which wavelet coefficients are kept: annealed moves them to the channels where they lower "
      "the error in the world most, standard keeps the largest of all, per channel keeps as many "
      "of each."));
  addChoices(weighting_, {Weighting::BoneEnds, Weighting::JointOrigins});
  weighting_->setAccessibleName(tr("Weighting"));
  weighting_->setToolTip(
      tr("Which points the error eps_x counts, each by bone length: the far end of every bone, or "
         "joint origins as in the paper."));
  addChoices(coding_, {Coding::Deflate, Coding::Rle16, Coding::Adaptive});
  coding_->setAccessibleName(tr("Coding"));
  coding_->setToolTip(
      tr("How kept coefficients become bytes: 16-bit words with runs of zeros, optionally packed "
         "further by DEFLATE."));

  auto* form = new QFormLayout;
  form->setHorizontalSpacing(12);
  form->setVerticalSpacing(6);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("Method"), method_);
  form->addRow(tr("Weighting"), weighting_);
  form->addRow(tr("Coding"), coding_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(10);
  column->addWidget(target_);
  column->addWidget(correction_);
  column->addLayout(form);

  connect(target_, &TargetControl::targetChanged, this, [this](const Target& target) {
    options_.target = target;
    emit optionsChanged(options_);
  });
  connect(correction_, &CorrectionControl::correctionChanged, this,
          [this](const std::optional<CorrectionOptions>& correction) {
            options_.correction = correction;
            emit optionsChanged(options_);
          });
  const auto combo_chosen = [this] {
    options_.method = chosen<Method>(method_);
    options_.weighting = chosen<Weighting>(weighting_);
    options_.coding = chosen<Coding>(coding_);
    emit optionsChanged(options_);
  };
  connect(method_, &QComboBox::activated, this, [this, combo_chosen] {
    options_.basis = Basis::Cubic;  // no longer that of a study's Haar or linear wavelets
    combo_chosen();
  });
  for (QComboBox* box : {weighting_, coding_})
    connect(box, &QComboBox::activated, this, combo_chosen);
  setOptions({});
}

void CompressionPanel::setOptions(const EncodeOptions& options) {
  options_ = options;
  target_->setTarget(options.target);
  correction_->setCorrection(options.correction);
  choose(method_, options.method);
  choose(weighting_, options.weighting);
  choose(coding_, options.coding);
}

void CompressionPanel::setSkeleton(const Skeleton& skeleton) {
  correction_->setSkeleton(skeleton);
}

}  // namespace mocapress
