// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <map>

#include "widgets/models/batch_queue_model.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace mocapress {

/// Edits the output of a batch: folder, file names and formats.
class BatchOutput : public QWidget {
  Q_OBJECT

 public:
  explicit BatchOutput(QWidget* parent = nullptr);

  /// Emits nothing.
  void setSettings(const BatchSettings& settings);

  /// Shows an example of the file names, made from a clip of the queue. If `wrong`, the text is an
  /// error in the pattern of the names.
  void setExample(const QString& example, bool wrong);

  QPushButton* folder() const { return folder_; }
  QLineEdit* names() const { return names_; }
  QCheckBox* format(OutputFormat format) const { return formats_.at(format); }
  QComboBox* bank() const { return bank_; }
  QCheckBox* learn() const { return learn_; }
  QCheckBox* overwrite() const { return overwrite_; }

 signals:
  void settingsChanged(const BatchSettings& settings);
  void folderRequested();

 private:
  void change();

  BatchSettings settings_;
  QPushButton* folder_;
  QLineEdit* names_;
  QLabel* example_;
  std::map<OutputFormat, QCheckBox*> formats_;
  QComboBox* bank_;
  QCheckBox* learn_;
  QCheckBox* overwrite_;
};

}  // namespace mocapress
