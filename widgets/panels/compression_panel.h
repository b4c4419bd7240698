// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/codec/encoder.h"

class QComboBox;

namespace mocapress {

class CorrectionControl;
class TargetControl;

/// The settings of the compression. Shows what it is told, and tells what the user chose.
class CompressionPanel : public QWidget {
  Q_OBJECT

 public:
  explicit CompressionPanel(QWidget* parent = nullptr);

  /// Emits nothing.
  void setOptions(const EncodeOptions& options);

  /// The joints that can be held.
  void setSkeleton(const Skeleton& skeleton);

  TargetControl* target() const { return target_; }
  CorrectionControl* correction() const { return correction_; }

 signals:
  void optionsChanged(const EncodeOptions& options);

 private:
  EncodeOptions options_;
  TargetControl* target_;
  CorrectionControl* correction_;
  QComboBox* method_;
  QComboBox* weighting_;
  QComboBox* coding_;
};

}  // namespace mocapress
