// SPDX-License-Identifier: MIT
// A clip of a packed bank: FORMAT.md, "Packed clips". Its sections are those of its .mcpr, of which
// some stand once for many clips.
#pragma once

#include <cstdint>

#include "core/runtime/format/bank.h"
#include "core/runtime/format/section.h"

namespace mocapress::runtime {

inline constexpr std::uint32_t kOwnPart = 0xFFFFFFFFU;  // of an outline: the clip has it itself
inline constexpr std::size_t kOutlineHead = 4;          // u16 sections, u16 bytes of orders and a
inline constexpr std::uint16_t kWholeErrors = 0x8000;   // bit: errors are 4 bytes each, not 2
inline constexpr std::size_t kOutlineSection = 8;       // tag, u32 part

inline constexpr std::size_t kDescriptionBytes = 32;  // CLIP, of which a clip has its own:
inline constexpr std::size_t kFramesAt = 8;           // the frames, u32,
inline constexpr std::size_t kErrorsAt = 24;          // and eps and max_error, f32 each

/// The part that has what clips of the bank taught, which no file has: learned_priors.h.
inline constexpr char kLearned[] = "PRIO";

/// A file that a reader counts as so much longer, where joints were reordered: JNTS is not as long
/// then as it is in the bank, and how many samples a file may have goes by its length.
inline constexpr std::size_t kReorderedRoom = 256;

/// Whether a section's size is told: of the motion it is what is left.
bool has_told_size(const Section& section);

/// Gives the sections of a packed clip as they stand in its .mcpr, but for JNTS where orders() has
/// bytes: then the joints that turn freely have all their angles in the order x y z.
class PackedSections {
 public:
  PackedSections(const mcpk_bank& bank, const BankEntry& entry) : bank_(bank), entry_(entry) {}

  /// What comes before the sections, and their number.
  mcpr_result begin(std::uint16_t& sections);

  /// The payload is valid until the next.
  mcpr_result next(Section& section);

  /// How many bytes of the clip no section took.
  std::size_t left() const { return left_.left(); }
  std::size_t offset() const { return left_.offset(); }

  /// In which orders the clip's joints have their angles: joint_orders.h.
  const Bytes& orders() const { return orders_; }

 private:
  mcpr_result refuse(const char* message) const;
  Section section_at(int number, std::uint32_t& part) const;

  const mcpk_bank& bank_;
  const BankEntry& entry_;
  Bytes outline_;
  Bytes orders_;
  Cursor sizes_{nullptr, 0};
  Cursor left_{nullptr, 0};
  std::size_t motion_bytes_ = 0;
  int next_ = 0;
  std::uint8_t description_[kDescriptionBytes] = {};
  std::uint32_t frames_ = 0;
  float errors_[2] = {};
};

}  // namespace mocapress::runtime
