// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "core/codec/format/adaptive.h"
#include "core/codec/format/coded_ends.h"
#include "core/codec/format/signal_coder.h"
#include "core/ik/correction.h"
#include "core/motion/clip.h"
#include "core/motion/landmarks.h"
#include "core/motion/loop.h"
#include "core/motion/rotation_form.h"
#include "core/runtime/format/segment_layout.h"
#include "core/wavelet/lifting.h"

namespace mocapress {

using runtime::SegmentLayout;

/// The method that chose the coefficients. Decoding does not depend on it; the values are part of
/// the file format.
enum class Method : std::uint8_t {
  PerChannel = 1,  // the same number from every channel
  Standard = 2,    // the largest of all channels
  Annealed = 3,    // the paper's Algorithm 1
  ClosedLoop = 4,  // quantised by each step's effect on eps_x; always with Coding::Adaptive
};

/// "per-channel", "standard", "annealed", "closed-loop".
std::string_view name(Method method);

/// The method, settings and measured error of an encode: for people and tools, unused by the
/// decoder.
struct Provenance {
  Method method = Method::Annealed;
  Weighting weighting = Weighting::BoneEnds;
  std::uint64_t seed = 0;
  float eps_cm = 0;        // in `weighting`, against the original, at encoding
  float max_error_cm = 0;  // largest of the points of `weighting`
};

/// The solver that corrects the decoded motion, and its effectors (the paper's section 5.1). The
/// effectors' paths are coded with the motion.
struct CodedCorrection {
  IkSolver solver = IkSolver::NearestPose;
  std::vector<Effector> effectors;

  int signal_count() const { return 3 * static_cast<int>(effectors.size()); }
  std::size_t section_bytes() const { return 2 + 4 * effectors.size(); }
};

/// The segments that the motion of a long clip falls into.
struct CodedSegments {
  int length = 0;                    // frames of each segment but the last
  int overlap = 0;                   // frames shared by neighbouring segments
  std::vector<std::uint32_t> bytes;  // bytes of each segment

  std::size_t section_bytes() const { return 12 + 4 * bytes.size(); }
};

/// The quantised values of an adaptive motion in one segment, and the samples decoded from them.
/// Safe to use from several threads at a time.
class KnownMotion {
 public:
  explicit KnownMotion(QuantisedSignals coded) : coded_(std::move(coded)) {}

  /// Takes samples that are known already and equal the decoded ones up to rounding.
  KnownMotion(QuantisedSignals coded, Eigen::MatrixXd samples) : coded_(std::move(coded)) {
    std::call_once(decoded_, [&] { samples_ = std::move(samples); });
  }

  const QuantisedSignals& coded() const { return coded_; }

  /// The samples that `decode(coded)` returns (frames x signals), computed once.
  template <typename Decode>
  const Eigen::MatrixXd& samples(const Decode& decode) const {
    std::call_once(decoded_, [&] { samples_ = decode(coded_); });
    return samples_;
  }

 private:
  QuantisedSignals coded_;
  mutable std::once_flag decoded_;
  mutable Eigen::MatrixXd samples_;
};

/// A compressed clip as values: the content of a .mcpr file. FORMAT.md describes the bytes.
struct CompressedClip {
  Skeleton skeleton;    // the source's
  RotationForms forms;  // forms of the coded angles; empty: the skeleton's own
  double sample_rate_hz = 120;
  int frames = 0;
  Basis basis = Basis::Cubic;
  Coding coding = Coding::Deflate;
  std::vector<std::byte> motion;  // coded coefficients of every channel, then of the correction
  std::shared_ptr<const KnownMotion> known;  // the motion's values, if the encoder still has them
  std::optional<std::size_t> likely_bytes;  // estimate for a motion that is known but not coded yet
  std::optional<CodedSegments> segments;    // only with Coding::Adaptive
  std::optional<CodedCorrection> correction;
  Loop loop = Loop::None;
  std::optional<CodedEnds> ends;  // only with Coding::Adaptive, in clips with frames
  Provenance provenance;
  int bands_left_out = 0;  // finest bands that are missing: only a file's first tiers were read

  /// The skeleton in whose channels the motion is coded.
  Skeleton coded_skeleton() const;

  /// The bytes that a ratio counts: motion, segments, correction, ends and turned axes, not the
  /// skeleton. An estimate where the motion is not coded yet.
  std::size_t motion_bytes() const;

  /// The part of motion_bytes() that the correction adds.
  std::size_t correction_bytes() const;

  /// The segments of the motion; a single one if it is not cut.
  SegmentLayout segment_layout() const {
    return segments ? SegmentLayout{frames, segments->length, segments->overlap}
                    : SegmentLayout::whole(frames);
  }
};

/// The words of `clip.motion`; requires uses_rle(clip.coding). Throws FormatError when its bytes
/// are not valid.
std::vector<std::byte> unpack_motion(const CompressedClip& clip);

/// Reads the segments of an adaptive motion one after the other. Offsets in a FormatError count
/// from the motion's first byte.
class AdaptiveSegments {
 public:
  /// The clip must outlive this object.
  explicit AdaptiveSegments(const CompressedClip& clip);

  /// Reads the next segment: the motion's coefficients, then the correction's.
  QuantisedSignals next();

  void skip();

 private:
  std::size_t size() const;  // bytes of the next segment

  const CompressedClip& clip_;
  std::vector<SignalNeighbours> neighbours_;
  int segment_ = 0;
  std::size_t first_byte_ = 0;
};

/// Codes the coefficients of a segment, or of a clip without segments.
std::vector<std::byte> pack_adaptive(const QuantisedSignals& coded, const CompressedClip& clip);

/// Stores coefficients as the motion of a clip in one segment.
void set_motion(QuantisedSignals coded, CompressedClip& clip);
void set_motion(std::shared_ptr<const KnownMotion> coded, CompressedClip& clip);

/// Codes a motion that was only estimated, and drops `known`.
void code_motion(CompressedClip& clip);

/// The signals that resemble each signal of a coded motion: first for the channels, then for the
/// correction.
std::vector<SignalNeighbours> signal_neighbours(const CompressedClip& clip);

}  // namespace mocapress
