// SPDX-License-Identifier: MIT
// Measures transform, coding, decoding and kinematics. Items are frames of 62 channels.
#include <benchmark/benchmark.h>

#include <cstring>

#include "core/codec/decode/decoder.h"
#include "core/codec/format/deflate.h"
#include "core/codec/format/rle16.h"
#include "core/motion/forward_kinematics.h"
#include "core/motion/landmarks.h"
#include "core/select/ranking.h"
#include "tests/bench/synthetic_motion.h"

namespace mocapress::test {
namespace {

constexpr int kCoefficientRatio = 20;

void count_frames(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * synthetic_motion().clip.frames());
}

std::span<double> column(Eigen::MatrixXd& matrix, Eigen::Index c) {
  return {matrix.col(c).data(), static_cast<std::size_t>(matrix.rows())};
}

/// The largest twentieth of each channel's coefficients, as the encoder hands them to the coding.
Eigen::MatrixXd kept_coefficients() {
  const RankedCoefficients ranked = rank_coefficients(synthetic_motion().clip, Basis::Cubic);
  const std::vector<double> gains = ranked.lifting.gains();
  const Eigen::Map<const Eigen::VectorXd> gain(gains.data(), ranked.per_channel());
  return gain.asDiagonal() *
         truncate(ranked, keep_per_channel(ranked, ranked.total() / kCoefficientRatio));
}

std::vector<std::byte> words(const Eigen::MatrixXd& coefficients) {
  return rle16_encode(coefficients, Eigen::VectorXd::Zero(coefficients.cols()));
}

CompressedClip compressed(Coding coding) {
  const Motion& motion = synthetic_motion();
  std::vector<std::byte> bytes = words(kept_coefficients());
  if (coding == Coding::Deflate) bytes = deflate_bytes(bytes);
  return {.skeleton = motion.skeleton,
          .sample_rate_hz = motion.clip.sample_rate_hz,
          .frames = motion.clip.frames(),
          .coding = coding,
          .motion = std::move(bytes)};
}

/// A lower bound for everything that touches each value once.
void Memcpy(benchmark::State& state) {
  const Eigen::MatrixXd& from = synthetic_motion().clip.channels;
  Eigen::MatrixXd to = from;
  for (auto _ : state) {
    std::memcpy(to.data(), from.data(), static_cast<std::size_t>(from.size()) * sizeof(double));
    benchmark::ClobberMemory();
  }
  count_frames(state);
}
BENCHMARK(Memcpy);

void LiftingForward(benchmark::State& state) {
  Eigen::MatrixXd samples = synthetic_motion().clip.channels;
  Eigen::MatrixXd coefficients = samples;
  const Lifting lifting(Basis::Cubic, static_cast<int>(samples.rows()));
  for (auto _ : state)
    for (Eigen::Index c = 0; c < samples.cols(); ++c)
      lifting.forward(column(samples, c), column(coefficients, c));
  count_frames(state);
}
BENCHMARK(LiftingForward);

void LiftingInverse(benchmark::State& state) {
  Eigen::MatrixXd coefficients = kept_coefficients();
  Eigen::MatrixXd samples = coefficients;
  const Lifting lifting(Basis::Cubic, static_cast<int>(samples.rows()));
  for (auto _ : state)
    for (Eigen::Index c = 0; c < samples.cols(); ++c)
      lifting.inverse(column(coefficients, c), column(samples, c));
  count_frames(state);
}
BENCHMARK(LiftingInverse);

void Rle16Encode(benchmark::State& state) {
  const Eigen::MatrixXd coefficients = kept_coefficients();
  for (auto _ : state) benchmark::DoNotOptimize(words(coefficients));
  count_frames(state);
}
BENCHMARK(Rle16Encode);

void Rle16Decode(benchmark::State& state) {
  const Eigen::MatrixXd coefficients = kept_coefficients();
  const auto bytes = words(coefficients);
  for (auto _ : state) {
    ByteReader reader(bytes);
    benchmark::DoNotOptimize(rle16_read(reader, static_cast<int>(coefficients.rows()),
                                        static_cast<int>(coefficients.cols())));
  }
  count_frames(state);
}
BENCHMARK(Rle16Decode);

void Deflate(benchmark::State& state) {
  const auto bytes = words(kept_coefficients());
  for (auto _ : state) benchmark::DoNotOptimize(deflate_bytes(bytes));
  count_frames(state);
}
BENCHMARK(Deflate);

void Inflate(benchmark::State& state) {
  const auto bytes = words(kept_coefficients());
  const auto packed = deflate_bytes(bytes);
  for (auto _ : state) benchmark::DoNotOptimize(inflate_bytes(packed, bytes.size()));
  count_frames(state);
}
BENCHMARK(Inflate);

void Decode(benchmark::State& state, Coding coding) {
  const CompressedClip clip = compressed(coding);
  for (auto _ : state) benchmark::DoNotOptimize(decode(clip));
  count_frames(state);
}
BENCHMARK_CAPTURE(Decode, rle16, Coding::Rle16);
BENCHMARK_CAPTURE(Decode, deflate, Coding::Deflate);

void ComputePose(benchmark::State& state) {
  const Motion& motion = synthetic_motion();
  Pose pose;
  for (auto _ : state)
    for (int t = 0; t < motion.clip.frames(); ++t) {
      compute_pose(motion.skeleton, motion.clip.channels.row(t), pose);
      benchmark::DoNotOptimize(pose.origin.data());
    }
  count_frames(state);
}
BENCHMARK(ComputePose);

void LandmarkTracks(benchmark::State& state) {
  const Motion& motion = synthetic_motion();
  for (auto _ : state) benchmark::DoNotOptimize(landmark_tracks(motion.skeleton, motion.clip));
  count_frames(state);
}
BENCHMARK(LandmarkTracks)->UseRealTime();

}  // namespace
}  // namespace mocapress::test
