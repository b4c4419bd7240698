// SPDX-License-Identifier: MIT
// Bounds beside the target, on the joints that eyes and engines look at most.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/metrics/distortion.h"
#include "core/motion/clip.h"

namespace mocapress {

struct Importance;

/// The turns are root-mean-squares over a clip, of the worst joint of each part. Bounds of the root
/// hold at every frame, for roots that move on the floor: engines take a character's motion from
/// those. Unset: nothing is promised. An encode raises the weights of joints that miss a promise
/// until all are kept.
struct Promises {
  std::optional<double> head_degrees;
  std::optional<double> hand_degrees;  // each hand by itself
  std::optional<double> finger_degrees;
  std::optional<double> root_cm;
  std::optional<double> root_degrees;

  bool any() const {
    return head_degrees || hand_degrees || finger_degrees || root_cm || root_degrees;
  }
  bool operator==(const Promises&) const = default;
};

/// The names that promises have in JSON.
struct PromiseKey {
  const char* key;
  std::optional<double> Promises::*bound;
};
inline constexpr std::array kPromiseKeys = {PromiseKey{"head_degrees", &Promises::head_degrees},
                                            PromiseKey{"hand_degrees", &Promises::hand_degrees},
                                            PromiseKey{"finger_degrees", &Promises::finger_degrees},
                                            PromiseKey{"root_cm", &Promises::root_cm},
                                            PromiseKey{"root_degrees", &Promises::root_degrees}};

/// A joint that is further off than was promised.
struct BrokenPromise {
  std::string text;   // "hand lhand is turned by 4.8 degrees, not 4"
  int joint = 0;      // 0 for the root
  double times = 1;   // as far off as promised, above 1
  bool root = false;  // a promise about the root
};

/// The distortion is that of a decoded motion from this one.
std::vector<BrokenPromise> broken_promises(const Promises& promises, const Motion& original,
                                           const Distortion& distortion);

/// Raises the importance of the joints named, by the square of what they are off.
void raise_importance(const std::vector<BrokenPromise>& broken, const Skeleton& skeleton,
                      Importance& importance);

}  // namespace mocapress
