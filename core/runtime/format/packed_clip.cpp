// SPDX-License-Identifier: MIT
#include "core/runtime/format/packed_clip.h"

#include "core/runtime/format/coded_error.h"

namespace mocapress::runtime {

bool has_told_size(const Section& section) {
  return !section.is("MOTN") && !section.is("COMP");
}

mcpr_result PackedSections::refuse(const char* message) const {
  return failure(MCPR_INVALID, static_cast<std::size_t>(entry_.place.offset), message);
}

Section PackedSections::section_at(int number, std::uint32_t& part) const {
  const std::uint8_t* const at =
      outline_.data + kOutlineHead + kOutlineSection * static_cast<std::size_t>(number);
  Section section;
  std::memcpy(section.tag, at, sizeof section.tag);
  std::memcpy(&part, at + sizeof section.tag, sizeof part);
  section.start = static_cast<std::size_t>(entry_.place.offset);
  return section;
}

mcpr_result PackedSections::begin(std::uint16_t& sections) {
  outline_ = bank_.item(BankItem::Outline, entry_.kind);
  if (outline_.size < kOutlineHead) return refuse("the clip has no outline");
  std::uint16_t order_bytes = 0;
  static_assert(kErrorsAt + sizeof errors_ == kDescriptionBytes);
  std::memcpy(&sections, outline_.data, sizeof sections);
  std::memcpy(&order_bytes, outline_.data + sizeof sections, sizeof order_bytes);
  if (outline_.size != kOutlineHead + kOutlineSection * sections)
    return refuse("the outline of the clip has the wrong size");
  left_ = bank_.bytes_of(entry_.place).cursor();
  const bool are_whole = (order_bytes & kWholeErrors) != 0;
  for (float& error : errors_)
    error = are_whole ? left_.read<float>() : error_from(left_.read<std::uint16_t>());
  const std::uint64_t frames = left_.read_varint();
  if (frames > 0xFFFFFFFFU) return refuse("more than 2^22 frames");
  frames_ = static_cast<std::uint32_t>(frames);
  sizes_ = left_;
  std::uint32_t part = 0;
  std::uint64_t told = 0;
  for (int s = 0; s < sections; ++s)
    if (has_told_size(section_at(s, part)) && part == kOwnPart)
      told += left_.read_varint() & 0xFFFFFFFFU;
  orders_ = {nullptr, order_bytes & (kWholeErrors - 1U), left_.offset()};
  orders_.data = left_.take(orders_.size);
  if (left_.failed() || told > left_.left()) return refuse("the clip ends within its head");
  motion_bytes_ = left_.left() - static_cast<std::size_t>(told);
  return kOk;
}

mcpr_result PackedSections::next(Section& section) {
  std::uint32_t part = 0;
  section = section_at(next_++, part);
  if (part == kOwnPart) {
    const std::uint64_t size = has_told_size(section) ? sizes_.read_varint() : motion_bytes_;
    section.payload = {nullptr, static_cast<std::size_t>(size), left_.offset()};
    section.payload.data = size > left_.left() ? nullptr : left_.take(section.payload.size);
    return section.payload.data != nullptr ? kOk : refuse("the clip ends within a section");
  }
  section.payload = bank_.item(BankItem::Part, part);
  if (section.payload.size < sizeof section.tag ||
      std::memcmp(section.payload.data, section.tag, sizeof section.tag) != 0)
    return refuse("the clip has a section that the bank does not have");
  section.payload.data += sizeof section.tag;
  section.payload.size -= sizeof section.tag;
  section.payload.offset += sizeof section.tag;
  if (!section.is("CLIP")) return kOk;
  if (section.payload.size != kDescriptionBytes) return refuse("CLIP has the wrong size");
  std::memcpy(description_, section.payload.data, kDescriptionBytes);
  std::memcpy(description_ + kFramesAt, &frames_, sizeof frames_);
  std::memcpy(description_ + kErrorsAt, errors_, sizeof errors_);
  section.payload.data = description_;
  return kOk;
}

std::uint32_t PackedSections::joints_part() {
  outline_ = bank_.item(BankItem::Outline, entry_.kind);
  for (std::size_t s = 0; kOutlineHead + kOutlineSection * (s + 1) <= outline_.size; ++s) {
    std::uint32_t part = 0;
    if (section_at(static_cast<int>(s), part).is("JNTS")) return part;
  }
  return kOwnPart;
}

}  // namespace mocapress::runtime
