// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "core/codec/encode/mend/correction_encoder.h"

class QCheckBox;
class QComboBox;
class QMenu;
class QSlider;
class QToolButton;

namespace mocapress {

class NumberBox;

/// Edits the IK correction: on or off, its ratio, and the joints that it holds in place. Shows what
/// is set and reports what the user chooses.
class CorrectionControl : public QWidget {
  Q_OBJECT

 public:
  explicit CorrectionControl(QWidget* parent = nullptr);

  /// Sets the joints to choose from.
  void setSkeleton(const Skeleton& skeleton);

  /// Emits nothing.
  void setCorrection(const std::optional<EncodeCorrection>& correction);

  /// Sets the ratio that the encoder found for Auto; unset: not known yet.
  void setFound(const std::optional<double>& ratio);

  QCheckBox* hold() const { return hold_; }
  QCheckBox* found() const { return found_; }
  NumberBox* number() const { return value_; }
  QSlider* slider() const { return slider_; }

 signals:
  void correctionChanged(const std::optional<EncodeCorrection>& correction);

 private:
  void choose(const EncodeCorrection& correction);
  void chooseJoints();
  void show();
  void tell();

  EncodeCorrection correction_;
  double ratio_;  // used when Auto is switched off
  std::optional<double> found_ratio_;
  QCheckBox* hold_;
  QCheckBox* found_;
  NumberBox* value_;
  QSlider* slider_;
  QComboBox* at_;
  QToolButton* joints_;
  QMenu* joint_menu_;
};

}  // namespace mocapress
