// SPDX-License-Identifier: MIT
#include "core/formats/key_times.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/formats/node_motion.h"

namespace mocapress {
namespace {

constexpr double kUnstatedRate = 30;     // Hz
constexpr double kSlowestRate = 10;      // Hz; keys further apart were set by hand
constexpr double kSameInstant = 1e-5;    // s
constexpr double kOnFrame = 0.01;        // in frames: less is rounding of keys, which are floats
constexpr double kNearFrame = 0.15;      // in frames: half a millisecond at up to 300 Hz
constexpr double kSameRate = 0.005;      // share of the rate
constexpr double kDensestUnasked = 120;  // Hz; a higher rate needs keys that are as dense
constexpr double kMostFramesPerKey = 4;

// Round rates come first, since a short clip may fit several.
constexpr double kUsualRates[] = {24,
                                  25,
                                  30,
                                  48,
                                  50,
                                  60,
                                  72,
                                  75,
                                  90,
                                  96,
                                  100,
                                  120,
                                  144,
                                  150,
                                  180,
                                  200,
                                  240,
                                  250,
                                  300,
                                  480,
                                  500,
                                  960,
                                  1000,
                                  24000.0 / 1001,
                                  30000.0 / 1001,
                                  60000.0 / 1001,
                                  120000.0 / 1001};

/// The largest distance of a key from its frame, in frames.
double farthest_key(double rate_hz, const std::vector<double>& keys_s) {
  double farthest = 0;
  for (const double key : keys_s) {
    const double frame = (key - keys_s.front()) * rate_hz;
    farthest = std::max(farthest, std::abs(frame - std::round(frame)));
  }
  return farthest;
}

/// The mean rate of the keys.
double mean_rate(const std::vector<double>& keys_s) {
  return static_cast<double>(keys_s.size() - 1) / (keys_s.back() - keys_s.front());
}

/// The rate of keys that are one frame apart; unset if they are not. The keys may fit several
/// rates, which are tried in order: the file's, the usual ones, the mean.
std::optional<double> rate_without_gaps(const std::vector<double>& keys_s, double stated_hz) {
  const double mean = mean_rate(keys_s);
  std::vector<double> rates = {stated_hz};
  rates.insert(rates.end(), std::begin(kUsualRates), std::end(kUsualRates));
  if (mean >= kSlowestRate) rates.push_back(mean);
  std::optional<double> best;
  double farthest_of_best = kNearFrame;
  for (const double rate : rates) {
    if (std::abs(rate - mean) > kSameRate * mean) continue;
    const double farthest = std::max(farthest_key(rate, keys_s), kOnFrame);
    if (farthest > kNearFrame || (best && farthest >= farthest_of_best)) continue;
    best = rate;
    farthest_of_best = farthest;
  }
  return best;
}

/// The rate with a frame at every key, although some frames have no key; unset if there is none.
std::optional<double> rate_with_gaps(const std::vector<double>& keys_s,
                                     std::optional<double> stated_hz) {
  if (stated_hz && farthest_key(*stated_hz, keys_s) <= kNearFrame) return stated_hz;
  std::vector<double> rates = {kUnstatedRate};
  rates.insert(rates.end(), std::begin(kUsualRates), std::end(kUsualRates));
  const auto first_below = [&](double most_hz, double near) -> std::optional<double> {
    for (const double rate : rates)
      if (rate <= most_hz && farthest_key(rate, keys_s) <= near) return rate;
    return std::nullopt;
  };
  if (const auto rate = first_below(kDensestUnasked, kOnFrame)) return rate;
  if (const auto rate = first_below(kDensestUnasked, kNearFrame)) return rate;
  return first_below(kMostFramesPerKey * mean_rate(keys_s), kOnFrame);
}

/// The guessed rate; unset if no rate has a frame at every key.
std::optional<double> guess_rate(const std::vector<double>& keys_s,
                                 std::optional<double> stated_hz) {
  if (keys_s.size() < 2) return std::nullopt;
  const auto whole = rate_without_gaps(keys_s, stated_hz.value_or(kUnstatedRate));
  return whole ? whole : rate_with_gaps(keys_s, stated_hz);
}

/// A warning for keys that are not on frames, or frames without keys.
std::string unevenness(const SampleTimes& times, const std::vector<double>& keys_s) {
  std::vector<bool> is_key(times.frames, false);
  for (const double key : keys_s) {
    const double frame = (key - times.first_s) * times.rate_hz;
    if (std::abs(frame - std::round(frame)) <= times.near_s * times.rate_hz)
      is_key[std::min(static_cast<std::size_t>(std::round(frame)), is_key.size() - 1)] = true;
  }
  const auto keyed = std::ranges::count(is_key, true);
  if (keyed == times.frames) return {};
  return "keys lie unevenly: " + std::to_string(keyed) + " of " + std::to_string(times.frames) +
         " frames carry keys; frames between are interpolated";
}

}  // namespace

std::vector<double> merged_times(const std::vector<double>& times, std::vector<double> more) {
  if (!std::ranges::is_sorted(more)) std::ranges::sort(more);
  std::vector<double> all;
  all.reserve(std::max(times.size(), more.size()));
  std::merge(times.begin(), times.end(), more.begin(), more.end(), std::back_inserter(all));
  const auto same = [](double a, double b) { return b - a < kSameInstant; };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return all;
}

SampleTimes sample_times(const std::string& file, const std::vector<double>& keys_s,
                         std::optional<double> stated_hz, std::optional<double> wanted_hz,
                         std::size_t moving_nodes) {
  SampleTimes times;
  times.first_s = keys_s.front();
  const std::optional<double> guessed = wanted_hz ? std::nullopt : guess_rate(keys_s, stated_hz);
  times.rate_hz = wanted_hz ? *wanted_hz : guessed.value_or(stated_hz.value_or(kUnstatedRate));
  // The largest distance of a key from its frame, plus rounding.
  const double near =
      guessed ? std::max(1.01 * farthest_key(times.rate_hz, keys_s), kOnFrame) : kOnFrame;
  times.near_s = near / times.rate_hz;
  const double frames = std::ceil((keys_s.back() - keys_s.front()) * times.rate_hz - near) + 1;
  check_take_size(file, moving_nodes, frames);
  times.frames = static_cast<int>(frames);
  if (!wanted_hz) times.warning = unevenness(times, keys_s);
  return times;
}

}  // namespace mocapress
