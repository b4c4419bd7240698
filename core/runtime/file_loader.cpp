// SPDX-License-Identifier: MIT
#include "core/runtime/file_loader.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <new>

#include "core/codec/format/format_limits.h"
#include "core/codec/format/joint_records.h"
#include "core/codec/format/turned_axes.h"
#include "core/codec/format/wide_limits.h"

namespace mocapress::runtime {
namespace {

constexpr std::uint64_t kBudget = 20;  // tenths of the motion in the file, for its resident form

float step_of(float scale, int step_exponent) {
  const double whole = std::ldexp(static_cast<double>(scale), -(step_exponent >> 1));
  return static_cast<float>(step_exponent % 2 == 0 ? whole : whole * 0x1.6a09e667f3bcdp-1);
}

}  // namespace

/// Places things at the end of a block, or only measures it.
class FileLoader::Block {
 public:
  explicit Block(std::byte* memory) : memory_(memory) {}

  std::uint32_t reserve(std::uint64_t bytes) {
    used_ = (used_ + 7) / 8 * 8;
    const std::uint64_t at = used_;
    used_ += bytes;
    return static_cast<std::uint32_t>(at);
  }
  template <typename T>
  T* at(std::uint32_t offset) const {
    return memory_ == nullptr ? nullptr : reinterpret_cast<T*>(memory_ + offset);
  }
  std::uint64_t used() const { return used_; }

 private:
  std::byte* memory_;
  std::uint64_t used_ = 0;
};

FileLoader::FileLoader(Memory& memory, const FileSections& sections)
    : sections_(sections),
      joint_bytes_(memory.take<std::uint8_t>(sections.joint_bytes)),
      joints_(memory.take<JointModel>(sections.joints)),
      parents_(memory.take<std::int16_t>(sections.joints)),
      channel_counts_(memory.take<std::uint8_t>(sections.joints)),
      depths_(memory.take<std::uint16_t>(sections.joints)),
      neighbours_(memory.take<SignalNeighbours>(sections.signal_count())),
      contexts_(memory.take<AdaptiveBit>(static_cast<std::uint64_t>(
          ContextLayout(static_cast<int>(sections.signal_count())).end))),
      coded_motion_(
          memory.take<std::uint8_t>(sections.segments.count() > 1 ? sections.motion.size : 0)),
      segments_(memory.take<Segment>(static_cast<std::uint64_t>(sections.segments.count()))),
      step_exponents_(memory.take<std::int32_t>(sections.signal_count())),
      values_(memory.take<std::int32_t>(static_cast<std::uint64_t>(sections.segments.length) *
                                        sections.signal_count())),
      steps_(memory.take<float>(sections.signal_count())),
      wide_limits_(memory.take<float>(sections.signal_count())),
      reach_(memory.take<float>(sections.joints)),
      ends_(memory.take<float>(sections.ends_bytes > 0 ? 2 * std::uint64_t{sections.channels} : 0)),
      notes_(memory.take<std::uint8_t>(sections.signal_count())),
      joint_coder_(memory),
      neighbour_finder_(memory, static_cast<int>(sections.joints)),
      coder_notes_(memory, Bands(sections.segments.length),
                   static_cast<int>(sections.signal_count())),
      limb_planner_(memory, static_cast<int>(sections.joints)) {}

mcpr_result FileLoader::read() {
  for (const auto step : {&FileLoader::read_joints, &FileLoader::turn_axes_of_joints,
                          &FileLoader::plan_limbs, &FileLoader::read_motion}) {
    const mcpr_result result = (this->*step)();
    if (failed(result)) return result;
  }
  mark = kMark;
  return kOk;
}

mcpr_result FileLoader::read_joints() {
  const Bytes& coded = sections_.coded_joints;
  RangeDecoder bits(coded.data, coded.size);
  joint_coder_.run(bits, joint_bytes_, sections_.joint_bytes);
  if (bits.failed() || !bits.is_at_end())
    return failure(MCPR_INVALID, coded.offset + bits.position(), "the coded skeleton is damaged");
  return read_joint_records();
}

mcpr_result FileLoader::read_joint_records() {
  const std::size_t offset = sections_.coded_joints.offset;
  Cursor cursor(joint_bytes_, sections_.joint_bytes);
  std::uint32_t channels = 0;
  name_bytes_ = 0;
  for (int j = 0; j < static_cast<int>(sections_.joints); ++j) {
    JointRecord record;
    const mcpr_result result = read_joint(cursor, j, record);
    if (failed(result)) return failure(result.status, offset, result.message);
    const int parent = record.model.parent;
    depths_[j] = static_cast<std::uint16_t>(parent < 0 ? 1 : depths_[parent] + 1);
    if (depths_[j] > kMostDepth)
      return failure(MCPR_INVALID, offset, "joints are nested deeper than 1000");
    record.model.first_channel = static_cast<std::uint16_t>(channels);
    record.model.name = name_bytes_;
    joints_[j] = record.model;
    parents_[j] = static_cast<std::int16_t>(record.model.parent);
    channel_counts_[j] = record.model.channels;
    channels += record.model.channels;
    name_bytes_ += record.name_length + 1U;
  }
  if (!cursor.at_end()) return failure(MCPR_INVALID, offset, "bytes after the last joint");
  if (channels != sections_.channels)
    return failure(MCPR_INVALID, offset, "not as many channels as JNTS promises");
  return kOk;
}

mcpr_result FileLoader::turn_axes_of_joints() {
  const Bytes& axes = sections_.axes;
  if (axes.data == nullptr) return kOk;
  std::size_t candidates = 0;
  for (int j = 0; j < static_cast<int>(sections_.joints); ++j)
    candidates += may_turn_axes(joints_[j]) ? 1 : 0;
  Cursor cursor(axes.data, axes.size, axes.offset);
  const std::uint8_t* const flags = cursor.take((candidates + 7) / 8);
  if (cursor.failed()) return failure(MCPR_INVALID, axes.offset, "AXES is too short");
  if (candidates % 8 != 0 && flags[candidates / 8] >> (candidates % 8) != 0)
    return failure(MCPR_INVALID, axes.offset, "axes turned that are none");
  std::size_t i = 0;
  for (int j = 0; j < static_cast<int>(sections_.joints); ++j) {
    if (!may_turn_axes(joints_[j])) continue;
    const bool turned = (flags[i / 8] >> (i % 8) & 1) != 0;
    ++i;
    if (!turned) continue;
    const std::size_t offset = cursor.offset();
    TurnedAxes coded;
    if (!coded.set(cursor.read<std::uint32_t>()) || cursor.failed())
      return failure(MCPR_INVALID, offset, "axes turned that are none");
    turn_axes(coded, joints_[j]);
  }
  if (!cursor.at_end()) return failure(MCPR_INVALID, cursor.offset(), "AXES of another size");
  return kOk;
}

mcpr_result FileLoader::plan_limbs() {
  const auto count = static_cast<int>(sections_.effectors);
  for (int e = 0; e < count; ++e)
    effectors_[e] = {sections_.effector[e].joint, sections_.effector[e].top};
  if (const char* const wrong = limb_planner_.plan(joints_, effectors_, count))
    return failure(MCPR_INVALID, sections_.effector_offset, wrong);
  return kOk;
}

mcpr_result FileLoader::read_motion() {
  const auto channels = static_cast<int>(sections_.channels);
  const auto signal_count = static_cast<int>(sections_.signal_count());
  neighbour_finder_.find({static_cast<int>(sections_.joints), parents_, channel_counts_},
                         neighbours_);
  set_correction_neighbours(channels, signal_count - channels, neighbours_ + channels);
  find_wide_limits();
  std::size_t first_byte = 0;
  const Bytes& coded_ends = sections_.coded_ends;
  RangeDecoder end_bits(coded_ends.data, coded_ends.size);
  EndCoder end_coder;
  for (int k = 0; k < sections_.segments.count(); ++k) {
    segments_[k] = {first_byte, sections_.segment_size(k), 0};
    const mcpr_result result = read_segment(k);
    if (failed(result)) return result;
    if (k == 0) read_end(end_coder, end_bits, 0);
    if (k == sections_.segments.count() - 1) read_end(end_coder, end_bits, 1);
    segments_[k].resident_bytes = ResidentSignals::size(source(k));
    first_byte += segments_[k].bytes;
  }
  if (sections_.ends_bytes > 0 && (end_bits.failed() || !end_bits.is_at_end()))
    return failure(MCPR_INVALID, coded_ends.offset + end_bits.position(),
                   "the coded ends are damaged");
  // The file is done with.
  if (sections_.segments.count() > 1)
    std::copy_n(sections_.motion.data, sections_.motion.size, coded_motion_);
  sections_.motion.data = coded_motion_;
  return kOk;
}

/// In steps of the segment that was decoded last.
void FileLoader::read_end(EndCoder& coder, RangeDecoder& bits, int end) {
  if (sections_.ends_bytes == 0) return;
  const std::uint32_t channels = sections_.channels;
  const int step_exponent = sections_.end_fineness[end];
  for (std::uint32_t c = 0; c < channels; ++c)
    ends_[static_cast<std::uint32_t>(end) * channels + c] =
        end_value(coder.code(bits, 0), steps_[c], step_exponent);
}

/// Unless it is the one that was decoded last.
mcpr_result FileLoader::read_segment(int segment) {
  if (segment == decoded_) return kOk;
  const Segment& coded = segments_[segment];
  decoded_ = segment;
  return decode_segment(segment, {sections_.motion.data + coded.first_byte, coded.bytes,
                                  sections_.motion.offset + coded.first_byte});
}

mcpr_result FileLoader::decode_segment(int segment, const Bytes& coded) {
  Cursor head(coded.data, coded.size, coded.offset);
  const auto scale = std::bit_cast<float>(std::uint32_t{head.read<std::uint16_t>()} << 16);
  if (head.failed() || !std::isfinite(scale) || scale <= 0)
    return failure(MCPR_INVALID, coded.offset, "the scale of steps is no positive number");
  const int frames = sections_.segments.frames_of(segment);
  const auto signal_count = static_cast<int>(sections_.signal_count());
  std::fill_n(step_exponents_, signal_count, 0);
  std::fill_n(values_, std::int64_t{frames} * signal_count, 0);
  RangeDecoder bits(coded.data + 2, coded.size - 2);
  CoefficientModel model(signal_count, contexts_);
  model.begin();
  const Bands bands(frames);
  const QuantisedView view{frames, signal_count, step_exponents_, values_};
  CoefficientCoder(bits, neighbours_, bands, model, view, coder_notes_).run();
  const std::size_t offset = coded.offset + 2 + bits.position();
  if (bits.exhausted()) return failure(MCPR_INVALID, offset, "the coded motion ends early");
  if (bits.refused()) return failure(MCPR_INVALID, offset, "a number of the motion out of bounds");
  if (!bits.is_at_end()) return failure(MCPR_INVALID, offset, "bytes after the coded motion");
  for (int s = 0; s < signal_count; ++s) steps_[s] = step_of(scale, step_exponents_[s]);
  return kOk;
}

void FileLoader::find_wide_limits() {
  std::fill_n(wide_limits_, sections_.signal_count(), kWideLength);
  find_reach(joints_, static_cast<int>(sections_.joints), reach_);
  for (std::uint32_t j = 0; j < sections_.joints; ++j)
    for (int c = 0; c < joints_[j].channels; ++c)
      wide_limits_[joints_[j].first_channel + c] = wide_limit(joints_[j].kinds[c], reach_[j]);
}

/// Of the segment that is decoded.
QuantisedSource FileLoader::source(int segment) const {
  const std::uint64_t bytes =
      segments_[segment].bytes + (sections_.segments.count() == 1 ? sections_.correction_bytes : 0);
  return {.length = sections_.segments.frames_of(segment),
          .signal_count = static_cast<int>(sections_.signal_count()),
          .wavelet = sections_.wavelet,
          .steps = steps_,
          .wide_limits = wide_limits_,
          .values = values_,
          .notes = notes_,
          .budget_bytes = kBudget * bytes / 10};
}

std::uint64_t FileLoader::resident_size() {
  return lay_out(nullptr);
}

const mcpr_clip* FileLoader::build(std::byte* memory) {
  lay_out(memory);
  return std::launder(reinterpret_cast<const mcpr_clip*>(memory));
}

std::uint64_t FileLoader::lay_out(std::byte* memory) {
  Block block(memory);
  block.reserve(sizeof(mcpr_clip));
  ClipBlock head;
  head.joint_count = sections_.joints;
  head.channel_count = sections_.channels;
  head.effector_count = sections_.effectors;
  head.sample_rate = sections_.sample_rate;
  head.solver = sections_.solver;
  head.solver_iterations = std::min<std::uint32_t>(solver_iterations, kMostSweeps);
  head.joints = block.reserve(sizeof(JointModel) * std::uint64_t{sections_.joints});
  head.names = block.reserve(name_bytes_);
  head.skeleton_bytes = block.used() - sizeof(mcpr_clip);
  if (memory != nullptr) {
    std::copy_n(joints_, sections_.joints, block.at<JointModel>(head.joints));
    Cursor cursor(joint_bytes_, sections_.joint_bytes);
    for (int j = 0; j < static_cast<int>(sections_.joints); ++j) {
      JointRecord record;
      read_joint(cursor, j, record);
      if (record.name_length > 0)
        std::memcpy(block.at<char>(head.names) + joints_[j].name, record.name, record.name_length);
    }
  }
  head.limb_count = static_cast<std::uint16_t>(limb_planner_.limb_count());
  head.limbs = block.reserve(sizeof(ResidentLimb) * std::uint64_t{head.limb_count});
  for (int l = 0; l < head.limb_count; ++l) {
    LimbPlan plan = limb_planner_.size(l);
    head.most_links = std::max(head.most_links, static_cast<std::uint16_t>(plan.links));
    const auto room = [&](int count, std::size_t size) {
      return block.reserve(static_cast<std::uint64_t>(count) * size);
    };
    ResidentLimb limb{.effectors = static_cast<std::uint16_t>(plan.effectors),
                      .links = static_cast<std::uint16_t>(plan.links),
                      .turns = static_cast<std::uint16_t>(plan.turns),
                      .is_two_bones = 0,
                      .effector_numbers = room(plan.effectors, sizeof(std::uint16_t)),
                      .effector_links = room(plan.effectors, sizeof(std::uint16_t)),
                      .link = room(plan.links, sizeof(LimbLink)),
                      .turn = room(plan.turns, sizeof(LimbTurn))};
    if (memory == nullptr) continue;
    plan = limb_planner_.lay_out(l, {block.at<std::uint16_t>(limb.effector_numbers),
                                     block.at<std::uint16_t>(limb.effector_links),
                                     block.at<LimbLink>(limb.link), block.at<LimbTurn>(limb.turn)});
    limb.is_two_bones = plan.is_two_bones ? 1 : 0;
    block.at<ResidentLimb>(head.limbs)[l] = limb;
  }
  head.loop = sections_.loop;
  if (sections_.ends_bytes > 0) {
    std::copy_n(sections_.end_reach, 2, head.end_reach);
    const std::size_t values = std::size_t{2} * head.channel_count;
    head.ends = block.reserve(values * sizeof(float));
    if (memory != nullptr) std::copy_n(ends_, values, block.at<float>(head.ends));
  }
  lay_out_motion(block, head, memory);
  head.total_bytes = block.used();
  if (memory != nullptr) new (memory) mcpr_clip{head};
  return block.used();
}

void FileLoader::lay_out_motion(Block& block, ClipBlock& head, std::byte* memory) {
  head.segments = sections_.segments;
  head.largest = {sections_.segments.length, static_cast<int>(sections_.signal_count()), 0};
  const auto segments = static_cast<std::uint64_t>(sections_.segments.count());
  head.motions = block.reserve(sizeof(std::uint32_t) * segments);
  for (int k = 0; k < sections_.segments.count(); ++k) {
    const std::uint32_t offset = block.reserve(segments_[k].resident_bytes);
    if (memory == nullptr) continue;
    read_segment(k);  // as before, when it was found to be valid
    block.at<std::uint32_t>(head.motions)[k] = offset;
    const auto* const motion = ResidentSignals::build(source(k), memory + offset);
    head.largest.wide_count = std::max(head.largest.wide_count, motion->shape().wide_count);
  }
}

}  // namespace mocapress::runtime
