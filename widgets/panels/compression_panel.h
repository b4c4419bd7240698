// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/codec/encode/encoder.h"

class QComboBox;
class QDoubleSpinBox;
class QToolButton;

namespace mocapress {

class CorrectionControl;
class PresetChooser;
class TargetControl;

/// Edits the settings of the compression: shows what is set and reports what the user chooses.
class CompressionPanel : public QWidget {
  Q_OBJECT

 public:
  explicit CompressionPanel(QWidget* parent = nullptr);

  /// Emits nothing.
  void setOptions(const EncodeSettings& options);

  /// Sets the skeleton whose joints can be held in place.
  void setSkeleton(const Skeleton& skeleton);

  /// Sets the largest error of a scalar track's values. Emits nothing.
  void setTrackError(double track_error);

  /// Tells whether the clip has scalar tracks. Without them, their setting is hidden.
  void setHasTracks(bool has_tracks);

  PresetChooser* presets() const { return presets_; }
  TargetControl* target() const { return target_; }
  CorrectionControl* correction() const { return correction_; }
  QComboBox* method() const { return method_; }
  QComboBox* effort() const { return effort_; }
  QComboBox* ends() const { return ends_; }
  QComboBox* coding() const { return coding_; }
  QToolButton* importance() const { return importance_; }
  QDoubleSpinBox* trackError() const { return track_error_; }

 signals:
  void optionsChanged(const EncodeSettings& options);
  void trackErrorChanged(double track_error);

  /// The user wants to edit the importances.
  void importanceRequested();

 private:
  void makeChoices();
  QWidget* makeTracks();
  QWidget* makeDrawer();
  void showWhatApplies();

  EncodeSettings options_;
  Skeleton skeleton_;
  PresetChooser* presets_;
  TargetControl* target_;
  QDoubleSpinBox* track_error_;
  QWidget* tracks_;
  CorrectionControl* correction_;
  QComboBox* method_;
  QComboBox* effort_;
  QComboBox* ends_;
  QToolButton* importance_;
  QComboBox* weighting_;
  QDoubleSpinBox* distance_;
  QComboBox* coding_;
};

}  // namespace mocapress
