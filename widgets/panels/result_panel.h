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

/// Visibility of a clip's errors, and the place where they are most visible.
struct SeenFigures {
  Sight sight = Sight::NotVisible;
  Cue cue = Cue::Velocity;
  QString joint;
  double seconds = 0;
  double times_noticed = 0;
  double unnoticed_from_m = 0;         // distance from which nothing is noticed
  double distance_m = kUsualDistance;  // the viewer's distance, for which `sight` holds
};

/// Measurements of one compressed clip. Unset ones are unknown.
struct ResultFigures {
  double ratio = 0;
  std::size_t motion_bytes = 0;
  std::size_t file_bytes = 0;                 // unknown for an estimated size
  bool size_is_estimated = false;             // ratio and bits are estimates, too
  Weighting weighting = Weighting::BoneEnds;  // weighting of eps_cm
  double eps_cm = 0;
  std::optional<double> p95_cm;
  std::optional<double> p99_cm;
  double max_cm = 0;
  std::optional<Spread> skin;  // unset: no mesh, or no original to compare with
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

/// Size and error of the compressed clip: first whether its errors are visible and why, then ratio
/// and error, then everything else, which can be folded away.
class ResultPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ResultPanel(QWidget* parent = nullptr);

  /// Shows the measurements; dashes if unset.
  void setFigures(const std::optional<ResultFigures>& figures);

  /// Shows a few words about the origin of the numbers.
  void setState(const QString& state);

 private:
  QLabel* addHeadline(QGridLayout* head, const QString& name, const QString& explanation,
                      int column);
  QLabel* addRow(const QString& name, const QString& explanation);
  QLabel* nameOf(QLabel* value) const;
  void setEnds(const ResultFigures& figures);
  void setSeen(const std::optional<SeenFigures>& seen);
  QWidget* makeDetails();

  QLabel* seen_;
  QLabel* reason_;
  QGridLayout* grid_;  // rows of the details
  QLabel* ratio_;
  QLabel* eps_;
  QLabel* eps_name_;
  QLabel* state_;
  QLabel* ends_;
  QLabel* elsewhere_;  // error at other frames, to compare with a loop's seam
  QLabel* bytes_;
  QLabel* p95_;
  QLabel* p99_;
  QLabel* max_;
  QLabel* skin_;
  QLabel* coefficient_ratio_;
  QLabel* bits_;
  QLabel* footskate_;
  QLabel* slide_;
  QLabel* correction_;
  QLabel* knee_;
};

}  // namespace mocapress
