// SPDX-License-Identifier: MIT
#include "core/codec/signal_decoder.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>

#include "core/base/own_memory.h"
#include "core/decoder/synthesis.h"

namespace mocapress {
namespace {

/// The resident form of some signals, in memory of its own.
class OwnResidentSignals {
 public:
  explicit OwnResidentSignals(const decoder::QuantisedSource& source)
      : bytes_(static_cast<std::size_t>(decoder::ResidentSignals::size(source))) {
    std::memset(bytes_.data(), 0, bytes_.size());
    signals_ = decoder::ResidentSignals::build(source, bytes_.data());
  }
  const decoder::ResidentSignals& operator*() const { return *signals_; }

 private:
  AlignedBytes bytes_;
  const decoder::ResidentSignals* signals_;
};

}  // namespace

Eigen::MatrixXd decode_signals(const Eigen::MatrixXi& values, const std::vector<float>& steps,
                               Basis basis) {
  const auto length = static_cast<int>(values.rows());
  const auto count = static_cast<int>(values.cols());
  std::vector<std::uint8_t> notes(steps.size());
  const OwnResidentSignals resident(
      decoder::QuantisedSource{.length = length,
                               .signals = count,
                               .wavelet = static_cast<decoder::Wavelet>(basis),
                               .steps = steps.data(),
                               .values = values.data(),
                               .notes = notes.data(),
                               .budget_bytes = std::numeric_limits<std::uint64_t>::max()});
  std::vector<std::int32_t> columns(steps.size());
  std::iota(columns.begin(), columns.end(), 0);
  OwnMemory<decoder::Synthesis> synthesis(
      *resident, decoder::SynthesisPlan{columns.data(), true, count, 0, &decoder::best_rows()});
  Eigen::MatrixXd samples(length, count);
  Eigen::MatrixXf window(count, decoder::Synthesis::kWindow);  // a column is a frame
  for (int first = 0; first < length; first += decoder::Synthesis::kWindow) {
    const int frames = std::min(decoder::Synthesis::kWindow, length - first);
    synthesis->make(first, frames, window.data(), count);
    samples.middleRows(first, frames) = window.leftCols(frames).transpose().cast<double>();
  }
  return samples;
}

}  // namespace mocapress
