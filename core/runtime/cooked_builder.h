// SPDX-License-Identifier: MIT
#pragma once

#include "core/codec/format/memory.h"
#include "core/runtime/clip.h"
#include "core/runtime/cooked_block.h"
#include "core/runtime/cooked_clip.h"
#include "core/runtime/cooked_coefficients.h"
#include "core/runtime/cooked_columns.h"

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

 private:
  void choose_bands();
  void lay_out_joints(CookedBlock& block, mcpr_cooked& head);
  void lay_out_rotors(CookedBlock& block, mcpr_cooked& head);

  const ClipBlock& clip_;
  CookedCoefficients coefficients_;
  CookedColumns columns_;
};

}  // namespace mocapress::runtime
