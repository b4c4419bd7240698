// SPDX-License-Identifier: MIT
// The interface of the methods that the wavelets are compared with. core/baselines/METHODS.md
// describes their bytes.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/motion/clip.h"
#include "core/motion/landmarks.h"

namespace mocapress {

/// One motion, ready to be compressed by one method at any level of detail.
class DetailCoder {
 public:
  virtual ~DetailCoder() = default;

  /// Detail levels are in [0, most_detail()]: with more detail, bytes grow and the error falls.
  virtual int most_detail() const = 0;

  /// Encodes everything that decode() needs besides the skeleton, the frame count and the rate.
  virtual std::vector<std::byte> encode(int detail) const = 0;
};

/// Makes the coder of a method for one motion.
template <typename Coder>
std::unique_ptr<DetailCoder> coder_of(const Motion& motion, Weighting weighting) {
  return std::make_unique<Coder>(motion, weighting);
}

/// A compression method other than the wavelets of core/codec.
struct ComparisonMethod {
  std::string_view name;   // as in --method: "pca"
  std::string_view title;  // for a legend: "PCA"
  std::string_view note;   // its author, and what is simplified here

  /// `weighting` of the error is for methods that look at it when they choose what to keep.
  std::unique_ptr<DetailCoder> (*analyse)(const Motion& motion, Weighting weighting);

  /// Throws FormatError on bytes that encode() cannot have written; checks sizes before allocating.
  Clip (*decode)(const Skeleton& skeleton, double sample_rate_hz, int frames,
                 std::span<const std::byte> motion);
};

/// The added methods, in order. None at first, because the library carries none.
std::span<const ComparisonMethod* const> comparison_methods();

/// Adds methods that can be found by name. Call once, before anything asks for methods: see
/// core/baselines/rivals.h.
void add_comparison_methods(std::span<const ComparisonMethod* const> methods);

/// nullptr when there is none of that name.
const ComparisonMethod* find_comparison_method(std::string_view name);

}  // namespace mocapress
