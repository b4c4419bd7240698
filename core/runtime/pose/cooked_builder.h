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

/// Makes a cooked clip from the resident form of a clip. The coefficients of the fine bands are
/// kept unchanged, the coarse bands become samples.
class CookedBuilder {
 public:
  /// If `memory` only measures, this counts bytes and does nothing else.
  CookedBuilder(Memory& memory, const mcpr_clip& clip, const mcpr_cook_options& options);

  /// Analyses the clip, and chooses the layout of the cooked clip.
  mcpr_result prepare();

  /// Lays out the clip in zeroed memory, after prepare(), and returns its size. Without memory it
  /// only measures.
  std::uint64_t lay_out(std::byte* memory);

  /// Lays out the clip, with its tables in another block. Offset 0 of that block stays free. The
  /// caller must set mcpr_cooked::tables to the distance from the clip to that block.
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
