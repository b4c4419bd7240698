// SPDX-License-Identifier: MIT
#include "core/codec/coefficient_model.h"

#include "core/codec/coefficient_priors.h"

namespace mocapress {

CoefficientModel::CoefficientModel(int signal_count, Untaught)
    : layout(signal_count), contexts(static_cast<std::size_t>(layout.end)) {
  constexpr AdaptiveBit kSeldom{6000, 1};
  for (int c = layout.zero_own.first; c < layout.class_own.first; ++c)
    contexts[static_cast<std::size_t>(c)] = kSeldom;
  for (MixingWeights& set : weights) set.of.fill(65536 * 3 / 10);
}

CoefficientModel CoefficientModel::untaught(int signal_count) {
  return {signal_count, Untaught()};
}

void CoefficientModel::teach(std::string_view priors) {
  constexpr std::uint16_t kTrust = 40;  // observations that a prior is worth
  for (std::size_t c = 0; c < priors.size() && c < static_cast<std::size_t>(layout.shared); ++c)
    if (const auto log_odds = log_odds_of_prior(priors[c]))
      contexts[c] = {probability_of_log_odds(*log_odds), kTrust};
}

CoefficientModel::CoefficientModel(int signal_count) : CoefficientModel(signal_count, Untaught()) {
  teach(context_priors());
  const std::span<const std::int16_t> shares = weight_priors();
  for (std::size_t i = 0; i < shares.size(); ++i)
    weights[i / MixingWeights::kMost].of[i % MixingWeights::kMost] = 64 * shares[i];
}

}  // namespace mocapress
