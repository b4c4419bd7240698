// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/report/curve.h"
#include "core/study/published_figures.h"
#include "core/study/row.h"

namespace mocapress {

/// A line of a chart: a method, with or without IK correction.
struct Series {
  std::string method;
  std::optional<double> ik_ratio;
  std::string title;  // title in a legend

  bool has(const StudyRow& row) const {
    return row.settings.method == method && row.ik_ratio() == ik_ratio;
  }
};

/// A clip that was read and measured.
struct StudiedClip {
  std::string path;
  ClipReview review = {};
  std::string title;  // file name; the path if several clips share the name
  int frames = 0;
  int channels = 0;
  double sample_rate_hz = 0;
  std::size_t raw_bytes = 0;
  const PublishedClip* published = nullptr;  // the paper's values; null: it has none
};

/// The size of a clip in a series at some error, as a compression ratio.
struct SizeAtError {
  double ratio;
  bool measured;  // false: interpolated between measured points
};

/// A mean ratio, and the number of clips that it is taken over.
struct MeanRatio {
  double ratio;
  int clips;
};

/// The rows of a study, which can be looked up by clip and series.
class Results {
 public:
  explicit Results(std::vector<StudyRow> rows);

  const std::vector<StudyRow>& rows() const { return rows_; }
  const std::vector<StudiedClip>& clips() const { return clips_; }
  const std::vector<Series>& series() const { return series_; }
  Weighting weighting() const { return weighting_; }

  /// The series of a method without IK correction; null if no row has it.
  const Series* find_series(std::string_view method) const;

  /// The series that a report leads with: that of the method that ships, or else of the paper's
  /// best method, or else the first. Null if there is no series.
  const Series* leading_series() const;

  /// The measured row of a clip, series and target; null if there is none.
  const StudyRow* row(const StudiedClip& clip, const Series& series, const Target& target) const;

  Curve curve(const StudiedClip& clip, const Series& series) const;

  /// The size at an error, from the row with this target if it was reached, or else from the curve.
  /// Unset if the curve does not cover the error.
  std::optional<SizeAtError> size_at(const StudiedClip& clip, const Series& series,
                                     double eps_cm) const;

  /// The geometric mean of the ratios at an error, over the clips that have one.
  std::optional<MeanRatio> mean_ratio_at(const Series& series, double eps_cm) const;

  /// The mean of all clips' curves; empty if no error is common to them.
  Curve mean_curve(const Series& series) const;

 private:
  std::vector<StudyRow> rows_;
  std::vector<StudiedClip> clips_;
  std::vector<Series> series_;
  Weighting weighting_ = Weighting::BoneEnds;
};

}  // namespace mocapress
