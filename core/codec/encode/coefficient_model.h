// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/codec/format/coefficient_model.h"

namespace mocapress {

using runtime::kLevels;
using runtime::kSizes;
using runtime::size_of;

/// The decoder's model with memory of its own.
class CoefficientModel {
 public:
  /// As it is before the first bit.
  explicit CoefficientModel(int signal_count);

  /// Without what other clips taught: for fitting that.
  static CoefficientModel untaught(int signal_count);

  CoefficientModel(CoefficientModel&&) = default;
  CoefficientModel& operator=(CoefficientModel&&) = default;

  runtime::CoefficientModel& operator*() { return model_; }
  runtime::CoefficientModel* operator->() { return &model_; }

 private:
  struct Untaught {};
  CoefficientModel(int signal_count, Untaught);

  std::vector<runtime::AdaptiveBit> contexts_;  // moved along, never copied: model_ points into it
  runtime::CoefficientModel model_;
};

}  // namespace mocapress
