// SPDX-License-Identifier: MIT
// A clip of a packed bank: FORMAT.md, "Packed clips". A packed clip has the same sections as a
// .mcpr file, but the bank stores sections that several clips share only once.
#pragma once

#include <cstdint>

#include "core/runtime/format/bank.h"
#include "core/runtime/format/bank_tiers.h"
#include "core/runtime/format/section.h"

namespace mocapress::runtime {

inline constexpr std::uint32_t kOwnPart = 0xFFFFFFFFU;  // in an outline: the clip stores this
                                                        // section itself
inline constexpr std::size_t kOutlineHead = 4;  // bytes: u16 number of sections; u16 number of
                                                // bytes of rotation orders, with kWholeErrors
inline constexpr std::uint16_t kWholeErrors = 0x8000;  // flag: the two errors take 4 bytes each,
                                                       // not 2
inline constexpr std::size_t kOutlineSection = 8;      // bytes: tag, u32 part

inline constexpr std::size_t kDescriptionBytes = 32;  // bytes in CLIP. Each clip has values of its
                                                      // own at the next two offsets
inline constexpr std::size_t kFramesAt = 8;           // offset of frames, u32
inline constexpr std::size_t kErrorsAt = 24;          // offset of eps and max_error, f32 each

/// Tag of the part that holds the bank's learned priors, which only banks have: learned_priors.h.
inline constexpr char kLearned[] = "PRIO";

/// Extra bytes in the count that bounds a clip's samples (most_values_of), if the bank stores the
/// joints in another rotation order. JNTS may then be shorter in the bank than in the .mcpr file.
inline constexpr std::size_t kReorderedRoom = 256;

/// True if a packed clip stores the section's size. The motion has no stored size: it takes the
/// bytes that are left.
bool has_told_size(const Section& section);

/// Reads the sections of a packed clip, as they are in its .mcpr file. Only JNTS differs if
/// orders() is not empty: then every joint that turns about three axes has them in the order x y z.
class PackedSections {
 public:
  PackedSections(const mcpk_bank& bank, const BankEntry& entry)
      : bank_(bank), entry_(entry), tiers_(bank) {}

  /// Reads the head; sets the number of sections.
  mcpr_result begin(std::uint16_t& sections);

  /// Reads the next section. Its payload is valid until the next call.
  mcpr_result next(Section& section);

  /// Number of the clip's tiers that the bank still has; and the piece that a tier adds to the
  /// motion. The first tier has no piece.
  int tiers() const { return tiers_.present(); }
  Bytes piece(int tier) const { return bank_.bytes_of(tiers_.piece(tier, entry_.number)); }

  /// Number of the part that holds the clip's joints; kOwnPart if the clip holds them itself. Reads
  /// the clip's outline only.
  std::uint32_t joints_part();

  /// Number of the clip's bytes that no section has taken.
  std::size_t left() const { return left_.left(); }
  std::size_t offset() const { return left_.offset(); }

  /// Rotation orders of the clip's joints: joint_orders.h.
  const Bytes& orders() const { return orders_; }

 private:
  mcpr_result refuse(const char* message) const;
  Section section_at(int number, std::uint32_t& part) const;

  const mcpk_bank& bank_;
  const BankEntry& entry_;
  BankTiers tiers_;
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
