// SPDX-License-Identifier: MIT
#include "core/codec/format/packed_clip_writer.h"

#include <algorithm>
#include <optional>

#include "core/base/byte_cursor.h"
#include "core/codec/format/adaptive.h"
#include "core/codec/format/container.h"
#include "core/codec/format/format_error.h"
#include "core/codec/format/section_writer.h"
#include "core/codec/format/skeleton_section.h"
#include "core/codec/format/tiers.h"
#include "core/codec/format/varint.h"
#include "core/runtime/format/coded_error.h"
#include "core/runtime/format/joint_orders.h"
#include "core/runtime/format/joint_records.h"
#include "core/runtime/mocapress_runtime.hpp"
#include "core/runtime/own_memory.h"

namespace mocapress {
namespace {

std::span<const std::byte> span_of(const runtime::Bytes& bytes) {
  return {reinterpret_cast<const std::byte*>(bytes.data), bytes.size};
}

void append(std::vector<std::byte>& to, std::span<const std::byte> bytes) {
  to.insert(to.end(), bytes.begin(), bytes.end());
}

template <typename T>
void append_number(std::vector<std::byte>& to, T number) {
  append(to, std::as_bytes(std::span(&number, 1)));
}

std::vector<std::byte> part_of(const runtime::Section& section,
                               std::span<const std::byte> payload) {
  std::vector<std::byte> part;
  append(part, std::as_bytes(std::span(section.tag)));
  append(part, payload);
  return part;
}

/// The joints of a JNTS section as bytes, in which the rotation orders can be replaced.
class JointText {
 public:
  explicit JointText(const runtime::FileSections& sections)
      : bytes_(sections.joint_bytes),
        joints_(static_cast<int>(sections.joints)),
        channels_(static_cast<int>(sections.channels)) {
    require(runtime::decode_joint_bytes(sections, *OwnMemory<runtime::JointByteCoder>(),
                                        reinterpret_cast<std::uint8_t*>(bytes_.data())));
  }

  /// Visits the channel kinds of each joint that turns freely.
  template <typename Visit>
  void visit(const Visit& visit) {
    auto* const first = reinterpret_cast<std::uint8_t*>(bytes_.data());
    runtime::Cursor cursor(first, bytes_.size());
    for (int j = 0; j < joints_; ++j) {
      runtime::JointRecord record;
      require(runtime::read_joint(cursor, j, record));
      const int channels = record.model.channels;
      std::uint8_t* const kinds = first + cursor.offset() - channels;
      if (runtime::turns_about_three_axes(kinds, channels)) visit(kinds, channels);
    }
  }

  std::vector<std::byte> payload() const { return write_joints(bytes_, joints_, channels_); }

 private:
  std::vector<std::byte> bytes_;
  int joints_;
  int channels_;
};

/// Appends errors in 2 bytes each, or in 4 where they do not fit; returns whether it took 4.
bool append_errors(std::span<const std::byte> errors, std::vector<std::byte>& to) {
  float both[2];
  std::memcpy(both, errors.data(), sizeof both);
  std::uint16_t codes[2];
  const bool are_short =
      runtime::find_error_code(both[0], codes[0]) && runtime::find_error_code(both[1], codes[1]);
  append(to, are_short ? std::as_bytes(std::span(codes)) : errors);
  return !are_short;
}

int order_of(const std::uint8_t* kinds, int channels) {
  std::uint8_t axes[3] = {};
  int turns = 0;
  for (int c = 0; c < channels; ++c)
    if (runtime::is_rotation(kinds[c]))
      axes[turns++] = static_cast<std::uint8_t>(runtime::axis_of(kinds[c]));
  int order = 0;
  while (!std::equal(axes, axes + 3, runtime::kAxesOfOrder[order])) ++order;
  return order;
}

/// Returns the rotation orders of a skeleton, and replaces them by the order x, y, z. Returns
/// nothing if the original bytes could not be restored exactly.
std::optional<std::vector<std::byte>> take_orders(std::span<const std::byte> payload,
                                                  JointText& joints) {
  if (!std::ranges::equal(joints.payload(), payload)) return std::nullopt;
  std::vector<std::byte> orders;
  int factor = 1;
  joints.visit([&](std::uint8_t* kinds, int channels) {
    if (factor == 1) orders.push_back({});
    orders.back() = static_cast<std::byte>(std::to_integer<int>(orders.back()) +
                                           factor * order_of(kinds, channels));
    factor = factor == 36 ? 1 : 6 * factor;
    runtime::set_order(0, kinds, channels);
  });
  return orders;
}

std::vector<SignalNeighbours> neighbours_of(const runtime::FileSections& sections) {
  std::vector<SignalNeighbours> neighbours = channel_neighbours(read_joints(sections));
  append_correction_neighbours(static_cast<int>(sections.signal_count() - sections.channels),
                               neighbours);
  return neighbours;
}

/// Codes the motion with the learned priors. Returns nothing if that is no shorter, or if the
/// original bytes could not be restored exactly.
std::optional<std::vector<std::byte>> recoded(const runtime::FileSections& sections,
                                              std::span<const std::byte> learned) {
  if (learned.empty() || !sections.is_adaptive() || sections.segments_bytes > 0 ||
      sections.tiers.count > 0)
    return std::nullopt;
  const std::span<const std::byte> motion = span_of(sections.motion);
  const std::vector<SignalNeighbours> neighbours = neighbours_of(sections);
  const QuantisedSignals coded =
      adaptive_decode(motion, neighbours, static_cast<int>(sections.frames));
  std::vector<std::byte> bytes = adaptive_encode(coded, neighbours, learned);
  if (bytes.size() >= motion.size() ||
      !std::ranges::equal(adaptive_encode(coded, neighbours), motion))
    return std::nullopt;
  return bytes;
}

}  // namespace

PackedClip pack_clip(std::span<const std::byte> file, std::span<const std::byte> learned) {
  const runtime::FileSections sections = sections_of(file);
  const std::optional<std::vector<std::byte>> motion = recoded(sections, learned);
  runtime::Cursor cursor(reinterpret_cast<const std::uint8_t*>(file.data()), file.size());
  std::uint16_t count = 0;
  require(runtime::read_head(cursor, count));
  PackedClip packed;
  std::vector<std::byte> sizes;
  std::vector<std::byte> orders;
  std::vector<std::byte> payloads;
  std::span<const std::byte> description;
  if (motion) {
    runtime::Section section;
    std::memcpy(section.tag, runtime::kLearned, sizeof section.tag);
    packed.sections.push_back({std::to_array(section.tag), part_of(section, learned)});
  }
  for (int s = 0; s < count; ++s) {
    runtime::Section section;
    require(runtime::read_section(cursor, section));
    const std::span<const std::byte> payload = span_of(section.payload);
    std::vector<std::byte> part;
    if (section.is(kTiers.data())) {
      const std::vector<std::byte> tiers = write_tiers(sections.tiers);
      write_varint(sizes, tiers.size());
      append(payloads, tiers);
    } else if (section.is("JNTS")) {
      JointText joints(sections);
      const auto taken = take_orders(payload, joints);
      if (taken) orders = *taken;
      const std::vector<std::byte> ordered =
          orders.empty() ? std::vector(payload.begin(), payload.end()) : joints.payload();
      part = part_of(section, ordered);
    } else if (section.is("CLIP")) {
      description = payload;
      std::vector<std::byte> common(payload.begin(), payload.end());
      std::fill_n(common.begin() + runtime::kFramesAt, 4, std::byte{});
      std::fill_n(common.begin() + runtime::kErrorsAt, 8, std::byte{});
      part = part_of(section, common);
    } else if (section.is_optional()) {
      part = part_of(section, payload);
    } else {
      if (runtime::has_told_size(section)) write_varint(sizes, payload.size());
      append(payloads, motion && section.is("MOTN") ? *motion : payload);
    }
    packed.sections.push_back({std::to_array(section.tag), std::move(part)});
  }
  for (int t = 1; t < sections.tiers_read; ++t) {
    const std::span<const std::byte> piece = span_of(sections.piece(t));
    packed.pieces.emplace_back(piece.begin(), piece.end());
  }
  const bool are_whole =
      append_errors(description.subspan(runtime::kErrorsAt, 2 * sizeof(float)), packed.bytes);
  packed.orders_head =
      static_cast<std::uint16_t>(orders.size() | (are_whole ? runtime::kWholeErrors : 0U));
  write_varint(packed.bytes, sections.frames);
  append(packed.bytes, sizes);
  append(packed.bytes, orders);
  append(packed.bytes, payloads);
  return packed;
}

std::uint32_t intern_outline(const PackedClip& clip, const InternItem& intern) {
  std::vector<std::byte> outline;
  append_number(outline, static_cast<std::uint16_t>(clip.sections.size()));
  append_number(outline, clip.orders_head);
  for (const PackedClip::Section& section : clip.sections) {
    append(outline, std::as_bytes(std::span(section.tag)));
    append_number(outline, section.part.empty() ? runtime::kOwnPart
                                                : intern(runtime::BankItem::Part, section.part));
  }
  return intern(runtime::BankItem::Outline, outline);
}

std::vector<std::byte> unpack_clip(const mcpk_bank& bank, const runtime::BankEntry& entry) {
  runtime::FileSections sections;
  require(runtime::read_sections(bank, entry, mcpr::default_limits(), sections));
  runtime::PackedSections packed(bank, entry);
  std::uint16_t count = 0;
  require(packed.begin(count));
  const std::span<const std::byte> learned = span_of(sections.learned);
  ByteWriter rest;  // all sections except TIER
  for (int s = 0; s < count; ++s) {
    runtime::Section section;
    require(packed.next(section));
    const std::string_view tag(section.tag, sizeof section.tag);
    if (tag == runtime::kLearned || tag == kTiers) continue;
    if (tag == "MOTN" && !learned.empty()) {
      const std::vector<SignalNeighbours> neighbours = neighbours_of(sections);
      const QuantisedSignals coded =
          adaptive_decode(span_of(section.payload), neighbours, static_cast<int>(sections.frames),
                          section.payload.offset, learned);
      write_section(rest, tag, adaptive_encode(coded, neighbours));
      continue;
    }
    if (!section.is("JNTS") || packed.orders().size == 0) {
      write_section(rest, tag, span_of(section.payload));
      continue;
    }
    JointText joints(sections);
    runtime::JointOrders orders(packed.orders());
    joints.visit([&](std::uint8_t* kinds, int channels) {
      runtime::set_order(orders.next(), kinds, channels);
    });
    require(orders.finish());
    write_section(rest, tag, joints.payload());
  }
  ByteWriter file;
  write_head(file, static_cast<std::uint16_t>(count - (learned.empty() ? 0 : 1)));
  const runtime::TierTable& tiers = sections.tiers;
  if (tiers.count > 0) {
    std::vector<TierBytes> bytes = {{rest.bytes().size()}};
    for (int t = 1; t < tiers.count; ++t)  // file_of_tiers() drops those that the bank lacks
      bytes.push_back(t < sections.tiers_read ? tier_bytes(span_of(sections.piece(t)))
                                              : TierBytes{1, 0});
    write_section(file, kTiers, write_tiers(tiers, bytes));
  }
  file.append(rest.bytes());
  for (int t = 1; t < sections.tiers_read; ++t) file.append(span_of(sections.piece(t)));
  const bool is_cut = sections.tiers_read < sections.tiers.count;
  return is_cut ? file_of_tiers(file.bytes(), sections.tiers_read) : file.release();
}

std::uint32_t copy_outline(const mcpk_bank& bank, std::uint32_t outline, const InternItem& intern) {
  const std::span<const std::byte> from = span_of(bank.item(runtime::BankItem::Outline, outline));
  std::vector<std::byte> copy(from.begin(), from.end());
  for (std::size_t at = runtime::kOutlineHead; at + runtime::kOutlineSection <= copy.size();
       at += runtime::kOutlineSection) {
    std::uint32_t part = 0;
    std::memcpy(&part, copy.data() + at + 4, sizeof part);
    if (part == runtime::kOwnPart) continue;
    part = intern(runtime::BankItem::Part, span_of(bank.item(runtime::BankItem::Part, part)));
    std::memcpy(copy.data() + at + 4, &part, sizeof part);
  }
  return intern(runtime::BankItem::Outline, copy);
}

}  // namespace mocapress
