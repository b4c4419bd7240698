// SPDX-License-Identifier: MIT
// Curves of an FBX file: keys, how to go from one to the next, and what is before and after them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/formats/fbx/fbx_records.h"

namespace mocapress {

/// A second of FBX. Files that say so have another (FbxScene::ticks_per_second()).
inline constexpr double kFbxTicks = 46186158000;

class FbxCurve {
 public:
  enum class Way : std::uint8_t { Constant, ConstantNext, Linear, Cubic };
  enum class Beyond : std::uint8_t { Constant, Repeat, RepeatFurther, Mirror, Slope };

  struct Key {
    std::int64_t ticks = 0;
    double value = 0;
    // To the next key. Slopes are per second; weights are shares of the time between.
    Way way = Way::Linear;
    double slope_out = 0;
    double slope_in = 0;  // arriving at the next key
    double weight_out = 1.0 / 3;
    double weight_in = 1.0 / 3;
  };

  /// An AnimationCurve of version 7.
  FbxCurve(FbxRecords& records, const FbxRecord& curve, double ticks_per_second);
  /// A Channel of a take of version 6.
  static FbxCurve of_channel(FbxRecords& records, const FbxRecord& channel,
                             double ticks_per_second);

  const std::vector<Key>& keys() const { return keys_; }
  bool moves() const;        // some key differs from the first
  bool steps() const;        // all ways are constant
  bool goes_beyond() const;  // it moves before its first or after its last key
  /// The curve has at least one key. A time within a hundred-thousandth of a second of a key is
  /// that key's.
  double at(double ticks) const;
  int dropped() const { return dropped_; }  // keys whose time or value was no number

 private:
  struct Extrapolation {
    Beyond way = Beyond::Constant;
    std::int64_t repetitions = -1;  // below 0: without end
  };
  struct Tangents;  // what the file says of a key

  explicit FbxCurve(double ticks_per_second) : ticks_per_second_(ticks_per_second) {}
  static Extrapolation extrapolation(const FbxRecords& records, const FbxRecord& curve,
                                     const char* name);
  void settle(const std::vector<Tangents>& tangents);
  double seconds(std::size_t from, std::size_t to) const;
  double slope(std::size_t from, std::size_t to) const;
  double auto_slope(std::size_t key, double bias, const Tangents& tangents, double weight_before,
                    double weight_after) const;
  double within(double ticks) const;
  double beyond(double ticks) const;

  double ticks_per_second_;
  std::vector<Key> keys_;
  Extrapolation before_;
  Extrapolation after_;
  int dropped_ = 0;
};

}  // namespace mocapress
