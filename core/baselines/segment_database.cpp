// SPDX-License-Identifier: MIT
#include "core/baselines/segment_database.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/baselines/bezier.h"
#include "core/baselines/k_means.h"
#include "core/baselines/virtual_markers.h"
#include "core/select/error_model.h"

namespace mocapress {
namespace {

constexpr double kMostSteps = 32000;  // some way inside 16 bits

std::int16_t steps(double value, double step) {
  return static_cast<std::int16_t>(std::clamp(std::round(value / step), -32767.0, 32767.0));
}

float step_for(double wanted, double largest) {
  return static_cast<float>(std::max({wanted, largest / kMostSteps, 1e-9}));
}

double largest_of(const Eigen::MatrixXd& values) {
  return values.size() > 0 ? values.cwiseAbs().maxCoeff() : 0;
}

Eigen::MatrixXd marker_tracks(const VirtualMarkers& markers, const Clip& clip) {
  Eigen::MatrixXd tracks(clip.frames(), markers.coordinates());
  for (int t = 0; t < clip.frames(); ++t) tracks.row(t) = markers.of(clip.channels.row(t));
  return tracks;
}

}  // namespace

SegmentDatabase::SegmentDatabase(std::span<const Motion> motions, Weighting weighting) {
  std::vector<Eigen::MatrixXd> tracks;
  for (const auto& [skeleton, clip] : motions) {
    const VirtualMarkers markers(skeleton);
    coordinates_ = markers.coordinates();
    tracks.push_back(marker_tracks(markers, clip));
    Source source{clip.frames(), {}, markers.other_channels(), markers.angles(), {}};
    if (clip.frames() > 0) source.first_frame = clip.channels.row(0);
    const Eigen::MatrixXd curvature = ErrorModel(skeleton, clip, weighting).curvature();
    source.other_scales = Eigen::VectorXd::Ones(std::ssize(source.other_channels));
    if (clip.frames() > 0)
      source.other_scales =
          curvature(Eigen::all, source.other_channels).colwise().mean().cwiseSqrt().cwiseMax(1);
    sources_.push_back(std::move(source));
  }
  for (const int length : {32, 16, 8, 5, kShortestCurve})
    cuttings_.push_back(cut(tracks, motions, length));
}

SegmentDatabase::Cutting SegmentDatabase::cut(const std::vector<Eigen::MatrixXd>& markers,
                                              std::span<const Motion> motions, int length) const {
  Cutting cutting{.length = length};
  Eigen::Index segments = 0;
  for (const Motion& motion : motions) {
    cutting.first.push_back(static_cast<std::size_t>(segments));
    segments += curve_count(motion.clip.frames(), length);
  }
  cutting.markers.resize(segments, 3 * coordinates_);
  double squared_error = 0;
  int frames = 0;
  for (std::size_t m = 0; m < motions.size(); ++m) {
    const Source& source = sources_[m];
    const Eigen::MatrixXd other = motions[m].clip.channels(Eigen::all, source.other_channels);
    const int count = curve_count(motions[m].clip.frames(), length);
    Eigen::MatrixXd controls_of_others(3 * count, other.cols());
    for (int s = 0; s < count; ++s) {
      const int begin = s * length;
      const int last = std::min(begin + length, motions[m].clip.frames() - 1);
      const auto fit = [&](const Eigen::MatrixXd& rows, const Eigen::RowVectorXd& scales) {
        const Eigen::MatrixXd segment = rows.middleRows(begin, last - begin + 1);
        const Eigen::MatrixXd controls = fit_bezier(segment);
        squared_error += ((bezier_curve(segment.row(0), controls, last - begin) -
                           segment.bottomRows(last - begin)) *
                          scales.asDiagonal())
                             .squaredNorm();
        return controls;
      };
      // Of the markers, the mean.
      const double share =
          std::sqrt(3.0 / static_cast<double>(std::max<Eigen::Index>(coordinates_, 1)));
      cutting.markers.row(static_cast<Eigen::Index>(cutting.first[m]) + s) =
          fit(markers[m], Eigen::RowVectorXd::Constant(coordinates_, share))
              .reshaped<Eigen::RowMajor>()
              .transpose();
      controls_of_others.middleRows<3>(3 * s) = fit(other, source.other_scales.transpose());
      frames += last - begin;
    }
    cutting.others.push_back(std::move(controls_of_others));
  }
  cutting.error = std::sqrt(squared_error / std::max(frames, 1));

  constexpr int kMostClusters = 64;
  constexpr int kLargestCluster = 400;  // segments: larger ones take long to analyse
  constexpr int kSmallestCluster = 6;
  for (int count = 1; count <= kMostClusters && segments > 0; count *= 4) {
    if (count > 1 && segments < count * kSmallestCluster) break;
    if (count < kMostClusters && segments > count * kLargestCluster) continue;
    Clustering clustering{k_means(cutting.markers, count), {}, {}};
    std::vector<std::vector<int>> rows(static_cast<std::size_t>(count));
    for (std::size_t s = 0; s < clustering.clusters.size(); ++s) {
      auto& mates = rows[static_cast<std::size_t>(clustering.clusters[s])];
      clustering.places.push_back(static_cast<int>(mates.size()));
      mates.push_back(static_cast<int>(s));
    }
    for (const auto& of_cluster : rows)
      clustering.parts.push_back(principal_components(cutting.markers(of_cluster, Eigen::all)));
    cutting.clusterings.push_back(std::move(clustering));
  }
  if (segments == 0) cutting.clusterings.emplace_back();
  return cutting;
}

SegmentDatabase::Encoding SegmentDatabase::encode(double tolerance_cm) const {
  // Of the squared error a fifth is for the steps; what the curves leave is for the components. An
  // error of a control point is in sight for about half a segment.
  const double markers = static_cast<double>(coordinates_) / 3;
  const double may_miss = 0.8 * tolerance_cm * tolerance_cm;
  Encoding best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t cutting = 0; cutting < cuttings_.size(); ++cutting) {
    const Cutting& cut = cuttings_[cutting];
    const double left = may_miss - cut.error * cut.error;
    if (left < 0 && cut.length > kShortestCurve) continue;
    for (std::size_t way = 0; way < cut.clusterings.size(); ++way) {
      const Clustering& clustering = cut.clusterings[way];
      constexpr double kBytes = 1.3;  // of a number, deflated
      double bytes = 0;
      std::vector<int> components;
      for (const PrincipalComponents& parts : clustering.parts) {
        components.push_back(parts.enough_for(6 * markers * std::max(left, 0.0)));
        bytes += kBytes * (static_cast<double>(parts.mean.size()) * (1 + components.back()) +
                           static_cast<double>(parts.projections.rows()) * components.back());
      }
      for (const Eigen::MatrixXd& others : cut.others)
        bytes += kBytes * static_cast<double>(others.size());
      if (bytes >= least) continue;
      least = bytes;
      double largest_loading = 0;
      double largest_coefficient = 0;
      for (const PrincipalComponents& parts : clustering.parts) {
        largest_loading = std::max(largest_loading, largest_of(parts.mean));
        largest_coefficient = std::max(largest_coefficient, largest_of(parts.projections));
      }
      best.cutting = cutting;
      best.clustering = way;
      best.components = std::move(components);
      best.loading_step =
          step_for(tolerance_cm / 2, std::max(largest_loading, largest_coefficient));
      best.coefficient_step = step_for(tolerance_cm * std::sqrt(markers) / 2, largest_coefficient);
    }
  }
  best.database = this;
  best.tolerance = tolerance_cm;
  return best;
}

void SegmentDatabase::Encoding::write_codebook(ByteWriter& writer) const {
  const Cutting& cut = database->cuttings_[cutting];
  const Clustering& ways = cut.clusterings[clustering];
  writer.write(static_cast<std::uint8_t>(cut.length));
  writer.write(static_cast<std::uint8_t>(ways.parts.size()));
  writer.write(loading_step);
  for (std::size_t c = 0; c < ways.parts.size(); ++c) {
    const PrincipalComponents& parts = ways.parts[c];
    writer.write(static_cast<std::uint16_t>(components[c]));
    for (const double value : parts.mean) writer.write(steps(value, loading_step));
    for (int i = 0; i < components[c]; ++i) {
      const auto reach = static_cast<float>(largest_of(parts.projections.col(i)));
      writer.write(reach);
      for (const double value : parts.basis.col(i))
        writer.write(steps(reach * value, loading_step));
    }
  }
}

void SegmentDatabase::Encoding::write_clip(ByteWriter& writer, std::size_t clip) const {
  const Source& source = database->sources_[clip];
  const Cutting& cut = database->cuttings_[cutting];
  const Clustering& ways = cut.clusterings[clustering];
  if (source.frames == 0) return;
  for (const int c : source.other_channels) writer.write(static_cast<float>(source.first_frame(c)));
  for (const int c : source.angles)
    writer.write(steps(std::remainder(source.first_frame(c), 2 * std::numbers::pi),
                       std::numbers::pi / 32767));
  writer.write(coefficient_step);

  // Each curve from where the decoder's came to be.
  const Eigen::MatrixXd& others = cut.others[clip];
  for (Eigen::Index c = 0; c < others.cols(); ++c) {
    const double at_first =
        static_cast<float>(source.first_frame(source.other_channels[static_cast<std::size_t>(c)]));
    const double range = largest_of(others.col(c).array() - at_first);
    const float step = step_for(tolerance / 4 / source.other_scales(c), 2 * range);
    writer.write(step);
    double start = at_first;
    for (Eigen::Index s = 0; s < others.rows(); s += 3) {
      for (Eigen::Index i = s; i < s + 3; ++i) writer.write(steps(others(i, c) - start, step));
      start += static_cast<double>(step) * steps(others(s + 2, c) - start, step);
    }
  }
  const std::size_t first = cut.first[clip];
  const std::size_t count = static_cast<std::size_t>(others.rows()) / 3;
  for (std::size_t s = first; s < first + count; ++s)
    writer.write(static_cast<std::uint8_t>(ways.clusters[s]));
  for (std::size_t s = first; s < first + count; ++s) {
    const auto cluster = static_cast<std::size_t>(ways.clusters[s]);
    const auto coefficients = ways.parts[cluster].projections.row(ways.places[s]);
    for (int i = 0; i < components[cluster]; ++i)
      writer.write(steps(coefficients(i), coefficient_step));
  }
}

}  // namespace mocapress
