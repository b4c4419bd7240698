// SPDX-License-Identifier: MIT
#include "core/baselines/rivals.h"

#include <array>

namespace mocapress {

void add_rivals() {
  static const std::array kMethods{&kPca,         &kSubsample, &kQuaternion,
                                   &kLiuMcMillan, &kArikan,    &kKeyFrames};
  add_comparison_methods(kMethods);
}

}  // namespace mocapress
