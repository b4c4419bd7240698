// SPDX-License-Identifier: MIT
// Measures the encoder on one core for a clip that is analysed already: a draft, as a slider asks
// for it, and a full encode. Forward kinematics of the same frames is measured for comparison.
// Items are frames.
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include "core/codec/encode/encoder.h"
#include "tests/bench/synthetic_motion.h"

namespace mocapress::test {
namespace {

Motion first_frames(int frames) {
  Motion motion = synthetic_motion();
  motion.clip.channels = motion.clip.channels.topRows(frames).eval();
  return motion;
}

void Encode(benchmark::State& state, Effort effort) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const Encoder encoder(first_frames(static_cast<int>(state.range(0))));
  const EncodeSettings options{.method = Method::ClosedLoop,
                               .weighting = Weighting::Surface,
                               .target = {Target::Kind::Error, 0.3},
                               .effort = effort};
  encoder.encode(options);
  for (auto _ : state) benchmark::DoNotOptimize(encoder.encode(options));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK_CAPTURE(Encode, draft, Effort::Draft)->Arg(500)->Arg(1000)->Arg(2000);
BENCHMARK_CAPTURE(Encode, default_effort, Effort::Default)->Arg(2000);

void EncodeReferenceTracks(benchmark::State& state) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const Motion motion = first_frames(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(landmark_tracks(motion.skeleton, motion.clip));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(EncodeReferenceTracks)->Arg(2000);

}  // namespace
}  // namespace mocapress::test
