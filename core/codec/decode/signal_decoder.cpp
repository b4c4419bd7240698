// SPDX-License-Identifier: MIT
#include "core/codec/decode/signal_decoder.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

#include "core/codec/format/own_memory.h"
#include "core/codec/format/rle16.h"
#include "core/runtime/signal_decoder.h"

namespace mocapress {
namespace {

constexpr float kUnknown = 8;  // a limit for radians, where it is not known what they move

/// The resident form of some signals, in memory of its own.
class OwnResidentSignals {
 public:
  explicit OwnResidentSignals(const runtime::QuantisedSource& source)
      : bytes_(static_cast<std::size_t>(runtime::ResidentSignals::size(source))) {
    std::memset(bytes_.data(), 0, bytes_.size());
    signals_ = runtime::ResidentSignals::build(source, bytes_.data());
  }
  const runtime::ResidentSignals& operator*() const { return *signals_; }

 private:
  AlignedBytes bytes_;
  const runtime::ResidentSignals* signals_;
};

}  // namespace

Eigen::MatrixXd decode_signals(const Eigen::MatrixXi& values, const std::vector<float>& steps,
                               Basis basis, const std::vector<float>& double_precision_limits) {
  const auto length = static_cast<int>(values.rows());
  const auto count = static_cast<int>(values.cols());
  std::vector<float> limits = double_precision_limits;
  limits.resize(steps.size(), kUnknown);
  std::vector<std::uint8_t> notes(steps.size());
  const OwnResidentSignals resident(
      runtime::QuantisedSource{.length = length,
                               .signal_count = count,
                               .wavelet = static_cast<runtime::Wavelet>(basis),
                               .steps = steps.data(),
                               .double_precision_limits = limits.data(),
                               .values = values.data(),
                               .notes = notes.data(),
                               .budget_bytes = std::numeric_limits<std::uint64_t>::max()});
  std::vector<std::int32_t> columns(steps.size());
  std::iota(columns.begin(), columns.end(), 0);
  OwnMemory<runtime::SignalDecoder> signal_decoder(
      *resident, runtime::SignalRequest{columns.data(), true, count, 0, &runtime::best_rows()});
  Eigen::MatrixXd samples(length, count);
  Eigen::MatrixXf window(count, runtime::kWindow);  // a column is a frame
  for (int first = 0; first < length; first += runtime::kWindow) {
    const int frames = std::min(runtime::kWindow, length - first);
    signal_decoder->decode_window(first, frames, window.data(), count);
    samples.middleRows(first, frames) = window.leftCols(frames).transpose().cast<double>();
  }
  return samples;
}

Eigen::MatrixXd read_signals(ByteReader& words, Basis basis, int samples, int count) {
  const Rle16Values read = rle16_read(words, samples, count);
  std::vector<float> steps;
  for (const int exponent : read.exponents) steps.push_back(std::ldexp(1.0F, exponent));
  return decode_signals(read.values, steps, basis);
}

}  // namespace mocapress
