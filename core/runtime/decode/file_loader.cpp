// SPDX-License-Identifier: MIT
#include "core/runtime/decode/file_loader.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <new>

#include "core/runtime/format/coded_motion.h"
#include "core/runtime/format/double_precision_limits.h"
#include "core/runtime/format/joint_orders.h"
#include "core/runtime/format/joint_records.h"
#include "core/runtime/format/turned_axes.h"

namespace mocapress::runtime {
namespace {

constexpr std::uint64_t kBudget = 20;  // size up to which the resident motion may have dense bands
                                       // for speed, in tenths of the coded motion

}  // namespace

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
      coded_motion_(memory.take<std::uint8_t>(
          sections.segments.count() > 1 || sections.tiers_read > 0 ? sections.coded_size() : 0)),
      segments_(memory.take<Segment>(static_cast<std::uint64_t>(sections.segments.count()))),
      step_exponents_(memory.take<std::int32_t>(sections.signal_count())),
      values_(memory.take<std::int32_t>(static_cast<std::uint64_t>(sections.segments.length) *
                                        sections.signal_count())),
      steps_(memory.take<float>(sections.signal_count())),
      double_precision_limits_(memory.take<float>(sections.signal_count())),
      reach_(memory.take<float>(sections.joints)),
      ends_(memory.take<float>(sections.ends_bytes > 0
                                   ? static_cast<std::uint64_t>(sections.end_reaches.count()) *
                                         sections.channels
                                   : 0)),
      notes_(memory.take<std::uint8_t>(sections.signal_count())),
      joint_coder_(memory),
      neighbour_finder_(memory, static_cast<int>(sections.joints)),
      coder_notes_(memory, Bands(sections.segments.length),
                   static_cast<int>(sections.signal_count())),
      limb_planner_(memory, static_cast<int>(sections.joints)),
      tracks_(memory, sections, joint_coder_) {}

mcpr_result FileLoader::read() {
  for (const auto step : {&FileLoader::read_joints, &FileLoader::order_angles_of_joints,
                          &FileLoader::turn_axes_of_joints, &FileLoader::plan_limbs,
                          &FileLoader::read_tracks, &FileLoader::read_motion}) {
    const mcpr_result result = (this->*step)();
    if (failed(result)) return result;
  }
  mark = kMark;
  return kOk;
}

mcpr_result FileLoader::read_joints() {
  const mcpr_result result = decode_joint_bytes(sections_, joint_coder_, joint_bytes_);
  if (failed(result)) return result;
  name_bytes_ = 0;
  return runtime::read_joints(sections_, joint_bytes_, depths_,
                              [&](int j, const JointRecord& record) {
                                joints_[j] = record.model;
                                joints_[j].name = name_bytes_;
                                parents_[j] = static_cast<std::int16_t>(record.model.parent);
                                channel_counts_[j] = record.model.channels;
                                name_bytes_ += record.name_length + 1U;
                              });
}

mcpr_result FileLoader::order_angles_of_joints() {
  if (sections_.joint_orders.size == 0) return kOk;
  JointOrders orders(sections_.joint_orders);
  for (std::uint32_t j = 0; j < sections_.joints; ++j)
    if (turns_about_three_axes(joints_[j].kinds, joints_[j].channels))
      set_order(orders.next(), joints_[j].kinds, joints_[j].channels);
  return orders.finish();
}

mcpr_result FileLoader::turn_axes_of_joints() {
  return read_turned_axes(
      sections_.axes, static_cast<int>(sections_.joints),
      [&](int j) { return may_turn_axes(joints_[j]); },
      [&](int j, const TurnedAxes& turned) { turn_axes(turned, joints_[j]); });
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
  find_double_precision_limits();
  if (sections_.segments.count() > 1 || sections_.tiers_read > 0) {
    sections_.copy_coded(coded_motion_);
    sections_.motion.data = coded_motion_;
  }
  std::size_t first_byte = 0;
  EndReader ends(sections_.coded_ends);
  for (int k = 0; k < sections_.segments.count(); ++k) {
    segments_[k] = {first_byte, sections_.segment_size(k), 0};
    const mcpr_result result = read_segment(k);
    if (failed(result)) return result;
    if (k == 0) read_ends(ends, kFirstPose);
    if (k == sections_.segments.count() - 1) read_ends(ends, kLastPose);
    segments_[k].resident_bytes = ResidentSignals::size(source(k));
    first_byte += segments_[k].bytes;
  }
  if (sections_.ends_bytes > 0)
    if (const mcpr_result result = ends.finish(); failed(result)) return result;
  return kOk;
}

/// Reads the end correction of a pose. After that of the last pose, reads that of the velocity, if
/// there is one.
void FileLoader::read_ends(EndReader& ends, int pose) {
  const EndReaches& reaches = sections_.end_reaches;
  if (!reaches.any()) return;
  read_end(ends, pose);
  if (pose == kLastPose && reaches.count() > kVelocity) read_end(ends, kVelocity);
}

/// Reads one end correction. Its unit is the quantisation step of the segment that was decoded
/// last.
void FileLoader::read_end(EndReader& ends, int end) {
  const std::uint32_t channels = sections_.channels;
  const int step_exponent = sections_.end_step_exponent[end];
  for (std::uint32_t c = 0; c < channels; ++c)
    ends_[static_cast<std::uint32_t>(end) * channels + c] =
        end_value(ends.next(), steps_[c], step_exponent);
}

/// Decodes a segment, unless it is the one that was decoded last.
mcpr_result FileLoader::read_segment(int segment) {
  if (segment == decoded_) return kOk;
  const Segment& coded = segments_[segment];
  decoded_ = segment;
  mcpr_result result =
      decode_segment(segment, {sections_.motion.data + coded.first_byte, coded.bytes});
  if (failed(result)) result.offset = sections_.offset_of(segment, result.offset);
  return result;
}

mcpr_result FileLoader::decode_segment(int segment, const Bytes& coded) {
  const int frames = sections_.segments.frames_of(segment);
  const auto signal_count = static_cast<int>(sections_.signal_count());
  const Bands bands(frames);
  const QuantisedView view{frames, signal_count, step_exponents_, values_};
  CoefficientModel model(signal_count, contexts_);
  float scale = 0;
  const mcpr_result result =
      decode_coefficients(coded, neighbours_, bands, model, view, coder_notes_, scale,
                          sections_.learned, sections_.bands_left_out());
  if (failed(result)) return result;
  for (int s = 0; s < signal_count; ++s)
    steps_[s] = static_cast<float>(step_of(step_exponents_[s], scale));
  return kOk;
}

void FileLoader::find_double_precision_limits() {
  std::fill_n(double_precision_limits_, sections_.signal_count(), kDoublePrecisionLength);
  find_reach(joints_, static_cast<int>(sections_.joints), reach_);
  for (std::uint32_t j = 0; j < sections_.joints; ++j)
    for (int c = 0; c < joints_[j].channels; ++c)
      double_precision_limits_[joints_[j].first_channel + c] =
          double_precision_limit(joints_[j].kinds[c], reach_[j]);
}

/// The quantised coefficients of the segment that was decoded last, from which its resident form is
/// made.
QuantisedSource FileLoader::source(int segment) const {
  const std::uint64_t bytes =
      segments_[segment].bytes + (sections_.segments.count() == 1 ? sections_.correction_bytes : 0);
  return {.length = sections_.segments.frames_of(segment),
          .signal_count = static_cast<int>(sections_.signal_count()),
          .wavelet = sections_.wavelet,
          .steps = steps_,
          .double_precision_limits = double_precision_limits_,
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
  BlockLayout block(memory);
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
    head.end_reaches = sections_.end_reaches;
    const std::size_t values =
        static_cast<std::size_t>(head.end_reaches.count()) * head.channel_count;
    head.ends = block.reserve(values * sizeof(float));
    if (memory != nullptr) std::copy_n(ends_, values, block.at<float>(head.ends));
  }
  head.tracks = tracks_.lay_out(block, head.loop);
  lay_out_motion(block, head, memory);
  head.total_bytes = block.used();
  if (memory != nullptr) new (memory) mcpr_clip{head};
  return block.used();
}

void FileLoader::lay_out_motion(BlockLayout& block, ClipBlock& head, std::byte* memory) {
  head.segments = sections_.segments;
  head.largest = {sections_.segments.length, static_cast<int>(sections_.signal_count()), 0};
  const auto segments = static_cast<std::uint64_t>(sections_.segments.count());
  head.motions = block.reserve(sizeof(std::uint32_t) * segments);
  for (int k = 0; k < sections_.segments.count(); ++k) {
    const std::uint32_t offset = block.reserve(segments_[k].resident_bytes);
    if (memory == nullptr) continue;
    read_segment(k);  // cannot fail: read_motion() has already decoded this segment
    block.at<std::uint32_t>(head.motions)[k] = offset;
    const auto* const motion = ResidentSignals::build(source(k), memory + offset);
    head.largest.double_precision_count =
        std::max(head.largest.double_precision_count, motion->shape().double_precision_count);
  }
}

/// Finds the scratch memory for the FileLoader object and the arrays that it takes.
mcpr_result find_read_bytes(const FileSections& sections, const mcpr_limits& limits,
                            std::uint64_t& bytes) {
  if (!sections.is_adaptive())
    return failure(MCPR_UNSUPPORTED, sections.motion.offset, "the coding is not adaptive");
  Memory memory;
  memory.take<FileLoader>(1);
  const FileLoader measured(memory, sections);
  bytes = memory.used();
  if (bytes > limits.scratch_bytes)
    return failure(MCPR_LIMIT, 0, "reading takes more scratch memory than the limits allow");
  return kOk;
}

mcpr_info info_of(const FileSections& sections, std::uint64_t read_bytes) {
  const bool is_whole = sections.bands_left_out() == 0;
  const Tier& last = sections.tiers.tier[std::max(sections.tiers_read, 1) - 1];
  const float error = is_whole ? sections.eps_cm : last.eps_cm;
  const float max_error = is_whole ? sections.max_error_cm : last.max_error_cm;
  return {.sample_rate = sections.sample_rate,
          .frames = sections.frames,
          .joints = sections.joints,
          .channels = sections.channels,
          .effectors = sections.effectors,
          .motion_bytes = sections.motion_bytes(),
          .read_bytes = static_cast<std::size_t>(read_bytes),
          .error = error > 0 ? error : 0,
          .max_error = max_error > 0 ? max_error : 0,
          .tiers = static_cast<std::uint32_t>(std::max(sections.tiers.count, 1))};
}

mcpr_result read_into(const FileSections& sections, std::uint64_t read_bytes,
                      const mcpr_limits& limits, void* scratch, std::size_t scratch_size,
                      std::size_t& resident_bytes) {
  mcpr_result result = check_memory(scratch, scratch_size, read_bytes, "too little scratch memory");
  if (failed(result)) return result;
  Memory memory(scratch, scratch_size);
  auto* const opening = new (memory.take<FileLoader>(1)) FileLoader(memory, sections);
  opening->solver_iterations = limits.solver_iterations;
  if (failed(result = opening->read())) return result;
  const std::uint64_t resident = opening->resident_size();
  if (resident > limits.resident_bytes || resident > std::numeric_limits<std::uint32_t>::max())
    return failure(MCPR_LIMIT, 0, "the resident form takes more memory than the limits allow");
  resident_bytes = static_cast<std::size_t>(resident);
  return kOk;
}

}  // namespace mocapress::runtime
