// SPDX-License-Identifier: MIT
// Makes the tracks of a clip from section trks of a file, in two steps as in FileLoader: read()
// into scratch memory, then lay_out() into the resident clip.
#pragma once

#include "core/runtime/decode/block_layout.h"
#include "core/runtime/decode/track_block.h"
#include "core/runtime/format/coefficient_coder.h"
#include "core/runtime/format/file_sections.h"
#include "core/runtime/format/memory.h"
#include "core/runtime/format/track_records.h"

namespace mocapress::runtime {

class TrackLoader {
 public:
  /// If `memory` only measures, this counts bytes and does nothing else. Reuses the memory of the
  /// skeleton's coder `done_with`, which must not be used any more.
  TrackLoader(Memory& memory, const FileSections& sections, const JointByteCoder& done_with);

  /// Decodes all tracks. The file is not needed afterwards.
  mcpr_result read();

  /// Writes the tracks into a block as mcpr_tracks, and returns their offset; 0: there are none.
  std::uint32_t lay_out(BlockLayout& block, LoopKind loop) const;

 private:
  mcpr_result read_curves();
  QuantisedSource source() const;
  std::uint64_t lay_out(std::byte* memory, LoopKind loop) const;
  void put_records(ResidentTrack* resident, char* names) const;

  TracksHead head_;
  std::uint32_t frames_;
  std::uint8_t* records_;
  TrackRun* runs_;
  SignalNeighbours* neighbours_;
  AdaptiveBit* contexts_;
  std::int32_t* step_exponents_;
  std::int32_t* values_;
  float* steps_;
  float* double_precision_limits_;
  std::uint8_t* notes_;
  Bands bands_;
  CoderNotes coder_notes_;
  TrackByteCoder byte_coder_;
};

}  // namespace mocapress::runtime
