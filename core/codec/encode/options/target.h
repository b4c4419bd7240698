// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mocapress {

/// The user's target: a number and its kind.
struct Target {
  enum class Kind {
    Ratio,             // raw bytes / motion bytes, met within 2 %
    CoefficientRatio,  // the paper's r: all coefficients / kept coefficients
    Size,              // motion bytes, not exceeded
    Error,             // eps_x in cm in the chosen weighting, not exceeded
    MaxError,          // cm, exceeded by no landmark at any frame
    Visibility,        // multiple of what people notice, never exceeded; 1: not visible
  };
  Kind kind = Kind::Ratio;
  double value = 25;
};

/// Returns whether errors at single frames decide.
constexpr bool is_by_worst(const Target& target) {
  return target.kind == Target::Kind::MaxError || target.kind == Target::Kind::Visibility;
}

/// Returns whether the target is an error, so that the bytes are free.
constexpr bool is_error(const Target& target) {
  return target.kind == Target::Kind::Error || is_by_worst(target);
}

/// Returns whether `achieved`, in the target's quantity, meets the target. Allows for the rounding
/// of figures that were written as text and read again. A coefficient ratio is met by construction.
bool reached(const Target& target, double achieved);

/// The message for a target that nothing meets: what was asked, the nearest value that can be
/// reached, and for ratios whether that is a smaller or a larger file. Both values are in the
/// target's quantity.
std::string out_of_reach(const Target& target, double nearest);

/// "ratio", "coefficient-ratio", "size", "error", "max-error", "not-visible".
std::string_view name(Target::Kind kind);

inline bool operator==(const Target& a, const Target& b) {
  return a.kind == b.kind && a.value == b.value;
}

}  // namespace mocapress
