// SPDX-License-Identifier: MIT
#include "core/formats/key_times.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/formats/node_motion.h"

namespace mocapress {
namespace {

constexpr double kUnstatedRate = 30;   // Hz
constexpr double kSlowestRate = 10;    // Hz; keys farther apart were set by hand
constexpr double kSameInstant = 1e-5;  // s
constexpr double kOnFrame = 0.01;      // frames

// Round ones first: in a short clip both fit.
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

/// Whether every key lies on a frame.
bool fits(double rate_hz, const std::vector<double>& keys_s) {
  return std::all_of(keys_s.begin(), keys_s.end(), [&](double key) {
    const double frame = (key - keys_s.front()) * rate_hz;
    return std::abs(frame - std::round(frame)) <= kOnFrame;
  });
}

double smallest_spacing(const std::vector<double>& keys_s) {
  double smallest = keys_s.back() - keys_s.front();
  for (std::size_t i = 1; i < keys_s.size(); ++i)
    smallest = std::min(smallest, keys_s[i] - keys_s[i - 1]);
  return smallest;
}

double guess_rate(const std::vector<double>& keys_s, std::optional<double> stated_hz) {
  const double fallback = stated_hz.value_or(kUnstatedRate);
  if (keys_s.size() < 2) return fallback;
  const double densest = 1 / smallest_spacing(keys_s);
  const auto is_densest = [&](double rate) { return std::abs(rate - densest) < 0.005 * densest; };
  if (is_densest(fallback) && fits(fallback, keys_s)) return fallback;
  for (const double rate : kUsualRates)
    if (is_densest(rate) && fits(rate, keys_s)) return rate;
  const double mean = static_cast<double>(keys_s.size() - 1) / (keys_s.back() - keys_s.front());
  if (mean >= kSlowestRate && is_densest(mean) && fits(mean, keys_s)) return mean;
  if (fits(fallback, keys_s)) return fallback;
  for (const double rate : kUsualRates)
    if (fits(rate, keys_s)) return rate;
  return fallback;
}

/// What there is to say where keys are not frames and frames no keys.
std::string unevenness(const SampleTimes& times, const std::vector<double>& keys_s) {
  std::vector<bool> is_key(static_cast<std::size_t>(times.frames), false);
  for (const double key : keys_s) {
    const double frame = (key - times.first_s) * times.rate_hz;
    if (std::abs(frame - std::round(frame)) <= kOnFrame)
      is_key[std::min(static_cast<std::size_t>(std::round(frame)), is_key.size() - 1)] = true;
  }
  const auto keyed = std::count(is_key.begin(), is_key.end(), true);
  if (keyed == times.frames) return {};
  return "keys lie unevenly: " + std::to_string(keyed) + " of " + std::to_string(times.frames) +
         " frames carry keys; frames between are interpolated";
}

}  // namespace

std::vector<double> merged_times(const std::vector<double>& times, std::vector<double> more) {
  if (!std::is_sorted(more.begin(), more.end())) std::sort(more.begin(), more.end());
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
  times.rate_hz = wanted_hz ? *wanted_hz : guess_rate(keys_s, stated_hz);
  const double frames = std::ceil((keys_s.back() - keys_s.front()) * times.rate_hz - kOnFrame) + 1;
  check_take_size(file, moving_nodes, frames);
  times.frames = static_cast<int>(frames);
  if (!wanted_hz) times.warning = unevenness(times, keys_s);
  return times;
}

}  // namespace mocapress
