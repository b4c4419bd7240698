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

/// Whether, how finely and where feet or other joints are held by inverse kinematics. Shows what it
/// is told, and tells what the user chose.
class CorrectionControl : public QWidget {
  Q_OBJECT

 public:
  explicit CorrectionControl(QWidget* parent = nullptr);

  /// The joints to choose from.
  void setSkeleton(const Skeleton& skeleton);

  /// Emits nothing.
  void setCorrection(const std::optional<EncodeCorrection>& correction);

  /// The ratio that the encoder chose where that is left to it; unset: not known yet.
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
  double ratio_;  // for when it is no longer found by the encoder
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
