// SPDX-License-Identifier: MIT
// Based on: O. Arikan, "Compression of Motion Capture Databases", 2006, which compares with
// subsampling. METHODS.md defines the bytes.
#include "core/baselines/rivals.h"

#include <algorithm>

#include "core/base/byte_cursor.h"
#include "core/baselines/series16.h"
#include "core/baselines/splines.h"
#include "core/codec/format/deflate.h"

namespace mocapress {
namespace {

std::vector<int> key_frames(int frames, int stride) {
  std::vector<int> keys;
  for (int t = 0; t + 1 < frames; t += stride) keys.push_back(t);
  if (frames > 0) keys.push_back(frames - 1);
  return keys;
}

class SubsampleCoder : public DetailCoder {
 public:
  SubsampleCoder(const Motion& motion, Weighting) : channels_(motion.clip.channels) {
    const int gaps = static_cast<int>(channels_.rows()) - 1;
    // If several strides keep the same number of frames, takes the smallest, which has the most
    // even gaps.
    for (int stride = gaps; stride > 1; --stride)
      if (kept(gaps, stride) != kept(gaps, stride - 1)) strides_.push_back(stride);
    strides_.push_back(1);
  }

  int most_detail() const override { return static_cast<int>(strides_.size()) - 1; }

  std::vector<std::byte> encode(int detail) const override {
    const int stride = strides_[detail];
    ByteWriter writer;
    writer.write(static_cast<std::uint32_t>(stride));
    const std::vector<int> keys = key_frames(static_cast<int>(channels_.rows()), stride);
    for (const auto& channel : channels_.colwise()) write_series16(writer, channel(keys));
    return deflate_bytes(writer.bytes());
  }

 private:
  static int kept(int gaps, int stride) { return (gaps + stride - 1) / stride; }

  Eigen::MatrixXd channels_;
  std::vector<int> strides_;  // in descending order
};

Clip decode_subsample(const Skeleton& skeleton, double sample_rate_hz, int frames,
                      std::span<const std::byte> motion) {
  const auto channels = static_cast<std::size_t>(skeleton.channel_count());
  const auto bytes = inflate_bytes(
      motion, sizeof(std::uint32_t) + channels * series16_bytes(static_cast<std::size_t>(frames)));
  ByteReader reader(bytes);
  const auto stride = reader.read<std::uint32_t>();
  if (stride < 1 || stride > static_cast<std::uint32_t>(std::max(frames - 1, 1)))
    reader.fail("a stride longer than the clip");
  const std::vector<int> keys = key_frames(frames, static_cast<int>(stride));
  Clip clip{sample_rate_hz, Eigen::MatrixXd(frames, skeleton.channel_count())};
  for (auto channel : clip.channels.colwise()) {
    const Eigen::VectorXd values = read_series16(reader, keys.size());
    if (frames > 0) channel = natural_spline(keys, values);
  }
  reader.expect_end();
  return clip;
}

}  // namespace

constinit const ComparisonMethod kSubsample{
    "subsample", "Frame subsampling",
    "Every s-th frame in 16 bits, DEFLATE; natural cubic splines between.",
    &coder_of<SubsampleCoder>, &decode_subsample};

}  // namespace mocapress
