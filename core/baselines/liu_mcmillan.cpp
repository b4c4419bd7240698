// SPDX-License-Identifier: MIT
// Based on: G. Liu and L. McMillan, "Segment-Based Human Motion Compression", 2006. Differences:
// - the signals are channels, scaled by how far they move the body on average, not markers;
// - segments are halved for as long as that saves bytes, not grown frame by frame;
// - feet are not coded separately.
// METHODS.md defines the bytes.
#include "core/baselines/rivals.h"

#include <algorithm>
#include <cmath>

#include "core/base/byte_cursor.h"
#include "core/baselines/principal_components.h"
#include "core/baselines/series16.h"
#include "core/baselines/splines.h"
#include "core/codec/format/deflate.h"
#include "core/select/error_model.h"

namespace mocapress {
namespace {

constexpr int kShortestSegment = 16;   // frames
constexpr double kStepsPerOctave = 8;  // scales differ by factors of 2^(1/8)

enum Node : std::uint8_t { kLeaf = 0, kHalves = 1 };

double scale_of(std::int8_t exponent) {
  return std::exp2(exponent / kStepsPerOctave);
}

/// For each channel, the body's average movement, in cm, for a change by a radian (or a cm), as the
/// exponent that scale_of() takes.
std::vector<std::int8_t> scale_exponents(const Motion& motion, Weighting weighting) {
  constexpr double kLeast = 1;  // cm: lower bound, so that no channel is lost altogether
  const ErrorModel model(motion.skeleton, motion.clip, weighting);
  std::vector<std::int8_t> exponents;
  for (const auto& curvature : model.curvature().colwise()) {
    const double mean = curvature.size() > 0 ? curvature.mean() : 0;
    // Rounding may make the mean negative.
    const double scale = std::sqrt(std::max(mean, kLeast * kLeast));
    exponents.push_back(static_cast<std::int8_t>(
        std::clamp(std::round(kStepsPerOctave * std::log2(scale)), -127.0, 127.0)));
  }
  return exponents;
}

Eigen::RowVectorXd scales_of(const std::vector<std::int8_t>& exponents) {
  Eigen::RowVectorXd scales(std::ssize(exponents));
  std::ranges::transform(exponents, scales.begin(), scale_of);
  return scales;
}

/// The principal components of a segment, and the same for its halves if it is long enough.
struct Segment {
  PrincipalComponents poses;
  std::unique_ptr<Segment> first;
  std::unique_ptr<Segment> second;

  explicit Segment(const Eigen::Ref<const Eigen::MatrixXd>& rows)
      : poses(principal_components(rows)) {
    const Eigen::Index half = rows.rows() / 2;
    if (half < kShortestSegment) return;
    first = std::make_unique<Segment>(rows.topRows(half));
    second = std::make_unique<Segment>(rows.bottomRows(rows.rows() - half));
  }
};

/// Writes segments so that the root-mean-square error of poses stays within a tolerance (cm).
class SegmentWriter {
 public:
  SegmentWriter(double tolerance, double step) : tolerance_(tolerance), step_(step) {}

  std::vector<std::byte> write(const Segment& segment) const {
    std::vector<std::byte> whole = write_leaf(segment.poses);
    if (!segment.first) return whole;
    ByteWriter halves;
    halves.write(static_cast<std::uint8_t>(kHalves));
    halves.append(write(*segment.first));
    halves.append(write(*segment.second));
    return halves.bytes().size() < whole.size() ? halves.release() : whole;
  }

 private:
  // Components and key frames may take half of the squared error each. A spline's largest error is
  // about 2.5 times its root-mean-square error.
  std::vector<std::byte> write_leaf(const PrincipalComponents& poses) const {
    const int components = poses.enough_for(tolerance_ * tolerance_ / 2);
    ByteWriter writer;
    writer.write(static_cast<std::uint8_t>(kLeaf));
    writer.write(static_cast<std::uint16_t>(components));
    write_series16(writer, poses.mean);
    write_series16(writer, poses.basis.leftCols(components).reshaped());
    const double at_worst = 2.5 * tolerance_ / std::sqrt(2.0 * std::max(components, 1));
    for (int c = 0; c < components; ++c) write_curve(writer, poses.projections.col(c), at_worst);
    return writer.release();
  }

  void write_curve(ByteWriter& writer, const Eigen::VectorXd& curve, double tolerance) const {
    const std::vector<int> keys = choose_key_frames(curve, tolerance);
    writer.write(static_cast<std::uint32_t>(keys.size()));
    for (std::size_t i = 1; i < keys.size(); ++i)
      writer.write(static_cast<std::uint8_t>(keys[i] - keys[i - 1]));
    std::int16_t previous = 0;
    for (const int key : keys) {
      const auto value = static_cast<std::int16_t>(std::lround(curve(key) / step_));
      writer.write(static_cast<std::uint16_t>(value - previous));  // difference modulo 2^16
      previous = value;
    }
  }

  double tolerance_;
  double step_;
};

class LiuMcMillanCoder : public DetailCoder {
 public:
  LiuMcMillanCoder(const Motion& motion, Weighting weighting)
      : exponents_(scale_exponents(motion, weighting)),
        scaled_(motion.clip.channels * scales_of(exponents_).asDiagonal()),
        whole_(scaled_) {
    const Eigen::MatrixXd centred = scaled_.rowwise() - whole_.poses.mean.transpose();
    if (centred.size() > 0) reach_ = 2 * centred.rowwise().norm().maxCoeff();
  }

  int most_detail() const override { return kMostDetail; }

  std::vector<std::byte> encode(int detail) const override {
    const double tolerance = tolerance_of_detail(detail);
    const auto step = static_cast<float>(std::max({tolerance / 8, reach_ / 32000, 1e-6}));
    ByteWriter writer;
    for (const std::int8_t exponent : exponents_) writer.write(exponent);
    writer.write(step);
    writer.append(SegmentWriter(tolerance, step).write(whole_));
    return deflate_bytes(writer.bytes());
  }

 private:
  std::vector<std::int8_t> exponents_;
  Eigen::MatrixXd scaled_;  // frames x channels, roughly in cm
  Segment whole_;
  double reach_ = 0;  // no projection is larger
};

/// Reads segments written by SegmentWriter.
class SegmentReader {
 public:
  SegmentReader(ByteReader& reader, double step) : reader_(reader), step_(step) {}

  void read(Eigen::Ref<Eigen::MatrixXd> rows) const {
    const Eigen::Index half = rows.rows() / 2;
    const auto node = reader_.read<std::uint8_t>();
    if (node == kLeaf) return read_leaf(rows);
    if (node != kHalves || half < kShortestSegment) reader_.fail("a segment of an unknown kind");
    read(rows.topRows(half));
    read(rows.bottomRows(rows.rows() - half));
  }

 private:
  void read_leaf(Eigen::Ref<Eigen::MatrixXd> rows) const {
    const int components = reader_.read<std::uint16_t>();
    if (components > std::min(rows.rows(), rows.cols()))
      reader_.fail("more components than possible");
    const Eigen::VectorXd mean = read_series16(reader_, rows.cols());
    const Eigen::VectorXd basis = read_series16(reader_, rows.cols() * components);
    Eigen::MatrixXd projections(rows.rows(), components);
    for (auto curve : projections.colwise()) curve = read_curve(rows.rows());
    rows = (projections * basis.reshaped(rows.cols(), components).transpose()).rowwise() +
           mean.transpose();
  }

  Eigen::VectorXd read_curve(Eigen::Index frames) const {
    const auto count = reader_.read<std::uint32_t>();
    std::vector<int> keys{0};
    for (std::uint32_t i = 1; i < count; ++i) {
      const int gap = reader_.read<std::uint8_t>();
      if (gap == 0) reader_.fail("two keys at one frame");
      keys.push_back(keys.back() + gap);
      if (keys.back() >= frames) reader_.fail("a key after the segment's end");
    }
    if (count == 0 || keys.back() != frames - 1) reader_.fail("no key at the segment's end");
    Eigen::VectorXd values(count);
    std::uint16_t value = 0;
    for (double& at_key : values) {
      value = static_cast<std::uint16_t>(value + reader_.read<std::uint16_t>());
      at_key = step_ * static_cast<std::int16_t>(value);
    }
    return natural_spline(keys, values);
  }

  ByteReader& reader_;
  double step_;
};

/// The most bytes that a clip can inflate to. A component takes 2 bytes for each channel and 3 for
/// each frame, and there are no more components than frames or channels.
std::size_t most_segment_bytes(int frames, int channels) {
  const auto n = static_cast<std::size_t>(frames);
  const auto k = static_cast<std::size_t>(channels);
  const std::size_t leaves = n / kShortestSegment + 1;
  return sizeof(float) + k + 5 * n * k + leaves * (32 + 4 * k + series16_bytes(k));
}

Clip decode_liu_mcmillan(const Skeleton& skeleton, double sample_rate_hz, int frames,
                         std::span<const std::byte> motion) {
  const int channels = skeleton.channel_count();
  const auto bytes = inflate_bytes(motion, most_segment_bytes(frames, channels));
  ByteReader reader(bytes);
  std::vector<std::int8_t> exponents(channels);
  for (std::int8_t& exponent : exponents) exponent = reader.read<std::int8_t>();
  const double step = reader.read<float>();
  if (!std::isfinite(step)) reader.fail("a step that is not finite");
  Clip clip{sample_rate_hz, Eigen::MatrixXd(frames, channels)};
  SegmentReader(reader, step).read(clip.channels);
  reader.expect_end();
  clip.channels *= scales_of(exponents).cwiseInverse().asDiagonal();
  return clip;
}

}  // namespace

constinit const ComparisonMethod kLiuMcMillan{
    "liu-mcmillan", "Segment PCA, after Liu & McMillan",
    "Our reading of Liu and McMillan (2006): PCA of segments, adaptive key frames with "
    "cubic splines; on channels weighted by what they move, not on markers, and with no "
    "special care of the feet.",
    &coder_of<LiuMcMillanCoder>, &decode_liu_mcmillan};

}  // namespace mocapress
