// SPDX-License-Identifier: MIT
// Decodes any bytes as the motion of a comparison method, or sees them refused. The first three
// bytes choose method, frames and skeleton. The others are decoded twice: deflated first, so that
// mutations pass DEFLATE, and as the deflated stream itself.
#include <algorithm>
#include <cstdlib>
#include <span>

#include "core/base/error.h"
#include "core/baselines/rivals.h"
#include "core/codec/format/deflate.h"
#include "core/codec/methods/compared_file.h"

namespace {

using namespace mocapress;

/// A tree of one to eight joints; one byte decides their number and channels.
Skeleton skeleton_of(unsigned choice) {
  Skeleton skeleton;
  const auto joints = static_cast<int>(1 + choice % 8);
  for (int j = 0; j < joints; ++j) {
    Joint joint{.name = std::string(1, static_cast<char>('a' + j)),
                .parent = (j + 1) / 2 - 1,
                .offset = Eigen::Vector3d(j, 10, 0)};
    if (j % 3 == 0)
      joint.channels = {ChannelKind::TranslationX, ChannelKind::TranslationY,
                        ChannelKind::TranslationZ};
    for (unsigned axis = 0; axis < 3; ++axis)
      if ((choice >> (3 + axis) & 1) == 0 || static_cast<unsigned>(j) % 3 == axis)
        joint.channels.push_back(rotation_about(static_cast<int>(axis)));
    skeleton.add(std::move(joint));
  }
  return skeleton;
}

void open(const ComparisonMethod& method, const CompressedClip& clip) {
  const std::vector<std::byte> file = write_compared(method, clip);
  try {
    const OpenedMcpr opened = read_mcpr(file);
    if (opened.decoded.frames() != clip.frames ||
        opened.decoded.channels.cols() != clip.skeleton.channel_count())
      std::abort();
  } catch (const FormatError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (comparison_methods().empty()) add_rivals();
  if (size < 3) return 0;
  const auto methods = comparison_methods();
  const ComparisonMethod& method = *methods[data[0] % methods.size()];
  CompressedClip clip{.skeleton = skeleton_of(data[2]), .frames = data[1], .motion = {}};
  const std::span bytes = std::as_bytes(std::span(data, size)).subspan(3);
  clip.motion = deflate_bytes(bytes);
  open(method, clip);
  clip.motion = {bytes.begin(), bytes.end()};
  open(method, clip);
  return 0;
}
