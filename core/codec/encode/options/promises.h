// SPDX-License-Identifier: MIT
// Bounds that are kept in addition to the target, on the joints that people notice and engines use
// most.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/metrics/distortion.h"
#include "core/motion/clip.h"

namespace mocapress {

struct Importance;

/// Bounds on errors that an encode keeps in addition to its target. The angles are
/// root-mean-squares over a clip, for the worst joint of each part. Bounds on the root hold at
/// every frame, for roots that move on the floor, from which engines take a character's motion.
/// Unset fields promise nothing. An encode raises the weights of joints that miss a promise until
/// all are kept.
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

/// The JSON name of a promise.
struct PromiseKey {
  const char* key;
  std::optional<double> Promises::*bound;
};
inline constexpr std::array kPromiseKeys = {PromiseKey{"head_degrees", &Promises::head_degrees},
                                            PromiseKey{"hand_degrees", &Promises::hand_degrees},
                                            PromiseKey{"finger_degrees", &Promises::finger_degrees},
                                            PromiseKey{"root_cm", &Promises::root_cm},
                                            PromiseKey{"root_degrees", &Promises::root_degrees}};

/// A joint whose error exceeds a promise.
struct BrokenPromise {
  std::string text;   // "lhand is turned (degrees, RMS) by 4.8, not 4"
  int joint = 0;      // 0 for the root
  double times = 1;   // error / promised bound, above 1
  bool root = false;  // a promise about the root
};

/// The promises that a decoded motion breaks. `distortion` compares that motion with the original.
std::vector<BrokenPromise> broken_promises(const Promises& promises, const Motion& original,
                                           const Distortion& distortion);

/// Raises the importance of joints that break a promise: by the square of error / bound, or for the
/// root by error / bound.
void raise_importance(const std::vector<BrokenPromise>& broken, const Skeleton& skeleton,
                      Importance& importance);

}  // namespace mocapress
