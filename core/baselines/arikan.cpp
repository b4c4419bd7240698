// SPDX-License-Identifier: MIT
#include "core/baselines/arikan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/byte_cursor.h"
#include "core/base/error.h"
#include "core/baselines/bezier.h"
#include "core/baselines/segment_database.h"
#include "core/baselines/tolerance_of_detail.h"
#include "core/baselines/virtual_markers.h"
#include "core/codec/format/deflate.h"

namespace mocapress {
namespace {

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

/// Clusters of curves, as the decoder has them.
struct Codebook {
  struct Cluster {
    Eigen::VectorXd mean;
    Eigen::MatrixXd basis;  // coordinates of control points x components
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

/// Puts frames together again, segment by segment.
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

  /// Control points 1, 2, 3 of each segment of the channels that markers do not say.
  Eigen::MatrixXd read_others(ByteReader& reader, const Eigen::RowVectorXd& first) const {
    const std::vector<int>& channels = markers_.other_channels();
    Eigen::MatrixXd controls(3 * segments_, std::ssize(channels));
    for (std::size_t c = 0; c < channels.size(); ++c) {
      const double step = read_finite(reader);
      const Eigen::VectorXd read = read_steps(reader, controls.rows(), step);
      auto column = controls.col(static_cast<Eigen::Index>(c));
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

/// Of a clip, at most.
std::size_t segments_of(int frames) {
  return static_cast<std::size_t>(curve_count(frames, kShortestCurve));
}

/// No clip's part inflates to more, whatever is in it.
std::size_t most_clip_bytes(const VirtualMarkers& markers, int frames) {
  const std::size_t segments = segments_of(frames);
  const auto coordinates = static_cast<std::size_t>(markers.coordinates());
  const std::size_t others = markers.other_channels().size();
  return 4 * others + 2 * markers.angles().size() + 4 + others * (4 + 6 * segments) +
         segments * (1 + 6 * coordinates);
}

/// Nor does a codebook: there are no more clusters than segments, and no more components in all.
std::size_t most_codebook_bytes(const VirtualMarkers& markers, std::size_t segments) {
  const std::size_t of_vector = 6 * static_cast<std::size_t>(markers.coordinates());
  constexpr std::size_t kMostClusters = 255;
  return 6 + std::min(segments, kMostClusters) * (2 + of_vector) + segments * (4 + of_vector);
}

class ArikanCoder : public DetailCoder {
 public:
  ArikanCoder(const Motion& motion, Weighting weighting)
      : database_(std::span(&motion, 1), weighting) {}

  int most_detail() const override { return kMostDetail; }

  std::vector<std::byte> encode(int detail) const override {
    const auto encoding = database_.encode(tolerance_of_detail(detail));
    ByteWriter writer;
    encoding.write_codebook(writer);
    encoding.write_clip(writer, 0);
    return deflate_bytes(writer.bytes());
  }

 private:
  SegmentDatabase database_;
};

class Arikan : public ComparisonMethod {
 public:
  std::string_view name() const override { return "arikan"; }
  std::string_view title() const override { return "Clustered PCA, after Arikan"; }
  std::string_view note() const override {
    return "Our reading of Arikan (2006): clustered PCA of short Bezier curves of virtual markers, "
           "the database being the clip alone; k-means clusters, DEFLATE, and no special care of "
           "the feet.";
  }

  std::unique_ptr<DetailCoder> analyse(const Motion& motion, Weighting weighting) const override {
    return std::make_unique<ArikanCoder>(motion, weighting);
  }

  Clip decode(const Skeleton& skeleton, double sample_rate_hz, int frames,
              std::span<const std::byte> motion) const override {
    const VirtualMarkers markers(skeleton);
    const auto bytes = inflate_bytes(motion, most_codebook_bytes(markers, segments_of(frames)) +
                                                 most_clip_bytes(markers, frames));
    ByteReader reader(bytes);
    const Codebook codebook(reader, markers.coordinates());
    Clip clip{sample_rate_hz,
              ClipDecoder(skeleton, frames, codebook).decode(reader, skeleton.channel_count())};
    reader.expect_end();
    return clip;
  }
};

bool alike(const Skeleton& a, const Skeleton& b) {
  return std::equal(a.joints().begin(), a.joints().end(), b.joints().begin(), b.joints().end(),
                    [](const Joint& x, const Joint& y) {
                      return x.parent == y.parent && x.channels == y.channels;
                    });
}

}  // namespace

const ComparisonMethod& arikan_method() {
  static const Arikan kMethod;
  return kMethod;
}

std::size_t ArikanDatabase::bytes() const {
  std::size_t sum = codebook.size();
  for (const auto& clip : clips) sum += clip.size();
  return sum;
}

ArikanDatabase compress_database(std::span<const Motion> motions, Weighting weighting,
                                 double tolerance_cm) {
  for (const Motion& motion : motions)
    if (!alike(motion.skeleton, motions.front().skeleton))
      throw Error("the skeletons of a database must have the same joints and channels");
  const SegmentDatabase database(motions, weighting);
  const auto encoding = database.encode(tolerance_cm);
  ArikanDatabase result;
  ByteWriter codebook;
  encoding.write_codebook(codebook);
  result.codebook = deflate_bytes(codebook.bytes());
  for (std::size_t m = 0; m < motions.size(); ++m) {
    ByteWriter clip;
    encoding.write_clip(clip, m);
    result.clips.push_back(deflate_bytes(clip.bytes()));
  }
  return result;
}

Clip decode_from_database(const Skeleton& skeleton, double sample_rate_hz, int frames,
                          std::span<const std::byte> codebook_bytes,
                          std::span<const std::byte> clip_bytes) {
  constexpr int kMostFramesOfDatabase = 1 << 20;  // it is of more clips than this
  const VirtualMarkers markers(skeleton);
  const auto shared = inflate_bytes(
      codebook_bytes, most_codebook_bytes(markers, segments_of(kMostFramesOfDatabase)));
  ByteReader codebook_reader(shared);
  const Codebook codebook(codebook_reader, markers.coordinates());
  codebook_reader.expect_end();
  const auto own = inflate_bytes(clip_bytes, most_clip_bytes(markers, frames));
  ByteReader reader(own);
  Clip clip{sample_rate_hz,
            ClipDecoder(skeleton, frames, codebook).decode(reader, skeleton.channel_count())};
  reader.expect_end();
  return clip;
}

}  // namespace mocapress
