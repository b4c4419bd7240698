// SPDX-License-Identifier: MIT
#include "core/codec/encode/paper_encode.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/codec/encode/search/count_search.h"

namespace mocapress {

Trial PaperEncode::run(Method method) {
  constexpr int kCheapTrials = 24;
  constexpr int kAnnealings = 10;
  const int guess = count_for(coder_.goal().likely_coefficient_ratio());
  if (coder_.settings().target.kind == Target::Kind::CoefficientRatio)
    return attempt(method, guess);
  if (method != Method::Annealed) return search(method, guess, kCheapTrials);
  // Standard selection gives the first guess: it is almost free and needs about as many
  // coefficients as annealing.
  return search(Method::Annealed, search(Method::Standard, guess, kCheapTrials).count, kAnnealings);
}

int PaperEncode::count_for(double coefficient_ratio) const {
  const double total = coder_.coefficients().total();
  return static_cast<int>(std::lround(std::clamp(total / coefficient_ratio, 0.0, total)));
}

Trial PaperEncode::search(Method method, int first_guess, int most_trials) {
  std::optional<Trial> best;
  CountSearch search(coder_.coefficients().total(), first_guess, coder_.goal().window(),
                     most_trials);
  while (!search.done() && (!best || best->complete)) {
    Trial trial = attempt(method, search.count());
    search.tried(trial.excess);
    const bool complete = trial.complete;
    if (!best || !coder_.goal().better(best->excess, trial.excess)) best = std::move(trial);
    best->complete = complete;  // false if the search was stopped, whichever trial was the best
  }
  return std::move(*best);
}

Trial PaperEncode::attempt(Method method, int count) {
  Trial chosen{.compressed = {}, .count = count};
  const Kept kept = choose(method, chosen);
  Trial trial = coder_.code(kept);
  trial.count = count;
  trial.iterations = chosen.iterations;
  trial.complete = chosen.complete;
  coder_.measure(trial);
  return trial;
}

Kept PaperEncode::choose(Method method, Trial& trial) {
  if (method == Method::PerChannel) return keep_per_channel(basis().ranked, trial.count);
  Kept standard = basis().standard.keep(trial.count);
  if (method == Method::Standard) return standard;
  const auto known = annealed_.find(trial.count);
  const AnnealingReport report =
      known != annealed_.end() ? known->second : best_annealing(standard);
  annealed_[trial.count] = report;
  trial.iterations = report.iterations;
  trial.complete = report.complete;
  return report.kept;
}

/// Results of annealing differ by chance by some 10 %. Short clips, whose annealings take next to
/// no time, get several; the best is returned.
AnnealingReport PaperEncode::best_annealing(const Kept& standard) {
  constexpr int kMost = 8;
  constexpr int kSamples = 80'000;  // over all annealings together
  const int annealings =
      std::clamp(kSamples / std::max(coder_.coefficients().total(), 1), 1, kMost);
  AnnealingReport best;
  for (int i = 0; i < annealings && best.complete; ++i) {
    const auto observe = [&, pass = passes_.begin()](const AnnealingProgress& p) {
      return should_continue(passes_.observer(),
                             EncodeProgress{pass, p.iteration, p.step, p.first_step, p.eps_cm});
    };
    AnnealingReport report =
        anneal(basis().ranked, coder_.model(), standard,
               coder_.settings().seed + static_cast<std::uint64_t>(i), observe);
    if (i > 0 && report.eps_cm >= best.eps_cm)
      best.complete = report.complete;
    else
      best = std::move(report);
  }
  return best;
}

}  // namespace mocapress
