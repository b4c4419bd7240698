// SPDX-License-Identifier: MIT
// Compresses a clip as engines do, each channel by itself: leaves out channels that stand still,
// leaves out key frames where straight lines come near enough, and quantises a channel only as
// finely as it needs, like the bit rates of N. Frechette's Animation Compression Library (ACL).
// This is our own method, on channels. METHODS.md defines the bytes.
#include "core/baselines/rivals.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/byte_cursor.h"
#include "core/codec/format/deflate.h"
#include "core/select/error_model.h"

namespace mocapress {
namespace {

constexpr int kMostGap = 255;           // frames between keys: fits into a byte
constexpr double kSteps16 = 65535;      // 16-bit steps from a channel's least to its greatest value
constexpr std::size_t kHeadBytes = 12;  // of each channel

/// The body's average movement, in cm, for a change of each channel by a radian (or a cm).
Eigen::VectorXd moved_by_channels(const Motion& motion, Weighting weighting) {
  constexpr double kLeast = 1;  // so that no channel is lost altogether
  const ErrorModel model(motion.skeleton, motion.clip, weighting);
  Eigen::VectorXd moved(motion.skeleton.channel_count());
  for (Eigen::Index c = 0; c < moved.size(); ++c) {
    const auto curvature = model.curvature().col(c);
    const double mean = curvature.size() > 0 ? curvature.mean() : 0;
    moved[c] = std::sqrt(std::max(mean, kLeast * kLeast));  // rounding may make the mean negative
  }
  return moved;
}

/// Returns key frames between which straight lines stay within `tolerance` of the curve. Each key
/// is as far from the previous one as possible: the slopes that pass all frames between them form a
/// cone, which narrows until it is empty.
std::vector<int> line_keys(const Eigen::Ref<const Eigen::VectorXd>& curve, double tolerance) {
  std::vector<int> keys{0};
  const auto last = static_cast<int>(curve.size()) - 1;
  while (keys.back() < last) {
    const int from = keys.back();
    double lowest = -std::numeric_limits<double>::infinity();
    double highest = -lowest;
    int next = from + 1;
    for (int t = from + 1; t <= std::min(last, from + kMostGap); ++t) {
      const double run = t - from;
      const double slope = (curve[t] - curve[from]) / run;
      if (lowest <= slope && slope <= highest) next = t;
      lowest = std::max(lowest, slope - tolerance / run);
      highest = std::min(highest, slope + tolerance / run);
      if (lowest > highest) break;
    }
    keys.push_back(next);
  }
  return keys;
}

class KeyFrameCoder : public DetailCoder {
 public:
  KeyFrameCoder(const Motion& motion, Weighting weighting)
      : channels_(motion.clip.channels), moved_(moved_by_channels(motion, weighting)) {}

  int most_detail() const override { return kMostDetail; }

  std::vector<std::byte> encode(int detail) const override {
    const double tolerance = tolerance_of_detail(detail);
    ByteWriter writer;
    for (Eigen::Index c = 0; c < channels_.cols(); ++c)
      if (channels_.rows() > 0) write(writer, channels_.col(c), tolerance / moved_[c]);
    return deflate_bytes(writer.bytes());
  }

 private:
  static void write(ByteWriter& writer, const Eigen::Ref<const Eigen::VectorXd>& curve,
                    double tolerance) {
    const double least = curve.minCoeff();
    const double range = curve.maxCoeff() - least;
    const bool stands = range <= tolerance;
    const auto step = static_cast<float>(stands ? 0 : std::max(tolerance, range / kSteps16));
    writer.write(static_cast<float>(stands ? least + range / 2 : least));
    writer.write(step);
    const std::vector<int> keys = stands ? std::vector<int>() : line_keys(curve, tolerance);
    writer.write(static_cast<std::uint32_t>(keys.size()));
    for (std::size_t i = 1; i < keys.size(); ++i)
      writer.write(static_cast<std::uint8_t>(keys[i] - keys[i - 1]));
    std::uint16_t before = 0;
    for (const int key : keys) {
      const auto value = static_cast<std::uint16_t>(
          std::clamp(std::round((curve[key] - least) / static_cast<double>(step)), 0.0, kSteps16));
      writer.write(static_cast<std::uint16_t>(value - before));
      before = value;
    }
  }

  Eigen::MatrixXd channels_;
  Eigen::VectorXd moved_;
};

Eigen::VectorXd read_curve(ByteReader& reader, int frames) {
  const double least = reader.read<float>();
  const double step = reader.read<float>();
  if (!std::isfinite(least) || !std::isfinite(step)) reader.fail("a value that is not finite");
  const auto count = reader.read<std::uint32_t>();
  Eigen::VectorXd curve = Eigen::VectorXd::Constant(frames, least);
  if (count == 0) return curve;
  std::vector<int> keys{0};
  for (std::uint32_t i = 1; i < count; ++i) {
    const int gap = reader.read<std::uint8_t>();
    if (gap == 0) reader.fail("two keys at one frame");
    keys.push_back(keys.back() + gap);
    if (keys.back() >= frames) reader.fail("a key after the clip's end");
  }
  if (keys.back() != frames - 1) reader.fail("no key at the clip's end");
  std::uint16_t value = 0;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    value = static_cast<std::uint16_t>(value + reader.read<std::uint16_t>());
    curve[keys[i]] = least + step * value;
    for (int t = i > 0 ? keys[i - 1] + 1 : keys[i]; t < keys[i]; ++t) {
      const double share = double(t - keys[i - 1]) / (keys[i] - keys[i - 1]);
      curve[t] = (1 - share) * curve[keys[i - 1]] + share * curve[keys[i]];
    }
  }
  return curve;
}

Clip decode_key_frames(const Skeleton& skeleton, double sample_rate_hz, int frames,
                       std::span<const std::byte> motion) {
  const auto channels = static_cast<std::size_t>(skeleton.channel_count());
  const auto bytes =
      inflate_bytes(motion, channels * (kHeadBytes + 3 * static_cast<std::size_t>(frames)));
  ByteReader reader(bytes);
  Clip clip{sample_rate_hz, Eigen::MatrixXd(frames, skeleton.channel_count())};
  for (auto channel : clip.channels.colwise())
    if (frames > 0) channel = read_curve(reader, frames);
  reader.expect_end();
  return clip;
}

}  // namespace

constinit const ComparisonMethod kKeyFrames{
    "key-frames", "Key frames per track",
    "What engines do: each channel by itself, key frames left out where a line comes within "
    "the tolerance, steps as fine as the channel needs (as ACL's bit rates), DEFLATE.",
    &coder_of<KeyFrameCoder>, &decode_key_frames};

}  // namespace mocapress
