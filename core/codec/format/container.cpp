// SPDX-License-Identifier: MIT
#include "core/codec/format/container.h"

#include <algorithm>
#include <optional>

#include "core/base/byte_cursor.h"
#include "core/codec/format/axes_section.h"
#include "core/codec/format/format_error.h"
#include "core/codec/format/room.h"
#include "core/codec/format/section_writer.h"
#include "core/codec/format/skeleton_section.h"
#include "core/runtime/format/coded_error.h"
#include "core/runtime/format/format_limits.h"
#include "core/runtime/mocapress_runtime.hpp"

namespace mocapress {
namespace {

constexpr std::string_view kEnds = "ENDS";
constexpr std::string_view kLoop = "loop";
constexpr std::string_view kOrders = "ordr";

constexpr auto kNoCoding = static_cast<Coding>(0);  // for comparison methods
constexpr auto kNoMethod = static_cast<Method>(0);

std::vector<std::byte> write_description(const Container& container) {
  const CompressedClip& clip = container.clip;
  const bool wavelets = !container.of_comparison;
  ByteWriter writer;
  writer.write(clip.sample_rate_hz);
  writer.write(static_cast<std::uint32_t>(clip.frames));
  writer.write(static_cast<std::uint8_t>(wavelets ? clip.basis : Basis{}));
  writer.write(static_cast<std::uint8_t>(wavelets ? clip.coding : kNoCoding));
  writer.write(static_cast<std::uint8_t>(wavelets ? clip.provenance.method : kNoMethod));
  writer.write(static_cast<std::uint8_t>(clip.provenance.weighting));
  writer.write(clip.provenance.seed);
  writer.write(runtime::rounded_error(clip.provenance.eps_cm));
  writer.write(runtime::rounded_error(clip.provenance.max_error_cm));
  return writer.release();
}

std::vector<std::byte> write_correction(const CodedCorrection& correction) {
  ByteWriter writer;
  writer.write(static_cast<std::uint8_t>(correction.solver));
  writer.write(static_cast<std::uint8_t>(correction.effectors.size()));
  for (const Effector& effector : correction.effectors) {
    writer.write(static_cast<std::uint16_t>(effector.joint));
    writer.write(static_cast<std::uint16_t>(effector.chain.front()));
  }
  return writer.release();
}

CodedCorrection read_correction(const runtime::FileSections& sections, const Skeleton& skeleton) {
  CodedCorrection correction{sections.solver, {}};
  try {
    for (std::uint32_t e = 0; e < sections.effectors; ++e)
      correction.effectors.push_back(
          effector_between(skeleton, sections.effector[e].top, sections.effector[e].joint));
    check_effectors(skeleton, correction.effectors);
  } catch (const FormatError&) {
    throw;
  } catch (const Error& error) {
    throw FormatError(sections.effector_offset, error.what());
  }
  return correction;
}

std::vector<std::byte> write_segments(const CodedSegments& segments) {
  ByteWriter writer;
  writer.write(static_cast<std::uint32_t>(segments.length));
  writer.write(static_cast<std::uint32_t>(segments.overlap));
  writer.write(static_cast<std::uint32_t>(segments.bytes.size()));
  for (const std::uint32_t bytes : segments.bytes) writer.write(bytes);
  return writer.release();
}

CodedSegments read_segments(const runtime::FileSections& sections) {
  CodedSegments segments{sections.segments.length, sections.segments.overlap, {}};
  for (int k = 0; k < sections.segments.count(); ++k)
    segments.bytes.push_back(sections.segment_size(k));
  return segments;
}

bool turns_axes(const CompressedClip& clip) {
  return std::ranges::any_of(clip.forms,
                             [](const RotationForm& form) { return form.has_fixed_turns(); });
}

/// Returns whether any joint's angles are coded in another order than the source has.
bool reorders(const CompressedClip& clip) {
  if (clip.forms.empty()) return false;
  const RotationForms source = rotation_forms(clip.skeleton);
  return !std::equal(
      source.begin(), source.end(), clip.forms.begin(), clip.forms.end(),
      [](const RotationForm& a, const RotationForm& b) { return a.order == b.order; });
}

/// The source's rotation orders of joints that turn freely: one for all, or one for each.
std::vector<std::byte> write_orders(const Skeleton& source) {
  std::vector<std::byte> orders;
  for (const Joint& joint : source.joints())
    if (turns_freely(joint)) orders.push_back(static_cast<std::byte>(rotation_order(joint)));
  if (std::ranges::adjacent_find(orders, std::not_equal_to<>()) == orders.end())
    orders.resize(std::min<std::size_t>(orders.size(), 1));
  return orders;
}

RotationForms read_orders(const runtime::Bytes& payload, const Skeleton& coded) {
  runtime::Cursor cursor = payload.cursor();
  const bool all_alike = payload.size == 1;
  RotationForms orders = rotation_forms(coded);
  std::optional<RotationOrder> last;
  for (int j = 0; j < coded.joint_count(); ++j) {
    if (!turns_freely(coded.joint(j))) continue;
    if (!last || !all_alike) {
      const auto order = cursor.read<std::uint8_t>();
      if (order > static_cast<std::uint8_t>(RotationOrder::Zyx))
        throw FormatError(payload.offset, "unknown order of rotations");
      last = static_cast<RotationOrder>(order);
    }
    orders[j].order = *last;
  }
  if (cursor.failed() || !cursor.at_end())
    throw FormatError(payload.offset, "ordr has the wrong size");
  return orders;
}

std::string_view motion_tag(const Container& container) {
  return container.of_comparison ? "COMP" : "MOTN";
}

/// Samples of all segments. A clip without signals counts as one signal.
std::uint64_t sample_count(const CompressedClip& clip) {
  const int signals =
      clip.skeleton.channel_count() + (clip.correction ? clip.correction->signal_count() : 0);
  return static_cast<std::uint64_t>(clip.segment_layout().coded_frames()) *
         static_cast<std::uint64_t>(std::max(signals, 1));
}

}  // namespace

std::vector<std::byte> write_container(const CompressedClip& clip) {
  return write_container(Container{clip});
}

std::vector<std::byte> write_container(const Container& container) {
  const CompressedClip& clip = container.clip;
  if (clip.likely_bytes) throw Error("the motion to be written is not coded yet");
  if (clip.bands_left_out > 0) throw Error("the motion to be written lacks its finest bands");
  check_room({clip.skeleton, clip.sample_rate_hz, clip.segment_layout(),
              clip.correction ? static_cast<int>(clip.correction->effectors.size()) : 0});
  ByteWriter file;
  const int sections = 3 + (clip.segments ? 1 : 0) + (clip.correction ? 1 : 0) +
                       (clip.ends ? 1 : 0) + (clip.loop != Loop::None ? 1 : 0) +
                       (turns_axes(clip) ? 1 : 0) + (reorders(clip) ? 1 : 0);
  write_head(file, static_cast<std::uint16_t>(sections));
  write_section(file, "JNTS", write_joints(clip.coded_skeleton()));
  write_section(file, "CLIP", write_description(container));
  if (clip.segments) write_section(file, "SEGS", write_segments(*clip.segments));
  write_section(file, motion_tag(container), clip.motion);
  if (clip.correction) write_section(file, "IKCO", write_correction(*clip.correction));
  if (clip.ends) write_section(file, kEnds, clip.ends->write());
  if (turns_axes(clip)) write_section(file, kAxes, write_axes(clip.skeleton, clip.forms));
  if (clip.loop != Loop::None)
    write_section(file, kLoop, std::vector{static_cast<std::byte>(clip.loop)});
  if (reorders(clip)) write_section(file, kOrders, write_orders(clip.skeleton));
  check_room(sample_count(clip), file.bytes().size());
  return file.release();
}

namespace {

void read_description(const runtime::FileSections& sections, Container& container) {
  CompressedClip& clip = container.clip;
  clip.sample_rate_hz = sections.sample_rate;
  clip.frames = static_cast<int>(sections.frames);
  container.of_comparison = sections.coding == runtime::kComparison;
  if (!container.of_comparison) {
    clip.basis = sections.wavelet;
    clip.coding = static_cast<Coding>(sections.coding);
    clip.provenance.method = static_cast<Method>(sections.method);
  }
  clip.provenance.weighting = static_cast<Weighting>(sections.weighting);
  clip.provenance.seed = sections.seed;
  clip.provenance.eps_cm = sections.eps_cm;
  clip.provenance.max_error_cm = sections.max_error_cm;
}

}  // namespace

runtime::FileSections sections_of(std::span<const std::byte> bytes, int tiers) {
  runtime::FileSections sections;
  mcpr_limits limits = mcpr::default_limits();
  limits.tiers = static_cast<std::uint32_t>(tiers);
  require(runtime::read_sections(bytes.data(), bytes.size(), limits, sections));
  return sections;
}

Container read_any_container(std::span<const std::byte> bytes, int tiers) {
  const runtime::FileSections sections = sections_of(bytes, tiers);
  Container container;
  CompressedClip& clip = container.clip;
  read_description(sections, container);
  clip.skeleton = read_joints(sections);
  if (sections.segments_bytes > 0) clip.segments = read_segments(sections);
  clip.motion.resize(sections.coded_size());
  sections.copy_coded(reinterpret_cast<std::uint8_t*>(clip.motion.data()));
  clip.bands_left_out = sections.bands_left_out();
  if (sections.effectors > 0) clip.correction = read_correction(sections, clip.skeleton);
  if (sections.ends_bytes > 0) clip.ends = read_ends(sections);
  clip.loop = static_cast<Loop>(sections.loop);
  if (sections.axes.data != nullptr || sections.orders.data != nullptr) {
    clip.forms = rotation_forms(clip.skeleton);
    read_axes(sections.axes, clip.skeleton, clip.forms);
  }
  if (sections.orders.data != nullptr)
    clip.skeleton = with_forms(clip.skeleton, read_orders(sections.orders, clip.skeleton));
  return container;
}

CompressedClip read_container(std::span<const std::byte> bytes, int tiers) {
  Container container = read_any_container(bytes, tiers);
  if (container.of_comparison)
    throw FormatError(sections_of(bytes, tiers).motion.offset,
                      "not a wavelet clip: it was made by a comparison method (section COMP)");
  return std::move(container.clip);
}

}  // namespace mocapress
