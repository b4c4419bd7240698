// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/error_profile.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace mocapress {

ErrorProfile errorProfile(const Eigen::MatrixXf& distances) {
  if (distances.size() == 0) return {};
  return {distances.rowwise().maxCoeff(), distances.rowwise().mean()};
}

RangeErrors rangeErrors(const Eigen::MatrixXf& distances, int first, int last) {
  const auto rows = distances.middleRows(first, last - first + 1);
  if (rows.size() == 0) return {};
  std::vector<float> all(static_cast<std::size_t>(rows.size()));
  Eigen::Map<Eigen::MatrixXf>(all.data(), rows.rows(), rows.cols()) = rows;
  const auto share = static_cast<std::ptrdiff_t>(std::ceil(0.95 * double(all.size()))) - 1;
  std::nth_element(all.begin(), all.begin() + share, all.end());
  Eigen::Index frame = 0;
  Eigen::Index landmark = 0;
  const double max = double(rows.maxCoeff(&frame, &landmark));
  return {std::sqrt(rows.cast<double>().array().square().mean()), double(all[std::size_t(share)]),
          max, first + static_cast<int>(frame), static_cast<int>(landmark)};
}

std::vector<int> worstFrames(const Eigen::VectorXf& max, int apart, int most) {
  std::vector<int> order(static_cast<std::size_t>(max.size()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return max[a] > max[b]; });
  std::vector<int> worst;
  for (const int frame : order) {
    if (static_cast<int>(worst.size()) == most) break;
    const bool alone = std::all_of(worst.begin(), worst.end(),
                                   [&](int worse) { return std::abs(worse - frame) >= apart; });
    if (alone) worst.push_back(frame);
  }
  return worst;
}

int nextWorst(const std::vector<int>& worst, int frame, int step) {
  const auto found = std::find(worst.begin(), worst.end(), frame);
  if (worst.empty()) return frame;
  if (found == worst.end()) return worst.front();
  const auto count = static_cast<int>(worst.size());
  const auto place = static_cast<int>(found - worst.begin());
  return worst[static_cast<std::size_t>((place + step + count) % count)];
}

}  // namespace mocapress
