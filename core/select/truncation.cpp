// SPDX-License-Identifier: MIT
#include "core/select/truncation.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace mocapress {

Kept keep_per_channel(const RankedCoefficients& ranked, int count) {
  assert(count >= 0 && count <= ranked.total());
  const int channels = ranked.channels();
  Kept kept(static_cast<std::size_t>(channels));
  for (int c = 0; c < channels; ++c)
    kept[static_cast<std::size_t>(c)] = count / channels + (c < count % channels ? 1 : 0);
  return kept;
}

std::vector<double> channel_scales(const Skeleton& skeleton) {
  const std::vector<double> lengths = skeleton.driven_lengths();
  const double longest = lengths.empty() ? 1 : *std::max_element(lengths.begin(), lengths.end());
  std::vector<double> scales;
  for (int c = 0; c < skeleton.channel_count(); ++c) {
    const double length = lengths[static_cast<std::size_t>(skeleton.channel_joint(c))];
    const bool rotates = is_rotation(skeleton.channel_kind(c));
    scales.push_back(!rotates ? 1 : length > 0 ? length : std::max(longest, 1.0));
  }
  return scales;
}

StandardOrder::StandardOrder(const RankedCoefficients& ranked, const Skeleton& skeleton)
    : StandardOrder(ranked, channel_scales(skeleton)) {}

StandardOrder::StandardOrder(const RankedCoefficients& ranked, const std::vector<double>& scales)
    : channels_(ranked.channels()) {
  std::vector<std::pair<double, int>> all;  // scaled importance, channel
  all.reserve(static_cast<std::size_t>(ranked.total()));
  for (int c = 0; c < channels_; ++c)
    for (int i = 0; i < ranked.per_channel(); ++i)
      all.emplace_back(ranked.importance(i, c) * scales[static_cast<std::size_t>(c)], c);
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second < b.second;
  });
  for (const auto& [importance, channel] : all) channel_by_importance_.push_back(channel);
}

Kept StandardOrder::keep(int count) const {
  assert(count >= 0 && count <= static_cast<int>(channel_by_importance_.size()));
  Kept kept(static_cast<std::size_t>(channels_), 0);
  for (int i = 0; i < count; ++i)
    ++kept[static_cast<std::size_t>(channel_by_importance_[static_cast<std::size_t>(i)])];
  return kept;
}

}  // namespace mocapress
