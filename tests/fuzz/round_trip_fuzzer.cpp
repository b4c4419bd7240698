// SPDX-License-Identifier: MIT
// Makes a motion of any bytes and encodes it. The result can be written, read and decoded again, to
// the same motion that was measured.
#include <algorithm>
#include <cstdlib>

#include "core/base/error.h"
#include "core/codec/decode/decoder.h"
#include "core/codec/encode/encoder.h"
#include "core/codec/format/container.h"

namespace {

using namespace mocapress;

/// Returns bytes one after the other, and zeros after the last.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : next_(data), left_(size) {}
  int operator()() {
    if (left_ == 0) return 0;
    --left_;
    return *next_++;
  }

 private:
  const std::uint8_t* next_;
  std::size_t left_;
};

Motion motion_of(Bytes& bytes) {
  Motion motion;
  const int joints = 1 + bytes() % 6;
  for (int j = 0; j < joints; ++j) {
    Joint joint{.name = std::string(1, static_cast<char>('a' + j)),
                .parent = j == 0 ? -1 : bytes() % j,
                .offset = Eigen::Vector3d(bytes(), bytes(), bytes()) / 8};
    if (bytes() % 4 == 0) joint.end_site = Eigen::Vector3d(0, bytes(), 1);
    const int first = bytes();
    for (int c = bytes() % 4; c > 0; --c)
      joint.channels.push_back(static_cast<ChannelKind>(
          j == 0 && first % 2 == 0 ? (first + c) % 3 : 3 + (first + c) % 3));
    motion.skeleton.add(std::move(joint));
  }
  const int frames = bytes() % 80;
  const double size = bytes() % 2 == 0 ? 0.02 : 4;
  motion.clip.channels.resize(frames, motion.skeleton.channel_count());
  for (double& value : motion.clip.channels.reshaped()) value = size * (bytes() - 128);
  return motion;
}

EncodeSettings options_of(Bytes& bytes) {
  constexpr Method kMethods[] = {Method::Standard, Method::PerChannel, Method::Annealed,
                                 Method::ClosedLoop};
  constexpr Coding kCodings[] = {Coding::Rle16, Coding::Deflate, Coding::Adaptive};
  constexpr Basis kBases[] = {Basis::Haar, Basis::Linear, Basis::Cubic};
  EncodeSettings options{.method = kMethods[bytes() % 4],
                         .coding = kCodings[bytes() % 3],
                         .basis = kBases[bytes() % 3],
                         .weighting = Weighting::BoneEnds,
                         .target = {Target::Kind::CoefficientRatio, 1.0 + bytes() % 32}};
  options.effort = bytes() % 2 == 0 ? Effort::Draft : Effort::Default;
  return options;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  const EncodeSettings options = options_of(bytes);
  const Encoder encoder(motion_of(bytes));
  Encoding encoding;
  try {
    encoding = encoder.encode(options);
  } catch (const Error&) {  // the target is out of reach
    return 0;
  }
  const CompressedClip read = read_container(write_container(encoding.compressed));
  if (decode(read).channels != encoding.decoded.channels) std::abort();
  return 0;
}
