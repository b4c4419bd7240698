// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/preset_editor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QScopedValueRollback>
#include <QVBoxLayout>

#include "core/codec/methods/comparison_method.h"
#include "core/codec/methods/compression_method.h"
#include "widgets/models/display_names.h"
#include "widgets/panels/preset_chooser.h"

namespace mocapress {
PresetEditor::PresetEditor(QWidget* parent)
    : QWidget(parent),
      chooser_(new PresetChooser(this)),
      purpose_(new QLabel(this)),
      kind_(new QComboBox(this)),
      value_(new QDoubleSpinBox(this)),
      method_(new QComboBox(this)),
      weighting_(new QComboBox(this)),
      hold_feet_(new QCheckBox(tr("Hold feet by inverse kinematics"), this)) {
  purpose_->setWordWrap(true);
  purpose_->setForegroundRole(QPalette::PlaceholderText);
  addRows();
  connect(chooser_, &PresetChooser::chosen, this, [this](const Settings& preset) {
    setPreset(preset);
    emit presetChanged(preset);
  });
  connect(kind_, &QComboBox::activated, this, [this] {
    showKind();
    change();
  });
  connect(value_, &QDoubleSpinBox::valueChanged, this, &PresetEditor::change);
  connect(method_, &QComboBox::activated, this, &PresetEditor::change);
  connect(weighting_, &QComboBox::activated, this, &PresetEditor::change);
  connect(hold_feet_, &QCheckBox::clicked, this, &PresetEditor::change);
  setPresets({built_in_presets().begin(), built_in_presets().end()});
  setPreset(built_in_presets().front());
}

void PresetEditor::addRows() {
  kind_->setAccessibleName(tr("Kind of target"));
  kind_->addItem(tr("Error, eps_x"), static_cast<int>(Target::Kind::Error));
  kind_->addItem(tr("Hard maximum"), static_cast<int>(Target::Kind::MaxError));
  kind_->addItem(tr("Visibility"), static_cast<int>(Target::Kind::Visibility));
  kind_->addItem(tr("Ratio"), static_cast<int>(Target::Kind::Ratio));
  kind_->addItem(tr("Bytes"), static_cast<int>(Target::Kind::Size));
  kind_->addItem(tr("Coefficient ratio"), static_cast<int>(Target::Kind::CoefficientRatio));
  kind_->setToolTip(
      tr("Error, eps_x: the weighted root mean square error; single frames may exceed it. Hard "
         "maximum: largest error of any point of the body at any frame. Visibility: largest error "
         "as a multiple of what people notice; at 1, no error is visible. Quality targets suit all "
         "kinds of clips; ratio and bytes ignore how hard a clip is to compress."));
  value_->setAccessibleName(tr("Value of the target"));
  value_->setKeyboardTracking(false);
  value_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  method_->setAccessibleName(tr("Method"));
  for (const CompressionMethod& compression_method : compression_methods()) {
    method_->addItem(methodTitle(compression_method.name),
                     QString::fromUtf8(compression_method.name));
    method_->setItemData(
        method_->count() - 1,
        QStringLiteral("<p>%1</p>").arg(QString::fromUtf8(compression_method.note).toHtmlEscaped()),
        Qt::ToolTipRole);
  }
  method_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  method_->setMinimumContentsLength(12);
  weighting_->setAccessibleName(tr("Weighting"));
  weighting_->setToolTip(tr(
      "Points on which the error eps_x is measured. Surface: a body modelled around the bones, so "
      "that turned heads and hands count. Skin: the mesh of the clip or of the batch's character; "
      "clips without a mesh are refused. Shell: three points 3 cm from every joint, as in ACL. "
      "Bone ends and joint "
      "origins: points on the bones, weighted by bone length; joint origins are the paper's."));
  for (const Weighting weighting : kWeightings)
    weighting_->addItem(displayName(weighting), static_cast<int>(weighting));
  hold_feet_->setToolTip(tr("Keeps standing feet in place, for some more bytes."));

  auto* target = new QHBoxLayout;
  target->addWidget(kind_);
  target->addWidget(value_, 1);
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(10);
  form->setVerticalSpacing(6);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("Target"), target);
  form->addRow(tr("Weighting"), weighting_);
  form->addRow(tr("Method"), method_);
  form->addRow(QString(), hold_feet_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  column->addWidget(chooser_);
  column->addWidget(purpose_);
  column->addLayout(form);
}

void PresetEditor::setPresets(const std::vector<Settings>& presets) {
  chooser_->setPresets(presets);
  setPreset(Settings(preset_));
}

void PresetEditor::setPreset(const Settings& preset) {
  const QScopedValueRollback filling(filling_, true);
  preset_ = preset;
  chooser_->setPreset(preset);
  const bool purpose = chooser_->isPure() && !purposeOf(preset).isEmpty();
  purpose_->setText(purpose ? purposeOf(preset) : detailsOf(preset));
  purpose_->setVisible(!purpose_->text().isEmpty());
  kind_->setCurrentIndex(kind_->findData(static_cast<int>(preset.target.kind)));
  showKind();
  value_->setValue(preset.target.value);
  method_->setCurrentIndex(method_->findData(QString::fromStdString(preset.method)));
  weighting_->setCurrentIndex(weighting_->findData(static_cast<int>(preset.weighting)));
  hold_feet_->setChecked(preset.correction.has_value());
  hold_feet_->setEnabled(!find_comparison_method(preset.method));
}

/// Sets the range, decimals and unit that suit the kind of target, and a usual value if the kind is
/// new.
void PresetEditor::showKind() {
  struct Scale {
    double least, most, usual;
    int decimals;
    QString unit;
  };
  const auto kind = static_cast<Target::Kind>(kind_->currentData().toInt());
  const auto scale = [&]() -> Scale {
    switch (kind) {
      case Target::Kind::Ratio:
      case Target::Kind::CoefficientRatio:
        return {1, 5000, 30, 1, tr(":1")};
      case Target::Kind::Size:
        return {64, 1e9, 20000, 0, tr(" bytes")};
      case Target::Kind::MaxError:
        return {0.001, 100, 1, 3, tr(" cm")};
      case Target::Kind::Visibility:
        return {0.01, 100, 1, 2, tr(" times")};
      default:
        return {0.001, 100, 0.5, 3, tr(" cm")};
    }
  }();
  const QScopedValueRollback filling(filling_, true);
  value_->setRange(scale.least, scale.most);
  value_->setDecimals(scale.decimals);
  value_->setSuffix(scale.unit);
  if (kind != preset_.target.kind) value_->setValue(scale.usual);
}

void PresetEditor::change() {
  if (filling_) return;
  Settings changed = preset_;
  changed.target = {static_cast<Target::Kind>(kind_->currentData().toInt()), value_->value()};
  changed.weighting = static_cast<Weighting>(weighting_->currentData().toInt());
  const std::string method = method_->currentData().toString().toStdString();
  if (method != changed.method) changed.coding.reset();
  changed.method = method;
  const bool of_wavelets = !find_comparison_method(method);
  if (!hold_feet_->isChecked() || !of_wavelets)
    changed.correction.reset();
  else if (!changed.correction)
    changed.correction = CorrectionSettings{};
  if (changed == preset_) return;
  setPreset(changed);
  emit presetChanged(changed);
}

}  // namespace mocapress
