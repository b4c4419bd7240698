// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/runtime/decode/clip.h"
#include "core/runtime/format/memory.h"
#include "core/runtime/pose/cooked_block.h"
#include "core/runtime/pose/cooked_clip.h"
#include "core/runtime/pose/cooked_coefficients.h"
#include "core/runtime/pose/cooked_columns.h"

namespace mocapress::runtime {

/// From the resident form of a clip to the cooked one. The coefficients are taken over as they are,
/// but for the coarse bands, of which samples are made.
class CookedBuilder {
 public:
  /// With measuring memory only to know how much.
  CookedBuilder(Memory& memory, const mcpr_clip& clip, bool apply_ik);

  /// Finds out what there is to lay out.
  mcpr_result prepare();

  /// Makes the clip, after prepare(), in zeroed memory; without memory only its size.
  std::uint64_t lay_out(std::byte* memory);

  /// The same with its tables elsewhere, where offset 0 is left free. How far away they are is not
  /// known here: mcpr_cooked::tables.
  struct Size {
    std::uint64_t clip = 0;
    std::uint64_t tables = 0;
  };
  Size lay_out_apart(std::byte* memory, std::byte* tables);

 private:
  std::uint64_t lay_out(CookedBlock& block, CookedBlock& tables, std::byte* memory);
  void choose_bands();
  void lay_out_ends(CookedBlock& block, mcpr_cooked& head);
  void lay_out_joints(CookedBlock& block, mcpr_cooked& head);
  void lay_out_rotors(CookedBlock& block, mcpr_cooked& head);

  const ClipBlock& clip_;
  CookedCoefficients coefficients_;
  CookedColumns columns_;
};

}  // namespace mocapress::runtime
