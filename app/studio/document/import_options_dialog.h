// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <optional>
#include <string>

class QComboBox;
class QDoubleSpinBox;

namespace mocapress {

struct OriginalClip;
struct ReadOptions;

/// What to read a motion as where its file says it wrongly or not at all: unit, up axis, rate, and
/// how a BVH root goes with its OFFSET. Each is as the file says, or as the reader guesses, unless
/// it is chosen.
class ImportOptionsDialog : public QDialog {
  Q_OBJECT

 public:
  /// Begins with what the clip was read by, and shows what that came to.
  explicit ImportOptionsDialog(const OriginalClip& clip, QWidget* parent = nullptr);

  ReadOptions options() const;
  void setOptions(const ReadOptions& options);

 private:
  QComboBox* unit_;
  QDoubleSpinBox* cm_per_unit_;
  QComboBox* up_;
  QComboBox* root_;
  QComboBox* rate_;
  QDoubleSpinBox* rate_hz_;
  std::optional<std::string> take_;  // kept as it is
};

}  // namespace mocapress
