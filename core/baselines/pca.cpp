// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", section 3.2. METHODS.md
// defines the bytes.
#include "core/baselines/rivals.h"

#include <algorithm>

#include "core/base/byte_cursor.h"
#include "core/baselines/principal_components.h"
#include "core/baselines/series16.h"
#include "core/codec/format/deflate.h"

namespace mocapress {
namespace {

/// The channels of a skeleton in two parts: the pose (angles), which is analysed, and the
/// translations, which are stored as they are.
struct Split {
  std::vector<int> angles;
  std::vector<int> translations;

  explicit Split(const Skeleton& skeleton) {
    for (int c = 0; c < skeleton.channel_count(); ++c)
      (is_rotation(skeleton.channel_kind(c)) ? angles : translations).push_back(c);
  }
  int most_components(int frames) const {
    return std::min(static_cast<int>(angles.size()), std::max(frames - 1, 0));
  }
};

class PcaCoder : public DetailCoder {
 public:
  PcaCoder(const Motion& motion, Weighting) {
    const Split split(motion.skeleton);
    translations_ = motion.clip.channels(Eigen::all, split.translations);
    pose_ = principal_components(motion.clip.channels(Eigen::all, split.angles));
  }

  int most_detail() const override { return pose_.count(); }

  std::vector<std::byte> encode(int detail) const override {
    ByteWriter writer;
    writer.write(static_cast<std::uint16_t>(detail));
    write_series16(writer, pose_.mean);
    write_series16(writer, pose_.basis.leftCols(detail).reshaped());
    write_series16(writer, pose_.projections.leftCols(detail).reshaped());
    for (const auto& channel : translations_.colwise()) write_series16(writer, channel);
    return deflate_bytes(writer.bytes());
  }

 private:
  PrincipalComponents pose_;
  Eigen::MatrixXd translations_;
};

std::size_t most_pca_bytes(const Split& split, int frames) {
  const std::size_t angles = split.angles.size();
  const auto components = static_cast<std::size_t>(split.most_components(frames));
  return sizeof(std::uint16_t) + series16_bytes(angles) + series16_bytes(angles * components) +
         series16_bytes(static_cast<std::size_t>(frames) * components) +
         split.translations.size() * series16_bytes(static_cast<std::size_t>(frames));
}

Clip decode_pca(const Skeleton& skeleton, double sample_rate_hz, int frames,
                std::span<const std::byte> motion) {
  const Split split(skeleton);
  const auto bytes = inflate_bytes(motion, most_pca_bytes(split, frames));
  ByteReader reader(bytes);
  const int components = reader.read<std::uint16_t>();
  if (components > split.most_components(frames)) reader.fail("more components than possible");
  const auto angles = static_cast<Eigen::Index>(split.angles.size());
  const Eigen::VectorXd mean = read_series16(reader, angles);
  const Eigen::VectorXd basis = read_series16(reader, angles * components);
  const Eigen::VectorXd projections = read_series16(reader, Eigen::Index{frames} * components);

  Clip clip{sample_rate_hz, Eigen::MatrixXd(frames, skeleton.channel_count())};
  for (const int c : split.translations) clip.channels.col(c) = read_series16(reader, frames);
  reader.expect_end();
  const Eigen::MatrixXd poses =
      (projections.reshaped(frames, components) * basis.reshaped(angles, components).transpose())
          .rowwise() +
      mean.transpose();
  clip.channels(Eigen::all, split.angles) = poses;
  return clip;
}

}  // namespace

constinit const ComparisonMethod kPca{
    "pca", "PCA",
    "Principal components of the poses without the root's position, everything in 16 bits, "
    "DEFLATE: the paper's section 3.2.",
    &coder_of<PcaCoder>, &decode_pca};

}  // namespace mocapress
