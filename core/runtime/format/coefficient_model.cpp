// SPDX-License-Identifier: MIT
#include "core/runtime/format/coefficient_model.h"

#include "core/runtime/format/coefficient_priors.h"

namespace mocapress::runtime {

void CoefficientModel::begin_untaught() {
  constexpr AdaptiveBit kSeldom{6000, 1};
  std::fill_n(contexts, layout.end, AdaptiveBit());
  std::fill(contexts + layout.zero_own.first, contexts + layout.class_own.first, kSeldom);
  for (MixingWeights& set : weights) set.of.fill(65536 * 3 / 10);
}

void CoefficientModel::teach(std::string_view priors, std::string_view trust) {
  for (std::size_t c = 0; c < priors.size() && c < static_cast<std::size_t>(layout.shared); ++c)
    if (const auto log_odds = log_odds_of_prior(priors[c]))
      contexts[c] = {static_cast<std::uint16_t>(squash(*log_odds)), observations_of(trust[c])};
}

void CoefficientModel::begin() {
  begin_untaught();
  teach(context_priors(), context_trust());
  const std::span<const std::int16_t> shares = weight_priors();
  for (std::size_t i = 0; i < shares.size(); ++i)
    weights[i / MixingWeights::kMost].of[i % MixingWeights::kMost] = 64 * shares[i];
}

}  // namespace mocapress::runtime
