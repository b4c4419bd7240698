// SPDX-License-Identifier: MIT
#include "core/codec/encode/search/split_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mocapress {
namespace {

constexpr double kShareLeft = 0.1;
constexpr double kUnseen = 0.1;  // cm of slide; a correction may add this much itself
constexpr double kNone = std::numeric_limits<double>::infinity();

}  // namespace

SplitSearch::SplitSearch(double slide_without_cm, int finer_steps)
    : enough_cm_(kShareLeft * slide_without_cm),
      finer_steps_(finer_steps),
      best_{kFirst, kNone, kNone, kNone} {}

std::optional<double> SplitSearch::next() const {
  if (tried_.empty()) return kFirst;
  const bool held =
      std::ranges::any_of(tried_, [this](const Split& split) { return holds(split); });
  // If a correction holds the feet, try a coarser one; if the finest tried is the best, a finer one
  // may be better.
  if (held && holds(tried_.back()) && tried_.back().ratio < kMost) return 2 * tried_.back().ratio;
  // The coarsest ratio is by far the cheapest, and may by chance hold feet that hardly slide.
  if (!held && tried_.size() == 1) return kMost;
  const double finest = tried_.front().ratio;
  const bool gets_cheaper = tried_.size() < 2 || tried_[0].price <= tried_[1].price;
  if ((!held || (best_.ratio == finest && gets_cheaper)) && finest > kLeast) return finest / 2;
  if (!held) return {};
  const auto above = std::ranges::find_if(
      tried_, [this](const Split& split) { return split.ratio > best_.ratio; });
  const auto finer = std::ranges::count_if(tried_, [](const Split& split) {
    return std::exp2(std::round(std::log2(split.ratio))) != split.ratio;
  });
  if (finer >= finer_steps_ || above == tried_.end()) return {};
  return std::sqrt(best_.ratio * above->ratio);
}

bool SplitSearch::tried(const Split& split) {
  const auto place =
      std::ranges::find_if(tried_, [&](const Split& other) { return other.ratio > split.ratio; });
  const bool better = tried_.empty() || is_better(split);
  tried_.insert(place, split);
  if (better) best_ = split;
  return better;
}

bool SplitSearch::holds(const Split& split) const {
  return split.price < kNone && (split.slide_cm <= enough_cm_ || split.worst_cm <= kUnseen);
}

bool SplitSearch::is_better(const Split& split) const {
  if (holds(split) != holds(best_)) return holds(split);
  if (holds(split)) return split.price < best_.price;
  if ((split.price < kNone) != (best_.price < kNone)) return split.price < kNone;
  return split.slide_cm < best_.slide_cm;
}

}  // namespace mocapress
