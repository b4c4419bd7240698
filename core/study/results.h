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

/// One line of a chart: a method, with or without IK correction.
struct Series {
  std::string method;
  std::optional<double> ik_ratio;
  std::string title;  // text for a legend

  bool has(const StudyRow& row) const {
    return row.settings.method == method && row.ik_ratio() == ik_ratio;
  }
};

/// A clip that was read.
struct StudiedClip {
  std::string path;
  ClipReview review = {};
  std::string title;  // the file's name, or its path if other clips share the name
  int frames = 0;
  int channels = 0;
  double sample_rate_hz = 0;
  std::size_t raw_bytes = 0;
  const PublishedClip* published = nullptr;  // the paper's figures for it; null: none
};

/// The smallest size of a clip in a series, at some error.
struct SizeAtError {
  double ratio;
  bool measured;  // false: read from the curve between measured points
};

/// A mean and the number of clips behind it.
struct MeanRatio {
  double ratio;
  int clips;
};

/// The rows of a finished study, found by clip and series.
class Results {
 public:
  explicit Results(std::vector<StudyRow> rows);

  const std::vector<StudyRow>& rows() const { return rows_; }
  const std::vector<StudiedClip>& clips() const { return clips_; }
  const std::vector<Series>& series() const { return series_; }
  Weighting weighting() const { return weighting_; }

  /// Null if no row has this method.
  const Series* find_series(std::string_view method) const;

  /// The series that a report leads with: of the method that ships, else of the paper's best, else
  /// the first; nullptr when there is none.
  const Series* leading_series() const;

  /// nullptr when there is none, or none that was measured.
  const StudyRow* row(const StudiedClip& clip, const Series& series, const Target& target) const;

  Curve curve(const StudiedClip& clip, const Series& series) const;

  /// The size from the row for this error, else from the curve.
  std::optional<SizeAtError> size_at(const StudiedClip& clip, const Series& series,
                                     double eps_cm) const;

  /// The geometric mean over the clips that have a size at this error.
  std::optional<MeanRatio> mean_ratio_at(const Series& series, double eps_cm) const;

  /// The curve over all clips; empty if they share no error.
  Curve mean_curve(const Series& series) const;

 private:
  std::vector<StudyRow> rows_;
  std::vector<StudiedClip> clips_;
  std::vector<Series> series_;
  Weighting weighting_ = Weighting::BoneEnds;
};

}  // namespace mocapress
