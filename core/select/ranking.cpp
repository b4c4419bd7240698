// SPDX-License-Identifier: MIT
#include "core/select/ranking.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <span>

#include "core/base/parallel.h"

namespace mocapress {

namespace {

std::span<double> span_of(Eigen::Ref<Eigen::VectorXd> column) {
  return {column.data(), static_cast<std::size_t>(column.size())};
}

/// The coefficients of a signal that stands still, without the rounding of a transform.
void set_constant(double value, const Lifting& lifting, Eigen::Ref<Eigen::VectorXd> coefficients) {
  coefficients.setZero();
  coefficients.head(lifting.bands().front().size).setConstant(value);
}

}  // namespace

Coefficients transform(const Clip& clip, Basis basis) {
  Coefficients coefficients{Lifting(basis, clip.frames()), clip.channels};
  const std::vector<bool> still = still_channels(clip);
  parallel_for(0, coefficients.channels(), [&](int c) {
    auto column = coefficients.values.col(c);
    if (column.size() > 0 && still[c])
      set_constant(clip.channels(0, c), coefficients.lifting, column);
    else
      coefficients.lifting.forward(span_of(column), span_of(column));
  });
  return coefficients;
}

RankedCoefficients rank_coefficients(const Clip& clip, Basis basis) {
  RankedCoefficients ranked{transform(clip, basis), {}, {}};
  const std::vector<double> norms = ranked.lifting.norms();
  const Eigen::Map<const Eigen::VectorXd> norm(norms.data(), clip.frames());
  ranked.importance.resizeLike(ranked.values);
  ranked.by_importance.resize(ranked.channels());
  parallel_for(0, ranked.channels(), [&](int c) {
    ranked.importance.col(c) = ranked.values.col(c).cwiseAbs().cwiseProduct(norm);
    auto& order = ranked.by_importance[c];
    order.resize(ranked.per_channel());
    std::iota(order.begin(), order.end(), 0);
    // Ties go to the coarser coefficient, so that every machine gets the same order.
    std::ranges::stable_sort(
        order, [&](int a, int b) { return ranked.importance(a, c) > ranked.importance(b, c); });
  });
  return ranked;
}

Eigen::MatrixXd truncate(const RankedCoefficients& ranked, const Kept& kept) {
  Eigen::MatrixXd truncated = Eigen::MatrixXd::Zero(ranked.per_channel(), ranked.channels());
  for (int c = 0; c < ranked.channels(); ++c) {
    const auto& order = ranked.by_importance[c];
    for (int i = 0; i < kept[c]; ++i) {
      const int coefficient = order[i];
      truncated(coefficient, c) = ranked.values(coefficient, c);
    }
  }
  return truncated;
}

Eigen::VectorXd synthesise(const RankedCoefficients& ranked, int channel, int first, int last) {
  Eigen::VectorXd signal = Eigen::VectorXd::Zero(ranked.per_channel());
  const auto& order = ranked.by_importance[channel];
  for (int i = first; i < last; ++i) {
    const int coefficient = order[i];
    signal(coefficient) = ranked.values(coefficient, channel);
  }
  ranked.lifting.inverse(span_of(signal), span_of(signal));
  return signal;
}

Kept keep_per_channel(const RankedCoefficients& ranked, int count) {
  assert(count >= 0 && count <= ranked.total());
  const int channels = ranked.channels();
  Kept kept(static_cast<std::size_t>(channels));
  for (int c = 0; c < channels; ++c) kept[c] = count / channels + (c < count % channels ? 1 : 0);
  return kept;
}

std::vector<double> channel_scales(const Skeleton& skeleton) {
  const std::vector<double> lengths = skeleton.driven_lengths();
  const double longest = lengths.empty() ? 1 : *std::ranges::max_element(lengths);
  std::vector<double> scales;
  for (int c = 0; c < skeleton.channel_count(); ++c) {
    const double length = lengths[skeleton.channel_joint(c)];
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
  all.reserve(ranked.total());
  for (int c = 0; c < channels_; ++c)
    for (int i = 0; i < ranked.per_channel(); ++i)
      all.emplace_back(ranked.importance(i, c) * scales[c], c);
  std::ranges::sort(all, [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second < b.second;
  });
  for (const auto& [importance, channel] : all) channel_by_importance_.push_back(channel);
}

Kept StandardOrder::keep(int count) const {
  assert(count >= 0 && count <= static_cast<int>(channel_by_importance_.size()));
  Kept kept(static_cast<std::size_t>(channels_), 0);
  for (int i = 0; i < count; ++i) ++kept[channel_by_importance_[i]];
  return kept;
}

}  // namespace mocapress
