// SPDX-License-Identifier: MIT
#include "core/codec/format/byte_costs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

#include "core/base/memory_limit.h"
#include "core/codec/format/adaptive.h"
#include "core/codec/format/container.h"
#include "core/codec/format/format_error.h"
#include "core/runtime/format/range_decoder.h"
#include "core/runtime/format/section.h"

namespace mocapress {
namespace {

/// Decodes bits and books what each one costs, for the coefficient that the coder announces by
/// about().
class CostMeter {
 public:
  static constexpr bool kWrites = false;

  /// `first_frame` and `bands` are those of the segment, `joints` has one entry for each signal.
  CostMeter(std::span<const std::byte> coded, const runtime::Bands& bands, int first_frame,
            const std::vector<int>& joints, ByteCosts& costs)
      : bits_(reinterpret_cast<const std::uint8_t*>(coded.data()), coded.size()),
        bands_(bands),
        first_frame_(first_frame),
        length_(bands.length(bands.count - 1)),
        joints_(joints),
        costs_(costs) {}

  bool code(bool bit, runtime::Probability one) {
    bit = bits_.code(bit, one);
    bits_here_ -= std::log2(static_cast<double>(bit ? one : 65536 - one) / 65536);
    return bit;
  }
  void refuse() { bits_.refuse(); }
  bool failed() const { return bits_.failed(); }

  /// The coder calls this before the bits of a value of a band, or with a `value` of -1 before bits
  /// that are about a whole band or signal.
  void about(int signal, int band, int value) {
    book();
    signal_ = signal;
    first_ = 0;
    last_ = length_;
    if (value < 0) return;
    const int shift = bands_.count - std::max(band, 1);  // a value stands for 2^shift frames
    first_ = std::min(value << shift, length_ - 1);
    last_ = std::min((value + 1) << shift, length_);
  }

  /// Books the last bits; returns the bytes of all bits.
  double finish() {
    book();
    return bytes_;
  }

 private:
  void book() {
    const double bytes = std::exchange(bits_here_, 0) / 8;
    if (bytes == 0) return;
    bytes_ += bytes;
    const double of_a_frame = bytes / (last_ - first_);
    const int joint = joints_[signal_];
    for (int from = first_frame_ + first_; from < first_frame_ + last_;) {
      const int slice = from / costs_.slice_frames;
      const int until = std::min(first_frame_ + last_, (slice + 1) * costs_.slice_frames);
      costs_.bytes(slice, joint) += of_a_frame * (until - from);
      from = until;
    }
  }

  runtime::RangeDecoder bits_;
  const runtime::Bands& bands_;
  int first_frame_;
  int length_;
  const std::vector<int>& joints_;
  ByteCosts& costs_;
  double bits_here_ = 0;  // since the last call of about()
  double bytes_ = 0;
  int signal_ = 0;
  int first_ = 0;  // frames of the segment that the bits are about
  int last_ = 1;   // the frame after these
};

/// The joint that each signal belongs to.
std::vector<int> joints_of_signals(const CompressedClip& clip) {
  std::vector<int> joints;
  for (int j = 0; j < clip.skeleton.joint_count(); ++j)
    joints.insert(joints.end(), clip.skeleton.joint(j).channels.size(), j);
  if (clip.correction)
    for (const Effector& effector : clip.correction->effectors)
      joints.insert(joints.end(), 3, effector.joint);
  return joints;
}

/// Divides the motion's bytes among joints and slices; returns their sum.
double divide(const CompressedClip& clip, ByteCosts& costs) {
  const std::vector<int> joints = joints_of_signals(clip);
  const std::vector<SignalNeighbours> neighbours = signal_neighbours(clip);
  const SegmentLayout layout = clip.segment_layout();
  constexpr std::size_t kScale = 2;  // bytes of a segment before its coded bits
  double all = 0;
  std::size_t first_byte = 0;
  for (int k = 0; k < layout.count(); ++k) {
    const std::size_t size = clip.segments ? clip.segments->bytes[k] : clip.motion.size();
    const std::span coded = std::span(clip.motion).subspan(first_byte, size);
    first_byte += size;
    runtime::Cursor scale(reinterpret_cast<const std::uint8_t*>(coded.data()), coded.size());
    QuantisedSignals values{runtime::read_scale(scale), std::vector(joints.size(), 0),
                            Eigen::MatrixXi::Zero(layout.frames_of(k), std::ssize(joints))};
    if (scale.failed()) throw FormatError(0, "the coded motion ends early");
    const runtime::Bands bands(layout.frames_of(k));
    CoefficientModel model(static_cast<int>(joints.size()));
    CostMeter meter(coded.subspan(kScale), bands, layout.first(k), joints, costs);
    code_coefficients(meter, neighbours, *model, values, clip.bands_left_out);
    if (meter.failed()) throw FormatError(0, "the coded motion ends early");
    all += meter.finish();
  }
  return all;
}

/// The name of a section for people; empty for pieces of the motion.
std::string_view part_name(std::string_view tag) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 11> kNames = {{
      {"JNTS", "skeleton"},
      {"CLIP", "description"},
      {"SEGS", "segments"},
      {"IKCO", "correction"},
      {"ENDS", "first and last pose"},
      {"AXES", "turned axes"},
      {"TIER", "tiers"},
      {"loop", "loop"},
      {"ordr", "rotation orders"},
      {"srce", "source"},
      {"trks", "tracks"},
  }};
  for (const auto& [known, name] : kNames)
    if (known == tag) return name;
  return tag == "MOTN" || tag == "COMP" ? "" : tag;
}

}  // namespace

ByteCosts byte_costs(std::span<const std::byte> mcpr, int slice_frames) {
  const Container container = read_any_container(mcpr);
  const CompressedClip& clip = container.clip;
  ByteCosts costs{.slice_frames = std::clamp(slice_frames, 1, std::max(clip.frames, 1)),
                  .file_bytes = mcpr.size()};
  const int slices = (clip.frames + costs.slice_frames - 1) / costs.slice_frames;
  const auto entries =
      static_cast<std::uint64_t>(slices) * static_cast<std::uint64_t>(clip.skeleton.joint_count());
  if (const auto why = beyond_memory_limit(entries * sizeof(double))) throw FormatError(0, *why);
  costs.bytes = Eigen::MatrixXd::Zero(slices, clip.skeleton.joint_count());

  runtime::Cursor file(reinterpret_cast<const std::uint8_t*>(mcpr.data()), mcpr.size());
  std::uint16_t sections = 0;
  require(runtime::read_head(file, sections));
  double motion = 0;
  for (int left = sections; left > 0; --left) {
    runtime::Section section;
    require(runtime::read_section(file, section));
    const std::string_view name = part_name({section.tag, 4});
    const auto bytes = static_cast<double>(section.payload.size);
    if (name.empty())
      motion += bytes;
    else
      costs.rest.push_back({std::string(name), bytes});
  }
  motion += static_cast<double>(file.left());  // the finer tiers
  const bool divides = !container.of_comparison && clip.coding == Coding::Adaptive;
  if (divides && clip.frames > 0)
    costs.rest.push_back({"scale and rounding", motion - divide(clip, costs)});
  else
    costs.rest.push_back({"motion", motion});
  costs.rest.push_back({"section heads", static_cast<double>(runtime::kFileHead +
                                                             sections * runtime::kSectionHead)});
  return costs;
}

}  // namespace mocapress
