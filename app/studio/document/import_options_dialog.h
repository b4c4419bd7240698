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

/// Asks for properties that a motion's file states wrongly or not at all: unit, up axis, rate, and
/// the use of a BVH root's OFFSET. By default the file's statement or the reader's guess applies.
class ImportOptionsDialog : public QDialog {
  Q_OBJECT

 public:
  /// Starts with the options that the clip was read with, and shows their effect.
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
  std::optional<std::string> take_;  // kept unchanged
};

}  // namespace mocapress
