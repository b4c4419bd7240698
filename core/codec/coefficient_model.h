// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/decoder/coefficient_model.h"

namespace mocapress {

using decoder::kLevels;
using decoder::kSizes;
using decoder::size_of;

/// The decoder's model with memory of its own.
class CoefficientModel {
 public:
  /// As it is before the first bit.
  explicit CoefficientModel(int signal_count);

  /// Without what other clips taught: for fitting that.
  static CoefficientModel untaught(int signal_count);

  CoefficientModel(CoefficientModel&&) = default;
  CoefficientModel& operator=(CoefficientModel&&) = default;

  decoder::CoefficientModel& operator*() { return model_; }
  decoder::CoefficientModel* operator->() { return &model_; }

 private:
  struct Untaught {};
  CoefficientModel(int signal_count, Untaught);

  std::vector<decoder::AdaptiveBit> contexts_;  // moved along, never copied: model_ points into it
  decoder::CoefficientModel model_;
};

}  // namespace mocapress
