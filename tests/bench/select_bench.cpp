// SPDX-License-Identifier: MIT
// Measures ranking and the error model, the parts of annealing.
#include <benchmark/benchmark.h>

#include "core/select/error_model.h"
#include "core/select/ranking.h"
#include "tests/bench/synthetic_motion.h"

namespace mocapress::test {
namespace {

const ErrorModel& model() {
  static const ErrorModel kModel(synthetic_motion().skeleton, synthetic_motion().clip,
                                 Weighting::BoneEnds);
  return kModel;
}

/// A small error of one channel, with a value for each frame.
Eigen::VectorXd delta() {
  return 0.01 * synthetic_motion().clip.channels.rightCols<1>();
}

void RankCoefficients(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(rank_coefficients(synthetic_motion().clip, Basis::Cubic));
}
BENCHMARK(RankCoefficients)->UseRealTime();

void ErrorModelConstruction(benchmark::State& state) {
  const Motion& motion = synthetic_motion();
  for (auto _ : state)
    benchmark::DoNotOptimize(ErrorModel(motion.skeleton, motion.clip, Weighting::BoneEnds));
}
BENCHMARK(ErrorModelConstruction)->UseRealTime();

/// Measures one candidate.
void ErrorStateChange(benchmark::State& state) {
  const ErrorState error(model());
  const Eigen::VectorXd d = delta();
  for (auto _ : state) benchmark::DoNotOptimize(error.change(model().channels() - 1, d));
}
BENCHMARK(ErrorStateChange);

/// Measures one accepted change of a channel at the root, which affects every other, or at a hand.
void ErrorStateAdd(benchmark::State& state, bool at_root) {
  ErrorState error(model());
  const Eigen::VectorXd d = delta();
  const int channel = at_root ? 3 : model().channels() - 1;
  for (auto _ : state) {
    error.add(channel, d);
    benchmark::ClobberMemory();
  }
}
BENCHMARK_CAPTURE(ErrorStateAdd, root, true)->UseRealTime();
BENCHMARK_CAPTURE(ErrorStateAdd, hand, false)->UseRealTime();

}  // namespace
}  // namespace mocapress::test
