// SPDX-License-Identifier: MIT
#include "core/codec/encode/coefficient_model.h"

namespace mocapress {

CoefficientModel::CoefficientModel(int signal_count, Untaught)
    : contexts_(static_cast<std::size_t>(runtime::ContextLayout(signal_count).end)),
      model_(signal_count, contexts_.data()) {
  model_.begin_untaught();
}

CoefficientModel CoefficientModel::untaught(int signal_count) {
  return {signal_count, Untaught()};
}

CoefficientModel::CoefficientModel(int signal_count) : CoefficientModel(signal_count, Untaught()) {
  model_.begin();
}

}  // namespace mocapress
