// SPDX-License-Identifier: MIT
// Curves of an FBX file: keys, the interpolation between them, and the values before and after.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/formats/fbx/fbx_records.h"

namespace mocapress {

/// FBX ticks in a second. A file may state another number (FbxScene::ticks_per_second()).
inline constexpr double kFbxTicks = 46186158000;

class FbxCurve {
 public:
  enum class Way : std::uint8_t { Constant, ConstantNext, Linear, Cubic };
  enum class Beyond : std::uint8_t { Constant, Repeat, RepeatFurther, Mirror, Slope };

  struct Key {
    std::int64_t ticks = 0;
    double value = 0;
  };

  /// Reads an AnimationCurve of version 7.
  FbxCurve(FbxRecords& records, const FbxRecord& curve, double ticks_per_second);
  /// Reads a Channel of a version 6 take.
  static FbxCurve of_channel(FbxRecords& records, const FbxRecord& channel,
                             double ticks_per_second);

  const std::vector<Key>& keys() const { return keys_; }
  bool moves() const;        // some key differs from the first
  bool steps() const;        // true if all interpolations are constant
  bool goes_beyond() const;  // true if it moves before its first or after its last key
  /// The value at a time; requires at least one key. A time within 1e-5 s of a key gives that key's
  /// value.
  double at(double ticks) const;
  int dropped() const { return dropped_; }  // number of keys whose time or value was no number

 private:
  struct Extrapolation {
    Beyond way = Beyond::Constant;
    std::int64_t repetitions = -1;  // below 0: endless
  };
  struct Tangents;  // tangents as the file states them
  /// The interpolation from a key to the next one.
  struct Span {
    Way way = Way::Linear;
    double slope_out = 0;         // per second
    double slope_in = 0;          // slope on arrival at the next key
    double weight_out = 1.0 / 3;  // share of the time between
    double weight_in = 1.0 / 3;
  };

  explicit FbxCurve(double ticks_per_second) : ticks_per_second_(ticks_per_second) {}
  static Extrapolation extrapolation(const FbxRecords& records, const FbxRecord& curve,
                                     const char* name);
  void sort(std::vector<Tangents>& tangents);
  void settle(std::vector<Tangents> tangents);
  const Span& span(std::size_t key) const { return spans_[spans_.size() == 1 ? 0 : key]; }
  double seconds(std::size_t from, std::size_t to) const;
  double slope(std::size_t from, std::size_t to) const;
  double auto_slope(std::size_t key, double bias, const Tangents& tangents, double weight_before,
                    double weight_after) const;
  std::size_t key_after(double ticks) const;
  double within(double ticks) const;
  double beyond(double ticks) const;

  double ticks_per_second_;
  std::vector<Key> keys_;
  std::vector<Span> spans_;             // one for each key, or one for all
  mutable std::size_t last_found_ = 0;  // key_after() searches from here, since times mostly ascend
  Extrapolation before_;
  Extrapolation after_;
  int dropped_ = 0;
};

}  // namespace mocapress
