// SPDX-License-Identifier: MIT
// Every method of compression by one name and one call: the wavelets and what they are compared
// with.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/codec/encode/encoder.h"
#include "core/metrics/comparison.h"

namespace mocapress {

/// A method as the user names it: a selection of wavelet coefficients in some basis, or a
/// comparison method.
struct CompressionMethod {
  std::string_view name;   // "annealed", "haar", "pca" ...: in options and files
  std::string_view title;  // the same for people, everywhere
  std::string_view note;   // what it is, whose, and what is simplified
};

/// annealed, standard, per-channel, haar, linear, closed-loop, then comparison_methods().
std::span<const CompressionMethod> compression_methods();

/// nullptr when there is none of that name.
const CompressionMethod* find_compression_method(std::string_view name);

/// The title of the method of that name; the name itself where there is none.
std::string_view method_title(std::string_view name);

/// Sets method and basis to those of a method that is wavelets. False: it is a
/// comparison method, and nothing was set.
bool choose_wavelets(const CompressionMethod& compression_method, EncodeOptions& options);

/// A motion compressed by a method, decoded again and measured.
/// EncodeOptions::figures_only is heeded by wavelets. Contacts are Encoder::contacts(), or edited
/// ones.
struct Compression : Comparison {
  std::vector<std::byte> file;   // the .mcpr
  std::size_t motion_bytes = 0;  // what the ratio counts
  Clip decoded;
  std::optional<CorrectionResult> correction;  // of wavelets
  std::optional<double> coefficient_ratio;     // of wavelets
  std::optional<int> iterations;               // of annealing
  double seconds = 0;
  bool complete = true;  // false: the observer ended it early
};

/// Compresses one motion by any method, with any options; what does not depend on them
/// is computed once, when first asked for. Const and safe to use from several threads at a time.
class MethodEncoder {
 public:
  explicit MethodEncoder(Motion motion);
  ~MethodEncoder();

  const Encoder& wavelets() const;

  /// Throws Error when a correction is asked of a comparison method.
  /// `options.method` and `.basis` are those of the method, whatever they were. Throws
  /// TargetMissed when no amount of detail meets the target; comparison methods, whose detail comes
  /// in coarse steps, take the nearest step to a ratio instead, and have no coefficient ratio
  /// target (Error).
  Compression compress(const CompressionMethod& compression_method, const EncodeOptions& options,
                       const Observer<EncodeProgress>& observer = {}) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace mocapress
