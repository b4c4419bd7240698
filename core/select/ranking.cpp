// SPDX-License-Identifier: MIT
#include "core/select/ranking.h"

#include <algorithm>
#include <numeric>
#include <span>

#include "core/base/parallel.h"

namespace mocapress {
namespace {

std::span<double> span_of(Eigen::Ref<Eigen::VectorXd> column) {
  return {column.data(), static_cast<std::size_t>(column.size())};
}

}  // namespace

Coefficients transform(const Clip& clip, Basis basis) {
  Coefficients coefficients{Lifting(basis, clip.frames()), clip.channels};
  parallel_for(0, coefficients.channels(), [&](int c) {
    const auto column = span_of(coefficients.values.col(c));
    coefficients.lifting.forward(column, column);
  });
  return coefficients;
}

RankedCoefficients rank_coefficients(const Clip& clip, Basis basis) {
  RankedCoefficients ranked{transform(clip, basis), {}, {}};
  const std::vector<double> norms = ranked.lifting.norms();
  const Eigen::Map<const Eigen::VectorXd> norm(norms.data(), clip.frames());
  ranked.importance.resizeLike(ranked.values);
  ranked.by_importance.resize(static_cast<std::size_t>(ranked.channels()));
  parallel_for(0, ranked.channels(), [&](int c) {
    ranked.importance.col(c) = ranked.values.col(c).cwiseAbs().cwiseProduct(norm);
    auto& order = ranked.by_importance[static_cast<std::size_t>(c)];
    order.resize(static_cast<std::size_t>(ranked.per_channel()));
    std::iota(order.begin(), order.end(), 0);
    // Ties go to the coarser coefficient, so that the order is the same everywhere.
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
      return ranked.importance(a, c) > ranked.importance(b, c);
    });
  });
  return ranked;
}

Eigen::MatrixXd truncate(const RankedCoefficients& ranked, const Kept& kept) {
  Eigen::MatrixXd truncated = Eigen::MatrixXd::Zero(ranked.per_channel(), ranked.channels());
  for (int c = 0; c < ranked.channels(); ++c) {
    const auto& order = ranked.by_importance[static_cast<std::size_t>(c)];
    for (int i = 0; i < kept[static_cast<std::size_t>(c)]; ++i) {
      const int coefficient = order[static_cast<std::size_t>(i)];
      truncated(coefficient, c) = ranked.values(coefficient, c);
    }
  }
  return truncated;
}

Eigen::VectorXd synthesise(const RankedCoefficients& ranked, int channel, int first, int last) {
  Eigen::VectorXd signal = Eigen::VectorXd::Zero(ranked.per_channel());
  const auto& order = ranked.by_importance[static_cast<std::size_t>(channel)];
  for (int i = first; i < last; ++i) {
    const int coefficient = order[static_cast<std::size_t>(i)];
    signal(coefficient) = ranked.values(coefficient, channel);
  }
  ranked.lifting.inverse(span_of(signal), span_of(signal));
  return signal;
}

}  // namespace mocapress
