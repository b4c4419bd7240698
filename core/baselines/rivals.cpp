// SPDX-License-Identifier: MIT
#include "core/baselines/rivals.h"

#include <array>

#include "core/baselines/quaternion.h"

namespace mocapress {

void add_rivals() {
  static const std::array kMethods{&pca_method(),        &subsample_method(),
                                   &quaternion_method(), &liu_mcmillan_method(),
                                   &arikan_method(),     &key_frame_method()};
  add_comparison_methods(kMethods);
}

}  // namespace mocapress
