// SPDX-License-Identifier: MIT
#include "core/runtime/format/learned_priors.h"

#include "core/runtime/format/cursor.h"

namespace mocapress::runtime {

namespace {

/// Parses learned priors. Calls weight(index, step) for every mixing weight, then context(number,
/// code, layout) for each context; `layout` is that of the clips that the priors were learned from.
template <typename Weight, typename Context>
mcpr_result visit(const Bytes& learned, const Weight& weight, const Context& context) {
  Cursor cursor = learned.cursor();
  const ContextLayout taught(cursor.read<std::uint16_t>());
  for (std::size_t i = 0; i < MixingSets::kCount * MixingWeights::kMost; ++i)
    weight(i, cursor.read<std::int8_t>());
  std::uint64_t number = 0;
  while (!cursor.failed() && !cursor.at_end()) {
    number += cursor.read_varint();
    const auto code = cursor.read<std::uint8_t>();
    if (number >= static_cast<std::uint64_t>(taught.end)) cursor.fail();
    if (!cursor.failed()) context(static_cast<std::size_t>(number), code, taught);
    ++number;
  }
  return cursor.failed()
             ? failure(MCPR_INVALID, learned.offset, "what the bank's clips taught makes no sense")
             : kOk;
}

}  // namespace

mcpr_result check_learned(const Bytes& learned) {
  return visit(
      learned, [](std::size_t, std::int8_t) {},
      [](std::size_t, std::uint8_t, const ContextLayout&) {});
}

mcpr_result learn(const Bytes& learned, CoefficientModel& model) {
  if (learned.size == 0) return kOk;
  const ContextLayout& own = model.layout;
  return visit(
      learned,
      [&](std::size_t i, std::int8_t steps) {
        model.weights[i / MixingWeights::kMost].of[i % MixingWeights::kMost] +=
            kLearnedWeightStep * steps;
      },
      [&](std::size_t context, std::uint8_t code, const ContextLayout& taught) {
        if (static_cast<int>(context) >= taught.shared && taught.end != own.end) return;
        model.contexts[context] = {static_cast<std::uint16_t>(squash(learned_log_odds(code))),
                                   learned_trust(code)};
      });
}

}  // namespace mocapress::runtime
