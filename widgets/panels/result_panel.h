// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <cstddef>
#include <optional>

#include "core/feet/footskate.h"
#include "core/metrics/distortion.h"
#include "core/metrics/end_errors.h"
#include "core/metrics/visibility.h"
#include "core/motion/landmarks.h"

class QGridLayout;
class QLabel;

namespace mocapress {

/// What the eye sees, and where it sees it most.
struct SeenFigures {
  Sight sight = Sight::NotVisible;
  Cue cue = Cue::Velocity;
  QString joint;
  double seconds = 0;
  double times_noticed = 0;
};

/// The figures of one compressed clip. Unset: not known.
struct ResultFigures {
  double ratio = 0;
  std::size_t motion_bytes = 0;
  std::size_t file_bytes = 0;                 // unknown where the size is estimated
  bool size_is_estimated = false;             // and with it the ratio and the bits
  Weighting weighting = Weighting::BoneEnds;  // of eps_cm
  double eps_cm = 0;
  std::optional<double> p95_cm;
  std::optional<double> p99_cm;
  double max_cm = 0;
  std::optional<Spread> skin;  // unset: there is no mesh, or no original to compare it with
  std::optional<SeenFigures> seen;
  std::optional<double> coefficient_ratio;
  double bits_per_joint_sample = 0;
  std::optional<double> footskate_cm;
  std::optional<SlidePerContact> slide;
  std::optional<EndErrors> ends;
  bool is_loop = false;
  std::optional<std::size_t> correction_bytes;
  std::optional<double> correction_ratio;  // r_IK
  std::optional<double> fastest_knee;      // radians/s
  std::optional<double> fastest_knee_of_original;
};

/// Size and error of the compressed clip, always in sight.
class ResultPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ResultPanel(QWidget* parent = nullptr);

  /// Unset: dashes.
  void setFigures(const std::optional<ResultFigures>& figures);

  /// How the figures came about, in a few words.
  void setState(const QString& state);

 private:
  QLabel* addHeadline(const QString& name, const QString& explanation, int column);
  QLabel* addRow(const QString& name, const QString& explanation);
  QLabel* nameOf(QLabel* value) const;
  void setEnds(const ResultFigures& figures);

  QGridLayout* grid_;
  QLabel* ratio_;
  QLabel* eps_;
  QLabel* eps_name_;
  QLabel* state_;
  QLabel* ends_;
  QLabel* elsewhere_;  // what a loop's seam compares with
  QLabel* bytes_;
  QLabel* p95_;
  QLabel* p99_;
  QLabel* max_;
  QLabel* skin_;
  QLabel* seen_;
  QLabel* coefficient_ratio_;
  QLabel* bits_;
  QLabel* footskate_;
  QLabel* slide_;
  QLabel* correction_;
  QLabel* knee_;
};

}  // namespace mocapress
