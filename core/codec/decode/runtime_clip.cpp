// SPDX-License-Identifier: MIT
#include "core/codec/decode/runtime_clip.h"

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

#include "core/codec/format/format_error.h"

namespace mocapress {
namespace {

constexpr mcpr_request kCorrected{.output = MCPR_CHANNELS, .apply_ik = 1};

bool is_joint(const mcpr_joint& found, const Joint& joint) {
  const auto is_place = [](const float(&place)[3], const Eigen::Vector3d& expected) {
    return Eigen::Map<const Eigen::Vector3f>(place) == expected.cast<float>();
  };
  return std::strcmp(found.name, joint.name.c_str()) == 0 && found.parent == joint.parent &&
         std::equal(found.kinds, found.kinds + found.channels, joint.channels.begin(),
                    joint.channels.end(),
                    [](std::uint8_t kind, ChannelKind expected) {
                      return static_cast<ChannelKind>(kind) == expected;
                    }) &&
         is_place(found.offset, joint.offset) &&
         (found.has_end_site != 0) == joint.end_site.has_value() &&
         (!joint.end_site || is_place(found.end_site, *joint.end_site));
}

}  // namespace

RuntimeClip::RuntimeClip(std::span<const std::byte> file, int tiers) {
  mcpr_limits limits = mcpr::default_limits();
  limits.tiers = static_cast<std::uint32_t>(tiers);
  auto loaded = mcpr::load(file, &limits);
  require(loaded.result);
  clip_ = std::move(*loaded);
  scratch_.emplace(mcpr_scratch_bytes(get(), &kCorrected));
}

bool RuntimeClip::has_joints_of(const Skeleton& skeleton) const {
  if (info().joints != static_cast<std::uint32_t>(skeleton.joint_count())) return false;
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    mcpr_joint found;
    mcpr_result result;
    mcpr_clip_joint(get(), static_cast<std::uint32_t>(j), &found, &result);
    require(result);
    if (!is_joint(found, skeleton.joint(j))) return false;
  }
  return true;
}

Eigen::MatrixXd RuntimeClip::frames(int first, int count) const {
  const std::size_t columns = mcpr_frame_values(get(), &kCorrected);
  std::vector<float> rows(columns * static_cast<std::size_t>(count));
  mcpr_result result;
  mcpr_decode_frames(get(), &kCorrected, static_cast<std::uint32_t>(first),
                     static_cast<std::uint32_t>(count), rows.data(), scratch_->data(),
                     scratch_->size(), &result);
  require(result);
  using Rows = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const Rows>(rows.data(), count, static_cast<Eigen::Index>(columns))
      .cast<double>();
}

}  // namespace mocapress
