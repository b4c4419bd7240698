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

/// The signals (samples x signals) of quantised coefficients (coarse to fine), by the runtime
/// decoder: what it gives, to the bit, 32-bit floats. `steps` are those of each signal, which
/// Lifting::gains() divide. Signals with samples beyond their limit, or 8 where none is given,
/// are decoded in double precision on the way.
Eigen::MatrixXd decode_signals(const Eigen::MatrixXi& values, const std::vector<float>& steps,
                               Basis basis, const std::vector<float>& double_precision_limits = {});

/// The next signals of words (FORMAT.md, MOTN), samples x count. Throws FormatError when the words
/// are not valid.
Eigen::MatrixXd read_signals(ByteReader& words, Basis basis, int samples, int count);

/// The motion of a compressed clip, in the channels of its skeleton. Throws FormatError when its
/// bytes are not valid.
Clip decode(const CompressedClip& compressed);

/// A compressed clip, or some frames of it, before its correction: in the channels that are coded.
struct Uncorrected {
  Clip clip;
  Eigen::MatrixXd differences;  // frames x 3 * effectors, cm: what the effectors lack
};

/// decode() without the correction.
Uncorrected decode_uncorrected(const CompressedClip& compressed);

/// From what visit_decoded() gives to what decode() does, but in the channels that are coded.
class Finish {
 public:
  /// The compressed clip must outlive this.
  explicit Finish(const CompressedClip& compressed);

  /// Frames from first_frame on: first the correction, if there is one, then the ends.
  CorrectionReport operator()(int first_frame, Uncorrected& block) const;

  /// Frames (rows) from first_frame on; nothing where ends are not coded.
  void add_ends(int first_frame, Eigen::MatrixXd& channels) const;

 private:
  const CompressedClip& compressed_;
  Skeleton coded_skeleton_;
  std::optional<EndPoses> ends_;
};

/// What a step of each signal is worth in the first and in the last segment. Of Coding::Adaptive.
std::pair<std::vector<float>, std::vector<float>> steps_at_ends(const CompressedClip& compressed);

/// The frames from first_frame on, which may be changed or taken.
using DecodedBlock = std::function<void(int first_frame, Uncorrected& block)>;

/// What the coefficients say, in time, segment after segment, so that they are never all in memory:
/// without correction and ends. A clip that is not in segments comes at once.
void visit_decoded(const CompressedClip& compressed, const DecodedBlock& visit);

/// A clip in the channels that are coded, in those of the skeleton.
Clip in_source_channels(const CompressedClip& compressed, Clip coded);

/// Puts some rows where they belong in a matrix of so many.
void put_rows(Eigen::MatrixXd rows, int first, int all, Eigen::MatrixXd& matrix);

}  // namespace mocapress
