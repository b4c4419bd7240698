// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/correction_control.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QMenu>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <algorithm>

#include "core/motion/rig.h"
#include "widgets/models/display_names.h"
#include "widgets/models/log_scale.h"
#include "widgets/panels/number_fields.h"

namespace mocapress {
namespace {

constexpr double kFirstRatio = 16;  // as in the paper's video; used when Auto is switched off
constexpr LogScale kScale = {1, 200};
const QString kNotKnownYet = QStringLiteral("–");

}  // namespace

CorrectionControl::CorrectionControl(QWidget* parent)
    : QWidget(parent),
      ratio_(kFirstRatio),
      hold_(new QCheckBox(tr("Hold feet (IK)"), this)),
      found_(new QCheckBox(tr("Auto"), this)),
      value_(new NumberBox(this)),
      slider_(new QSlider(Qt::Horizontal, this)),
      at_(new QComboBox(this)),
      joints_(new QToolButton(this)),
      joint_menu_(new QMenu(this)) {
  hold_->setToolTip(tr(
      "Stores the places of the feet and moves the feet there by inverse kinematics, so that "
      "planted feet do not slide. The bytes of this correction count in the compression ratio."));
  found_->setToolTip(
      tr("Searches for the smallest correction that removes at least nine tenths of the sliding, "
         "or leaves no foot sliding more than a millimetre."));
  value_->setAccessibleName(tr("IK ratio"));
  value_->setToolTip(
      tr("Coefficients of the correction over those kept (r_IK in the paper). Lower values hold "
         "the feet better and take more bytes."));
  value_->setDecimalsShown(1, 3);
  value_->setSuffix(tr(" : 1"));
  slider_->setAccessibleName(tr("IK ratio on a slider"));
  slider_->setToolTip(value_->toolTip());
  slider_->setRange(0, kScale.steps);
  slider_->setPageStep(50);
  at_->setAccessibleName(tr("When feet are held"));
  for (const CorrectAt at : {CorrectAt::EveryFrame, CorrectAt::Contacts})
    at_->addItem(displayName(at), static_cast<int>(at));
  at_->setToolTip(
      tr("Hold the feet at every frame, as in the paper, or only while they stand on the ground, "
         "blended in and out."));
  joints_->setAccessibleName(tr("Held joints"));
  joints_->setMenu(joint_menu_);
  joints_->setPopupMode(QToolButton::InstantPopup);
  joints_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  joints_->setToolTip(tr("Joints to hold; the feet by default."));

  auto* head = new QGridLayout;
  head->setContentsMargins(0, 0, 0, 0);
  head->setVerticalSpacing(4);
  head->addWidget(hold_, 0, 0);
  head->addWidget(found_, 0, 1);
  head->addWidget(value_, 0, 2);
  head->addWidget(slider_, 1, 0, 1, 3);
  head->setColumnStretch(0, 1);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->setHorizontalSpacing(12);
  form->setVerticalSpacing(6);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(head);
  form->addRow(tr("Hold at"), at_);
  form->addRow(tr("Joints"), joints_);

  connect(hold_, &QCheckBox::toggled, this, [this] {
    show();
    tell();
  });
  connect(found_, &QCheckBox::toggled, this, [this](bool found) {
    EncodeCorrection chosen = correction_;
    chosen.ratio = found ? std::nullopt : std::optional(ratio_);
    choose(chosen);
  });
  const auto choose_ratio = [this](double ratio) {
    EncodeCorrection chosen = correction_;
    chosen.ratio = ratio_ = ratio;
    choose(chosen);
  };
  connect(value_, &QDoubleSpinBox::valueChanged, this,
          [=, this](double ratio) { ratio > 0 ? choose_ratio(ratio) : show(); });
  connect(slider_, &QSlider::valueChanged, this,
          [=](int position) { choose_ratio(kScale.chosen(position)); });
  connect(at_, &QComboBox::activated, this, [this] {
    EncodeCorrection chosen = correction_;
    chosen.at = static_cast<CorrectAt>(at_->currentData().toInt());
    choose(chosen);
  });
  show();
}

void CorrectionControl::setSkeleton(const Skeleton& skeleton) {
  joint_menu_->clear();
  joint_menu_->setToolTipsVisible(true);
  const std::size_t shared = shared_namespace(skeleton).size();
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    QAction* action =
        joint_menu_->addAction(QString::fromStdString(skeleton.joint(j).name.substr(shared)));
    action->setToolTip(QString::fromStdString(skeleton.joint(j).name));
    action->setCheckable(true);
    action->setData(j);
    connect(action, &QAction::toggled, this, &CorrectionControl::chooseJoints);
  }
  correction_.joints.clear();  // joint indices of the old skeleton mean nothing here
  show();
}

void CorrectionControl::setCorrection(const std::optional<EncodeCorrection>& correction) {
  const QSignalBlocker blocker(hold_);
  hold_->setChecked(correction.has_value());
  if (correction) correction_ = *correction;
  if (correction_.ratio) ratio_ = *correction_.ratio;
  show();
}

void CorrectionControl::setFound(const std::optional<double>& ratio) {
  found_ratio_ = ratio;
  show();
}

void CorrectionControl::chooseJoints() {
  EncodeCorrection chosen = correction_;
  chosen.joints.clear();
  for (const QAction* action : joint_menu_->actions())
    if (action->isChecked()) chosen.joints.push_back(action->data().toInt());
  choose(chosen);
}

void CorrectionControl::choose(const EncodeCorrection& correction) {
  correction_ = correction;
  show();
  tell();
}

void CorrectionControl::tell() {
  emit correctionChanged(hold_->isChecked() ? std::optional(correction_) : std::nullopt);
}

void CorrectionControl::show() {
  const QSignalBlocker block_found(found_);
  const QSignalBlocker block_value(value_);
  const QSignalBlocker block_slider(slider_);
  const bool held = hold_->isChecked();
  found_->setChecked(!correction_.ratio);
  const bool unknown = !correction_.ratio && !found_ratio_;
  const double ratio = correction_.ratio || unknown ? ratio_ : *found_ratio_;
  value_->setSpecialValueText(unknown ? kNotKnownYet : QString());
  value_->setValue(unknown ? 0 : ratio);
  slider_->setValue(kScale.position(ratio, slider_->value()));
  at_->setCurrentIndex(at_->findData(static_cast<int>(correction_.at)));
  QStringList names;
  for (QAction* action : joint_menu_->actions()) {
    const QSignalBlocker block_action(action);
    const auto& chosen = correction_.joints;
    action->setChecked(std::count(chosen.begin(), chosen.end(), action->data().toInt()) > 0);
    if (action->isChecked()) names << action->text();
  }
  joints_->setText(names.isEmpty() ? tr("Feet")
                   : names.size() <= 2
                       ? names.join(QStringLiteral(", "))
                       : tr("%Ln joint(s)", nullptr, static_cast<int>(names.size())));
  for (QWidget* widget :
       {static_cast<QWidget*>(found_), static_cast<QWidget*>(at_), static_cast<QWidget*>(joints_)})
    widget->setEnabled(held);
  value_->setEnabled(held && correction_.ratio);
  slider_->setEnabled(held && correction_.ratio);
}

}  // namespace mocapress
