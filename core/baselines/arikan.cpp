// SPDX-License-Identifier: MIT
// Based on: O. Arikan, "Compression of Motion Capture Databases", 2006. Differences, and choices
// that the paper leaves open:
// - each curve begins where the one before ends, so that nothing has to be smoothed;
// - k-means, not spectral clustering; segment length and number of clusters are chosen for the
//   tolerance;
// - roots and translations have curves of their own, and feet get no extra signals;
// - 16-bit steps and DEFLATE in place of Huffman codes.
// METHODS.md defines the bytes.
#include "core/baselines/rivals.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/byte_cursor.h"
#include "core/base/error.h"
#include "core/baselines/k_means.h"
#include "core/baselines/principal_components.h"
#include "core/baselines/splines.h"
#include "core/baselines/virtual_markers.h"
#include "core/codec/format/deflate.h"
#include "core/select/error_model.h"

namespace mocapress {

namespace {

/// Curves fit segments of up to this many frames exactly: a curve has three free control points.
inline constexpr int kShortestCurve = 3;

/// The number of segments of `length` frames after the first frame; the last may be shorter.
constexpr int curve_count(int frames, int length) {
  return frames > 1 ? (frames - 2) / length + 1 : 0;
}

/// A motion cut into curves of several lengths, each clustered in several ways.
class SegmentDatabase {
 public:
  SegmentDatabase(const Motion& motion, Weighting weighting);

  /// One encoding of the motion: the best way to cut and cluster it for a tolerance.
  class Encoding {
   public:
    void write_codebook(ByteWriter& writer) const;
    void write_clip(ByteWriter& writer) const;

   private:
    friend class SegmentDatabase;
    const SegmentDatabase* database;
    std::size_t cutting;
    std::size_t clustering;
    double tolerance;             // cm
    std::vector<int> components;  // number of components kept for each cluster
    float loading_step;           // cm
    float coefficient_step;       // cm
  };
  Encoding encode(double tolerance_cm) const;

 private:
  struct Clustering {
    std::vector<int> clusters;               // each segment's cluster
    std::vector<int> places;                 // each segment's row in its cluster
    std::vector<PrincipalComponents> parts;  // one for each cluster
  };
  /// The motion as curves of one length.
  struct Cutting {
    int length;               // frames of a segment
    double error;             // cm: root-mean-square distance of the curves from the motion
    Eigen::MatrixXd markers;  // rows: segments; columns: control points 1, 2, 3 of all markers
    Eigen::MatrixXd others;   // rows: 3 control points of each segment; columns: other channels
    std::vector<Clustering> clusterings;
  };

  Cutting cut(const Eigen::MatrixXd& markers, const Clip& clip, int length) const;

  int frames_;
  Eigen::RowVectorXd first_frame_;
  std::vector<int> other_channels_;
  std::vector<int> angles_;
  Eigen::VectorXd other_scales_;   // cm of movement for a unit of each other channel
  Eigen::Index coordinates_;       // number of coordinates of a frame's markers
  std::vector<Cutting> cuttings_;  // the longest first
};

constexpr double kMostSteps = 32000;  // below the largest 16-bit value

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

SegmentDatabase::SegmentDatabase(const Motion& motion, Weighting weighting) {
  const auto& [skeleton, clip] = motion;
  const VirtualMarkers markers(skeleton);
  frames_ = clip.frames();
  other_channels_ = markers.other_channels();
  angles_ = markers.angles();
  coordinates_ = markers.coordinates();
  other_scales_ = Eigen::VectorXd::Ones(std::ssize(other_channels_));
  if (frames_ > 0) {
    first_frame_ = clip.channels.row(0);
    const Eigen::MatrixXd curvature = ErrorModel(skeleton, clip, weighting).curvature();
    other_scales_ = curvature(Eigen::all, other_channels_).colwise().mean().cwiseSqrt().cwiseMax(1);
  }
  const Eigen::MatrixXd tracks = marker_tracks(markers, clip);
  for (const int length : {32, 16, 8, 5, kShortestCurve})
    cuttings_.push_back(cut(tracks, clip, length));
}

SegmentDatabase::Cutting SegmentDatabase::cut(const Eigen::MatrixXd& markers, const Clip& clip,
                                              int length) const {
  Cutting cutting{.length = length};
  const Eigen::Index segments = curve_count(frames_, length);
  const Eigen::MatrixXd other = clip.channels(Eigen::all, other_channels_);
  cutting.markers.resize(segments, 3 * coordinates_);
  cutting.others.resize(3 * segments, other.cols());
  double squared_error = 0;
  for (Eigen::Index s = 0; s < segments; ++s) {
    const Eigen::Index begin = s * length;
    const Eigen::Index count = std::min<Eigen::Index>(length, frames_ - 1 - begin);
    const auto fit = [&](const Eigen::MatrixXd& rows, const Eigen::RowVectorXd& scales) {
      const Eigen::MatrixXd segment = rows.middleRows(begin, count + 1);
      Eigen::MatrixXd controls = fit_bezier(segment);
      squared_error += ((bezier_curve(segment.row(0), controls, static_cast<int>(count)) -
                         segment.bottomRows(count)) *
                        scales.asDiagonal())
                           .squaredNorm();
      return controls;
    };
    // The markers' errors count as an average over the markers.
    const double share =
        std::sqrt(3.0 / static_cast<double>(std::max<Eigen::Index>(coordinates_, 1)));
    cutting.markers.row(s) = fit(markers, Eigen::RowVectorXd::Constant(coordinates_, share))
                                 .reshaped<Eigen::RowMajor>()
                                 .transpose();
    cutting.others.middleRows<3>(3 * s) = fit(other, other_scales_.transpose());
  }
  cutting.error = std::sqrt(squared_error / std::max(frames_ - 1, 1));

  constexpr int kMostClusters = 64;
  constexpr int kLargestCluster = 400;  // segments; analysing larger clusters takes long
  constexpr int kSmallestCluster = 6;
  for (int count = 1; count <= kMostClusters && segments > 0; count *= 4) {
    if (count > 1 && segments < count * kSmallestCluster) break;
    if (count < kMostClusters && segments > count * kLargestCluster) continue;
    Clustering clustering{k_means(cutting.markers, count), {}, {}};
    std::vector<std::vector<int>> rows(count);
    for (std::size_t s = 0; s < clustering.clusters.size(); ++s) {
      auto& mates = rows[clustering.clusters[s]];
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
  // Rounding to steps may take a fifth of the squared error, and components what the curves leave
  // of the rest. An error of a control point spreads over about half a segment.
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
      constexpr double kBytes = 1.3;  // average bytes for a number after DEFLATE
      double bytes = 0;
      std::vector<int> components;
      for (const PrincipalComponents& parts : clustering.parts) {
        components.push_back(parts.enough_for(6 * markers * std::max(left, 0.0)));
        bytes += kBytes * (static_cast<double>(parts.mean.size()) * (1 + components.back()) +
                           static_cast<double>(parts.projections.rows()) * components.back());
      }
      bytes += kBytes * static_cast<double>(cut.others.size());
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

void SegmentDatabase::Encoding::write_clip(ByteWriter& writer) const {
  const Cutting& cut = database->cuttings_[cutting];
  const Clustering& ways = cut.clusterings[clustering];
  if (database->frames_ == 0) return;
  const Eigen::RowVectorXd& first_frame = database->first_frame_;
  for (const int c : database->other_channels_) writer.write(static_cast<float>(first_frame(c)));
  for (const int c : database->angles_)
    writer.write(
        steps(std::remainder(first_frame(c), 2 * std::numbers::pi), std::numbers::pi / 32767));
  writer.write(coefficient_step);

  // Each curve starts where the decoder's previous curve ends.
  const Eigen::MatrixXd& others = cut.others;
  for (Eigen::Index c = 0; c < others.cols(); ++c) {
    const double at_first = static_cast<float>(first_frame(database->other_channels_[c]));
    const double range = largest_of(others.col(c).array() - at_first);
    const float step = step_for(tolerance / 4 / database->other_scales_(c), 2 * range);
    writer.write(step);
    double start = at_first;
    for (Eigen::Index s = 0; s < others.rows(); s += 3) {
      for (Eigen::Index i = s; i < s + 3; ++i) writer.write(steps(others(i, c) - start, step));
      start += static_cast<double>(step) * steps(others(s + 2, c) - start, step);
    }
  }
  for (const int cluster : ways.clusters) writer.write(static_cast<std::uint8_t>(cluster));
  for (std::size_t s = 0; s < ways.clusters.size(); ++s) {
    const auto cluster = static_cast<std::size_t>(ways.clusters[s]);
    const auto coefficients = ways.parts[cluster].projections.row(ways.places[s]);
    for (int i = 0; i < components[cluster]; ++i)
      writer.write(steps(coefficients(i), coefficient_step));
  }
}

double read_finite(ByteReader& reader) {
  const double value = reader.read<float>();
  if (!std::isfinite(value)) reader.fail("a number that is not finite");
  return value;
}

Eigen::VectorXd read_steps(ByteReader& reader, Eigen::Index count, double step) {
  ByteReader steps(reader.take(static_cast<std::size_t>(count) * sizeof(std::int16_t)));
  Eigen::VectorXd values(count);
  for (double& value : values) value = step * steps.read<std::int16_t>();
  return values;
}

/// The clusters of curves, as the decoder reads them.
struct Codebook {
  struct Cluster {
    Eigen::VectorXd mean;
    Eigen::MatrixXd basis;  // rows: coordinates of the control points; columns: components
  };
  int length;  // frames of a segment
  std::vector<Cluster> clusters;

  Codebook(ByteReader& reader, Eigen::Index coordinates) {
    length = reader.read<std::uint8_t>();
    if (length < kShortestCurve) reader.fail("segments that are too short");
    clusters.resize(reader.read<std::uint8_t>());
    const double step = read_finite(reader);
    for (Cluster& cluster : clusters) {
      const int components = reader.read<std::uint16_t>();
      if (components > 3 * coordinates) reader.fail("more components than possible");
      cluster.mean = read_steps(reader, 3 * coordinates, step);
      const std::size_t needed = static_cast<std::size_t>(components) *
                                 (sizeof(float) + 6 * static_cast<std::size_t>(coordinates));
      if (reader.remaining() < needed) reader.fail("fewer components than stated");
      cluster.basis.resize(3 * coordinates, components);
      for (auto component : cluster.basis.colwise()) {
        const double reach = read_finite(reader);
        if (reach <= 0) reader.fail("a component whose reach is not above 0");
        component = read_steps(reader, 3 * coordinates, step) / reach;
      }
    }
  }
};

/// Rebuilds frames, segment by segment.
class ClipDecoder {
 public:
  ClipDecoder(const Skeleton& skeleton, int frames, const Codebook& codebook)
      : markers_(skeleton),
        codebook_(codebook),
        frames_(frames),
        segments_(curve_count(frames, codebook.length)) {}

  Eigen::MatrixXd decode(ByteReader& reader, Eigen::Index channels) const {
    Eigen::MatrixXd result(frames_, channels);
    if (frames_ == 0) return result;
    Eigen::RowVectorXd frame = read_first(reader, channels);
    result.row(0) = frame;
    const double step = read_finite(reader);
    const Eigen::MatrixXd others = read_others(reader, frame);
    ByteReader clusters(reader.take(static_cast<std::size_t>(segments_)));
    Eigen::RowVectorXd start = markers_.of(frame);
    for (int s = 0; s < segments_; ++s) {
      const int begin = s * codebook_.length;
      const int count = std::min(codebook_.length, frames_ - 1 - begin);
      const Eigen::MatrixXd controls = read_controls(reader, clusters, step);
      const Eigen::MatrixXd tracks = bezier_curve(start, controls, count);
      const Eigen::MatrixXd other_tracks =
          bezier_curve(frame(markers_.other_channels()), others.middleRows<3>(3 * s), count);
      for (int t = 0; t < count; ++t) {
        frame(markers_.other_channels()) = other_tracks.row(t);
        markers_.turn(tracks.row(t), frame);
        result.row(begin + 1 + t) = frame;
      }
      start = controls.row(2);
    }
    return result;
  }

 private:
  Eigen::RowVectorXd read_first(ByteReader& reader, Eigen::Index channels) const {
    Eigen::RowVectorXd frame(channels);
    for (const int c : markers_.other_channels()) frame(c) = read_finite(reader);
    for (const int c : markers_.angles())
      frame(c) = std::numbers::pi / 32767 * reader.read<std::int16_t>();
    return frame;
  }

  /// Reads control points 1, 2, 3 of each segment for the channels that markers do not determine.
  Eigen::MatrixXd read_others(ByteReader& reader, const Eigen::RowVectorXd& first) const {
    const std::vector<int>& channels = markers_.other_channels();
    Eigen::MatrixXd controls(3 * segments_, std::ssize(channels));
    for (std::size_t c = 0; c < channels.size(); ++c) {
      const double step = read_finite(reader);
      const Eigen::VectorXd read = read_steps(reader, controls.rows(), step);
      auto column = controls.col(c);
      double start = first(channels[c]);
      for (Eigen::Index s = 0; s < controls.rows(); s += 3) {
        column.segment<3>(s) = read.segment<3>(s).array() + start;
        start = column(s + 2);
      }
    }
    return controls;
  }

  Eigen::MatrixXd read_controls(ByteReader& reader, ByteReader& clusters, double step) const {
    const std::size_t index = clusters.read<std::uint8_t>();
    if (index >= codebook_.clusters.size()) clusters.fail("an unknown cluster");
    const Codebook::Cluster& cluster = codebook_.clusters[index];
    const Eigen::VectorXd controls =
        cluster.mean + cluster.basis * read_steps(reader, cluster.basis.cols(), step);
    return controls.reshaped<Eigen::RowMajor>(3, markers_.coordinates());
  }

  VirtualMarkers markers_;
  const Codebook& codebook_;
  int frames_;
  int segments_;
};

/// The largest number of segments that a clip can have.
std::size_t segments_of(int frames) {
  return static_cast<std::size_t>(curve_count(frames, kShortestCurve));
}

/// The most bytes that a clip's part can inflate to, whatever its contents.
std::size_t most_clip_bytes(const VirtualMarkers& markers, int frames) {
  const std::size_t segments = segments_of(frames);
  const auto coordinates = static_cast<std::size_t>(markers.coordinates());
  const std::size_t others = markers.other_channels().size();
  return 4 * others + 2 * markers.angles().size() + 4 + others * (4 + 6 * segments) +
         segments * (1 + 6 * coordinates);
}

/// The most bytes that a codebook can inflate to. It has at most as many clusters as there are
/// segments, and at most as many components in total.
std::size_t most_codebook_bytes(const VirtualMarkers& markers, int frames) {
  const std::size_t segments = segments_of(frames);
  const std::size_t of_vector = 6 * static_cast<std::size_t>(markers.coordinates());
  constexpr std::size_t kMostClusters = 255;
  return 6 + std::min(segments, kMostClusters) * (2 + of_vector) + segments * (4 + of_vector);
}

class ArikanCoder : public DetailCoder {
 public:
  ArikanCoder(const Motion& motion, Weighting weighting) : database_(motion, weighting) {}

  int most_detail() const override { return kMostDetail; }

  std::vector<std::byte> encode(int detail) const override {
    const auto encoding = database_.encode(tolerance_of_detail(detail));
    ByteWriter writer;
    encoding.write_codebook(writer);
    encoding.write_clip(writer);
    return deflate_bytes(writer.bytes());
  }

 private:
  SegmentDatabase database_;
};

Clip decode_arikan(const Skeleton& skeleton, double sample_rate_hz, int frames,
                   std::span<const std::byte> motion) {
  const VirtualMarkers markers(skeleton);
  const auto bytes = inflate_bytes(
      motion, most_codebook_bytes(markers, frames) + most_clip_bytes(markers, frames));
  ByteReader reader(bytes);
  const Codebook codebook(reader, markers.coordinates());
  Clip clip{sample_rate_hz,
            ClipDecoder(skeleton, frames, codebook).decode(reader, skeleton.channel_count())};
  reader.expect_end();
  return clip;
}

}  // namespace

constinit const ComparisonMethod kArikan{
    "arikan", "Clustered PCA, after Arikan",
    "Our reading of Arikan (2006): clustered PCA of short Bezier curves of virtual markers, "
    "the database being the clip alone; k-means clusters, DEFLATE, and no special care of "
    "the feet.",
    &coder_of<ArikanCoder>, &decode_arikan};

}  // namespace mocapress
