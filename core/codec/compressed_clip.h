// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

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

/// How the chosen coefficients became bytes. The values are part of the file format.
enum class Coding : std::uint8_t {
  Rle16 = 1,    // 16-bit words with runs of zeros
  Deflate = 2,  // the same words, DEFLATE over the clip
};

/// "per-channel", "standard", "annealed"; "rle16", "deflate".
std::string_view name(Method method);
std::string_view name(Coding coding);

/// How a clip was made and what it promises: for people and tools, not for the decoder.
struct Provenance {
  Method method = Method::Annealed;
  Weighting weighting = Weighting::BoneEnds;
  std::uint64_t seed = 0;
  float eps_cm = 0;        // in `weighting`, against the original, at encoding
  float max_error_cm = 0;  // over all landmarks and frames
};

/// A compressed clip as values: what a .mcpr file holds. FORMAT.md says how.
struct CompressedClip {
  Skeleton skeleton;
  double sample_rate_hz = 120;
  int frames = 0;
  Basis basis = Basis::Cubic;
  Coding coding = Coding::Deflate;
  std::vector<std::byte> motion;  // every channel's coefficients, coded
  Provenance provenance;
};

}  // namespace mocapress
