// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/codec/signal_coder.h"
#include "core/ik/correction.h"
#include "core/motion/clip.h"
#include "core/motion/landmarks.h"
#include "core/wavelet/basis.h"

namespace mocapress {

/// How coefficients were chosen. The decoder does not care; the values are part of the file format.
enum class Method : std::uint8_t {
  PerChannel = 1,  // as many from every channel
  Standard = 2,    // the largest of all
  Annealed = 3,    // the paper's Algorithm 1
};

/// "per-channel", "standard", "annealed".
std::string_view name(Method method);

/// How a clip was made and what it promises: for people and tools, not for the decoder.
struct Provenance {
  Method method = Method::Annealed;
  Weighting weighting = Weighting::BoneEnds;
  std::uint64_t seed = 0;
  float eps_cm = 0;        // in `weighting`, against the original, at encoding
  float max_error_cm = 0;  // over all landmarks and frames
};

/// Where effectors go beside the decoded motion, and by what solver (the paper's section 5.1).
struct CodedCorrection {
  IkSolver solver = IkSolver::NearestPose;
  std::vector<Effector> effectors;
  std::vector<std::byte> differences;  // three signals an effector, coded as the motion is

  /// What the correction adds to a file: its signals and what says whose they are.
  std::size_t bytes() const;
};

/// A compressed clip as values: what a .mcpr file holds. FORMAT.md says how.
struct CompressedClip {
  Skeleton skeleton;
  double sample_rate_hz = 120;
  int frames = 0;
  Basis basis = Basis::Cubic;
  Coding coding = Coding::Deflate;
  std::vector<std::byte> motion;  // every channel's coefficients, coded
  std::optional<CodedCorrection> correction;
  Provenance provenance;

  /// What a ratio counts: motion and correction, not the skeleton.
  std::size_t motion_bytes() const {
    return motion.size() + (correction ? correction->bytes() : 0);
  }
};

}  // namespace mocapress
