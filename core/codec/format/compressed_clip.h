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

/// How coefficients were chosen. The decoder does not care; the values are part of the file format.
enum class Method : std::uint8_t {
  PerChannel = 1,  // as many from every channel
  Standard = 2,    // the largest of all
  Annealed = 3,    // the paper's Algorithm 1
  ClosedLoop = 4,  // quantised by what each step does to eps_x; always of Coding::Adaptive
};

/// "per-channel", "standard", "annealed", "closed-loop".
std::string_view name(Method method);

/// How a clip was made and what it promises: for people and tools, not for the decoder.
struct Provenance {
  Method method = Method::Annealed;
  Weighting weighting = Weighting::BoneEnds;
  std::uint64_t seed = 0;
  float eps_cm = 0;        // in `weighting`, against the original, at encoding
  float max_error_cm = 0;  // over all landmarks and frames
};

/// Who corrects the decoded motion, and at which effectors (the paper's section 5.1). Where they go
/// is coded with the motion.
struct CodedCorrection {
  IkSolver solver = IkSolver::NearestPose;
  std::vector<Effector> effectors;

  int signal_count() const { return 3 * static_cast<int>(effectors.size()); }
  std::size_t section_bytes() const { return 2 + 4 * effectors.size(); }
};

/// The segments that the motion of a long clip falls into.
struct CodedSegments {
  int length = 0;                    // frames of each but the last
  int overlap = 0;                   // frames that neighbours share
  std::vector<std::uint32_t> bytes;  // of each in the motion

  std::size_t section_bytes() const { return 12 + 4 * bytes.size(); }
};

/// What an adaptive motion of one segment decodes to. Safe to use from several threads at a time.
class KnownMotion {
 public:
  explicit KnownMotion(QuantisedSignals coded) : coded_(std::move(coded)) {}

  /// Where what it decodes to is known too, but for rounding.
  KnownMotion(QuantisedSignals coded, Eigen::MatrixXd samples) : coded_(std::move(coded)) {
    std::call_once(decoded_, [&] { samples_ = std::move(samples); });
  }

  const QuantisedSignals& coded() const { return coded_; }

  /// What `decode(coded)` makes of it (frames x signals), asked for once.
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

/// A compressed clip as values: what a .mcpr file holds. FORMAT.md says how.
struct CompressedClip {
  Skeleton skeleton;    // the source's
  RotationForms forms;  // of its joints' angles as they are coded; empty: the skeleton's own
  double sample_rate_hz = 120;
  int frames = 0;
  Basis basis = Basis::Cubic;
  Coding coding = Coding::Deflate;
  std::vector<std::byte> motion;  // coefficients of every channel, then of the correction, coded
  std::shared_ptr<const KnownMotion> known;  // where its encoder still knows
  std::optional<std::size_t> likely_bytes;   // of a motion that is known but not coded yet
  std::optional<CodedSegments> segments;     // of Coding::Adaptive only
  std::optional<CodedCorrection> correction;
  Loop loop = Loop::None;
  std::optional<CodedEnds> ends;  // of Coding::Adaptive only, and of clips with frames
  Provenance provenance;

  /// The skeleton in whose channels the motion is coded.
  Skeleton coded_skeleton() const;

  /// What a ratio counts: motion, segments, correction, ends and turned axes, not the skeleton.
  /// An estimate where the motion is not coded yet.
  std::size_t motion_bytes() const;

  /// How many of them are the correction's: what the motion alone would not take.
  std::size_t correction_bytes() const;

  /// One segment where there are no others.
  SegmentLayout segment_layout() const {
    return segments ? SegmentLayout{frames, segments->length, segments->overlap}
                    : SegmentLayout::whole(frames);
  }
};

/// Of the channels, then of the signals of the correction.
std::vector<SignalNeighbours> signal_neighbours(const CompressedClip& clip);

/// The words of `clip.motion`; requires a coding of words. Throws FormatError when its bytes are
/// not valid.
std::vector<std::byte> unpack_motion(const CompressedClip& clip);

/// The same of the segments of Coding::Adaptive, one after the other. Offsets of a FormatError
/// count from the motion's first byte.
class AdaptiveSegments {
 public:
  /// The clip must outlive this.
  explicit AdaptiveSegments(const CompressedClip& clip);

  /// The next segment's: the motion's coefficients, then the correction's.
  QuantisedSignals next();

  void skip();

 private:
  std::size_t size() const;  // of the next segment, in bytes

  const CompressedClip& clip_;
  std::vector<SignalNeighbours> neighbours_;
  int segment_ = 0;
  std::size_t first_byte_ = 0;
};

/// The coefficients of a segment, or of a clip that is not in segments, coded.
std::vector<std::byte> pack_adaptive(const QuantisedSignals& coded, const CompressedClip& clip);

/// Makes them the motion of a clip in one segment.
void set_motion(QuantisedSignals coded, CompressedClip& clip);
void set_motion(std::shared_ptr<const KnownMotion> coded, CompressedClip& clip);

/// Codes a motion that was only estimated, and forgets what is known.
void code_motion(CompressedClip& clip);

/// Which signals of a coded motion resemble one another.
std::vector<SignalNeighbours> signal_neighbours(const CompressedClip& clip);

}  // namespace mocapress
