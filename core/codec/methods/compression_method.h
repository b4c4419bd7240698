// SPDX-License-Identifier: MIT
// One interface for all methods of compression: the wavelets and the comparison methods.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/codec/encode/encoder.h"

namespace mocapress {

/// A method as the user names it: a selection of wavelet coefficients in some basis, or a
/// comparison method.
struct CompressionMethod {
  std::string_view name;   // "annealed", "haar", "pca" ...: in settings and files
  std::string_view title;  // shown to people, the same everywhere
  std::string_view note;   // description, author, and what is simplified
};

/// All methods: annealed, standard, per-channel, haar, linear and closed-loop, then those of
/// comparison_methods().
std::span<const CompressionMethod> compression_methods();

/// nullptr when there is none of that name.
const CompressionMethod* find_compression_method(std::string_view name);

/// The title of the method with that name, or the name itself where there is none.
std::string_view method_title(std::string_view name);

/// Sets method and basis if this is a wavelet method. Returns false for a comparison method and
/// leaves `settings` unchanged.
bool choose_wavelets(const CompressionMethod& compression_method, EncodeSettings& settings);

/// Compresses one motion by any method, with any settings. Data that does not depend on method and
/// settings is computed once, when first asked for. Const and safe to use from several threads at a
/// time.
class MethodEncoder {
 public:
  explicit MethodEncoder(Motion motion);
  ~MethodEncoder();

  const Encoder& wavelets() const;

  /// Compresses by the given method; `settings.method` and `.basis` are ignored. Throws Error when
  /// a correction or a coefficient ratio is asked of a comparison method, and TargetMissed when no
  /// amount of detail meets the target. The detail of comparison methods comes in coarse steps; for
  /// a ratio they take the nearest step. Only wavelet methods support EncodeSettings::figures_only
  /// and fill Encoding::tracks.
  Encoding compress(const CompressionMethod& compression_method, const EncodeSettings& settings,
                    const Observer<EncodeProgress>& observer = {}) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace mocapress
