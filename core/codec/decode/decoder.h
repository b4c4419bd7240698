// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/byte_cursor.h"
#include "core/codec/format/compressed_clip.h"
#include "core/wavelet/lifting.h"

namespace mocapress {

/// Decodes quantised coefficients (coarse to fine) to signals (samples x signals) with the runtime
/// decoder; the result holds the same 32-bit floats, bit by bit. `steps` has one quantisation step
/// for each signal; a coefficient's step is that divided by its Lifting::gains(). Signals with
/// samples beyond their limit (8 where none is given) are decoded in double precision and then
/// rounded to floats.
Eigen::MatrixXd decode_signals(const Eigen::MatrixXi& values, const std::vector<float>& steps,
                               Basis basis, const std::vector<float>& double_precision_limits = {});

/// Reads and decodes the next signals from entropy-coded words (FORMAT.md, MOTN): samples x count.
/// Throws FormatError when the words are not valid.
Eigen::MatrixXd read_signals(ByteReader& words, Basis basis, int samples, int count);

/// The motion of a compressed clip, in the channels of its skeleton. Throws FormatError when its
/// bytes are not valid.
Clip decode(const CompressedClip& compressed);

/// Decoded frames of a clip, all or some, before the IK correction. The channels are the coded
/// ones: those of CompressedClip::coded_skeleton().
struct Uncorrected {
  Clip clip;
  Eigen::MatrixXd differences;  // frames x 3 * effectors, cm: the coded offsets from decoded to
                                // original effectors
};

/// Decodes without applying the correction.
Uncorrected decode_uncorrected(const CompressedClip& compressed);

/// Applies the IK correction and the coded ends to the blocks of visit_decoded(). The result
/// differs from decode() only in that it has the coded channels.
class Finish {
 public:
  /// The compressed clip must outlive this object.
  explicit Finish(const CompressedClip& compressed);

  /// Finishes the block that starts at first_frame: applies the correction, if there is one, and
  /// then adds the ends.
  CorrectionReport operator()(int first_frame, Uncorrected& block) const;

  /// Adds the coded corrections of the first and the last pose to frames (rows) from first_frame
  /// on. Does nothing for a clip without coded ends.
  void add_ends(int first_frame, Eigen::MatrixXd& channels) const;

 private:
  const CompressedClip& compressed_;
  Skeleton coded_skeleton_;
  std::optional<EndPoses> ends_;
};

/// The quantisation step of each signal in the first and in the last segment. Requires
/// Coding::Adaptive.
std::pair<std::vector<float>, std::vector<float>> steps_at_ends(const CompressedClip& compressed);

/// Receives the frames from first_frame on, and may change them or move them out.
using DecodedBlock = std::function<void(int first_frame, Uncorrected& block)>;

/// Decodes a clip segment by segment and hands each block to `visit`, so that memory does not grow
/// with the clip. Correction and ends are not applied. A clip without segments comes as one block.
void visit_decoded(const CompressedClip& compressed, const DecodedBlock& visit);

/// Converts a clip from the coded channels to those of the source's skeleton.
Clip in_source_channels(const CompressedClip& compressed, Clip coded);

/// Copies rows into `matrix` from row `first` on; `matrix` gets `all` rows in total.
void put_rows(Eigen::MatrixXd rows, int first, int all, Eigen::MatrixXd& matrix);

}  // namespace mocapress
