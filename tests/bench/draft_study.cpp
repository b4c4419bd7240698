// SPDX-License-Identifier: MIT
// Measures the time of drafts and the accuracy of their estimated sizes, as Markdown tables; with
// `fit`, also fits the weights of the estimate. Times are wall-clock milliseconds, the least of
// five, for clips that are analysed already.
// Usage: mocapress-draft-study CORPUS/study [fit]
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/kept_memory.h"
#include "core/codec/encode/encoder.h"
#include "core/codec/encode/search/size_estimate.h"
#include "core/formats/motion_file.h"
#include "tests/bench/study_clips.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

constexpr std::array kErrors = {0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 1.0};  // cm, as `mocapress bench`
constexpr std::array kWeightings = {Weighting::BoneEnds, Weighting::Surface};
constexpr std::array kEvery = {1, 4};  // frames

EncodeSettings draft_at(double eps_cm, Weighting weighting, bool size_will_do) {
  return {.method = Method::ClosedLoop,
          .coding = Coding::Adaptive,
          .weighting = weighting,
          .target = {Target::Kind::Error, eps_cm},
          .effort = Effort::Draft,
          .size_will_do = size_will_do};
}

double least_ms(const Encoder& encoder, const EncodeSettings& options) {
  using Clock = std::chrono::steady_clock;
  double least = INFINITY;
  for (int i = 0; i < 5; ++i) {
    const auto start = Clock::now();
    encoder.encode(options);
    least =
        std::min(least, std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  }
  return least;
}

void print_times(const std::vector<fs::path>& clips) {
  std::printf("| clip | frames | ms at 0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 1 cm | with bytes |\n");
  std::printf("| --- | --- | --- | --- |\n");
  for (const fs::path& path : clips) {
    const Encoder encoder(read_motion(path).motion);
    encoder.encode(draft_at(kErrors[0], Weighting::BoneEnds, true));  // analyses it
    std::array<std::string, 2> texts;
    for (const bool size_will_do : {true, false})
      for (const double eps_cm : kErrors) {
        char text[32];
        std::string& all = texts[size_will_do ? 0 : 1];
        std::snprintf(text, sizeof text, "%s%.1f", all.empty() ? "" : ", ",
                      least_ms(encoder, draft_at(eps_cm, Weighting::BoneEnds, size_will_do)));
        all += text;
      }
    std::printf("| %s | %d | %s | %s |\n", path.stem().c_str(), encoder.motion().clip.frames(),
                texts[0].c_str(), texts[1].c_str());
    std::fflush(stdout);
  }
  std::printf("\n");
}

/// A draft's size, and the terms of its estimate.
struct Sample {
  double bytes;
  double estimate;
  SizeParts parts;
};

std::vector<Sample> samples_of(const std::vector<fs::path>& clips) {
  std::vector<Sample> samples;
  for (const fs::path& path : clips) {
    const Motion whole = read_motion(path).motion;
    for (const int every : kEvery) {
      const Encoder encoder(thinned(whole, every));
      for (const Weighting weighting : kWeightings)
        for (const double eps_cm : kErrors) {
          const Encoding draft = encoder.encode(draft_at(eps_cm, weighting, false));
          const QuantisedSignals coded = AdaptiveSegments(draft.compressed).next();
          const auto neighbours = signal_neighbours(draft.compressed);
          samples.push_back({static_cast<double>(draft.compressed.motion.size()),
                             static_cast<double>(estimated_bytes(coded, neighbours)),
                             size_parts(coded, neighbours)});
        }
    }
  }
  return samples;
}

void print_accuracy(const std::vector<Sample>& samples) {
  std::vector<double> off;
  double sum = 0;
  for (const Sample& sample : samples) {
    off.push_back(std::abs(sample.estimate / sample.bytes - 1));
    sum += sample.estimate / sample.bytes - 1;
  }
  std::sort(off.begin(), off.end());
  const auto share = [&](double of) {
    return 100 * off[static_cast<std::size_t>(of * static_cast<double>(off.size() - 1))];
  };
  std::printf(
      "%zu drafts: estimates off by %.1f %% (median), %.1f %% (95 of 100), %.1f %% (worst); "
      "%+.1f %% in the mean\n",
      off.size(), share(0.5), share(0.95), share(1), 100 * sum / static_cast<double>(off.size()));
}

/// Fits weights by least squares of relative errors.
void print_weights(const std::vector<Sample>& samples) {
  Eigen::MatrixXd parts(std::ssize(samples), 5);
  for (Eigen::Index i = 0; i < parts.rows(); ++i) {
    const auto& [bytes, estimate, of] = samples[static_cast<std::size_t>(i)];
    parts.row(i) << of.details, of.signs, of.coarse, of.bands, of.signals;
    parts.row(i) /= bytes;
  }
  const Eigen::VectorXd weights =
      parts.colPivHouseholderQr().solve(Eigen::VectorXd::Ones(parts.rows()));
  std::printf("details %.4f, signs %.4f, coarse %.4f, bands %.4f, signals %.4f\n", weights(0),
              weights(1), weights(2), weights(3), weights(4));
}

}  // namespace
}  // namespace mocapress

int main(int argc, char** argv) {
  mocapress::keep_freed_memory();  // as the programs do
  const bool fits = argc == 3 && std::string_view(argv[2]) == "fit";
  if (argc != 2 && !fits) {
    std::fprintf(stderr, "Usage: mocapress-draft-study CORPUS/study [fit]\n");
    return 2;
  }
  try {
    const auto clips = mocapress::clips_of(argv[1]);
    if (!fits) mocapress::print_times(clips);
    const auto samples = mocapress::samples_of(clips);
    mocapress::print_accuracy(samples);
    if (fits) mocapress::print_weights(samples);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mocapress-draft-study: %s\n", error.what());
    return 1;
  }
}
