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

/// Makes a cooked clip from the resident form. Takes over the coefficients of the fine bands
/// unchanged, and turns the coarse bands into samples.
class CookedBuilder {
 public:
  /// If `memory` only measures, this counts bytes and does nothing else.
  CookedBuilder(Memory& memory, const mcpr_clip& clip, const mcpr_cook_options& options);

  /// Decides on the layout of the cooked clip.
  mcpr_result prepare();

  /// Lays out the clip in zeroed memory, after prepare(), and returns its size. Without memory it
  /// only measures.
  std::uint64_t lay_out(std::byte* memory);

  /// Lays out the clip with its tables in another block, whose offset 0 stays free. The caller sets
  /// mcpr_cooked::tables, the distance to that block.
  struct Size {
    std::uint64_t clip = 0;
    std::uint64_t tables = 0;
  };
  Size lay_out_apart(std::byte* memory, std::byte* tables);

 private:
  std::uint64_t lay_out(CookedBlock& block, CookedBlock& tables, std::byte* memory);
  void choose_bands();
  void lay_out_skeleton(CookedBlock& block);
  void lay_out_ends(CookedBlock& block, mcpr_cooked& head);
  void lay_out_joints(CookedBlock& block, mcpr_cooked& head);
  void lay_out_rotors(CookedBlock& block, mcpr_cooked& head);

  const ClipBlock& clip_;
  const bool has_skeleton_;
  CookedCoefficients coefficients_;
  CookedColumns columns_;
};

}  // namespace mocapress::runtime
