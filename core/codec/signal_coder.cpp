// SPDX-License-Identifier: MIT
#include "core/codec/signal_coder.h"

#include <tbb/parallel_for.h>

#include "core/codec/deflate.h"
#include "core/codec/rle16.h"

namespace mocapress {
namespace {

Eigen::VectorXd gains_of(const Lifting& lifting) {
  const std::vector<double> gains = lifting.gains();
  return Eigen::Map<const Eigen::VectorXd>(gains.data(), lifting.length());
}

/// The largest coefficient each signal drops, in the units it is coded in.
Eigen::VectorXd largest_dropped(const RankedCoefficients& ranked, const Kept& kept,
                                const Eigen::VectorXd& gains) {
  Eigen::VectorXd dropped = Eigen::VectorXd::Zero(ranked.channels());
  for (int c = 0; c < ranked.channels(); ++c) {
    const auto rank = static_cast<std::size_t>(kept[static_cast<std::size_t>(c)]);
    const auto& order = ranked.by_importance[static_cast<std::size_t>(c)];
    if (rank < order.size())
      dropped(c) = std::abs(ranked.values(order[rank], c)) * gains(order[rank]);
  }
  return dropped;
}

}  // namespace

std::string_view name(Coding coding) {
  return coding == Coding::Rle16 ? "rle16" : "deflate";
}

std::vector<std::byte> code_signals(const RankedCoefficients& ranked, const Kept& kept,
                                    Coding coding) {
  const Eigen::VectorXd gains = gains_of(ranked.lifting);
  const auto words = rle16_encode(gains.asDiagonal() * truncate(ranked, kept),
                                  largest_dropped(ranked, kept, gains));
  return coding == Coding::Rle16 ? words : deflate_bytes(words);
}

Eigen::MatrixXd decode_signals(std::span<const std::byte> bytes, Basis basis, Coding coding,
                               int samples, int count) {
  Eigen::MatrixXd values =
      coding == Coding::Rle16
          ? rle16_decode(bytes, samples, count)
          : rle16_decode(inflate_bytes(bytes, rle16_bound(samples, count)), samples, count);
  const Lifting lifting(basis, samples);
  const Eigen::VectorXd gains = gains_of(lifting);
  tbb::parallel_for(Eigen::Index{0}, values.cols(), [&](Eigen::Index s) {
    values.col(s).array() /= gains.array();
    const std::span<double> signal(values.col(s).data(), static_cast<std::size_t>(samples));
    lifting.inverse(signal, signal);
  });
  return values;
}

}  // namespace mocapress
